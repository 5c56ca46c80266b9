//! The two cameras.

use crate::Ray;
use crate::Vec3;

/// Turns a position on the picture into a viewing ray. Slide «Interface para as câmeras».
///
/// A camera knows nothing of pixels: it is asked in normalized coordinates.
pub trait Camera: Sync {
    /// The viewing ray through (u, v), with (0, 0) the lower left corner of the picture and
    /// (1, 1) the upper right one. The direction has unit length.
    ///
    /// Positions outside [0, 1]² continue the same plane beyond the picture's edge.
    fn generate_ray(&self, u: f32, v: f32) -> Ray;

    /// Where `point` is seen: the (u, v) whose viewing ray passes through it. Slide «Projeção».
    ///
    /// `None` where no ray does: behind the camera, in the eye itself, at a point that is not
    /// finite; and always from a camera that does not know the way back.
    fn project(&self, _point: Vec3) -> Option<(f32, f32)> {
        None
    }
}

/// The (u, v) of a point by how far it is from the middle of the window, along the window's sides.
fn on_window(from_middle: Vec3, horizontal: Vec3, vertical: Vec3) -> Option<(f32, f32)> {
    let u = 0.5 + from_middle.dot(horizontal) / horizontal.length_squared();
    let v = 0.5 + from_middle.dot(vertical) / vertical.length_squared();
    (u.is_finite() && v.is_finite()).then_some((u, v))
}

/// The smallest and largest vertical field of view, in degrees.
pub(crate) const FIELD_OF_VIEW: std::ops::RangeInclusive<f32> = 1.0..=170.0;

/// Right, up and backward: unit vectors at right angles to each other.
///
/// They always exist: a viewer who stands on the target looks along −z, and one who looks along
/// `up` takes z for it (or x, should that be parallel too).
fn basis(eye: Vec3, target: Vec3, up: Vec3) -> (Vec3, Vec3, Vec3) {
    let backward = (eye - target).normalize_or(Vec3::Z);
    let right = [up, Vec3::Z, Vec3::X]
        .into_iter()
        .find_map(|up| up.normalize_or_zero().cross(backward).try_normalize())
        .unwrap_or(Vec3::X);
    (right, backward.cross(right), backward)
}

/// One origin, many directions. Slide «Geração de raios - perspectiva».
#[derive(Clone, Copy, Debug)]
pub struct PerspectiveCamera {
    eye: Vec3,
    corner: Vec3,
    horizontal: Vec3,
    vertical: Vec3,
    forward: Vec3,
}

impl PerspectiveCamera {
    /// A camera at `eye` that looks at `target`; `up` points upwards on the picture.
    ///
    /// `field_of_view` is the vertical angle in degrees, at least 1 and at most 170; `aspect`
    /// is width over height. `eye` = `target` looks along −z, and an `up` along the line of sight
    /// is replaced by z.
    pub fn new(eye: Vec3, target: Vec3, up: Vec3, field_of_view: f32, aspect: f32) -> Self {
        let (right, up, backward) = basis(eye, target, up);
        let angle = field_of_view.clamp(*FIELD_OF_VIEW.start(), *FIELD_OF_VIEW.end());
        let vertical = 2.0 * (angle.to_radians() / 2.0).tan() * up;
        let horizontal = 2.0 * (angle.to_radians() / 2.0).tan() * aspect * right;
        let corner = -backward - horizontal / 2.0 - vertical / 2.0;
        Self { eye, corner, horizontal, vertical, forward: -backward }
    }
}

impl Camera for PerspectiveCamera {
    #[inline]
    fn generate_ray(&self, u: f32, v: f32) -> Ray {
        let direction = self.corner + u * self.horizontal + v * self.vertical;
        Ray::new(self.eye, direction.normalize())
    }

    /// The window is at the distance 1: a point x at the depth z is seen through (x − eye) / z.
    fn project(&self, point: Vec3) -> Option<(f32, f32)> {
        let from_eye = point - self.eye;
        let depth = from_eye.dot(self.forward);
        let seen = on_window(from_eye / depth, self.horizontal, self.vertical);
        seen.filter(|_| depth > 0.0)
    }
}

/// Many origins, one direction. Slide «Geração de raios - paralela».
#[derive(Clone, Copy, Debug)]
pub struct OrthographicCamera {
    direction: Vec3,
    corner: Vec3,
    horizontal: Vec3,
    vertical: Vec3,
}

impl OrthographicCamera {
    /// A camera whose viewing window is centred on `eye`, at a right angle to the line from `eye`
    /// to `target`; `up` points upwards on the picture.
    ///
    /// `height` is the window's height in world units and `aspect` its width over its height.
    /// `eye` = `target` looks along −z, and an `up` along the line of sight is replaced by z.
    pub fn new(eye: Vec3, target: Vec3, up: Vec3, height: f32, aspect: f32) -> Self {
        let (right, up, backward) = basis(eye, target, up);
        let vertical = height * up;
        let horizontal = height * aspect * right;
        Self {
            direction: -backward,
            corner: eye - horizontal / 2.0 - vertical / 2.0,
            horizontal,
            vertical,
        }
    }
}

impl Camera for OrthographicCamera {
    #[inline]
    fn generate_ray(&self, u: f32, v: f32) -> Ray {
        let origin = self.corner + u * self.horizontal + v * self.vertical;
        Ray::new(origin, self.direction)
    }

    /// The depth does not matter: a point x is seen through x − t d on the window.
    fn project(&self, point: Vec3) -> Option<(f32, f32)> {
        let middle = self.corner + self.horizontal / 2.0 + self.vertical / 2.0;
        let from_middle = point - middle;
        let seen = on_window(from_middle, self.horizontal, self.vertical);
        // A ray's own origin is seen, whatever rounding says.
        let rounding = 1e-5 * (middle.length() + from_middle.length());
        seen.filter(|_| from_middle.dot(self.direction) >= -rounding)
    }
}
