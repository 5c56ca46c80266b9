//! Switching off what a step adds gives the step before it, to the last bit of every pixel.

use common::Camera;
use common::Color;
use common::Entry;
use common::Explanation;
use common::Pixel;
use common::Step;
use common::Value;
use common::Vec3;
use common::View;
use tests::every_step::Ball;
use tests::every_step::Package;
use tests::every_step::Paint;
use tests::every_step::Scenes;
use tests::every_step::World;

const WIDTH: usize = 96;
const HEIGHT: usize = 54;

/// The lecture's view and one from the side, in both projections.
fn views(step: &dyn Step) -> Vec<View> {
    let mut views = Vec::new();
    for (turn, projection) in [(0.0, 0), (0.0, 1), (50.0, 0), (-130.0, 1)] {
        let mut view = step.view();
        view.azimuth += turn;
        view.projection = projection;
        views.push(view);
    }
    views
}

fn camera(view: &View) -> Box<dyn Camera> {
    view.camera(WIDTH as f32 / HEIGHT as f32)
}

/// What `step` shows, in linear radiance.
fn colors(step: &dyn Step, view: &View) -> Vec<Color> {
    tests::colors(step, &*camera(view), WIDTH, HEIGHT)
}

/// Every pixel, explained.
fn explanations(step: &dyn Step, view: &View) -> Vec<Explanation> {
    let camera = camera(view);
    let pixel =
        |index| Pixel { col: index % WIDTH, row: index / WIDTH, width: WIDTH, height: HEIGHT };
    (0..WIDTH * HEIGHT).map(|index| step.explain(&*camera, pixel(index))).collect()
}

#[track_caller]
fn same<A: Package, B: Package>(later: &[Color], earlier: &[Color], why: &str) {
    let different = || later.iter().zip(earlier).enumerate().filter(|(_, (a, b))| a != b);
    let Some((index, (later, earlier))) = different().next() else { return };
    panic!(
        "{} of {} pixels of {} are not those of {}, first ({}, {}) of {WIDTH}x{HEIGHT}: \
         {later} instead of {earlier}; they should be, because {why}",
        different().count(),
        WIDTH * HEIGHT,
        A::NAME,
        B::NAME,
        index % WIDTH,
        index / WIDTH,
    );
}

/// Moves each control of `earlier` to both ends and the middle, the one of that name in `later`
/// with it, and compares what both show then.
fn same_whatever_is_set<A: Package, B: Package>(later: &A, earlier: &B, why: &str) {
    for view in views(earlier) {
        same::<A, B>(&colors(later, &view), &colors(earlier, &view), why);
    }
    let view = earlier.view();
    let names: Vec<String> =
        earlier.clone().controls().iter().map(|control| control.name.clone()).collect();
    for name in names {
        for fraction in [0.0, 0.5, 1.0] {
            let (mut later, mut earlier) = (later.clone(), earlier.clone());
            // A later step may have inserted another control of that name before it.
            let mut kinds = Vec::new();
            for controls in [earlier.controls(), later.controls()] {
                let mut control = controls.into_iter().find(|control| control.name == name);
                let control =
                    control.as_mut().expect("a later step keeps an earlier one's control");
                control.set_fraction(fraction);
                kinds.push((control.takes(), control.text()));
            }
            assert_eq!(kinds[0], kinds[1], "'{name}' of {} and {}", B::NAME, A::NAME);
            let why = format!("{why}; with {name} = {}", kinds[0].1);
            same::<A, B>(&colors(&later, &view), &colors(&earlier, &view), &why);
        }
    }
}

#[test]
fn step07_without_k_s_is_step06() {
    let mut later = step07_specular::Lesson::default();
    later.scene.spheres.iter_mut().for_each(|object| object.material.k_s = 0.0);
    later.scene.triangles.iter_mut().for_each(|object| object.material.k_s = 0.0);
    let earlier = step06_shadows::Lesson::default();
    same_whatever_is_set(&later, &earlier, "with k_s = 0 every L_s is 0: L = L_a + the sum of L_d");
}

#[test]
fn step07_without_l_s_is_step06() {
    let mut later = step07_specular::Lesson::default();
    later.scene.terms[2] = false;
    let earlier = step06_shadows::Lesson::default();
    same_whatever_is_set(&later, &earlier, "L_s is switched off: L = L_a + the sum of L_d");
}

#[test]
fn step06_with_one_light_and_no_shadow_is_step05() {
    let mut later = step06_shadows::Lesson::default();
    later.scene.ambient = 0.0;
    later.scene.lit = 1;
    later.scene.shadows = false;
    let earlier = step05_diffuse::Lesson::default();
    let why = "no ambient light, the key light alone and nothing in its way: L = L_d";
    same_whatever_is_set(&later, &earlier, why);
}

#[test]
fn step05_with_its_light_divided_out_is_step04() {
    let (later, earlier) = (step05_diffuse::Lesson::default(), step04_scene::Lesson::default());
    for view in views(&later) {
        let flat = colors(&earlier, &view);
        let number = |explanation: &Explanation, symbol| match explanation.value(symbol) {
            Some(Value::Number(number)) => Some(*number),
            _ => None,
        };
        let lit: Vec<Color> = explanations(&later, &view)
            .iter()
            .zip(&flat)
            .map(|(explanation, flat)| {
                let irradiance = number(explanation, "I/r²");
                match irradiance.zip(number(explanation, "n·l")) {
                    Some((irradiance, n_dot_l)) => *flat * irradiance * n_dot_l.max(0.0),
                    // The background is no surface, and so is not lit.
                    None => *flat,
                }
            })
            .collect();
        let why = "L_d = k_d (I/r²) max(0, n·l), and k_d is step 04's flat colour";
        same::<step05_diffuse::Lesson, step04_scene::Lesson>(&colors(&later, &view), &lit, why);
    }
}

/// What is known of a pixel before light comes in: all entries of the earlier step's explanation.
fn same_rays_and_hits<A: Package, B: Package>(later: &A, earlier: &B, view: &View) {
    for (a, b) in explanations(later, view).iter().zip(explanations(earlier, view)) {
        let shared = &a.entries()[..b.entries().len().min(a.entries().len())];
        let (later, earlier) = (A::NAME, B::NAME);
        assert_eq!(
            shared,
            b.entries(),
            "pixel ({}, {}): {later} should cast the rays of {earlier} and find its hits",
            a.pixel.col,
            a.pixel.row
        );
    }
}

#[test]
fn steps_04_to_07_hit_the_same() {
    for view in views(&step04_scene::Lesson::default()) {
        let steps = (
            step04_scene::Lesson::default(),
            step05_diffuse::Lesson::default(),
            step06_shadows::Lesson::default(),
            step07_specular::Lesson::default(),
        );
        same_rays_and_hits(&steps.1, &steps.0, &view);
        same_rays_and_hits(&steps.2, &steps.0, &view);
        same_rays_and_hits(&steps.3, &steps.0, &view);
    }
}

#[test]
fn step04_with_one_triangle_covers_what_step03_does() {
    let earlier = step03_triangle::Lesson::default();
    let later = step04_scene::Lesson {
        scene: step04_scene::Lesson::scene(&World {
            triangles: vec![(earlier.vertices, Paint::matte(Color::ONE))],
            ..World::default()
        }),
        ..step04_scene::Lesson::default()
    };
    for view in views(&earlier) {
        // α + β + γ = 1 inside, so that no pixel of it is black.
        let covered: Vec<Color> = colors(&earlier, &view)
            .into_iter()
            .map(|weights| if weights == Color::ZERO { Color::ZERO } else { Color::ONE })
            .collect();
        let why = "its triangle is all there is, in white";
        same::<step04_scene::Lesson, step03_triangle::Lesson>(
            &colors(&later, &view),
            &covered,
            why,
        );
    }
}

#[test]
fn step04_with_the_unit_sphere_is_step02() {
    let earlier = step02_sphere::Lesson::default();
    let ball = Ball { center: Vec3::ZERO, radius: 1.0 };
    let later = step04_scene::Lesson {
        scene: step04_scene::Lesson::scene(&World {
            spheres: vec![(ball, Paint::matte(Color::ONE))],
            ..World::default()
        }),
        ..step04_scene::Lesson::default()
    };
    for view in views(&earlier) {
        let why = "the slide's white unit sphere on black is all there is";
        let (later, earlier) = (colors(&later, &view), colors(&earlier, &view));
        same::<step04_scene::Lesson, step02_sphere::Lesson>(&later, &earlier, why);
    }
}

#[test]
fn steps_02_and_03_cast_the_rays_of_step01() {
    let first = step01_rays::Lesson::default();
    let (second, third) = (step02_sphere::Lesson::default(), step03_triangle::Lesson::default());
    assert_eq!(second.view(), first.view(), "step 02 keeps the view of step 01");
    assert_eq!(third.view(), first.view(), "step 03 keeps the view of step 01");
    for view in views(&first) {
        same_rays_and_hits(&second, &first, &view);
        same_rays_and_hits(&third, &first, &view);
    }
}

#[test]
fn the_pictures_compared_show_something() {
    // Black equals black: what is neutral must not be nothing. Step 01 does show one colour where
    // it should: parallel rays have one direction.
    for step in (1..tests::STEPS.len()).map(tests::step) {
        for view in views(&*step) {
            let colors = colors(&*step, &view);
            assert!(colors.iter().any(|color| *color != colors[0]), "{view:?} shows one colour");
        }
    }
}

#[test]
fn explanations_compared_name_what_is_hit() {
    let step = step04_scene::Lesson::default();
    let explanations = explanations(&step, &step.view());
    for name in ["floor", "red sphere", "green sphere", "blue sphere", "pyramid", "background"] {
        let heading = Entry::Heading(name.to_owned());
        let found = explanations.iter().any(|explanation| explanation.entries().contains(&heading));
        assert!(found, "no pixel of the lecture scene shows the {name}");
    }
}
