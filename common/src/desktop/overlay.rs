use std::convert::Infallible;
use std::ops::Range;

use embedded_graphics::Drawable;
use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::geometry::OriginDimensions;
use embedded_graphics::geometry::Point;
use embedded_graphics::geometry::Size as Extent;
use embedded_graphics::mono_font::MonoFont;
use embedded_graphics::mono_font::MonoTextStyle;
// The part of ISO 8859 with the slides' Greek letters.
use embedded_graphics::mono_font::iso_8859_7::FONT_6X10;
use embedded_graphics::mono_font::iso_8859_7::FONT_10X20;
use embedded_graphics::pixelcolor::IntoStorage;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::pixelcolor::RgbColor;
use embedded_graphics::primitives::Circle;
use embedded_graphics::primitives::Primitive;
use embedded_graphics::primitives::PrimitiveStyle;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::Baseline;
use embedded_graphics::text::Text;

use crate::Setting;
use crate::Size;

const TEXT: Rgb888 = Rgb888::WHITE;
const FAINT: Rgb888 = Rgb888::new(184, 192, 204);
const CHOSEN: Rgb888 = Rgb888::new(255, 208, 64);
const BAR: Rgb888 = Rgb888::new(96, 160, 232);
const GROOVE: Rgb888 = Rgb888::new(72, 80, 92);

/// The columns of a control's row, in characters.
const NAME: i32 = 0;
const SLIDER: i32 = 13;
const VALUE: i32 = 24;
const COLUMNS: i32 = 35;

/// What lies over the picture, and which of its parts are shown.
#[derive(Default)]
pub(crate) struct Overlay {
    /// Nothing lies over the picture.
    pub(crate) hidden: bool,
    /// The list of keys takes the place of the controls.
    pub(crate) help: bool,
    /// The control that keys act on.
    pub(crate) selected: usize,
    /// The control in the panel's first row.
    first: usize,
}

/// What the overlay shows besides the controls.
pub(crate) struct Caption<'a> {
    pub(crate) name: &'a str,
    pub(crate) concept: &'a str,
    /// At the lower left.
    pub(crate) status: &'a str,
    /// At the lower right.
    pub(crate) hint: &'a str,
    /// The lines of the help.
    pub(crate) keys: &'a [(&'a str, &'a str)],
}

/// What the mouse points at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Target {
    /// A control's row, and where on its slider, as far as it is on it.
    Control(usize, Option<f32>),
    /// A part of the overlay without effect.
    Panel,
    Picture,
}

/// Where things are in a window of some size, in units of `scale` pixels.
#[derive(Clone, Copy)]
struct Layout {
    scale: i32,
    font: &'static MonoFont<'static>,
    width: i32,
    height: i32,
}

impl Layout {
    fn new(size: Size) -> Self {
        let (width, height) = (size.width() as i32, size.height() as i32);
        let scale = (height / 540).min(width / 960).max(1);
        let font = if width < 720 || height < 400 { &FONT_6X10 } else { &FONT_10X20 };
        Self { scale, font, width: width / scale, height: height / scale }
    }

    fn column(&self) -> i32 {
        self.font.character_size.width as i32
    }

    fn margin(&self) -> i32 {
        self.column() / 2
    }

    fn row(&self) -> i32 {
        self.font.character_size.height as i32 + 2
    }

    /// The height of the line at the top and of that at the bottom.
    fn line(&self) -> i32 {
        self.row() + self.margin()
    }

    /// How many rows fit between the two lines.
    fn capacity(&self) -> usize {
        ((self.height - 2 * self.line() - 2 * self.margin()) / self.row()).max(0) as usize
    }

    /// A panel of some rows below the upper line.
    fn panel(&self, columns: i32, rows: usize) -> Rectangle {
        let width = columns * self.column() + 4 * self.margin();
        let height = rows as i32 * self.row() + 2 * self.margin();
        area(0, self.line(), width, if rows > 0 { height } else { 0 })
    }

    /// The top of a row of the panel.
    fn top(&self, row: usize) -> i32 {
        self.line() + self.margin() + row as i32 * self.row()
    }

    /// The left of a column of the panel.
    fn left(&self, column: i32) -> i32 {
        self.margin() + column * self.column()
    }

    /// Where `x` is on the slider, 0 to 1 between its ends.
    fn fraction(&self, x: f32) -> f32 {
        let start = self.left(SLIDER) as f32;
        (x / self.scale as f32 - start) / (self.left(VALUE - 1) as f32 - start)
    }
}

fn area(left: i32, top: i32, width: i32, height: i32) -> Rectangle {
    Rectangle::new(Point::new(left, top), Extent::new(width.max(0) as u32, height.max(0) as u32))
}

impl Overlay {
    /// Selects the next of `count` controls, or with −1 the one before.
    pub(crate) fn select(&mut self, by: isize, count: usize) {
        self.selected = (self.selected + count).saturating_add_signed(by) % count;
    }

    /// The controls that have a row: as many as fit, the selected one among them.
    fn shown(&self, layout: &Layout, count: usize) -> Range<usize> {
        let capacity = layout.capacity().min(count);
        if self.hidden || self.help || capacity == 0 {
            return 0..0;
        }
        let first = self.first.clamp((self.selected + 1).saturating_sub(capacity), self.selected);
        let first = first.min(count - capacity);
        first..first + capacity
    }

    /// What is at (`x`, `y`) in a window of some size, with `count` controls.
    pub(crate) fn target(&self, size: Size, count: usize, x: f32, y: f32) -> Target {
        let layout = Layout::new(size);
        let scale = layout.scale as f32;
        let point = Point::new((x / scale) as i32, (y / scale) as i32);
        let shown = self.shown(&layout, count);
        let panel = layout.panel(COLUMNS, shown.len());
        if !panel.contains(point) {
            return Target::Picture;
        }
        let row = (point.y - layout.top(0)).div_euclid(layout.row());
        let Some(index) = usize::try_from(row).ok().and_then(|row| shown.clone().nth(row)) else {
            return Target::Panel;
        };
        // A little beyond its ends too, which are hard to hit.
        let slider = layout.left(SLIDER) - layout.margin()..layout.left(VALUE) - layout.margin();
        Target::Control(index, slider.contains(&point.x).then(|| layout.fraction(x)))
    }

    /// Where on a slider `x` is, for a drag that began on it; below 0 or above 1 beyond its ends.
    pub(crate) fn fraction(&self, size: Size, x: f32) -> f32 {
        Layout::new(size).fraction(x)
    }

    /// Draws the overlay onto the pixels of a window, 0RGB.
    pub(crate) fn draw(
        &mut self, pixels: &mut [u32], size: Size, controls: &[Setting], caption: &Caption<'_>,
    ) {
        if self.hidden {
            return;
        }
        let layout = Layout::new(size);
        let mut canvas = Canvas { pixels, size, scale: layout.scale as usize };
        lines(&mut canvas, &layout, caption);
        if self.help {
            help(&mut canvas, &layout, caption.keys);
            return;
        }
        let shown = self.shown(&layout, controls.len());
        self.first = shown.start;
        let panel = layout.panel(COLUMNS, shown.len());
        canvas.dim(panel);
        for (row, index) in shown.clone().enumerate() {
            control(&mut canvas, &layout, row, &controls[index], index == self.selected);
        }
        if shown.len() < controls.len() {
            // How much of the list is shown, as on a scroll bar.
            let place =
                |index: usize| index as i32 * panel.size.height as i32 / controls.len() as i32;
            let (top, bottom) = (place(shown.start), place(shown.end));
            let left = panel.size.width as i32 - layout.margin() / 2;
            let bar = area(left, panel.top_left.y + top, layout.margin() / 2, bottom - top);
            canvas.fill(bar, FAINT);
        }
    }
}

/// The line at the top, and that at the bottom.
fn lines(canvas: &mut Canvas<'_>, layout: &Layout, caption: &Caption<'_>) {
    let Caption { name, concept, status, hint, .. } = caption;
    let bottom = layout.height - layout.line();
    canvas.dim(area(0, 0, layout.width, layout.line()));
    canvas.dim(area(0, bottom.max(layout.line()), layout.width, layout.line()));
    let top = layout.margin() / 2 + 1;
    let after = |text: &str| layout.left(text.chars().count() as i32 + 2);
    canvas.text(layout, layout.left(0), top, name, CHOSEN);
    canvas.text(layout, after(name), top, concept, TEXT);
    if bottom < layout.line() {
        return;
    }
    canvas.text(layout, layout.left(0), bottom + top, status, TEXT);
    let right = layout.width - layout.left(hint.chars().count() as i32);
    if right >= after(status) {
        canvas.text(layout, right, bottom + top, hint, FAINT);
    }
}

fn help(canvas: &mut Canvas<'_>, layout: &Layout, keys: &[(&str, &str)]) {
    let width = |texts: &mut dyn Iterator<Item = &str>| {
        texts.map(|text| text.chars().count()).max().unwrap_or(0) as i32
    };
    let column = width(&mut keys.iter().map(|(keys, _)| *keys)) + 2;
    let columns = column + width(&mut keys.iter().map(|(_, effect)| *effect));
    let rows = keys.len().min(layout.capacity());
    canvas.dim(layout.panel(columns, rows));
    for (row, (keys, effect)) in keys.iter().take(rows).enumerate() {
        canvas.text(layout, layout.left(0), layout.top(row), keys, CHOSEN);
        canvas.text(layout, layout.left(column), layout.top(row), effect, TEXT);
    }
}

fn control(
    canvas: &mut Canvas<'_>, layout: &Layout, row: usize, control: &Setting, selected: bool,
) {
    let top = layout.top(row);
    let (text, bar) = if selected { (CHOSEN, CHOSEN) } else { (TEXT, BAR) };
    if selected {
        let width = COLUMNS * layout.column() + 2 * layout.margin();
        canvas.dim(area(0, top, width, layout.row()));
        canvas.fill(area(0, top, layout.margin() / 2, layout.row()), CHOSEN);
    }
    canvas.text(layout, layout.left(NAME), top + 1, &control.name, text);
    canvas.text(layout, layout.left(VALUE), top + 1, &control.text, text);
    let (left, right) = (layout.left(SLIDER), layout.left(VALUE - 1));
    let (top, height) = (top + layout.row() / 3, layout.row() / 3);
    canvas.fill(area(left, top, right - left, height), GROOVE);
    let length = (control.fraction * (right - left) as f32).round() as i32;
    canvas.fill(area(left, top, length, height), bar);
    // The handle: what is taken hold of, and seen where the value is the range's start.
    let handle = area(left + length - layout.margin() / 2, top - 2, layout.margin(), height + 4);
    canvas.fill(handle, text);
}

/// A ring around the pixel (`col`, `row`), which itself stays as it is.
pub(crate) fn mark(pixels: &mut [u32], size: Size, col: usize, row: usize) {
    let thick = Layout::new(size).scale;
    let mut canvas = Canvas { pixels, size, scale: 1 };
    let center = Point::new(col as i32, row as i32);
    for (radius, color, width) in [(7, Rgb888::BLACK, 4), (7, CHOSEN, 2)] {
        let circle = Circle::with_center(center, (2 * radius * thick + 1) as u32);
        let style = PrimitiveStyle::with_stroke(color, (width * thick) as u32);
        let Ok(()) = circle.into_styled(style).draw(&mut canvas);
    }
}

/// A window's pixels, of which `scale` × `scale` make one of the drawing.
struct Canvas<'a> {
    pixels: &'a mut [u32],
    size: Size,
    scale: usize,
}

impl Canvas<'_> {
    /// The rows of pixels that `area` covers.
    fn rows(&mut self, area: &Rectangle) -> impl Iterator<Item = &mut [u32]> {
        let area = area.intersection(&self.bounding_box());
        let (width, scale) = (self.size.width(), self.scale);
        let Point { x, y } = area.top_left;
        let left = (x.max(0) as usize * scale).min(width);
        let top = y.max(0) as usize * scale;
        let right = (left + area.size.width as usize * scale).min(width);
        let bottom = top + area.size.height as usize * scale;
        let rows = self.pixels.chunks_exact_mut(width).take(bottom).skip(top);
        rows.map(move |row| &mut row[left..right])
    }

    /// Darkens what is there, so that text can be read on it.
    fn dim(&mut self, area: Rectangle) {
        for row in self.rows(&area) {
            row.iter_mut().for_each(|pixel| {
                *pixel = ((*pixel >> 2) & 0x3f_3f_3f) + ((*pixel >> 3) & 0x1f_1f_1f);
            });
        }
    }

    fn fill(&mut self, area: Rectangle, color: Rgb888) {
        let Ok(()) = self.fill_solid(&area, color);
    }

    fn text(&mut self, layout: &Layout, left: i32, top: i32, text: &str, color: Rgb888) {
        let style = MonoTextStyle::new(layout.font, color);
        let text = Text::with_baseline(text, Point::new(left, top), style, Baseline::Top);
        let Ok(_) = text.draw(self);
    }
}

impl OriginDimensions for Canvas<'_> {
    fn size(&self) -> Extent {
        let units = |pixels: usize| pixels.div_ceil(self.scale) as u32;
        Extent::new(units(self.size.width()), units(self.size.height()))
    }
}

impl DrawTarget for Canvas<'_> {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(
        &mut self, pixels: I,
    ) -> Result<(), Infallible> {
        for Pixel(point, color) in pixels {
            self.fill_solid(&Rectangle::new(point, Extent::new_equal(1)), color)?;
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb888) -> Result<(), Infallible> {
        let color = color.into_storage();
        self.rows(area).for_each(|row| row.fill(color));
        Ok(())
    }
}
