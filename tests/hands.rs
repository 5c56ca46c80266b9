//! What a class does by hand: acts on a desk, and keys and the mouse in a window.

use crate::prelude::*;

/// A desk with all steps, at the one of this index, whose pictures are so large; it speaks English.
pub fn desk(index: usize, picture: Size) -> Desk {
    Language::ENGLISH.speak();
    let program = |index| Program::new(STEPS[index], "a concept", picture, make(index));
    Desk::new((0..STEPS.len()).map(program).collect(), index)
}

/// Does on the desk what cannot be refused.
pub fn act(desk: &mut Desk, act: Act) -> Vec<Effect> {
    desk.act(act.clone()).unwrap_or_else(|refusal| panic!("{act:?}: {refusal}"))
}

/// A desk after these acts, none of which it refuses.
pub fn after(mut desk: Desk, acts: &[Act]) -> Desk {
    acts.iter().for_each(|one| drop(act(&mut desk, one.clone())));
    desk
}

/// What the desk says of an act that it refuses.
#[track_caller]
pub fn refused(desk: &mut Desk, act: Act) -> String {
    desk.act(act).expect_err("it is refused").to_string()
}

/// `--set NAME=VALUE`
pub fn set(name: &str, value: &str) -> Act {
    Act::Set(name.to_owned(), value.to_owned())
}

/// `--show LINE`
pub fn show(name: &str) -> Act {
    Act::ShowNamed(name.to_owned())
}

/// `--what-if LINE=VALUE`
pub fn what_if(setting: &str) -> Act {
    Act::Answer(setting.to_owned())
}

/// What the options of a command do on a desk.
pub fn acts_of(options: &str) -> Vec<Act> {
    let (mut words, mut acts) = (options.split_whitespace(), Vec::new());
    while let Some(flag) = words.next() {
        let mut value = || words.next().expect("a value");
        acts.push(match flag {
            "--set" => {
                let (name, value) = value().split_once('=').expect("NAME=VALUE");
                set(name, value)
            }
            "--camera" => set("camera", value()),
            "--pixel" => {
                let (col, row) = value().split_once(',').expect("X,Y");
                Act::PinPixel(col.parse().expect("a column"), row.parse().expect("a row"))
            }
            "--show" => show(value()),
            "--what-if" => what_if(value()),
            "--outside" => Act::Outside,
            "-s" | "--size" => Act::Size(value().parse().expect("a size")),
            _ => panic!("{options}"),
        });
    }
    acts
}

/// What can be read in an address.
pub fn address(desk: &Desk) -> String {
    desk.address(Language::ENGLISH)
}

/// A window as large as a picture is at first.
pub fn window(desk: Desk) -> Session {
    let mut session = Session::new(desk);
    session.handle(Event::Resize(Size::DEFAULT));
    session
}

/// Presses a key.
pub fn key(session: &mut Session, key: Key) -> Vec<Effect> {
    session.handle(Event::Key(key, false))
}

/// Presses the keys of these letters.
pub fn typed(session: &mut Session, letters: &str) -> Vec<Effect> {
    letters.chars().flat_map(|letter| key(session, Key::Char(letter))).collect()
}

/// A place of the picture, by its shares of it.
pub fn place(session: &Session, (across, down): (f32, f32)) -> (f32, f32) {
    let Area { left, top, width, height } = session.picture_area();
    (left + across * width, top + down * height)
}

/// A press at the first place of a way, and letting go at the last; a click where there is but one.
pub fn drag(session: &mut Session, way: &[(f32, f32)]) {
    let ((x, y), (last_x, last_y)) = (way[0], way[way.len() - 1]);
    session.handle(Event::Press(x, y));
    way[1..].iter().for_each(|(x, y)| drop(session.handle(Event::Move(*x, *y))));
    session.handle(Event::Release(last_x, last_y));
}

/// Clicks on a place of the picture, by its shares of it.
pub fn click(session: &mut Session, at: (f32, f32)) {
    drag(session, &[place(session, at)]);
}

/// What a window of this size shows, with a word on how the picture was made.
pub fn painted(session: &mut Session, window: Size, status: &str) -> RgbImage {
    session.handle(Event::Resize(window));
    let pictures = pictures_of(session.desk(), session.shown_size());
    let mut image = RgbImage::new(window.width() as u32, window.height() as u32);
    session.paint(&mut image, &pictures.iter().collect::<Vec<_>>(), status);
    image
}

/// The picture's part of what a window shows.
pub fn cropped(session: &Session, image: &RgbImage) -> RgbImage {
    let Area { left, top, width, height } = session.picture_area();
    let [left, top, width, height] = [left, top, width, height].map(|side| side as u32);
    imageops::crop_imm(image, left, top, width, height).to_image()
}
