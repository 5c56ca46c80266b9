//! What a class does, without a display: every key and every action of the mouse.

use image::imageops;
use tests::prelude::*;

const WINDOW: Size = Size::DEFAULT;

fn size(width: usize, height: usize) -> Size {
    Size::new(width, height).expect("a size")
}

fn program(index: usize) -> Program {
    Program::new(STEPS[index], "a concept", size(320, 180), make(index))
}

/// A step's session in a window of its picture's size.
fn session(index: usize) -> Session {
    Session::new(Desk::new(vec![program(index)], 0))
}

/// All steps' session, at the step `index`.
fn lecture(index: usize) -> Session {
    let told = |index| Program { diff: "+a line\n-another", idea: "an idea", ..program(index) };
    let programs = (0..STEPS.len()).map(told).collect();
    Session::new(Desk::new(programs, index))
}

fn key(session: &mut Session, key: Key) -> Vec<Effect> {
    session.handle(Event::Key(key, false))
}

fn keys(session: &mut Session, keys: &[Key]) {
    keys.iter().for_each(|pressed| drop(key(session, *pressed)));
}

/// `session` in a [`WINDOW`].
fn wide(mut session: Session) -> Session {
    session.handle(Event::Resize(WINDOW));
    session
}

/// What `session` paints into a window of `window`.
fn painted(session: &mut Session, window: Size) -> RgbImage {
    session.handle(Event::Resize(window));
    paint(session, window)
}

/// The pictures that `session` wants.
fn rendered(session: &Session) -> Vec<RgbImage> {
    pictures_of(session.desk(), session.shown_size())
}

fn paint(session: &mut Session, window: Size) -> RgbImage {
    let pictures = rendered(session);
    let mut image = RgbImage::new(window.width() as u32, window.height() as u32);
    session.paint(&mut image, &pictures.iter().collect::<Vec<_>>(), "1 ms");
    image
}

fn text(session: &Session, name: &str) -> String {
    let mut list = session.desk().setup().list().into_iter();
    list.find(|setting| setting.name == name).expect("a control").control.text()
}

fn middle(area: Area) -> (f32, f32) {
    (area.left + area.width / 2.0, area.top + area.height / 2.0)
}

fn click(session: &mut Session, (x, y): (f32, f32)) -> Vec<Effect> {
    let mut effects = session.handle(Event::Press(x, y));
    effects.extend(session.handle(Event::Release(x, y)));
    effects
}

fn drag(session: &mut Session, (x, y): (f32, f32), (right, down): (f32, f32)) {
    session.handle(Event::Press(x, y));
    session.handle(Event::Move(right, down));
    session.handle(Event::Release(right, down));
}

fn click_middle(session: &mut Session) -> Vec<Effect> {
    let at = middle(session.picture_area());
    click(session, at)
}

fn printed(effects: &[Effect]) -> Option<&str> {
    effects.iter().find_map(|effect| match effect {
        Effect::Print(text) => Some(&**text),
        _ => None,
    })
}

#[test]
fn arrows_select_and_change() {
    let mut session = session(1);
    assert_eq!(session.selected(), Some("radius"));
    key(&mut session, Key::Down);
    assert_eq!(session.selected(), Some("center.x"));
    let place = |session: &Session| text(session, "center.x").parse::<f32>().expect("a number");
    assert!(key(&mut session, Key::Right).contains(&Effect::Redraw));
    let coarse = place(&session);
    key(&mut session, Key::Left);
    assert!(place(&session).abs() < 1e-5);
    session.handle(Event::Key(Key::Right, true));
    let fine = place(&session);
    assert!(fine > 0.0 && fine < coarse / 5.0, "{fine} {coarse}");
    key(&mut session, Key::Up);
    assert_eq!(session.selected(), Some("radius"));
    // Before the first comes the last: the heading over the camera's.
    key(&mut session, Key::Up);
    assert_eq!(session.selected(), None);
    // It opens to the right and folds to the left, and changes nothing.
    assert!(!key(&mut session, Key::Right).contains(&Effect::Redraw));
    key(&mut session, Key::Down);
    assert_eq!(session.selected(), Some("camera"));
    keys(&mut session, &[Key::Up, Key::Left, Key::Down]);
    assert_eq!(session.selected(), Some("radius"));
}

#[test]
fn every_control_can_be_selected() {
    for (index, name) in STEPS.iter().enumerate() {
        let mut session = session(index);
        let mut seen: Vec<String> = Vec::new();
        // Headings open on the way.
        for _ in 0..120 {
            match session.selected() {
                Some(name) => seen.push(name.to_owned()),
                None => drop(key(&mut session, Key::Right)),
            }
            key(&mut session, Key::Down);
            let mut image = RgbImage::new(320, 180);
            session.paint(&mut image, &[], "");
            let marked = image.pixels().any(|pixel| pixel.0 == [43, 49, 61]);
            assert!(marked, "{name}: what is selected is not seen, after {:?}", seen.last());
        }
        for setting in setup(index).list() {
            assert!(seen.contains(&setting.name), "{name}: {}", setting.name);
        }
    }
}

#[test]
fn one_control_is_reset_or_all() {
    for back in [Key::Backspace, Key::Delete] {
        let mut session = session(1);
        keys(&mut session, &[Key::Right, Key::Down, Key::Right]);
        assert_eq!(session.desk().setup().settings().len(), 2);
        assert!(key(&mut session, back).contains(&Effect::Redraw));
        assert_eq!(session.desk().setup().settings().len(), 1);
        assert!(session.desk().setup().settings()[0].starts_with("radius="));
        key(&mut session, Key::Home);
        assert_eq!(session.desk().setup().settings(), Vec::<String>::new());
    }
}

#[test]
fn space_gives_the_picture_the_whole_window() {
    let mut session = session(6);
    let beside = session.picture_area();
    assert!(beside.width < 320.0 && beside.height < 180.0);
    assert!(key(&mut session, Key::Space).contains(&Effect::Redraw));
    assert_eq!(session.picture_area(), Area::new(0.0, 0.0, 320.0, 180.0));
    let window = size(320, 180);
    assert!(painted(&mut session, window) == picture_of(session.desk().setup(), 320, 180));
    // What happens is said there too.
    session.handle(Event::Say("saved".to_owned()));
    assert!(paint(&mut session, window) != picture_of(session.desk().setup(), 320, 180));
    key(&mut session, Key::Space);
    assert_eq!(session.picture_area(), beside);
}

#[test]
fn a_figure_is_first_shown_alone() {
    let program = Program { is_figure: true, ..program(6) };
    let session = Session::new(Desk::new(vec![program], 0));
    assert_eq!(session.picture_area(), Area::new(0.0, 0.0, 320.0, 180.0));
    assert_eq!(session.desk().command(), "cargo run --example step07_specular");
}

#[test]
fn a_click_pins_and_escape_unpins() {
    let mut session = session(6);
    let area = session.picture_area();
    let effects = click(&mut session, middle(area));
    let pixel = Pixel { col: 160, row: 90, width: 320, height: 180 };
    assert_eq!(session.desk().pinned(), Some(pixel));
    let view = session.desk().setup().view().camera(320.0 / 180.0);
    let expected: Explanation = session.desk().setup().step().explain(&*view, pixel);
    assert_eq!(session.desk().explanation(), Some(expected.clone()));
    assert_eq!(printed(&effects), Some(&*written(&expected)));
    assert!(session.note().expect("a note").contains("(160, 90)"));
    // It follows what is changed, and is printed once.
    key(&mut session, Key::Down);
    let effects = key(&mut session, Key::Right);
    assert_eq!(printed(&effects), None);
    assert!(session.desk().explanation() != Some(expected));
    assert!(!key(&mut session, Key::Escape).contains(&Effect::Quit));
    assert_eq!(session.desk().pinned(), None);
    assert!(key(&mut session, Key::Escape).contains(&Effect::Quit));
}

#[test]
fn a_key_pins_the_pixel_under_the_pointer() {
    for pin in [Key::Enter, Key::Char('P')] {
        let mut session = session(6);
        assert_eq!(printed(&key(&mut session, pin)), None);
        assert!(session.note().is_some() && session.desk().pinned().is_none());
        let (x, y) = middle(session.picture_area());
        session.handle(Event::Move(x, y));
        assert!(printed(&key(&mut session, pin)).is_some());
        assert_eq!(session.desk().pinned().map(|pixel| (pixel.col, pixel.row)), Some((160, 90)));
    }
}

#[test]
fn the_whole_picture_has_its_shape_and_its_pinned_pixel_in_every_window() {
    for pinned in [false, true] {
        let mut session = session(6);
        if pinned {
            click_middle(&mut session);
        }
        let pixel = session.desk().pinned();
        for (width, height) in
            [(960, 540), (1920, 1080), (700, 1100), (1, 1), (120, 2000), (2000, 30), (5000, 3000)]
        {
            painted(&mut session, size(width, height));
            let area = session.picture_area();
            assert!(area.left >= 0.0 && area.right() <= width as f32, "{area:?}");
            assert!(area.top >= 0.0 && area.bottom() <= height as f32, "{area:?}");
            assert!((area.width - area.height * 16.0 / 9.0).abs() <= 2.0, "{area:?}");
            if width * 9 == height * 16 {
                assert!(area.width >= 0.6 * width as f32, "{area:?}");
            }
            assert_eq!(session.desk().pinned(), pixel);
        }
    }
}

#[test]
fn nothing_lies_over_the_picture() {
    for (index, name) in STEPS.iter().enumerate() {
        let mut session = session(index);
        for window in [size(640, 360), size(960, 540), size(400, 700)] {
            let image = painted(&mut session, window);
            let area = session.picture_area();
            let (width, height) = (area.width as u32, area.height as u32);
            let (left, top) = (area.left as u32, area.top as u32);
            let found = imageops::crop_imm(&image, left, top, width, height).to_image();
            assert!(found == rendered(&session)[0], "{name} {window}");
        }
    }
}

#[test]
fn a_drag_orbits_and_the_wheel_zooms() {
    let mut session = session(6);
    let start = session.desk().setup().view().clone();
    let (x, y) = middle(session.picture_area());
    session.handle(Event::Press(x, y));
    // As long as it is a click.
    assert_eq!(session.handle(Event::Move(x + 1.0, y)), []);
    assert!(session.handle(Event::Move(x - 30.0, y + 20.0)).contains(&Effect::Redraw));
    session.handle(Event::Release(x - 30.0, y + 20.0));
    let view = session.desk().setup().view().clone();
    assert!(view.azimuth > start.azimuth && view.elevation > start.elevation);
    assert_eq!(session.desk().pinned(), None);
    session.handle(Event::Wheel(2.0));
    assert!((session.desk().setup().view().distance / view.distance - 0.81).abs() < 1e-4);
    // Once the button is up nothing moves any more.
    assert_eq!(session.handle(Event::Move(x, y)), []);
}

/// Places of a [`WINDOW`] beside the picture, closer together than anything is high.
fn beside(session: &Session) -> Vec<(f32, f32)> {
    let places = (0..540).step_by(6).flat_map(|y| (0..960).step_by(6).map(move |x| (x, y)));
    let places = places.map(|(x, y)| (x as f32, y as f32));
    places.filter(|at| !session.picture_area().contains(*at)).collect()
}

#[test]
fn a_slider_is_dragged_to_its_ends() {
    let mut session = wide(session(1));
    // Found as a hand would: by pressing.
    let found = beside(&session).into_iter().any(|(x, y)| {
        session.handle(Event::Press(x, y));
        let found =
            session.selected() == Some("radius") && !session.desk().setup().settings().is_empty();
        if !found {
            session.handle(Event::Release(x, y));
        }
        found
    });
    assert!(found, "no slider was found");
    session.handle(Event::Move(5000.0, 5000.0));
    assert_eq!(text(&session, "radius"), "2");
    session.handle(Event::Move(-5000.0, 0.0));
    assert_eq!(text(&session, "radius"), "0.1");
    session.handle(Event::Release(-5000.0, 0.0));
    session.handle(Event::Move(5000.0, 0.0));
    assert_eq!(text(&session, "radius"), "0.1");
}

#[test]
fn a_press_on_the_name_of_a_control_selects_it_and_changes_nothing() {
    let mut session = wide(session(1));
    let is_a_name = |at| {
        click(&mut session, at);
        let moved = !session.desk().setup().settings().is_empty();
        let selected = session.selected() == Some("center.x");
        if selected {
            key(&mut session, Key::Up);
        }
        key(&mut session, Key::Home);
        selected && !moved
    };
    assert!(beside(&wide(crate::session(1))).into_iter().any(is_a_name));
}

#[test]
fn what_is_left_for_another_window_is_let_go() {
    let mut session = session(6);
    let (x, y) = middle(session.picture_area());
    session.handle(Event::Press(x, y));
    session.handle(Event::FocusLost);
    assert_eq!(session.handle(Event::Move(x + 50.0, y)), []);
    session.handle(Event::Release(x + 50.0, y));
    assert_eq!(session.desk().pinned(), None);
    let mut session = lecture(6);
    key(&mut session, Key::Tab);
    session.handle(Event::FocusLost);
    assert_eq!(session.desk().pictures()[0].program, 6, "Tab was let go elsewhere");
}

#[test]
fn the_wheel_beside_the_picture_scrolls() {
    let mut session = wide(session(6));
    click_middle(&mut session);
    let distance = session.desk().setup().view().distance;
    let before = paint(&mut session, WINDOW);
    session.handle(Event::Move(900.0, 200.0));
    session.handle(Event::Wheel(-3.0));
    let after = paint(&mut session, WINDOW);
    assert_eq!(session.desk().setup().view().distance, distance);
    let bar = |image: &RgbImage| {
        (0..540).filter(|row| image.get_pixel(956, *row).0 == [128, 140, 160]).min()
    };
    assert!(bar(&before).is_some() && bar(&before) < bar(&after), "the scroll bar goes down");
    // Back to the top, and not beyond.
    session.handle(Event::Wheel(50.0));
    assert!(paint(&mut session, WINDOW) == before);
    let mut unpinned = wide(crate::session(6));
    unpinned.handle(Event::Move(900.0, 200.0));
    unpinned.handle(Event::Wheel(-3.0));
    assert_eq!(unpinned.desk().setup().view().distance, distance);
}

#[test]
fn a_click_on_a_heading_folds() {
    let mut session = wide(session(6));
    click_middle(&mut session);
    key(&mut session, Key::Down);
    let open = paint(&mut session, WINDOW);
    // The first row of the explanation is the pixel, the second the section.
    let em = 0.0385 * 540.0;
    let heading = (session.picture_area().right() + 100.0, 2.8 * em);
    click(&mut session, heading);
    let folded = paint(&mut session, WINDOW);
    assert!(open != folded);
    click(&mut session, heading);
    assert!(paint(&mut session, WINDOW) == open);
}

#[test]
fn letters_grow_and_shrink() {
    let mut session = wide(session(6));
    let usual = session.picture_area().width;
    assert!(key(&mut session, Key::Char('+')).contains(&Effect::Redraw));
    assert!(session.picture_area().width < usual);
    key(&mut session, Key::Char('-'));
    assert_eq!(session.picture_area().width, usual);
    // Larger than the window, and smaller than a pixel.
    for (by, times) in [('+', 40), ('-', 80)] {
        (0..times).for_each(|_| drop(key(&mut session, Key::Char(by))));
        for window in [WINDOW, size(60, 40), size(1, 1)] {
            painted(&mut session, window);
        }
    }
}

#[test]
fn f1_lists_the_keys_and_f2_saves() {
    let mut session = session(6);
    let before = painted(&mut session, WINDOW);
    // While the picture is alone they are asked for, not left.
    for before_it in [&[][..], &[Key::Space], &[Key::F(1), Key::Space]] {
        keys(&mut session, before_it);
        key(&mut session, Key::F(1));
        assert!(paint(&mut session, WINDOW) != before && session.picture_area().width < 960.0);
        key(&mut session, Key::F(1));
        assert!(paint(&mut session, WINDOW) == before);
    }
    // Escape leaves the keys first.
    key(&mut session, Key::F(1));
    assert!(!key(&mut session, Key::Escape).contains(&Effect::Quit));
    assert!(paint(&mut session, WINDOW) == before);
    assert!(key(&mut session, Key::F(2)).contains(&Effect::Save));
    session.handle(Event::Say("cannot write: the disc is full".to_owned()));
    assert!(paint(&mut session, WINDOW) != before);
}

#[test]
fn how_the_picture_was_made_stands_where_nothing_else_does() {
    for (index, window) in [(0, size(960, 540)), (6, size(700, 1000)), (6, size(1280, 720))] {
        let mut session = session(index);
        session.handle(Event::Resize(window));
        let pictures = rendered(&session);
        for words in (0..60).step_by(5) {
            session.handle(Event::Say("a word ".repeat(words)));
            let [without, with] = ["", "12.3 ms, 40/s"].map(|status| {
                let mut image = RgbImage::new(window.width() as u32, window.height() as u32);
                session.paint(&mut image, &pictures.iter().collect::<Vec<_>>(), status);
                image
            });
            let covered =
                without.pixels().zip(with.pixels()).find(|(a, b)| a != b && a.0 != [21, 24, 31]);
            assert_eq!(covered, None, "after {words} words in {window}");
        }
    }
}

#[test]
fn vectors_are_shown_and_hidden() {
    let mut session = wide(session(6));
    click_middle(&mut session);
    let shown = paint(&mut session, WINDOW);
    key(&mut session, Key::Char('V'));
    assert!(paint(&mut session, WINDOW) != shown);
    key(&mut session, Key::Char('V'));
    // But for the note on what was pinned.
    let area = session.picture_area();
    let crop = |image: &RgbImage| {
        imageops::crop_imm(image, 0, 0, area.width as u32, area.height as u32).to_image()
    };
    assert!(crop(&paint(&mut session, WINDOW)) == crop(&shown));
}

#[test]
fn the_command_gives_the_same_picture() {
    let mut session = session(6);
    assert_eq!(session.desk().command(), "cargo run -p step07_specular");
    let (x, y) = middle(session.picture_area());
    drag(&mut session, (x, y), (x + 33.0, y - 7.0));
    keys(&mut session, &[Key::Right, Key::Down, Key::Right]);
    let effects = key(&mut session, Key::Char('C'));
    let command = session.desk().command();
    assert_eq!(printed(&effects), Some(&*format!("{command}\n")));
    assert_eq!(session.note(), Some(&*command));
    let settings = session.desk().setup().settings().join(" --set ");
    assert_eq!(command, format!("cargo run -p step07_specular -- --set {settings}"));
}

#[test]
fn from_outside_the_onlooker_moves() {
    let mut session = session(6);
    let view = session.desk().setup().view().clone();
    assert!(key(&mut session, Key::Char('O')).contains(&Effect::Redraw));
    let onlooker = session.desk().onlooker().expect("outside").clone();
    // In the sky, where nothing is to be taken hold of.
    let area = session.picture_area();
    let (x, y) = (area.left + 3.0, area.top + 3.0);
    drag(&mut session, (x, y), (x + 30.0, y));
    session.handle(Event::Wheel(1.0));
    assert_eq!(*session.desk().setup().view(), view);
    let moved = session.desk().onlooker().expect("outside");
    assert_ne!(moved.azimuth, onlooker.azimuth);
    assert!(moved.distance < onlooker.distance);
    click(&mut session, (x, y));
    assert_eq!(session.desk().pinned(), None);
    key(&mut session, Key::Char('O'));
    assert!(session.desk().onlooker().is_none());
}

#[test]
fn a_light_is_dragged_from_outside() {
    let mut session = session(6);
    key(&mut session, Key::Char('O'));
    let area = session.picture_area();
    let before = session.desk().setup().settings();
    // Somewhere in the picture is a point to be taken hold of.
    let moved = (0..area.height as usize).step_by(4).any(|row| {
        (0..area.width as usize).step_by(4).any(|col| {
            let (x, y) = (area.left + col as f32, area.top + row as f32);
            drag(&mut session, (x, y), (x + 6.0, y));
            session.desk().setup().settings() != before
        })
    });
    assert!(moved);
    assert!(session.desk().setup().settings().iter().any(|setting| setting.contains(".light.")));
}

#[test]
fn keys_go_from_step_to_step() {
    let last = STEPS.len() - 1;
    let mut session = lecture(last - 1);
    session.handle(Event::Wheel(1.0));
    click_middle(&mut session);
    key(&mut session, Key::Char('+'));
    let (distance, pinned) = (session.desk().setup().view().distance, session.desk().pinned());
    assert!(key(&mut session, Key::PageDown).contains(&Effect::Redraw));
    assert_eq!(session.desk().program().name, STEPS[last]);
    assert_eq!(
        (session.desk().setup().view().distance, session.desk().pinned()),
        (distance, pinned)
    );
    key(&mut session, Key::PageDown);
    assert_eq!(session.desk().program().name, STEPS[last]);
    key(&mut session, Key::PageUp);
    assert_eq!(session.desk().program().name, STEPS[last - 1]);
    for (digit, step) in ('1'..='9').zip(STEPS) {
        key(&mut session, Key::Char(digit));
        assert_eq!(session.desk().program().name, step);
    }
    for key_ in [Key::Char('0'), Key::F(9), Key::Char('Z')] {
        key(&mut session, key_);
        assert_eq!(session.desk().program().name, STEPS[last]);
    }
    let mut alone = crate::session(3);
    assert!(!key(&mut alone, Key::PageUp).contains(&Effect::Redraw));
    assert_eq!(alone.desk().program().name, STEPS[3]);
}

#[test]
fn the_step_before_is_seen_as_long_as_a_key_is_held() {
    let mut session = lecture(6);
    key(&mut session, Key::Tab);
    assert_eq!(
        session.desk().pictures().iter().map(|wanted| wanted.program).collect::<Vec<_>>(),
        [5]
    );
    session.handle(Event::KeyUp(Key::Tab));
    assert_eq!(
        session.desk().pictures().iter().map(|wanted| wanted.program).collect::<Vec<_>>(),
        [6]
    );
}

#[test]
fn a_line_divides_the_step_before_from_this_one() {
    let mut session = wide(lecture(6));
    key(&mut session, Key::Char('D'));
    let (x, y) = middle(session.picture_area());
    drag(&mut session, (x, y), (x + 100.0, y));
    assert_eq!(session.desk().pictures().len(), 2);
    let image = paint(&mut session, WINDOW);
    let sides = rendered(&session);
    assert!(sides[0] != sides[1]);
    for (col, row, before) in sides[0].enumerate_pixels() {
        let expected = match (col as f32) - (x + 100.0) {
            off if off < -6.0 => before,
            off if off > 6.0 => sides[1].get_pixel(col, row),
            _ => continue,
        };
        assert_eq!(image.get_pixel(col, row), expected, "{col} {row}");
    }
    key(&mut session, Key::Char('D'));
    assert_eq!(session.desk().pictures().len(), 1);
    // The first step has none before it, and a step's own WINDOW has no other.
    keys(&mut session, &['1', 'D'].map(Key::Char));
    assert_eq!(session.desk().pictures().len(), 1);
    painted(&mut session, WINDOW);
    let mut alone = crate::session(6);
    key(&mut alone, Key::Char('X'));
    assert_eq!(alone.desk().pictures().len(), 1);
}

#[test]
fn differences_are_seen_eight_times() {
    let mut session = wide(lecture(6));
    key(&mut session, Key::Char('X'));
    let image = paint(&mut session, WINDOW);
    let pictures = rendered(&session);
    let (width, height) = pictures[0].dimensions();
    let panels = side_by_side(&pictures[0], &pictures[1]);
    let [found, expected] = [(0, image), (2 * width, panels)]
        .map(|(left, image)| imageops::crop_imm(&image, left, 0, width, height).to_image());
    assert!(found == expected);
}

#[test]
fn the_lesson_is_read_beside_the_picture() {
    let mut session = lecture(6);
    let before = painted(&mut session, WINDOW);
    for lesson in [Key::F(3), Key::F(4)] {
        key(&mut session, lesson);
        assert!(paint(&mut session, WINDOW) != before);
        key(&mut session, lesson);
        assert!(paint(&mut session, WINDOW) == before);
        // A step's own WINDOW has none.
        let mut alone = crate::session(6);
        let picture = alone.picture_area();
        key(&mut alone, lesson);
        assert_eq!(alone.picture_area(), picture);
    }
}

#[test]
fn what_a_step_tells_anew_is_marked() {
    let marks = |session: &mut Session| {
        let image = paint(session, WINDOW);
        image.pixels().filter(|pixel| pixel.0 == [150, 225, 150]).count()
    };
    // Where letters are large, what is new is far below the panel's upper edge.
    for larger in [0, 8] {
        let pinned = |session: Session| {
            let mut session = wide(session);
            (0..larger).for_each(|_| drop(key(&mut session, Key::Char('+'))));
            click_middle(&mut session);
            session
        };
        for (index, name) in STEPS.iter().enumerate() {
            let mut session = pinned(lecture(index));
            assert_eq!(marks(&mut session) > 100, index > 0, "{name}, {larger} times larger");
            assert_eq!(marks(&mut pinned(crate::session(index))), 0, "{name}");
            // And when the pixel was pinned before.
            key(&mut session, Key::PageDown);
            assert!(marks(&mut session) > 100, "{name}, the step after it");
        }
    }
}

#[test]
fn no_event_hurts_in_any_window() {
    let letters = "PVOCDX+-1237Z".chars().map(Key::Char);
    let keys: Vec<Key> = letters
        .chain((0..12).map(Key::F))
        .chain([Key::Up, Key::Down, Key::Left, Key::Right, Key::Home, Key::Backspace])
        .chain([Key::Space, Key::Enter, Key::Tab, Key::PageUp, Key::PageDown, Key::Escape])
        .collect();
    for (width, height) in [(1, 1), (120, 400), (400, 20), (64, 36)] {
        let window = size(width, height);
        let mut session = lecture(0);
        painted(&mut session, window);
        for (turn, pressed) in keys.iter().chain(keys.iter().rev()).enumerate() {
            key(&mut session, *pressed);
            let at = (turn as f32 * 7.0 % width as f32, turn as f32 * 5.0 % height as f32);
            click(&mut session, at);
            session.handle(Event::Move(f32::NAN, f32::INFINITY));
            session.handle(Event::Wheel(turn as f32 - 20.0));
            session.handle(Event::Move(at.0, at.1));
            paint(&mut session, window);
        }
    }
}

#[test]
fn symbols_can_be_read_beside_the_picture() {
    let background = Ink::new(21, 24, 31);
    let mut seen = 0;
    for index in 0..STEPS.len() {
        let mut session = session(index);
        click_middle(&mut session);
        let explanation = session.desk().explanation().expect("a pixel is pinned");
        for ink in explanation.lines().filter_map(|line| symbol_ink(line.symbol())) {
            seen += 1;
            assert!(ink.contrast(background) >= 4.5, "{ink:?}");
        }
    }
    assert!(seen > 20);
}
