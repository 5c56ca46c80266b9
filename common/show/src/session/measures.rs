//! How rows look: their inks, and their measures in ems.

use crate::Ink;

/// Behind all that is beside the picture.
pub(super) const BACKGROUND: Ink = Ink::new(21, 24, 31);
pub(super) const TEXT: Ink = Ink::grey(238);
pub(super) const FAINT: Ink = Ink::new(163, 172, 186);
/// What is chosen, and what was changed.
pub(super) const ACCENT: Ink = Ink::new(255, 208, 64);
/// What is answered otherwise.
pub(super) const ALTERED: Ink = Ink::new(255, 150, 70);
/// What a step adds: to its code, and to what is told of a pixel.
pub(super) const ADDED: Ink = Ink::new(150, 225, 150);
/// What it takes away.
pub(super) const REMOVED: Ink = Ink::new(255, 160, 150);
pub(super) const NEW: Ink = Ink::new(30, 50, 42);
pub(super) const CHOSEN: Ink = Ink::new(43, 49, 61);
pub(super) const GROOVE: Ink = Ink::new(66, 74, 90);
pub(super) const BAR: Ink = Ink::new(128, 140, 160);

/// Heights and widths in ems.
pub(super) const HIGH: f32 = 1.5;
pub(super) const MARGIN: f32 = 0.6;
pub(super) const INDENT: f32 = 0.95;
pub(super) const NUMBER: f32 = 4.4;
/// How much of a number's column is behind its point.
pub(super) const DECIMALS: f32 = 3.1;
pub(super) const NAME: f32 = 6.6;
/// How much smaller an equation may be to stand beside its values.
pub(super) const SMALLER: f32 = 0.7;
/// From this width on controls stand two in a row.
pub(super) const TWO: f32 = 24.0;
/// Between the two.
pub(super) const GUTTER: f32 = 1.6;
