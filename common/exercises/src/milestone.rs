//! The milestones that the handouts name on the way to a solution.

use std::fmt;

use crate::mistake::told_of;
use crate::mistake::unasked;
use crate::said::ahead;
use crate::said::told;
use crate::sample::Place;
use crate::sample::Sample;
use crate::symbol::*;
use common::Color;
use show::encode;
use show::text;
use show::translated;
use telling::Slip;

/// How a milestone's ways are coloured.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Colored {
    /// As they are told.
    Told,
    /// As they are computed, though told otherwise so that nothing asked of it fails.
    Computed,
    /// What is white in these ways may have any one colour, as all else is black.
    AnyOne,
}

/// A milestone of an exercise.
#[derive(Debug)]
pub struct Milestone {
    /// The step that the exercise leads to.
    pub step: &'static str,
    /// What is right so far.
    pub done: &'static str,
    /// What is not there yet.
    pub missing: &'static str,
    /// What the handout has next.
    pub next: &'static str,
    /// What the step tells otherwise there, in one way or another.
    ways: &'static [Slip],
    color: Colored,
}

impl fmt::Display for Milestone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [done, missing, next] = [self.done, self.missing, self.next].map(translated);
        f.write_str(&text!(
            "So far so good: {done}. Still missing: {missing}. Next: {next}",
            done,
            missing,
            next
        ))
    }
}

impl Milestone {
    /// All of them, in the order of the handouts.
    pub const ALL: &'static [Self] = &[
        Self {
            step: "step02_sphere",
            done: "white where D > 0",
            missing: "0 < t < ∞",
            next: "the roots, as the sphere may be behind the eye, or the eye inside the sphere",
            ways: &[told!(|_| T_1(t) => ahead(t))],
            color: Colored::Told,
        },
        Self {
            step: "step03_triangle",
            done: "the plane, by its t",
            missing: "α, β and γ",
            next: "β and γ",
            ways: &[told!(|_| ALPHA(_) => 1.0, BETA(_) => 1.0, GAMMA(_) => 1.0)],
            color: Colored::AnyOne,
        },
        Self {
            step: "step03_triangle",
            done: "t, α, β and γ",
            missing: "where the triangle ends",
            next: "the interior test",
            ways: &[told!(|said|
                BETA(beta) => beta.max(0.0),
                GAMMA(gamma) => gamma.max(0.0),
                ALPHA(_) => said.weights()?[0].max(0.0))],
            color: Colored::Computed,
        },
        Self {
            step: "step04_scene",
            done: "a list of one sphere",
            missing: "all other surfaces",
            next: "the loop over all of them, which keeps the closest hit",
            ways: &[
                told!(|said| T_1(t) => said.of_sphere(0, t)?, T_2(t) => said.of_sphere(0, t)?, T(_) => -1.0),
                told!(|said| T_1(t) => said.of_sphere(1, t)?, T_2(t) => said.of_sphere(1, t)?, T(_) => -1.0),
                told!(|said| T_1(t) => said.of_sphere(2, t)?, T_2(t) => said.of_sphere(2, t)?, T(_) => -1.0),
            ],
            color: Colored::Told,
        },
        Self {
            step: "step04_scene",
            done: "the loop over all spheres",
            missing: "the triangles",
            next: "the whole scene",
            ways: &[told!(|_| T(_) => -1.0)],
            color: Colored::Told,
        },
        Self {
            step: "step05_diffuse",
            done: "k_d max(0, n·l)",
            missing: "I/r²",
            next: "the light, divided by r²",
            ways: &[told!(|_| IRRADIANCE(_) => 1.0)],
            color: Colored::Told,
        },
        Self {
            step: "step06_shadows",
            done: "one light and its shadow",
            missing: "the second light and the ambient light",
            next: "the loop over two lights",
            ways: &[told!(|said|
                VISIBLE(v) => if said.lights().is_empty() { v } else { 0.0 },
                L_A(_) => Color::ZERO)],
            color: Colored::Told,
        },
        Self {
            step: "step06_shadows",
            done: "two lights and their shadows",
            missing: "the ambient light",
            next: "the ambient term, L_a = k_a I_a",
            ways: &[told!(|_| L_A(_) => Color::ZERO)],
            color: Colored::Told,
        },
        Self {
            step: "step07_specular",
            done: "the highlight in Phong's form, with v_r",
            missing: "h, halfway between v and l",
            next: "n·h in place of v_r·v",
            ways: &[told!(|said| N_DOT_H(_) => said.v_r()?.dot(said.get(TO_VIEWER)?))],
            color: Colored::Told,
        },
    ];

    /// How many pixels of `sample` are not as they are at this milestone, or with one more `mistake`;
    /// none if they are [too many](Sample::misfits).
    pub(crate) fn misfits(
        &self, sample: &Sample<'_>, part: usize, mistake: Option<Slip>,
    ) -> Option<usize> {
        let of = |way: &Slip| {
            let slips: Vec<Slip> = [*way].into_iter().chain(mistake).collect();
            let pixel = |place: &Place<'_>| {
                let said = told_of(place, &slips);
                let computed = self.color == Colored::Computed;
                let color = if computed { unasked(&said) } else { said.color };
                encode(place.pair.times * color)
            };
            if self.color != Colored::AnyOne {
                return sample.misfits(part, pixel);
            }
            // Only what is seen: the same colour elsewhere is darker than black nowhere.
            let is_white =
                |place: &Place<'_>| place.pair.times == 1.0 && pixel(place) == encode(Color::ONE);
            let color = sample.places().find(|place| is_white(place))?.found();
            if color == encode(Color::ZERO) {
                return None;
            }
            sample.misfits(part, |place| match (place.pair.times == 1.0, is_white(place)) {
                (false, _) => place.found(),
                (true, true) => color,
                (true, false) => pixel(place),
            })
        };
        self.ways.iter().filter_map(of).min()
    }
}
