//! What can be said of a solution by its pictures.

use std::fmt;

use crate::known;
use crate::milestone::Milestone;
use crate::mistake::Kind;
use crate::mistake::Mistake;
use crate::mistake::mistaken;
use crate::sample::Pair;
use crate::sample::Sample;
use show::text;

/// What makes pictures differ, as far as that is known.
#[derive(Debug, Default)]
pub struct Diagnosis {
    /// The milestone that is reached.
    pub milestone: Option<&'static Milestone>,
    /// The mistakes that explain the pictures too, the likeliest first.
    pub mistakes: Vec<&'static Mistake>,
    /// Whether nothing can be told, since each picture is all black or all white.
    pub is_blank: bool,
    /// Two mistakes that explain the pictures together, where none does alone.
    pub two: Option<[&'static Mistake; 2]>,
    /// A mistake on the way: with it the milestone is explained, and not without.
    pub but: Option<&'static Mistake>,
}

/// Of so many pixels that differ one may stay unexplained.
const PART: usize = 10;

/// Of so many one, where two mistakes may explain them: two fit more than one does.
const PART_OF_TWO: usize = 50;

/// Of so many one, where a milestone and one more mistake may explain them.
const HALF: usize = 2;

/// The most mistakes that are said, if any of them may be it.
const SAID: usize = 3;

impl Diagnosis {
    /// What explains how the pictures found differ, each of them: nine in ten of the pixels that do,
    /// nearly all of those that do not, and more than anything else that is known. Milestones are those
    /// of `step`.
    pub fn new(step: &str, pairs: &[Pair<'_>]) -> Self {
        let Some(sample) = Sample::new(pairs) else { return Self::default() };
        if sample.is_blank() {
            return Self { is_blank: true, ..Self::default() };
        }
        let milestones = || Milestone::ALL.iter().filter(|milestone| milestone.step == step);
        let reached = milestones().filter_map(|it| Some((it.misfits(&sample, PART, None)?, it)));
        let reached = reached.min_by_key(|(misfits, _)| *misfits);
        // What a step hands over is not encoded yet.
        let all: Vec<&Mistake> =
            known::all().filter(|it| step.is_empty() || !it.is_encoding()).collect();
        let misfits = |it: &&Mistake| sample.misfits(PART, |place| mistaken(&[*it], place));
        let known: Vec<(usize, &Mistake)> =
            all.iter().filter_map(|it| Some((misfits(it)?, *it))).collect();
        let counts = known.iter().map(|it| it.0).chain(reached.iter().map(|it| it.0));
        let Some(least) = counts.min() else {
            let on_the_way = Self::on_the_way(milestones(), &sample);
            return on_the_way.or_else(|| Self::of_two(&all, &sample)).unwrap_or_default();
        };
        let most = least + sample.margin();
        let mut mistakes: Vec<&Mistake> = Vec::new();
        // In the order in which they are listed: the likeliest first.
        for (_, mistake) in known.into_iter().filter(|(misfits, _)| *misfits <= most) {
            if mistakes.iter().all(|other| other.what != mistake.what) {
                mistakes.push(mistake);
            }
        }
        let milestone = reached.filter(|(misfits, _)| *misfits <= most).map(|(_, it)| it);
        Self { milestone, mistakes, ..Self::default() }
    }

    /// The two mistakes that together explain what neither does, if there are no other two.
    fn of_two(all: &[&'static Mistake], sample: &Sample<'_>) -> Option<Self> {
        let matters = |mistake: &&&Mistake| {
            sample.some().any(|place| mistaken(&[**mistake], place) != place.expected())
        };
        let all: Vec<&Mistake> = all.iter().filter(matters).copied().collect();
        let mut known: Vec<(usize, [&'static Mistake; 2])> = Vec::new();
        for (index, one) in all.iter().enumerate() {
            for two in all[index + 1..].iter().filter(|two| one.goes_with(two)) {
                let both = [*one, *two];
                if sample.may_fit(|place| mistaken(&both, place)) {
                    let misfits = sample.misfits(PART_OF_TWO, |place| mistaken(&both, place));
                    known.extend(misfits.map(|misfits| (misfits, both)));
                }
            }
        }
        let least = known.iter().map(|it| it.0).min()?;
        let most = least + sample.margin();
        let mut best = known.into_iter().filter(|it| it.0 <= most).map(|it| it.1);
        let two = best.next()?;
        let same = |other: [&Mistake; 2]| {
            [0, 1].map(|one| other[one].what) == [0, 1].map(|one| two[one].what)
        };
        best.all(same).then_some(Self { two: Some(two), ..Self::default() })
    }

    /// The milestone that is reached but for one mistake, if there is no other.
    fn on_the_way(
        milestones: impl Iterator<Item = &'static Milestone>, sample: &Sample<'_>,
    ) -> Option<Self> {
        let with = |milestone: &'static Milestone| {
            let fits = |mistake: &&Mistake| match mistake.kind {
                Kind::Told(slip) => milestone.misfits(sample, PART, Some(slip)).is_some(),
                _ => false,
            };
            let mut known = known::all().filter(fits);
            let but = known.next()?;
            let is_alone = known.all(|other| other.what == but.what);
            is_alone.then_some(Self {
                milestone: Some(milestone),
                but: Some(but),
                ..Self::default()
            })
        };
        // From behind a mistake may change a whole picture.
        let most = sample.places().count() / HALF;
        let is_near =
            |it: &&Milestone| it.misfits(sample, 1, None).is_some_and(|misfits| misfits <= most);
        milestones.filter(is_near).find_map(with)
    }
}

impl fmt::Display for Diagnosis {
    /// A sentence a line, and nothing where nothing is known.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let milestone = self.milestone.iter().map(ToString::to_string);
        let mistakes = self.mistakes.iter().take(SAID).map(ToString::to_string);
        let all: Vec<String> = milestone.chain(mistakes).collect();
        for (place, sentence) in all.iter().enumerate() {
            match place {
                0 => writeln!(f, "{sentence}")?,
                _ => writeln!(f, "{}", text!("Or: {sentence}", sentence))?,
            }
        }
        if self.mistakes.len() > 1 {
            let alike = text!("All of these give these pictures: the first is the most likely.");
            writeln!(f, "{alike}")?;
        }
        if self.is_blank {
            let blank = text!(
                "Each picture that differs is all black or all white: every ray hits, or none."
            );
            writeln!(f, "{blank}")?;
        }
        if let Some([one, two]) = self.two {
            writeln!(f, "{}", text!("Two at once: {one}. And: {two}", one, two))?;
        }
        match self.but {
            Some(mistake) => writeln!(f, "{}", text!("But: {mistake}", mistake)),
            None => Ok(()),
        }
    }
}
