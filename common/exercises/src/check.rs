//! `--check`: whether a solution of an exercise is right, and what is wrong with it.

use anyhow::Result;
use anyhow::anyhow;
use image::RgbImage;
use image::imageops;
use image::imageops::FilterType;

use crate::Diagnosis;
use crate::Pair;
use crate::case::Case;
use crate::case::Scene;
use crate::mistake::centered;
use crate::other;
use crate::other::Answer;
use common::Pixel;
use show::Comparison;
use show::Frame;
use show::Program;
use show::Verdict;
use show::Workspace;
use show::render_parallel;
use show::side_by_side;
use show::text;
use show::written;

/// Whether the program of step `name` is `program`, or of `program` itself whether its pixel loop is
/// right; and if not, where and perhaps why.
pub(crate) fn check(program: &Program, name: &str) -> Result<Verdict> {
    let itself = name == program.name;
    let cases = Case::all(&program.make)?;
    let scenes = cases.iter().map(|case| case.scene(&program.make));
    let scenes: Vec<Scene> = scenes
        .collect::<Result<_, String>>()
        .map_err(|name| anyhow!(text!("'{name}' cannot be set", name)))?;
    let frames: Vec<Frame<'_>> =
        cases.iter().zip(&scenes).map(|(case, scene)| case.frame(scene)).collect();
    let render = |frame: &Frame<'_>| render_parallel(frame, |_| ());
    let answers = if itself {
        frames.iter().map(|frame| Answer::Picture(render(frame))).collect()
    } else {
        let workspace = Workspace::find()?;
        let steps = workspace.steps();
        if !steps.iter().any(|step| step == name) {
            let names = steps.join(", ");
            let unknown = text!("there is no step '{name}'; there are {names}", name, names);
            return Ok(Verdict::Unknown(unknown));
        }
        other::ask(name, &workspace.build(name)?, &cases)?
    };
    let expected: Vec<RgbImage> =
        frames.iter().map(|frame| if itself { centered(frame) } else { render(frame) }).collect();
    let mut compared = Vec::new();
    let mut lacking: Vec<&str> = Vec::new();
    for (index, answer) in answers.iter().enumerate() {
        match answer {
            Answer::Picture(found) => {
                let (frame, expected) = (frames[index], &expected[index]);
                let comparison = Comparison::new(expected, found, &[]);
                compared.push((&cases[index], Pair { frame, expected, found }, comparison));
            }
            Answer::Lacks(control) if !lacking.contains(&control.as_str()) => lacking.push(control),
            Answer::Lacks(_) => {}
        }
    }
    let count = compared.len();
    let mut differing = compared.iter().filter(|(.., comparison)| !comparison.is_equal());
    let lacking = match lacking.is_empty() {
        true => String::new(),
        false => text!(
            "; what {name} cannot set is not compared: {controls}",
            name,
            controls = lacking.join(", ")
        ),
    };
    let Some((case, pair, comparison)) = differing.next() else {
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
        return Ok(Verdict::Right(format!("{done}{lacking}\n")));
    };
    let mut text = text!(
        "{name}: {differing} of {count} pictures differ{lacking}\nfirst {options}\n",
        name,
        differing = 1 + differing.count(),
        count,
        lacking,
        options = case
    );
    text += &format!("{comparison}\n");
    let pairs: Vec<Pair<'_>> = compared.iter().map(|(_, pair, _)| Pair { ..*pair }).collect();
    text += &Diagnosis::new(program.name, &pairs).to_string();
    if let Comparison::Different(difference) = comparison {
        let (col, row) = (difference.worst.0 as usize, difference.worst.1 as usize);
        let (width, height) = (case.size.width(), case.size.height());
        let explanation =
            pair.frame.step.explain(pair.frame.camera, Pixel { col, row, width, height });
        text += &text!(
            "\nas {name} has it:\n{explanation}",
            name = program.name,
            explanation = written(&explanation)
        );
    }
    // A picture of eight pixels is to be seen, too.
    let picture = side_by_side(pair.expected, pair.found);
    let scale = (960 / picture.width()).max(1);
    let (width, height) = (scale * picture.width(), scale * picture.height());
    Ok(Verdict::Wrong(text, imageops::resize(&picture, width, height, FilterType::Nearest)))
}
