//! The languages in which all is said.

use std::cell::Cell;
use std::collections::HashMap;
use std::fmt::Display;
use std::sync::LazyLock;

/// What a class speaks.
///
/// Every text is in the code in English, and is looked up by that where it is shown: in
/// `pt-BR.po`, a catalogue such as translators' tools read and write. Symbols, flags, names of
/// controls and their values are the same in all languages, and so are commands.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Language {
    /// As the code has it.
    #[default]
    English,
    /// As it is spoken in Brazil.
    Portuguese,
}

thread_local! {
    /// Each thread that shows something has its own, so that two need not agree.
    static SPOKEN: Cell<Language> = const { Cell::new(Language::English) };
}

/// What is Portuguese, by what is English.
static PORTUGUESE: LazyLock<HashMap<String, String>> =
    LazyLock::new(|| read(include_str!("pt-BR.po")).into_iter().collect());

impl Language {
    /// Both, each with the name that `--language` knows it by.
    pub const ALL: [(&'static str, Self); 2] = [("pt", Self::Portuguese), ("en", Self::English)];

    /// The language of a locale such as `pt_BR.UTF-8` or `pt-PT`; English where it is another, or
    /// none.
    pub fn of_locale(locale: &str) -> Self {
        match locale.get(..2) {
            Some(language) if language.eq_ignore_ascii_case("pt") => Self::Portuguese,
            _ => Self::English,
        }
    }

    /// The next in the list of all.
    pub fn next(self) -> Self {
        let place = Self::ALL.iter().position(|(_, language)| *language == self).unwrap_or(0);
        Self::ALL[(place + 1) % Self::ALL.len()].1
    }

    /// The name that `--language` knows it by.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, language)| *language == self).map_or("", |(name, _)| name)
    }

    /// From now on this thread's texts are in this language.
    pub fn speak(self) {
        SPOKEN.set(self);
    }

    /// The language of this thread's texts: English until another is [spoken](Self::speak).
    pub fn spoken() -> Self {
        SPOKEN.get()
    }

    /// All texts of the catalogue: English, Portuguese.
    pub fn catalogue() -> Vec<(String, String)> {
        read(include_str!("pt-BR.po"))
    }
}

/// A text in the language that is [spoken](Language::speak); as it is, if the catalogue has none.
pub fn translated(english: &str) -> &str {
    match Language::spoken() {
        Language::English => english,
        Language::Portuguese => PORTUGUESE.get(english).map_or(english, String::as_str),
    }
}

/// The translation of `english` with `values` in the place of their {names}.
#[doc(hidden)]
pub fn filled(english: &str, values: &[(&str, &dyn Display)]) -> String {
    let mut text = String::new();
    let mut rest = translated(english);
    while let Some((before, after)) = rest.split_once('{') {
        text.push_str(before);
        let (name, after) = after.split_once('}').unwrap_or((after, ""));
        match values.iter().find(|value| value.0 == name) {
            Some((_, value)) => text.push_str(&value.to_string()),
            None => text.push_str(name),
        }
        rest = after;
    }
    text + rest
}

/// A text in the language that is [spoken](Language::speak), found by its English. With names after
/// it, each alone or as `name = value`, their values take the place of each `{name}`.
#[macro_export]
macro_rules! text {
    ($english:literal) => { $crate::translated($english) };
    ($english:literal, $($name:ident $(= $value:expr)?),+ $(,)?) => {
        $crate::filled($english, &[$((stringify!($name), &$crate::text!(@ $name $($value)?))),+])
    };
    (@ $name:ident) => { $name };
    (@ $name:ident $value:expr) => { $value };
}

/// The texts of a catalogue, each with its translation, in its order.
fn read(catalogue: &str) -> Vec<(String, String)> {
    let mut texts: Vec<[String; 2]> = Vec::new();
    let mut of = 0;
    for line in catalogue.lines() {
        let (keyword, quoted) = line.split_once('"').unwrap_or((line, ""));
        match keyword.trim() {
            "msgid" => {
                texts.push(Default::default());
                of = 0;
            }
            "msgstr" => of = 1,
            _ => {}
        }
        if let (Some(text), Some(quoted)) = (texts.last_mut(), quoted.strip_suffix('"'))
            && !line.starts_with('#')
        {
            text[of] += &quoted.replace("\\n", "\n").replace("\\\"", "\"").replace("\\\\", "\\");
        }
    }
    // What has no English is the catalogue's own: who made it, and how it is encoded.
    texts.retain(|[english, _]| !english.is_empty());
    texts.into_iter().map(|[english, translation]| (english, translation)).collect()
}
