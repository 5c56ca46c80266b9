//! A figure: the same lesson several times side by side, each with one thing changed.

mod canvas;
mod plot;

use crate::Camera;
use crate::Color;
use crate::Control;
use crate::Explanation;
use crate::Image;
use crate::Pixel;
use crate::Ray;
use crate::Size;
use crate::Step;
use crate::View;
use crate::explanation::Entry;

pub use canvas::Canvas;

/// Panels in a grid, each with a label. It is a [`Step`] itself, so that it has a window, a
/// command line and controls as any step has; the control `panel` shows one of them alone.
pub struct Figure<L> {
    lesson: L,
    view: View,
    controls: &'static [&'static str],
    columns: usize,
    aspect: f32,
    panels: Vec<Panel<L>>,
    shown: usize,
}

type Change<L> = dyn Fn(&mut L) + Sync;
type Draw<L> = dyn Fn(&L, &mut Canvas<'_>) + Sync;

struct Panel<L> {
    label: String,
    change: Box<Change<L>>,
    draw: Box<Draw<L>>,
}

/// Where a panel's picture lies in the figure, in pixels.
struct Place {
    left: usize,
    top: usize,
    width: usize,
    height: usize,
}

/// The part of a camera's plane that a panel shows: all of the figure's height, and of its width
/// as much as fits, but never less than a picture of the shape `aspect` would.
struct PanelCamera<'a> {
    camera: &'a dyn Camera,
    horizontal: f32,
    vertical: f32,
}

impl Camera for PanelCamera<'_> {
    fn generate_ray(&self, u: f32, v: f32) -> Ray {
        let (u, v) = (self.horizontal * (u - 0.5), self.vertical * (v - 0.5));
        self.camera.generate_ray(0.5 + u, 0.5 + v)
    }
}

impl<L: Step + Clone> Figure<L> {
    /// A figure of `lesson` with `columns` panels in a row, each of the shape of the lecture's
    /// pictures.
    pub fn new(lesson: L, columns: usize) -> Self {
        let view = lesson.view();
        let aspect = Size::DEFAULT.aspect();
        let panels = Vec::new();
        Self { lesson, view, controls: &[], columns, aspect, panels, shown: 0 }
    }

    /// Seen from there, instead of from where the lesson is.
    pub fn view(self, view: View) -> Self {
        Self { view, ..self }
    }

    /// The width of a panel's picture over its height.
    pub fn aspect(self, aspect: f32) -> Self {
        Self { aspect, ..self }
    }

    /// Which of the lesson's controls the figure has.
    pub fn controls(self, controls: &'static [&'static str]) -> Self {
        Self { controls, ..self }
    }

    /// Adds a panel that shows the lesson after `change`.
    pub fn vary(self, label: impl Into<String>, change: impl Fn(&mut L) + Sync + 'static) -> Self {
        self.panel(label, change, |lesson, canvas| canvas.show(lesson))
    }

    /// Adds a panel that `draw` fills.
    pub fn draw(
        self, label: impl Into<String>, draw: impl Fn(&L, &mut Canvas<'_>) + Sync + 'static,
    ) -> Self {
        self.panel(label, |_| (), draw)
    }

    /// Adds a panel that `draw` fills with the lesson after `change`.
    pub fn panel(
        mut self, label: impl Into<String>, change: impl Fn(&mut L) + Sync + 'static,
        draw: impl Fn(&L, &mut Canvas<'_>) + Sync + 'static,
    ) -> Self {
        let (label, change, draw) = (label.into(), Box::new(change), Box::new(draw));
        self.panels.push(Panel { label, change, draw });
        self
    }

    /// The size at which all panels have the figure's shape.
    pub fn size(&self) -> Size {
        let width = Size::DEFAULT.width();
        let Place { left, top, .. } = self.place(0, width, width);
        let (gap, label) = (2 * left, top - left);
        let panel = (width / self.columns - gap) as f32 / self.aspect;
        let height = self.rows() * (panel as usize + gap + label);
        Size::new(width, height).unwrap_or(Size::DEFAULT)
    }

    fn rows(&self) -> usize {
        self.panels.len().div_ceil(self.columns)
    }

    /// How many pixels of a picture that is `width` wide are a pixel of the labels' font.
    fn magnification(&self, width: usize) -> f32 {
        let longest = self.panels.iter().map(|panel| panel.label.chars().count()).max();
        let letters = self.columns * (longest.unwrap_or(0) + 1);
        let fits = width as f32 / (canvas::GLYPH.0 * letters) as f32;
        canvas::magnification(fits.min(width as f32 / 480.0))
    }

    fn place(&self, index: usize, width: usize, height: usize) -> Place {
        if self.shown > 0 {
            return Place { left: 0, top: 0, width, height };
        }
        let margin = width / 480;
        let label = canvas::text_size(self.magnification(width), "").1 + 2 * margin;
        let (cell_width, cell_height) = (width / self.columns, height / self.rows());
        Place {
            left: index % self.columns * cell_width + margin,
            top: index / self.columns * cell_height + margin + label,
            width: cell_width.saturating_sub(2 * margin),
            height: cell_height.saturating_sub(2 * margin + label),
        }
    }

    /// The panels that can be seen, and where.
    fn places(&self, width: usize, height: usize) -> impl Iterator<Item = (&Panel<L>, Place)> {
        let panels = self.panels.iter().enumerate();
        panels
            .filter(|(index, _)| [0, index + 1].contains(&self.shown))
            .map(move |(index, panel)| (panel, self.place(index, width, height)))
            .filter(|(_, place)| place.width > 0 && place.height > 0)
    }

    fn camera<'a>(
        &self, camera: &'a dyn Camera, (width, height): (usize, usize), place: &Place,
    ) -> PanelCamera<'a> {
        let aspect = place.width as f32 / place.height as f32;
        let vertical = if self.shown > 0 { 1.0 } else { (self.aspect / aspect).max(1.0) };
        let horizontal = vertical * aspect * height as f32 / width as f32;
        PanelCamera { camera, horizontal, vertical }
    }

    fn changed(&self, panel: &Panel<L>) -> L {
        let mut lesson = self.lesson.clone();
        (panel.change)(&mut lesson);
        lesson
    }
}

impl<L: Step + Clone> Step for Figure<L> {
    fn view(&self) -> View {
        self.view.clone()
    }

    fn controls(&mut self) -> Vec<Control<'_>> {
        let mut controls = vec![Control::count("panel", 0..=self.panels.len(), &mut self.shown)];
        let known = self.lesson.controls().into_iter();
        controls.extend(known.filter(|control| self.controls.contains(&control.name.as_str())));
        controls
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        let size = (image.width(), image.height());
        let magnification = self.magnification(size.0);
        let mut whole = Canvas::new(camera, size, image.rows(), magnification);
        for (panel, place) in self.places(size.0, size.1) {
            if self.shown == 0 {
                let center = place.left + place.width / 2;
                let bottom = place.top - size.0 / 480;
                whole.write(center as f32, bottom as f32, (0.5, 1.0), Color::ONE, &panel.label);
            }
            let rows = image.rows();
            let below = place.top + place.height;
            let rows = rows.start.clamp(place.top, below)..rows.end.clamp(place.top, below);
            if rows.is_empty() {
                continue;
            }
            let camera = self.camera(camera, size, &place);
            let rows = rows.start - place.top..rows.end - place.top;
            let mut canvas = Canvas::new(&camera, (place.width, place.height), rows, magnification);
            (panel.draw)(&self.changed(panel), &mut canvas);
            whole.paste(&canvas, place.left, place.top);
        }
        whole.copy_to(image);
    }

    /// What the lesson says of the pixel that is there in the panel.
    fn explain(&self, camera: &dyn Camera, pixel: Pixel) -> Explanation {
        let Pixel { col, row, width, height } = pixel;
        let mut pixels = vec![Color::ZERO; width];
        self.render(camera, &mut Image::new(width, height, row, &mut pixels));
        let mut explanation = Explanation::new(pixel, pixels[col]);
        for (panel, place) in self.places(width, height) {
            let (col, row) = (col.wrapping_sub(place.left), row.wrapping_sub(place.top));
            if col < place.width && row < place.height {
                explanation.heading(&panel.label);
                let camera = self.camera(camera, (width, height), &place);
                let pixel = Pixel { col, row, width: place.width, height: place.height };
                for entry in self.changed(panel).explain(&camera, pixel).entries() {
                    match entry {
                        Entry::Heading(text) => explanation.heading(text),
                        Entry::Equation(equation, value) => {
                            explanation.line(equation, value.clone());
                        }
                    }
                }
            }
        }
        explanation
    }
}
