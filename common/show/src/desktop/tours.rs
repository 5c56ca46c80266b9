//! The tours that a command line asks for: read, begun, checked.

use std::fs;
use std::path::PathBuf;

use anyhow::Context;
use anyhow::Result;
use anyhow::ensure;
use clap::ArgMatches;
use clap::parser::ValueSource;
use image::RgbImage;

use super::arguments::given;
use super::drawing::render_parallel;
use super::remembered::Remembered;
use super::said::print;
use super::said::tell;
use super::suite::Suite;
use crate::Act;
use crate::Desk;
use crate::Frame;
use crate::Session;
use crate::Tour;
use crate::Wanted;
use crate::text;

/// What may be said with a class that begins at its first stop.
const WITH_A_CLASS: [&str; 6] = ["size", "tour", "still", "language", "watch", "window"];

/// Whether the arguments ask for a class, and nothing else.
pub(super) fn begins(suite: &Suite, matches: &ArgMatches) -> bool {
    let typed = |id: &&str| matches.value_source(id) == Some(ValueSource::CommandLine);
    let mut others = matches.ids().map(|id| id.as_str()).filter(typed);
    !suite.tours.is_empty() && others.all(|id| WITH_A_CLASS.contains(&id))
}

/// The tours: the suite's own, or the one in the file that is named. What is wrong in them is told.
pub(super) fn tours(suite: &Suite, matches: &ArgMatches) -> Result<Vec<Tour>> {
    let own = |(name, text): &(&str, &str)| ((*name).to_owned(), (*text).to_owned());
    let texts = match given::<PathBuf>(matches, "tour") {
        None => suite.tours.iter().map(own).collect(),
        Some(path) => {
            let name = path.display().to_string();
            let text = fs::read_to_string(&path);
            vec![(name.clone(), text.with_context(|| text!("cannot read {path}", path = name))?)]
        }
    };
    let mut tours = Vec::new();
    for (name, text) in texts {
        let (tour, mistakes) = suite.tour(&text);
        mistakes.iter().for_each(|mistake| tell(&format!("{name}:{mistake}")));
        ensure!(!tour.stops.is_empty(), text!("no stop of {name} can be shown", name));
        tours.push(tour);
    }
    Ok(tours)
}

/// Begins the class: its first stop, and what is said of the last one.
pub(super) fn begin(desk: &mut Desk, remembered: &Remembered) -> Option<String> {
    // There is a first stop.
    let _ = desk.act(Act::Stop(1));
    let (number, count) = (remembered.stop, desk.stops().len());
    let stop = desk.stops().get(number.checked_sub(1)?).filter(|_| (2..count).contains(&number))?;
    let offer = text!(
        "T and Enter go on where the last class ended: {slide}, {number}/{count}",
        slide = stop.slide,
        number,
        count
    );
    let _ = desk.act(Act::Pick(number as isize - 1));
    Some(offer)
}

/// What a desk shows, written as a file is.
pub fn picture_shown(mut desk: Desk) -> RgbImage {
    // Nothing is on its way: that cannot be refused.
    let _ = desk.act(Act::Glide(1.0));
    let (size, samples) = (desk.picture_size(), desk.samples());
    let render = |wanted: &Wanted<'_>| {
        let frame = Frame { step: wanted.step(), camera: &*wanted.camera, size, samples };
        let mut picture = render_parallel(&frame, |_| ());
        wanted.draw_over(&mut picture);
        picture
    };
    let pictures = desk.pictures().iter().map(render).collect();
    Session::new(desk).written(pictures)
}

/// Prints which stops show nothing, or the same as the one before; whether none does.
pub(super) fn check(suite: &Suite, tours: Vec<Tour>) -> Result<bool> {
    let (mut text, mut right) = (String::new(), true);
    for tour in tours {
        let mut before = None;
        for (number, stop) in (1..).zip(&tour.stops) {
            let mut desk = suite.desk(0).touring(vec![tour.clone()]);
            desk.act(Act::Stop(number))?;
            let picture = picture_shown(desk);
            let first = picture.pixels().next();
            let wrong = if picture.pixels().all(|pixel| Some(pixel) == first) {
                text!("the picture is empty")
            } else if before.as_ref() == Some(&picture) {
                text!("the picture is that of the stop before")
            } else {
                ""
            };
            if !wrong.is_empty() {
                right = false;
                text += &format!("{number} {}: {wrong}\n", stop.slide);
            }
            before = Some(picture);
        }
        let count = tour.stops.len();
        text += &text!("{title}: {count} stops looked at\n", title = tour.title, count);
    }
    print(text.as_bytes())?;
    Ok(right)
}
