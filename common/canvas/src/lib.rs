//! A picture's pixels: how they are encoded, compared, and drawn on.
//!
//! What costs time for each pixel and is no step's stands here, apart from what shows a step: this
//! crate is optimised in every build, and that one, which is large, compiles fast instead.

mod area;
mod canvas;
mod font;
mod glyphs;
mod ink;
mod pixels;
mod radiance;
mod shape;
mod srgb;
mod told;

pub use area::Anchor;
pub use area::Area;
pub use canvas::Canvas;
pub use font::CodeFont;
pub use font::Font;
pub use font::MathFont;
pub use ink::Ink;
pub use pixels::LESS;
pub use pixels::MORE;
pub use pixels::add_rays;
pub use pixels::count_off;
pub use pixels::difference;
pub use pixels::encode_means;
pub use pixels::off;
pub use pixels::on_nothing;
pub use pixels::pack;
pub use pixels::rgba;
pub use radiance::Radiance;
pub use srgb::decode;
pub use srgb::encode;
pub use told::Palette;
pub use told::STRIPES;
pub use told::Told;
pub use told::draw_told;
