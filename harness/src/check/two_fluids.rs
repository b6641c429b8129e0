//! `two-fluids`: case M1. A light fluid lies at rest over a heavy one, with density ratios up to 1000. The fluids must
//! not mix, the pressure must be linear in each and continuous at the interface, and no gap may open between them.
//!
//! The classic density sum smears the density of the heavy fluid over the nearest rows of the light one, and that of
//! the light fluid over the nearest rows of the heavy one. Rows that are not compressed are then pushed apart, or
//! pulled in where pressure may be negative. The adapted forms ignore the density of the other fluid (Pirovano,
//! section 3.4.3).
use super::enclosure::Enclosure;
use super::flow::{checked, grid, larger, rms_speed, start_with, step, steps_to};
use super::form::Form;
use super::formulas::SEVERAL_FLUIDS;
use super::strata::{GRAVITY, HEAVY, NEAR, Rest, Row, averaged, mixed, near, rows};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{
    Block, DensityForm, Dimension, Face, Fluid, Formulation, Kernel, PressureForce, Scene, Viscosity, Wall, WallShape,
};

const NAME: &str = "two-fluids";

/// Particles along a side of the box of 1 m, in a full and in a quick study. The number is even, since the interface is
/// halfway up.
const SIDE: u16 = 30;
pub(super) const QUICK_SIDE: u16 = 20;

/// Speed of sound of the heavy fluid, m/s: ten times `sqrt(g H)`. The light fluid is as hard to compress (equal
/// `rho c^2`), so that the remaining pressure noise of the heavy fluid does not crush it. Its speed of sound is
/// therefore higher and determines the time step.
const SPEED_OF_SOUND: f32 = 10.0;

/// Share of the support radius that sound travels in a step.
const COURANT: f64 = 0.2;

/// Coefficient of artificial viscosity, as in `still-tank`.
const ALPHA: f32 = 0.1;

/// Density ratios and end times, s. The end is the 5 s of case M1 where the thousands of steps per second allow it.
pub(super) const CASES: [Case; 4] = [
    Case { ratio: 2.0, end: 5.0, quick_end: 1.0 },
    Case { ratio: 10.0, end: 5.0, quick_end: 1.0 },
    Case { ratio: 100.0, end: 4.0, quick_end: 0.5 },
    Case { ratio: 1000.0, end: 1.5, quick_end: 0.2 },
];

/// Share of a run, at its end, over which rows are averaged and the largest speed counts.
const LAST: f64 = 0.2;
const STEPS_PER_SAMPLE: u64 = 5;

/// Test with two labels of one fluid: steps after which the bits are compared, and random displacement of the start, in
/// spacings, so that there is motion.
const LABEL_STEPS: u64 = 50;
const JITTER: f32 = 0.2;

/// Kernel of all sums, and number of neighbours. With these a lattice under pressure resists shear, as a fluid at rest
/// that started on a lattice should. With 32 neighbours and Wendland's C2 it gives way (`millpond check kernels` prints
/// the table).
const KERNEL: (Kernel, f32) = (Kernel::WendlandC4, 32.0);

/// Compared forms. The first one has the limits. The second one has Pirovano's pressure gradient, which lacks half of
/// the step of the weight in the rows at the interface.
const ADAPTED: Sums = (DensityForm::SummationAdapted, PressureForce::DensityWeighted);
const SYMMETRIC: Sums = (DensityForm::SummationAdapted, PressureForce::MonaghanAdapted);
const CLASSIC: Sums = (DensityForm::Summation, PressureForce::Monaghan);

type Sums = (DensityForm, PressureForce);

/// A density ratio, and how long its run is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Case {
    pub(super) ratio: f32,
    pub(super) end: f64,
    pub(super) quick_end: f64,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let side = if context.quick { QUICK_SIDE } else { SIDE };
    let mut figures = Vec::new();
    let (mut lines, mut profiles) = (Vec::new(), Vec::new());
    for case in CASES {
        let rest = |sums| rest(context, side, case, &form_of(sums), KERNEL.1);
        let adapted = rest(ADAPTED)?;
        let classic = rest(CLASSIC);
        figures.extend(adapted.figures());
        lines.push(line(case, ADAPTED, Ok(&adapted)));
        lines.push(line(case, SYMMETRIC, rest(SYMMETRIC).as_ref()));
        lines.push(line(case, CLASSIC, classic.as_ref()));
        let smeared = start(&scene(side, case.ratio, &form_of(CLASSIC), KERNEL.1), side)?;
        profiles.push(profile(case, &smeared, &adapted, classic.as_ref().ok()));
    }
    for sums in [ADAPTED, CLASSIC] {
        let name = format!("hashes that differ, two labels of one fluid, {}", sums.0.name());
        figures.push(Metric::below(name, labels(context, side, sums)?, 0.0));
    }
    let titles = [
        "ratio",
        "density, pressure force",
        "time in s, steps",
        "rms speed over sqrt(g H)",
        "pressure error: rms, largest",
        "pressure step at the interface",
        "rows at the interface, spacings apart",
        "particles beyond the interface",
    ];
    let note = "Pressure errors are over the pressure at the floor, and less their mean, since the box is closed. \
                Lighter fluids need shorter steps, since their speed of sound is higher, and run for less time.";
    let mut notes = vec![table(titles, lines), note.into()];
    notes.extend(profiles);
    Ok(Outcome::new(NAME, figures, notes))
}

fn line(case: Case, form: Sums, rest: Result<&Rest, &Failure>) -> [String; 8] {
    let percent = |x: f64| format!("{:.2} %", x * 100.0);
    let name = format!("{}, {}", form.0.name(), form.1.name());
    let [time, speed, pressure, jump, gap, mixed] = match rest {
        Ok(rest) => [
            format!("{}, {}", rest.seconds, rest.steps),
            percent(rest.speed),
            format!("{}, {}", percent(rest.rms_miss()), percent(rest.largest_miss())),
            percent(rest.jump()),
            format!("{:.2}", rest.gap()),
            rest.mixed.to_string(),
        ],
        Err(failure) => {
            let mut words = [const { String::new() }; 6];
            words[0] = failure.to_string();
            words
        }
    };
    [case.ratio.to_string(), name, time, speed, pressure, jump, gap, mixed]
}

/// Returns a table of the positions and densities of the rows near the interface: with the classic forms at the start,
/// when only the density sum has been computed, and at the end with both forms.
fn profile(case: Case, smeared: &[Row], adapted: &Rest, classic: Option<&Rest>) -> String {
    let titles = [
        "rows from the interface",
        "classic, start: density over rest density",
        "classic, end: spacings from the interface",
        "density over rest density",
        "adapted, end: spacings from the interface",
        "density over rest density",
    ];
    let words = |rest: Option<&Rest>, i: usize| {
        let row = rest.and_then(|rest| near(&rest.rows).get(i).map(|row| (row, rest.side)));
        row.map_or([String::new(), String::new()], |(row, side)| {
            [format!("{:+.2}", (row.height - 0.5) * side), format!("{:.4}", row.density)]
        })
    };
    let lines = near(smeared).iter().enumerate().map(|(i, row)| {
        let [classic_at, classic_density] = words(classic, i);
        let [adapted_at, adapted_density] = words(Some(adapted), i);
        let from = i as f64 + 0.5 - NEAR as f64;
        let density = format!("{:.4}", row.density);
        [format!("{from:+}"), density, classic_at, classic_density, adapted_at, adapted_density]
    });
    format!("Density across the interface, ratio {}:\n\n{}", case.ratio, table(titles, lines))
}

/// Returns the form of this study with these sums.
fn form_of((density, pressure_force): Sums) -> Form {
    let model = Formulation {
        density,
        pressure_force,
        viscosity: Viscosity::Artificial,
        alpha: ALPHA,
        beta: 0.0,
        // under the lid the weight causes no pressure, and negative pressure there would pull particles into the wall
        negative_pressure: false,
        initialize_hydrostatic: true,
        normalize_mass: true,
        density_kernel: KERNEL.0,
        pressure_kernel: KERNEL.0,
        viscosity_kernel: KERNEL.0,
        ..SEVERAL_FLUIDS
    };
    Form { walls: Enclosure::MIRRORED, model }
}

fn scene(side: u16, ratio: f32, form: &Form, neighbours: f32) -> Scene {
    let heavy = Fluid { rest_density: HEAVY, speed_of_sound: SPEED_OF_SOUND, ..Fluid::default() };
    let light = Fluid { rest_density: HEAVY / ratio, speed_of_sound: SPEED_OF_SOUND * ratio.sqrt(), ..heavy };
    let below = Block { size: Vec3::new(1.0, 0.5, 0.0), ..Block::default() };
    let above = Block { fluid: 1, corner: Vec3::new(0.0, 0.5, 0.0), ..below };
    let mut scene = Scene::of(Dimension::Two, 1.0 / f32::from(side), 1.0, heavy, below);
    scene.fluids.extend([light]);
    scene.blocks = [below, above].into_iter().collect();
    scene.average_neighbours = Some(neighbours);
    scene.time_step = (COURANT * support_radius(&scene) / f64::from(light.speed_of_sound)) as f32;
    scene.gravity = Vec3::new(0.0, -GRAVITY, 0.0);
    scene.model = form.model;
    // each fluid lies between walls of its own density, so that the classic sum smears only the interface
    let walls = |fluid: u32, from: f32, open: Face| {
        let (low, high) = ([0.0, from, 0.0], [1.0, from + 0.5, 0.0]);
        Wall {
            fluid,
            ..Wall::still(WallShape::Box { low: low.into(), high: high.into(), open: [open].into_iter().collect() })
        }
    };
    if let Enclosure::Particles(wall_pressure) = form.walls {
        scene.model.wall_pressure = wall_pressure;
        scene.walls = [walls(0, 0.0, Face::Ceiling), walls(1, 0.5, Face::Floor)].into_iter().collect();
    } else {
        form.walls.enclose(&mut scene, Vec3::new(1.0, 1.0, 0.0), &[], None);
    }
    scene.grid = grid(Dimension::Two, 32);
    scene
}

/// Watches the fluids.
pub(super) fn rest(context: &Context, side: u16, case: Case, form: &Form, neighbours: f32) -> Result<Rest, Failure> {
    let scene = scene(side, case.ratio, form, neighbours);
    let end = if context.quick { case.quick_end } else { case.end };
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let (mut samples, mut speed) = (Vec::new(), 0.0);
    let title = format!("{NAME} {} {}", case.ratio, form.name());
    step(&title, context, &mut solver, steps_to(&scene, end), STEPS_PER_SAMPLE, |solver| {
        if solver.time() > end * (1.0 - LAST) {
            samples.push(rows(solver, &scene, side));
            speed = larger(speed, rms_speed(solver));
        }
    })?;
    Ok(Rest {
        ratio: f64::from(case.ratio),
        side: f64::from(side),
        seconds: end,
        steps: solver.steps(),
        mixed: mixed(&solver, side),
        speed: speed / f64::from(GRAVITY).sqrt(),
        rows: averaged(&samples),
    })
}

/// Returns the rows of a scene at its start.
fn start(scene: &Scene, side: u16) -> Result<Vec<Row>, Failure> {
    let scene = &checked(NAME, scene)?;
    let mut heap = OwnedMemory::of(scene);
    let solver = start_with(NAME, scene, scene.initial_particles().collect(), &mut heap)?;
    Ok(rows(&solver, scene, side))
}

/// Returns 1 if the result depends on whether one fluid has two labels, else 0.
fn labels(context: &Context, side: u16, sums: Sums) -> Result<f64, Failure> {
    let mut two = scene(side, 1.0, &form_of(sums), KERNEL.1);
    for block in &mut two.blocks {
        block.jitter = JITTER;
    }
    let mut one = two.clone();
    one.fluids.truncate(1);
    for block in &mut one.blocks {
        block.fluid = 0;
    }
    for wall in &mut one.walls {
        wall.fluid = 0;
    }
    let differ = hash(context, &two)? != hash(context, &one)?;
    Ok(f64::from(u8::from(differ)))
}

fn hash(context: &Context, scene: &Scene) -> Result<u64, Failure> {
    let scene = &checked(NAME, scene)?;
    let mut heap = OwnedMemory::of(scene);
    let mut solver = start_with(NAME, scene, scene.initial_particles().collect(), &mut heap)?;
    step(NAME, context, &mut solver, LABEL_STEPS, LABEL_STEPS, |_| ())?;
    Ok(solver.hash())
}
