//! A shell of its own over the desk: a terminal, where a key is a letter and a pixel is one too.

use tests::prelude::*;

/// From dark to bright.
const LETTERS: [char; 6] = [' ', '.', ':', 'o', '#', '@'];

struct Terminal {
    desk: Desk,
    /// What was said and printed since the last screen.
    said: String,
}

impl Terminal {
    /// Does a line: a key's letter, a setting `NAME=VALUE`, or the pixel `COL,ROW`; whether it goes on.
    fn type_line(&mut self, line: &str) -> bool {
        let pixel = line.split_once(',').map(|(col, row)| (col.parse(), row.parse()));
        let acts = match (line.split_once('='), pixel, line.chars().next()) {
            (Some((name, value)), ..) => vec![set(name, value)],
            (_, Some((Ok(col), Ok(row))), _) => vec![Act::PinPixel(col, row)],
            (.., Some(letter)) => match does(Key::Char(letter.to_ascii_uppercase())) {
                Some(Does::Act(act)) => vec![act],
                // A terminal does not hear a key that is let go: the next line does that.
                Some(Does::While(act, _)) => vec![act],
                Some(Does::Shell(Hand::Pin)) => vec![Act::Pin((0.5, 0.5))],
                _ => Vec::new(),
            },
            _ => return false,
        };
        for act in [vec![Act::Hold(false)], acts].concat() {
            match self.desk.act(act) {
                Ok(effects) => effects.into_iter().for_each(|effect| match effect {
                    Effect::Say(words) | Effect::Print(words) => self.said += &(words + "\n"),
                    _ => {}
                }),
                Err(refusal) => self.said += &format!("{refusal}\n"),
            }
        }
        true
    }

    /// What is seen, and below it what was said, and the settings that are not as at first.
    fn screen(&mut self, size: Size) -> String {
        let picture = compared(&self.desk, pictures_of(&self.desk, size));
        let letter = |pixel: &Rgb<u8>| {
            let light: usize = pixel.0.iter().map(|code| usize::from(*code)).sum();
            LETTERS[light * LETTERS.len() / (3 * 255 + 1)]
        };
        let rows = picture.rows().map(|row| row.map(letter).chain(['\n']).collect::<String>());
        let settings = self.desk.setup().settings().join(" ");
        rows.collect::<String>() + &std::mem::take(&mut self.said) + &settings
    }
}

#[test]
fn a_terminal_shows_what_all_other_shells_do() {
    let desk = desk(6, Size::DEFAULT);
    let mut terminal = Terminal { desk, said: String::new() };
    let mut shown = |line: &str| {
        assert!(terminal.type_line(line));
        (terminal.screen(size(48, 13)), address(&terminal.desk))
    };
    let (plain, _) = shown("red.radius=0.4");
    assert!(plain.lines().count() == 14 && plain.ends_with("\nred.radius=0.4"), "{plain}");
    assert!(LETTERS.iter().filter(|letter| plain.contains(**letter)).count() > 3, "{plain}");
    let (held, _) = shown("a");
    let (outside, address) = shown("o");
    assert!(plain != held && held != outside && address.contains("&outside=on"), "{address}");
    shown("o");
    let (pinned, _) = shown("480,300");
    assert!(pinned.contains("illumination") && pinned.contains("V  "), "{pinned}");
    assert!(shown("red.radius=x").0.contains("'radius' cannot be 'x'"));
    assert!(shown("c").0.contains("--pixel 480,300"));
    assert!(!terminal.type_line(""), "an empty line ends it");
}
