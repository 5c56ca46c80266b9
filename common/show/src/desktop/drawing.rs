//! Pictures rendered on all cores: at once, or a slice of time after the other.

use std::mem;
use std::time::Duration;
use std::time::Instant;

use image::RgbImage;
use rayon::iter::IndexedParallelIterator;
use rayon::slice::ParallelSliceMut;

use crate::Canvas;
use crate::Frame;
use crate::Language;
use crate::Size;
use crate::Wanted;
use common::Camera;
use telling::AnyStep;

/// How long the picture is worked on before the window is looked after again.
const SLICE: Duration = Duration::from_millis(12);

/// How long the rows take that are rendered between two looks at the clock: for a draft, all of
/// them, unless they take much longer than was expected.
const BATCH: Duration = Duration::from_millis(4);
const DRAFT_BATCH: Duration = Duration::from_millis(50);

/// The coarsest grid has one ray for a square with sides of so many pixels.
const COARSEST: usize = 32;

/// A picture in the making, a slice of time after the other: first a draft on a grid so coarse
/// that it is there at once, then with a ray for every pixel, then with all samples.
pub struct Drawing {
    size: Size,
    samples: usize,
    camera: Box<dyn Camera>,
    picture: RgbImage,
    /// A ray a pixel of the draft's grid; no part of it is seen before it is whole.
    draft: RgbImage,
    /// The pass that is being rendered; none when all are done.
    pass: Option<Pass>,
    finished: Finished,
    /// How long a ray took in the last pass, in seconds.
    cost: f64,
}

/// What was done last.
#[derive(Clone, Copy, Debug)]
pub struct Finished {
    /// A square with sides of so many pixels has the same colour.
    pub grid: usize,
    /// The square root of the number of rays a pixel.
    pub samples: usize,
    /// How long it took.
    pub time: Duration,
}

#[derive(Clone, Copy)]
struct Pass {
    /// A square with sides of so many pixels has the same colour.
    grid: usize,
    samples: usize,
    row: usize,
    time: Duration,
    draft: bool,
}

impl Pass {
    fn new(grid: usize, samples: usize, draft: bool) -> Self {
        Self { grid, samples, row: 0, time: Duration::ZERO, draft }
    }

    fn size(&self, full: Size) -> Size {
        let coarse = |pixels: usize| pixels.div_ceil(self.grid);
        // At least one pixel, and no more than the full size has.
        Size::new(coarse(full.width()), coarse(full.height())).unwrap_or(full)
    }

    fn rays_per_row(&self, full: Size) -> usize {
        self.size(full).width() * self.samples * self.samples
    }
}

impl Drawing {
    /// A black picture, of which the first pass shall take no longer than `draft`.
    pub fn new(size: Size, samples: usize, camera: Box<dyn Camera>, draft: Duration) -> Self {
        let mut drawing = Self {
            size,
            samples,
            camera,
            picture: black(size),
            draft: black(size),
            pass: None,
            finished: Finished { grid: 1, samples, time: Duration::ZERO },
            cost: 1e-6,
        };
        drawing.start(draft);
        drawing
    }

    /// The square root of the number of rays a pixel.
    pub(crate) fn samples(&self) -> usize {
        self.samples
    }

    /// As much of the picture as there is.
    pub fn picture(&self) -> &RgbImage {
        &self.picture
    }

    /// As much of the picture as there is.
    pub fn into_picture(self) -> RgbImage {
        self.picture
    }

    /// What was done last.
    pub fn finished(&self) -> Finished {
        self.finished
    }

    /// Whether there is nothing left to be done.
    pub fn is_complete(&self) -> bool {
        self.pass.is_none()
    }

    /// Whether the picture is still the one before, soon to be replaced.
    pub fn is_drafting(&self) -> bool {
        self.pass.is_some_and(|pass| pass.draft)
    }

    /// Starts again, as something was changed; the first pass shall take no longer than `draft`.
    pub fn restart(&mut self, size: Size, camera: Box<dyn Camera>, draft: Duration) {
        if let Some(pass) = self.pass {
            self.learn(&pass);
        }
        self.size = size;
        self.camera = camera;
        self.start(draft);
    }

    fn start(&mut self, draft: Duration) {
        let size = self.size;
        let affordable = draft.as_secs_f64() / self.cost;
        let is_affordable = |grid: &usize| {
            let coarse = Pass::new(*grid, 1, true).size(size);
            (coarse.width() * coarse.height()) as f64 <= affordable
        };
        let grid = (1..COARSEST).find(is_affordable).unwrap_or(COARSEST);
        let pass = Pass::new(grid, 1, true);
        self.draft = black(pass.size(size));
        self.pass = Some(pass);
    }

    /// Renders for a slice of time, or until a pass is done; whether one was.
    pub fn work(&mut self, wanted: &Wanted<'_>) -> bool {
        let start = Instant::now();
        while let Some(mut pass) = self.pass {
            self.batch(wanted.step(), &mut pass);
            if pass.row == pass.size(self.size).height() {
                if pass.draft {
                    self.enlarge();
                }
                wanted.draw_over(&mut self.picture);
                self.finish(pass);
                return true;
            }
            self.pass = Some(pass);
            if start.elapsed() > SLICE {
                break;
            }
        }
        false
    }

    fn batch(&mut self, step: &dyn AnyStep, pass: &mut Pass) {
        let start = Instant::now();
        let size = pass.size(self.size);
        let row_cost = self.cost * pass.rays_per_row(self.size) as f64;
        let batch = if pass.draft { DRAFT_BATCH } else { BATCH };
        let rows = (batch.as_secs_f64() / row_cost) as usize;
        let frame = Frame { step, camera: &*self.camera, size, samples: pass.samples };
        let picture = if pass.draft { &mut self.draft } else { &mut self.picture };
        let band = frame.rows_at_a_time();
        let count = rows.max(rayon::current_num_threads()).div_ceil(band);
        let bands = picture.par_chunks_mut(3 * size.width() * band).enumerate();
        let bands = bands.skip(pass.row / band).take(count);
        on_all_cores(bands, |(index, rgb)| frame.render_rows(index * band, rgb));
        pass.time += start.elapsed();
        pass.row = (pass.row + count * band).min(size.height());
    }

    /// Makes the whole draft the picture.
    fn enlarge(&mut self) {
        if self.draft.dimensions() == (self.size.width() as u32, self.size.height() as u32) {
            return mem::swap(&mut self.picture, &mut self.draft);
        }
        self.picture = black(self.size);
        let mut canvas = Canvas::new(&mut self.picture);
        let area = canvas.area();
        canvas.picture(&self.draft, area);
    }

    fn finish(&mut self, pass: Pass) {
        let Pass { grid, samples, time, .. } = pass;
        self.learn(&pass);
        self.finished = Finished { grid, samples, time };
        self.pass = if grid > 1 {
            Some(Pass::new(1, 1, false))
        } else if samples < self.samples {
            Some(Pass::new(1, self.samples, false))
        } else {
            None
        };
    }

    /// Learns from a pass how long a ray takes: at once if it was faster than expected, and
    /// little by little if it was slower, which may have been for another program's sake.
    fn learn(&mut self, pass: &Pass) {
        let rays = pass.row * pass.rays_per_row(self.size);
        if rays > 0 {
            let cost = pass.time.as_secs_f64() / rays as f64;
            self.cost = cost.min(self.cost + (cost - self.cost) / 4.0);
        }
    }
}

fn black(size: Size) -> RgbImage {
    RgbImage::new(size.width() as u32, size.height() as u32)
}

/// Does `work` for each of `parts`, on all cores. Each thread speaks the language of the one that waits
/// for them: left to themselves they would speak English.
fn on_all_cores<P: IndexedParallelIterator>(parts: P, work: impl Fn(P::Item) + Sync) {
    let language = Language::spoken();
    parts.for_each(|part| {
        language.speak();
        work(part);
    });
}

/// The picture of `frame`, rendered on all cores. `done` is told a number of rows whenever that many
/// more are finished, by whichever thread finished them.
pub fn render_parallel(frame: &Frame<'_>, done: impl Fn(usize) + Sync) -> RgbImage {
    let mut picture = black(frame.size);
    let row = 3 * frame.size.width();
    // Small bands, because rows cost as much as what is seen in them.
    let rows = frame.rows_at_a_time().max(4);
    let bands = picture.par_chunks_mut(row * rows).enumerate();
    on_all_cores(bands, |(band, rgb)| {
        frame.render_rows(band * rows, rgb);
        done(rgb.len() / row);
    });
    picture
}
