//! Whether other settings of the same step explain a picture as well.

use crate::mistake::pixel;
use crate::sample::Place;
use crate::sample::Sample;
use crate::shot::Shot;
use show::Setting;
use show::Setup;
use show::Size;
use show::text;

/// How many values of a control are tried at first, and how often the best of them is made better.
const COARSE: usize = 32;
const FINER: usize = 14;

/// One pixel in so many that differ may stay unexplained: other settings fit nearly anything.
const PART: usize = 50;

/// What a sample was taken of, and how.
pub(crate) struct Settings<'a> {
    pub(crate) setup: &'a Setup,
    pub(crate) size: Size,
    /// The square root of the number of rays a pixel.
    pub(crate) samples: usize,
    pub(crate) sample: &'a Sample<'a>,
}

impl Settings<'_> {
    /// With which settings the picture would match, if there are such.
    pub(crate) fn others(&self) -> Option<String> {
        let mut start = self.setup.copied();
        start.reset_all();
        if !self.setup.settings().is_empty() && self.fits(&start) {
            return Some(text!("Without --set it would match").to_owned());
        }
        let fits = |samples: &usize| Self { samples: *samples, ..*self }.fits(self.setup);
        let mut others = [1, 2, 3, 4, 8].into_iter().filter(|samples| *samples != self.samples);
        if let Some(samples) = others.find(fits) {
            return Some(text!("With --samples {samples} it would match", samples));
        }
        let settings = self.setup.list();
        let mut fitting = settings.iter().filter_map(|setting| self.other(setting));
        fitting.next().map(|setting| text!("With --set {setting} it would match", setting))
    }

    /// The value of one control with which the picture would match, as NAME=VALUE.
    fn other(&self, setting: &Setting) -> Option<String> {
        let Setting { name, control, .. } = setting;
        let last = control.options().len().saturating_sub(1);
        let with = |fraction: f32| {
            let mut other = self.setup.copied();
            other.set_fraction(name, fraction);
            other
        };
        let values = if last > 0 { last } else { COARSE };
        let at = |index: usize| index as f32 / values as f32;
        let distance = |fraction: f32| self.distance(&with(fraction));
        let (mut least, mut best) =
            (0..=values).map(|index| (distance(at(index)), at(index))).min_by_key(|it| it.0)?;
        let mut stride = at(1);
        for _ in 0..if last > 0 { 0 } else { FINER } {
            stride /= 2.0;
            for near in [best - stride, best + stride].map(|near| near.clamp(0.0, 1.0)) {
                let off = distance(near);
                if off < least {
                    (least, best) = (off, near);
                }
            }
        }
        if last > 0 {
            return self.fits(&with(best)).then(|| value_of(&with(best), name))?;
        }
        // In as few digits as do: somebody has typed it.
        let number = value_of(&with(best), name)?.split_once('=')?.1.parse::<f64>().ok()?;
        let rounded = (1..6).map(|digits| format!("{:.*e}", digits - 1, number));
        let mut typed = rounded.filter_map(|text| {
            let mut other = self.setup.copied();
            other.set(name, &text).ok()?;
            self.fits(&other).then(|| value_of(&other, name))?
        });
        typed.next()
    }

    fn fits(&self, setup: &Setup) -> bool {
        self.seen(setup, |pixel| self.sample.misfits(PART, pixel).is_some())
    }

    /// How far off some pixels are, all in all.
    fn distance(&self, setup: &Setup) -> u32 {
        self.seen(setup, |pixel| {
            let off = |place: &Place<'_>| {
                let both = pixel(place).into_iter().zip(place.found());
                both.map(|(a, b)| u32::from(a.abs_diff(b))).sum::<u32>()
            };
            self.sample.some().map(off).sum()
        })
    }

    /// What `of` makes of the pixels that are seen as `setup` has it.
    fn seen<T>(&self, setup: &Setup, of: impl FnOnce(&dyn Fn(&Place<'_>) -> [u8; 3]) -> T) -> T {
        let camera = setup.view().camera(self.size.aspect());
        let shot = Shot::right(setup, &*camera, self.size, self.samples);
        of(&|place| pixel(&[], &shot, 1.0, place.col, place.row))
    }
}

/// `name` and its value, as it is typed.
fn value_of(setup: &Setup, name: &str) -> Option<String> {
    let setting = setup.list().into_iter().find(|setting| setting.name == name)?;
    Some(format!("{name}={}", setting.control.exact()))
}
