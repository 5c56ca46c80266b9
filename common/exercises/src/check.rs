//! `--check`: whether a solution of an exercise is right, and what is wrong with it.

use std::collections::BTreeSet;
use std::path::Path;
use std::path::PathBuf;

use anyhow::Result;
use anyhow::anyhow;
use image::RgbImage;
use image::imageops;
use image::imageops::FilterType;

use crate::Diagnosis;
use crate::Pair;
use crate::Scene;
use crate::Shot;
use crate::case::Case;
use crate::first_line::first_line;
use crate::mistake::centered;
use crate::other;
use crate::other::Answer;
use common::Pixel;
use show::Comparison;
use show::Difference;
use show::Program;
use show::Radiance;
use show::Verdict;
use show::Workspace;
use show::side_by_side;
use show::text;
use show::written;
use telling::Explanation;

/// How many times its light a picture is compared with where some of it is darker than black, or brighter
/// than white. Where a picture cuts that off, the mean of many rays does not.
const DARKER: f32 = -1.0;
const BRIGHTER: f32 = 1.0 / 16.0;

/// Into so many parts across and down a picture is divided, to find a pixel of which much is told.
const PARTS: usize = 8;

/// A picture of both programs.
struct Compared<'a> {
    case: &'a Case,
    shot: Shot<'a>,
    times: f32,
    expected: RgbImage,
    found: RgbImage,
    comparison: Comparison,
}

/// Whether the program of step `name` is `program`, or of `program` itself whether its pixel loop is
/// right; and if not, where and perhaps why.
pub(crate) fn check(program: &Program, name: &str) -> Result<Verdict> {
    let itself = name == program.name;
    let cases = Case::all(&program.make)?;
    let scenes = cases.iter().map(|case| case.scene(&program.make));
    let scenes: Vec<Scene> = scenes
        .collect::<Result<_, String>>()
        .map_err(|name| anyhow!(text!("'{name}' cannot be set", name)))?;
    let shots = cases.iter().zip(&scenes).map(|(case, scene)| (case, scene.shot(1)));
    let mut built = None;
    let answers = if itself {
        shots.clone().map(|(_, shot)| Answer::Picture(shot.frame.radiance())).collect()
    } else {
        let workspace = Workspace::find()?;
        let steps = workspace.steps();
        if !steps.iter().any(|step| step == name) {
            let names = steps.join(", ");
            let unknown = text!("there is no step '{name}'; there are {names}", name, names);
            return Ok(Verdict::Unknown(unknown));
        }
        other::ask(name, built.insert(workspace.build(name)?), &cases)?
    };
    let mut compared: Vec<Compared<'_>> = Vec::new();
    let mut lacking: Vec<&str> = Vec::new();
    let mut count = 0;
    for ((case, shot), answer) in shots.zip(&answers) {
        match answer {
            Answer::Picture(found) => {
                let expected = if itself { centered(&shot.frame) } else { shot.frame.radiance() };
                let both = [&expected, found];
                let ranges = both.map(Radiance::range);
                let darker = ranges.iter().any(|range| range.0 < 0.0).then_some(DARKER);
                let brighter = ranges.iter().any(|range| range.1 > 1.0).then_some(BRIGHTER);
                let times = [Some(1.0), darker, brighter].into_iter().flatten();
                compared.extend(times.map(|times| Compared::new(case, shot, times, both)));
                count += 1;
            }
            Answer::Lacks(control) if !lacking.contains(&control.as_str()) => lacking.push(control),
            Answer::Lacks(_) => {}
        }
    }
    let off = compared.iter().filter(|it| !it.comparison.is_equal()).map(|it| it.case.to_string());
    let differing = off.collect::<BTreeSet<String>>().len();
    let lacking = match lacking.is_empty() {
        true => String::new(),
        false => text!(
            "; what {name} cannot set is not compared: {controls}",
            name,
            controls = lacking.join(", ")
        ),
    };
    let is_seen = |it: &&Compared<'_>| it.times == 1.0 && !it.comparison.is_equal();
    let first = compared.iter().find(is_seen);
    let first = first.or_else(|| compared.iter().find(|it| !it.comparison.is_equal()));
    let Some(first) = first else {
        let done = match itself {
            true => text!(
                "done: the pixel loop of {name} is right in all {count} pictures",
                name,
                count
            ),
            false => text!(
                "done: {name} draws all {count} pictures as {other} does",
                name,
                count,
                other = program.name
            ),
        };
        let mut note = String::new();
        if let Some(built) = &built {
            for picture in compared.iter().filter(|it| it.times == 1.0) {
                if note.is_empty() {
                    note = picture.told_otherwise(program.name, name, built)?;
                }
            }
        }
        return Ok(Verdict::Right(format!("{done}{lacking}\n{note}")));
    };
    let mut text = text!(
        "{name}: {differing} of {count} pictures differ{lacking}\nfirst {options}\n",
        name,
        differing,
        count,
        lacking,
        options = first.case
    );
    if first.times != 1.0 {
        text += text!(
            "the picture is the same, but not the light in it, which is cut off below 0 and above 1:\n"
        );
    }
    text += &format!("{}\n", first.comparison);
    let pairs: Vec<Pair<'_>> = compared.iter().map(Compared::pair).collect();
    text += &Diagnosis::new(program.name, &pairs).to_string();
    if let Comparison::Different(difference) = &first.comparison {
        text += &first.told(program.name, name, built.as_ref(), difference)?;
    }
    // A picture of eight pixels is to be seen, too.
    let picture = side_by_side(&first.expected, &first.found);
    let scale = (960 / picture.width()).max(1);
    let (width, height) = (scale * picture.width(), scale * picture.height());
    Ok(Verdict::Wrong(text, imageops::resize(&picture, width, height, FilterType::Nearest)))
}

impl<'a> Compared<'a> {
    fn new(case: &'a Case, shot: Shot<'a>, times: f32, both: [&Radiance; 2]) -> Self {
        let [expected, found] = both.map(|radiance| radiance.times(times));
        let comparison = Comparison::new(&expected, &found, &[]);
        Self { case, shot, times, expected, found, comparison }
    }

    fn pair(&self) -> Pair<'_> {
        let Self { shot, times, expected, found, .. } = self;
        Pair { shot: *shot, times: *times, expected, found }
    }

    /// What `step`, and the program `built` of the step `name`, tell of the pixel that is furthest off.
    fn told(
        &self, step: &str, name: &str, built: Option<&PathBuf>, difference: &Difference,
    ) -> Result<String> {
        let (col, row) = (difference.worst.0 as usize, difference.worst.1 as usize);
        let (expected, arguments) = self.of_pixel(col, row);
        let mut text = String::new();
        if let Some(built) = built {
            let found = other::tell(name, built, &arguments)?;
            let line = first_line(&expected, &found, true);
            text += &line.map(|line| line.written(step, name)).unwrap_or_default();
        }
        let explanation = expected;
        text += &text!("\nas {name} has it:\n{explanation}", name = step, explanation);
        let options = arguments.join(" ");
        text +=
            &text!("the same pixel of {name}: cargo run -p {name} -- {options}\n", name, options);
        Ok(text)
    }

    /// Which line the program `built` of the step `name` tells otherwise than `step`, although both
    /// draw the same: of a pixel of which as much is told as of any that is looked at, if there is one.
    fn told_otherwise(&self, step: &str, name: &str, built: &Path) -> Result<String> {
        let (width, height) = (self.case.size.width(), self.case.size.height());
        let pixels = (0..PARTS * PARTS)
            .map(|part| (width * (part % PARTS) / PARTS, height * (part / PARTS) / PARTS));
        let told = |pixel: &(usize, usize)| self.explained(*pixel).lines().count();
        let (col, row) = pixels.max_by_key(told).unwrap_or_default();
        let (expected, arguments) = self.of_pixel(col, row);
        let found = other::tell(name, built, &arguments)?;
        let options = self.case;
        Ok(first_line(&expected, &found, false).map_or(String::new(), |line| {
            let note = text!(
                "but one line is told otherwise, which no picture here shows; of pixel ({col}, {row}) with {options}:",
                col,
                row,
                options
            );
            note + &line.written(step, name)
        }))
    }

    /// What is told of a pixel, and what has a program tell it.
    fn of_pixel(&self, col: usize, row: usize) -> (String, Vec<String>) {
        let mut arguments = self.case.arguments();
        arguments.extend(["--pixel".to_owned(), format!("{col},{row}")]);
        (written(&self.explained((col, row))), arguments)
    }

    fn explained(&self, (col, row): (usize, usize)) -> Explanation {
        let (width, height) = (self.case.size.width(), self.case.size.height());
        let frame = self.shot.frame;
        frame.step.explain(frame.camera, Pixel { col, row, width, height })
    }
}
