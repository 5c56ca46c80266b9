//! What a class reads of a pinned pixel at once, without scrolling.

use tests::prelude::*;

/// What is read of the pixel at `at` in a window of this size.
fn read(steps: Vec<Program>, index: usize, window: Size, at: (f32, f32)) -> Vec<String> {
    Language::ENGLISH.speak();
    let mut session = Session::new(Desk::new(steps, index));
    session.handle(Event::Resize(window));
    let Area { left, top, width, height } = session.picture_area();
    let (x, y) = (left + at.0 * width, top + at.1 * height);
    session.handle(Event::Press(x, y));
    session.handle(Event::Release(x, y));
    session.read_at_once()
}

#[test]
fn what_a_step_is_about_is_read_without_scrolling() {
    // The red sphere, before a floor and, once, the pyramid.
    let middle = (0.48, 0.46);
    let about: [(f32, f32, &[&str]); 6] = [
        (0.5, 0.46, &["√𝐷", "𝑡", "𝑡_1=−𝑏−√𝐷/𝑎"]),
        (0.5, 0.46, &["𝛽", "𝛾", "𝑡", "𝛼", "𝛼=1−𝛽−𝛾", "𝛽=|𝐚−𝐩𝐚−𝐜𝐝|/𝐷"]),
        (middle.0, middle.1, &["𝑡^∗"]),
        (middle.0, middle.1, &["𝐧·𝐥", "𝐿_𝑑"]),
        (middle.0, middle.1, &["𝑉", "𝐿"]),
        (middle.0, middle.1, &["𝐡=𝐯+𝐥/‖𝐯+𝐥‖", "𝐧·𝐡", "𝐿_𝑠=𝑘_𝑠𝐼/𝑟^2max(0,𝐧·𝐡)^𝑝"]),
    ];
    for (index, (across, down, expected)) in (1..).zip(about) {
        for window in [size(1280, 720), size(1920, 1080)] {
            let own = programs().swap_remove(index);
            for (steps, index) in [(programs(), index), (vec![own], 0)] {
                let alone = steps.len() == 1;
                let name = steps[index].name;
                let read = read(steps, index, window, (across, down));
                for symbol in expected {
                    let there = read.iter().any(|key| key == symbol);
                    assert!(there, "{name}, {window}, alone {alone}: {symbol} in {read:#?}");
                }
            }
        }
    }
}

#[test]
fn all_hits_are_read_without_scrolling_and_misses_are_one_line() {
    let setup = setup(3);
    // Through the pyramid's front and back to the floor.
    let (at, pixel) = ((0.72, 0.5), (691, 270));
    let told = explained(&setup, pixel, Size::DEFAULT);
    let objects = told.scope("intersection").expect("it is told").scopes();
    let hits: Vec<f32> = objects
        .filter_map(|object| match object.outcome {
            Outcome::Closest(t) | Outcome::Farther(t) => Some(t),
            _ => None,
        })
        .collect();
    assert!(hits.len() >= 2, "{hits:?}");
    let read = read(programs(), 3, size(1280, 720), at);
    for t in hits {
        let [t] = &rounded(&Value::Number(t))[..] else { panic!("a number") };
        let is_told =
            |row: &&String| row.contains(&format!("=𝑡={t}")) || row.contains(&format!("𝑡={t}"));
        assert_eq!(read.iter().filter(is_told).count(), 1, "{t}: {read:#?}");
    }
    assert_eq!(read.iter().filter(|row| row.contains("missed: ")).count(), 1, "{read:#?}");
}

#[test]
fn keys_walk_down_the_panel_and_unfold_what_they_come_to() {
    Language::ENGLISH.speak();
    let mut session = Session::new(Desk::new(programs(), 6));
    session.handle(Event::Resize(size(1280, 720)));
    click(&mut session, (0.48, 0.46));
    let chosen = |session: &Session| session.desk().line().cloned().expect("a line");
    let mut walked = Vec::new();
    loop {
        key(&mut session, Key::Char('J'));
        let line = chosen(&session);
        if walked.contains(&line) {
            break;
        }
        let told = session.desk().explanation().expect("it is pinned");
        let told = told.last_told(&line).map(|line| typeset(line).key()).expect("a told line");
        let read = session.read_at_once();
        assert!(read.contains(&told), "{line:?} is not seen: {read:#?}");
        walked.push(line);
    }
    // What is new comes first, and what a light has from before after it, folded or not.
    assert_eq!(walked[0].equation, "h = (v + l) / ‖v + l‖");
    let place = |equation: &str| walked.iter().position(|line| line.equation == equation);
    assert!(place("L_s = k_s (I/r²) max(0, n·h)^p") < place("V"), "{walked:?}");
    assert!(place("V") < place("t_max = t") && place("t_max = t") < place("d"), "{walked:?}");
    key(&mut session, Key::Char('K'));
    assert_eq!(Some(chosen(&session)), walked.last().cloned());
}

#[test]
fn a_pixel_without_what_the_step_adds_says_so_and_opens_a_light() {
    // The floor, which is matte.
    let read = read(programs(), 6, size(1280, 720), (0.3, 0.9));
    assert!(read.iter().any(|row| row.contains("not computed")), "{read:#?}");
    assert!(!read.iter().any(|row| row == "𝐡"), "{read:#?}");
    let light = read.iter().find(|row| row.starts_with("1 · key light")).expect("a light");
    assert_eq!(light, "1 · key light", "it is open");
}

#[test]
fn each_equation_of_the_slides_is_in_its_step() {
    for language in Language::all() {
        language.speak();
        let all = programs();
        for (index, equation) in DECK {
            let Program { name, idea, texts, .. } = &all[index];
            let idea = texts.get(Language::spoken().place()).map_or(*idea, |[_, idea, _]| idea);
            let told = idea.lines().filter_map(|line| line.strip_prefix("  "));
            let key = latex(equation).key();
            let is_told = told.map(|line| latex(line).key()).any(|told| told.contains(&key));
            assert!(is_told, "{name} has no {equation}: {idea}");
        }
    }
    Language::ENGLISH.speak();
}

#[test]
fn each_letter_of_an_equation_is_in_its_font_and_no_command_is_left() {
    let mut keys = BTreeSet::new();
    for program in PROGRAMS {
        for handout in program.handouts {
            let blocks = handout.split("$$").skip(1).step_by(2);
            keys.extend(blocks.flat_map(|block| block.split(r"\qquad")).map(|it| latex(it).key()));
        }
    }
    for (index, language) in
        (0..STEPS.len()).flat_map(|index| Language::all().map(move |it| (index, it)))
    {
        language.speak();
        let setup = setup(index);
        for pixel in pixels(24, 14) {
            let told = setup.step().explain(&*setup.view().camera(24.0 / 14.0), pixel);
            keys.extend(told.lines().map(|line| typeset(line).key()));
        }
    }
    Language::ENGLISH.speak();
    assert!(keys.len() > 60, "{keys:?}");
    for key in keys {
        assert!(!key.contains('\\'), "{key}");
        assert!(key.chars().all(MathFont::has), "{key}");
        let sides = ["(", ")", "[", "]", "‖"].map(|side| key.matches(side).count());
        let [open, close, left, right, bars] = sides;
        assert!(open == close && left == right && bars % 2 == 0, "{key}");
    }
}
