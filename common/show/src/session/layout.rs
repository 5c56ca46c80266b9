//! Where things have their place in a window.

use crate::Area;
use crate::Curve;
use crate::Legend;
use crate::Size;

/// The em of the text, of the window's height: then a capital letter is 2.8 % of it high.
const TEXT: f32 = 0.0385;

/// Below so many pixels no text can be read: the picture is all there is.
const LEAST_TEXT: f32 = 5.0;

/// How wide the column beside the picture is, in ems: as wide as three numbers of an explanation.
const COLUMN: f32 = 18.0;

/// How high a stop's text is with what stands over it, in ems: three lines.
const STOP: f32 = 5.8;
/// How much of the width code takes.
const CODE_COLUMN: f32 = 0.58;

/// Where things have their place in a window. Nothing lies over anything else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layout {
    /// The em of the text, in pixels.
    pub(super) em: f32,
    /// The picture, whole.
    pub(super) picture: Area,
    /// What the colours of a quantity stand for, below the picture, if one is shown.
    pub(super) legend: Option<Area>,
    /// The quantity as a curve, below that, if it is shown.
    pub(super) curve: Option<Area>,
    /// What there is beside the picture; none when it is hidden.
    pub(super) beside: Option<Beside>,
    /// The stop's text, below all of it, if there is one.
    pub(super) stop: Option<Area>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Beside {
    /// What the program is, and what happened last.
    pub(super) caption: Area,
    /// The controls; no height where something to be read has taken their place.
    pub(super) controls: Area,
    /// What is to be read, if there is something.
    pub(super) reading: Option<Area>,
}

/// What a layout depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wishes {
    /// Of the window.
    pub(super) size: Size,
    /// Width over height of the picture.
    pub(super) aspect: f32,
    /// How much larger the text shall be than usual.
    pub(super) text: f32,
    /// The picture alone.
    pub(super) hidden: bool,
    /// Whether there is something to be read.
    pub(super) reading: bool,
    /// Whether that is code, whose lines are long.
    pub(super) code: bool,
    /// Whether a quantity is shown.
    pub(super) legend: bool,
    /// Whether it is seen as a curve too.
    pub(super) curve: bool,
    /// Whether there is a stop's text.
    pub(super) stop: bool,
}

/// The largest area of this aspect in `outer`, at least a pixel wide and high: at its top, in the
/// middle of its width.
fn fit(outer: Area, aspect: f32) -> Area {
    let width = outer.width.min(outer.height * aspect).floor().max(1.0);
    let height = (width / aspect).round().min(outer.height.floor()).max(1.0);
    let left = outer.left + ((outer.width - width) / 2.0).floor().max(0.0);
    Area::new(left, outer.top, width, height)
}

/// The upper part of `area`, `height` high, and the rest.
pub(super) fn split(area: Area, height: f32) -> (Area, Area) {
    let height = height.clamp(0.0, area.height.max(0.0));
    (Area { height, ..area }, Area { top: area.top + height, height: area.height - height, ..area })
}

impl Layout {
    /// How high a row of text is, in ems.
    pub(super) const ROW: f32 = 1.2;

    /// How large code is beside other text: so many lines, and so long ones, are seen at once.
    pub(super) const CODE: f32 = 0.72;

    pub(super) fn new(wishes: &Wishes) -> Self {
        let Wishes { size, aspect, text, hidden, reading, code, legend, curve, stop } = *wishes;
        let (width, height) = (size.width() as f32, size.height() as f32);
        let window = Area::new(0.0, 0.0, width, height);
        // In a window that is higher than wide the width decides.
        let em = TEXT * height.min(0.75 * width) * text;
        let stop = (stop && em >= LEAST_TEXT).then(|| (STOP * em).min(0.4 * height).round());
        let (window, lower) = split(window, height - stop.unwrap_or_default());
        let (height, stop) = (window.height, stop.map(|_| lower));
        let high = |is_shown: bool, ems: f32, most: f32| match is_shown {
            true => (ems * em).min(most * height),
            false => 0.0,
        };
        let (legend, curve) = (high(legend, Legend::HEIGHT, 0.2), high(curve, Curve::HEIGHT, 0.3));
        let under = legend + curve;
        // Under the picture: the legend as wide as there is room, the curve as wide as the picture.
        let with = |picture: Area, room: f32, beside: Option<Beside>| {
            let under = Area { top: picture.bottom(), height: under, ..picture };
            let (upper, lower) = split(under, legend);
            let upper = Area { left: 0.0, width: room, ..upper };
            let shown = |area: Area| (area.height > 0.0).then_some(area);
            Self { em, picture, legend: shown(upper), curve: shown(lower), beside, stop }
        };
        if hidden || em < LEAST_TEXT {
            let picture = fit(Area { height: height - under, ..window }, aspect);
            let top = ((height - under - picture.height) / 2.0).floor();
            return with(Area { top, ..picture }, width, None);
        }
        let row = Self::ROW * em;
        if width < 0.9 * height {
            let outer = Area { height: (0.45 * height).floor(), ..window };
            let picture = fit(outer, aspect);
            let (_, below) = split(window, picture.height + under);
            let (caption, rest) = split(below, 4.5 * row);
            let (upper, controls) = split(rest, if reading { 0.6 * rest.height } else { 0.0 });
            let beside = Beside { caption, controls, reading: reading.then_some(upper) };
            return with(picture, width, Some(beside));
        }
        let column = match code {
            true => (CODE_COLUMN * width).floor(),
            false => (COLUMN * em).min(0.5 * width).floor(),
        };
        // At a stop that says what happens, below all of it.
        let rows = if stop.is_some() { 1.7 } else { 3.5 };
        let most = (height - rows * row - under).max(0.3 * height);
        let outer = Area::new(0.0, 0.0, width - column, most);
        let picture = fit(outer, aspect);
        let column = Area::new(outer.width, 0.0, column, height);
        let (_, below) = split(Area { height, ..outer }, picture.height + under);
        let beside = if !reading {
            Beside { caption: below, controls: column, reading: None }
        } else if below.height > 5.5 * row {
            let (caption, controls) = split(below, 2.5 * row);
            Beside { caption, controls, reading: Some(column) }
        } else {
            let (reading, controls) = split(column, 0.66 * height);
            Beside { caption: below, controls, reading: Some(reading) }
        };
        with(picture, outer.width, Some(beside))
    }
}
