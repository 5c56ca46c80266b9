//! The loop that all ray tracing is.
use common::prelude::*;

/// The normalized coordinates of a pixel's centre. Slide «Mapeamento».
///
/// Columns and rows count from the top left corner, (u, v) from the lower left one: hence 1 − v.
pub fn pixel_center(Pixel { col, row, width, height }: Pixel) -> (f32, f32) {
    let u = (col as f32 + 0.5) / width as f32;
    let v = 1.0 - (row as f32 + 0.5) / height as f32;
    (u, v)
}

/// The ray that is seen at `pixel`. Slide «Interface para as câmeras».
pub fn viewing_ray(camera: &dyn Camera, pixel: Pixel, say: &mut impl Listener) -> Ray {
    say.section("viewing ray");
    let (u, v) = say.line("(u, v)", pixel_center(pixel));
    let ray = camera.generate_ray(u, v);
    say.point("p", ray.origin);
    say.ray("d", &ray, f32::INFINITY);
    ray
}

/// For each pixel: compute the viewing ray, trace it, put the result into the image.
/// Slide «Algoritmo de ray tracing».
pub fn render(camera: &dyn Camera, image: &mut Image<'_>, trace: impl Fn(&Ray) -> Color) {
    for row in image.rows() {
        for col in 0..image.width() {
            let ray = viewing_ray(camera, image.pixel(col, row), &mut Silent);
            let color = trace(&ray);
            image.set(col, row, color);
        }
    }
}
