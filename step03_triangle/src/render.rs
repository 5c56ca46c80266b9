//! The loop that all ray tracing is.
use common::prelude::*;

/// The ray through the centre of `pixel`. Slides «Mapeamento» and «Interface para as câmeras».
///
/// Columns and rows count from the top left corner, (u, v) from the lower left one: hence 1 − v.
pub fn viewing_ray(camera: &dyn Camera, pixel: Pixel, say: &impl Listener) -> Ray {
    let _about = say.about("viewing ray");
    let Pixel { col, row, width, height } = pixel;
    let u = say.line("u = (col + ½) / width", (col as f32 + 0.5) / width as f32);
    let v = say.line("v = 1 − (row + ½) / height", 1.0 - (row as f32 + 0.5) / height as f32);
    say.viewing_ray(camera.generate_ray(u, v))
}

/// For each pixel: compute the viewing ray, trace it, put the result into the image.
/// Slide «Algoritmo de ray tracing».
pub fn render(camera: &dyn Camera, image: &mut Image<'_>, trace: impl Fn(&Ray) -> Color) {
    for row in image.rows() {
        for col in 0..image.width() {
            let ray = viewing_ray(camera, image.pixel(col, row), &Silent);
            let color = trace(&ray);
            image.set(col, row, color);
        }
    }
}
