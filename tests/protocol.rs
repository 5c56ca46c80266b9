//! What the page with all steps is answered, as a browser would ask, without one.

use lecture::PROGRAMS;
use lecture::Page;
use show::Frame;
use show::Size;

fn text(page: &mut Page, command: &str) -> String {
    let answer =
        page.answer(command.as_bytes()).unwrap_or_else(|error| panic!("{command}: {error}"));
    String::from_utf8(answer).expect("text")
}

/// The fields of the line of `state` that is about a control.
fn setting(page: &mut Page, name: &str) -> Vec<String> {
    let state = text(page, "state");
    let line = state.lines().find(|line| line.starts_with(&format!("setting\t{name}\t")));
    line.expect("there is the control").split('\t').map(str::to_owned).collect()
}

#[test]
fn rows_are_those_of_the_step() {
    let mut page = Page::default();
    let size = Size::new(64, 36).expect("a size");
    for (index, program) in PROGRAMS.iter().enumerate() {
        text(&mut page, &format!("open {}", index + 1));
        let step = (program.make)();
        let camera = step.view().camera(size.aspect());
        let picture = Frame { step: &*step, camera: &*camera, size, samples: 1 }.render();
        let top = page.answer(b"rows now 64 36 0 20").expect("rows");
        let bottom = page.answer(b"rows now 64 36 20 16").expect("rows");
        assert!([top, bottom].concat() == *picture.as_raw(), "{}", program.name);
    }
}

#[test]
fn the_step_before_has_the_same_changes() {
    let mut page = Page::default();
    text(&mut page, "open 6");
    text(&mut page, "set radius 0.5");
    text(&mut page, "orbit 20 -3");
    let rows = "64 36 0 36";
    let before = page.answer(format!("rows before {rows}").as_bytes()).expect("rows");
    text(&mut page, "step 5");
    assert!(page.answer(format!("rows now {rows}").as_bytes()) == Ok(before));
    assert!(text(&mut page, "state").contains("change\tradius=0.5"));
}

#[test]
fn a_handle_follows_the_hand() {
    let mut page = Page::default();
    text(&mut page, "open 3");
    let places = (0..96).flat_map(|x| (0..54).map(move |y| (10 * x, 10 * y)));
    let mut grab = |(x, y)| text(&mut page, &format!("grab 960 540 {x} {y} 8"));
    let at = places.clone().find(|place| grab(*place) == "0").expect("a corner is seen");
    let (u, v) = (at.0 as f32 / 960.0 - 0.1, 1.0 - at.1 as f32 / 540.0);
    text(&mut page, &format!("drag 960 540 0 {u} {v}"));
    assert_eq!(text(&mut page, &format!("grab 960 540 {} {} 8", at.0 - 96, at.1)), "0");
    assert_eq!(setting(&mut page, "a.x").last().map(String::as_str), Some("1"));
    text(&mut page, "reset");
    assert_eq!(setting(&mut page, "a.x").last().map(String::as_str), Some("0"));
}

#[test]
fn what_is_drawn_over_a_picture_changes_only_it() {
    let mut page = Page::default();
    text(&mut page, "open 7");
    let rgb = page.answer(b"rows now 240 135 0 135").expect("rows");
    let mut show = |marks: &str| {
        let command = format!("show now 240 135 240 135 11 {marks}\n");
        page.answer(&[command.as_bytes(), &rgb].concat()).expect("a picture")
    };
    let plain = show("- 1 0");
    assert!(plain.chunks_exact(4).flat_map(|pixel| &pixel[..3]).eq(&rgb));
    assert!(plain.iter().skip(3).step_by(4).all(|alpha| *alpha == 255));
    assert!(show("110,60 0 0") == plain);
    assert!(show("110,60 1 0") != plain);
    assert!(show("- 0 1") != plain);
}

#[test]
fn from_outside_the_camera_itself_stays() {
    let mut page = Page::default();
    text(&mut page, "open 4");
    let inside = page.answer(b"rows now 64 36 0 36").expect("rows");
    text(&mut page, "outside on");
    let outside = page.answer(b"rows now 64 36 0 36").expect("rows");
    text(&mut page, "orbit 30 0");
    let turned = page.answer(b"rows now 64 36 0 36").expect("rows");
    assert!(inside != outside && outside != turned);
    assert!(text(&mut page, "state").contains("change\toutside.azimuth="));
    assert_eq!(setting(&mut page, "azimuth").last().map(String::as_str), Some("0"));
    text(&mut page, "outside off");
    assert!(page.answer(b"rows now 64 36 0 36") == Ok(inside));
}

#[test]
fn what_cannot_be_done_is_said_and_changes_nothing() {
    let beyond = format!("open {}", PROGRAMS.len() + 1);
    let mut page = Page::default();
    text(&mut page, "open 7");
    text(&mut page, "set p 10");
    let state = text(&mut page, "state");
    for command in [
        "",
        " ",
        "nothing",
        "open",
        "open 0",
        &beyond,
        "open -1",
        "open 99999999999999999999",
        "step x",
        "set p",
        "set p NaN",
        "set nothing 1",
        "set outside.nothing 1",
        "orbit NaN 1",
        "orbit 1",
        "zoom inf",
        "rows",
        "rows never 9 9 0 1",
        "rows now 0 9 0 1",
        "rows now 99999 99999 0 1",
        "rows now 9 9 9 1",
        "rows now 9 9 1 18446744073709551615",
        "explain 9 9 9,0",
        "explain 9 9 -1,0",
        "explain 9 9 1e9",
        "grab 9 9 NaN 1 1",
        "drag 9 9 99 0 0",
        "drag 9 9 0 NaN 0",
        "show now 9 9 9 9 8 - 0 0",
        "show now 9 9 9 9 NaN - 0 0\n",
        "show now 9 9 9 9 8 9,9 1 0\nabc",
    ] {
        let answer = page.answer(command.as_bytes());
        let error = answer.expect_err(command);
        assert!(!error.is_empty() && !error.contains('\n'), "{command}: {error}");
    }
    assert!(page.answer(b"set p \xff").is_err());
    assert_eq!(text(&mut page, "state"), state);
    assert!(page.answer(b"rows before 9 9 0 9").is_ok());
    text(&mut page, "open 1");
    assert!(page.answer(b"rows before 9 9 0 9").is_err());
}

#[test]
fn answers_are_in_the_language_that_was_asked_for() {
    let mut page = Page::default();
    text(&mut page, "open 6");
    let mut told = |locale: &str| {
        text(&mut page, &format!("language {locale}"));
        let wrong = page.answer(b"set epsilon x").expect_err("it is no number");
        [text(&mut page, "explain 960 540 240,420"), text(&mut page, "state"), wrong].concat()
    };
    let (english, portuguese) = (told("en"), told("pt-BR"));
    for (own, other, words) in [
        (&english, &portuguese, ["\tviewing ray\n", "\tno root: ", "\tcamera\t-1.6", "cannot be"]),
        (
            &portuguese,
            &english,
            ["\traio de visão\n", "\tsem raiz: ", "\tcâmera\t-1.6", "não pode ser"],
        ),
    ] {
        for word in words {
            assert!(own.contains(word) && !other.contains(word), "{word}: {own}");
        }
    }
    assert_eq!(told("en"), english);
}

#[test]
fn a_figure_is_changed_alone() {
    let mut page = Page::default();
    text(&mut page, "open 2");
    let state = text(&mut page, "state");
    let figure = text(&mut page, "figure both_roots state");
    assert!(figure.starts_with("size\t960\t") && figure.contains("setting\tpanel\t"), "{figure}");
    let before = page.answer(b"rows both_roots 64 36 0 36").expect("rows");
    text(&mut page, "figure both_roots set radius 0.5");
    assert!(page.answer(b"rows both_roots 64 36 0 36").expect("rows") != before);
    assert!(text(&mut page, "figure both_roots state").contains("change\tradius=0.5\n"));
    assert_eq!(text(&mut page, "state"), state);
    text(&mut page, "figure both_roots reset");
    assert_eq!(text(&mut page, "figure both_roots state"), figure);
    for command in [
        "figure",
        "figure none state",
        "figure both_roots",
        "figure both_roots open 1",
        "rows rays 9 9 0 9",
    ] {
        assert!(page.answer(command.as_bytes()).is_err(), "{command}");
    }
}
