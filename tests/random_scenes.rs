//! Random scenes look the same to step 07 and to POV-Ray.
//!
//! Every channel of every pixel is within 1/255 of what POV-Ray makes of the same scene, without a
//! single exception counted. What is allowed for is this: the step's 32-bit numbers and POV-Ray's
//! 64-bit ones put a silhouette, a shadow's edge or the end of a highlight at places that differ
//! by a tiny part of a pixel. So a pixel is right if POV-Ray's colour is the step's own, at the
//! pixel's centre or at one of eight places [`SHIFT`] of a pixel around it. On a smooth surface
//! all nine are one colour; on an edge they are the colours of both sides, and no other colour
//! will do. What is closer to a surface than [`CLOSE`] may block its light or not: POV-Ray lets light
//! pass within a thousandth, and where light grazes, 32 bits see a sphere before itself.

use std::array;
use std::collections::HashSet;
use std::fs;
use std::path::Path;

use fastrand::Rng;
use lecture::step07_specular::Lesson;
use lecture::step07_specular::scene::Object;
use lecture::step07_specular::scene::Scene;
use lecture::step07_specular::surface::Surface;
use lecture::step07_specular::triangle::Triangle;
use rayon::iter::IntoParallelIterator;
use rayon::iter::ParallelIterator;
use tests::prelude::*;

/// How far from the centre of a pixel an edge may have moved, in pixels.
const SHIFT: f32 = 1.0 / 256.0;

/// The ε of the step's shadow rays. At 10⁻⁵ surfaces would shadow themselves.
const EPSILON: f32 = 3e-5;

/// The ε that lets pass what POV-Ray does: lights are at least three units away.
const CLOSE: f32 = 3e-4;

/// A scene and a camera, as random numbers make them.
struct RandomScene {
    scene: Scene,
    /// The vertices of the scene's triangles.
    vertices: Vec<[Vec3; 3]>,
    view: View,
    size: Size,
}

/// A camera that looks a little past the place it is asked for.
struct Shifted<'a> {
    camera: &'a dyn Camera,
    u: f32,
    v: f32,
}

impl Camera for Shifted<'_> {
    fn generate_ray(&self, u: f32, v: f32) -> Ray {
        self.camera.generate_ray(u + self.u, v + self.v)
    }
}

fn between(rng: &mut Rng, low: f32, high: f32) -> f32 {
    low + (high - low) * rng.f32()
}

/// Three numbers from `low` to `high`.
fn vector(rng: &mut Rng, low: f32, high: f32) -> Vec3 {
    Vec3::from_array(array::from_fn(|_| between(rng, low, high)))
}

/// A point `low` to `high` away from the origin.
fn around(rng: &mut Rng, low: f32, high: f32) -> Vec3 {
    between(rng, low, high) * vector(rng, -1.0, 1.0).normalize_or(Vec3::Y)
}

fn random_material(rng: &mut Rng) -> Paint {
    let k_d = vector(rng, 0.1, 0.9);
    let (k_a, k_s) = (between(rng, 0.0, 0.3) * k_d, between(rng, 0.0, 0.8));
    Paint { k_a, k_d, k_s, p: 400_f32.powf(rng.f32()) }
}

fn random_light(rng: &mut Rng) -> Light {
    let position = around(rng, 4.0, 9.0);
    light(position.with_y(position.y.abs()), between(rng, 10.0, 40.0))
}

impl RandomScene {
    fn new(seed: u64) -> Self {
        let rng = &mut Rng::with_seed(seed);
        let mut spheres: Vec<_> = (0..rng.usize(2..=6))
            .map(|_| Ball { center: vector(rng, -2.5, 2.5), radius: between(rng, 0.2, 1.3) })
            .collect();
        let mut vertices: Vec<_> = (0..rng.usize(2..=6))
            .map(|_| {
                let center = vector(rng, -2.0, 2.0);
                array::from_fn(|_| center + vector(rng, -2.0, 2.0))
            })
            .collect();
        // What catches the shadows: a floor, or a sphere with everything inside.
        if rng.bool() {
            let [a, b, c, d] = [(-9.0, -9.0), (-9.0, 9.0), (9.0, 9.0), (9.0, -9.0)]
                .map(|(x, z)| Vec3::new(x, -1.5, z));
            vertices.extend([[a, b, c], [a, c, d]]);
        } else {
            spheres.push(Ball { center: vector(rng, -1.0, 1.0), radius: 13.0 });
        }
        let triangles = vertices.iter().map(|abc| Surface::Triangle(Triangle::new(*abc)));
        let surfaces = spheres.into_iter().map(Surface::Sphere).chain(triangles);
        let objects = surfaces
            .map(|surface| Object { name: "o", material: random_material(rng), surface })
            .collect();
        let lights: Vec<_> = (0..rng.usize(1..=3)).map(|_| random_light(rng)).collect();
        let scene = Scene {
            objects,
            background: vector(rng, 0.0, 0.2),
            lights,
            ambient: between(rng, 0.5, 1.5),
            epsilon: EPSILON,
        };
        let (eye, target) = (around(rng, 8.0, 11.0), vector(rng, -0.5, 0.5));
        let mut view = View::new(eye.with_y(eye.y.abs()), target, between(rng, 30.0, 60.0));
        view.projection = View::PROJECTIONS[rng.usize(..2)].1;
        let (width, height) = [(160, 90), (120, 120), (90, 160)][rng.usize(..3)];
        let size = Size::new(width, height).expect("a size");
        Self { scene, vertices, view, size }
    }

    /// The step's picture with this ε, seen `u` and `v` pixels past each pixel's centre.
    fn picture(&self, epsilon: f32, u: f32, v: f32) -> RgbImage {
        let step = &Lesson { scene: Scene { epsilon, ..self.scene.clone() } };
        let (u, v) = (u / self.size.width() as f32, v / self.size.height() as f32);
        let camera = &Shifted { camera: &*self.view.camera(self.size.aspect()), u, v };
        Frame { step, camera, size: self.size, samples: 1 }.render()
    }

    /// The scene in POV-Ray's language, with the words and tricks of `references/lecture.pov`.
    fn pov(&self) -> String {
        let Self { scene, view, size, .. } = self;
        let vector = |v: Vec3| format!("<{}, {}, {}>", v.x, v.y, v.z);
        let aspect = format!("{} / {}", size.width(), size.height());
        let tan = format!("tan(radians({} / 2))", view.field_of_view);
        let height = format!("2 * {} * {tan}", view.distance);
        let camera = match view.projection {
            Projection::Perspective => format!(
                "perspective right -x * {aspect} up y angle 2 * degrees(atan2({tan} * {aspect}, 1))"
            ),
            Projection::Parallel => {
                format!("orthographic right -x * {height} * {aspect} up y * {height}")
            }
        };
        let lights = scene.lights.iter().map(|light| {
            let (position, intensity) = (vector(light.position), light.intensity);
            let fading = "* 1000000 / 2 fade_distance 0.001 fade_power 2";
            format!("light_source {{ {position} color rgb {intensity} {fading} }}")
        });
        let texture = |material: &Paint| {
            let (k_a, k_d) = (vector(material.k_a), vector(material.k_d));
            let highlight = format!("specular {} roughness 1 / {}", material.k_s, material.p);
            let finish = format!("finish {{ ambient rgb {k_a} / {k_d} diffuse 1 {highlight} }}");
            format!("texture {{ pigment {{ color rgb {k_d} }} {finish} }}")
        };
        let mut vertices = self.vertices.iter();
        let objects = scene.objects.iter().map(|Object { material, surface, .. }| match surface {
            Surface::Sphere(Ball { center, radius }) => {
                format!("sphere {{ {}, {radius} {} }}", vector(*center), texture(material))
            }
            Surface::Triangle(_) => {
                let [a, b, c] = vertices.next().expect("a triangle has vertices").map(vector);
                format!("triangle {{ {a}, {b}, {c} {} }}", texture(material))
            }
        });
        let head = [
            "#version 3.7;".to_owned(),
            format!(
                "global_settings {{ assumed_gamma 1.0 max_trace_level 1 ambient_light rgb {} }}",
                scene.ambient
            ),
            format!(
                "camera {{ {camera} location {} look_at {} }}",
                vector(view.eye()),
                vector(view.target())
            ),
            format!("background {{ rgb {} }}", vector(scene.background)),
        ];
        let lines = head.into_iter().chain(lights).chain(objects);
        lines.map(|line| line + "\n").collect()
    }
}

fn looks_the_same_to_pov_ray(seed: u64) {
    let random = RandomScene::new(seed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let path = folder.join(format!("random_scene_{seed}.pov"));
    fs::write(&path, random.pov()).expect("the target folder can be written to");
    let size = (random.size.width(), random.size.height());
    let expected = povray::render(&path, &[], size, &path.with_extension("png"));

    let shifts = [0.0, -SHIFT, SHIFT];
    let shifts = shifts.into_iter().flat_map(|u| shifts.map(|v| (u, v)));
    let pictures: Vec<_> = shifts.map(|(u, v)| random.picture(EPSILON, u, v)).collect();
    let (at_center, nearby) = (&pictures[0], &pictures[1..]);
    let close = random.picture(CLOSE, 0.0, 0.0);
    let (mut inexact, mut edges, mut touching, mut wrong) = (0, 0, 0, Vec::new());
    for (col, row, pixel) in expected.enumerate_pixels() {
        // What rounding to a byte may make of a channel is allowed.
        let is_in = |picture: &RgbImage| off(picture.get_pixel(col, row).0, pixel.0) <= 1;
        inexact += usize::from(at_center.get_pixel(col, row) != pixel);
        if is_in(at_center) {
            continue;
        }
        if nearby.iter().any(is_in) {
            edges += 1;
        } else if is_in(&close) {
            touching += 1;
        } else {
            wrong.push((col, row));
        }
    }
    say(&format!(
        "random scene {seed}: {inexact} of {} pixels differ at all, {edges} are on an edge, \
         {touching} where surfaces touch",
        size.0 * size.1
    ));
    let seen = expected.pixels().collect::<HashSet<_>>().len();
    assert!(seen > 100, "random scene {seed} has {seen} colours: there is nothing to see in it");
    if let Some(&(col, row)) = wrong.first() {
        let picture = path.with_file_name(format!("random_scene_{seed}_differs.png"));
        side_by_side(&expected, at_center).save(&picture).expect("a picture");
        panic!(
            "random scene {seed}: {} pixels of step 07 are not what POV-Ray makes of them; the \
             first is ({col}, {row}), {:?} instead of {:?}\n  the scene: {}\n  \
             expected, found, 8 × their difference: {}",
            wrong.len(),
            at_center.get_pixel(col, row).0,
            expected.get_pixel(col, row).0,
            path.display(),
            picture.display()
        );
    }
}

#[test]
#[ignore = "needs POV-Ray"]
fn scenes_look_the_same_to_pov_ray() {
    (1..=60).into_par_iter().for_each(looks_the_same_to_pov_ray);
}
