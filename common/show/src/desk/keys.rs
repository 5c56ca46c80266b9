//! The keys: what each does, in every shell.

use super::Act;
use super::Desk;
use super::Reading;
use crate::translated;

/// A key that a shell knows.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Key {
    /// The arrow.
    Up,
    /// The arrow.
    Down,
    /// The arrow.
    Left,
    /// The arrow.
    Right,
    /// To the start.
    Home,
    /// Takes one thing back.
    Backspace,
    /// The same as [`Backspace`](Self::Backspace).
    Delete,
    /// The space bar.
    Space,
    /// The large key.
    Enter,
    /// Leaves.
    Escape,
    /// The one beside Q.
    Tab,
    /// To the stop before.
    PageUp,
    /// To the next stop.
    PageDown,
    /// F1 and so on.
    F(u8),
    /// What the key writes, as a capital letter: `P`, `3`, `+`.
    Char(char),
}

/// What a key does.
#[derive(Clone, Debug, PartialEq)]
pub enum Does {
    /// Something that is done in the class.
    Act(Act),
    /// Something as long as the key is down, and something when it is let go.
    While(Act, Act),
    /// Something with what the shell shows beside the picture, or with where its pointer is.
    Shell(Hand),
}

/// What only a shell can do, as it knows what is where on its screen.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Hand {
    /// Selects the control or heading before.
    Before,
    /// Selects the one after.
    After,
    /// Makes the selected control less, or folds the heading.
    Less,
    /// Makes it more, or unfolds it.
    More,
    /// Resets the selected control.
    Reset,
    /// Pins the pixel under the pointer.
    Pin,
    /// Larger text.
    Larger,
    /// Smaller text.
    Smaller,
}

/// How far a page goes in the list of stops.
const PAGE: isize = 10;

/// A row of the table of keys.
pub struct Row {
    /// The keys, as they are listed.
    pub keys: &'static str,
    /// What they do, as it is listed.
    pub effect: &'static str,
    /// Whether it takes several steps.
    pub lecture: bool,
    /// Each key with what it does; none of what a mouse does.
    pub does: Vec<(Key, Does)>,
}

impl Row {
    /// The keys and what they do, in the language that is spoken.
    pub fn listed(&self) -> (&'static str, &'static str) {
        (translated(self.keys), translated(self.effect))
    }
}

/// All that keys and mouse do. It makes the dispatch, the help and the lists of keys.
pub fn table() -> Vec<Row> {
    let row = |keys, effect, does| Row { keys, effect, lecture: false, does };
    let lecture = |keys, effect, does| Row { keys, effect, lecture: true, does };
    let act = |keys: &[Key], act: Act| -> Vec<(Key, Does)> {
        keys.iter().map(|key| (*key, Does::Act(act.clone()))).collect()
    };
    let hand = |hands: &[(Key, Hand)]| -> Vec<(Key, Does)> {
        hands.iter().map(|(key, hand)| (*key, Does::Shell(*hand))).collect()
    };
    let letter = Key::Char;
    let hold = || Does::While(Act::Hold(true), Act::Hold(false));
    let steps =
        ('1'..='9').zip(1..).map(|(digit, step)| (letter(digit), Does::Act(Act::Step(step))));
    vec![
        row(
            "click, Enter, P",
            "pin the pixel there: how it comes by its colour",
            hand(&[(Key::Enter, Hand::Pin), (letter('P'), Hand::Pin)]),
        ),
        row("drag", "orbit; on a slider, change its control", Vec::new()),
        row("wheel", "nearer or further; beside the picture, scroll", Vec::new()),
        row(
            "Up, Down",
            "select a control or a heading",
            hand(&[(Key::Up, Hand::Before), (Key::Down, Hand::After)]),
        ),
        row(
            "Left, Right",
            "change it, with Shift in fine steps; fold a heading or unfold it",
            hand(&[(Key::Left, Hand::Less), (Key::Right, Hand::More)]),
        ),
        row(
            "Backspace",
            "reset the selected control",
            hand(&[(Key::Backspace, Hand::Reset), (Key::Delete, Hand::Reset)]),
        ),
        row(
            "Home",
            "back to the stop as it is written, or reset all controls",
            act(&[Key::Home], Act::ResetAll),
        ),
        row("Space", "the picture alone, or with all beside it", act(&[Key::Space], Act::Alone)),
        row(
            "+, −",
            "larger or smaller text",
            hand(&[(letter('+'), Hand::Larger), (letter('-'), Hand::Smaller)]),
        ),
        row("V", "show or hide the rays and vectors", act(&[letter('V')], Act::Vectors)),
        row("H", "show or hide what can be dragged", act(&[letter('H')], Act::Handles)),
        row("O", "look from outside the camera, or through it", act(&[letter('O')], Act::Outside)),
        row("C", "the command that gives exactly this picture", act(&[letter('C')], Act::Command)),
        row("G", "all this in the next language", act(&[letter('G')], Act::NextLanguage)),
        row(
            "J, K",
            "choose a line of the pinned pixel: the next, the one before",
            vec![(letter('J'), Does::Act(Act::Walk(1))), (letter('K'), Does::Act(Act::Walk(-1)))],
        ),
        row(
            "Q, or a click on a line",
            "the chosen line as a picture, or the light again",
            act(&[letter('Q')], Act::ShowLine),
        ),
        row(
            "W",
            "what if the chosen line had another value: a slider",
            act(&[letter('W')], Act::WhatIfLine),
        ),
        row(
            "U",
            "the shown line along the pinned pixel's row, as a curve",
            act(&[letter('U')], Act::Curve),
        ),
        row(
            "F1, M",
            "show or hide these keys",
            act(&[Key::F(1), letter('M')], Act::Read(Reading::Keys)),
        ),
        row(
            "F3, L",
            "the code that runs for the pinned pixel, with its numbers",
            act(&[Key::F(3), letter('L')], Act::Read(Reading::Code)),
        ),
        row("E", "that code to the letter, as an editor shows it", act(&[letter('E')], Act::Whole)),
        row("N", "that code for the next light or object", act(&[letter('N')], Act::Look)),
        row("F2, S", "save the picture as a new PNG", act(&[Key::F(2), letter('S')], Act::Save)),
        row("Esc", "back: a text, a quantity, the pin", act(&[Key::Escape], Act::Leave)),
        row(
            "B, .",
            "a black screen, until the next key",
            act(&[letter('B'), letter('.')], Act::Blank),
        ),
        row("Ctrl+Q", "quit", Vec::new()),
        row(
            "Page Down, Up",
            "the next stop of the class, or the one before",
            vec![(Key::PageDown, Does::Act(Act::Next)), (Key::PageUp, Does::Act(Act::Previous))],
        ),
        lecture("F5", "the first stop", act(&[Key::F(5)], Act::Stop(1))),
        lecture(
            "T",
            "all stops and figures: arrows and Enter, or a click, go there",
            act(&[letter('T')], Act::Read(Reading::Stops)),
        ),
        lecture("R", "the stop's question, then its answer", act(&[letter('R')], Act::Ask)),
        lecture("1, 2, 3 …", "that step", steps.collect()),
        lecture(
            "Tab, A",
            "as long as it is held, the step before",
            vec![(Key::Tab, hold()), (letter('A'), hold())],
        ),
        lecture(
            "D",
            "the step before left of a line that can be dragged",
            act(&[letter('D')], Act::Divide),
        ),
        lecture(
            "X",
            "where there is more light than in the step before, and less",
            act(&[letter('X')], Act::Difference),
        ),
        lecture(
            "F4, I",
            "the idea in short",
            act(&[Key::F(4), letter('I')], Act::Read(Reading::Idea)),
        ),
    ]
}

impl Desk {
    /// What `key` does now; nothing where it has no meaning. In the list of stops keys go through that, and
    /// from a black screen each leads back.
    pub fn does(&self, key: Key) -> Option<Does> {
        let act = match key {
            _ if self.is_blank() => match does(key) {
                Some(Does::Shell(_)) | None => Act::Blank,
                does => return does,
            },
            _ if self.reading() != Reading::Stops => return does(key),
            Key::Up => Act::Pick(-1),
            Key::Down => Act::Pick(1),
            Key::PageUp => Act::Pick(-PAGE),
            Key::PageDown => Act::Pick(PAGE),
            Key::Enter => Act::Listed(self.picked()),
            _ => return does(key),
        };
        Some(Does::Act(act))
    }
}

/// What `key` does; nothing where it has no meaning.
pub fn does(key: Key) -> Option<Does> {
    let rows = table();
    let mut keys = rows.into_iter().flat_map(|row| row.does);
    keys.find(|(other, _)| *other == key).map(|(_, does)| does)
}
