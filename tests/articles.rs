//! The page as it is written: each handout stands on it once, and what it links to is there.

use std::io::Read;
use std::sync::LazyLock;

use flate2::read::GzDecoder;
use pulldown_cmark::Event;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;
use serde_json::Value;
use tests::prelude::*;

use crate::markup::Element;
use crate::markup::by_id;
use crate::markup::elements;
use crate::protocol::Asked;
use crate::scripts;

/// What the page has in it as the steps' program.
const WASM: &[u8] =
    concat!("no program, but Controls", include_str!("../common/show/src/pt-BR.po")).as_bytes();

pub(crate) static HTML: LazyLock<String> =
    LazyLock::new(|| lecture::html(WASM, &[]).expect("the page is written"));

pub(crate) static ELEMENTS: LazyLock<Vec<Element<'_>>> = LazyLock::new(|| elements(&HTML));

/// Each step's handouts: its number, the text, and the article.
fn handouts() -> impl Iterator<Item = (usize, &'static str, Element<'static>)> {
    (1..).zip(PROGRAMS).flat_map(|(number, program)| {
        Language::all().zip(program.handouts).map(move |(language, text)| {
            let language = language.tag();
            let article = by_id(&ELEMENTS, &format!("handout{number:02}-{language}"));
            assert_eq!(article.says("lang").as_deref(), Some(language));
            (number, *text, article)
        })
    })
}

/// `text` as letters alone, so that it does not matter how it is broken and set.
fn letters(text: &str) -> String {
    text.chars().map(plain).filter(|letter| !letter.is_whitespace() && *letter != '_').collect()
}

#[test]
fn each_article_says_once_what_the_handout_says() {
    for (number, handout, article) in handouts() {
        let shown_already = ["Before and after\n", "Antes e depois\n"];
        let parts = handout.split("\n## ");
        let parts = parts.filter(|part| !shown_already.iter().any(|title| part.starts_with(title)));
        let parts: Vec<&str> = parts.collect();
        let all = article.elements();
        let sections: Vec<&Element<'_>> = all.iter().filter(|it| it.name() == "section").collect();
        let title = all.iter().find(|it| it.name() == "h2").expect("a title").text();
        let headings = sections.iter().map(|it| it.elements()[0].text());
        let headings: Vec<String> = [format!("# {title}")].into_iter().chain(headings).collect();
        let heading = |part: &&str| part.lines().next().unwrap_or_default().replace('`', "");
        assert_eq!(headings, parts.iter().map(heading).collect::<Vec<_>>(), "{number}");
        let kinds = ["idea", "equation", "try", "trap", "asks", "exercise"].into_iter();
        let kinds = kinds.chain(std::iter::repeat("more")).map(str::to_owned);
        assert!(sections.iter().filter_map(|it| it.says("class")).eq(kinds.take(sections.len())));
        let blocks = ["p", "li", "td", "pre", "figcaption"];
        let texts = all.iter().filter(|it| blocks.contains(&it.name())).map(Element::text);
        let mut seen = BTreeSet::new();
        for text in texts.filter(|text| text.len() >= 40) {
            assert!(seen.insert(text.clone()), "twice in step {number}: {text}");
        }
        for (part, section) in parts.iter().zip([&article].into_iter().chain(sections)) {
            says_all(part, section, STEPS[number - 1]);
        }
    }
}

/// Each piece of text of a handout's part is in the section, once the one before it is, or can be tapped
/// there; ways to other pages are not.
fn says_all(part: &str, section: &Element<'_>, step: &str) {
    let is_way = |block: &&str| block.contains("](README") || block.contains("](../README");
    let blocks: Vec<&str> = part.split("\n\n").filter(|block| !is_way(block)).collect();
    let offers: Vec<String> = section.elements().iter().filter_map(|it| it.says("title")).collect();
    let start = format!("cargo run -p {step}");
    let is_done = |text: &str| {
        let mut lines = text.lines().map(|line| line.strip_prefix(&start).unwrap_or(line));
        lines.all(|line| line.is_empty() || offers.iter().any(|it| line.ends_with(it)))
    };
    let all = section.elements();
    let fold = all.iter().find(|it| it.is("look")).map(|it| it.elements()[0].text());
    let text = section.text();
    let said = letters(&fold.map_or(text.clone(), |fold| text.replace(&fold, "")));
    let (mut rest, mut deep) = (&*said, 0);
    for event in
        Parser::new_ext(&blocks.join("\n\n"), Options::ENABLE_TABLES | Options::ENABLE_MATH)
    {
        use Tag::*;
        match event {
            // A figure's text stands where the handout has the figure.
            Event::Start(Link { dest_url, .. }) if dest_url.starts_with("examples/") => {}
            Event::Start(Table(_) | Link { .. } | Heading { .. } | Image { .. }) => deep += 1,
            Event::End(TagEnd::Link) if deep == 0 => {}
            Event::End(TagEnd::Table | TagEnd::Link | TagEnd::Heading(_) | TagEnd::Image) => {
                deep -= 1
            }
            Event::Text(text) | Event::Code(text) if deep == 0 && !is_done(&text) => {
                let after = rest.split_once(&letters(&text));
                rest = after.unwrap_or_else(|| panic!("{step}: {text}")).1;
            }
            _ => {}
        }
    }
}

/// A bold or slanted letter as any other.
fn plain(letter: char) -> char {
    let alphabets = [('𝐀', 'A'), ('𝐚', 'a'), ('𝐴', 'A'), ('𝑎', 'a'), ('𝛼', 'α')];
    let place = |first: char| (letter as u32).checked_sub(first as u32);
    let found = alphabets.iter().find_map(|(first, plain)| {
        let place = place(*first).filter(|place| *place < 26)?;
        char::from_u32(*plain as u32 + place)
    });
    match letter {
        'ℎ' => 'h',
        '⋅' => '·',
        '∗' => '*',
        '²' => '2',
        letter => found.unwrap_or(letter),
    }
}

/// A symbol, or what is written in an equation, as it is read out: bold and slanted letters and indices
/// are as any others, and the index of a light says nothing.
fn read_out(text: &str) -> String {
    let letters = text.chars().map(plain);
    letters.filter(|letter| !"_/^√ 𝑖i⏟\u{2061}".contains(*letter)).collect()
}

#[test]
fn below_each_symbol_is_the_place_for_its_number() {
    for (number, _, article) in handouts() {
        let told = explained(&setup(number - 1), (480, 300), Size::DEFAULT);
        let told: Vec<&str> = told.told.all_lines().iter().map(|line| line.symbol()).collect();
        let section = article.elements().into_iter().find(|it| it.is("equation")).unwrap();
        let all = section.elements();
        let is_place = |it: &&Element<'_>| it.says("data-symbol").is_some();
        let mut count = 0;
        for under in all.iter().filter(|it| it.name() == "munder") {
            let inner = under.elements();
            let Some(place) = inner.iter().find(is_place) else { continue };
            let symbol = place.says("data-symbol").unwrap();
            let is_told = told.contains(&&*symbol);
            let written = symbol.replace("t_max", "t*").replace("t₁", "t");
            let same = read_out(&under.text()) == read_out(&written);
            assert!(is_told && same, "step {number}: {symbol} below {}", under.text());
            count += 1;
        }
        assert!(count > 0 && count == all.iter().filter(is_place).count(), "step {number}");
    }
}

#[test]
fn what_is_to_be_tried_is_what_the_link_opens() {
    for (number, _, article) in handouts() {
        let mut tried = 0;
        for link in article.elements().into_iter().filter(|it| it.name() == "a") {
            let to = link.says("href").or(link.says("data-address")).expect("where it leads");
            let mut shown = Desk::new(programs(), 0);
            let effects = act(&mut shown, Act::Open(to.clone()));
            assert!(!effects.iter().any(|effect| matches!(effect, Effect::Say(_))), "{to}");
            if link.is("try") {
                let typed = link.says("title").expect("its command");
                let expected = after(Desk::new(programs(), number - 1), &acts_of(&typed));
                assert_eq!(address(&shown), address(&expected), "{typed}");
                // As the page writes it, so that it sees whether it is shown.
                assert_eq!(to, shown.shown_address(), "{typed}");
                tried += 1;
            }
        }
        assert!(tried > 3, "step {number}");
    }
}

#[test]
fn each_figure_has_a_place_of_its_shape() {
    let style = ELEMENTS.iter().find(|it| it.name() == "style").expect("a style").inner;
    let mut places: Vec<(String, String)> = Vec::new();
    for (_, _, article) in handouts() {
        let all = article.elements();
        for place in all.iter().filter(|it| it.says("data-figure").is_some()) {
            let name = place.says("data-figure").unwrap();
            let is_said = place.says("aria-label").is_some_and(|seen| seen.len() > 20);
            assert!(place.is("still") && place.is(&name) && is_said, "{name}");
            let about = place.says("data-about").expect("the control that it is about");
            let mut page = Asked::at("");
            let groups = page.ask(json!({"state": {"of": name, "spoken": "en"}}))["groups"].clone();
            assert!(groups.to_string().contains(&format!("{about:?}")), "{name} is about {about}");
            places.push((name, article.says("lang").unwrap()));
        }
    }
    places.sort();
    let languages = |name: &str| ["en", "pt-BR"].map(|it| (name.to_owned(), it.to_owned()));
    let mut expected = FIGURES.map(|(name, _)| languages(name)).concat();
    expected.sort();
    assert_eq!(places, expected);
    for (name, figure) in FIGURES {
        let (_, rule) = style.split_once(&format!(".{name} {{")).expect(name);
        let shape = rule.split_once("aspect-ratio: ").expect(name).1.split(';').next().unwrap();
        assert_eq!(shape.replace(" / ", "x"), figure().size.to_string(), "{name}");
    }
}

/// The bytes of a text of which each letter has seven bits.
fn bytes_of(text: &str) -> Vec<u8> {
    let bits: Vec<u32> = text
        .chars()
        .flat_map(|letter| (0..7).rev().map(move |bit| letter as u32 >> bit & 1))
        .collect();
    bits.chunks_exact(8)
        .map(|bits| bits.iter().fold(0, |byte, bit| 2 * byte + *bit) as u8)
        .collect()
}

#[test]
fn all_of_it_is_there_and_nothing_is_elsewhere() {
    let ids: Vec<String> = ELEMENTS.iter().map(Element::id).filter(|id| !id.is_empty()).collect();
    for (place, id) in ids.iter().enumerate() {
        assert!(!ids[..place].contains(id), "two have the id {id}");
    }
    for element in ELEMENTS.iter() {
        for said in ["for", "aria-describedby"].iter().filter_map(|it| element.says(it)) {
            assert!(ids.contains(&said), "there is no #{said}");
        }
        for said in ["href", "src"].iter().filter_map(|it| element.says(it)) {
            assert!(
                said.starts_with("#step") || ["#", "data:,"].contains(&&*said),
                "{said} is elsewhere"
            );
        }
        if let Some(key) = element.says("data-key") {
            let done = Asked::at("").ask(json!({"key": {"key": key, "down": true}}));
            assert_eq!(done["known"], true, "{key}");
        }
    }
    assert!(!HTML.contains("{{") && !HTML.contains("<!--"));
    let letters = by_id(&ELEMENTS, "wasm").inner;
    assert!(!letters.contains(['\0', '\r', '<']), "a browser reads another letter");
    let packed = bytes_of(letters);
    let mut program = Vec::new();
    GzDecoder::new(&*packed).read_to_end(&mut program).expect("it is packed");
    assert_eq!(program.len(), WASM.len());
    // Of the catalogue it has what it says.
    let program = String::from_utf8(program).expect("it is text");
    let (before, catalogue) = program.split_at(program.find("Controls").expect("it is said") + 8);
    let said = ["\nmsgid \"Controls\"\nmsgstr", "msgid \"Keys\""].map(|it| catalogue.contains(it));
    assert_eq!((before, said), ("no program, but Controls", [true, false]));
}

#[test]
fn each_text_of_the_page_has_a_translation() {
    let texts: Value = serde_json::from_str(by_id(&ELEMENTS, "texts").inner).expect("JSON");
    let catalogue = portuguese().catalogue();
    let said = ELEMENTS.iter().flat_map(|it| ["data-text", "data-name"].map(|name| it.says(name)));
    for english in said.flatten().chain(scripts::said()) {
        let portuguese = texts["pt-BR"][&english].as_str();
        let expected = catalogue.iter().find(|(known, _)| *known == english);
        assert_eq!(portuguese, expected.map(|(_, text)| &**text), "{english}");
        assert!(portuguese.is_some(), "{english}");
    }
}
