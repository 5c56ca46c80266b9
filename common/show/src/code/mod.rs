//! The code of a step beside its picture, with the numbers that it computes.

mod block;
mod fold;
mod heard;
mod news;
mod parsed;
mod ran;
mod token;
mod walk;

use std::cell::OnceCell;
use std::ops::Range;

use common::Projection;
use telling::Explanation;
use telling::LineName;

use fold::Line;
use fold::folded;
use fold::whole;
use heard::Heard;
use news::News;
use parsed::Source;
use ran::Ran;
pub use token::Kind;
use walk::Id;
use walk::Sources;

/// A file: its path from the root, and its text.
pub(crate) type File = (&'static str, &'static str);

/// A step's files in the order in which the lecture tells them, the step before's, and the camera's.
pub type Files = (&'static [File], &'static [File], File);

/// The code of a step; it is taken apart when it is first asked for.
#[derive(Default)]
pub struct Code {
    files: Files,
    parsed: OnceCell<Parsed>,
}

struct Parsed {
    sources: Sources,
    /// Of each file its lines without the telling, and to the letter, each with what is new in them.
    shown: [Vec<(Vec<Line>, News)>; 2],
}

/// What of the code is to be seen.
#[derive(Clone, Copy)]
pub struct Sought<'a> {
    /// The pixel for which it runs, if there is one.
    pub explanation: Option<&'a Explanation>,
    /// The lights and objects that are looked at, the most important one first.
    pub looked_at: &'a [String],
    /// To the letter, with the telling.
    pub whole: bool,
    /// The camera's kind.
    pub projection: Projection,
}

/// A part of the code: a function, a type, or the rest of a file.
pub struct Part {
    /// The file's path from the root.
    pub path: &'static str,
    /// The rest of a file, which is read last.
    pub is_rest: bool,
    /// Its lines in order.
    pub lines: Vec<CodeLine>,
}

/// A line of code.
#[derive(Clone, Debug)]
pub struct CodeLine {
    /// Its number in the file, from 1 on.
    pub number: usize,
    /// As far as it is indented more than its part.
    pub text: String,
    /// Its bytes that are not plain, and what they are.
    pub kinds: Vec<(Range<usize>, Kind)>,
    /// What is told where it runs, with what that is called.
    pub told: Vec<(telling::Line, Option<LineName>)>,
    /// What it is beside the step before.
    pub change: Change,
    /// It did not run for the pixel, which is certain.
    pub is_idle: bool,
}

/// What a line is beside the step before.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Change {
    /// It stands there too.
    Same,
    /// It does not.
    New,
    /// It stands there alone.
    Gone,
}

impl Code {
    /// The code in `files`.
    pub fn new(files: Files) -> Self {
        Self { files, parsed: OnceCell::new() }
    }

    /// Whether there is any.
    pub fn is_empty(&self) -> bool {
        self.files.0.is_empty()
    }

    fn parsed(&self) -> &Parsed {
        self.parsed.get_or_init(|| {
            let (now, before, camera) = self.files;
            let files: Vec<Source> =
                now.iter().chain([&camera]).copied().map(Source::new).collect();
            let before: Vec<Source> = before.iter().copied().map(Source::new).collect();
            let shown = [folded, whole].map(|lines_of: fn(&Source) -> Vec<Line>| {
                let with_news = |source: &Source| {
                    let lines = lines_of(source);
                    let is_it = |other: &&Source| file_name(other.path) == file_name(source.path);
                    let old = before.iter().find(is_it).map(lines_of).unwrap_or_default();
                    let has_before = !before.is_empty() && source.path != camera.0;
                    let news = News::new(has_before.then_some(&*old), &lines);
                    (lines, news)
                };
                files.iter().map(with_news).collect()
            });
            Parsed { sources: Sources(files), shown }
        })
    }

    /// Each file of the step, by its path, as it would be if nothing were told.
    pub fn plain(&self) -> Vec<(&'static str, String)> {
        let Parsed { sources, shown } = self.parsed();
        let of_step = self.files.0.len();
        let text = |(lines, _): &(Vec<Line>, News)| -> String {
            lines.iter().map(|line| format!("{}\n", line.text)).collect()
        };
        let files = sources.0.iter().zip(&shown[0]).take(of_step);
        files.map(|(source, lines)| (source.path, text(lines))).collect()
    }

    /// The functions that run for the pixel, or all of them, in the order of the algorithm; then the rest
    /// of each file.
    pub fn parts(&self, sought: &Sought<'_>) -> Vec<Part> {
        let Parsed { sources, shown } = self.parsed();
        let shown = &*shown[usize::from(sought.whole)];
        let heard = sought.explanation.map(|told| Heard::new(told, sought.looked_at));
        let ran =
            heard.as_ref().map(|heard| Ran { sources, heard, camera: camera(sought.projection) });
        let runs = |id: Id| match &ran {
            Some(ran) if sources.listens(id) => ran.ran(id) == Some(true),
            _ => true,
        };
        let mut walked = sources.walk(camera(sought.projection), &runs);
        // What tells is shown in any case, also where nobody is found who calls it.
        let tells = |id: &Id| sources.item(*id).is_function && sources.listens(*id) && runs(*id);
        let others: Vec<Id> =
            sources.all().filter(|id| tells(id) && !walked.contains(id)).collect();
        walked.extend(others.into_iter().filter(|_| ran.is_some()));
        let mut parts: Vec<Part> = walked
            .iter()
            .map(|id| part(sources, *id, (shown, sought.whole), ran.as_ref()))
            .collect();
        let of_step = sources.0.iter().enumerate().filter(|(place, _)| place + 1 < sources.0.len());
        parts.extend(of_step.filter_map(|(file, source)| {
            let told = walked.iter().filter(|id| id.0 == file).map(|id| &sources.item(*id).at);
            let told: Vec<_> = told.collect();
            let (lines, news) = &shown[file];
            let is_rest = |line: &Line| !told.iter().any(|at| at.contains(&line.first));
            let rest = 0..lines.len();
            let rest = rest.filter(|place| is_rest(&lines[*place]));
            let mut listed = Vec::new();
            rest.for_each(|place| list(&mut listed, place, (lines, news), 0));
            let is_blank = |line: &CodeLine| line.text.is_empty();
            listed.dedup_by(|next, line| is_blank(next) && is_blank(line));
            Some(Part { path: source.path, is_rest: true, lines: listed })
                .filter(|part| !part.lines.iter().all(is_blank))
        }));
        parts
    }

    /// The lights or objects of which one is looked at, with that one.
    pub fn alike(&self, sought: &Sought<'_>) -> Vec<(Vec<&'static str>, &'static str)> {
        let heard = sought.explanation.map(|told| Heard::new(told, sought.looked_at));
        heard.map_or(Vec::new(), |heard| heard.alike)
    }
}

/// The type of the camera of this kind.
fn camera(projection: Projection) -> &'static str {
    match projection {
        Projection::Perspective => "PerspectiveCamera",
        Projection::Parallel => "OrthographicCamera",
    }
}

/// The last part of a path.
pub(crate) fn file_name(path: &'static str) -> &'static str {
    path.rsplit('/').next().unwrap_or(path)
}

fn part(
    sources: &Sources, id: Id, (shown, is_whole): (&[(Vec<Line>, News)], bool),
    ran: Option<&Ran<'_>>,
) -> Part {
    let (source, item) = (sources.source(id), sources.item(id));
    let (all, news) = &shown[id.0];
    // What tells the compiler something tells nothing of the algorithm.
    let is_read = |line: &Line| is_whole || !line.text.trim_start().starts_with("#[");
    let is_its = |line: &Line| item.at.contains(&line.first) && is_read(line);
    let places = (0..all.len()).filter(|place| is_its(&all[*place]));
    let first = places.clone().next().map_or("", |place| &all[place].text);
    let indent = first.len() - first.trim_start().len();
    let mut lines = Vec::new();
    places.for_each(|place| list(&mut lines, place, (all, news), indent));
    if let Some(ran) = ran {
        let idle = ran.not_run(id);
        let sites = source.sites(item.parts.clone()).iter().filter(|site| site.tells);
        let told: Vec<_> = sites.map(|site| (source.start(site.name), site.name)).collect();
        for line in lines.iter_mut().filter(|line| line.change != Change::Gone) {
            let Some(at) = all.iter().find(|other| other.number == line.number) else { continue };
            line.is_idle = idle.iter().any(|idle| idle.contains(&at.first));
            let here = told.iter().filter(|(byte, _)| at.at.contains(byte));
            line.told = here.flat_map(|(_, name)| ran.heard.shown(source, *name)).collect();
        }
    }
    Part { path: source.path, is_rest: false, lines }
}

/// Adds a line, with those before it that are gone.
fn list(listed: &mut Vec<CodeLine>, place: usize, (lines, news): (&[Line], &News), indent: usize) {
    let line = |line: &Line, change| {
        let Line { text, kinds, number, .. } = line;
        let cut = indent.min(text.len() - text.trim_start().len());
        let kinds = kinds.iter().map(|(at, kind)| (at.start - cut..at.end - cut, *kind)).collect();
        let (number, text) = (*number, text[cut..].to_owned());
        CodeLine { number, text, kinds, told: Vec::new(), change, is_idle: false }
    };
    let gone = news.gone.iter().filter(|(at, _)| *at == place);
    listed.extend(gone.map(|(_, gone)| line(gone, Change::Gone)));
    let change = if news.new[place] { Change::New } else { Change::Same };
    listed.push(line(&lines[place], change));
}
