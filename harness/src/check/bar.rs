//! The second part of `tensile`: a bar of fluid, four times as long as wide, in nothing and without viscosity, that
//! spins by one radian. It is stretched, and its pressure is negative throughout. Its kinetic energy and its angular
//! momentum do not change. Fluid that is stretched tears where particles do not move into the gaps, and where the bar
//! becomes thinner its rows come together.
use super::flow::{checked, closest_pair, fluid, grid, heap_for, start_with, step, steps_to};
use super::formulas::SHIFTED;
use super::{Context, Metric};
use crate::failure::Failure;
use glam::{Vec2, Vec3};
use millpond_core::Solver;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{Block, Dimension, Fluid, Formulation, InitialParticle, Scene, Shifting, Viscosity};
use std::collections::VecDeque;

const NAME: &str = "tensile";

/// Particles along the width of the bar, in a full and in a quick study. The width is 1 m, and the bar turns at 1
/// rad/s.
const WIDTHS: [u16; 3] = [25, 50, 100];
const LENGTH: f32 = 4.0;

/// Number of neighbours; speed of sound, m/s, 12 times that of the bar's ends at the start; and share of the support
/// radius that sound travels in a step.
const AVERAGE_NEIGHBOURS: f32 = 32.0;
const SPEED_OF_SOUND: f32 = 25.0;
const COURANT: f32 = 0.2;

/// End of the run, s: one radian.
const END: f64 = 1.0;
const STEPS_PER_SAMPLE: u64 = 20;

/// Required limits: changes of kinetic energy and of angular momentum, and distance of the closest pair, in spacings.
const ENERGY: f64 = 0.01;
const MOMENTUM: f64 = 0.005;
const CLOSEST: f64 = 0.5;

/// Change of the angular momentum without shifting and tensile control, when all forces are equal and opposite along
/// the line of a pair: the rounding of 1600 steps.
const ROUNDING: f64 = 1e-5;

/// Edge of a cell of the raster on which holes are looked for, in spacings.
const CELL: f32 = 0.25;

/// Results of a run.
#[derive(Clone, Copy, Debug)]
struct Spin {
    /// Largest relative change of the kinetic energy.
    energy: f64,
    /// Largest relative change of the angular momentum.
    momentum: f64,
    /// Smallest distance between two particles, in spacings.
    closest: f64,
    /// Share of the area that is hole, at the end.
    holes: f64,
    /// Number of separate parts of the fluid, at the end.
    parts: usize,
}

/// Returns the figures and the lines of the table.
pub(super) fn run(context: &Context) -> Result<(Vec<Metric>, Vec<[String; 7]>), Failure> {
    let (mut figures, mut lines, mut momenta) = (Vec::new(), Vec::new(), Vec::new());
    for width in if context.quick { &WIDTHS[..1] } else { &WIDTHS } {
        let spin = spin(context, *width, SHIFTED)?;
        let of = |what: &str| format!("{what} of a spinning bar, {width} spacings wide");
        figures.push(Metric::below(of("change of the kinetic energy"), spin.energy, ENERGY));
        figures.push(Metric::below(of("change of the angular momentum"), spin.momentum, MOMENTUM));
        figures.push(Metric::above(of("closest pair over spacing"), spin.closest, CLOSEST));
        figures.push(Metric::below(of("share of holes"), spin.holes, 0.0));
        figures.push(Metric::below(of("separate parts"), spin.parts as f64, 1.0));
        momenta.push(spin.momentum);
        lines.push(line(*width, "shifting, tensile control", &spin));
    }
    if let (Some(coarse), [_, .., fine]) = (momenta.first(), &momenta[..]) {
        let name = "change of the angular momentum of the finest bar over that of the coarsest";
        figures.push(Metric::below(name, fine / coarse, 1.0));
    }
    let plain = Formulation { shifting: Shifting::Off, tensile_control: false, ..SHIFTED };
    let bare = spin(context, WIDTHS[0], plain)?;
    let name = "change of the angular momentum of a spinning bar, without shifting and tensile control";
    figures.push(Metric::below(name, bare.momentum, ROUNDING));
    lines.push(line(WIDTHS[0], "neither", &bare));
    if !context.quick {
        let shifted = Formulation { tensile_control: false, ..SHIFTED };
        lines.push(line(WIDTHS[0], "shifting", &spin(context, WIDTHS[0], shifted)?));
        let controlled = Formulation { shifting: Shifting::Off, ..SHIFTED };
        lines.push(line(WIDTHS[0], "tensile control", &spin(context, WIDTHS[0], controlled)?));
    }
    Ok((figures, lines))
}

fn line(width: u16, choice: &str, spin: &Spin) -> [String; 7] {
    [
        width.to_string(),
        choice.into(),
        format!("{:.3} %", spin.energy * 100.0),
        format!("{:.4} %", spin.momentum * 100.0),
        format!("{:.2}", spin.closest),
        format!("{:.2} %", spin.holes * 100.0),
        spin.parts.to_string(),
    ]
}

fn scene(width: u16, model: Formulation) -> Scene {
    let spacing = 1.0 / f32::from(width);
    let fluid = Fluid { speed_of_sound: SPEED_OF_SOUND, dynamic_viscosity: 0.0, ..Fluid::default() };
    let size = Vec3::new(1.0, LENGTH, 0.0);
    let block = Block { corner: size * -0.5, size, ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, spacing, 1.0, fluid, block);
    scene.average_neighbours = Some(AVERAGE_NEIGHBOURS);
    scene.time_step = COURANT * support_radius(&scene) as f32 / SPEED_OF_SOUND;
    scene.model = Formulation { viscosity: Viscosity::Morris, ..model };
    scene.grid = grid(Dimension::Two, 64);
    scene
}

fn spin(context: &Context, width: u16, model: Formulation) -> Result<Spin, Failure> {
    let scene = scene(width, model);
    let spacing = scene.particle_spacing;
    let scene = checked(NAME, &scene)?;
    let turning = |place: InitialParticle| {
        let velocity = Vec3::new(-place.position.y, place.position.x, 0.0);
        InitialParticle { velocity, ..place }
    };
    let places: Vec<InitialParticle> = scene.initial_particles().map(turning).collect();
    let mut heap = heap_for(&scene, places.len());
    let mut solver = start_with(NAME, &scene, places, &mut heap)?;
    let at_start = [solver.energies().kinetic, angular_momentum(&solver)];
    let (mut energy, mut momentum, mut closest) = (0.0f64, 0.0f64, f64::INFINITY);
    let title = format!("{NAME}, bar {width}");
    step(&title, context, &mut solver, steps_to(&scene, END), STEPS_PER_SAMPLE, |solver| {
        energy = energy.max((solver.energies().kinetic / at_start[0] - 1.0).abs());
        momentum = momentum.max((angular_momentum(solver) / at_start[1] - 1.0).abs());
        closest = closest.min(closest_pair(solver) / f64::from(spacing));
    })?;
    let places: Vec<Vec2> = fluid(&solver).iter().map(|particle| particle.position.truncate()).collect();
    let Raster { holes, parts } = Raster::of(&places, spacing);
    Ok(Spin { energy, momentum, closest, holes, parts })
}

/// Returns the angular momentum about the origin, over the mass of a particle, m2/s.
fn angular_momentum(solver: &Solver<'_>) -> f64 {
    let of = |x: Vec3, v: Vec3| f64::from(x.x) * f64::from(v.y) - f64::from(x.y) * f64::from(v.x);
    fluid(solver).iter().map(|particle| of(particle.position, particle.velocity)).sum()
}

/// The area within one spacing of a particle, looked at cell by cell.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Raster {
    /// Share of enclosed area that is further than a spacing from every particle.
    holes: f64,
    /// Number of connected parts.
    parts: usize,
}

/// What a cell of the raster is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Cell {
    Empty,
    Outside,
    Covered,
    Counted,
}

impl Raster {
    fn of(places: &[Vec2], spacing: f32) -> Raster {
        let bounds = |low: Vec2, place: &Vec2| low.min(*place);
        let low = places.iter().fold(Vec2::INFINITY, bounds) - 3.0 * spacing;
        let high = places.iter().fold(Vec2::NEG_INFINITY, |high, place| high.max(*place)) + 3.0 * spacing;
        let cell = CELL * spacing;
        let [columns, rows] = ((high - low) / cell).ceil().to_array().map(|count| count as usize);
        let mut cells = vec![Cell::Empty; columns * rows];
        let reach = (1.0 / CELL).ceil() as i64;
        for place in places {
            let middle = (*place - low) / cell;
            for j in -reach..=reach {
                for i in -reach..=reach {
                    let [x, y] = [middle.x as i64 + i, middle.y as i64 + j];
                    if (Vec2::new(x as f32, y as f32) - middle).length() * cell <= spacing {
                        cells[x as usize + columns * y as usize] = Cell::Covered;
                    }
                }
            }
        }
        let mut fill = |start: usize, from: Cell, to: Cell| {
            let mut queue = VecDeque::from([start]);
            cells[start] = to;
            while let Some(at) = queue.pop_front() {
                let [x, y] = [at % columns, at / columns];
                let beside = [
                    (x > 0, at.wrapping_sub(1)),
                    (x + 1 < columns, at + 1),
                    (y > 0, at.wrapping_sub(columns)),
                    (y + 1 < rows, at + columns),
                ];
                for (_, next) in beside.into_iter().filter(|(exists, _)| *exists) {
                    if cells[next] == from {
                        cells[next] = to;
                        queue.push_back(next);
                    }
                }
            }
            cells.iter().position(|cell| *cell == Cell::Covered)
        };
        let mut part = fill(0, Cell::Empty, Cell::Outside);
        let mut parts = 0;
        while let Some(start) = part {
            parts += 1;
            part = fill(start, Cell::Covered, Cell::Counted);
        }
        let count = |kind: Cell| cells.iter().filter(|cell| **cell == kind).count() as f64;
        Raster { holes: count(Cell::Empty) / count(Cell::Counted), parts }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lattice without the places that `is_left_out` names.
    fn lattice(is_left_out: impl Fn(i32, i32) -> bool) -> Vec<Vec2> {
        let all = (0..20).flat_map(|j| (0..20).map(move |i| (i, j)));
        all.filter(|&(i, j)| !is_left_out(i, j)).map(|(i, j)| Vec2::new(i as f32, j as f32)).collect()
    }

    #[test]
    fn a_raster_finds_holes_and_parts() {
        assert_eq!(Raster::of(&lattice(|_, _| false), 1.0), Raster { holes: 0.0, parts: 1 });
        let hollow = Raster::of(&lattice(|i, j| (8..12).contains(&i) && (8..12).contains(&j)), 1.0);
        assert!(hollow.parts == 1 && (0.01..0.05).contains(&hollow.holes), "{hollow:?}");
        let torn = Raster::of(&lattice(|i, _| (8..12).contains(&i)), 1.0);
        assert_eq!(torn, Raster { holes: 0.0, parts: 2 });
    }
}
