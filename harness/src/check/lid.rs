//! `lid`: a square cavity whose lid slides over it, at a Reynolds number of 100. The lid also slides over the side
//! walls, which is what a wall that steps its own density does not survive.
use super::flow::{checked, fluid, grid, larger, start_with, step, steps_to};
use super::formulas::{ROWS_STAY, WATER};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{Block, Dimension, Face, Fluid, Formulation, Scene, Wall, WallPressure, WallShape};
use millpond_core::{OwnedMemory, Solver};

const NAME: &str = "lid";

/// Spacing, m, in a full and in a quick study; the cavity is 1 m wide and high.
const SPACING: f32 = 0.02;
const QUICK_SPACING: f32 = 0.04;

/// End of the run, s, in a full and in a quick study. After 25 s the lid has passed over the cavity 25 times.
const END: f64 = 25.0;
const QUICK_END: f64 = 5.0;

/// Speed of the lid and of sound, m/s, rest density, kg/m3, and viscosity, Pa s.
const LID: f32 = 1.0;
const SOUND: f32 = 10.0;
const REST_DENSITY: f32 = 1000.0;
const VISCOSITY: f32 = 10.0;

/// Time step over the time that sound takes through a support radius.
const COURANT: f64 = 0.1;

/// Required limit: density of every wall particle within 5 % of the rest density, in every sample.
const LIMIT: f64 = 0.05;
const STEPS_PER_SAMPLE: u64 = 20;

/// Velocity along x in the middle of the cavity over that of the lid (Ghia, Ghia and Shin 1982, table I).
const IN_THE_MIDDLE: f64 = -0.205_81;

/// Compared forms of wall pressure. The first one has the limit, and a quick study runs only that one.
const FORMS: [WallPressure; 3] = [WallPressure::Extrapolated, WallPressure::Dynamic, WallPressure::Mirrored];

/// Results of a run.
struct Slid {
    /// Largest deviation of the density of a wall particle, over the rest density.
    wall: f64,
    /// Largest deviation of the density of a fluid particle at the end, over the rest density.
    fluid: f64,
    /// Velocity along x in the middle of the cavity at the end, over that of the lid.
    middle: f64,
    /// Particles that are no longer in the cavity.
    lost: usize,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let (spacing, end, forms) = if context.quick { (QUICK_SPACING, QUICK_END, 1) } else { (SPACING, END, FORMS.len()) };
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    for (i, wall) in FORMS.into_iter().take(forms).enumerate() {
        let line = match slide(context, spacing, end, wall) {
            Err(Failure::Step(error)) if i > 0 => [error.to_string(), String::new(), String::new(), String::new()],
            Err(failure) => return Err(failure),
            Ok(Slid { wall, fluid, middle, lost }) => {
                if i == 0 {
                    figures.push(Metric::below("density of a wall particle, off the rest density", wall, LIMIT));
                    figures.push(Metric::below("particles lost", lost as f64, 0.0));
                }
                let percent = |x: f64| format!("{:.2} %", x * 100.0);
                [percent(wall), percent(fluid), format!("{middle:.3}"), lost.to_string()]
            }
        };
        let [wall_density, fluid_density, middle, lost] = line;
        lines.push([wall.name().into(), wall_density, fluid_density, middle, lost]);
    }
    let titles = [
        "walls",
        "largest error of a wall's density",
        "of the fluid's, at the end",
        "velocity in the middle, over the lid's",
        "lost",
    ];
    let reference = format!("Ghia, Ghia and Shin 1982 give {IN_THE_MIDDLE} for the velocity in the middle.");
    Ok(Outcome::new(NAME, figures, vec![table(titles, lines), reference]))
}

fn scene(spacing: f32, wall_pressure: WallPressure) -> Scene {
    let fluid =
        Fluid { rest_density: REST_DENSITY, speed_of_sound: SOUND, dynamic_viscosity: VISCOSITY, ..Fluid::default() };
    let block = Block { size: Vec3::new(1.0, 1.0, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, spacing, 1.0, fluid, block);
    scene.average_neighbours = Some(ROWS_STAY);
    scene.time_step = (COURANT * support_radius(&scene) / f64::from(SOUND)) as f32;
    scene.model = Formulation { wall_pressure, ..WATER };
    let inside =
        WallShape::Box { low: Vec3::ZERO, high: Vec3::new(1.0, 1.0, 0.0), open: [Face::Ceiling].into_iter().collect() };
    // as far over the side walls as they are thick
    let thick = 4.0 * spacing;
    let over = WallShape::Plane {
        face: Face::Ceiling,
        low: Vec3::new(-thick, 1.0, 0.0),
        high: Vec3::new(1.0 + thick, 1.0, 0.0),
    };
    let lid = Wall { velocity: Vec3::new(LID, 0.0, 0.0), ..Wall::still(over) };
    scene.walls = [Wall::still(inside), lid].into_iter().collect();
    scene.grid = grid(Dimension::Two, 32);
    scene
}

fn slide(context: &Context, spacing: f32, end: f64, wall: WallPressure) -> Result<Slid, Failure> {
    let scene = scene(spacing, wall);
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let title = format!("{NAME} {}", wall.name());
    let mut walls = 0.0;
    step(&title, context, &mut solver, steps_to(&scene, end), STEPS_PER_SAMPLE, |solver| {
        walls = larger(walls, off(solver, true));
    })?;
    // half a spacing further on lie the first particles of the walls
    let inside = |x: f32| (-0.5 * spacing..=1.0 + 0.5 * spacing).contains(&x);
    let all = fluid(&solver);
    let near: Vec<f64> = all
        .iter()
        .filter(|p| (p.position.truncate() - 0.5).length() < 2.0 * spacing)
        .map(|p| f64::from(p.velocity.x / LID))
        .collect();
    Ok(Slid {
        wall: walls,
        fluid: off(&solver, false),
        middle: near.iter().sum::<f64>() / near.len() as f64,
        lost: all.iter().filter(|p| !(inside(p.position.x) && inside(p.position.y))).count(),
    })
}

/// Returns the largest deviation from the rest density of wall particles or of fluid particles, over the rest density.
fn off(solver: &Solver<'_>, is_wall: bool) -> f64 {
    let of = solver.particles().filter(|particle| particle.is_wall == is_wall);
    of.map(|particle| (f64::from(particle.density) / f64::from(REST_DENSITY) - 1.0).abs()).fold(0.0, larger)
}
