//! What hands do in a window, and what is painted there.

use tests::prelude::*;

use crate::alone;
use crate::desk;

const WINDOW: Size = Size::DEFAULT;
const BACKGROUND: [u8; 3] = [21, 24, 31];

fn single(index: usize) -> Session {
    window(alone(index))
}

fn lecture(index: usize) -> Session {
    window(desk(index))
}

fn keys(session: &mut Session, keys: &[Key]) {
    keys.iter().for_each(|pressed| drop(key(session, *pressed)));
}

fn paint(session: &mut Session) -> RgbImage {
    painted(session, WINDOW, "")
}

fn text(session: &Session, name: &str) -> String {
    let mut list = session.desk().setup().list().into_iter();
    list.find(|setting| setting.name == name).expect("a control").control.text()
}

fn settings(session: &Session) -> Vec<String> {
    session.desk().setup().settings()
}

fn view(session: &Session) -> View {
    session.desk().setup().view().clone()
}

fn pinned(session: &Session) -> Option<(usize, usize)> {
    session.desk().pinned().map(|pixel| (pixel.col, pixel.row))
}

/// The first place beside the picture where a press does what is asked for; each is let go again.
fn found(session: &mut Session, mut is_it: impl FnMut(&mut Session) -> bool) -> (f32, f32) {
    let area = session.picture_area();
    let places = (0..540).step_by(6).flat_map(|y| (0..960).step_by(6).map(move |x| (x, y)));
    let mut places = places.map(|(x, y)| (x as f32, y as f32)).filter(|at| !area.contains(*at));
    let place = places.find(|(x, y)| {
        session.handle(Event::Press(*x, *y));
        let is_it = is_it(session);
        session.handle(Event::Release(*x, *y));
        is_it
    });
    place.expect("somewhere beside the picture")
}

#[test]
fn arrows_select_every_control_and_change_it() {
    for (index, name) in STEPS.iter().enumerate() {
        let (mut session, mut seen) = (single(index), Vec::new());
        // Headings open on the way.
        for _ in 0..60 {
            match session.selected() {
                Some(name) => seen.push(name.to_owned()),
                None => drop(key(&mut session, Key::Right)),
            }
            key(&mut session, Key::Down);
            let mut image = RgbImage::new(960, 540);
            session.paint(&mut image, &[], "");
            let marked = image.pixels().any(|pixel| pixel.0 == [43, 49, 61]);
            assert!(marked, "{name}: what is selected is not seen, after {:?}", seen.last());
        }
        for setting in setup(index).list() {
            assert!(seen.contains(&setting.name), "{name}: {}", setting.name);
        }
    }
    let mut session = single(1);
    assert_eq!(session.selected(), Some("radius"));
    key(&mut session, Key::Down);
    assert!(key(&mut session, Key::Right).contains(&Effect::Redraw));
    let number = |session: &Session| text(session, "center.x").parse::<f32>().expect("a number");
    let coarse = number(&session);
    key(&mut session, Key::Left);
    session.handle(Event::Key(Key::Right, true));
    let fine = number(&session);
    assert!(fine > 0.0 && fine < coarse / 5.0, "with Shift {fine}, without {coarse}");
    keys(&mut session, &[Key::Up, Key::Right]);
    for (back, left) in [(Key::Delete, 1), (Key::Home, 0)] {
        assert!(key(&mut session, back).contains(&Effect::Redraw));
        assert_eq!(settings(&session).len(), left, "{back:?}");
    }
    // Before the first comes the last: the heading over the camera's, which folds.
    key(&mut session, Key::Up);
    assert_eq!(session.selected(), None);
    keys(&mut session, &[Key::Right, Key::Down]);
    assert_eq!(session.selected(), Some("camera"));
    keys(&mut session, &[Key::Up, Key::Left, Key::Down]);
    assert_eq!(session.selected(), Some("radius"));
    // What is selected stays so where the other step has it.
    let mut session = lecture(5);
    keys(&mut session, &[Key::Down, Key::Char('7')]);
    assert_eq!(session.selected(), Some("red.k_s"), "folded away, so the first one");
    keys(&mut session, &[Key::Char('6'), Key::Char('4')]);
    assert_eq!(session.selected(), Some("red.center.x"), "step 04 lacks the other");
    keys(&mut session, &[Key::Down, Key::Char('5')]);
    assert_eq!(session.selected(), Some("red.center.y"));
}

#[test]
fn a_click_pins_as_long_as_it_does_not_move() {
    let mut session = single(6);
    let at = place(&session, (0.52, 0.48));
    // A drag that ends where it began is none.
    drag(&mut session, &[at, (at.0 - 30.0, at.1 + 20.0), at]);
    assert_eq!(pinned(&session), None, "it was a drag");
    let off = view(&session).azimuth - setup(6).view().azimuth;
    assert!(off.abs() < 1e-4, "and it went back");
    // A hand trembles; it pins where it pressed.
    session.handle(Event::Press(at.0, at.1));
    assert_eq!(session.handle(Event::Move(at.0 + 2.0, at.1)), []);
    session.handle(Event::Release(at.0 + 2.0, at.1));
    assert_eq!(pinned(&session), Some((166, 86)), "0.52 of 320 and 0.48 of 180");
    assert!(session.note().is_some_and(|note| note.contains("(166, 86)")), "{:?}", session.note());
    for pin in [Key::Enter, Key::Char('P')] {
        let mut session = single(6);
        key(&mut session, pin);
        assert!(session.note().is_some() && pinned(&session).is_none(), "no pixel is pointed at");
        session.handle(Event::Move(at.0, at.1));
        key(&mut session, pin);
        assert_eq!(pinned(&session), Some((166, 86)));
    }
}

#[test]
fn a_drag_orbits_and_the_wheel_zooms() {
    let mut session = single(6);
    let start = view(&session);
    let (x, y) = place(&session, (0.5, 0.5));
    // In however many moves.
    drag(&mut session, &[(x, y), (x + 70.0, y), (x - 30.0, y + 20.0)]);
    let (turned, degrees) = (view(&session), 180.0 / session.picture_area().height);
    session.handle(Event::Wheel(2.0));
    for (found, expected) in [
        (turned.azimuth - start.azimuth, 30.0 * degrees),
        (turned.elevation - start.elevation, 20.0 * degrees),
        (view(&session).distance / turned.distance, 0.81),
    ] {
        assert!((found - expected).abs() < 0.01, "{found} {expected}");
    }
    assert_eq!((pinned(&session), session.handle(Event::Move(x, y))), (None, vec![]), "it is up");
    // What is left for another window is let go.
    session.handle(Event::Press(x, y));
    session.handle(Event::FocusLost);
    assert_eq!(session.handle(Event::Move(x + 50.0, y)), []);
    session.handle(Event::Release(x, y));
    assert_eq!(pinned(&session), None);
    let mut session = lecture(6);
    key(&mut session, Key::Tab);
    assert!(session.desk().is_holding());
    session.handle(Event::FocusLost);
    assert!(!session.desk().is_holding(), "Tab was let go elsewhere");
    // From outside, a light is dragged; the nearest of what is near.
    let mut session = single(6);
    typed(&mut session, "O");
    let camera = session.desk().seen_from().camera(320.0 / 180.0);
    let sight = Sight { step: &*step(6), camera: &*camera, area: session.picture_area() };
    let (x, y) = sight.at(Vec3::new(4.0, 6.0, 5.0)).expect("the key light is seen");
    drag(&mut session, &[(x + 3.0, y), (x - 40.0, y)]);
    let moved = settings(&session);
    assert!(!moved.is_empty() && moved.iter().all(|it| it.starts_with("key.light.")), "{moved:?}");
}

#[test]
fn a_slider_is_dragged_to_its_ends_and_its_name_changes_nothing() {
    let mut session = single(1);
    let (x, y) = found(&mut session, |session| {
        session.selected() == Some("radius") && !settings(session).is_empty()
    });
    session.handle(Event::Press(x, y));
    for (to, radius) in [(5000.0, "2"), (-5000.0, "0.1")] {
        session.handle(Event::Move(to, to));
        assert_eq!(text(&session, "radius"), radius);
    }
    session.handle(Event::Release(-5000.0, 0.0));
    session.handle(Event::Move(5000.0, 0.0));
    assert_eq!(text(&session, "radius"), "0.1");
    key(&mut session, Key::Home);
    found(&mut session, |session| {
        let moved = !settings(session).is_empty();
        key(session, Key::Home);
        session.selected() == Some("center.x") && !moved
    });
}

#[test]
fn the_wheel_beside_the_picture_scrolls_and_a_click_on_a_heading_folds() {
    let mut session = single(6);
    let distance = view(&session).distance;
    let beside = |session: &mut Session, notches: f32| {
        // What is below the pointer may be another line then.
        for event in [Event::Move(900.0, 200.0), Event::Wheel(notches), Event::Move(900.0, 200.0)] {
            session.handle(event);
        }
        paint(session)
    };
    beside(&mut session, -3.0);
    click(&mut session, (0.5, 0.5));
    key(&mut session, Key::Down);
    let top = beside(&mut session, 50.0);
    let bar = |image: &RgbImage| {
        (0..540).filter(|row| image.get_pixel(956, *row).0 == [128, 140, 160]).min()
    };
    let lower = beside(&mut session, -3.0);
    assert!(bar(&top).is_some() && bar(&top) < bar(&lower), "the scroll bar goes down");
    // As far as there is something, and no farther; and so back.
    let [bottom, above] = [-500.0, 1.0].map(|notches| beside(&mut session, notches));
    assert!(bar(&above) < bar(&bottom), "one notch back is seen");
    assert_eq!(bar(&beside(&mut session, 50.0)), bar(&top));
    assert_eq!(view(&session).distance, distance);
    // Some way down the explanation stands a section: a click on a line would be another picture.
    session.handle(Event::Move(0.0, 539.0));
    let (right, top) = (session.picture_area().right(), paint(&mut session));
    let picture = cropped(&session, &top);
    let is_folded = (2..60).map(|row| (right + 100.0, 6.0 * row as f32)).any(|heading| {
        let folds = [true, false].map(|is_folded| {
            drag(&mut session, &[heading]);
            session.handle(Event::Move(0.0, 539.0));
            let image = paint(&mut session);
            (image != top) == is_folded && cropped(&session, &image) == picture
        });
        folds == [true, true]
    });
    assert!(is_folded, "a second click on what the first folds unfolds it");
}

#[test]
fn the_picture_keeps_its_shape_and_nothing_lies_over_it() {
    for (index, name) in STEPS.iter().enumerate() {
        let mut session = single(index);
        for (width, height) in
            [(640, 360), (960, 540), (400, 700), (1, 1), (120, 2000), (2000, 30), (1920, 1080)]
        {
            let image = painted(&mut session, size(width, height), "");
            let area = session.picture_area();
            assert!(area.left >= 0.0 && area.right() <= width as f32, "{area:?}");
            assert!(area.top >= 0.0 && area.bottom() <= height as f32, "{area:?}");
            assert!((area.width - area.height * 16.0 / 9.0).abs() <= 2.0, "{area:?}");
            assert!(area.width >= 0.6 * width as f32 || width * 9 != height * 16, "{area:?}");
            let picture = pictures_of(session.desk(), session.shown_size()).remove(0);
            assert!(cropped(&session, &image) == picture, "{name}: {width}x{height}");
        }
    }
    let mut session = single(6);
    let usual = session.picture_area();
    for (pressed, again) in [(Key::Char('+'), Key::Char('-')), (Key::Space, Key::Space)] {
        assert!(key(&mut session, pressed).contains(&Effect::Redraw));
        assert_ne!(session.picture_area(), usual);
        let is_alone = session.picture_area() == Area::new(0.0, 0.0, 960.0, 540.0);
        assert_eq!(is_alone, pressed == Key::Space);
        let before = paint(&mut session);
        session.handle(Event::Say("what happens is said there too".to_owned()));
        assert!(paint(&mut session) != before);
        key(&mut session, again);
        assert_eq!(session.picture_area(), usual);
    }
}

#[test]
fn a_ring_is_around_the_pinned_pixel_where_it_is_seen() {
    let ring = |session: &mut Session| {
        let image = paint(session);
        let picture = cropped(session, &image);
        let ringed = picture.enumerate_pixels().filter(|(.., pixel)| pixel.0 == [255, 208, 64]);
        let (cols, rows): (Vec<u32>, Vec<u32>) = ringed.map(|(col, row, _)| (col, row)).unzip();
        let middle = |places: &[u32], all: u32| {
            places.iter().sum::<u32>() as f32 / (places.len() as u32 * all) as f32
        };
        let (width, height) = picture.dimensions();
        (!cols.is_empty()).then(|| (middle(&cols, width), middle(&rows, height)))
    };
    let mut session = single(6);
    // In the sky, where no arrow begins.
    click(&mut session, (0.3, 0.1));
    let (across, down) = ring(&mut session).expect("a ring");
    assert!((across - 0.3).abs() < 0.01 && (down - 0.1).abs() < 0.01, "{across} {down}");
    typed(&mut session, "O");
    assert_eq!(ring(&mut session), None, "it is not seen from outside");
    keys(&mut session, &[Key::Char('O'), Key::Escape]);
    assert_eq!(ring(&mut session), None, "it is unpinned");
    // Vectors are shown and hidden.
    click(&mut session, (0.5, 0.5));
    let images = ["V", "V"].map(|pressed| {
        typed(&mut session, pressed);
        paint(&mut session)
    });
    assert!(cropped(&session, &images[0]) != cropped(&session, &images[1]));
}

#[test]
fn how_the_picture_was_made_stands_where_nothing_else_does() {
    for (index, window) in [(0, size(960, 540)), (6, size(700, 1000)), (6, size(1280, 720))] {
        let mut session = single(index);
        for words in (0..60).step_by(5) {
            session.handle(Event::Say("a word ".repeat(words)));
            let [without, with] =
                ["", "12.3 ms, 40/s"].map(|status| painted(&mut session, window, status));
            let mut pairs = without.pixels().zip(with.pixels());
            let covered = pairs.find(|(a, b)| a != b && a.0 != BACKGROUND);
            assert_eq!(covered, None, "after {words} words in {window}");
        }
    }
    // Where what stands below the picture has no room, letters are cut off by the window's edge.
    for language in Language::all() {
        language.speak();
        for (index, name) in STEPS.iter().enumerate() {
            let mut session = window(Desk::new(programs(), index));
            let (image, right) = (paint(&mut session), session.picture_area().right() as u32);
            let edge = imageops::crop_imm(&image, 0, 534, right, 6).to_image();
            assert!(edge.pixels().all(|it| it.0 == BACKGROUND), "{name}, {language:?}");
        }
    }
}

#[test]
fn two_steps_are_compared_by_a_line_or_by_their_difference() {
    let mut session = lecture(6);
    typed(&mut session, "D");
    let (x, y) = place(&session, (0.5, 0.5));
    drag(&mut session, &[(x, y), (x + 100.0, y)]);
    let sides = pictures_of(session.desk(), session.shown_size());
    let image = paint(&mut session);
    assert!(sides[0] != sides[1]);
    for (col, row, before) in sides[0].enumerate_pixels() {
        let off = col as f32 - (x + 100.0);
        let expected = if off < 0.0 { before } else { sides[1].get_pixel(col, row) };
        assert!(off.abs() <= 6.0 || image.get_pixel(col, row) == expected, "{col} {row}");
    }
    typed(&mut session, "X");
    let image = paint(&mut session);
    // Below what says which colour is more light and which is less.
    for (col, row, before) in sides[0].enumerate_pixels().filter(|(_, row, _)| *row > 40) {
        let [r, _, b] = image.get_pixel(col, row).0;
        let pairs = before.0.into_iter().zip(sides[1].get_pixel(col, row).0);
        let off = pairs.map(|(before, this)| i32::from(this) - i32::from(before));
        let most = off.max_by_key(|off| off.abs()).expect("three channels");
        assert_eq!(most.signum(), (i32::from(r) - i32::from(b)).signum(), "{col} {row}");
    }
}

#[test]
fn what_a_step_tells_anew_is_marked_and_seen_at_once() {
    let marks = |session: &mut Session| {
        paint(session).pixels().filter(|pixel| pixel.0 == [150, 225, 150]).count()
    };
    // Where letters are large, what is new is far below the panel's upper edge.
    for (index, larger) in (0..STEPS.len()).flat_map(|index| [(index, 0), (index, 8)]) {
        let pinned = |mut session: Session| {
            typed(&mut session, &"+".repeat(larger));
            click(&mut session, (0.5, 0.5));
            session
        };
        let (mut session, what) = (pinned(lecture(index)), format!("{index}, {larger} larger"));
        assert_eq!(marks(&mut session) > 100, index > 0, "{what}");
        assert_eq!(marks(&mut pinned(single(index))), 0, "{what}");
        // And when the pixel was pinned before.
        typed(&mut session, &(index + 2).min(STEPS.len()).to_string());
        assert!(marks(&mut session) > 100, "{what}, the step after it");
    }
}

#[test]
fn no_event_hurts_in_any_window() {
    let letters = "PVOCDXH+-1237Z".chars().map(Key::Char).chain((0..12).map(Key::F));
    let others = [Key::Up, Key::Down, Key::Left, Key::Right, Key::Home, Key::Backspace, Key::Space];
    let named = [Key::Enter, Key::Tab, Key::PageUp, Key::PageDown, Key::Escape];
    let keys: Vec<Key> = letters.chain(others).chain(named).collect();
    for (width, height) in [(1, 1), (120, 400), (400, 20), (64, 36)] {
        let mut session = lecture(0);
        for (turn, pressed) in keys.iter().chain(keys.iter().rev()).enumerate() {
            key(&mut session, *pressed);
            let at = (turn as f32 * 7.0 % width as f32, turn as f32 * 5.0 % height as f32);
            drag(&mut session, &[at]);
            session.handle(Event::Move(f32::NAN, f32::INFINITY));
            session.handle(Event::Wheel(turn as f32 - 20.0));
            session.handle(Event::Move(at.0, at.1));
            painted(&mut session, size(width, height), "");
        }
    }
}
