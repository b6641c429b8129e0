//! `guide`: derives a scene from the size of a volume of fluid, its properties and a number class, and says how.
use crate::failure::Failure;
use crate::outcome::table;
use crate::output::{print_json, say, write_text};
use glam::Vec3;
use millpond_core::guide::{Guide, Guided, NUMBER_CLASSES};
use millpond_core::scene::{Dimension, Fluid};
use std::path::PathBuf;

/// Options of `guide`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    /// Extents of the volume of fluid, m: two in 2D, three in 3D
    #[arg(long, value_name = "X,Y[,Z]", value_delimiter = ',', default_value = "1,1,1", allow_hyphen_values = true)]
    size: Vec<f32>,
    /// Number class, 0 to 10: the higher, the more particles (class 3 has 32 along the shortest side)
    #[arg(long, value_name = "N", default_value_t = 3)]
    class: u32,
    /// Rest density, kg/m3
    #[arg(long, value_name = "RHO", default_value_t = 1000.0)]
    density: f32,
    /// Speed of sound, m/s: ten times the speed of the fastest flow
    #[arg(long, value_name = "C", default_value_t = 10.0)]
    sound: f32,
    /// Dynamic viscosity, Pa s
    #[arg(long, value_name = "MU", default_value_t = 0.001)]
    viscosity: f32,
    /// Average number of neighbours, instead of that of the class
    #[arg(long, value_name = "N")]
    neighbours: Option<f32>,
    /// Write the scene to this file
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// One JSON document on stdout
    #[arg(long)]
    json: bool,
}

/// Runs `guide`.
///
/// # Errors
/// A choice from which no scene follows, or a file that cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let (dimension, size) = match options.size[..] {
        [x, y] => (Dimension::Two, Vec3::new(x, y, 0.0)),
        [x, y, z] => (Dimension::Three, Vec3::new(x, y, z)),
        _ => {
            return Err(Failure::Call(format!(
                "--size has {} extents: give two in 2D, three in 3D",
                options.size.len()
            )));
        }
    };
    let fluid = Fluid {
        rest_density: options.density,
        speed_of_sound: options.sound,
        dynamic_viscosity: options.viscosity,
        ..Fluid::default()
    };
    let guide = Guide { dimension, size, number_class: options.class, fluid, average_neighbours: options.neighbours };
    let origin = || "guide".into();
    let (guided, scene) = guide.derive().map_err(|error| Failure::Scene { origin: origin(), error })?;
    let Guided { counts: [x, y, z], particles, fixed_distance, particle_spacing, .. } = guided;
    let along = NUMBER_CLASSES[options.class as usize];
    let rows = [
        [
            "particles".into(),
            particles.to_string(),
            format!("{x} x {y} x {z}: class {} has {along} along the shortest side", options.class),
        ],
        [
            "fixed distance".into(),
            format!("{fixed_distance} m"),
            "the outermost particles on the surface of the volume".into(),
        ],
        [
            "particle_spacing".into(),
            format!("{particle_spacing} m"),
            "each particle in the middle of its cell; the scene has it".into(),
        ],
        ["average_neighbours".into(), guided.average_neighbours.to_string(), "more are smoother and slower".into()],
        [
            "support radius".into(),
            format!("{:.6} m", guided.support_radius),
            "holds these neighbours (Pirovano, eq. 4.1)".into(),
        ],
        [
            "particle mass".into(),
            format!("{:.6} kg", guided.particle_mass),
            format!("{} kg over all particles", guided.total_mass),
        ],
        [
            "time_step".into(),
            format!("{:.3e} s", guided.time_step),
            "the shortest of what sound, viscosity and gravity allow".into(),
        ],
    ];
    let text = format!(
        "// Made by `millpond guide`.\n(\n    about: \"{particles} particles of one fluid\",\n    duration: 1.0,\n    \
         camera: {},\n    shade: Speed(0.0, 1.0),\n    scene: (\n        dimension: {dimension:?},\n        \
         particle_spacing: {particle_spacing:?},\n        average_neighbours: Some({:?}),\n        time_step: {:?},\n        \
         fluids: [(rest_density: {:?}, speed_of_sound: {:?}, dynamic_viscosity: {:?})],\n        \
         blocks: [(corner: (0.0, 0.0, 0.0), size: ({:?}, {:?}, {:?}))],\n    ),\n)\n",
        if dimension == Dimension::Two { "Flat" } else { "Orbit(yaw_degrees: 25.0, pitch_degrees: 20.0)" },
        guided.average_neighbours,
        guided.time_step,
        options.density,
        options.sound,
        options.viscosity,
        scene.blocks[0].size.x,
        scene.blocks[0].size.y,
        scene.blocks[0].size.z,
    );
    if let Some(path) = &options.out {
        write_text(path, &text)?;
    }
    if options.json {
        print_json(&serde_json::json!({
            "name": "guide", "particles": particles, "counts": [x, y, z], "fixed_distance_m": fixed_distance,
            "particle_spacing_m": particle_spacing, "average_neighbours": guided.average_neighbours,
            "support_radius_m": guided.support_radius, "particle_mass_kg": guided.particle_mass,
            "total_mass_kg": guided.total_mass, "time_step_s": guided.time_step, "scene": text,
        }))?;
    } else {
        say(&table(["quantity", "value", "why"], rows))?;
    }
    Ok(true)
}
