//! A handout's equations as MathML, with a place for the number of each symbol that a step tells.

use pulldown_latex::Parser;
use pulldown_latex::RenderConfig;
use pulldown_latex::Storage;
use pulldown_latex::config::DisplayMode;
use pulldown_latex::push_mathml;

use crate::handout::escape;

/// What stands in an equation, and the symbols that steps tell with its value, with `|` between
/// them; one that ends in `=` is meant only where it is given its value. Of two that begin alike the
/// longer one is first.
const SYMBOLS: [(&str, &str); 27] = [
    (r"\max(0, \mathbf{n}\cdot\mathbf{h}_i)^{p}", "max(0, n·h)^p"),
    (r"\mathbf{n}\cdot\mathbf{l}_i", "n·l"),
    (r"\mathbf{n}\cdot\mathbf{l}", "n·l"),
    (r"\frac{I_i}{r_i^2}", "I/r²"),
    (r"\frac{I}{r^2}", "I/r²"),
    (r"\mathbf{p}", "p"),
    (r"\mathbf{d}", "d"),
    (r"\mathbf{h} =", "h"),
    (r"t^{\ast}", "t_max"),
    (r"\alpha", "α"),
    (r"\beta", "β"),
    (r"\gamma", "γ"),
    (r"\sqrt{D}", "√D"),
    ("a =", "a"),
    ("b =", "b"),
    ("q^2 =", "q²"),
    ("D =", "D"),
    ("t =", "t₁|t"),
    ("V_i", "V"),
    ("k_a", "k_a"),
    ("k_d", "k_d"),
    ("k_s", "k_s"),
    ("I_a", "I_a"),
    ("L_d", "L_d"),
    ("L", "L"),
    ("u", "u"),
    ("v", "v"),
];

/// An equation in a line of text.
pub(crate) fn inline(latex: &str) -> String {
    mathml(latex, DisplayMode::Inline)
}

/// Which of [`SYMBOLS`] have had their place in the equations of a section.
pub(crate) type Seen = [bool; SYMBOLS.len()];

/// Equations below each other, or beside each other where there is room. Under each symbol that a
/// step tells is an empty `<span data-symbol>`, where the symbol first stands in the section.
pub(crate) fn block(latex: &str, seen: &mut Seen) -> String {
    let mut html = String::from("<div class=\"math\" tabindex=\"0\" role=\"group\">");
    for equation in with_places(latex, seen).split(r"\qquad") {
        html.push_str(&mathml(equation, DisplayMode::Block));
    }
    for (place, (_, symbol)) in SYMBOLS.iter().enumerate() {
        let span = format!("<mtext><span data-symbol=\"{}\"></span></mtext>", escape(symbol));
        html = html.replace(&format!("<mtext>@{place}@</mtext>"), &span);
    }
    html + "</div>"
}

/// LaTeX as MathML; what cannot be read stays LaTeX.
fn mathml(latex: &str, display_mode: DisplayMode) -> String {
    let storage = Storage::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut html = String::new();
    match push_mathml(&mut html, Parser::new(latex, &storage), config) {
        Ok(()) => html,
        Err(_) => format!("<code>{}</code>", escape(latex)),
    }
}

/// Puts `@PLACE@` under the first of each of [`SYMBOLS`].
fn with_places(latex: &str, seen: &mut Seen) -> String {
    let mut marked = String::new();
    let mut rest = latex;
    while let Some(first) = rest.chars().next() {
        let letter = |letter: char| letter.is_ascii_alphabetic();
        let found = SYMBOLS.iter().position(|(symbol, _)| {
            let after = rest.strip_prefix(symbol).map(|after| after.chars().next());
            after.is_some_and(|next| !next.is_some_and(|next| letter(next) || next == '_'))
        });
        let whole = match found {
            Some(place) if !std::mem::replace(&mut seen[place], true) => {
                let symbol = SYMBOLS[place].0.trim_end_matches(" =");
                marked.push_str(&format!(r"\underset{{\text{{@{place}@}}}}{{{symbol}}}"));
                rest = &rest[symbol.len()..];
                continue;
            }
            Some(place) => SYMBOLS[place].0.len(),
            // Nothing within a word, a command, an index or a name is a symbol.
            None if first == '\\' => {
                let word = rest[1..].find(|next| !letter(next)).map_or(rest.len(), |end| end + 1);
                let named = [r"\text{", r"\mathrm{", r"\mathbf{", r"\begin{", r"\end{"];
                match named.iter().any(|name| rest.starts_with(name)) {
                    true => rest.find('}').map_or(rest.len(), |end| end + 1),
                    false => word.max(2).min(rest.len()),
                }
            }
            None if first == '_' || first == '^' => match rest[1..].starts_with('{') {
                true => rest.find('}').map_or(rest.len(), |end| end + 1),
                false => rest.len().min(1),
            },
            None => first.len_utf8(),
        };
        marked.push_str(&rest[..whole]);
        rest = &rest[whole..];
    }
    marked
}
