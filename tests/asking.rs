//! What a window does with the lines of a pinned pixel: pointed at, shown, asked what if.

use tests::prelude::*;

/// A session in a window, with a pinned pixel in the key light's shadow on the floor.
fn pinned() -> Session {
    let mut session = window(desk(6, Size::DEFAULT));
    click(&mut session, (0.34, 0.62));
    session
}

/// Points at the line of this equation, wherever it is in the window; whether it is there.
fn point_at(session: &mut Session, equation: &str) -> bool {
    let (width, height) = (Size::DEFAULT.width(), Size::DEFAULT.height());
    (0..height).step_by(4).any(|row| {
        session.handle(Event::Move(0.9 * width as f32, row as f32));
        session.desk().line().is_some_and(|line| line.equation == equation)
    })
}

#[test]
fn a_key_asks_what_if_of_the_line_that_is_pointed_at() {
    let mut session = pinned();
    let before = pictures_of(session.desk(), size(320, 180));
    // The floor is matte, so that the light itself is what there is to be read.
    assert!(point_at(&mut session, "V"));
    assert!(typed(&mut session, "W").contains(&Effect::Redraw));
    assert_eq!(session.desk().altered().as_deref(), Some("What if V · key light = 1?"));
    assert_eq!(session.selected(), Some("what-if key light: V"), "its slider is at hand");
    let lit = after(desk(6, Size::DEFAULT), &[what_if("key: V=1")]);
    assert!(pictures_of(session.desk(), size(320, 180)) == pictures_of(&lit, size(320, 180)));
    let told = session.desk().explanation().expect("it is pinned");
    let rays =
        told.lines().filter(|line| matches!(line.place, Some(Place::ShadowRay(_, t)) if t < 1.0));
    assert_eq!(rays.count(), 0, "the key light's shadow ray gets to it");
    key(&mut session, Key::Left);
    assert_eq!(session.desk().altered().as_deref(), Some("What if V · key light = 0?"));
    typed(&mut session, "W");
    assert_eq!(session.desk().altered(), None);
    assert!(pictures_of(session.desk(), size(320, 180)) == before);
    typed(&mut session, "WG");
    let asked = session.desk().altered().expect("something is");
    assert_eq!(asked, "E se V · luz principal = 1?");
    // As long as it is, the window says so, whatever else is said.
    let window = |session: &Session| {
        let mut image = RgbImage::new(960, 540);
        session.paint(&mut image, &[], "");
        image
    };
    let orange =
        |image: &RgbImage| image.pixels().filter(|pixel| pixel.0 == [255, 150, 70]).count();
    let row = orange(&window(&session));
    assert!(row > 20, "{row}");
    typed(&mut session, "C");
    assert_eq!(orange(&window(&session)), row);
    key(&mut session, Key::Home);
    assert_eq!(orange(&window(&session)), 0);
}

#[test]
fn a_line_is_shown_by_a_click_and_a_curve_by_a_key() {
    let mut session = pinned();
    typed(&mut session, "U");
    assert!(
        session.desk().curve().is_none()
            && session.note().is_some_and(|note| note.contains("curve"))
    );
    assert!(point_at(&mut session, "I_a"));
    let line = session.desk().line().cloned();
    typed(&mut session, "Q");
    assert_eq!(session.desk().shown_line().cloned(), line);
    let area = session.picture_area();
    let effects = typed(&mut session, "U");
    assert!(effects.contains(&Effect::Redraw) && session.desk().has_curve());
    assert!(session.picture_area().height < area.height, "it takes place");
    typed(&mut session, "J");
    assert_ne!(session.desk().line().cloned(), line, "the next line");
    typed(&mut session, "KQ");
    assert_eq!(session.desk().shown_line(), None);
    assert!(point_at(&mut session, "L_a = k_a I_a"));
    typed(&mut session, "Q");
    // What is held, divided and compared is the quantity too.
    for (key, count) in [('D', 2), ('D', 1), ('X', 2), ('X', 1), ('A', 1)] {
        typed(&mut session, &key.to_string());
        let wanted = session.desk().pictures();
        assert_eq!(wanted.len(), count);
        assert!(wanted.iter().all(|wanted| !std::ptr::addr_eq(wanted.step(), wanted.setup.step())));
    }
    session.handle(Event::KeyUp(Key::Char('A')));
    for has_pin in [true, false] {
        key(&mut session, Key::Escape);
        let desk = session.desk();
        assert_eq!((desk.shown_line(), desk.pinned().is_some()), (None, has_pin));
    }
    let said = key(&mut session, Key::Escape);
    assert_eq!((said, session.note().is_some()), (vec![Effect::Repaint], true), "it never ends");
}

#[test]
fn what_is_pinned_is_what_keys_act_on() {
    let mut session = window(desk(6, Size::DEFAULT));
    let mut selected = |at: (f32, f32)| {
        click(&mut session, at);
        session.selected().map(str::to_owned)
    };
    let [red, green] = [(0.48, 0.46), (0.23, 0.63)].map(&mut selected);
    assert_eq!((red.as_deref(), green.as_deref()), (Some("red.k_s"), Some("green.k_s")));
    // The background has no controls.
    assert_eq!(selected((0.5, 0.02)).as_deref(), Some("green.k_s"));
    key(&mut session, Key::Down);
    let second = session.selected().map(str::to_owned);
    click(&mut session, (0.23, 0.64));
    assert_eq!(session.selected().map(str::to_owned), second, "it is one of them already");
}
