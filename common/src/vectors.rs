use crate::Ink;

/// The fixed colour of a symbol that stands for a vector or a point: the same in the picture and
/// beside it.
pub(crate) fn symbol_ink(symbol: &str) -> Option<Ink> {
    match symbol {
        "n" | "normal" => Some(Ink::new(110, 200, 255)),
        "l" => Some(Ink::new(255, 225, 120)),
        "v" => Some(Ink::new(140, 230, 150)),
        "h" | "v_r" => Some(Ink::new(255, 150, 200)),
        _ => None,
    }
}
