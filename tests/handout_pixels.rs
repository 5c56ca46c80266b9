//! What handouts say of pixels is so: what is to be seen there, and what `--pixel` tells of them.

use std::cmp::Ordering;

use tests::prelude::*;

use crate::readme::Part;
use crate::readme::comments;
use crate::readme::languages;
use crate::readme::originals;

/// How the English handout says what is seen under «Try this», in a comment, which no reader sees: with
/// some settings pixels of 960 × 540 are brighter, darker or the same.
const SEEN: &str = "<!-- --set NAME=VALUE: COL,ROW brighter, COL,ROW darker, COL,ROW same -->, \
    or with other settings than the start's before a ';'";

/// How it says what a pixel tells, in the words that are printed.
const TELLS: &str = "<!-- --set NAME=VALUE --pixel X,Y tells LINE; LINE -->";

/// What a step says of a pixel with these arguments.
fn explanation(index: usize, arguments: &str) -> Explanation {
    let desk = after(Desk::new(programs(), index), &acts_of(arguments));
    desk.explanation().expect("a pixel")
}

/// The lines of what [`explanation`] gives, in the language that is spoken, their words one space apart.
fn told(index: usize, arguments: &str) -> Vec<String> {
    written(&explanation(index, arguments)).lines().map(spaced).collect()
}

fn spaced(text: &str) -> String {
    words(text).join(" ")
}

/// What is wrong with a comment that says what is [`SEEN`] in a step; none when it is no such comment.
fn wrong_in(index: usize, comment: &str) -> Option<Vec<String>> {
    let (settings, seen) = comment.split_once(": ")?;
    let (before, after) = settings.split_once("; ").unwrap_or(("", settings));
    let mut flags = [before, after].into_iter().flat_map(|all| all.split_whitespace().step_by(2));
    let is_known = !after.is_empty() && flags.all(|flag| ["--set", "--camera"].contains(&flag));
    let mut wrong = Vec::new();
    for pixel in seen.split(", ") {
        let (place, found) = pixel.split_once(' ').filter(|_| is_known)?;
        let expected = match found {
            "brighter" => Ordering::Greater,
            "darker" => Ordering::Less,
            "same" => Ordering::Equal,
            _ => return None,
        };
        let [old, new] = [before, after].map(|settings| {
            encode(explanation(index, &format!("{settings} --pixel {place}")).color)
        });
        let light = |pixel: [u8; 3]| pixel.iter().map(|code| u32::from(*code)).sum::<u32>();
        let found = light(new).cmp(&light(old));
        if found != expected || (found == Ordering::Equal && old != new) {
            wrong.push(format!("{after}: {place} went from {old:?} to {new:?}"));
        }
    }
    Some(wrong)
}

#[test]
fn what_is_to_be_seen_is_seen_and_what_a_pixel_tells_is_told() {
    let mut wrong = Vec::new();
    for readme in originals() {
        let Some(index) = readme.step() else { continue };
        let mut fail = |what: String| wrong.push(format!("{}: {what}", readme.name()));
        for item in readme.section("Try this").split(|part| *part == Part::ListItem) {
            let said: Vec<&str> = comments(item).filter(|it| !it.contains(" tells ")).collect();
            for comment in &said {
                let malformed = || vec![format!("malformed: {comment}; it has to be {SEEN}")];
                wrong_in(index, comment).unwrap_or_else(malformed).into_iter().for_each(&mut fail);
            }
            let is_set = |code: &&str| code.starts_with("--set") || code.starts_with("--camera");
            let codes = item.iter().filter(|part| matches!(part, Part::Code(_)));
            let codes = codes.filter_map(Part::text).filter(is_set);
            for code in codes.filter(|code| !code.contains("--pixel")) {
                let (alone, later) = (format!("{code}: "), format!("; {code}: "));
                if !said.iter().any(|it| it.starts_with(&alone) || it.contains(&later)) {
                    fail(format!("its item has no comment on what is seen with {code}: {SEEN}"));
                }
            }
        }
        let tells = comments(&readme.parts).filter_map(|comment| comment.split_once(" tells "));
        let tells: Vec<(&str, &str)> = tells.collect();
        for (arguments, lines) in &tells {
            let told = told(index, arguments);
            for line in lines.split("; ").filter(|line| !told.iter().any(|told| told == line)) {
                fail(format!("{arguments} does not tell {line}"));
            }
        }
        let is_pixel = |code: &&str| code.starts_with('-') && code.contains("--pixel ");
        for code in readme.codes().filter(is_pixel) {
            if !tells.iter().any(|(arguments, _)| *arguments == code) {
                fail(format!("what does {code} tell? {TELLS}"));
            }
        }
    }
    none(wrong);
}

/// What the handouts say in words that a pixel's explanation says: of a step, with `--pixel` and
/// whatever else is set, in each language a line of it, spaces apart, and how the handout puts it.
type Quoted = (usize, &'static str, [(&'static str, &'static str); 2]);

#[rustfmt::skip]
const QUOTED: &[Quoted] = &[
    (3, "--pixel 100,270", [("outside α, β or γ < 0", "outside, α, β or γ < 0"), ("fora α, β ou γ < 0", "fora, α, β ou γ < 0")]),
    (6, "--pixel 240,420", [("blocked by green sphere", "blocked by the green sphere"), ("bloqueada por esfera verde", "bloqueada pela esfera verde")]),
    (6, "--pixel 240,420", [("key light", "the key light has V = 1"), ("luz principal", "a luz principal (key) tem V = 1")]),
    (6, "--pixel 240,420", [("fill light", "the fill light V = 0"), ("luz de preenchimento", "a de preenchimento (fill) tem V = 0")]),
    (6, "--set epsilon=0 --pixel 480,270", [("blocked by red sphere", "the red sphere is blocked by the red sphere"), ("bloqueada por esfera vermelha", "a esfera vermelha é bloqueada pela esfera vermelha")]),
];

#[test]
fn what_is_quoted_of_a_pixel_is_told_in_each_language() {
    let mut wrong = Vec::new();
    for (number, arguments, quoted) in QUOTED {
        for ((language, file), (line, prose)) in languages().into_iter().zip(quoted) {
            language.speak();
            let path = format!("{}/{file}", STEPS[number - 1]);
            let handout = source(&path);
            let told = told(number - 1, arguments).iter().any(|told| told == line);
            let said = spaced(&handout).contains(prose);
            if !told || !said || !handout.contains(&format!("`{arguments}`")) {
                wrong.push(format!("{path}, {arguments}: {line} {told}, {prose} {said}"));
            }
        }
    }
    none(wrong);
}
