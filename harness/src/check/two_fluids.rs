//! `two-fluids`: the catalogue's case M1. A light fluid lies at rest over a heavy one, up to a thousand times as heavy: they
//! do not mix, pressure is linear in each and the same on both sides of the interface, and no gap opens between them.
//!
//! The classic density sum smears the heavy fluid's density over the nearest rows of the light one, and the light one's over
//! the heavy one's: rows that are not compressed at all are pushed apart, or torn in as far as suction acts. The adapted
//! forms see no other fluid in their densities (S0 section 3.4.3).
use super::flow::{fluid, grid, larger, mean, rms_speed, start_with, step, steps_to};
use super::outcome::table;
use super::{Context, Figure, Outcome};
use crate::failure::Failure;
use crate::memory::Heap;
use millpond_core::guided::support_radius;
use millpond_core::scene::{
    Block, DensityForm, Dimension, Face, Fluid, Kernel, ModelChoice, PressureForce, Scene, Viscosity, Wall, WallShape,
    places,
};
use millpond_core::{Particle, Solver};

const NAME: &str = "two-fluids";

/// Particles along a side of the box of one metre, an even number: the interface is halfway up.
const SIDE: u16 = 30;
const QUICK_SIDE: u16 = 20;

/// Of the catalogue's case H1, m/s2; of the heavy fluid, kg/m3.
const GRAVITY: f32 = 1.0;
const HEAVY: f32 = 1000.0;

/// Of the heavy fluid, m/s: ten times `sqrt(g H)`. The light one is as hard to compress, `rho c^2` being the same, lest what
/// is left of noise in the heavy one's pressure crush it: it has the faster sound, and decides the time step.
const SPEED_OF_SOUND: f32 = 10.0;

/// Share of the support that sound travels in a step.
const COURANT: f64 = 0.2;

/// Artificial viscosity, as much as the tank at rest has.
const ALPHA: f32 = 0.1;

/// How many times as heavy, and how long it runs, s: the catalogue's 5 s where its thousands of steps a second allow.
const CASES: [Case; 4] = [
    Case { ratio: 2.0, end: 5.0, quick_end: 1.0 },
    Case { ratio: 10.0, end: 5.0, quick_end: 1.0 },
    Case { ratio: 100.0, end: 4.0, quick_end: 0.5 },
    Case { ratio: 1000.0, end: 1.5, quick_end: 0.2 },
];

/// Share of a run at its end over which rows are averaged, and the largest speed counts.
const LAST: f64 = 0.2;
const STEPS_PER_SAMPLE: u64 = 5;

/// Rows at the floor and at the lid whose pressure does not count: some of their neighbours are walls.
const MARGIN: usize = 2;

/// Rows on either side of the interface that are looked at one by one.
const NEAR: usize = 4;

/// Of the catalogue: rms speed over `sqrt(g H)`.
const SPEED_LIMIT: f64 = 0.01;

/// Of the pressure at the floor, for each row and for the step at the interface.
const PRESSURE_LIMIT: f64 = 0.05;

/// The distance of the two rows at the interface, off a spacing by.
const GAP_LIMIT: f64 = 0.1;

/// Density over the fluid's own rest density, off 1 by: the weight makes half a per cent.
const DENSITY_LIMIT: f64 = 0.02;

/// Of two labels of one fluid: steps after which bits are compared, and the disorder that gives them work, spacings.
const LABEL_STEPS: u64 = 50;
const JITTER: f32 = 0.2;

/// Kernel of all sums, and particles inside its support: a lattice under pressure bears shear by these, as a still fluid
/// that began on one should. (With 32 and Wendland's C2 it gives way: `millpond check kernels` has the table.)
const KERNEL: (Kernel, f32) = (Kernel::WendlandC4, 32.0);

type Form = (DensityForm, PressureForce);

/// The first one has limits; the second has the thesis' gradient, of which half of the step of the weight is missing in the
/// rows at the interface.
const ADAPTED: Form = (DensityForm::SummationAdapted, PressureForce::DensityWeighted);
const THESIS: Form = (DensityForm::SummationAdapted, PressureForce::MonaghanAdapted);
const CLASSIC: Form = (DensityForm::Summation, PressureForce::Monaghan);

/// A ratio of densities.
#[derive(Clone, Copy, Debug)]
struct Case {
    ratio: f32,
    end: f64,
    quick_end: f64,
}

/// Means over the particles of one row of the lattice, and over time.
#[derive(Clone, Copy, Debug)]
struct Row {
    /// m.
    height: f64,
    /// Pa.
    pressure: f64,
    /// Over the fluid's own rest density.
    density: f64,
}

/// What a run came to.
#[derive(Clone, Debug)]
struct Rest {
    ratio: f64,
    side: f64,
    seconds: f64,
    steps: u64,
    /// Particles beyond the interface by more than a spacing, or out of the box.
    mixed: usize,
    /// Largest rms speed, over `sqrt(g H)`.
    speed: f64,
    /// From floor to lid.
    rows: Vec<Row>,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let side = if context.quick { QUICK_SIDE } else { SIDE };
    let mut figures = Vec::new();
    let (mut lines, mut profiles) = (Vec::new(), Vec::new());
    for case in CASES {
        let adapted = rest(context, side, case, ADAPTED)?;
        let classic = rest(context, side, case, CLASSIC);
        figures.extend(adapted.figures());
        lines.push(line(case, ADAPTED, Ok(&adapted)));
        lines.push(line(case, THESIS, rest(context, side, case, THESIS).as_ref()));
        lines.push(line(case, CLASSIC, classic.as_ref()));
        let smeared = start(&scene(side, case.ratio, CLASSIC), side)?;
        profiles.push(profile(case, &smeared, &adapted, classic.as_ref().ok()));
    }
    for form in [ADAPTED, CLASSIC] {
        let name = format!("hashes that differ, two labels of one fluid, {}", form.0.name());
        figures.push(Figure::below(name, labels(context, side, form)?, 0.0));
    }
    let titles = [
        "ratio",
        "density, pressure force",
        "s, steps",
        "rms speed over sqrt(g H)",
        "pressure off by: rms, largest",
        "step at the interface",
        "rows at the interface, spacings apart",
        "particles beyond it",
    ];
    let note = "Pressures are over that at the floor, the level of the closed box taken off. A step of the lighter fluids is shorter, as their sound is faster: \
                they run for less time.";
    let mut notes = vec![table(titles, lines), note.into()];
    notes.extend(profiles);
    Ok(Outcome::new(NAME, figures, notes))
}

fn line(case: Case, form: Form, rest: Result<&Rest, &Failure>) -> [String; 8] {
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

/// Where the rows about the interface lie and how dense they are: with the classic forms at once, when only the sum has
/// been made, then at the end with both.
fn profile(case: Case, smeared: &[Row], adapted: &Rest, classic: Option<&Rest>) -> String {
    let titles = [
        "rows from the interface",
        "classic, start: density over own",
        "classic, end: spacings away",
        "density over own",
        "adapted, end: spacings away",
        "density over own",
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

fn scene(side: u16, ratio: f32, (density, pressure_force): Form) -> Scene {
    let heavy =
        Fluid { rest_density: HEAVY, speed_of_sound: SPEED_OF_SOUND, alpha: ALPHA, beta: 0.0, ..Fluid::default() };
    let light = Fluid { rest_density: HEAVY / ratio, speed_of_sound: SPEED_OF_SOUND * ratio.sqrt(), ..heavy };
    let below = Block { size: [1.0, 0.5, 0.0], ..Block::default() };
    let above = Block { fluid: 1, corner: [0.0, 0.5, 0.0], ..below };
    let mut scene = Scene::of(Dimension::Two, 1.0 / f32::from(side), 1.0, heavy, below);
    scene.other_fluids = [light].into_iter().collect();
    scene.blocks = [below, above].into_iter().collect();
    let (kernel, neighbours) = KERNEL;
    scene.average_neighbours = neighbours;
    scene.time_step = (COURANT * support_radius(&scene) / f64::from(light.speed_of_sound)) as f32;
    scene.gravity = [0.0, -GRAVITY, 0.0];
    scene.model = ModelChoice {
        density,
        pressure_force,
        viscosity: Viscosity::Artificial,
        hydrostatic_start: true,
        calibrated_mass: true,
        density_kernel: kernel,
        pressure_kernel: kernel,
        viscosity_kernel: kernel,
        ..ModelChoice::multiphase()
    };
    // each fluid between walls of its own density: what the classic sum smears is the interface alone
    let walls = |fluid: u32, from: f32, open: Face| {
        let (low, high) = ([0.0, from, 0.0], [1.0, from + 0.5, 0.0]);
        Wall { fluid, ..Wall::still(WallShape::Box { low, high, open: [open].into_iter().collect() }) }
    };
    scene.walls = [walls(0, 0.0, Face::Ceiling), walls(1, 0.5, Face::Floor)].into_iter().collect();
    scene.grid = grid(Dimension::Two, 32);
    scene
}

fn rest(context: &Context, side: u16, case: Case, form: Form) -> Result<Rest, Failure> {
    let scene = scene(side, case.ratio, form);
    let end = if context.quick { case.quick_end } else { case.end };
    let mut heap = Heap::of(&scene);
    let mut solver = start_with(NAME, &scene, places(&scene).collect(), &mut heap)?;
    let (mut samples, mut speed) = (Vec::new(), 0.0);
    let title = format!("{NAME} {} {}", case.ratio, form.0.name());
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

/// The rows of a scene that has only begun.
fn start(scene: &Scene, side: u16) -> Result<Vec<Row>, Failure> {
    let mut heap = Heap::of(scene);
    let solver = start_with(NAME, scene, places(scene).collect(), &mut heap)?;
    Ok(rows(&solver, scene, side))
}

/// The rows that the particles began in, from floor to lid: the ids of a block run along x, and the lower block is first.
fn rows(solver: &Solver<'_>, scene: &Scene, side: u16) -> Vec<Row> {
    let row = |particles: &[Particle]| Row {
        height: mean(particles, |p| f64::from(p.position.y)),
        pressure: mean(particles, |p| f64::from(p.pressure)),
        density: mean(particles, |p| f64::from(p.density) / f64::from(scene.fluid_of(p.fluid).rest_density)),
    };
    fluid(solver).chunks(usize::from(side)).map(row).collect()
}

/// Means over time.
fn averaged(samples: &[Vec<Row>]) -> Vec<Row> {
    let row = |i: usize| Row {
        height: mean(samples, |rows| rows[i].height),
        pressure: mean(samples, |rows| rows[i].pressure),
        density: mean(samples, |rows| rows[i].density),
    };
    (0..samples.first().map_or(0, Vec::len)).map(row).collect()
}

fn mixed(solver: &Solver<'_>, side: u16) -> usize {
    let spacing = 1.0 / f32::from(side);
    let at_home = |p: &Particle| {
        let y = if p.fluid == 0 { 0.0..0.5 + spacing } else { 0.5 - spacing..1.0 };
        (0.0..1.0).contains(&p.position.x) && y.contains(&p.position.y)
    };
    fluid(solver).iter().filter(|p| !at_home(p)).count()
}

/// The rows about the interface, half of them below it; all of what has fewer.
fn near(rows: &[Row]) -> &[Row] {
    let first = (rows.len() / 2).saturating_sub(NEAR);
    rows.get(first..first + 2 * NEAR).unwrap_or(rows)
}

impl Rest {
    /// Pressure of a row less `p = g int rho dy` from the lid down, over that at the floor.
    fn miss(&self, row: &Row) -> f64 {
        let exact = |y: f64| (0.5 - y).max(0.0) + (1.0 - y).min(0.5) / self.ratio;
        (row.pressure / f64::from(HEAVY * GRAVITY) - exact(row.height)) / exact(0.0)
    }

    /// Rows whose pressure counts.
    fn inner(&self) -> &[Row] {
        self.rows.get(MARGIN..self.rows.len().saturating_sub(MARGIN)).unwrap_or(&[])
    }

    /// By how much all of the pressure is off, over that at the floor: a closed box may hold its fluids at any level, and
    /// half a row more or less between its walls is one.
    fn level(&self) -> f64 {
        mean(self.inner(), |row| self.miss(row))
    }

    fn rms_miss(&self) -> f64 {
        mean(self.inner(), |row| (self.miss(row) - self.level()).powi(2)).sqrt()
    }

    fn largest_miss(&self) -> f64 {
        // no rows at all are no good rows
        let least = if self.inner().is_empty() { f64::NAN } else { 0.0 };
        self.inner().iter().map(|row| (self.miss(row) - self.level()).abs()).fold(least, larger)
    }

    /// What the nearest rows above miss more than those below: a step that the pressure makes at the interface.
    fn jump(&self) -> f64 {
        let near = near(&self.rows);
        let (below, above) = near.split_at(near.len() / 2);
        mean(above, |row| self.miss(row)) - mean(below, |row| self.miss(row))
    }

    /// From the highest heavy row to the lowest light one, spacings.
    fn gap(&self) -> f64 {
        let (heavy, light) = self.rows.split_at(self.rows.len() / 2);
        match (heavy.last(), light.first()) {
            (Some(below), Some(above)) => (above.height - below.height) * self.side,
            _ => f64::NAN,
        }
    }

    /// Largest miss of a density about the interface, over the fluid's own.
    fn density_miss(&self) -> f64 {
        let near = near(&self.rows);
        let least = if near.is_empty() { f64::NAN } else { 0.0 };
        near.iter().map(|row| (row.density - 1.0).abs()).fold(least, larger)
    }

    fn figures(&self) -> Vec<Figure> {
        let name = |what: &str| format!("ratio {}: {what}", self.ratio);
        vec![
            Figure::below(name("particles beyond the interface"), self.mixed as f64, 0.0),
            Figure::below(name("rms speed over sqrt(g H)"), self.speed, SPEED_LIMIT),
            Figure::below(
                name("pressure of a row off by, over that at the floor"),
                self.largest_miss(),
                PRESSURE_LIMIT,
            ),
            Figure::below(name("step of the pressure at the interface"), self.jump().abs(), PRESSURE_LIMIT),
            Figure::below(name("gap at the interface, off a spacing by"), (self.gap() - 1.0).abs(), GAP_LIMIT),
            Figure::below(name("density about it over its own, off 1 by"), self.density_miss(), DENSITY_LIMIT),
        ]
    }
}

/// 1 where it makes a difference that one fluid goes by two names, else 0.
fn labels(context: &Context, side: u16, form: Form) -> Result<f64, Failure> {
    let mut two = scene(side, 1.0, form);
    for block in &mut two.blocks {
        block.jitter = JITTER;
    }
    let mut one = two.clone();
    one.other_fluids.clear();
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
    let mut heap = Heap::of(scene);
    let mut solver = start_with(NAME, scene, places(scene).collect(), &mut heap)?;
    step(NAME, context, &mut solver, LABEL_STEPS, LABEL_STEPS, |_| ())?;
    Ok(solver.hash())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run that came out as it should, of a fluid ten times as heavy.
    fn perfect() -> Rest {
        let row = |i: u16| {
            let height = (f64::from(i) + 0.5) / 20.0;
            let depths = [(0.5 - height).max(0.0), (1.0 - height).min(0.5)];
            Row { height, pressure: 1000.0 * depths[0] + 100.0 * depths[1], density: 1.0 }
        };
        let rows = (0..20).map(row).collect();
        Rest { ratio: 10.0, side: 20.0, seconds: 1.0, steps: 1, mixed: 0, speed: 0.0, rows }
    }

    #[test]
    fn a_perfect_rest_passes() {
        assert!(perfect().figures().iter().all(|figure| figure.ok));
    }

    #[test]
    fn a_gap_and_a_step_are_seen() {
        let mut torn = perfect();
        for row in &mut torn.rows[10..] {
            row.height += 0.5 / 20.0;
            row.pressure += 100.0;
        }
        assert!((torn.gap() - 1.5).abs() < 1e-12);
        assert!((torn.jump() - 102.5 / 550.0).abs() < 1e-12);
    }

    #[test]
    fn no_rows_are_no_rest() {
        let nothing = Rest { rows: Vec::new(), ..perfect() };
        assert_eq!(nothing.figures().iter().filter(|figure| figure.ok).count(), 2);
    }
}
