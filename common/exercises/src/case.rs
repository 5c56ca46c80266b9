//! The pictures by which a step and a solution of its exercise are compared.

use std::fmt;

use anyhow::Result;

use crate::Scene;
use show::Make;
use show::Setting;
use show::Setup;
use show::Size;

/// A picture as a command line asks for it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Case {
    pub(crate) size: Size,
    /// NAME=VALUE each.
    pub(crate) settings: Vec<String>,
}

/// Views of those steps that have these controls: width, height, settings.
const VIEWS: &[(usize, usize, &str)] = &[
    (320, 180, ""),
    (320, 180, "camera=parallel"),
    (8, 5, ""),
    (7, 3, "camera=parallel"),
    (1, 1, ""),
    (5, 8, "azimuth=20"),
    (160, 90, "azimuth=50 elevation=35"),
    (160, 90, "azimuth=-140 elevation=10"),
    (160, 90, "camera=parallel azimuth=-75 elevation=60"),
    (160, 90, "elevation=-20"),
    (160, 90, "camera=parallel azimuth=160 elevation=-20"),
    (160, 90, "distance=2 fov=90"),
    (160, 90, "distance=0.1"),
    (160, 90, "distance=0.1 fov=120 camera=parallel"),
    // All, or all but the floor, behind the eye.
    (160, 90, "center.z=3 distance=1.5"),
    (160, 90, "center.z=3 distance=1.5 camera=parallel"),
    // The eye is inside, and looks away from the centre.
    (160, 90, "center.z=3 distance=2.5"),
    (160, 90, "a.z=3 b.z=3 c.z=3 distance=1.5"),
    (160, 90, "a.z=3 b.z=3 c.z=3 distance=1.5 camera=parallel"),
    (160, 90, "sphere=green center.x=-0.9 center.z=0.7"),
    (160, 90, "light=key light.x=0.2 light.y=0.7 light.z=2.8"),
    (160, 90, "light=key light.x=0.5 light.y=1 light.z=-4 I=200"),
    // A light within the green sphere: behind its surface wherever that is seen, and blocked by nothing.
    (160, 90, "light=key light.x=-2.3 light.y=1 light.z=1.4 azimuth=-50 elevation=0 distance=4"),
];

impl Case {
    /// The views that the step has, and a picture for each of its controls.
    pub(crate) fn all(make: &Make) -> Result<Vec<Self>> {
        let mut cases = Vec::new();
        for &(width, height, settings) in VIEWS {
            let settings = settings.split_whitespace().map(str::to_owned).collect();
            let case = Self { size: Size::new(width, height)?, settings };
            cases.extend(case.scene(make).is_ok().then_some(case));
        }
        let mut setup = Setup::new(make.clone());
        for Setting { name, control, .. } in setup.list() {
            if control.group == "camera" {
                continue;
            }
            let last = control.options().len().saturating_sub(1);
            let start = control.fraction();
            let fractions: Vec<f32> = match last {
                0 if start < 0.7 => vec![start + 0.2],
                0 => vec![0.25],
                _ => (0..=last).map(|option| option as f32 / last as f32).collect(),
            };
            for fraction in fractions.into_iter().filter(|fraction| *fraction != start) {
                setup.set_fraction(&name, fraction);
                let settings = setup.settings();
                setup.reset_all();
                cases.push(Self { size: Size::new(160, 90)?, settings });
            }
        }
        Ok(cases)
    }

    /// The case of this step; the name of the control that it does not have, or that does not take
    /// the value.
    pub(crate) fn scene(&self, make: &Make) -> Result<Scene, String> {
        let mut setup = Setup::new(make.clone());
        for setting in &self.settings {
            let (name, value) = setting.split_once('=').unwrap_or((setting, ""));
            setup.set(name, value).map_err(|_| name.to_owned())?;
        }
        Ok(Scene::new(setup, self.size))
    }

    /// What gives the picture on a command line.
    pub(crate) fn arguments(&self) -> Vec<String> {
        let settings =
            self.settings.iter().flat_map(|setting| ["--set".to_owned(), setting.clone()]);
        ["--size".to_owned(), self.size.to_string()].into_iter().chain(settings).collect()
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.arguments().join(" "))
    }
}
