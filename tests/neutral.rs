//! Switching off what a step adds gives the step before it, to the last bit of every pixel.

use common::Control;
use tests::prelude::*;

const WIDTH: usize = 96;
const HEIGHT: usize = 54;

/// The lecture's view and one from the side, in both projections.
fn views(step: &dyn Step) -> Vec<View> {
    let mut views = Vec::new();
    for (turn, projection) in [
        (0.0, Projection::Perspective),
        (0.0, Projection::Parallel),
        (50.0, Projection::Perspective),
        (-130.0, Projection::Parallel),
    ] {
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
    for place in 0..earlier.clone().controls().len() {
        for fraction in [0.0, 0.5, 1.0] {
            let (mut later, mut earlier) = (later.clone(), earlier.clone());
            let (name, of, takes, text) = {
                let control = &mut earlier.controls()[place];
                control.set_fraction(fraction);
                (control.name.clone(), control.of, control.takes(), control.text())
            };
            let mut controls = later.controls();
            let same_one = |other: &&mut Control<'_>| other.name == name && other.of == of;
            let control = controls.iter_mut().find(same_one);
            let control = control.unwrap_or_else(|| {
                panic!("{} has lost the control '{name}' of {}, {of:?}", A::NAME, B::NAME)
            });
            control.set_fraction(fraction);
            assert_eq!((control.takes(), control.text()), (takes, text.clone()), "'{name}'");
            drop(controls);
            let why = format!("{why}; with {name} = {text} of {of:?}");
            same::<A, B>(&colors(&later, &view), &colors(&earlier, &view), &why);
        }
    }
}

#[test]
fn step07_without_k_s_is_step06() {
    let mut later = lecture::step07_specular::Lesson::default();
    later.scene.objects.iter_mut().for_each(|object| object.material.k_s = 0.0);
    let earlier = lecture::step06_shadows::Lesson::default();
    same_whatever_is_set(&later, &earlier, "with k_s = 0 every L_s is 0: L = L_a + the sum of L_d");
}

#[test]
fn step07_without_l_s_is_step06() {
    let mut later = lecture::step07_specular::Lesson::default();
    later.scene.weights[2] = 0.0;
    let earlier = lecture::step06_shadows::Lesson::default();
    same_whatever_is_set(&later, &earlier, "the weight of L_s is 0: L = L_a + the sum of L_d");
}

#[test]
fn step06_with_one_light_and_no_shadow_is_step05() {
    let mut later = lecture::step06_shadows::Lesson::default();
    later.scene.ambient = 0.0;
    later.scene.lit = 1;
    later.scene.shadows = false;
    let earlier = lecture::step05_diffuse::Lesson::default();
    let why = "no ambient light, the key light alone and nothing in its way: L = L_d";
    same_whatever_is_set(&later, &earlier, why);
}

#[test]
fn step05_with_its_light_divided_out_is_step04() {
    let (later, earlier) =
        (lecture::step05_diffuse::Lesson::default(), lecture::step04_scene::Lesson::default());
    for view in views(&later) {
        let flat = colors(&earlier, &view);
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
        same::<lecture::step05_diffuse::Lesson, lecture::step04_scene::Lesson>(
            &colors(&later, &view),
            &lit,
            why,
        );
    }
}

/// What is known of a pixel before light comes in: the ray, and from step 04 on all hits.
fn same_rays_and_hits<A: Package, B: Package>(
    later: &A, earlier: &B, view: &View, sections: usize,
) {
    for (a, b) in explanations(later, view).iter().zip(explanations(earlier, view)) {
        assert_eq!(
            a.sections[..sections],
            b.sections[..sections],
            "pixel ({}, {}): {} should cast the rays of {} and find its hits",
            a.pixel.col,
            a.pixel.row,
            A::NAME,
            B::NAME
        );
    }
}

#[test]
fn steps_04_to_07_hit_the_same() {
    let first = lecture::step04_scene::Lesson::default();
    for view in views(&first) {
        same_rays_and_hits(&lecture::step05_diffuse::Lesson::default(), &first, &view, 2);
        same_rays_and_hits(&lecture::step06_shadows::Lesson::default(), &first, &view, 2);
        same_rays_and_hits(&lecture::step07_specular::Lesson::default(), &first, &view, 2);
    }
}

#[test]
fn step04_with_one_triangle_covers_what_step03_does() {
    let earlier = lecture::step03_triangle::Lesson::default();
    let later = lecture::step04_scene::Lesson {
        scene: lecture::step04_scene::Lesson::scene(&World {
            triangles: vec![(earlier.vertices, Paint::matte(Color::ONE))],
            ..World::default()
        }),
    };
    for view in views(&earlier) {
        // α + β + γ = 1 inside, so that no pixel of it is black.
        let covered: Vec<Color> = colors(&earlier, &view)
            .into_iter()
            .map(|weights| if weights == Color::ZERO { Color::ZERO } else { Color::ONE })
            .collect();
        let why = "its triangle is all there is, in white";
        same::<lecture::step04_scene::Lesson, lecture::step03_triangle::Lesson>(
            &colors(&later, &view),
            &covered,
            why,
        );
    }
}

#[test]
fn step04_with_the_unit_sphere_is_step02() {
    let earlier = lecture::step02_sphere::Lesson::default();
    let ball = Ball { center: Vec3::ZERO, radius: 1.0 };
    let later = lecture::step04_scene::Lesson {
        scene: lecture::step04_scene::Lesson::scene(&World {
            spheres: vec![(ball, Paint::matte(Color::ONE))],
            ..World::default()
        }),
    };
    for view in views(&earlier) {
        let why = "the slide's white unit sphere on black is all there is";
        let (later, earlier) = (colors(&later, &view), colors(&earlier, &view));
        same::<lecture::step04_scene::Lesson, lecture::step02_sphere::Lesson>(
            &later, &earlier, why,
        );
    }
}

#[test]
fn steps_02_and_03_cast_the_rays_of_step01() {
    let first = lecture::step01_rays::Lesson::default();
    let (second, third) =
        (lecture::step02_sphere::Lesson::default(), lecture::step03_triangle::Lesson::default());
    assert_eq!(second.view(), first.view(), "step 02 keeps the view of step 01");
    assert_eq!(third.view(), first.view(), "step 03 keeps the view of step 01");
    for view in views(&first) {
        for sections in [explanations(&second, &view), explanations(&third, &view)] {
            for (a, b) in sections.iter().zip(explanations(&first, &view)) {
                let lines = &b.sections[0].groups[0].lines[..3];
                assert_eq!(
                    a.sections[0].groups[0].lines, lines,
                    "(u, v), p and d are those of step 01"
                );
            }
        }
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
