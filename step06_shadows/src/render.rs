//! The loop that all ray tracing is.
use common::Camera;
use common::Color;
use common::Image;
use common::Ray;

/// Where pixel (col, row) of a `width` × `height` picture lies in normalized coordinates: its
/// centre. Slide «Mapeamento».
///
/// Columns and rows count from the top left corner, (u, v) from the lower left one: hence 1 − v.
pub fn pixel_center(col: usize, row: usize, width: usize, height: usize) -> (f32, f32) {
    let u = (col as f32 + 0.5) / width as f32;
    let v = 1.0 - (row as f32 + 0.5) / height as f32;
    (u, v)
}

/// Fills `image`. Slide «Algoritmo de ray tracing».
///
/// For each pixel: compute the viewing ray, trace it, put the result into the image.
pub fn render(camera: &dyn Camera, image: &mut Image<'_>, trace: impl Fn(&Ray) -> Color) {
    for row in image.rows() {
        for col in 0..image.width() {
            let (u, v) = pixel_center(col, row, image.width(), image.height());
            let ray = camera.generate_ray(u, v);
            let color = trace(&ray);
            image.set(col, row, color);
        }
    }
}
