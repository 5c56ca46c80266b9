//! The languages in which all is said.

use std::cell::Cell;
use std::collections::HashMap;
use std::fmt::Display;
use std::sync::LazyLock;

/// Hands the tags of all translations to a macro, after what is before them: `translations!(the_macro,
/// something)`. This is the only list of them: a language is one tag here, its catalogue beside this
/// file, and its handouts.
#[macro_export]
macro_rules! translations {
    ($to:ident $(, $($before:tt)*)?) => {
        $to! { $($($before)*)? "pt-BR" }
    };
}

macro_rules! catalogues {
    ($($tag:literal)*) => {
        /// The tag of each translation, and its catalogue.
        const TRANSLATIONS: &[(&str, &str)] = &[$(($tag, include_str!(concat!($tag, ".po")))),*];
    };
}

translations!(catalogues);

/// What a class speaks.
///
/// Every text is in the code in English, and is looked up by that where it is shown: in a catalogue
/// such as translators' tools read and write. Symbols, flags, names of controls and their values are
/// the same in all languages, and so are commands.
///
/// It is the place in the list of all: 0 is English, the others are in the order of the translations.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Language(usize);

thread_local! {
    /// Each thread that shows something has its own, so that two need not agree.
    static SPOKEN: Cell<Language> = const { Cell::new(Language::ENGLISH) };
}

/// Of each translation what is said in it, by what is English.
static TEXTS: LazyLock<Vec<HashMap<String, String>>> = LazyLock::new(|| {
    TRANSLATIONS.iter().map(|(_, catalogue)| read(catalogue).into_iter().collect()).collect()
});

impl Language {
    /// As the code has it.
    pub const ENGLISH: Self = Self(0);

    /// All languages, in the order in which a key goes round them.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        (0..1 + TRANSLATIONS.len()).map(Self)
    }

    /// Its place in the list of all.
    pub fn place(self) -> usize {
        self.0
    }

    /// Its tag, as in `README.pt-BR.md`.
    pub fn tag(self) -> &'static str {
        self.0.checked_sub(1).map_or("en", |place| TRANSLATIONS[place].0)
    }

    /// The name that `--language` knows it by.
    pub fn name(self) -> &'static str {
        self.tag().split('-').next().unwrap_or_default()
    }

    /// The language of a locale such as `pt_BR.UTF-8` or `pt-PT`; English where it is another, or
    /// none.
    pub fn of_locale(locale: &str) -> Self {
        let spoken = locale.split(['_', '-', '.', '@']).next().unwrap_or_default();
        Self::all()
            .find(|language| language.name().eq_ignore_ascii_case(spoken))
            .unwrap_or_default()
    }

    /// The next in the list of all.
    pub fn next(self) -> Self {
        Self((self.0 + 1) % (1 + TRANSLATIONS.len()))
    }

    /// From now on this thread's texts are in this language.
    pub fn speak(self) {
        SPOKEN.set(self);
    }

    /// The language of this thread's texts: English until another is [spoken](Self::speak).
    pub fn spoken() -> Self {
        SPOKEN.get()
    }

    /// All texts of its catalogue, each with its English; none of English.
    pub fn catalogue(self) -> Vec<(String, String)> {
        self.0.checked_sub(1).map_or(Vec::new(), |place| read(TRANSLATIONS[place].1))
    }
}

/// A text in the language that is [spoken](Language::speak); as it is, if the catalogue has none.
pub fn translated(english: &str) -> &str {
    let texts = Language::spoken().0.checked_sub(1).map(|place| &TEXTS[place]);
    texts.and_then(|texts| texts.get(english)).map_or(english, String::as_str)
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
