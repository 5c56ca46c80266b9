//! The steps as the checks see them: what several of them have, under one name and in one set of
//! types, those of step 07, so that one check runs against all. A step takes from them what it knows.

use std::fmt::Display;

use common::*;
pub use lecture::step07_specular::intersection::IntersectionRecord as Hit;
pub use lecture::step07_specular::light::PointLight as Light;
pub use lecture::step07_specular::material::Material as Paint;
pub use lecture::step07_specular::sphere::Sphere as Ball;
use lecture::*;
use show::told;

/// How far the closed forms may be off. Their numbers stay below 16, and one that is the result
/// of a handful of operations is off by a handful of halves of the last bit of 16.
pub const TOLERANCE: f32 = 32.0 * f32::EPSILON;

/// A material with only a diffuse share.
pub const fn matte(k_d: Color) -> Paint {
    Paint { k_a: Color::ZERO, k_d, k_s: 0.0, p: 1.0 }
}

/// A light.
pub const fn light(position: Vec3, intensity: f32) -> Light {
    Light { name: "light", position, intensity }
}

/// The ε without shadows: no t lies in 1 < t < 1.
pub const UNSHADOWED: f32 = 1.0;

/// A scene; each step takes from it what it knows.
#[derive(Clone, Debug)]
pub struct World {
    /// The spheres.
    pub spheres: Vec<(Ball, Paint)>,
    /// The triangles.
    pub triangles: Vec<([Vec3; 3], Paint)>,
    /// What a ray sees that hits nothing.
    pub background: Color,
    /// The lights; step 05 knows the first.
    pub lights: Vec<Light>,
    /// I_a
    pub ambient: f32,
    /// ε; [`UNSHADOWED`] for a world without shadows.
    pub epsilon: f32,
}

impl Default for World {
    /// Nothing, before black.
    fn default() -> Self {
        Self {
            spheres: Vec::new(),
            triangles: Vec::new(),
            background: Color::ZERO,
            lights: Vec::new(),
            ambient: 0.0,
            epsilon: 1e-3,
        }
    }
}

/// Every step.
pub trait Package: Step + Clone + Default {
    /// The step's package.
    const NAME: &'static str;

    /// The ray through the pixel's centre.
    fn viewing_ray(camera: &dyn Camera, pixel: Pixel, say: &impl Listener) -> Ray;

    /// The slide's loop, with any function for `trace`.
    fn render_loop(camera: &dyn Camera, image: &mut Image<'_>, trace: &dyn Fn(&Ray) -> Color);
}

/// The steps with spheres, from 02 on.
pub trait Spheres: Package {
    /// The first hit with t_min < t < t_max.
    fn sphere(ball: Ball, ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener) -> Option<Hit>;
}

/// The steps with triangles, from 03 on.
pub trait Triangles: Spheres {
    /// The hit with t_min < t < t_max.
    fn triangle(
        abc: [Vec3; 3], ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener,
    ) -> Option<Hit>;

    /// t and α, β, γ of the point with t > 0 where `ray` meets the triangle's plane.
    fn solve(abc: [Vec3; 3], ray: &Ray) -> Option<(f32, Vec3)> {
        let [t, weights @ ..] = told(["t", "α", "β", "γ"], |say| {
            Self::triangle(abc, ray, 0.0, f32::INFINITY, say);
        })?;
        Some((t, Vec3::from(weights)))
    }
}

/// The number that `explanation` gives to `symbol`.
pub fn number(explanation: &Explanation, symbol: &str) -> Option<f32> {
    match explanation.value(symbol) {
        Some(Value::Number(number)) => Some(number),
        _ => None,
    }
}

/// The steps with scenes, from 04 on.
pub trait Scenes: Triangles {
    /// The step's own type.
    type Scene;

    /// What this step knows of `world`, as its own scene.
    fn scene(world: &World) -> Self::Scene;

    /// The closest hit, and k_d of what was hit.
    fn closest(scene: &Self::Scene, ray: &Ray, t_min: f32, t_max: f32) -> Option<(Hit, Color)>;

    /// The colour seen along `ray`.
    fn trace(scene: &Self::Scene, ray: &Ray) -> Color;
}

/// The steps with shadows, from 06 on.
pub trait Shadows: Scenes {
    /// Whether a light at `position` is hidden from `point`.
    fn is_blocked(scene: &Self::Scene, position: Vec3, point: Vec3) -> bool;
}

macro_rules! packages {
    ($($step:ident)*) => { $(
        impl Package for $step::Lesson {
            const NAME: &'static str = stringify!($step);

            fn viewing_ray(camera: &dyn Camera, pixel: Pixel, say: &impl Listener) -> Ray {
                $step::render::viewing_ray(camera, pixel, say)
            }

            fn render_loop(
                camera: &dyn Camera, image: &mut Image<'_>, trace: &dyn Fn(&Ray) -> Color,
            ) {
                $step::render::render(camera, image, trace);
            }
        }
    )* };
}

steps!(packages);

/// A step's record as a [`Hit`].
macro_rules! hit {
    ($record:expr) => {
        $record.map(|record| Hit { t: record.t, point: record.point, normal: record.normal })
    };
}

macro_rules! spheres {
    ($_01:ident $($step:ident)*) => { $(
        impl Spheres for $step::Lesson {
            fn sphere(
                ball: Ball, ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener,
            ) -> Option<Hit> {
                let sphere = $step::sphere::Sphere { center: ball.center, radius: ball.radius };
                hit!(sphere.intersect(ray, t_min, t_max, say))
            }
        }
    )* };
}

steps!(spheres);

macro_rules! triangles {
    ($_01:ident $_02:ident $($step:ident)*) => { $(
        impl Triangles for $step::Lesson {
            fn triangle(
                abc: [Vec3; 3], ray: &Ray, t_min: f32, t_max: f32, say: &impl Listener,
            ) -> Option<Hit> {
                hit!($step::triangle::Triangle::new(abc).intersect(ray, t_min, t_max, say))
            }
        }
    )* };
}

steps!(triangles);

/// `$look` is the field of an object that holds what `$made` makes of a [`Paint`], `$k_d` the diffuse
/// share of an object, and `$light` puts the lights of a [`World`] into a scene.
macro_rules! scenes {
    (
        $step:ident, $look:ident: $paint:ident => $made:expr, $object:ident => $k_d:expr,
        $scene:ident, $world:ident => { $($light:tt)* }
    ) => {
        impl Scenes for $step::Lesson {
            type Scene = $step::scene::Scene;

            fn scene($world: &World) -> Self::Scene {
                let object = |surface, $paint: &Paint| $step::scene::Object {
                    name: "object",
                    $look: $made,
                    surface,
                };
                let spheres = $world.spheres.iter().map(|(Ball { center, radius }, paint)| {
                    let sphere = $step::sphere::Sphere { center: *center, radius: *radius };
                    object($step::surface::Surface::Sphere(sphere), paint)
                });
                let triangles = $world.triangles.iter().map(|(abc, paint)| {
                    let triangle = $step::triangle::Triangle::new(*abc);
                    object($step::surface::Surface::Triangle(triangle), paint)
                });
                let mut $scene = $step::lecture_scene::lecture_scene();
                $scene.objects = spheres.chain(triangles).collect();
                $scene.background = $world.background;
                $($light)*
                $scene
            }

            fn closest(
                scene: &Self::Scene, ray: &Ray, t_min: f32, t_max: f32,
            ) -> Option<(Hit, Color)> {
                let (record, $object) = scene.intersect(ray, t_min, t_max, &Silent)?;
                hit!(Some(record)).zip(Some($k_d))
            }

            fn trace(scene: &Self::Scene, ray: &Ray) -> Color {
                scene.trace(ray, 0.0, f32::INFINITY, &Silent)
            }
        }
    };
}

/// A [`Light`] as the step's own.
macro_rules! point_light {
    ($step:ident, $light:expr) => {
        $step::light::PointLight {
            name: "light",
            position: $light.position,
            intensity: $light.intensity,
        }
    };
}

/// Puts all of a [`World`]'s lights into the scene of a step that knows several.
macro_rules! many_lights {
    ($step:ident, $scene:ident, $world:ident) => {
        $scene.lights = $world.lights.iter().map(|light| point_light!($step, light)).collect();
        $scene.ambient = $world.ambient;
        $scene.epsilon = $world.epsilon
    };
}

scenes!(step04_scene, color: paint => paint.k_d, object => object.color, scene, world => {});

scenes!(
    step05_diffuse, material: paint => step05_diffuse::material::Material { k_d: paint.k_d },
    object => object.material.k_d, scene, world => {
        let none = light(Vec3::ZERO, 0.0);
        scene.light = point_light!(step05_diffuse, world.lights.first().unwrap_or(&none));
    }
);

scenes!(
    step06_shadows,
    material: paint => step06_shadows::material::Material { k_a: paint.k_a, k_d: paint.k_d },
    object => object.material.k_d, scene, world => { many_lights!(step06_shadows, scene, world); }
);

/// The steps from 07 on: the floor has nothing of what they add to a material.
macro_rules! later_scenes {
    ($_01:ident $_02:ident $_03:ident $_04:ident $_05:ident $_06:ident $($step:ident)*) => { $(
        scenes!(
            $step, material: paint => {
                let lecture = $step::lecture_scene::lecture_scene();
                let mut floor = lecture.objects.into_iter().filter(|object| object.name == "floor");
                let mut material = floor.next().expect("the lecture's scene has a floor").material;
                material.k_a = paint.k_a;
                material.k_d = paint.k_d;
                material.k_s = paint.k_s;
                material.p = paint.p;
                material
            },
            object => object.material.k_d, scene, world => { many_lights!($step, scene, world); }
        );
    )* };
}

steps!(later_scenes);

macro_rules! shadows {
    ($_01:ident $_02:ident $_03:ident $_04:ident $_05:ident $($step:ident)*) => { $(
        impl Shadows for $step::Lesson {
            fn is_blocked(scene: &Self::Scene, position: Vec3, point: Vec3) -> bool {
                let light = point_light!($step, light(position, 1.0));
                scene.is_blocked(point, &light, &Silent)
            }
        }
    )* };
}

steps!(shadows);

/// Makes a test of each check, a function that is generic over the step, for every step that has
/// the thing checked: `checks!(spheres { one, another })` gives `spheres::step02_sphere::one` …
#[macro_export]
macro_rules! checks {
    ($thing:ident $checks:tt) => {
        ::lecture::steps!($crate::checks, @from $thing $checks);
    };
    (@from packages $checks:tt $($step:ident)*) => {
        $crate::checks!(@ packages $checks $($step)*);
    };
    (@from spheres $checks:tt $_01:ident $($step:ident)*) => {
        $crate::checks!(@ spheres $checks $($step)*);
    };
    (@from triangles $checks:tt $_01:ident $_02:ident $($step:ident)*) => {
        $crate::checks!(@ triangles $checks $($step)*);
    };
    (@from scenes $checks:tt $_01:ident $_02:ident $_03:ident $($step:ident)*) => {
        $crate::checks!(@ scenes $checks $($step)*);
    };
    (@from lights $checks:tt $_01:ident $_02:ident $_03:ident $_04:ident $($step:ident)*) => {
        $crate::checks!(@ lights $checks $($step)*);
    };
    (@from shadows $checks:tt $_01:ident $_02:ident $_03:ident $_04:ident $_05:ident
        $($step:ident)*) => {
        $crate::checks!(@ shadows $checks $($step)*);
    };
    (@ $thing:ident $checks:tt $($step:ident)*) => {
        mod $thing {
            $( $crate::checks!(@@ $step $checks); )*
        }
    };
    (@@ $step:ident { $($(#[$attribute:meta])* $check:ident),* $(,)? }) => {
        mod $step {
            $(
                #[test]
                $(#[$attribute])*
                fn $check() {
                    super::super::$check::<::lecture::$step::Lesson>();
                }
            )*
        }
    };
}

/// What can be nearly equal.
pub trait Near: Copy + Display {
    /// The largest difference in any part; not a number if any is none.
    fn difference(self, other: Self) -> f32;
}

impl Near for f32 {
    fn difference(self, other: Self) -> f32 {
        (self - other).abs()
    }
}

impl Near for Vec3 {
    fn difference(self, other: Self) -> f32 {
        let parts = (self - other).abs();
        if parts.is_nan() { f32::NAN } else { parts.max_element() }
    }
}

/// Fails unless `found` is `expected` within `tolerance`, with `why`.
#[track_caller]
pub fn assert_near<T: Near>(what: &str, found: T, expected: T, tolerance: f32, why: &str) {
    assert!(
        found.difference(expected) <= tolerance,
        "{what} is {found} and should be {expected}, within {tolerance:.1e}: {why}"
    );
}

/// Fails unless `found` is `expected` within [`TOLERANCE`], with the step's name and `why`.
#[track_caller]
pub fn near<S: Package, T: Near>(what: &str, found: T, expected: T, why: &str) {
    assert_near(&format!("{}: {what}", S::NAME), found, expected, TOLERANCE, why);
}

/// The hit, which must be there; fails with the step's name and `why`.
#[track_caller]
pub fn hit<S: Package>(hit: Option<Hit>, why: &str) -> Hit {
    let Some(hit) = hit else {
        panic!("{}: nothing is hit, and something should be: {why}", S::NAME);
    };
    hit
}

/// Fails if there is a hit, with the step's name and `why`.
#[track_caller]
pub fn miss<S: Package>(hit: Option<Hit>, why: &str) {
    let step = S::NAME;
    assert!(hit.is_none(), "{step}: {hit:?} was found, and nothing should be hit: {why}");
}
