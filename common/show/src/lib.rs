//! What shows a step. [`Session`] is what a class does, whatever window it is done in: events in,
//! effects out. But in a browser there are also a window, files and the command line, and `main` is all
//! that a step's program has to call.
//!
//! Nothing here knows of spheres, scenes or light, and what there is in a browser asks for no clock,
//! thread or file. A step's library does not know of this crate, nor could it be built for a browser
//! if it did: its program and its figures do.

mod code;
mod compare;
mod control;
mod desk;
#[cfg(not(target_family = "wasm"))]
mod desktop;
mod figure;
mod frame;
mod language;
mod math;
mod outside;
mod over;
mod pen;
mod pointed;
mod prose;
mod quantity;
mod session;
mod setup;
mod shown;
mod sight;
mod ticks;
mod typed;
mod vectors;
mod written;

pub use canvas::Anchor;
pub use canvas::Area;
pub use canvas::Canvas;
pub use canvas::CodeFont;
pub use canvas::Font;
pub use canvas::Ink;
pub use canvas::LESS;
pub use canvas::MORE;
pub use canvas::MathFont;
pub use canvas::Radiance;
pub use canvas::count_off;
pub use canvas::decode;
pub use canvas::difference;
pub use canvas::encode;
pub use canvas::off;
pub use canvas::on_nothing;
pub use canvas::pack;
pub use canvas::rgba;
pub use code::Change;
pub use code::Code;
pub use code::CodeLine;
pub use code::Files;
pub use code::Kind as CodeKind;
pub use code::Part as CodePart;
pub use code::Sought;
pub use compare::Comparison;
pub use compare::Difference;
pub use compare::TOLERANCE;
pub use compare::side_by_side;
pub use control::Control;
pub use control::Refused;
pub use desk::Act;
pub use desk::Asked;
pub use desk::Compare;
pub use desk::Desk;
pub use desk::Does;
pub use desk::Effect;
pub use desk::Gist;
pub use desk::Group;
pub use desk::Hand;
pub use desk::Key;
pub use desk::Program;
pub use desk::Reading;
pub use desk::Refusal;
pub use desk::Stop;
pub use desk::Tour;
pub use desk::Wanted;
pub use desk::WhatIf;
pub use desk::does;
pub use desk::table as keys;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Drawing;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Exercises;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Finished;
#[cfg(not(target_family = "wasm"))]
pub use desktop::LONGEST;
#[cfg(not(target_family = "wasm"))]
pub use desktop::MakePage;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Mistake;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Suite;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Verdict;
#[cfg(not(target_family = "wasm"))]
pub use desktop::Workspace;
#[cfg(not(target_family = "wasm"))]
pub use desktop::picture_shown;
#[cfg(not(target_family = "wasm"))]
pub use desktop::render_parallel;
#[cfg(not(target_family = "wasm"))]
pub use desktop::report;
#[cfg(not(target_family = "wasm"))]
#[doc(hidden)]
pub use desktop::run;
pub use figure::Axes;
pub use figure::Figure;
pub use figure::Sketch;
pub use figure::told;
pub use frame::Frame;
pub use frame::Size;
pub use frame::SizeError;
pub use frame::check_loop;
pub use language::Language;
pub use language::filled;
pub use language::translated;
pub use math::Boxed;
pub use math::Law;
pub use math::Letters;
pub use math::Math;
pub use math::Symbols;
pub use math::escaped;
pub use math::ink_of;
pub use math::latex;
pub use math::law_name;
pub use math::laws;
pub use math::mathml;
pub use math::plain;
pub use math::symbols;
pub use math::terms;
pub use math::typeset;
pub use outside::Outside;
pub use over::compared;
pub use over::draw_below;
pub use over::draw_marks;
pub use over::height_below;
pub use over::is_marked;
pub use over::point_at;
pub use prose::Prose;
pub use prose::prose;
pub use quantity::Curve;
pub use quantity::Legend;
pub use quantity::Lines;
pub use quantity::Look;
pub use quantity::Looked;
pub use quantity::Map;
pub use quantity::Quantity;
pub use quantity::Scale;
pub use quantity::Word;
pub use quantity::named_lines;
pub use session::Event;
pub use session::Session;
pub use setup::Handle;
pub use setup::Make;
pub use setup::Setting;
pub use setup::SettingError;
pub use setup::Setup;
pub use shown::Lesson;
pub use shown::Shown;
pub use sight::Sight;
pub use sight::Stroke;
pub use sight::first_hit;
pub use vectors::INKED;
pub use vectors::Mark;
pub use vectors::MarkShape;
pub use vectors::drag;
pub use vectors::draw_vectors;
pub use vectors::handle_at;
pub use vectors::marks;
pub use vectors::symbol_ink;
pub(crate) use written::glance;
pub use written::rounded;
pub use written::texts;
pub use written::written;
