//! Solutions of the exercises, right and wrong: a step's source with some of its text replaced.

/// The text of a file that is replaced, and by what.
pub(crate) type Change = (&'static str, &'static str, &'static str);

/// Right solutions: the step that they reach, from 1 on, and how they are written differently.
#[rustfmt::skip]
pub(crate) const RIGHT: &[(usize, &[Change])] = &[
    (1, &[("render.rs", "(col as f32 + 0.5) / width as f32", "(2 * col + 1) as f32 / (2 * width) as f32")]),
    (1, &[("render.rs", "1.0 - (row as f32 + 0.5) / height as f32", "((height - row) as f32 - 0.5) / height as f32")]),
    (1, &[WHOLE]),
    (2, &[TEXTBOOK]),
    (2, &[("sphere.rs", "if discriminant < 0.0", "if q_squared > self.radius.powi(2)")]),
    (2, &[("sphere.rs", "[t_1, t_2]", "[t_1.min(t_2), t_1.max(t_2)]")]),
    (3, &[("triangle.rs", "let alpha = say.area(\"α = 1 − β − γ\", [point, b, c], 1.0 - beta - gamma);", AREAS)]),
    (3, &[("triangle.rs", "normal.dot(a - p) / det_abc", "det(a - b, a - c, a - p) / det(a - b, a - c, d)")]),
    (4,
        &[("lecture_scene.rs", "let mut objects = vec![", "let mut objects: Vec<Object> = Vec::new(); let last = vec!["),
         ("lecture_scene.rs", "    objects.extend([face(0, 1), face(1, 2), face(2, 3), face(3, 0)]);", "    objects.extend([face(3, 0), face(0, 1), face(1, 2), face(2, 3)]); objects.extend(last);")]),
    (4, &[TEXTBOOK]),
    (4,
        &[("scene.rs", "if let Some(record) = object.surface.intersect(ray, t_min, t_max, say) {", "if let Some(record) = object.surface.intersect(ray, t_min, f32::INFINITY, say) && record.t < t_max {")]),
    (5, &[("material.rs", "point, to_light.normalize()", "point, to_light / to_light.length()")]),
    (5, &[TEXTBOOK, ("material.rs", "if normal.dot(v) < 0.0 { -normal } else { normal }", "normal.dot(v).signum() * normal")]),
    (5,
        &[("material.rs", "light.intensity / r_squared", "light.intensity / to_light.length() / to_light.length()"),
         ("material.rs", "k_d * irradiance * n_dot_l.max(0.0)", "n_dot_l.clamp(0.0, 1.0) * irradiance * k_d")]),
    (6,
        &[("scene.rs", "let shadow_ray = Ray::new(point, light.position - point);", "let r = (light.position - point).length(); let shadow_ray = Ray::new(point, (light.position - point) / r);"),
         ("scene.rs", "self.epsilon, 1.0, &Silent", "r * self.epsilon, r, &Silent")]),
    (6,
        &[("scene.rs", "self.intersect(&shadow_ray, self.epsilon, 1.0, &Silent)", "self.objects.iter().find_map(|object| Some((object.surface.intersect(&shadow_ray, self.epsilon, 1.0, &Silent)?, object)))")]),
    (6,
        &[("scene.rs", "let mut result = say.term(\"L_a = k_a I_a\", k_a * i_a);", "let mut result = Color::ZERO;"),
         ("scene.rs", "say.sum(\"L\", result)", "say.sum(\"L\", result + k_a * i_a)")]),
    (6, &[TEXTBOOK, ("scene.rs", "in &self.lights", "in self.lights.iter().rev()")]),
    (7, &[WHOLE, ("material.rs", "(v + l).normalize()", "(v + l) / (v + l).length()")]),
    (7, &[("material.rs", "n_dot_h.max(0.0).powf(p)", "(p * n_dot_h.max(0.0).ln()).exp()")]),
    (7, &[TEXTBOOK, ("material.rs", "l_d + say.term(\"L_s = k_s (I/r²) max(0, n·h)^p\", l_s)", "say.term(\"L_s = k_s (I/r²) max(0, n·h)^p\", l_s) + l_d")]),
];

/// The discriminant as in textbooks, b² − a c.
const TEXTBOOK: Change = discriminant("b * b - a * (p.dot(p) - self.radius.powi(2))");

/// The slide's loop over all rows, whichever are asked for.
const WHOLE: Change = ("render.rs", "in image.rows()", "in 0..image.height()");

/// `other` in place of the sphere's discriminant.
const fn discriminant(other: &'static str) -> Change {
    ("sphere.rs", "a * (self.radius.powi(2) - q_squared)", other)
}

/// Each weight the share of an area.
const AREAS: &str = "
        let area = |p: Vec3, q: Vec3, r: Vec3| (q - p).cross(r - p).dot(normal);
        let whole = area(a, b, c);
        let [alpha, beta, gamma] =
            [area(point, b, c), area(a, point, c), area(a, b, point)].map(|part| part / whole);";

/// Solutions on the way: the step, words of its handout, the changes, and how what is said to be right so
/// far begins.
#[rustfmt::skip]
pub(crate) const MILESTONES: &[(usize, &str, &[Change], &str)] = &[
    (2, "Begin with a white pixel for a positive discriminant", &[ANY_T], "white where D > 0"),
    (3,
        "Solve for t first and colour the whole plane",
        &[WHOLE_PLANE, ("lib.rs", "Color::new(alpha, beta, gamma)", "Color::new(0.9, 0.4, 0.0 * (alpha + beta + gamma))")],
        "the plane"),
    (3, "then β and γ", &[WHOLE_PLANE], "t, α, β and γ"),
    (4, "then a list of one sphere", &[("lecture_scene.rs", "Scene { objects,", "objects.truncate(1); Scene { objects,")], "a list of one sphere"),
    (4, "then a list of one sphere", &[("lecture_scene.rs", "Scene { objects,", "objects.drain(..2); objects.truncate(1); Scene { objects,")], "a list of one sphere"),
    (4, "then the loop over all of them", &[("lecture_scene.rs", "Scene { objects,", "objects.truncate(3); Scene { objects,")], "the loop over all spheres"),
    (5, "Begin with k_d max(0, n·l)", &[("material.rs", "light.intensity / r_squared", "1.0 + 0.0 * r_squared")], "k_d max(0, n·l)"),
    (5,
        "Begin with k_d max(0, n·l)",
        &[("material.rs", "light.intensity / r_squared", "1.0"),
         ("controls.rs", "to.group_of(\"diffuse reflection\", \"light\", light.name);", "return;")],
        "k_d max(0, n·l)"),
    (6,
        "Begin with one light and its shadow",
        &[("scene.rs", "in &self.lights", "in self.lights.iter().take(1)"), NO_AMBIENT],
        "one light and its shadow"),
    (6, "then loop over two lights", &[NO_AMBIENT], "two lights and their shadows"),
    (7, "Begin with v_r and Phong's form", &[PHONG], "the highlight in Phong's form"),
];

/// A solution on the way with a mistake: the same, and how what is said of the mistake begins.
#[rustfmt::skip]
pub(crate) const BUT: (usize, &[Change], &str, &str) =
    (5,
        &[("material.rs", "light.intensity / r_squared", "1.0"),
         ("material.rs", "if normal.dot(v) < 0.0 { -normal } else { normal }", "normal")],
        "k_d max(0, n·l)",
        "n is not turned");

const ANY_T: Change = ("sphere.rs", "if t_min < t && t < t_max", "if true");

const WHOLE_PLANE: Change =
    ("triangle.rs", "if alpha < 0.0 || beta < 0.0 || gamma < 0.0", "if false");

const NO_AMBIENT: Change =
    ("scene.rs", "say.term(\"L_a = k_a I_a\", k_a * i_a)", "Color::ZERO * k_a * i_a");

const PHONG: Change = ("material.rs", "n.dot(h)", "(2.0 * n_dot_l * n - l).dot(v)");

/// Wrong solutions: the step, the changes, and how what is said of them begins; nothing when it is
/// no mistake of the lecture.
#[rustfmt::skip]
pub(crate) const WRONG: &[(usize, &[Change], &str)] = &[
    (1, &[("render.rs", "col as f32 + 0.5", "col as f32"), ("render.rs", "row as f32 + 0.5", "row as f32")], "The ½ is missing: "),
    (1,
        &[("render.rs", "(col as f32 + 0.5) / width as f32", "col as f32 / (width as f32 - 1.0)"),
         ("render.rs", "(row as f32 + 0.5) / height as f32", "row as f32 / (height as f32 - 1.0)")],
        "It divides by width − 1"),
    (1, &[WHOLE, ("render.rs", "row as f32 + 0.5", "row as f32")], "The ½ is missing from v"),
    (1, &[("render.rs", "generate_ray(u, v)", "generate_ray(v, u)")], "u and v are exchanged"),
    (1, &[("render.rs", "1.0 - (row", "(row")], "The picture is upside down"),
    (1, &[("render.rs", "(col as f32 + 0.5) /", "1.0 - (col as f32 + 0.5) /")], "The picture is mirrored"),
    (1,
        &[("render.rs", "(col as f32 + 0.5) / width as f32", "(col / width) as f32"),
         ("render.rs", "(row as f32 + 0.5) / height as f32", "(row / height) as f32")],
        "col / width is a division of whole numbers"),
    (1, &[("render.rs", "row as f32 + 0.5", "row as f32 - 0.5")], "The picture is shifted by a pixel downwards"),
    (1, &[("render.rs", "image.pixel(col, row)", "image.pixel(row, col)")], ""),
    (2, &[ANY_T], "t > 0 is not asked"),
    (2, &[TEXTBOOK, ("sphere.rs", "[t_1, t_2]", "[t_1]")], "Only the smaller root"),
    (2, &[discriminant("b * b + a * (p.dot(p) - self.radius.powi(2))")], "The sign in the discriminant"),
    (2, &[discriminant("b * b - 4.0 * a * (p.dot(p) - self.radius.powi(2))")], "b² − 4 a c"),
    (2, &[TEXTBOOK, ("sphere.rs", "d.dot(p));", "2.0 * d.dot(p));")], "b = 2 d·p goes with"),
    (2, &[discriminant("a * (self.radius - q_squared)")], "The radius is not squared"),
    (2, &[("sphere.rs", "(ray.origin - self.center, ray.direction)", "(ray.origin, ray.direction)")], "The sphere's centre"),
    (2, &[("sphere.rs", "if discriminant < 0.0", "if discriminant > 0.0")], ""),
    (2,
        &[("sphere.rs", "(-b - root) / a", "-b / a"), ("sphere.rs", "(-b + root) / a", "-b / a + 0.0 * root")],
        "t is −b/a"),
    (2,
        &[("sphere.rs", "(-b - root)", "(b - root)"), ("sphere.rs", "(-b + root)", "(b + root)")],
        "The minus before b is missing"),
    (2, &[("sphere.rs", "(ray.origin - self.center, ray.direction)", "(ray.origin + self.center, ray.direction)")], "The sphere's centre is added"),
    (3, &[("triangle.rs", "alpha < 0.0 || ", "")], "α ≥ 0 is not asked"),
    (3, &[("triangle.rs", "beta < 0.0 || ", "")], "β ≥ 0 is not asked"),
    (3, &[("triangle.rs", " || gamma < 0.0", "")], "γ ≥ 0 is not asked"),
    (3, &[WHOLE_PLANE], "Whether the point is inside"),
    (3, &[("triangle.rs", "if !(t_min < t && t < t_max)", "if det_abc > 0.0 || !(t_min < t && t < t_max)")], "A triangle is seen from one side only"),
    (3, &[("triangle.rs", "if !(t_min < t && t < t_max)", "if det_abc < 0.0 || !(t_min < t && t < t_max)")], "A triangle is seen from one side only"),
    (3, &[("triangle.rs", "if !(t_min < t && t < t_max)", "if t.is_nan()")], "t > 0 is not asked"),
    (3, &[("triangle.rs", "det(a - b, a - p, d)", "det(a - p, a - b, d)")], "γ has the wrong sign"),
    (3, &[("lib.rs", "Color::new(alpha, beta, gamma)", "Color::new(beta, alpha, gamma)")], "α and β are exchanged"),
    (3, &[("lib.rs", "Color::new(alpha, beta, gamma)", "Color::new(alpha, gamma, beta)")], "β and γ are exchanged"),
    (4, &[("scene.rs", "t_max = say.closest(", "say.closest(")], "t_max stays as it was"),
    (4,
        &[("scene.rs", "closest = Some((record, object));", "return Some((record, object));"),
         ("scene.rs", "let mut closest", "let closest")],
        "The first hit wins"),
    (4,
        &[("scene.rs", "let mut t_max = t_max;", "let mut farthest = t_min;"),
         ("scene.rs", "object.surface.intersect(ray, t_min, t_max, say) {", "object.surface.intersect(ray, t_min, t_max, say) && record.t > farthest {"),
         ("scene.rs", "t_max = say.closest(", "farthest = say.closest(")],
        "The largest t wins"),
    (4, &[("lecture_scene.rs", "background: Color::new(0.03, 0.05, 0.09)", "background: Color::ZERO")], "The background is black"),
    (4, &[("sphere.rs", "[t_1, t_2]", "[t_2, t_1]")], "The roots are in the wrong order"),
    (4,
        &[("sphere.rs", "t_min < t && t < t_max {", "t < t_max {"),
         ("triangle.rs", "t_min < t && t < t_max)", "t < t_max)")],
        "t > 0 is not asked"),
    (4, &[("lecture_scene.rs", "face(2, 3), face(3, 0)]", "face(2, 3)]")], ""),
    (5, &[("material.rs", "if normal.dot(v) < 0.0 { -normal } else { normal }", "normal")], "n is not turned"),
    (5, &[("material.rs", "point, to_light.normalize()", "point, to_light")], "L_d is too large by a factor r"),
    (5, &[("material.rs", "light.intensity / r_squared", "light.intensity / r_squared.sqrt()")], "L_d is too large by a factor r"),
    (5, &[("material.rs", "light.intensity / r_squared", "light.intensity")], "I is not divided by r²"),
    (5, &[("material.rs", "k_d * irradiance * n_dot_l.max(0.0)", "k_d * irradiance")], "n·l is missing: "),
    (5, &[WHOLE, ("material.rs", "n_dot_l.max(0.0)", "n_dot_l.abs()")], "It is |n·l|"),
    (5, &[("material.rs", "k_d * irradiance * n_dot_l.max(0.0)", "Color::splat(irradiance * n_dot_l.max(0.0))")], "k_d is missing"),
    (5, &[("material.rs", "light.position - point", "point - light.position")], "n or l points the other way"),
    (5, &[("material.rs", "to_light.normalize()", "light.position.normalize()")], "l is the light's position"),
    (5, &[("triangle.rs", "self.normal.normalize()", "self.normal")], "A triangle's normal is not"),
    (5, &[("material.rs", "light.intensity / r_squared", "light.intensity / (4.0 * std::f32::consts::PI * r_squared)")], "I is divided by 4π r²"),
    (5, &[("material.rs", "n_dot_l.max(0.0)", "n_dot_l")], "max(0, n·l) is n·l alone"),
    (5, &[("material.rs", "\"r²\", to_light.length_squared()", "\"r²\", light.position.length_squared()")], "r is the light's distance"),
    (5, &[("material.rs", "\"r²\", to_light.length_squared()", "\"r²\", point.length_squared()")], "r is the point's distance"),
    (5, &[("material.rs", "k_d * irradiance * n_dot_l.max(0.0)", "0.0 * k_d * irradiance * n_dot_l.max(0.0)")], "The diffuse term L_d is missing"),
    (5, &[("lecture_scene.rs", "at(4.0, 6.0, 5.0), 42.0", "at(4.0, 6.0, -5.0), 42.0")], ""),
    (6, &[NO_AMBIENT], "The ambient term L_a is missing"),
    (6, &[("scene.rs", "if !self.is_blocked(point, light, say)", "if true")], "There are no shadows"),
    (6, &[("scene.rs", "in &self.lights", "in self.lights.iter().take(1)")], "The second light is left out"),
    (6, &[("scene.rs", "self.epsilon, 1.0, &Silent", "0.0, 1.0, &Silent")], "ε is 0"),
    (6, &[("scene.rs", "self.epsilon, 1.0, &Silent", "self.epsilon, f32::INFINITY, &Silent")], "The shadow ray does not end"),
    (6,
        &[("scene.rs", "Ray::new(point, light.position - point)", "Ray::new(point, (light.position - point).normalize())")],
        "The shadow ray's direction"),
    (6,
        &[("scene.rs", "light, say);\n            }", "light, say);\n            } else { break; }")],
        "Of the lights after one"),
    (6,
        &[("scene.rs", "result += material", "result += k_a * i_a + material"),
         ("scene.rs", "say.term(\"L_a = k_a I_a\", k_a * i_a)", "Color::ZERO")],
        "The ambient term is added once for each light that is seen"),
    (6,
        &[("scene.rs", "say.about(light.name);", "say.about(light.name); result += k_a * i_a;"),
         ("scene.rs", "say.term(\"L_a = k_a I_a\", k_a * i_a)", "Color::ZERO")],
        "The ambient term is added once for each light"),
    (6, &[("scene.rs", "if !self.is_blocked", "if self.is_blocked")], "It is the wrong way round"),
    (6,
        &[("scene.rs", "if !self.is_blocked(point, light, say) {", "if self.is_blocked(point, light, say) { return Color::ZERO; } else {")],
        "Where one light is blocked"),
    (6, &[("scene.rs", "result += material", "result = material")], "Each light takes the place"),
    (6, &[("scene.rs", "\"k_a\", material.k_a", "\"k_a\", Color::splat(0.1)")], "The ambient term is grey"),
    (6, &[("scene.rs", "\"k_a\", material.k_a", "\"k_a\", 0.1 * material.k_d")], "k_a is always a tenth"),
    (6,
        &[("scene.rs", "\"k_a\", material.k_a", "\"k_a\", 0.1 * material.k_d"), ("scene.rs", "if !self.is_blocked(point, light, say)", "if true")],
        "Two at once: There are no shadows"),
    (6,
        &[("scene.rs", "Ray::new(point, light.position - point)", "Ray::new(light.position, point - light.position)")],
        "The shadow ray comes from the light"),
    (6, &[("scene.rs", "if !self.is_blocked(point, light, say)", "if false")], "No light is added"),
    (7, &[("material.rs", "self.k_s == 0.0 || n_dot_l <= 0.0", "self.k_s == 0.0")], "A light behind the surface"),
    (7, &[PHONG], "The highlight is Phong's"),
    (7, &[("material.rs", "powf(p)", "powf(p / 4.0)")], "p is too small by a factor 4"),
    (7, &[("material.rs", "powf(p)", "powf(4.0 * p)")], "p is too large by a factor 4"),
    (7, &[("material.rs", "(v + l).normalize()", "(v + l) / 2.0")], "h is (v + l)/2"),
    (7, &[("material.rs", "-ray.direction.normalize()", "ray.direction.normalize()")], "v points from the eye"),
    (7, &[("material.rs", "(v + l).normalize()", "(l - v).normalize()")], "v points from the eye"),
    (7, &[("material.rs", "k_s * irradiance * highlight", "k_s * highlight")], "The highlight is not multiplied by I/r²"),
    (7, &[("material.rs", "Color::splat(k_s * irradiance * highlight)", "k_s * irradiance * highlight * k_d")], "The highlight has the surface's colour"),
    (7, &[("material.rs", "l_d + say.term", "l_d + 0.0 * say.term")], "The specular term L_s is missing"),
    (7, &[("material.rs", "k_s * irradiance * highlight", "irradiance * highlight")], "k_s is missing"),
    (7, &[("material.rs", "n_dot_h.max(0.0).powf(p)", "n_dot_h.max(0.0) * p")], "It is max(0, n·h) to the power p"),
    (7, &[("material.rs", "n.dot(h)", "(2.0 * n.dot(v) * n - l).dot(v)")], "v_r is 2 (n·l) n − l"),
    (7,
        &[("material.rs", "k_s * irradiance * highlight", "irradiance * highlight"), ("material.rs", "powf(p)", "powf(4.0 * p)")],
        "Two at once: k_s is missing"),
    (7, &[("material.rs", "l_d + say.term", "l_d + 0.8 * say.term")], ""),
];
