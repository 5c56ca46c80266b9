//! Pixels in a row: encoded, compared with those of another picture, and packed as others take them.

use common::Color;
use image::RgbImage;

use crate::encode;

/// Adds to each of the `sums`, one a pixel, the colours of its rays: those beside each other in a line
/// of `colors`.
pub fn add_rays(sums: &mut [Color], colors: &[Color]) {
    let rays = (colors.len() / sums.len().max(1)).max(1);
    for (sum, colors) in sums.iter_mut().zip(colors.chunks_exact(rays)) {
        colors.iter().for_each(|color| *sum += *color);
    }
}

/// Encodes pixels, each the mean of so many `rays`, whose colours are summed.
pub fn encode_means(sums: &[Color], rays: usize, pixels: &mut [u8]) {
    for (sum, pixel) in sums.iter().zip(pixels.chunks_exact_mut(3)) {
        pixel.copy_from_slice(&encode(*sum / rays as f32));
    }
}

/// How far the channel is off that is furthest, in steps of 1/255.
pub fn off(a: [u8; 3], b: [u8; 3]) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// How many pixels of two pictures of one size have a channel more than `tolerance`/255 off.
pub fn count_off(a: &RgbImage, b: &RgbImage, tolerance: u8) -> usize {
    a.pixels().zip(b.pixels()).filter(|(a, b)| off(a.0, b.0) > tolerance).count()
}

/// Where there is more light, and where there is less: apart for those who see few colours too.
pub const MORE: [u8; 3] = [255, 170, 40];
pub const LESS: [u8; 3] = [70, 150, 255];

/// How far `b` is from `a`, a picture of the same size: the channel that is off furthest, four times as
/// bright, in the colour of [`MORE`] or of [`LESS`] light. What differs at all can be seen.
pub fn difference(a: &RgbImage, b: &RgbImage) -> RgbImage {
    let mut difference = a.clone();
    for (pixel, b) in difference.pixels_mut().zip(b.pixels()) {
        let off = pixel.0.iter().zip(b.0).map(|(a, b)| i32::from(b) - i32::from(*a));
        let most = off.max_by_key(|off| off.abs()).unwrap_or(0);
        let share = if most == 0 { 0 } else { (4 * most.unsigned_abs()).clamp(48, 255) };
        let color = if most > 0 { MORE } else { LESS };
        pixel.0 = color.map(|channel| (u32::from(channel) * share / 255) as u8);
    }
    difference
}

/// The pixels of `picture` as windows take them, a number 0x00RRGGBB each, into `packed`.
pub fn pack(picture: &RgbImage, packed: &mut Vec<u32>) {
    packed.clear();
    packed.extend(picture.pixels().map(|pixel| {
        let [r, g, b] = pixel.0;
        u32::from_be_bytes([0, r, g, b])
    }));
}

/// The bytes of `picture` as browsers take them: red, green, blue, and how much it covers, all.
pub fn rgba(picture: &RgbImage) -> Vec<u8> {
    let mut rgba = vec![255; picture.len() / 3 * 4];
    for (to, from) in rgba.chunks_exact_mut(4).zip(picture.chunks_exact(3)) {
        to[..3].copy_from_slice(from);
    }
    rgba
}

/// What `draw` draws on nothing, as browsers take it. It is called twice: over black and over white it
/// looks alike where it covers all, and tells elsewhere how much of either is seen through it.
pub fn on_nothing(width: u32, height: u32, draw: &mut dyn FnMut(&mut RgbImage)) -> Vec<u8> {
    let [black, white] = [0, 255].map(|ground| {
        let bytes = vec![ground; 3 * width as usize * height as usize];
        let mut picture = RgbImage::from_raw(width, height, bytes).unwrap_or_default();
        draw(&mut picture);
        picture
    });
    let mut rgba = vec![0; black.len() / 3 * 4];
    let pixels = black.chunks_exact(3).zip(white.chunks_exact(3));
    for (to, (black, white)) in rgba.chunks_exact_mut(4).zip(pixels) {
        let cover = 255 - white[1].saturating_sub(black[1]);
        if cover > 0 {
            let color = |code: u8| (255 * u32::from(code) / u32::from(cover)).min(255) as u8;
            to.copy_from_slice(&[color(black[0]), color(black[1]), color(black[2]), cover]);
        }
    }
    rgba
}
