//! The stops of a class, as a browser is told of them, and tells of them.

use serde::Serialize;
use show::Asked;
use show::Desk;
use show::Prose;
use show::Reading;
use show::Stop;
use show::Tour;
use show::escaped;
use show::mathml;
use show::prose;

/// A tour as JSON has it: its title, and of each stop the slide, the subtitle, the address, the text,
/// the question and the answer.
pub(crate) type Told = (String, Vec<[String; 6]>);

/// Tours, one in each language or one for all, as the page reads them when it begins.
///
/// # Errors
///
/// When JSON cannot have them.
pub fn tours(tours: &[Tour]) -> Result<String, serde_json::Error> {
    let told = |tour: &Tour| -> Told {
        let stop = |stop: &Stop| {
            let Stop { slide, subtitle, address, text, question, answer } = stop.clone();
            [slide, subtitle, address, text, question, answer]
        };
        (tour.title.clone(), tour.stops.iter().map(stop).collect())
    };
    serde_json::to_string(&tours.iter().map(told).collect::<Vec<_>>())
}

/// The tour that was told.
pub(crate) fn tour((title, stops): Told) -> Tour {
    let stop = |[slide, subtitle, address, text, question, answer]: [String; 6]| Stop {
        slide,
        subtitle,
        address,
        text,
        question,
        answer,
    };
    Tour { title, stops: stops.into_iter().map(stop).collect() }
}

/// A text with its symbols set.
fn html(text: &str) -> String {
    let part = |part| match part {
        Prose::Text(text) => escaped(&text),
        Prose::Symbol(math) => mathml(&math, false, &mut |_, _| None),
    };
    prose(text).into_iter().map(part).collect()
}

/// Where the class is, and what is said there: subtitle, question and text in HTML.
#[derive(Serialize)]
pub(crate) struct Here {
    number: usize,
    count: usize,
    slide: String,
    subtitle: String,
    /// What stands in front: the question of which the answer is the text.
    question: String,
    text: String,
    /// Whether there is a question that is not to be seen.
    asks: bool,
    changed: bool,
}

/// The stop of the class, if it is at one.
pub(crate) fn here(desk: &Desk) -> Option<Here> {
    let (number, stop) = desk.stop()?;
    let Stop { slide, subtitle, text, question, answer, .. } = stop.clone();
    let asks = desk.asked() == Asked::Nothing && !question.is_empty();
    let (question, text) = match desk.asked() {
        Asked::Nothing => (String::new(), text),
        Asked::Question => (String::new(), question),
        Asked::Answer => (question, answer),
    };
    let (count, changed) = (desk.stops().len(), desk.is_changed());
    let [subtitle, question, text] = [subtitle, question, text].map(|text| html(&text));
    Some(Here { number, count, slide, subtitle, question, text, asks, changed })
}

/// The list of stops and figures, and the place in it, where that is read.
pub(crate) fn listed(desk: &Desk) -> Option<(Vec<String>, usize)> {
    (desk.reading() == Reading::Stops).then(|| (desk.listed(), desk.picked()))
}
