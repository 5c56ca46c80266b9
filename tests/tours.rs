//! The way of a class through the slides: its text, its stops, and what a hand changes there.

use std::iter;

use tests::prelude::*;

/// The titles of the deck's slides in their order, those that follow each other under one title once.
const SLIDES: &str = "\
    Projeção; Duas abordagens; Ray tracing; Algoritmo de ray tracing; Geração de raios - \
    paralela; Geração de raios - perspectiva; Interface para as câmeras; Mapeamento; \
    Intersecções; Raios; Intersecção entre raio e esfera; Intersecção entre raio e \
    triângulo; Ponto pertencente à triângulo; Coordenadas baricêntricas; Intersecção entre \
    raio e triângulo; Intersecção de raios em software; Imagen resultante até o momento; \
    Intersecção de raios em software; Imagen obtida até o momento; Tonalização; Aproximação \
    por raio; Princípio de Huygens; Comportamentos dos raios; Reflexão; Reflexão difusa; \
    Atenuação por distância; Reflexão Lambertiana; Tonalização difusa; Resultado esperado; \
    Imagen obtida até o momento; Sombras; Imagen obtida até o momento; Múltiplas luzes; \
    Imagen obtida até o momento; Reflexão especular; Modelo Blinn-Phong; Modelo \
    Phong/Blinn-Phong; Tonalização especular; Tonalização difusa + especular; Illuminação \
    ambiente; Somando as contribuições; Tarefa";

fn own() -> Vec<Tour> {
    let suite = lecture::suite();
    let read = |(name, text): &(&str, &str)| {
        let (tour, mistakes) = suite.tour(text);
        none(mistakes.iter().map(|mistake| format!("{name}:{mistake}")).collect());
        tour
    };
    suite.tours.iter().map(read).collect()
}

/// A desk with the steps, the figures and the tour in this text, at its first stop.
fn class(text: &str) -> Desk {
    Language::ENGLISH.speak();
    let suite = lecture::suite();
    let (tour, mistakes) = suite.tour(text);
    assert_eq!(mistakes, [], "{text}");
    let desk = Desk::new([suite.programs, suite.figures].concat(), 0);
    after(desk.touring(vec![tour]), &[Act::Stop(1)])
}

const THREE: &str = "# Three

## Raios

`cargo run -p step06_shadows -- --set fill.I=0 --pixel 387,289`

First.

> Why?
>
> So.

## Sombras: from above

`cargo run -p step06_shadows -- --set fill.I=5 --set elevation=60`

Second.

## Tarefa

`cargo run -p step05_diffuse --example lambert_cube -- --set angle=30`

Third.
";

#[test]
fn both_tours_have_the_same_stops_and_one_for_each_slide() {
    let [english, portuguese] = &own()[..] else { panic!("a tour in each language") };
    let of = |tour: &Tour| -> Vec<(String, String, bool)> {
        let stops = tour.stops.iter().cloned();
        stops.map(|stop| (stop.slide, stop.address, stop.question.is_empty())).collect()
    };
    assert_eq!(of(english), of(portuguese));
    let mut slides: Vec<&str> = english.stops.iter().map(|stop| &*stop.slide).collect();
    slides.dedup();
    assert_eq!(slides, SLIDES.split("; ").collect::<Vec<_>>());
}

#[test]
fn each_stop_draws_something_else_than_its_neighbour() {
    let suite = lecture::suite();
    let desk = || Desk::new([&suite.programs[..], &suite.figures].concat(), 0);
    let tour = own().swap_remove(0);
    let drawn = |number| {
        let mut desk = after(desk().touring(vec![tour.clone()]), &[Act::Stop(number)]);
        let (width, height) = (desk.picture_size().width(), desk.picture_size().height());
        act(&mut desk, Act::Size(size(width / 3, height / 3)));
        picture_shown(desk)
    };
    let pictures: Vec<RgbImage> = (1..=tour.stops.len()).map(drawn).collect();
    let mut wrong = Vec::new();
    for (number, picture) in (1..).zip(&pictures) {
        let first = picture.get_pixel(0, 0);
        if picture.pixels().all(|pixel| pixel == first) {
            wrong.push(format!("stop {number} is empty"));
        }
        if pictures.get(number) == Some(picture) {
            wrong.push(format!("stop {number} is the next one too"));
        }
    }
    none(wrong);
}

#[test]
fn a_broken_tour_is_told_line_by_line_and_the_rest_works() {
    Language::ENGLISH.speak();
    let suite = lecture::suite();
    let stop = |command: &str| format!("# T\n\n## S\n\n`{command}`\n\nSaid.\n");
    let run = |flags: &str| stop(&format!("cargo run -p step06_shadows -- {flags}"));
    let whole = stop("cargo run -p step04_scene");
    let with = |rest: &str| format!("{whole}{rest}");
    let long = "a".repeat(LONGEST + 1);
    let table = [
        (String::new(), 1, "a tour begins with its title"),
        ("# T\n".to_owned(), 1, "a tour has stops"),
        (whole.replace("# T\n", "\n"), 1, "# Title"),
        (with("\n# U\n"), 9, "one title: a stop begins with ##"),
        (with("\n### U\n"), 9, "has no headings in it"),
        (with("\n##\n\n`cargo run -p step02_sphere`\n\nSaid.\n"), 9, "as its slide"),
        ("# T\n\nHello.\n".to_owned(), 3, "above it stands ## Slide"),
        ("# T\n\n`cargo run -p step02_sphere`\n".to_owned(), 3, "above it stands ## Slide"),
        ("# T\n\n## S\n\nSaid.\n".to_owned(), 3, "no command"),
        ("# T\n\n## S\n\n`cargo run -p step02_sphere`\n".to_owned(), 3, "says nothing"),
        (with("\n`cargo run -p step02_sphere`\n"), 9, "a second one"),
        (stop("make step02"), 5, "cargo run -p STEP -- FLAGS"),
        (stop("cargo run step02_sphere"), 5, "cargo run -p STEP -- FLAGS"),
        (stop("cargo run -p"), 5, "cargo run -p STEP -- FLAGS"),
        (stop("cargo run -p step99_none"), 5, "no step or figure 'step99_none'"),
        (stop("cargo run -p step05_diffuse --example cube"), 5, "no step or figure 'cube'"),
        (run("--show 'n·l"), 5, "quotation mark"),
        (run("--pixels 1,1"), 5, "--pixels"),
        (run("--pixel 1"), 5, "a pixel is X,Y"),
        (run("--pixel 9999,1"), 5, "there is no pixel 9999,1"),
        (run("--set k_z=1"), 5, "k_z"),
        (run("--set fill.I=x"), 5, "'x'"),
        (run("--show nothing"), 5, "nothing"),
        (run("--check step05_diffuse"), 5, "--check"),
        (run("--language pt"), 5, "cannot have --language"),
        (run("--help"), 5, "--help"),
        (stop("cargo run -p lecture -- --stop 1"), 5, "cannot have --stop"),
        (stop("cargo run -p lecture -- --step 9"), 5, "1 to 7"),
        (whole.replace("`", "\n```\n").replace(" -p", "\n-p"), 6, "one line"),
        (with(&format!("\n{long}\n")), 3, "at most 240"),
        (with("\n> Why?\n"), 3, "no answer"),
        (with("\n> Why?\n>\n> So.\n\n- one\n"), 13, "headings, commands, sentences"),
        (with("\n> Why?\n>\n> So.\n\nMore.\n\n> How?\n>\n> So.\n"), 15, "a second one"),
    ];
    let mut wrong = Vec::new();
    for (text, line, part) in &table {
        let (_, mistakes) = suite.tour(text);
        let is_it = |mistake: &Mistake| mistake.line == *line && mistake.what.contains(part);
        if !mistakes.iter().any(is_it) {
            wrong.push(format!("{text}\n{line}, {part}: {mistakes:?}"));
        }
        // What is right is there all the same.
        let more = THREE.replace("# Three\n", "");
        let (tour, _) = suite.tour(&format!("{text}\n{more}"));
        let last = tour.stops.iter().rev().take(3).map(|stop| &*stop.text);
        if !last.eq(["Third.", "Second.", "First."]) {
            wrong.push(format!("{text}\n…: {:?}", tour.stops));
        }
    }
    none(wrong);
}

/// What the desk says of an act.
fn said(desk: &mut Desk, one: Act) -> String {
    let says = |effect| if let Effect::Say(words) = effect { Some(words) } else { None };
    act(desk, one).into_iter().find_map(says).unwrap_or_default()
}

#[test]
fn what_is_changed_at_a_stop_stays_until_the_next() {
    let mut desk = class(THREE);
    let first = seen(&desk);
    assert_eq!((address(&desk).as_str(), desk.is_changed()), ("#stop1", false));
    for one in [Act::Next, Act::Next] {
        act(&mut desk, one);
    }
    assert_eq!((desk.program().name, desk.stop().map(|stop| stop.0)), ("lambert_cube", Some(3)));
    assert_eq!(said(&mut desk, Act::Next), "this is the last stop");
    act(&mut desk, Act::Stop(1));
    assert_eq!(said(&mut desk, Act::Previous), "this is the first stop");
    let changes =
        [set("key.I", "1"), Act::Unpin, Act::Outside, Act::Step(4), Act::Orbit(20.0, 0.0)];
    for change in changes {
        act(&mut desk, change.clone());
        assert!(desk.is_changed(), "{change:?}");
        // In an address there is both: what is shown, and where in the class that is.
        let mut opened = class(THREE);
        act(&mut opened, Act::Open(address(&desk)));
        assert!(seen(&opened) == seen(&desk) && opened.is_changed(), "{change:?}");
        assert_eq!(opened.stop(), desk.stop(), "{change:?}");
        act(&mut desk, Act::ResetAll);
        act(&mut desk, Act::Glide(1.0));
        assert!(seen(&desk) == first && !desk.is_changed(), "{change:?}");
    }
    for acts in [[Act::Next, Act::Previous], [Act::Listed(1), Act::Listed(0)]] {
        act(&mut desk, set("key.I", "1"));
        acts.into_iter().for_each(|one| drop(act(&mut desk, one)));
        act(&mut desk, Act::Glide(1.0));
        assert!(seen(&desk) == first, "as it is written");
    }
}

fn seen(desk: &Desk) -> (String, Vec<RgbImage>) {
    (desk.command(), pictures_of(desk, size(24, 14)))
}

#[test]
fn the_list_leads_to_every_stop_and_figure() {
    let mut desk = class(THREE);
    let figures = lecture::suite().figures.len();
    assert_eq!(desk.listed().len(), 3 + figures);
    act(&mut desk, Act::Read(Reading::Stops));
    for (key, picked) in [
        (Key::Down, 1),
        (Key::PageDown, 11),
        (Key::Up, 10),
        (Key::PageUp, 0),
        (Key::Up, 0),
        (Key::PageDown, 10),
    ] {
        let Some(Does::Act(pick)) = desk.does(key) else { panic!("{key:?}") };
        act(&mut desk, pick);
        assert_eq!(desk.picked(), picked, "{key:?}");
    }
    let Some(Does::Act(go)) = desk.does(Key::Enter) else { panic!("Enter goes there") };
    act(&mut desk, go);
    let (name, at) = (desk.program().name, desk.stop().map(|(number, _)| number));
    assert_eq!((name, at, desk.reading()), (FIGURES[7].0, Some(1), Reading::Pixel));
    // A figure is a stop's neighbour: its pixels are told, and the class goes on from where it was.
    act(&mut desk, Act::Pin((0.25, 0.5)));
    assert!(desk.explanation().is_some() && desk.is_changed());
    assert!(act(&mut desk, Act::Step(3)).contains(&Effect::Redraw));
    assert_eq!((desk.program().name, desk.picture_size()), (STEPS[2], Size::DEFAULT));
    act(&mut desk, Act::Next);
    assert_eq!(desk.stop().map(|(number, _)| number), Some(2));
}

#[test]
fn a_question_is_asked_then_answered_and_a_black_screen_shows_nothing() {
    let mut session = window(class(THREE));
    let mut asked = Vec::new();
    for _ in 0..3 {
        typed(&mut session, "R");
        asked.push(session.desk().asked());
    }
    assert_eq!(asked, [Asked::Question, Asked::Answer, Asked::Nothing]);
    for blank in ["B", "."] {
        typed(&mut session, blank);
        let black = painted(&mut session, Size::DEFAULT, "");
        assert!(black.pixels().all(|pixel| pixel.0 == [0; 3]), "{blank}");
        let before = address(session.desk());
        // The next key brings it back, and does no more, unless it goes on.
        for (pressed, same) in [(Key::Char('O'), true), (Key::Up, true), (Key::PageDown, false)] {
            key(&mut session, pressed);
            let now = (session.desk().is_blank(), address(session.desk()) == before);
            assert_eq!(now, (false, same), "{blank}, {pressed:?}");
            typed(&mut session, if same { blank } else { "" });
        }
        key(&mut session, Key::PageUp);
    }
    typed(&mut session, "Y");
    assert!(session.note().is_some_and(|note| note.contains("does nothing here")));
    let mut alone = Session::new(after(desk(5, Size::DEFAULT), &[]));
    key(&mut alone, Key::PageDown);
    assert!(alone.note().is_some_and(|note| note.contains("cargo run -p lecture")));
}

#[test]
fn what_is_said_lies_below_the_picture_whole() {
    let long = format!("{}.", "every word is read ".repeat(12).trim());
    assert!(long.len() > LONGEST - 20, "as long as a text may be");
    let text = THREE.replace("First.", &long);
    for (width, height) in [(1280, 720), (1920, 1080), (960, 540), (700, 900)] {
        let mut session = window(class(&text));
        let told = painted(&mut session, size(width, height), "");
        let area = session.picture_area();
        let mut other = window(class(&text.replace(long.trim_end_matches("read."), "nothing ")));
        let without = painted(&mut other, size(width, height), "");
        assert_eq!(other.picture_area(), area, "it jumps for no text");
        let pairs = told.enumerate_pixels().zip(without.enumerate_pixels());
        let rows: Vec<u32> = pairs.filter(|(a, b)| a.2 != b.2).map(|(a, _)| a.1).collect();
        let (least, most) = (rows.iter().min().copied(), rows.iter().max().copied());
        assert!(least.is_some_and(|row| row as f32 >= area.bottom()), "{width}: below it");
        assert!(most.is_some_and(|row| (row as usize) < height - 2), "{width}: nothing is cut off");
    }
}

#[test]
fn stops_of_one_scene_glide_and_others_jump() {
    let mut desk = class(THREE);
    let near = "## N\n\n`cargo run -p step06_shadows -- --set elevation=60`\n\nNear.\n";
    let far = "## F\n\n`cargo run -p step06_shadows -- --camera parallel`\n\nFar.\n";
    let mut scene =
        class(&format!("# T\n\n## A\n\n`cargo run -p step06_shadows`\n\nA.\n\n{near}\n{far}"));
    let shown = |desk: &Desk| pictures_of(desk, size(24, 14));
    let start = shown(&scene);
    assert!(act(&mut scene, Act::Next).contains(&Effect::Glide));
    assert_eq!(shown(&scene), start, "it begins where it was");
    let mut seen = vec![start];
    for part in [0.3, 0.7, 1.0] {
        act(&mut scene, Act::Glide(part));
        assert!(!seen.contains(&shown(&scene)), "{part}");
        seen.push(shown(&scene));
    }
    assert!(!scene.is_gliding() && act(&mut scene, Act::Glide(0.5)).is_empty());
    act(&mut scene, Act::Previous);
    // Whoever does something at once does it to what is there.
    act(&mut scene, set("fov", "20"));
    assert!(!scene.is_gliding() && scene.is_changed());
    for jump in [Act::Stop(2), Act::Stop(3)] {
        act(&mut scene, Act::Stop(3));
        act(&mut scene, Act::Glide(1.0));
        assert!(
            !act(&mut scene, jump).contains(&Effect::Glide),
            "nothing does, or the camera jumps"
        );
        assert!(!scene.is_gliding());
    }
    act(&mut desk, Act::Stop(3));
    assert!(!act(&mut desk, Act::Stop(2)).contains(&Effect::Glide), "a figure is no scene");
}

#[test]
fn the_command_line_gives_a_class_of_ones_own() {
    let folder = tempdir().expect("a folder");
    let broken = format!("{THREE}\n## Bad\n\n`cargo run -p step08`\n\nLost.\n\n{}", &THREE[9..30]);
    for (name, text) in [("good.md", THREE), ("broken.md", &broken), ("empty.md", "# T\n")] {
        fs::write(folder.path().join(name), text).expect("it is written");
    }
    let twice =
        THREE.replace("--set fill.I=5 --set elevation=60", "--set fill.I=0 --pixel 387,289");
    fs::write(folder.path().join("twice.md"), twice).expect("it is written");
    let ran = |arguments: &str| {
        let words: Vec<&str> = arguments.split_whitespace().collect();
        let output = command("lecture", folder.path()).args(words).output().expect("it runs");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
        (output.status.code(), text(output.stdout), text(output.stderr))
    };
    let checked = ran("--tour good.md --check-tour");
    assert_eq!(checked, (Some(0), "Three: 3 stops looked at\n".to_owned(), String::new()));
    let (code, found, _) = ran("--tour twice.md --check-tour");
    assert_eq!(code, Some(1));
    assert!(found.starts_with("2 Sombras: the picture is that of the stop before\n"), "{found}");
    let printed = ran("--tour good.md --handout three.html");
    let page = fs::read_to_string(folder.path().join("three.html")).expect("a page");
    let count = |part: &str| page.matches(part).count();
    assert_eq!(
        (printed.0, count("<section>"), count("data:image/jpeg;base64,/9j/")),
        (Some(0), 3, 3)
    );
    let (code, _, told) = ran("--tour broken.md --stop 2 -o second.png");
    assert_eq!(code, Some(0), "{told}");
    assert!(told.contains("broken.md:27: there is no step or figure 'step08'"), "{told}");
    let expected = after(class(THREE), &[Act::Stop(2)]);
    let found = image::open(folder.path().join("second.png")).expect("a picture").into_rgb8();
    assert!(found == picture_shown(expected));
    for (arguments, part) in [
        ("--tour empty.md --stop 1", "no stop of empty.md can be shown"),
        ("--tour missing.md --stop 1", "cannot read missing.md"),
        ("--tour good.md --stop 4 -o a.png", "there is no stop 4: they go from 1 to 3"),
        ("--stop 0", "a whole number from 1 on"),
        ("--stop 2 --step 1", "cannot be used with"),
    ] {
        let (code, _, told) = ran(arguments);
        assert!(code.is_some_and(|code| code > 0) && told.contains(part), "{arguments}: {told}");
    }
}

#[test]
fn any_keys_in_any_order_leave_a_class_where_it_can_be_led_on() {
    let keys: Vec<Key> = show::keys().into_iter().flat_map(|row| row.does).map(|it| it.0).collect();
    let mut rng = Rng::with_seed(29);
    for _ in 0..20 {
        let mut session = window(class(THREE));
        let pressed: Vec<Key> =
            iter::repeat_with(|| keys[rng.usize(..keys.len())]).take(40).collect();
        for pressed in &pressed {
            key(&mut session, *pressed);
            session.handle(Event::KeyUp(*pressed));
        }
        let stop = session.desk().stop().map(|stop| stop.0);
        assert!(stop.is_some(), "{pressed:?}");
        typed(&mut session, "B");
        if session.desk().is_blank() {
            typed(&mut session, "B");
        }
        key(&mut session, Key::Home);
        let desk = session.desk();
        assert_eq!((desk.stop().map(|at| at.0), desk.is_changed()), (stop, false), "{pressed:?}");
    }
}
