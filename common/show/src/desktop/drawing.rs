//! Pictures rendered on all cores: at once, or a slice of time after the other.

use std::mem;
use std::sync::Mutex;
use std::sync::MutexGuard;
use std::sync::PoisonError;
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering;
use std::time::Duration;
use std::time::Instant;

use image::RgbImage;

use crate::Canvas;
use crate::Frame;
use crate::Language;
use crate::Size;
use crate::Wanted;
use crate::frame::Band;
use common::Camera;

/// How long is rendered between two looks at keys and mouse: a finger is on a button for longer.
const BATCH: Duration = Duration::from_millis(8);

/// How long for a draft, which is to be whole before what is changed next begins another.
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
    /// What is left of it.
    left: Left,
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
    /// How many lines of rays are rendered.
    lines: usize,
    time: Duration,
    draft: bool,
}

impl Pass {
    fn new(grid: usize, samples: usize, draft: bool) -> Self {
        Self { grid, samples, lines: 0, time: Duration::ZERO, draft }
    }

    fn size(&self, full: Size) -> Size {
        let coarse = |pixels: usize| pixels.div_ceil(self.grid);
        // At least one pixel, and no more than the full size has.
        Size::new(coarse(full.width()), coarse(full.height())).unwrap_or(full)
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
            left: Left::default(),
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
        self.left = Left::default();
    }

    /// Renders for a while, or until a pass is done; whether one was.
    pub fn work(&mut self, wanted: &Wanted<'_>) -> bool {
        let Some(mut pass) = self.pass else { return false };
        let (start, size) = (Instant::now(), pass.size(self.size));
        let frame =
            Frame { step: wanted.step(), camera: &*self.camera, size, samples: pass.samples };
        let (picture, limit) = match pass.draft {
            true => (&mut self.draft, DRAFT_BATCH),
            false => (&mut self.picture, BATCH),
        };
        pass.lines += render(&frame, picture, &mut self.left, limit, |_| ());
        pass.time += start.elapsed();
        self.pass = Some(pass);
        let is_done = pass.lines == size.height() * pass.samples;
        if is_done {
            if pass.draft {
                self.enlarge();
            }
            wanted.draw_over(&mut self.picture);
            self.finish(pass);
        }
        is_done
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
        self.left = Left::default();
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
        let rays = pass.lines * pass.size(self.size).width() * pass.samples;
        if rays > 0 {
            let cost = pass.time.as_secs_f64() / rays as f64;
            self.cost = cost.min(self.cost + (cost - self.cost) / 4.0);
        }
    }
}

fn black(size: Size) -> RgbImage {
    RgbImage::new(size.width() as u32, size.height() as u32)
}

/// What is left of a picture: rows that were begun, and all from this one on.
#[derive(Default)]
struct Left {
    begun: Vec<Band>,
    row: usize,
}

impl Left {
    /// The rows to go on with, of which so many `lines` are rendered at a time.
    fn next(&mut self, frame: &Frame<'_>, lines: usize) -> Option<Band> {
        self.begun.pop().or_else(|| {
            let band = frame.band(self.row, lines)?;
            self.row = band.end;
            Some(band)
        })
    }
}

/// Renders on all cores into `picture` what is `left` of it. Each takes one line of rays after the other,
/// as long as there is time for as long a line again before the `limit`. Says how many lines that were;
/// `done` is told of a number of rows whenever that many more are finished, by whichever thread
/// finished them.
fn render(
    frame: &Frame<'_>, picture: &mut RgbImage, left: &mut Left, limit: Duration,
    done: impl Fn(usize) + Sync,
) -> usize {
    let (start, language) = (Instant::now(), Language::spoken());
    let (lines, bytes) = (frame.lines_at_a_time(), 3 * frame.size.width());
    let (picture, left, count) = (Mutex::new(picture), Mutex::new(left), AtomicUsize::new(0));
    let work = || {
        // A thread that is left to itself speaks English.
        language.speak();
        let (mut band, mut longest) = (None::<Band>, Duration::ZERO);
        // However late it is, something is rendered.
        while start.elapsed() + longest <= limit || count.load(Ordering::Relaxed) == 0 {
            let Some(mut it) = band.take().or_else(|| locked(&left).next(frame, lines)) else {
                break;
            };
            let begin = Instant::now();
            count.fetch_add(frame.go_on(&mut it), Ordering::Relaxed);
            longest = longest.max(begin.elapsed());
            if !frame.is_complete(&it) {
                band = Some(it);
                continue;
            }
            let (first, rows) = (bytes * it.first, it.end - it.first);
            // Not while another thread waits to put its own there.
            let mut rgb = vec![0; bytes * rows];
            frame.encode(&it, &mut rgb);
            locked(&picture).as_mut()[first..][..rgb.len()].copy_from_slice(&rgb);
            done(rows);
        }
        locked(&left).begun.extend(band);
    };
    rayon::scope(|scope| (0..rayon::current_num_threads()).for_each(|_| scope.spawn(|_| work())));
    count.into_inner()
}

fn locked<T>(shared: &Mutex<T>) -> MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The picture of `frame`, rendered on all cores. `done` is told a number of rows whenever that many
/// more are finished, by whichever thread finished them.
pub fn render_parallel(frame: &Frame<'_>, done: impl Fn(usize) + Sync) -> RgbImage {
    let mut picture = black(frame.size);
    render(frame, &mut picture, &mut Left::default(), Duration::MAX, done);
    picture
}
