//! `water-jet`: a jet of water leaves a round opening along x and falls (case J1). Its axis is a parabola, its flow is
//! the same through every section, and its section shrinks as its speed grows, `A v = A0 v0`.
//!
//! Speed and opening are those of Pirovano, section 5.1, who took a range of 3.97 m for the exact one; a body that is
//! thrown with 4.76 m/s from a height of 3.5 m lands at 4.02 m. (His speed is that of a tank of 6.5 m with a
//! coefficient of discharge of 0.61; an ideal tank would throw the water 6.5 m.) One particle of water, which nothing
//! else touches, shows the error of the time integration alone.
use super::flow::{checked, fluid, larger, start_with};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use crate::output::progress;
use glam::{DVec3, Vec3};
use millpond_core::scene::{
    Block, DensityDiffusion, DensityForm, Dimension, Drain, Emitter, Fluid, Formulation, Opening, Recipe, Scene,
    Shifting,
};
use millpond_core::{OwnedMemory, Particle};

const NAME: &str = "water-jet";

/// Height and diameter of the opening, m, and speed of the jet there, m/s.
const HEIGHT: f64 = 3.5;
const DIAMETER: f32 = 0.2;
const SPEED: f64 = 4.76;

const GRAVITY: f64 = 9.81;

/// Speed of sound, m/s: ten times the largest speed, that at the ground.
const SOUND: f32 = 96.0;

/// Time step over the time that sound takes through a support radius.
const COURANT: f64 = 0.2;

/// Particles along the diameter, in a full and in a quick study.
const ACROSS: f32 = 10.0;
const QUICK_ACROSS: f32 = 6.0;

/// The jet is watched between these times, s, this often. The first water has then reached the ground.
const FROM: f64 = 1.0;
const UNTIL: f64 = 1.5;
const SAMPLES: u32 = 25;

/// Depths below the axis of the opening at which slabs of the jet are looked at, m, and the thickness of a slab.
const DROPS: [f64; 4] = [0.5, 1.0, 2.0, 3.0];
const SLAB: f64 = 0.1;

/// Required limits: axis, over its distance from the opening; section, over the theory; and a single particle, over the
/// distance. The limit of the flow is that of the catalogue.
const AXIS: f64 = 0.01;
const SECTION: f64 = 0.05;
const FLOW: f64 = 0.02;
const ONE: f64 = 1e-4;

/// A jet is stretched along its path, and what holds its section together is a pressure that may be a little negative.
const COHESIVE: Formulation = Formulation {
    negative_pressure: true,
    tensile_control: true,
    shifting: Shifting::Fickian,
    ..Formulation::of(Recipe::FreeSurface)
};

/// Compared formulas. The first ones have the limits, and a quick study runs only those.
const FORMS: [(&str, Formulation); 3] = [
    ("FreeSurface with negative pressure, tensile control and shifting", COHESIVE),
    ("FreeSurface", Formulation::of(Recipe::FreeSurface)),
    (
        "FreeSurface with a density sum",
        Formulation {
            density: DensityForm::Summation,
            density_diffusion: DensityDiffusion::Off,
            ..Formulation::of(Recipe::FreeSurface)
        },
    ),
];

fn scene(across: f32, model: Formulation) -> Scene {
    let spacing = DIAMETER / across;
    let water = Fluid { speed_of_sound: SOUND, ..Fluid::default() };
    let far = Block { corner: Vec3::new(-1.0, 3.5, 0.0), size: Vec3::splat(spacing), ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, spacing, 1.0, water, far);
    scene.model = model;
    scene.gravity = Vec3::new(0.0, -GRAVITY as f32, 0.0);
    let opening = Opening::Circle(DIAMETER);
    scene.emitters = [Emitter::jet([0.0, HEIGHT as f32, 0.0], Vec3::X, SPEED as f32, opening)].into_iter().collect();
    scene.drains =
        [Drain::Box { low: Vec3::new(-9.0, -9.0, -9.0), high: Vec3::new(9.0, 0.0, 9.0) }].into_iter().collect();
    let flow = std::f64::consts::FRAC_PI_4 * f64::from(DIAMETER).powi(2) * SPEED;
    scene.spare_particles = (1.2 * flow / f64::from(spacing).powi(3)) as u32;
    let support = millpond_core::backend::derive::support_radius(&scene);
    scene.time_step = (COURANT * support / f64::from(SOUND)) as f32;
    scene.grid.cells = [64, 64, 8];
    scene
}

/// Sums over the particles of a slab, over all samples.
#[derive(Clone, Copy, Default)]
struct Slab {
    count: f64,
    /// Distance from the opening along x.
    x: f64,
    /// Downward speed.
    fall: f64,
    /// Offsets from the axis, in the plane of the jet and across it, and their squares.
    offset: [f64; 2],
    squares: [f64; 2],
}

/// Returns the time at which a ballistic jet is nearest to a point, by Newton's method.
fn nearest(at: DVec3) -> f64 {
    let mut t = at.x / SPEED;
    for _ in 0..8 {
        let drop = HEIGHT - 0.5 * GRAVITY * t * t - at.y;
        let slope = SPEED * (SPEED * t - at.x) - GRAVITY * t * drop;
        let curve = SPEED * SPEED - GRAVITY * drop + (GRAVITY * t).powi(2);
        t -= slope / curve;
    }
    t
}

impl Slab {
    fn add(&mut self, particle: &Particle) {
        let at = particle.position.as_dvec3();
        let t = nearest(at);
        let direction = DVec3::new(SPEED, -GRAVITY * t, 0.0).normalize();
        let axis = DVec3::new(SPEED * t, HEIGHT - 0.5 * GRAVITY * t * t, 0.0);
        let up = DVec3::new(-direction.y, direction.x, 0.0);
        let offset = [(at - axis).dot(up), at.z];
        self.count += 1.0;
        self.x += at.x;
        self.fall -= f64::from(particle.velocity.y);
        for (i, offset) in offset.into_iter().enumerate() {
            self.offset[i] += offset;
            self.squares[i] += offset * offset;
        }
    }

    /// Returns the area of the section of a jet with an elliptic section, m2.
    fn section(&self) -> f64 {
        let spread = |i: usize| (self.squares[i] / self.count - (self.offset[i] / self.count).powi(2)).max(0.0).sqrt();
        4.0 * std::f64::consts::PI * spread(0) * spread(1)
    }
}

/// Runs the jet, and returns its slabs. The first one is at the opening, and the others at the [`DROPS`].
fn slabs(context: &Context, scene: &Scene) -> Result<[Slab; 1 + DROPS.len()], Failure> {
    let checked = checked(NAME, scene)?;
    let mut heap = OwnedMemory::of(&checked);
    let mut solver = start_with(NAME, &checked, checked.initial_particles().collect(), &mut heap)?;
    let mut slabs = [Slab::default(); 1 + DROPS.len()];
    let bar = progress(NAME, 1000);
    for sample in 0..=SAMPLES {
        let until = FROM + (UNTIL - FROM) * f64::from(sample) / f64::from(SAMPLES);
        while solver.time() < until {
            solver.step(&context.pool)?;
            bar.set_position((solver.time() / UNTIL * 1000.0) as u64);
        }
        for particle in fluid(&solver).iter().filter(|particle| particle.position.x > 0.0) {
            let drop = HEIGHT - f64::from(particle.position.y);
            if (SLAB..2.0 * SLAB).contains(&f64::from(particle.position.x)) {
                slabs[0].add(particle);
            }
            for (slab, at) in slabs[1..].iter_mut().zip(DROPS) {
                if (drop - at).abs() < SLAB / 2.0 {
                    slab.add(particle);
                }
            }
        }
    }
    bar.finish_and_clear();
    Ok(slabs)
}

/// Returns the largest distance of a single particle from its parabola on the way down, over the distance flown.
fn one(context: &Context) -> Result<f64, Failure> {
    let mut scene = scene(QUICK_ACROSS, COHESIVE);
    scene.emitters.clear();
    scene.spare_particles = 0;
    scene.blocks[0].corner = Vec3::new(0.0, HEIGHT as f32, 0.0);
    scene.blocks[0].velocity = Vec3::new(SPEED as f32, 0.0, 0.0);
    let checked = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&checked);
    let mut solver = start_with(NAME, &checked, checked.initial_particles().collect(), &mut heap)?;
    let start = fluid(&solver)[0].position.as_dvec3();
    let mut worst = 0.0;
    while solver.time() < 0.8 {
        solver.step(&context.pool)?;
        let t = solver.time();
        let exact = start + DVec3::new(SPEED * t, -0.5 * GRAVITY * t * t, 0.0);
        let flown = (exact - start).length();
        worst = larger(worst, (fluid(&solver)[0].position.as_dvec3() - exact).length() / flown.max(0.1));
    }
    Ok(worst)
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let across = if context.quick { QUICK_ACROSS } else { ACROSS };
    let mut figures =
        vec![Metric::below("one particle: distance from its parabola, over the distance flown", one(context)?, ONE)];
    let mut lines = Vec::new();
    for (i, (name, model)) in FORMS.into_iter().enumerate().take(if context.quick { 1 } else { FORMS.len() }) {
        let scene = scene(across, model);
        let slabs = slabs(context, &scene)?;
        let volume = f64::from(scene.particle_spacing).powi(3);
        let flow_in = points(across) as f64 * f64::from(scene.particle_spacing).powi(2) * SPEED;
        let mut worst = [0.0; 3];
        for (slab, drop) in slabs[1..].iter().zip(DROPS) {
            let x = SPEED * (2.0 * drop / GRAVITY).sqrt();
            // the axis of the slab lies at its middle, but its particles are spread over it
            let speed = (SPEED * SPEED + 2.0 * GRAVITY * drop).sqrt();
            let mean = slab.x / slab.count;
            let section = slab.section() / slabs[0].section();
            let flow = slab.count / f64::from(SAMPLES + 1) * volume * (slab.fall / slab.count) / SLAB;
            let off = [(mean / x - 1.0).abs(), (section / (SPEED / speed) - 1.0).abs(), (flow / flow_in - 1.0).abs()];
            for (worst, off) in worst.iter_mut().zip(off) {
                *worst = larger(*worst, off);
            }
            lines.push([
                format!("{name}, {drop} m"),
                format!("{mean:.3} of {x:.3}"),
                format!("{section:.4} of {:.4}", SPEED / speed),
                format!("{flow:.4}"),
            ]);
        }
        if i == 0 {
            let [axis, section, flow] = worst;
            figures.push(Metric::below("axis, off the parabola, over its distance from the opening", axis, AXIS));
            figures.push(Metric::below("section, off A0 v0 / v, over it", section, SECTION));
            figures.push(Metric::below("flow, off that of the emitter, over it", flow, FLOW));
        }
    }
    let titles =
        ["formulas, depth below the opening", "distance x, m", "section over that at the opening", "flow, m3/s"];
    let notes = vec![
        table(titles, lines),
        format!("The opening is {across} particles wide and has {} of them.", points(across)),
    ];
    Ok(Outcome::new(NAME, figures, notes))
}

/// Number of cell centres of a lattice in a circle of this diameter in cells.
fn points(across: f32) -> usize {
    let count = across as i32;
    let centre = |i: i32| f64::from(i) + 0.5 - f64::from(count) / 2.0;
    let inside = |(i, j): &(i32, i32)| centre(*i).hypot(centre(*j)) <= f64::from(across) / 2.0;
    (0..count).flat_map(|i| (0..count).map(move |j| (i, j))).filter(inside).count()
}
