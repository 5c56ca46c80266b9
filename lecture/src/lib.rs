//! The whole class at once: all seven steps behind one door.
//!
//! [`PROGRAMS`] is the only place that names them all. [`Page`] answers a browser; what it is asked
//! comes from `page/page.js`, through the three functions of `exports.rs`.

#[cfg(target_family = "wasm")]
mod exports;
mod page;

pub use page::Page;

use common::Step;

/// A step as a program.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// The step's package.
    pub name: &'static str,
    /// Makes the step as it starts.
    pub make: fn() -> Box<dyn Step>,
}

/// The steps, in the order of the lecture.
pub const PROGRAMS: [Program; 7] = [
    program::<step01_rays::Lesson>("step01_rays"),
    program::<step02_sphere::Lesson>("step02_sphere"),
    program::<step03_triangle::Lesson>("step03_triangle"),
    program::<step04_scene::Lesson>("step04_scene"),
    program::<step05_diffuse::Lesson>("step05_diffuse"),
    program::<step06_shadows::Lesson>("step06_shadows"),
    program::<step07_specular::Lesson>("step07_specular"),
];

const fn program<S: Step + Default + 'static>(name: &'static str) -> Program {
    Program { name, make: || Box::new(S::default()) }
}
