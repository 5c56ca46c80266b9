//! The steps' figures, each from its example's file.

use show::Program;

macro_rules! figures {
    ($($figure:ident $path:literal)*) => {
        $(
            #[path = $path]
            mod $figure;
        )*

        /// The figures of all steps: each one's name, and the figure as a program.
        pub const FIGURES: [(&str, fn() -> Program); [$($path),*].len()] =
            [$((stringify!($figure), $figure::program)),*];
    };
}

figures! {
    four_views "../../step01_rays/examples/four_views.rs"
    pixel_centers "../../step01_rays/examples/pixel_centers.rs"
    rays "../../step01_rays/examples/rays.rs"
    both_roots "../../step02_sphere/examples/both_roots.rs"
    areas "../../step03_triangle/examples/areas.rs"
    object_order "../../step04_scene/examples/object_order.rs"
    boundary "../../step05_diffuse/examples/boundary.rs"
    diffuse_row "../../step05_diffuse/examples/diffuse_row.rs"
    distance "../../step05_diffuse/examples/distance.rs"
    lambert_cube "../../step05_diffuse/examples/lambert_cube.rs"
    roughness "../../step05_diffuse/examples/roughness.rs"
    wave_fronts "../../step05_diffuse/examples/wave_fronts.rs"
    acne "../../step06_shadows/examples/acne.rs"
    lights "../../step06_shadows/examples/lights.rs"
    shadow_ray "../../step06_shadows/examples/shadow_ray.rs"
    lobes "../../step07_specular/examples/lobes.rs"
    phong_blinn "../../step07_specular/examples/phong_blinn.rs"
    reflection "../../step07_specular/examples/reflection.rs"
    specular_grid "../../step07_specular/examples/specular_grid.rs"
}
