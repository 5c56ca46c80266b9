//! Pixels of two pictures side by side, and packed.

use image::RgbImage;

/// How far the channel is off that is furthest, in steps of 1/255.
pub fn off(a: [u8; 3], b: [u8; 3]) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// How many pixels of two pictures of one size have a channel more than `tolerance`/255 off.
pub fn count_off(a: &RgbImage, b: &RgbImage, tolerance: u8) -> usize {
    a.pixels().zip(b.pixels()).filter(|(a, b)| off(a.0, b.0) > tolerance).count()
}

/// How far each channel of `b` is from that of `a`, a picture of the same size, times eight.
pub fn magnified(a: &RgbImage, b: &RgbImage) -> RgbImage {
    let mut difference = a.clone();
    for (channel, b) in difference.iter_mut().zip(b.iter()) {
        *channel = channel.abs_diff(*b).saturating_mul(8);
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
