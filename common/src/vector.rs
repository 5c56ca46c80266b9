//! Vectors and colours.

/// A point, a direction, or three numbers of any other kind, in a right-handed world with y up.
///
/// It is glam's 16-byte, SIMD-aligned vector: `dot`, `cross`, `length` and `normalize` are there.
pub type Vec3 = glam::Vec3A;

/// Linear RGB radiance: three numbers from 0 up, without an upper bound.
///
/// Colours add and multiply like vectors. They are clamped to [0, 1] and sRGB-encoded once, when
/// a finished pixel leaves for the screen or the file.
pub type Color = Vec3;
