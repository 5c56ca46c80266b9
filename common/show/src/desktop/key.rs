//! The names of minifb's keys, and what is typed with them.

use std::collections::VecDeque;

use crate::Key;

/// What minifb tells of the keyboard.
pub(super) enum Told {
    /// A key by its place, or what it would be on a US keyboard, is pressed or released.
    Key(minifb::Key, bool),
    /// The character that was typed, which it tells right after the key's press, if it knows that key.
    Char(char),
}

/// A key that is pressed or released, and the character that it types here, if that is another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Typed {
    pub(super) key: minifb::Key,
    pub(super) character: Option<char>,
    pub(super) down: bool,
}

impl Typed {
    /// The session's name for it.
    pub(super) fn session_key(self) -> Option<Key> {
        self.character.map(Key::Char).or_else(|| session_key(self.key))
    }
}

/// Which characters the keys here type: what a key is called is what stands on it, in any country.
#[derive(Default)]
pub(super) struct Keyboard {
    /// The last key that was pressed, until something else is told.
    last: Option<minifb::Key>,
    /// Characters that are not those of a US keyboard.
    characters: Vec<(minifb::Key, char)>,
}

impl Keyboard {
    /// Adds to `typed` what is told.
    pub(super) fn hear(&mut self, told: Told, typed: &mut VecDeque<Typed>) {
        let last = self.last.take();
        match told {
            Told::Key(key, down) => {
                self.last = down.then_some(key);
                let known = self.characters.iter().find(|known| known.0 == key);
                typed.push_back(Typed { key, character: known.map(|known| known.1), down });
            }
            Told::Char(character) => {
                let Some(character) = meant(character) else { return };
                let of = last.and_then(session_key);
                match (last, of, typed.back_mut()) {
                    (_, Some(Key::Char(as_told)), _) if as_told == character => {}
                    (Some(key), Some(Key::Char(_)), Some(press)) if press.key == key => {
                        self.characters.retain(|known| known.0 != key);
                        self.characters.push((key, character));
                        press.character = Some(character);
                    }
                    // It is dealt with already.
                    (_, Some(Key::Char(_)), _) => {}
                    // A key that minifb has no name for.
                    _ => typed.extend([true, false].map(|down| Typed {
                        key: minifb::Key::Unknown,
                        character: Some(character),
                        down,
                    })),
                }
            }
        }
    }
}

/// The character that keys are called by, if it is one of these.
fn meant(character: char) -> Option<char> {
    match character.to_ascii_uppercase() {
        '−' => Some('-'),
        known @ ('A'..='Z' | '0'..='9' | '+' | '-') => Some(known),
        _ => None,
    }
}

/// The session's name for a key.
fn session_key(key: minifb::Key) -> Option<Key> {
    use minifb::Key as K;

    const LETTERS: [(K, char); 39] = [
        (K::A, 'A'),
        (K::B, 'B'),
        (K::C, 'C'),
        (K::D, 'D'),
        (K::E, 'E'),
        (K::F, 'F'),
        (K::G, 'G'),
        (K::H, 'H'),
        (K::I, 'I'),
        (K::J, 'J'),
        (K::K, 'K'),
        (K::L, 'L'),
        (K::M, 'M'),
        (K::N, 'N'),
        (K::O, 'O'),
        (K::P, 'P'),
        (K::Q, 'Q'),
        (K::R, 'R'),
        (K::S, 'S'),
        (K::T, 'T'),
        (K::U, 'U'),
        (K::V, 'V'),
        (K::W, 'W'),
        (K::X, 'X'),
        (K::Y, 'Y'),
        (K::Z, 'Z'),
        (K::Key0, '0'),
        (K::Key1, '1'),
        (K::Key2, '2'),
        (K::Key3, '3'),
        (K::Key4, '4'),
        (K::Key5, '5'),
        (K::Key6, '6'),
        (K::Key7, '7'),
        (K::Key8, '8'),
        (K::Key9, '9'),
        (K::Minus, '-'),
        (K::Period, '.'),
        (K::Equal, '+'),
    ];
    Some(match key {
        K::Up => Key::Up,
        K::Down => Key::Down,
        K::Left => Key::Left,
        K::Right => Key::Right,
        K::Home => Key::Home,
        K::Backspace => Key::Backspace,
        K::Delete => Key::Delete,
        K::Space => Key::Space,
        K::Enter | K::NumPadEnter => Key::Enter,
        K::Escape => Key::Escape,
        K::Tab => Key::Tab,
        K::PageUp => Key::PageUp,
        K::PageDown => Key::PageDown,
        K::F1 => Key::F(1),
        K::F2 => Key::F(2),
        K::F3 => Key::F(3),
        K::F4 => Key::F(4),
        K::F5 => Key::F(5),
        K::F11 => Key::F(11),
        K::NumPadPlus => Key::Char('+'),
        K::NumPadMinus => Key::Char('-'),
        _ => Key::Char(LETTERS.iter().find(|(letter, _)| *letter == key)?.1),
    })
}
