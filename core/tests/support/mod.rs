//! Helpers for tests of a fluid that need only core: small scenes, threads, random numbers. The tests in `gpu/tests`
//! and `tests` include this file too.
#![allow(dead_code, unreachable_pub, reason = "each test uses its part")]
use millpond_core::backend::plan::arrays::{Class, Unit};
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    Block, Container, Dimension, Fluid, Formulation, Grid, InitialParticle, Kernel, NearPressure, PlaneModel,
    PressureForce, Recipe, Scene,
};
use millpond_core::{Array, Checked, Executor, OwnedMemory, Plan, Requirements, Solver, TimeReport};

pub mod air;
pub mod falling;
pub mod files;
pub mod forms;
pub mod refused;

/// Returns the cube of Pirovano, section 5.2, with an edge of `edge` m and 8000 particles per cubic metre. No external
/// force acts on it.
pub fn thesis_cube(edge: f32) -> Scene {
    let fluid = Fluid { dynamic_viscosity: 10.0, ..Fluid::default() };
    let block = Block { corner: Vec3::splat(-edge / 2.0), size: Vec3::splat(edge), ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, fluid, block);
    scene.model = Formulation::of(Recipe::Pirovano);
    scene.average_neighbours = Some(27.0);
    scene.grid = Grid { cells: [32, 32, 32], ..Grid::default() };
    scene
}

/// Returns the formulation of a dam break.
fn of_a_dam() -> Formulation {
    Formulation {
        density_kernel: Kernel::CubicSpline,
        pressure_kernel: Kernel::CubicSpline,
        negative_pressure: false,
        pressure_force: PressureForce::Monaghan,
        near_pressure: NearPressure::Off,
        ..Formulation::of(Recipe::Pirovano)
    }
}

/// Returns a column of water that falls into a box. All lengths are multiplied by `scale`; with 1 there are 21 000
/// particles.
pub fn dam_break(scale: f32) -> Scene {
    let fluid = Fluid { speed_of_sound: 20.0, dynamic_viscosity: 5.0, ..Fluid::default() };
    let block = Block { size: Vec3::new(1.2, 1.4, 0.8).map(|x| x * scale), jitter: 0.02, ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.04, 0.001, fluid, block);
    scene.average_neighbours = Some(32.0);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    scene.container = Some(Container {
        model: PlaneModel::Penalty,
        ..Container::closed([0.0; 3], [3.2, 2.4, 0.8].map(|x| x * scale))
    });
    scene.model = of_a_dam();
    scene.grid = Grid { cells: [48, 32, 16].map(|n: u16| (f32::from(n) * scale).ceil() as u32), ..Grid::default() };
    scene
}

/// Returns a dam break in 2D. All lengths are multiplied by `scale`; with 1 there are 3200 particles.
pub fn dam_break_2d(scale: f32) -> Scene {
    let fluid = Fluid { speed_of_sound: 25.0, dynamic_viscosity: 5.0, ..Fluid::default() };
    let block = Block { size: Vec3::new(scale, 2.0 * scale, 0.0), jitter: 0.02, ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, 0.025, 0.0005, fluid, block);
    scene.average_neighbours = Some(21.0);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    scene.container =
        Some(Container { model: PlaneModel::Penalty, ..Container::closed([0.0; 3], [4.0 * scale, 3.0 * scale, 0.0]) });
    scene.model = of_a_dam();
    let [x, y] = [64.0, 48.0].map(|n: f32| (n * scale).ceil() as u32);
    scene.grid = Grid { cells: [x, y, 1], ..Grid::default() };
    scene
}

/// Checks a scene and returns it with everything derived from it.
pub fn checked(scene: &Scene) -> Checked<'_> {
    scene.check().expect("a scene")
}

/// Allocates memory for `count` particles in the cells of `scene`.
pub fn heap_for(scene: &Scene, count: usize) -> OwnedMemory {
    OwnedMemory::with(&Requirements::of(&checked(scene)).for_particles(count))
}

/// Returns a solver with particles at rest at these positions.
pub fn at_rest<'a>(scene: &Scene, positions: &[[f32; 3]], heap: &'a mut OwnedMemory) -> Solver<'a> {
    let places = positions.iter().map(|&position| InitialParticle::at(position, [0.0; 3]));
    let scene = checked(scene);
    Solver::with_particles(&scene, Plan::of(&scene), positions.len(), places, heap.lend()).expect("a scene")
}

/// Every word of a fluid's state, ordered by particle id, and its clock. Two of these are equal only if every bit is.
#[derive(Clone, Debug, PartialEq)]
pub struct Words {
    arrays: Vec<Vec<u32>>,
    /// Report on the time step.
    pub clock: TimeReport,
}

impl Words {
    /// Takes the words of arrays whose particles lie in these slots (places in memory).
    pub fn of<'a>(slots: &[u32], words: impl Fn(Array) -> &'a [u32], clock: TimeReport) -> Words {
        let state = Array::ALL.iter().copied().filter(|array| array.class() == Class::State);
        let by_id = |array: Array| {
            let (all, entry) = (words(array), array.words());
            if array.unit() != Unit::Particle || all.is_empty() {
                return all.to_vec();
            }
            slots.iter().flat_map(|&slot| &all[slot as usize * entry..][..entry]).copied().collect()
        };
        Words { arrays: state.map(by_id).collect(), clock }
    }

    /// Takes the words of a solver.
    pub fn of_cpu(solver: &Solver<'_>) -> Words {
        Words::of(solver.slots(), |array| solver.words(array), solver.time_report())
    }
}

/// An executor with this number of threads of the standard library, which are created anew for each pass.
#[derive(Clone, Copy, Debug)]
pub struct Threads(pub usize);

impl Executor for Threads {
    fn width(&self) -> usize {
        self.0
    }

    fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync) {
        let Threads(threads) = *self;
        if threads == 1 {
            return jobs.iter_mut().for_each(work);
        }
        let share = jobs.len().div_ceil(threads).max(1);
        std::thread::scope(|scope| {
            for jobs in jobs.chunks_mut(share) {
                scope.spawn(|| jobs.iter_mut().for_each(&work));
            }
        });
    }
}

/// Random numbers with a fixed seed, always the same ones (splitmix64).
pub struct Random(pub u64);

impl Random {
    /// Returns 32 random bits.
    pub fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as u32
    }

    /// Returns a random number between 0 and 1.
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / (1u32 << 24) as f32
    }
}

/// Returns the particles that a scene starts with.
pub fn start(scene: &Scene) -> Vec<InitialParticle> {
    checked(scene).initial_particles().collect()
}

/// Adds `count` particles in a cube of half a spacing at the position of the first particle.
pub fn with_a_crowd(scene: &Scene, mut places: Vec<InitialParticle>, count: usize) -> Vec<InitialParticle> {
    let first = places[0];
    let offset = |i: usize| [7, 11, 13].map(|n| (i * n % 97) as f32 / 97.0 * 0.5 * scene.particle_spacing);
    places.extend((0..count).map(|i| {
        let offset = offset(i);
        let along = |axis: usize| if axis < scene.dimension.count() { offset[axis] } else { 0.0 };
        let position = core::array::from_fn(|axis| first.position[axis] + along(axis));
        InitialParticle { position: position.into(), ..first }
    }));
    places
}
