//! Switching off what a step adds gives the step before it, to the last bit of every pixel.

use std::rc::Rc;

use lecture::step04_scene::Lesson as Flat;
use lecture::step05_diffuse::Lesson as Diffuse;
use lecture::step06_shadows::Lesson as Shadow;
use tests::prelude::*;

const WIDTH: usize = 96;
const HEIGHT: usize = 54;

/// The lecture's view and one from the side, in both projections.
fn views(step: &dyn AnyStep) -> [View; 4] {
    let [perspective, parallel] = PROJECTIONS;
    [(0.0, perspective), (0.0, parallel), (50.0, perspective), (-130.0, parallel)].map(
        |(turn, projection)| {
            let mut view = step.view();
            view.orbit(turn, 0.0);
            view.projection = projection;
            view
        },
    )
}

fn camera(view: &View) -> Box<dyn Camera> {
    view.camera(WIDTH as f32 / HEIGHT as f32)
}

fn colors(step: &dyn AnyStep, view: &View) -> Vec<Color> {
    tests::colors(step, &*camera(view), WIDTH, HEIGHT)
}

fn explanations(step: &dyn AnyStep, view: &View) -> Vec<Explanation> {
    let camera = camera(view);
    pixels(WIDTH, HEIGHT).map(|pixel| step.explain(&*camera, pixel)).collect()
}

#[track_caller]
fn same(later: &[Color], earlier: &[Color], why: &str) {
    let mut places = pixels(WIDTH, HEIGHT).zip(later.iter().zip(earlier));
    if let Some((pixel, (later, earlier))) = places.find(|(_, (a, b))| a != b) {
        panic!("{pixel:?} is {later} instead of {earlier}, the earlier step's, because {why}");
    }
    // Black equals black: what is neutral must not be nothing.
    assert!(later.iter().any(|color| *color != later[0]), "one colour: {why}");
}

fn set_up<S: Tell + Clone + 'static>(step: &S) -> Setup {
    let step = step.clone();
    Setup::new(Rc::new(move || Box::new(Lesson(Box::new(step.clone())))))
}

/// Moves each control of `earlier` to both ends and the middle, the one of that name in `later`
/// with it, and compares what both show then.
fn same_whatever_is_set(
    later: &(impl Tell + Clone + 'static), earlier: &(impl Tell + Clone + 'static), why: &str,
) {
    for view in views(earlier) {
        same(&colors(later, &view), &colors(earlier, &view), why);
    }
    let view = earlier.view();
    let (mut later, mut earlier) = (set_up(later), set_up(earlier));
    let own = earlier.list().into_iter().filter(|it| it.control.group != "camera");
    for (place, Setting { name, control, .. }) in own.enumerate() {
        let is_it = |it: &Setting| (&it.control.name, it.control.of) == (&control.name, control.of);
        let found = later.list().into_iter().position(|it| is_it(&it));
        let found = found.unwrap_or_else(|| panic!("there is no '{name}'"));
        let of_later = later.list()[found].name.clone();
        for fraction in [0.0, 0.5, 1.0] {
            earlier.set_fraction(&name, fraction);
            later.set_fraction(&of_later, fraction);
            let control = earlier.list()[place].control.clone();
            assert_eq!(later.list()[found].control, control, "'{name}' is the same control");
            let why = format!("{why}; with {name} = {}", control.text());
            same(&colors(later.step(), &view), &colors(earlier.step(), &view), &why);
        }
        earlier.reset_all();
        later.reset_all();
    }
}

#[test]
fn step07_without_k_s_is_step06() {
    let mut later = Specular::default();
    later.scene.objects.iter_mut().for_each(|object| object.material.k_s = 0.0);
    let why = "with k_s = 0 every L_s is 0: L = L_a + the sum of L_d";
    same_whatever_is_set(&later, &Shadow::default(), why);
}

#[test]
fn step06_with_one_light_and_no_shadow_is_step05() {
    let mut later = Shadow::default();
    later.scene.ambient = 0.0;
    later.scene.lights[1].intensity = 0.0;
    later.scene.epsilon = UNSHADOWED;
    let why = "no ambient light, the key light alone, and no t lies in 1 < t < 1: L = L_d";
    same_whatever_is_set(&later, &Diffuse::default(), why);
}

#[test]
fn step05_with_its_light_divided_out_is_step04() {
    let (later, earlier) = (Diffuse::default(), Flat::default());
    for view in views(&later) {
        let mut lit = colors(&earlier, &view);
        for (color, told) in lit.iter_mut().zip(explanations(&later, &view)) {
            // The background is no surface, and so is not lit.
            if let Some((irradiance, n_dot_l)) = number(&told, "I/r²").zip(number(&told, "n·l")) {
                *color = *color * irradiance * n_dot_l.max(0.0);
            }
        }
        let why = "L_d = k_d (I/r²) max(0, n·l), and k_d is step 04's flat colour";
        same(&colors(&later, &view), &lit, why);
    }
}
