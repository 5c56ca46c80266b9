//! The page as it is written: each handout stands on it once, and what it links to is there.

use std::io::Read;
use std::sync::LazyLock;

use flate2::read::GzDecoder;
use lecture::FIGURES;
use lecture::PROGRAMS;
use pulldown_cmark::Event;
use pulldown_cmark::Options;
use pulldown_cmark::Parser;
use pulldown_cmark::Tag;
use pulldown_cmark::TagEnd;
use serde_json::Value;
use serde_json::json;
use tests::prelude::*;

use crate::markup::Element;
use crate::markup::by_id;
use crate::markup::elements;
use crate::protocol::Asked;
use crate::scripts;

/// What the page has in it as the steps' program.
const WASM: &[u8] = b"no program";

/// The whole page.
pub(crate) static HTML: LazyLock<String> =
    LazyLock::new(|| lecture::html(WASM, &[]).expect("the page is written"));

/// Its elements, made once.
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
    text.chars().filter(|letter| !letter.is_whitespace() && *letter != '_').collect()
}

#[test]
fn each_article_says_what_the_handout_says() {
    for (number, handout, article) in handouts() {
        let is_shown_already = |part: &&str| {
            !["Before and after\n", "Antes e depois\n"].iter().any(|h| part.starts_with(h))
        };
        let parts: Vec<&str> = handout.split("\n## ").filter(is_shown_already).collect();
        let heading = |part: &&str| part.lines().next().unwrap().replace('`', "");
        let all = article.elements();
        let is_section = |it: &&Element<'_>| it.name() == "details" && it.says("class").is_some();
        let sections: Vec<&Element<'_>> = all.iter().filter(is_section).collect();
        let title = all.iter().find(|it| it.name() == "h2").expect("a title");
        let first = |it: &&Element<'_>| it.elements()[1].text();
        let headings = [vec![title.text()], sections.iter().map(first).collect()].concat();
        let expected: Vec<String> = parts.iter().map(heading).collect();
        assert_eq!(headings.join("\n"), expected.join("\n").trim_start_matches("# "), "{number}");
        let open: Vec<(String, bool)> = sections
            .iter()
            .map(|it| (it.says("class").unwrap(), it.says("open").is_some()))
            .collect();
        let first = ["idea", "equation", "try"].map(|class| (class.to_owned(), true));
        assert_eq!(open[..3], first, "step {number}");
        assert!(open[3..].iter().all(|it| *it == ("more".to_owned(), false)), "step {number}");

        // Each piece of text is there, once the one before it is; ways to other pages are not.
        let handout = parts.join("\n## ");
        let is_way = |block: &&str| block.contains("](README") || block.contains("](../README");
        let blocks: Vec<&str> = handout.split("\n\n").filter(|block| !is_way(block)).collect();
        let article = letters(&article.text());
        let (mut rest, mut deep) = (&*article, 0);
        let options = Options::ENABLE_TABLES | Options::ENABLE_MATH;
        for event in Parser::new_ext(&blocks.join("\n\n"), options) {
            match event {
                Event::Start(
                    Tag::Table(_) | Tag::Link { .. } | Tag::Heading { .. } | Tag::Image { .. },
                ) => deep += 1,
                Event::End(TagEnd::Table | TagEnd::Link | TagEnd::Heading(_) | TagEnd::Image) => {
                    deep -= 1
                }
                Event::Text(text) | Event::Code(text) if deep == 0 => {
                    let text = letters(&text);
                    let (_, after) =
                        rest.split_once(&text).unwrap_or_else(|| panic!("{number}: {text}"));
                    rest = after;
                }
                _ => {}
            }
        }
    }
}

#[test]
fn no_text_stands_on_the_page_twice() {
    for (number, _, article) in handouts() {
        let mut seen: Vec<String> = Vec::new();
        for element in article.elements() {
            let text = element.text();
            if !["p", "li", "td", "pre", "figcaption"].contains(&element.name()) || text.len() < 40
            {
                continue;
            }
            assert!(!seen.contains(&text), "step {number}: {text}");
            seen.push(text);
        }
    }
}

/// A symbol, or what is written in an equation, as it is read out: bold letters and indices are as
/// any others, and the index of a light says nothing.
fn read_out(text: &str) -> String {
    let plain = |letter: char| match letter {
        '𝐩' => 'p',
        '𝐝' => 'd',
        '𝐧' => 'n',
        '𝐥' => 'l',
        '𝐡' => 'h',
        '⋅' => '·',
        '²' => '2',
        letter => letter,
    };
    let is_silent = |letter: &char| "_/^√ i\u{2061}".contains(*letter);
    text.chars().filter(|letter| !is_silent(letter)).map(plain).collect()
}

#[test]
fn below_each_symbol_is_the_place_for_its_number() {
    for (number, _, article) in handouts() {
        let step = step(number - 1);
        let pixel = Pixel { col: 480, row: 300, width: 960, height: 540 };
        let told = step.explain(&*step.view().camera(960.0 / 540.0), pixel);
        let told: Vec<&str> = told.told.all_lines().iter().map(|line| line.symbol()).collect();
        let section = article.elements().into_iter().find(|it| it.is("equation")).unwrap();
        let all = section.elements();
        let is_place = |it: &&Element<'_>| it.says("data-symbol").is_some();
        let mut symbols = Vec::new();
        for under in all.iter().filter(|it| it.name() == "munder") {
            let inner = under.elements();
            let Some(place) = inner.iter().find(is_place) else { continue };
            let symbol = place.says("data-symbol").unwrap();
            let is_told = symbol.split('|').any(|symbol| told.contains(&symbol));
            assert!(is_told, "step {number} does not tell {symbol}");
            let written = match &*symbol {
                "t_max" => "t*".to_owned(),
                "t₁|t" => "t".to_owned(),
                symbol => read_out(symbol),
            };
            assert_eq!(read_out(&under.text()), written, "step {number}: {symbol}");
            symbols.push(symbol);
        }
        assert!(!symbols.is_empty(), "step {number}");
        assert_eq!(symbols.len(), all.iter().filter(is_place).count(), "step {number}");
    }
}

/// A desk that shows what an address says.
fn opened(address: &str) -> Desk {
    let mut desk = Desk::new(lecture::programs(), 0);
    let effects = desk.act(Act::Open(address.to_owned())).expect("an address");
    let said = effects.iter().find(|effect| matches!(effect, Effect::Say(_)));
    assert_eq!(said, None, "{address}");
    desk
}

#[test]
fn what_is_to_be_tried_is_what_the_link_opens() {
    for (number, _, article) in handouts() {
        let mut tried = 0;
        for link in article.elements().into_iter().filter(|it| it.name() == "a") {
            let address = link.says("href").expect("where it leads");
            let shown = opened(&address);
            if !link.is("try") {
                continue;
            }
            tried += 1;
            let mut expected = Desk::new(lecture::programs(), number - 1);
            let text = link.text();
            let mut words = text.split_whitespace();
            while let Some(flag) = words.next() {
                let mut value = || words.next().expect("a value").to_owned();
                let whole = |number: &str| number.parse().expect("a whole number");
                let asked = match flag {
                    "--set" => {
                        let setting = value();
                        let (name, value) = setting.split_once('=').expect("a setting");
                        Act::Set(name.to_owned(), value.to_owned())
                    }
                    "--camera" => Act::Set("camera".to_owned(), value()),
                    "--pixel" => {
                        let place = value();
                        let (col, row) = place.split_once(',').expect("a pixel");
                        Act::PinPixel(whole(col), whole(row))
                    }
                    "--show" => Act::ShowNamed(value()),
                    "--what-if" => Act::Answer(value()),
                    "--outside" => Act::Outside,
                    "--size" => Act::Size(value().parse().expect("a size")),
                    _ => panic!("{text}"),
                };
                act(&mut expected, asked);
            }
            let [shown, expected] = [shown, expected].map(|desk| desk.address(Language::ENGLISH));
            assert_eq!(shown, expected, "{text}");
        }
        assert!(tried > 3, "step {number}");
    }
}

#[test]
fn each_figure_has_a_place_of_its_shape() {
    let style = ELEMENTS.iter().find(|it| it.name() == "style").expect("a style").inner;
    for language in ["en", "pt-BR"] {
        let mut names = Vec::new();
        for (_, _, article) in handouts().filter(|it| it.2.says("lang").unwrap() == language) {
            let all = article.elements();
            for place in all.iter().filter(|it| it.says("data-figure").is_some()) {
                let name = place.says("data-figure").unwrap();
                assert!(place.is("still") && place.is(&name), "{name}");
                assert!(place.says("aria-label").is_some_and(|seen| seen.len() > 20), "{name}");
                names.push(name);
            }
        }
        names.sort();
        let mut expected = FIGURES.map(|(name, _)| name);
        expected.sort_unstable();
        assert_eq!(names, expected);
    }
    for (name, figure) in FIGURES {
        let (_, rule) =
            style.split_once(&format!(".{name} {{")).unwrap_or_else(|| panic!("{name}"));
        let shape = rule.split_once("aspect-ratio: ").unwrap().1.split(';').next().unwrap();
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
            assert!(said.starts_with("#step") || said == "data:,", "{said} is elsewhere");
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
    assert!(program == WASM);
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
