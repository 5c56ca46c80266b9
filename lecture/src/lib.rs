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
    /// Its handout, in Markdown.
    #[cfg(feature = "desktop")]
    pub handout: &'static str,
    /// Its diff to the step before; "" of the first.
    #[cfg(feature = "desktop")]
    pub diff: &'static str,
}

macro_rules! programs {
    ($($step:ident $diff:expr),*) => {
        /// The steps, in the order of the lecture.
        pub const PROGRAMS: [Program; [$(stringify!($step)),*].len()] = [$(Program {
            name: stringify!($step),
            make: || Box::new($step::Lesson::default()),
            #[cfg(feature = "desktop")]
            handout: include_str!(concat!("../../", stringify!($step), "/README.md")),
            #[cfg(feature = "desktop")]
            diff: $diff,
        }),*];
    };
}

programs! {
    step01_rays "",
    step02_sphere include_str!("../../tests/diffs/step02_sphere.diff"),
    step03_triangle include_str!("../../tests/diffs/step03_triangle.diff"),
    step04_scene include_str!("../../tests/diffs/step04_scene.diff"),
    step05_diffuse include_str!("../../tests/diffs/step05_diffuse.diff"),
    step06_shadows include_str!("../../tests/diffs/step06_shadows.diff"),
    step07_specular include_str!("../../tests/diffs/step07_specular.diff")
}
