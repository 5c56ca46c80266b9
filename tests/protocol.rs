//! What the page is answered, as a browser would ask, without one.

use page::Page;
use serde_json::Value;
use tests::prelude::*;

/// A page that is asked in JSON.
pub(crate) struct Asked(Page);

impl Asked {
    /// A page that shows what `address` says.
    pub(crate) fn at(address: &str) -> Self {
        let mut page = Self(lecture::page());
        page.does(json!({"open": address}));
        page
    }

    pub(crate) fn answer(&mut self, question: &Value, below: &[u8]) -> Result<Vec<u8>, String> {
        self.0.answer(&[question.to_string().as_bytes(), b"\n", below].concat())
    }

    pub(crate) fn bytes(&mut self, question: Value, below: &[u8]) -> Vec<u8> {
        self.answer(&question, below).unwrap_or_else(|error| panic!("{question}: {error}"))
    }

    pub(crate) fn ask(&mut self, question: Value) -> Value {
        serde_json::from_slice(&self.bytes(question, b"")).expect("JSON")
    }

    pub(crate) fn does(&mut self, what: Value) -> Value {
        self.ask(json!({"do": what}))
    }

    pub(crate) fn press(&mut self, key: &str) -> Value {
        self.ask(json!({"key": {"key": key, "down": true}}))
    }

    pub(crate) fn state(&mut self) -> Value {
        self.ask(json!({"state": {"spoken": "en"}}))
    }

    /// All rows of a layer, 64 × 36 pixels large.
    pub(crate) fn rows(&mut self, layer: Value) -> Vec<u8> {
        self.bytes(rows(layer, [64, 36], 0, 36), b"")
    }

    /// These layers as they are shown, three bytes a pixel.
    fn shown(&mut self, of: Option<&str>, layers: &[Value]) -> Vec<u8> {
        let rgb: Vec<Vec<u8>> = layers.iter().map(|layer| self.rows(layer.clone())).collect();
        let show = json!({"of": of, "size": [64, 36], "drawn": [64, 36]});
        let rgba = self.bytes(json!({"show": show}), &rgb.concat());
        assert!(rgba.iter().skip(3).step_by(4).all(|alpha| *alpha == 255));
        rgba.chunks_exact(4).flat_map(|pixel| &pixel[..3]).copied().collect()
    }

    fn setting(&mut self, name: &str, what: &str) -> Value {
        let state = self.state();
        let groups = state["groups"].as_array().expect("groups");
        let mut settings = groups.iter().flat_map(|it| it["settings"].as_array().expect("a list"));
        let setting = settings.find(|setting| setting["name"] == name);
        setting.expect("there is the control")[what].clone()
    }
}

fn rows(layer: Value, size: [u64; 2], first: u64, count: u64) -> Value {
    json!({"rows": {"layer": layer, "size": size, "first": first, "count": count}})
}

#[test]
fn rows_are_those_of_what_is_shown() {
    for (program, seen) in
        PROGRAMS.iter().flat_map(|it| ["", "&azimuth=9", "&outside=on"].map(|by| (it, by)))
    {
        let address = format!("#{}{seen}", &program.name[..6]);
        let mut page = Asked::at(&address);
        let desk = after(Desk::new(programs(), 0), &[Act::Open(address.clone())]);
        let picture = pictures_of(&desk, size(64, 36)).remove(0);
        let parts = [(0, 20), (20, 16)]
            .map(|(first, count)| page.bytes(rows(json!("now"), [64, 36], first, count), b""));
        assert!(parts.concat() == *picture.as_raw(), "{address}");
    }
}

#[test]
fn a_handle_follows_the_hand() {
    let mut page = Asked::at("#step03&handles=on");
    let grab =
        |page: &mut Asked, at: [f32; 2]| page.ask(json!({"grab": {"at": at, "reach": 0.01}}));
    let mut places = pixels(96, 54).map(|at| [at.col as f32 / 96.0, at.row as f32 / 54.0]);
    let [u, v] = places.find(|at| grab(&mut page, *at) == 0).expect("a corner is seen");
    page.does(json!({"drag": [0, [u - 0.1, v]]}));
    assert_eq!(grab(&mut page, [u, v]), Value::Null);
    assert_eq!(grab(&mut page, [u - 0.1, v]), 0);
    assert_eq!(page.setting("a.x", "changed"), true);
    // What is not shown cannot be taken hold of.
    page.press("h");
    assert_eq!(grab(&mut page, [u - 0.1, v]), Value::Null);
}

#[test]
fn what_lies_over_a_picture_changes_only_it() {
    let now = json!("now");
    let plain = Asked::at("#step07").rows(now.clone());
    for (address, marked) in [
        ("", false),
        ("&pixel=30,15&vectors=off", false),
        ("&pixel=30,15", true),
        ("&handles=on", true),
    ] {
        let mut page = Asked::at(&format!("#step07&size=64x36{address}"));
        assert_eq!(page.state()["marked"], marked, "{address}");
        // Laid over the picture, the marks are what they are when they are drawn on it.
        let marks = page.bytes(json!({"marks": {"size": [64, 36], "text": 8}}), b"");
        let address = format!("#step07&size=64x36{address}");
        let desk = after(Desk::new(lecture::programs(), 0), &[Act::Open(address.clone())]);
        let mut drawn = RgbImage::from_raw(64, 36, plain.clone()).expect("all rows");
        let mut canvas = Canvas::new(&mut drawn);
        let area = canvas.area();
        draw_marks(&desk, &mut canvas, area, 8.0);
        assert_eq!(*drawn != plain, marked, "{address}");
        let pixels = plain.chunks_exact(3).zip(drawn.pixels()).zip(marks.chunks_exact(4));
        for ((under, drawn), mark) in pixels {
            let cover = f32::from(mark[3]) / 255.0;
            for channel in 0..3 {
                let through = (1.0 - cover) * f32::from(under[channel]);
                let seen = through + cover * f32::from(mark[channel]);
                let off = (seen - f32::from(drawn[channel])).abs();
                assert!(off <= 3.0, "{address}: {under:?} {mark:?} {drawn:?}");
            }
        }
        assert!(page.rows(now.clone()) == plain, "{address}");
    }
    // A coarse picture becomes as large as it is shown.
    let show = json!({"size": [128, 72], "drawn": [64, 36]});
    let large = Asked::at("#step07").bytes(json!({"show": show}), &plain);
    assert_eq!(large.len(), 4 * 128 * 72);
    assert_eq!(large[4 * (128 * 40 + 60)..][..3], plain[3 * (64 * 20 + 30)..][..3]);
}

#[test]
fn two_pictures_are_shown_as_they_are_compared() {
    let layers = [json!("before"), json!("now")];
    for (address, wanted) in
        [("", &layers[1..]), ("&divide=0.25", &layers[..]), ("&difference=on", &layers[..])]
    {
        let mut page = Asked::at(&format!("#step07{address}"));
        assert_eq!(page.state()["layers"], json!(wanted), "{address}");
        let [before, now] = layers.clone().map(|layer| page.rows(layer));
        let shown = page.shown(None, wanted);
        let pictures = [&before, &now].map(|rgb| RgbImage::from_raw(64, 36, rgb.clone()));
        let [Some(first), Some(second)] = pictures else { panic!("all rows") };
        let differing = difference(&first, &second).into_raw();
        for (at, shown) in shown.into_iter().enumerate() {
            let expected = match address {
                "&difference=on" => differing[at],
                "&divide=0.25" if at / 3 % 64 < 16 => before[at],
                _ => now[at],
            };
            assert_eq!(shown, expected, "{address}: byte {at}");
        }
        page.press("a");
        assert_eq!(page.state()["layers"], json!(["before"]), "{address}, held");
        assert!(page.shown(None, &layers[..1]) == before, "{address}, held");
    }
}

#[test]
fn each_symbol_has_the_number_of_what_is_seen() {
    let told = explained(&setup(6), (465, 215), Size::DEFAULT);
    let explained = Asked::at("#step07&pixel=465,215").ask(json!("explain"));
    let scope = |name| told.scope(name).expect("it is told");
    let red = scope("intersection").scopes().next().expect("it is seen");
    let (ray, lit) = (scope("viewing ray"), scope("illumination"));
    let sum = lit.scopes().last().expect("it is summed");
    let seen = [(ray, "u"), (ray, "p"), (red, "t₁"), (red, "D"), (lit, "k_a"), (sum, "L")];
    let mut expected: Vec<(usize, &Scope, &str)> = seen.map(|(of, symbol)| (0, of, symbol)).into();
    for (place, light) in (1..).zip(lit.scopes().take(2)) {
        assert_eq!(explained["symbols"][place]["of"], light.name);
        expected.extend(["n·l", "I/r²", "k_s", "V", "p"].map(|symbol| (place, light, symbol)));
    }
    let found = |place: usize, symbol: &str| {
        let values = explained["symbols"][place]["values"].as_array().expect("symbols");
        let values = values.iter().filter(|pair| pair[0] == symbol).map(|pair| pair[1].clone());
        values.collect::<Vec<_>>()
    };
    for (place, scope, symbol) in expected {
        let line = scope.lines().find(|line| line.symbol() == symbol).expect(symbol);
        assert_eq!(found(place, symbol), [json!(rounded(&line.value))], "{}: {symbol}", scope.name);
    }
    assert_eq!(found(0, "n·l"), [Value::Null; 0]);
    // Where there is but one of a kind, there is nothing to be chosen.
    for address in ["#step05&pixel=465,215", "#step02&pixel=480,270", "#step07&pixel=1,1"] {
        let symbols = Asked::at(address).ask(json!("explain"))["symbols"].clone();
        assert_eq!(symbols.as_array().map(Vec::len), Some(1), "{address}");
    }
}

#[test]
fn what_cannot_be_done_is_said_and_changes_nothing() {
    let mut page = Asked::at("#step07&p=10");
    let state = page.state();
    let show = |size: [u64; 2], drawn: [u64; 2]| json!({"show": {"size": size, "drawn": drawn}});
    for question in [
        json!(""),
        json!({}),
        json!("nothing"),
        json!({"do": "nothing"}),
        json!({"do": {"step": -1}}),
        json!({"do": {"set": ["p"]}}),
        json!({"do": {"set": ["p", "NaN"]}}),
        json!({"do": {"set": ["nothing", "1"]}}),
        json!({"do": {"set": ["outside.nothing", "1"]}}),
        json!({"do": {"orbit": [Value::Null, 1]}}),
        json!({"do": {"drag": [99, [0, 0]]}}),
        json!({"doOn": ["none", "unpin"]}),
        json!({"state": {"of": "none", "spoken": "en"}}),
        json!({"key": "a"}),
        json!({"grab": {"at": [0.5], "reach": 1}}),
        rows(json!("never"), [9, 9], 0, 1),
        rows(json!({"figure": "none"}), [9, 9], 0, 1),
        rows(json!("now"), [0, 9], 0, 1),
        rows(json!("now"), [99999, 99999], 0, 1),
        rows(json!("now"), [9, 9], 9, 1),
        rows(json!("now"), [9, 9], 1, u64::MAX),
        show([9, 9], [9, 9]),
        show([99999, 99999], [1, 1]),
    ] {
        let error = page.answer(&question, b"").expect_err(&question.to_string());
        assert!(!error.is_empty() && !error.contains('\n'), "{question}: {error}");
    }
    assert!(page.answer(&show([9, 9], [9, 9]), b"abc").is_err());
    assert!(page.0.answer(b"\xff").is_err() && page.0.answer(b"").is_err());
    assert_eq!(page.state(), state);
    // What stands on the page is not said in words as well.
    assert_eq!(page.press("c")["said"], Value::Null);
    for (from_outside, is_said) in [(false, false), (true, true)] {
        let said = page.does(json!({"pin": [0.5, 0.5]}))["said"].clone();
        assert_eq!(said != Value::Null, is_said, "from outside {from_outside}: {said}");
        page.press("o");
    }
    page.does(json!({"step": 1}));
    assert!(page.answer(&rows(json!("before"), [9, 9], 0, 9), b"").is_err());
}

#[test]
fn answers_are_in_the_language_that_was_asked_for() {
    let mut page = Asked::at("#step06&pixel=240,420");
    let mut told = |locale: &str| {
        page.does(json!({"language": locale}));
        let wrong = page.answer(&json!({"do": {"set": ["epsilon", "x"]}}), b"");
        let texts = json!([page.ask(json!("explain")), page.state(), page.ask(json!("keys"))]);
        format!("{texts} {}", wrong.expect_err("it is no number"))
    };
    let (english, portuguese) = (told("en"), told("pt-BR"));
    for words in [
        ["\"shown\":\"viewing ray\"", "\"shown\":\"raio de visão\""],
        ["\"outcome\":\"no root: ", "\"outcome\":\"sem raiz: "],
        ["\"shown\":\"key light\"", "\"shown\":\"luz principal\""],
        ["\"the first stop\"", "\"a primeira parada\""],
        ["cannot be", "não pode ser"],
    ] {
        for (place, answer) in [&english, &portuguese].into_iter().enumerate() {
            let says = words.map(|word| answer.contains(word));
            assert_eq!(says, [place == 0, place == 1], "{words:?}");
        }
    }
    assert_eq!(told("en"), english);
}

#[test]
fn a_figure_is_changed_alone() {
    let figure = json!({"figure": "both_roots"});
    let mut page = Asked::at("#step02");
    let its = |page: &mut Asked| page.ask(json!({"state": {"of": "both_roots", "spoken": "en"}}));
    let (start, first) = (page.state(), its(&mut page));
    assert_eq!(first["size"][0], 960);
    let before = page.rows(figure.clone());
    // Its letters lie over its rows.
    assert!(page.shown(Some("both_roots"), std::slice::from_ref(&figure)) != before);
    page.ask(json!({"doOn": ["both_roots", {"set": ["radius", "0.5"]}]}));
    assert!(page.rows(figure) != before);
    assert!(its(&mut page)["address"].to_string().contains("radius=0.5"));
    assert_eq!(page.state(), start);
    page.ask(json!({"doOn": ["both_roots", {"reset": "radius"}]}));
    assert_eq!(its(&mut page), first);
}

#[test]
fn a_control_is_told_as_what_it_is() {
    let mut page = Asked::at("#step07");
    let label = mathml(&plain("k_s", Letters::Scalar), false, &mut |_, _| None);
    for (name, what, expected) in [
        ("camera", "kind", json!("choice")),
        ("camera", "options", json!(["perspective", "parallel"])),
        ("green.k_s", "kind", json!("number")),
        ("green.k_s", "label", json!(label)),
        ("green.k_s", "takes", json!("0 to 1")),
    ] {
        assert_eq!(page.setting(name, what), expected, "{name}: {what}");
    }
    page.does(json!({"fraction": ["green.k_s", 0.25]}));
    let told = ["text", "fraction", "changed"].map(|what| page.setting("green.k_s", what));
    assert_eq!(told, [json!("0.25"), json!(0.25), json!(true)]);
    let figure = page.ask(json!({"state": {"of": "both_roots", "spoken": "en"}}));
    assert!(figure["groups"].to_string().contains("\"kind\":\"count\""));
}
