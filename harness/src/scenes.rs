//! Scene files: RON text in which unknown fields are errors. Some scenes are built in. `--set` can change every field.
use crate::failure::Failure;
use crate::overrides::{indexed, set};
use crate::scene_errors::explained;
use crate::scene_file::SceneFile;
use crate::scene_text::{current, line_of};
use glam::Vec3;
use millpond_core::scene::{Container, Drain, Opening, Periodic, WallShape};
use millpond_core::{Checked, Requirements, SceneError};
use std::path::Path;

/// A scene that was loaded by name or path.
#[derive(Clone, Debug)]
pub struct LoadedScene {
    /// Name of the built-in scene, or name of the file without its extension.
    pub name: String,
    /// Contents of the scene file, after changes.
    pub file: SceneFile,
}

impl LoadedScene {
    /// Returns the checked scene with everything derived from it.
    ///
    /// # Errors
    /// A scene that cannot run. [`load`] does not return such a scene.
    pub fn checked(&self) -> Result<Checked<'_>, Failure> {
        self.file.scene.check().map_err(|error| Failure::Scene { origin: self.name.clone(), error })
    }
}

macro_rules! built_in {
    ($($name:literal),* $(,)?) => { &[$(($name, include_str!(concat!("../scenes/", $name, ".ron")))),*] };
}

/// Names and texts of the built-in scenes.
pub const BUILT_IN: &[(&str, &str)] = built_in!(
    "dam-break",
    "dam-break-2d",
    "dam-break-classic",
    "still-tank",
    "thesis-cube",
    "viscosity-cubes",
    "channel",
    "corrected-column",
    "stiff-tank",
    "elastic-cube",
    "two-fluids",
    "two-jets",
    "jet",
    "splash",
    "obstacle",
    "obstacles",
    "funnel",
    "sloshing",
    "falling-column",
    "adhesion",
    "thesis-jet",
    "oil-and-water",
    "drop",
    "tower",
);

/// Largest memory of a scene: 4 GiB, some 18 million particles. `compare` holds several scenes in memory, one for each
/// path.
pub const MOST_BYTES: usize = 1 << 32;

/// Changes to a scene that the caller asks for.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct Changes {
    /// Override one field of the scene, named by the end of its path, with a value as in a scene file:
    /// time_step=0.0005, fluid.speed_of_sound=30, gravity=(0,-1.6,0)
    #[arg(long, value_name = "FIELD=VALUE")]
    pub set: Vec<String>,
    /// Approximate number of fluid particles: scales all lengths of the scene and keeps the particle spacing
    #[arg(long, value_name = "N")]
    pub particles: Option<u64>,
}

/// Loads a built-in scene by name or a scene file by path, applies the changes and checks the result.
///
/// # Errors
/// An unknown name, a text that is not a scene, a change that does not fit, or a scene that cannot run.
pub fn load(name: &str, changes: &Changes) -> Result<LoadedScene, Failure> {
    let built_in = BUILT_IN.iter().find(|(known, _)| *known == name);
    let path = Path::new(name);
    let (text, origin) = match built_in {
        Some((_, text)) => ((*text).to_owned(), Path::new("built-in").join(name)),
        None if path.extension().is_some() || path.exists() => {
            (std::fs::read_to_string(path).map_err(Failure::file(path))?, path.to_owned())
        }
        None => {
            let known: Vec<&str> = BUILT_IN.iter().map(|(known, _)| *known).collect();
            return Err(Failure::Call(format!("no scene {name:?}: give a .ron file or one of {}", known.join(", "))));
        }
    };
    let text = current(&text);
    let mut file = parse(&text, &origin)?;
    let was_valid = file.scene.check().is_ok();
    for change in &changes.set {
        file = set(&file, change)?;
    }
    let refuse = |error| refusal(&text, &origin, changes, was_valid, error);
    let now = file.scene.check().map_err(refuse)?.derived().fluid_particles;
    if now == 0 && file.scene.emitters.is_empty() {
        let why = "blocks and emitters are empty, so the scene has no fluid";
        return Err(Failure::Call(format!("{}: {why}", origin.display())));
    }
    if let Some(particles) = changes.particles {
        scale(&mut file, now, particles)?;
    }
    let bytes = Requirements::of(&file.scene.check().map_err(refuse)?).bytes();
    if bytes > MOST_BYTES {
        return Err(Failure::Call(format!("the scene needs {bytes} bytes of memory, and the limit is {MOST_BYTES}")));
    }
    if !(file.duration.is_finite() && file.duration > 0.0) {
        return Err(Failure::Call(format!(
            "{}: duration is {} s, but must be larger than 0",
            origin.display(),
            file.duration
        )));
    }
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned());
    Ok(LoadedScene { name: if built_in.is_some() { name.to_owned() } else { stem.unwrap_or_default() }, file })
}

/// Parses the RON text of a scene.
fn parse(text: &str, origin: &Path) -> Result<SceneFile, Failure> {
    let options = ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
    options.from_str(text).map_err(|e| {
        let line = e.span.start.line;
        // ron does not always name the field, so the line is quoted
        let quoted = text.lines().nth(line.saturating_sub(1)).unwrap_or_default().trim();
        Failure::SceneText { file: origin.to_owned(), line, message: explained(&e.code, quoted) }
    })
}

/// Adds the origin to a scene error: the `--set` arguments that caused it, or the file and, if it is found, the line of
/// the field. `was_valid` says whether the scene could run before the changes.
fn refusal(text: &str, origin: &Path, changes: &Changes, was_valid: bool, error: SceneError) -> Failure {
    let message = error.to_string();
    let field = message.split_whitespace().next().unwrap_or_default();
    let is_named = |change: &&String| {
        let path = indexed(change.split('=').next().unwrap_or_default());
        field == path || field.ends_with(&format!(".{path}")) || path.ends_with(&format!(".{field}"))
    };
    let named: Vec<&String> = changes.set.iter().filter(is_named).collect();
    let caused = if named.is_empty() && was_valid { changes.set.iter().collect() } else { named };
    if !caused.is_empty() {
        let arguments: Vec<String> = caused.iter().map(|change| format!("--set {change}")).collect();
        return Failure::Scene { origin: arguments.join(" "), error };
    }
    let leaf =
        |path: &str| path.rsplit('.').next().unwrap_or_default().split('[').next().unwrap_or_default().to_owned();
    let line = line_of(text, field).or_else(|| line_of(text, &leaf(field)));
    let line = line.map_or(String::new(), |line| format!(":{line}"));
    Failure::Scene { origin: format!("{}{line}", origin.display()), error }
}

/// Scales all lengths of a scene of `now` fluid particles at constant spacing, so that it has about `particles`.
fn scale(SceneFile { scene, gauges, .. }: &mut SceneFile, now: usize, particles: u64) -> Result<(), Failure> {
    if particles == 0 {
        return Err(Failure::Call("--particles must be at least 1".into()));
    }
    let factor = (particles as f64 / now as f64).powf(1.0 / scene.dimension.count() as f64);
    let grow = |lengths: &mut Vec3| *lengths = lengths.map(|x| (f64::from(x) * factor) as f32);
    for block in &mut scene.blocks {
        grow(&mut block.corner);
        grow(&mut block.size);
    }
    if let Some(Container { low, high, .. }) = &mut scene.container {
        grow(low);
        grow(high);
    }
    for wall in &mut scene.walls {
        let (WallShape::Plane { low, high, .. } | WallShape::Box { low, high, .. }) = &mut wall.shape;
        grow(low);
        grow(high);
    }
    if let Some(Periodic { low, high, .. }) = &mut scene.periodic {
        grow(low);
        grow(high);
    }
    gauges.iter_mut().filter_map(|gauge| gauge.measures.point_mut()).for_each(grow);
    if let Some(field) = &mut scene.acceleration_field {
        grow(&mut field.low);
        field.spacing = (f64::from(field.spacing) * factor) as f32;
    }
    for emitter in &mut scene.emitters {
        grow(&mut emitter.position);
        let (Opening::Square(width) | Opening::Circle(width)) = &mut emitter.opening;
        *width = (f64::from(*width) * factor) as f32;
    }
    for drain in &mut scene.drains {
        match drain {
            Drain::Box { low, high } => {
                grow(low);
                grow(high);
            }
            Drain::Ball { centre, radius } => {
                grow(centre);
                *radius = (f64::from(*radius) * factor) as f32;
            }
        }
    }
    let volume = factor.powi(scene.dimension.count() as i32);
    scene.spare_particles = (f64::from(scene.spare_particles) * volume).ceil() as u32;
    if let Some(air) = &mut scene.air {
        // the layer of air grows with the surface
        let surface = factor.powi(scene.dimension.count() as i32 - 1);
        air.capacity = (f64::from(air.capacity) * surface).ceil().max(1.0) as u32;
    }
    // a larger scene needs more cells, because the grid wraps and distant particles would share cells
    let axes = scene.dimension.count();
    for cells in &mut scene.grid.cells[..axes] {
        *cells = (f64::from(*cells) * factor).ceil().max(3.0) as u32;
    }
    Ok(())
}
