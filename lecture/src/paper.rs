//! A class on paper: of each stop its picture, what is said there, and room to write.

use std::fmt::Write as _;

use anyhow::Result;
use anyhow::anyhow;

use crate::FIGURES;
use crate::escape::escape;
use crate::html::jpeg;
use crate::programs;
use show::Act;
use show::Desk;
use show::Language;
use show::Tour;
use show::picture_shown;

/// How wide a picture is at most, in pixels: two stops fill a page.
const WIDTH: u32 = 1200;

/// How exactly pictures are kept, of 100: their letters are read on paper.
const QUALITY: u8 = 85;

const STYLE: &str = "
@page { size: A4; margin: 14mm; }
body { font: 11pt/1.4 serif; margin: 0 auto; max-width: 182mm; }
section { break-inside: avoid; margin-bottom: 8mm; }
h2 { font-size: 13pt; margin: 0 0 2mm; }
h2 span { font-weight: normal; }
img { display: block; max-width: 100%; max-height: 78mm; }
p { margin: 2mm 0; }
hr { border: 0; border-top: 0.2mm solid #999; margin: 7mm 0; }
";

/// The page that a browser prints: the tour in the language that is spoken, or the one there is.
///
/// # Errors
///
/// When there is no tour, or a picture cannot be encoded.
pub(crate) fn handout(tours: &[Tour]) -> Result<String> {
    let language = Language::spoken();
    let tour = tours.get(language.place()).or(tours.first());
    let tour = tour.ok_or_else(|| anyhow!("there is no tour"))?;
    let all = [programs(), FIGURES.map(|(_, figure)| figure()).to_vec()].concat();
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<meta charset=\"utf-8\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n<h1>{title}</h1>\n",
        language.tag(),
        title = escape(&tour.title),
    );
    for (number, stop) in (1..).zip(&tour.stops) {
        let mut desk = Desk::new(all.clone(), 0).touring(vec![tour.clone()]);
        for act in [Act::Speak(language), Act::Stop(number)] {
            desk.act(act)?;
        }
        let picture = jpeg(picture_shown(desk), WIDTH, QUALITY)?;
        let [slide, subtitle, text, question] =
            [&stop.slide, &stop.subtitle, &stop.text, &stop.question].map(|text| escape(text));
        let _ = writeln!(
            html,
            "<section>\n<h2>{slide} <span>{subtitle}</span></h2>\n\
             <img alt=\"{slide}\" src=\"data:image/jpeg;base64,{picture}\">\n\
             <p>{text}</p>\n<p><em>{question}</em></p>\n<hr><hr><hr>\n</section>"
        );
    }
    Ok(html)
}
