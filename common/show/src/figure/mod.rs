//! A figure: the same lesson several times side by side, each with one thing changed.

mod sketch;

use std::ops::RangeInclusive;
use std::rc::Rc;

use crate::Area;
use crate::Canvas;
use crate::Ink;
use crate::Program;
use crate::Shown;
use crate::Sight;
use crate::Size;
use crate::control::AXES;
use crate::prose::draw_caption;
use crate::translated;
use common::Adjustable;
use common::Camera;
use common::Color;
use common::Controls;
use common::Image;
use common::Kind;
use common::Listener;
use common::Pixel;
use common::Ray;
use common::Step;
use common::Tell;
use common::Value;
use common::Vec3;
use common::View;
use telling::Recorder;

pub use sketch::Axes;
pub use sketch::Sketch;

/// What is behind and between the panels.
const GROUND: Color = Color::new(0.012, 0.014, 0.02);

/// Panels in a grid, each with a label. It is a [`Step`] itself, so that it has a window, a
/// command line and controls as any step has; the control `panel` shows one of them alone.
pub struct Figure<L> {
    lesson: L,
    view: View,
    controls: &'static [&'static str],
    slider: Option<Slider<L>>,
    columns: usize,
    aspect: f32,
    panels: Vec<Panel<L>>,
    shown: usize,
}

struct Slider<L> {
    name: &'static str,
    range: RangeInclusive<f32>,
    value: f32,
    change: fn(&mut L, f32, &dyn Camera),
}

type Label<L> = dyn Fn(&L) -> String + Sync;
type Change<L> = dyn Fn(&mut L) + Sync;
type Render<L> = dyn Fn(&L, &dyn Camera, &mut Image<'_>) + Sync;
type Draw<L> = dyn Fn(&L, &mut Sketch<'_>) + Sync;

struct Panel<L> {
    label: Box<Label<L>>,
    change: Box<Change<L>>,
    render: Box<Render<L>>,
    draw: Box<Draw<L>>,
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

    fn project(&self, point: Vec3) -> Option<(f32, f32)> {
        let (u, v) = self.camera.project(point)?;
        Some((0.5 + (u - 0.5) / self.horizontal, 0.5 + (v - 0.5) / self.vertical))
    }
}

/// Shows the controls with these names alone.
struct Only<'a> {
    names: &'static [&'static str],
    to: &'a mut dyn Controls,
}

impl Controls for Only<'_> {
    fn group(&mut self, name: &'static str) {
        self.to.group(name);
    }

    fn group_of(&mut self, name: &'static str, kind: &'static str, which: &'static str) {
        self.to.group_of(name, kind, which);
    }

    fn visit(&mut self, name: &'static str, kind: Kind, value: &mut dyn Adjustable) {
        let is_named = |known: &str| match kind {
            Kind::Axis(axis, _) => known.split_once('.') == Some((name, AXES[axis])),
            _ => known == name,
        };
        if self.names.iter().any(|known| is_named(known)) {
            self.to.visit(name, kind, value);
        }
    }
}

/// The numbers that `compute` tells under these symbols; `None` unless it tells all of them.
pub fn told<const N: usize, T>(
    symbols: [&str; N], compute: impl FnOnce(&Recorder) -> T,
) -> Option<[f32; N]> {
    let recorder = Recorder::new(Pixel { col: 0, row: 0, width: 1, height: 1 });
    compute(&recorder);
    let said = recorder.finish(Color::ZERO);
    let mut numbers = [0.0; N];
    for (number, symbol) in numbers.iter_mut().zip(symbols) {
        let Some(Value::Number(value)) = said.value(symbol) else { return None };
        *number = value;
    }
    Some(numbers)
}

/// Makes a figure's file a program: names what makes the figure, and says what it shows.
#[macro_export]
macro_rules! figure_main {
    ($figure:ident, $concept:literal) => {
        /// The figure as a program.
        pub(crate) fn program() -> $crate::Program {
            $crate::Program::figure(module_path!(), $concept, $figure)
        }

        #[cfg(not(target_family = "wasm"))]
        #[allow(dead_code, reason = "on the web page, a figure is no program of its own")]
        fn main() -> std::process::ExitCode {
            $crate::run(program(), std::env::args_os())
        }
    };
}

impl Program {
    /// The figure that `figure` makes, called as the last part of `path` is.
    #[doc(hidden)]
    pub fn figure<L: Tell + Clone + 'static>(
        path: &'static str, concept: &'static str, figure: fn() -> Figure<L>,
    ) -> Self {
        let name = path.rsplit("::").next().unwrap_or(path);
        let make = Rc::new(move || Box::new(figure()) as Box<dyn Shown>);
        Self { is_figure: true, ..Self::new(name, concept, figure().size(), make) }
    }
}

impl<L: Tell + Clone> Figure<L> {
    /// A figure of `lesson` with `columns` panels in a row, each of the shape of the lecture's
    /// pictures.
    pub fn new(lesson: L, columns: usize) -> Self {
        Self {
            view: lesson.view(),
            lesson,
            controls: &[],
            slider: None,
            columns,
            aspect: Size::DEFAULT.aspect(),
            panels: Vec::new(),
            shown: 0,
        }
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

    /// A control of the figure's own, which starts at `value`. What it changes in the lesson, which
    /// may depend on the camera, comes before the changes of the panels.
    pub fn slider(
        self, name: &'static str, range: RangeInclusive<f32>, value: f32,
        change: fn(&mut L, f32, &dyn Camera),
    ) -> Self {
        Self { slider: Some(Slider { name, range, value, change }), ..self }
    }

    /// Adds a panel that shows the lesson after `change`.
    pub fn panel(
        mut self, label: impl Into<String>, change: impl Fn(&mut L) + Sync + 'static,
    ) -> Self {
        let label = label.into();
        self.panels.push(Panel {
            label: Box::new(move |_| label.clone()),
            change: Box::new(change),
            render: Box::new(|lesson, camera, image| lesson.render(camera, image)),
            draw: Box::new(|_, _| ()),
        });
        self
    }

    /// What the panel added last has for a label, which may depend on the lesson.
    pub fn label(self, label: impl Fn(&L) -> String + Sync + 'static) -> Self {
        self.last(|panel| panel.label = Box::new(label))
    }

    /// What the panel added last shows instead of the lesson.
    pub fn render(self, render: impl Fn(&L, &dyn Camera, &mut Image<'_>) + Sync + 'static) -> Self {
        self.last(|panel| panel.render = Box::new(render))
    }

    /// What is drawn over the panel added last.
    pub fn draw(self, draw: impl Fn(&L, &mut Sketch<'_>) + Sync + 'static) -> Self {
        self.last(|panel| panel.draw = Box::new(draw))
    }

    fn last(mut self, change: impl FnOnce(&mut Panel<L>)) -> Self {
        if let Some(panel) = self.panels.last_mut() {
            change(panel);
        }
        self
    }

    /// The size at which all panels have the figure's shape, and their edges are those of pixels.
    pub fn size(&self) -> Size {
        let width = Size::DEFAULT.width();
        let panel = self.place(0, width as f32, width as f32);
        let cell = width as f32 / self.rows() as f32 - panel.height + panel.width / self.aspect;
        Size::new(width, self.rows() * cell.round() as usize).unwrap_or(Size::DEFAULT)
    }

    fn rows(&self) -> usize {
        self.panels.len().div_ceil(self.columns)
    }

    /// How large letters are in a figure that is `width` wide.
    fn text_size(&self, width: f32) -> f32 {
        width / 960.0 * if self.columns > 3 { 18.0 } else { 22.0 }
    }

    /// Where a panel's picture lies in the figure.
    fn place(&self, index: usize, width: f32, height: f32) -> Area {
        if self.shown > 0 {
            return Area::new(0.0, 0.0, width, height);
        }
        let (margin, label) = (width / 240.0, 1.5 * self.text_size(width));
        let (cell_width, cell_height) = (width / self.columns as f32, height / self.rows() as f32);
        Area::new(
            (index % self.columns) as f32 * cell_width + margin,
            (index / self.columns) as f32 * cell_height + label,
            cell_width - 2.0 * margin,
            cell_height - label - margin,
        )
    }

    /// The panels that can be seen: each with where it lies, its camera, and what it shows.
    fn panels<'a>(
        &'a self, camera: &'a dyn Camera, width: usize, height: usize,
    ) -> impl Iterator<Item = (&'a Panel<L>, Area, PanelCamera<'a>, L)> {
        let (width, height) = (width as f32, height as f32);
        let panels = self.panels.iter().enumerate();
        let seen = panels.filter(|(index, _)| [0, index + 1].contains(&self.shown));
        let placed = seen.map(move |(index, panel)| (panel, self.place(index, width, height)));
        placed.filter(|(_, area)| area.width >= 1.0 && area.height >= 1.0).map(
            move |(panel, area)| {
                let aspect = area.width / area.height;
                let vertical = if self.shown > 0 { 1.0 } else { (self.aspect / aspect).max(1.0) };
                let horizontal = vertical * aspect * height / width;
                let mut lesson = self.lesson.clone();
                if let Some(Slider { value, change, .. }) = &self.slider {
                    change(&mut lesson, *value, camera);
                }
                (panel.change)(&mut lesson);
                (panel, area, PanelCamera { camera, horizontal, vertical }, lesson)
            },
        )
    }
}

/// The columns and rows of a picture that `area` is of: first and number.
fn pixels(area: Area) -> [usize; 4] {
    let edges = [area.left, area.top, area.right(), area.bottom()];
    let [left, top, right, bottom] = edges.map(|edge| edge.round() as usize);
    [left, top, right - left, bottom - top]
}

impl<L: Tell + Clone> Step for Figure<L> {
    fn view(&self) -> View {
        self.view.clone()
    }

    fn controls(&mut self, to: &mut dyn Controls) {
        to.count("panel", 0..=self.panels.len(), &mut self.shown);
        if let Some(slider) = &mut self.slider {
            to.number(slider.name, slider.range.clone(), &mut slider.value);
        }
        self.lesson.controls(&mut Only { names: self.controls, to });
    }

    fn render(&self, camera: &dyn Camera, image: &mut Image<'_>) {
        let (width, height) = (image.width(), image.height());
        for row in image.rows() {
            for col in 0..width {
                image.set(col, row, GROUND);
            }
        }
        for (panel, area, camera, lesson) in self.panels(camera, width, height) {
            let [left, top, width, height] = pixels(area);
            let inside = |row: usize| row.clamp(top, top + height) - top;
            let rows = inside(image.rows().start)..inside(image.rows().end);
            let mut colors = vec![GROUND; width * rows.len()];
            let mut part = Image::new(width, height, rows.start, &mut colors);
            (panel.render)(&lesson, &camera, &mut part);
            for (row, colors) in rows.zip(colors.chunks_exact(width)) {
                for (col, color) in colors.iter().enumerate() {
                    image.set(left + col, top + row, *color);
                }
            }
        }
    }
}

/// What the lesson tells of the pixel that is there in the panel.
impl<L: Tell + Clone> Tell for Figure<L> {
    fn tell(&self, camera: &dyn Camera, pixel: Pixel, say: &impl Listener) -> Color {
        let Pixel { col, row, width, height } = pixel;
        for (_, area, camera, lesson) in self.panels(camera, width, height) {
            let [left, top, width, height] = pixels(area);
            let (col, row) = (col.wrapping_sub(left), row.wrapping_sub(top));
            if col < width && row < height {
                lesson.tell(&camera, Pixel { col, row, width, height }, say);
            }
        }
        let mut colors = vec![Color::ZERO; width];
        self.render(camera, &mut Image::new(width, height, row, &mut colors));
        colors[col]
    }
}

impl<L: Tell + Clone> Shown for Figure<L> {
    fn draw_over(&self, camera: &dyn Camera, canvas: &mut Canvas<'_>) {
        let Area { width, height, .. } = canvas.area();
        let size = self.text_size(width);
        for (panel, area, camera, lesson) in self.panels(camera, width as usize, height as usize) {
            let sight = Sight { step: &lesson, camera: &camera, area };
            (panel.draw)(&lesson, &mut Sketch::new(canvas.clipped(area), sight, size));
            if self.shown == 0 {
                let at = (area.left + area.width / 2.0, area.top - 0.75 * size);
                let label = (panel.label)(&lesson);
                draw_caption(canvas, at, size, Ink::WHITE, translated(&label), area.width);
            }
        }
    }
}
