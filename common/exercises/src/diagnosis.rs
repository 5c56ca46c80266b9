//! What can be said of a solution by its pictures.

use std::fmt;

use crate::milestone::Milestone;
use crate::mistake::Kind;
use crate::mistake::Mistake;
use crate::sample::Pair;
use crate::sample::Sample;
use show::text;

/// What makes pictures differ, as far as that is known.
#[derive(Debug, Default)]
pub struct Diagnosis {
    /// The milestone that is reached.
    pub milestone: Option<&'static Milestone>,
    /// The mistake that explains the pictures too, or two, if either may be it.
    pub mistakes: Vec<&'static Mistake>,
    /// A mistake on the way: with it the milestone is explained, and not without.
    pub but: Option<&'static Mistake>,
}

/// Of so many pixels that differ one may stay unexplained.
const PART: usize = 10;

/// Of so many one, where a milestone and one more mistake may explain them.
const HALF: usize = 2;

impl Diagnosis {
    /// What explains how the pictures found differ: nine in ten of the pixels that do, nearly all of
    /// those that do not, and more than anything else that is known. Milestones are those of `step`.
    pub fn new(step: &str, pairs: &[Pair<'_>]) -> Self {
        let Some(sample) = Sample::new(pairs) else { return Self::default() };
        let milestones = || Milestone::ALL.iter().filter(|milestone| milestone.step == step);
        let reached = milestones().filter_map(|it| Some((it.misfits(&sample, PART, None)?, it)));
        let reached = reached.min_by_key(|(misfits, _)| *misfits);
        let misfits = |mistake: &Mistake| {
            sample.misfits(PART, |place| mistake.pixel(&place.pair.frame, place.col, place.row))
        };
        let mut known: Vec<(usize, &Mistake)> =
            Mistake::ALL.iter().filter_map(|it| Some((misfits(it)?, it))).collect();
        known.sort_by_key(|(misfits, _)| *misfits);
        let all = known.iter().map(|(misfits, _)| misfits).chain(reached.iter().map(|it| &it.0));
        let Some(least) = all.min() else { return Self::on_the_way(milestones(), &sample) };
        let most = least + sample.margin();
        let mut mistakes: Vec<&Mistake> = Vec::new();
        for (_, mistake) in known.into_iter().filter(|(misfits, _)| *misfits <= most) {
            if mistakes.iter().all(|other| other.what != mistake.what) {
                mistakes.push(mistake);
            }
        }
        if mistakes.len() > 2 {
            mistakes.clear();
        }
        let milestone = reached.filter(|(misfits, _)| *misfits <= most).map(|(_, it)| it);
        Self { milestone, mistakes, but: None }
    }

    /// The milestone that is reached but for one mistake, if there is no other.
    fn on_the_way(
        milestones: impl Iterator<Item = &'static Milestone>, sample: &Sample<'_>,
    ) -> Self {
        let with = |milestone: &'static Milestone| {
            let fits = |mistake: &&Mistake| match mistake.kind {
                Kind::Told(slip) => milestone.misfits(sample, PART, Some(slip)).is_some(),
                _ => false,
            };
            let mut known = Mistake::ALL.iter().filter(fits);
            let but = known.next()?;
            let is_alone = known.all(|other| other.what == but.what);
            is_alone.then_some(Self {
                milestone: Some(milestone),
                but: Some(but),
                ..Self::default()
            })
        };
        let is_near = |it: &&Milestone| it.misfits(sample, HALF, None).is_some();
        milestones.filter(is_near).find_map(with).unwrap_or_default()
    }
}

impl fmt::Display for Diagnosis {
    /// A sentence a line, and nothing where nothing is known.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let milestone = self.milestone.iter().map(ToString::to_string);
        let mistakes = self.mistakes.iter().map(ToString::to_string);
        for (place, sentence) in milestone.chain(mistakes).enumerate() {
            match place {
                0 => writeln!(f, "{sentence}")?,
                _ => writeln!(f, "{}", text!("Or: {sentence}", sentence))?,
            }
        }
        match self.but {
            Some(mistake) => writeln!(f, "{}", text!("But: {mistake}", mistake)),
            None => Ok(()),
        }
    }
}
