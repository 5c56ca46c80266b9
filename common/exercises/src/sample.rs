//! Pixels of pictures that should be equal, enough of them to tell what makes these differ.

use image::RgbImage;

use crate::shot::Shot;
use show::TOLERANCE;
use show::off;

/// Two pictures that should be equal, and how the one expected was made.
pub struct Pair<'a> {
    /// What was expected.
    pub shot: Shot<'a>,
    /// How many times its light both have: below 0 where what is darker than black is looked at.
    pub times: f32,
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

    /// What was expected here.
    pub(crate) fn expected(&self) -> [u8; 3] {
        self.pair.expected.get_pixel(self.col, self.row).0
    }
}

/// Some pixels of a pair, evenly from all that differ and from all others.
struct Part<'a> {
    differing: Vec<Place<'a>>,
    equal: Vec<Place<'a>>,
}

/// Some hundred pixels, some of each pair.
pub(crate) struct Sample<'a>(Vec<Part<'a>>);

/// How many pixels are looked at, of those that differ and of all others; and at least of each pair.
const DIFFERING: usize = 600;
const EQUAL: usize = 400;
const LEAST: usize = 12;

/// How many are enough for a first look.
const FEW: usize = 40;

impl<'a> Sample<'a> {
    /// None when too few differ to tell anything.
    pub(crate) fn new(pairs: &'a [Pair<'a>]) -> Option<Self> {
        let differ = |off: u8| off > TOLERANCE;
        let agree = |off: u8| off <= TOLERANCE;
        let total =
            |is_it: &dyn Fn(u8) -> bool| pairs.iter().map(|pair| places(pair, is_it).count()).sum();
        let [differing, equal]: [usize; 2] = [total(&differ), total(&agree)];
        let part = |pair| Part {
            differing: sample(pair, DIFFERING, differing, &differ),
            equal: sample(pair, EQUAL, equal, &agree),
        };
        (differing >= 4).then(|| Self(pairs.iter().map(part).collect()))
    }

    pub(crate) fn places(&self) -> impl Iterator<Item = &Place<'a>> {
        self.0.iter().flat_map(|part| part.differing.iter().chain(&part.equal))
    }

    /// Whether each picture that is seen is all black or all white: nearly anything leads to that.
    pub(crate) fn is_blank(&self) -> bool {
        // Those that do not differ tell what it is not.
        let is_seen = |part: &&Part<'_>| {
            part.differing.iter().chain(&part.equal).any(|place| place.pair.times == 1.0)
        };
        let seen = || self.0.iter().filter(is_seen);
        seen().count() > 0
            && seen().all(|part| {
                let mut found = part.differing.iter().chain(&part.equal).map(Place::found);
                let first = found.next().unwrap_or_default();
                [[0; 3], [255; 3]].contains(&first) && found.all(|other| other == first)
            })
    }

    /// Some of its places that differ, for a first look.
    pub(crate) fn some(&self) -> impl Iterator<Item = &Place<'a>> {
        let differing = || self.0.iter().flat_map(|part| &part.differing);
        differing().step_by(differing().count().div_ceil(FEW))
    }

    /// Whether most of [some](Self::some) are found as `pixel` has them.
    pub(crate) fn may_fit(&self, pixel: impl Fn(&Place<'_>) -> [u8; 3]) -> bool {
        let misfits = self.some().filter(|place| off(pixel(place), place.found()) > TOLERANCE);
        misfits.take(1 + FEW / 8).count() <= FEW / 8
    }

    /// How many pixels are not found as `pixel` has them; none if that is, in a picture or in all of
    /// them, more than one in `part` of those that differ, or more than one in five times `part` of the
    /// others. What is only right of all pictures taken together is no explanation.
    pub(crate) fn misfits(
        &self, part: usize, pixel: impl Fn(&Place<'_>) -> [u8; 3],
    ) -> Option<usize> {
        let count = |places: &[Place<'_>], part: usize| {
            let misfits =
                places.iter().filter(|place| off(pixel(place), place.found()) > TOLERANCE);
            // On a silhouette the last bit of a number may decide.
            let most = places.len() / part + 1;
            let misfits = misfits.take(most + 1).count();
            (misfits <= most).then_some(misfits)
        };
        let mut all = [(0, 0); 2];
        // Most mistakes fail in the first picture that differs.
        for Part { differing, equal } in &self.0 {
            for (places, part, sum) in [(differing, part, 0), (equal, 5 * part, 1)] {
                all[sum].0 += count(places, part)?;
                all[sum].1 += places.len();
            }
        }
        let [(differing, of), (equal, of_equal)] = all;
        (differing <= of / part && equal <= of_equal / (5 * part)).then_some(differing + equal)
    }

    /// By how many misfits one explanation has to be better than another to be the only one.
    pub(crate) fn margin(&self) -> usize {
        self.0.iter().map(|part| part.differing.len()).sum::<usize>() / 100
    }
}

/// The places where the pictures are so far off.
fn places<'a>(pair: &'a Pair<'a>, is_it: impl Fn(u8) -> bool) -> impl Iterator<Item = Place<'a>> {
    let pixels = pair.expected.enumerate_pixels().zip(pair.found.pixels());
    let off = pixels.filter(move |((_, _, a), b)| is_it(off(a.0, b.0)));
    off.map(move |((col, row, _), _)| Place { pair, col, row })
}

/// Some of these places: this pair's share of `most` if all pairs have `total`.
fn sample<'a>(
    pair: &'a Pair<'a>, most: usize, total: usize, is_it: &dyn Fn(u8) -> bool,
) -> Vec<Place<'a>> {
    let count = places(pair, is_it).count();
    let share = (most * count).div_ceil(total.max(1)).max(LEAST);
    places(pair, is_it).step_by((count / share).max(1)).collect()
}
