//! Where the picture is seen from.

use std::ops::RangeInclusive;

use crate::Camera;
use crate::Controls;
use crate::FIELD_OF_VIEW;
use crate::OrthographicCamera;
use crate::PerspectiveCamera;
use crate::Vec3;

const AZIMUTH: RangeInclusive<f32> = -180.0..=180.0;
const ELEVATION: RangeInclusive<f32> = -89.0..=89.0;
const DISTANCE: RangeInclusive<f32> = 0.1..=100.0;

/// Where the picture is seen from, and how: a viewpoint that circles a target.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    start: Vec3,
    target: Vec3,
    start_azimuth: f32,
    start_elevation: f32,
    start_distance: f32,
    /// Around the target, in degrees: 0 is seen from +z, 90 from +x.
    pub azimuth: f32,
    /// Above the target's horizon, in degrees.
    pub elevation: f32,
    /// From the target, in world units.
    pub distance: f32,
    /// The vertical angle of view, in degrees.
    pub field_of_view: f32,
    /// The kind of camera.
    pub projection: Projection,
}

/// The two kinds of camera.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Projection {
    /// One origin, many directions.
    Perspective,
    /// Many origins, one direction.
    Parallel,
}

impl View {
    /// The names of the two kinds of camera, in the order of [`Projection`].
    pub const PROJECTIONS: [&'static str; 2] = ["perspective", "parallel"];

    /// Seen in perspective from `eye`, towards `target`; `field_of_view` is vertical, in degrees.
    pub fn new(eye: Vec3, target: Vec3, field_of_view: f32) -> Self {
        let offset = eye - target;
        let azimuth = offset.x.atan2(offset.z).to_degrees();
        let elevation = offset.y.atan2(offset.x.hypot(offset.z)).to_degrees();
        let distance = offset.length();
        Self {
            start: eye,
            target,
            start_azimuth: azimuth,
            start_elevation: elevation,
            start_distance: distance,
            azimuth,
            elevation,
            distance,
            field_of_view,
            projection: Projection::Perspective,
        }
    }

    /// The viewpoint. As long as nothing was moved, it is the one given, to the last digit.
    pub fn eye(&self) -> Vec3 {
        if self.distance == self.start_distance
            && self.azimuth == self.start_azimuth
            && self.elevation == self.start_elevation
        {
            return self.start;
        }
        let (sin_azimuth, cos_azimuth) = self.azimuth.to_radians().sin_cos();
        let (sin_elevation, cos_elevation) = self.elevation.to_radians().sin_cos();
        let direction =
            Vec3::new(cos_elevation * sin_azimuth, sin_elevation, cos_elevation * cos_azimuth);
        self.target + self.distance * direction
    }

    /// What is looked at, and circled.
    pub fn target(&self) -> Vec3 {
        self.target
    }

    /// Circles the target by these angles in degrees; the elevation stops at its ends.
    pub fn orbit(&mut self, right: f32, up: f32) {
        let turn = AZIMUTH.end() - AZIMUTH.start();
        let azimuth = self.azimuth + right;
        self.azimuth = (azimuth - AZIMUTH.start()).rem_euclid(turn) + AZIMUTH.start();
        self.elevation = (self.elevation + up).clamp(*ELEVATION.start(), *ELEVATION.end());
    }

    /// Multiplies the distance by `factor`, as far as its range goes.
    pub fn zoom(&mut self, factor: f32) {
        self.distance = (self.distance * factor).clamp(*DISTANCE.start(), *DISTANCE.end());
    }

    /// The camera for a picture whose width over height is `aspect`.
    ///
    /// The parallel one shows as much at the target as the perspective one does there.
    pub fn camera(&self, aspect: f32) -> Box<dyn Camera> {
        let (eye, target, up) = (self.eye(), self.target, Vec3::Y);
        let angle = self.field_of_view.clamp(*FIELD_OF_VIEW.start(), *FIELD_OF_VIEW.end());
        match self.projection {
            Projection::Perspective => {
                Box::new(PerspectiveCamera::new(eye, target, up, angle, aspect))
            }
            Projection::Parallel => {
                let height = 2.0 * self.distance * (angle.to_radians() / 2.0).tan();
                Box::new(OrthographicCamera::new(eye, target, up, height, aspect))
            }
        }
    }

    /// Shows `to` the camera's own controls: they come after those of the step.
    pub fn controls(&mut self, to: &mut dyn Controls) {
        to.group("camera");
        let mut chosen = self.projection as usize;
        to.choice("camera", &Self::PROJECTIONS, &mut chosen);
        self.projection = [Projection::Perspective, Projection::Parallel][chosen];
        to.number("azimuth", AZIMUTH, &mut self.azimuth);
        to.number("elevation", ELEVATION, &mut self.elevation);
        to.logarithmic("distance", DISTANCE, &mut self.distance);
        to.number("fov", FIELD_OF_VIEW, &mut self.field_of_view);
    }
}
