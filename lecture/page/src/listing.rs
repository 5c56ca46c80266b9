//! The code of the step, as a browser is told it.

use show::Change;
use show::CodeKind;
use show::CodeLine;
use show::CodePart;
use show::Desk;
use show::rounded;
use show::translated;
use telling::LineName;

use crate::formula;
use crate::protocol::Listed;
use crate::protocol::Listing;
use crate::protocol::Noted;

/// The code in the order of the algorithm, the rest of each file last.
pub(crate) fn listings(desk: &Desk) -> Vec<Listing> {
    let listing = |CodePart { path, is_rest, lines }: CodePart| {
        let lines = lines.into_iter().map(|line| listed(line, desk)).collect();
        Listing { path, rest: is_rest, lines }
    };
    desk.code().into_iter().map(listing).collect()
}

fn listed(line: CodeLine, desk: &Desk) -> Listed {
    let mut pieces = Vec::new();
    let mut at = 0;
    for (bytes, kind) in &line.kinds {
        let kind = match kind {
            CodeKind::Word | CodeKind::Sign => continue,
            CodeKind::Keyword => "key",
            CodeKind::Comment => "said",
            CodeKind::Text => "text",
        };
        pieces.push(("", line.text[at..bytes.start].to_owned()));
        pieces.push((kind, line.text[bytes.clone()].to_owned()));
        at = bytes.end;
    }
    pieces.push(("", line.text[at..].to_owned()));
    pieces.retain(|(_, text)| !text.is_empty());
    let noted = |(told, name): (telling::Line, Option<LineName>)| Noted {
        math: formula::told(&told),
        shown: translated(told.equation),
        symbol: told.symbol(),
        value: rounded(&told.value).join("  "),
        chosen: name.is_some() && desk.line() == name.as_ref(),
        altered: name.as_ref().is_some_and(|name| desk.is_altered(name)),
        name: name.map(|LineName { equation, of }| (equation, of)),
    };
    let change = match line.change {
        Change::Same => "",
        Change::New => "new",
        Change::Gone => "gone",
    };
    let (number, idle) = (line.number, line.is_idle);
    Listed { number, pieces, notes: line.told.into_iter().map(noted).collect(), change, idle }
}
