//! Pixels of pictures that should be equal, enough of them to tell what makes these differ.

use image::RgbImage;

use show::Frame;
use show::TOLERANCE;
use show::off;

/// Two pictures that should be equal, and how the one expected was made.
pub struct Pair<'a> {
    /// What was expected.
    pub frame: Frame<'a>,
    /// Its picture.
    pub expected: &'a RgbImage,
    /// The other picture, of the same size.
    pub found: &'a RgbImage,
}

/// A pixel of a pair: its column and row.
pub(crate) struct Place<'a> {
    pub(crate) pair: &'a Pair<'a>,
    pub(crate) col: u32,
    pub(crate) row: u32,
}

impl Place<'_> {
    /// What was found here.
    pub(crate) fn found(&self) -> [u8; 3] {
        self.pair.found.get_pixel(self.col, self.row).0
    }
}

/// Some hundred pixels, evenly from all that differ and from all others.
pub(crate) struct Sample<'a> {
    differing: Vec<Place<'a>>,
    equal: Vec<Place<'a>>,
}

impl<'a> Sample<'a> {
    /// None when too few differ to tell anything.
    pub(crate) fn new(pairs: &'a [Pair<'a>]) -> Option<Self> {
        let differing = sample(pairs, 600, |off| off > TOLERANCE);
        let equal = sample(pairs, 400, |off| off <= TOLERANCE);
        (differing.len() >= 4).then_some(Self { differing, equal })
    }

    pub(crate) fn places(&self) -> impl Iterator<Item = &Place<'a>> {
        self.differing.iter().chain(&self.equal)
    }

    /// How many pixels are not found as `pixel` has them; none if that is more than one in `part` of
    /// those that differ, or more than one in five times `part` of the others.
    pub(crate) fn misfits(
        &self, part: usize, pixel: impl Fn(&Place<'_>) -> [u8; 3],
    ) -> Option<usize> {
        let count = |places: &[Place<'_>], most: usize| {
            let misfits =
                places.iter().filter(|place| off(pixel(place), place.found()) > TOLERANCE);
            let misfits = misfits.take(most + 1).count();
            (misfits <= most).then_some(misfits)
        };
        let (differing, equal) = (&self.differing, &self.equal);
        Some(count(differing, differing.len() / part)? + count(equal, equal.len() / (5 * part))?)
    }

    /// By how many misfits one explanation has to be better than another to be the only one.
    pub(crate) fn margin(&self) -> usize {
        self.differing.len() / 100
    }
}

/// About `most` of the places where the pictures are so far off.
fn sample<'a>(pairs: &'a [Pair<'a>], most: usize, is_it: impl Fn(u8) -> bool) -> Vec<Place<'a>> {
    let places = || {
        pairs.iter().flat_map(|pair| {
            let pixels = pair.expected.enumerate_pixels().zip(pair.found.pixels());
            let off = pixels.filter(|((_, _, a), b)| is_it(off(a.0, b.0)));
            off.map(move |((col, row, _), _)| Place { pair, col, row })
        })
    };
    let stride = (places().count() / most).max(1);
    places().step_by(stride).collect()
}
