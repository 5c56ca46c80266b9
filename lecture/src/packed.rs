//! What the page has packed, in letters; of the steps' program without the texts that it never says.

use std::io;
use std::io::Write as _;

use flate2::Compression;
use flate2::write::GzEncoder;
use show::translations;

macro_rules! catalogues {
    ($($tag:literal)*) => {
        &[$(include_str!(concat!("../../common/show/src/", $tag, ".po"))),*]
    };
}

/// The translations that the program has in it: also of what only a command line says.
const CATALOGUES: &[&str] = translations!(catalogues);

/// Bytes, to be written into the page.
///
/// # Errors
///
/// When they cannot be packed.
pub(crate) fn packed(bytes: &[u8]) -> io::Result<String> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    packed.write_all(bytes)?;
    Ok(letters(&packed.finish()?))
}

/// The program with nothing in place of a translation whose English it does not have in it.
pub(crate) fn without_unsaid(program: &[u8]) -> Vec<u8> {
    let mut program = program.to_vec();
    for catalogue in CATALOGUES {
        let length = catalogue.len();
        let Some(place) = program.windows(length).position(|part| part == catalogue.as_bytes())
        else {
            continue;
        };
        let others = [&program[..place], &program[place + length..]].map(String::from_utf8_lossy);
        let is_said = |entry: &str| {
            let (_, english) = entry.split_once("msgid \"").unwrap_or_default();
            let (english, _) = english.split_once("\"\nmsgstr").unwrap_or_default();
            let english = english.replace("\"\n\"", "").replace("\\n", "\n").replace("\\\"", "\"");
            others.iter().any(|text| text.contains(&english))
        };
        let said: String = catalogue
            .split_inclusive("\n\n")
            .map(|entry| if is_said(entry) { entry.to_owned() } else { "\n".repeat(entry.len()) })
            .collect();
        program[place..place + length].copy_from_slice(said.as_bytes());
    }
    program
}

/// Bytes as text, of which each letter has seven bits: shorter than base64. What HTML does not leave as it
/// is (a zero, the end of a line, the beginning of a tag) stands 256 letters further on.
fn letters(bytes: &[u8]) -> String {
    let bit = |at: usize| bytes.get(at / 8).map_or(0, |byte| byte >> (7 - at % 8) & 1);
    let letter = |first: usize| (first..first + 7).fold(0, |letter, at| 2 * letter + bit(at));
    let further = |letter: u8| match letter {
        b'\0' | b'\r' | b'<' => 256 + u32::from(letter),
        letter => u32::from(letter),
    };
    (0..8 * bytes.len()).step_by(7).filter_map(|at| char::from_u32(further(letter(at)))).collect()
}
