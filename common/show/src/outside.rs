//! The camera seen from outside.

use crate::Area;
use crate::Canvas;
use crate::Frame;
use crate::Handle;
use crate::Ink;
use crate::Sight;
use crate::Size;
use crate::pen::Pen;
use crate::sight::first_hit;
use crate::sight::told_hit;
use crate::text;
use crate::vectors::draw_handles;
use crate::vectors::draw_marks;
use crate::vectors::marks;
use crate::vectors::symbol_ink;
use crate::vectors::unit;
use crate::vectors::viewing_ray;
use common::Camera;
use common::Pixel;
use common::Projection;
use common::Ray;
use common::Vec3;
use common::View;
use telling::AnyStep;
use telling::Explanation;

/// The camera seen from outside: its eye, its window of pixels with the picture on it, and its rays
/// in the scene.
///
/// A plain value without a clock or a thread.
#[derive(Clone, Copy)]
pub struct Outside<'a> {
    /// What both see.
    pub step: &'a dyn AnyStep,
    /// The camera that is seen.
    pub view: &'a View,
    /// From where it is seen: that of the view [`onlooker`](Self::onlooker) to begin with.
    pub onlooker: &'a dyn Camera,
    /// The area that is drawn on, and whose shape the camera's picture has too.
    pub area: Area,
}

/// How many columns of pixels the window has.
const COLUMNS: u32 = 24;

/// How much of the scene the picture on the window covers.
const COVER: u8 = 190;

/// What is behind the camera of a step in which nothing can be hit.
const EMPTY: Ink = Ink::grey(44);

const FRAME: Ink = Ink::grey(235);

/// The window in the world.
struct Window<'a> {
    camera: &'a dyn Camera,
    /// How far it is from the rays' origins.
    depth: f32,
    forward: Vec3,
    middle: Vec3,
    columns: u32,
    rows: u32,
}

impl Window<'_> {
    /// Where (u, v) is.
    fn at(&self, u: f32, v: f32) -> Vec3 {
        let ray = self.camera.generate_ray(u, v);
        ray.at(self.depth / ray.direction.dot(self.forward))
    }

    fn corners(&self) -> [Vec3; 4] {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(u, v)| self.at(u, v))
    }

    /// The middle of a coarse pixel, counted from the upper left one.
    fn pixel(&self, col: u32, row: u32) -> (f32, f32) {
        let part = |at: u32, all: u32| (at as f32 + 0.5) / all as f32;
        (part(col, self.columns), 1.0 - part(row, self.rows))
    }

    /// The (u, v) at which `ray` passes through it.
    fn crossed(&self, ray: &Ray) -> Option<(f32, f32)> {
        let t = (self.middle - ray.origin).dot(self.forward) / ray.direction.dot(self.forward);
        let (u, v) = self.camera.project(ray.at(t)).filter(|_| t > 0.0)?;
        let inside = (0.0..1.0).contains(&u) && (0.0..1.0).contains(&v);
        inside.then_some((u, v))
    }
}

/// Between which parts of the picture's width and height a window is wholly in sight, and how many
/// small steps the onlooker goes back at most until it is.
const IN_SIGHT: std::ops::RangeInclusive<f32> = 0.03..=0.97;
const FARTHER: usize = 30;

impl Outside<'_> {
    /// From where a camera is first seen from outside: from the side and behind, with all of it
    /// and what it looks at in sight.
    pub fn onlooker(view: &View) -> View {
        let (eye, target) = (view.eye(), view.target());
        let far = (eye - target).length().max(1e-3);
        // The parallel camera's window is as large as what it looks at.
        let (raised, away) = match view.projection {
            Projection::Perspective => (0.1, 1.55),
            Projection::Parallel => (0.0, 2.5),
        };
        let middle = eye.lerp(target, 0.5) + raised * far * Vec3::Y;
        let mut onlooker = View::new(middle + far * Vec3::Z, middle, 42.0);
        onlooker.azimuth = 0.0;
        onlooker.elevation = 0.0;
        onlooker.orbit(view.azimuth + 52.0, 22.0);
        onlooker.zoom(away);
        // All of the window is in sight.
        let aspect = Size::DEFAULT.aspect();
        let camera = view.camera(aspect);
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        let corners = corners.map(|(u, v)| camera.generate_ray(u, v).origin);
        let is_seen = |onlooker: &View, corner: &Vec3| {
            let at = onlooker.camera(aspect).project(*corner);
            at.is_some_and(|(u, v)| IN_SIGHT.contains(&u) && IN_SIGHT.contains(&v))
        };
        for _ in 0..FARTHER {
            if !corners.iter().all(|corner| is_seen(&onlooker, corner)) {
                onlooker.zoom(1.05);
            }
        }
        onlooker
    }

    /// Draws all of it over the picture of the step from the onlooker's camera, which is in
    /// `area` already; with what `explanation` tells, and `handles`.
    ///
    /// Letters are `text_size` high, in pixels, as [`Font`](crate::Font) tells. No label is `across`, if
    /// it can be helped; where all are.
    pub fn draw(
        &self, canvas: &mut Canvas<'_>, explanation: Option<&Explanation>, handles: &[Handle],
        text_size: f32, across: Option<Area>,
    ) -> Vec<Area> {
        let Area { width, height, .. } = self.area;
        let aspect = width / height;
        let camera = self.view.camera(aspect);
        let sight = Sight { step: self.step, camera: self.onlooker, area: self.area };
        let perspective = self.view.projection == Projection::Perspective;
        let depth = if perspective { 0.4 * self.view.distance } else { 0.0 };
        let ahead = camera.generate_ray(0.5, 0.5);
        let window = Window {
            camera: &*camera,
            depth,
            forward: ahead.direction,
            middle: ahead.at(depth),
            columns: COLUMNS,
            rows: ((COLUMNS as f32 / aspect).round() as u32).clamp(1, 4 * COLUMNS),
        };
        let somewhere = self.step.explain(&*camera, Pixel { col: 0, row: 0, width: 1, height: 1 });
        let told = |name| somewhere.scope(name).is_some();
        if !told("intersection") {
            canvas.fill(self.area, EMPTY);
        }
        let mut pen = Pen::new(canvas, sight, text_size);
        across.into_iter().for_each(|area| pen.keep(area));
        if !told("illumination") {
            draw_ground(&mut pen);
        }
        let ray = explanation.and_then(viewing_ray);
        self.draw_window(&mut pen, &window);
        if ray.is_none() || !perspective || !told("intersection") {
            self.draw_rays(&mut pen, &window, ray.is_some());
        }
        draw_handles(&mut pen, handles);
        if let Some((ray, explanation)) = ray.zip(explanation) {
            self.draw_viewing_ray(&mut pen, &window, &ray, explanation);
            draw_marks(&mut pen, &marks(explanation, unit(&sight, explanation)));
        }
        if perspective {
            pen.dot(self.view.eye(), 2.4, Ink::WHITE, text!("eye"));
        }
        let height = |corner: &Vec3| sight.at(*corner).map_or(f32::INFINITY, |at| at.1);
        let corners = window.corners();
        if let Some(highest) = corners.iter().min_by(|a, b| height(a).total_cmp(&height(b))) {
            pen.label(*highest, FRAME, text!("window"));
        }
        pen.finish()
    }

    /// The frame, the pixels, and the picture on them.
    fn draw_window(&self, pen: &mut Pen<'_>, window: &Window<'_>) {
        let [columns, rows] = [window.columns, window.rows];
        // The number of pixels is within all limits.
        if let Ok(size) = Size::new(columns as usize, rows as usize) {
            let frame = Frame { step: self.step, camera: window.camera, size, samples: 2 };
            let picture = frame.render();
            let covers: Vec<u8> = (0..columns * rows)
                .map(|cell| {
                    let (u, v) = window.pixel(cell % columns, cell / columns);
                    let hidden = pen.sight.is_hidden(window.at(u, v));
                    if hidden { COVER / 4 } else { COVER }
                })
                .collect();
            let (cols, rows_seen) = self.pixels_of(pen, window);
            for row in rows_seen {
                // Two at once: the edges between them are under the lines.
                for col in cols.clone().step_by(2) {
                    let at = (col as f32 + 1.0, row as f32 + 0.5);
                    let Some((u, v)) = window.crossed(&pen.sight.ray(at)) else { continue };
                    let cell_col = ((u * columns as f32) as u32).min(columns - 1);
                    let cell_row = (((1.0 - v) * rows as f32) as u32).min(rows - 1);
                    let [red, green, blue] = picture.get_pixel(cell_col, cell_row).0;
                    let cover = covers[(cell_row * columns + cell_col) as usize];
                    let ink = Ink::new(red, green, blue).with_alpha(cover);
                    pen.canvas().pixel(col, row, ink);
                    pen.canvas().pixel(col + 1, row, ink);
                }
            }
        }
        let grid = Ink::grey(200).with_alpha(90);
        for col in 1..columns {
            let u = col as f32 / columns as f32;
            pen.thin(window.at(u, 0.0), window.at(u, 1.0), grid);
        }
        for row in 1..rows {
            let v = row as f32 / rows as f32;
            pen.thin(window.at(0.0, v), window.at(1.0, v), grid);
        }
        let corners = window.corners();
        let width = 0.8 * pen.width();
        for (corner, next) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            pen.line(*corner, *next, width, FRAME);
            if self.view.projection == Projection::Perspective {
                pen.line(self.view.eye(), *corner, 0.6 * width, FRAME.with_alpha(150));
            }
        }
    }

    /// The columns and rows of the picture in which the window may be.
    fn pixels_of(
        &self, pen: &Pen<'_>, window: &Window<'_>,
    ) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
        let area = self.area;
        let corners = window.corners().map(|corner| pen.sight.at(corner));
        let range = |from: f32, to: f32, get: fn((f32, f32)) -> f32| {
            let places = || corners.iter().flatten().map(|at| get(*at));
            let (mut least, mut most) = (from, to);
            if corners.iter().all(Option::is_some) {
                least = places().fold(f32::INFINITY, f32::min).clamp(from, to);
                most = places().fold(f32::NEG_INFINITY, f32::max).clamp(from, to);
            }
            least.floor().max(0.0) as usize..most.ceil().max(0.0) as usize
        };
        (range(area.left, area.right(), |at| at.0), range(area.top, area.bottom(), |at| at.1))
    }

    /// Some of the many rays, as far as they go before they hit something.
    fn draw_rays(&self, pen: &mut Pen<'_>, window: &Window<'_>, faint: bool) {
        let ink = symbol_ink("d").unwrap_or(FRAME).with_alpha(if faint { 130 } else { 190 });
        let across = |part: u32, parts: u32, all: u32| (2 * part + 1) * all / (2 * parts);
        for (row, col) in (0..3).flat_map(|row| (0..5).map(move |col| (row, col))) {
            let col = across(col, 5, window.columns);
            let row = across(row, 3, window.rows);
            let (u, v) = window.pixel(col, row);
            let ray = window.camera.generate_ray(u, v);
            let end = first_hit(self.step, &ray).unwrap_or(1.15 * self.view.distance);
            pen.line(ray.origin, ray.at(end), 0.5 * pen.width(), ink);
            pen.dot(window.at(u, v), 0.6, ink.with_alpha(255), "");
        }
    }

    /// The ray through a pixel's centre to what it hits, and faintly beyond.
    fn draw_viewing_ray(
        &self, pen: &mut Pen<'_>, window: &Window<'_>, ray: &Ray, explanation: &Explanation,
    ) {
        let ink = symbol_ink("d").unwrap_or(FRAME);
        let hit = told_hit(explanation, ray);
        let beyond = hit.unwrap_or(0.0) + 1.3 * self.view.distance;
        let width = pen.width();
        pen.line(
            ray.origin,
            ray.at(beyond),
            0.5 * width,
            ink.with_alpha(if hit.is_some() { 110 } else { 220 }),
        );
        if let Some(t) = hit {
            pen.line(ray.origin, ray.at(t), width, ink);
        }
        let unit = unit(&pen.sight, explanation).min(0.25 * self.view.distance);
        pen.arrow(ray.origin, ray.at(unit), ink, "d");
        if let Some((u, v)) = window.camera.project(ray.at(hit.unwrap_or(1.0))) {
            pen.dot(window.at(u, v), 1.2, ink, "(u, v)");
        }
        pen.dot(ray.origin, 1.6, ink, "p");
        pen.label(ray.at(0.6 * hit.unwrap_or(beyond)), ink, text!("viewing ray"));
    }
}

/// The world's axes, and a ground of unit squares.
fn draw_ground(pen: &mut Pen<'_>) {
    let grid = Ink::grey(150).with_alpha(110);
    for at in -3..=3 {
        let at = at as f32;
        let width = 0.4 * pen.width();
        pen.line(Vec3::new(at, 0.0, -3.0), Vec3::new(at, 0.0, 3.0), width, grid);
        pen.line(Vec3::new(-3.0, 0.0, at), Vec3::new(3.0, 0.0, at), width, grid);
    }
    for (axis, name) in [(Vec3::X, "x"), (Vec3::Y, "y"), (Vec3::Z, "z")] {
        pen.arrow(Vec3::ZERO, 1.5 * axis, Ink::grey(190), name);
    }
}
