//! A tank of water at rest in two dimensions, open at the top. It is used by the studies
//! `hydrostatic`, `still-tank` and `pressure-correction`.
use super::enclosure::Enclosure;
use super::flow::{fluid, grid, mean};
use super::form::Form;
use super::formulas::WENDLAND;
use glam::Vec3;
use millpond_core::Solver;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{Block, Dimension, Face, Fluid, Formulation, Kernel, Scene};

/// A tank of water.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    /// Particle spacing, m.
    pub(super) spacing: f32,
    /// Width of the tank, m.
    pub(super) width: f32,
    /// Depth of the water, m.
    pub(super) depth: f32,
    /// Downward acceleration, m/s2.
    pub(super) gravity: f32,
    /// Speed of sound, m/s.
    pub(super) speed_of_sound: f32,
    /// Share of the support radius that sound travels in a time step.
    pub(super) courant: f64,
    /// What holds the water.
    pub(super) walls: Enclosure,
    /// The formulas. Walls set the pressure that the fluid sees at them.
    pub(super) model: Formulation,
    /// Number of neighbours.
    pub(super) neighbours: f32,
    /// Random displacement at the start, in spacings.
    pub(super) jitter: f32,
}

/// With 27 neighbours the gradient of the cubic spline is exact on the lattice. With other numbers it is up to 2 % too
/// small, and the pressure that carries the water is too large by as much.
const EXACT: f32 = 27.0;

/// A single kernel serves all terms, and particles do not pair with it. Masses are chosen so that the lattice has the
/// rest density. Negative pressure is off, so that there is none at the surface.
pub(super) const SPLINE: Formulation = of_one_kernel(Kernel::CubicSpline);

/// The same with a kernel with which a lattice under pressure keeps its rows.
pub(super) const REGULAR: Formulation = of_one_kernel(Kernel::WendlandC2);

const fn of_one_kernel(kernel: Kernel) -> Formulation {
    Formulation {
        density_kernel: kernel,
        pressure_kernel: kernel,
        viscosity_kernel: kernel,
        normalize_mass: true,
        negative_pressure: false,
        ..WENDLAND
    }
}

/// Random displacement at the start, in spacings. A regular lattice would settle into rows with alternating pressures,
/// which a density sum does not detect.
const JITTER: f32 = 0.2;

/// Rest density, kg/m3.
const REST_DENSITY: f32 = 1000.0;

/// Height of the walls above the water, as a share of its depth.
const HEADROOM: f32 = 0.2;

/// Layers at the floor and at the surface that are excluded: half of their neighbours are wall particles, or missing.
const MARGIN: usize = 2;

impl Column {
    /// Returns the tank of case H1 (after Adami et al. 2012): g = 1 m/s2 and a speed of sound of ten times the
    /// long-wave speed, which compresses the water by 1 % at the floor.
    pub(super) fn of_reference_case(spacing: f32) -> Column {
        let (depth, gravity) = (0.9f32, 1.0f32);
        // an eighth of the support radius per step is a quarter of the smoothing length h = H / 2 of textbooks
        Column {
            spacing,
            width: 1.0,
            depth,
            gravity,
            speed_of_sound: 10.0 * (gravity * depth).sqrt(),
            courant: 0.125,
            walls: Enclosure::MIRRORED,
            model: SPLINE,
            neighbours: EXACT,
            jitter: JITTER,
        }
    }

    /// Returns the tank with these walls and formulas.
    pub(super) fn with(self, form: &Form) -> Column {
        Column { walls: form.walls, model: form.model, ..self }
    }

    /// Returns the scene.
    pub(super) fn scene(&self) -> Scene {
        let fluid = Fluid { rest_density: REST_DENSITY, speed_of_sound: self.speed_of_sound, ..Fluid::default() };
        let block = Block { size: Vec3::new(self.width, self.depth, 0.0), jitter: self.jitter, ..Block::default() };
        let mut scene = Scene::of(Dimension::Two, self.spacing, 1.0, fluid, block);
        scene.gravity = Vec3::new(0.0, -self.gravity, 0.0);
        scene.average_neighbours = Some(self.neighbours);
        scene.time_step = (self.courant * support_radius(&scene) / f64::from(self.speed_of_sound)) as f32;
        scene.model = self.model;
        let high = Vec3::new(self.width, self.depth * (1.0 + HEADROOM), 0.0);
        self.walls.enclose(&mut scene, high, &[Face::Ceiling], None);
        scene.grid = grid(Dimension::Two, 32);
        scene
    }

    /// Returns the speed of a long wave, `sqrt(g H)`, m/s. H is the depth of the water.
    pub(super) fn wave_speed(&self) -> f64 {
        (f64::from(self.gravity) * f64::from(self.depth)).sqrt()
    }

    /// Returns by how much the weight lowers the mean height, `g H^2 / (3 c^2)`, m. A layer at height y sinks by the
    /// integral of `g (H - y) / c^2` from the floor to y.
    pub(super) fn compression(&self) -> f64 {
        let [gravity, depth, sound] = [self.gravity, self.depth, self.speed_of_sound].map(f64::from);
        gravity * depth.powi(2) / (3.0 * sound.powi(2))
    }

    /// Returns the hydrostatic pressure at the floor, Pa.
    pub(super) fn floor_pressure(&self) -> f64 {
        f64::from(REST_DENSITY) * f64::from(self.gravity) * f64::from(self.depth)
    }

    /// Returns the error of the pressure of a layer, given with its height, over the pressure at the floor.
    pub(super) fn off(&self, [height, pressure]: &[f64; 2]) -> f64 {
        pressure / self.floor_pressure() - (1.0 - height / f64::from(self.depth))
    }

    /// Returns the number of fluid particles that are no longer between the walls.
    pub(super) fn lost(&self, solver: &Solver<'_>) -> usize {
        let inside = |x: f32, y: f32| x >= 0.0 && x <= self.width && y >= 0.0 && y <= self.depth * (1.0 + HEADROOM);
        fluid(solver).iter().filter(|p| !inside(p.position.x, p.position.y)).count()
    }

    /// Returns the mean height of the fluid, m.
    pub(super) fn mean_height(solver: &Solver<'_>) -> f64 {
        mean(&fluid(solver), |particle| f64::from(particle.position.y))
    }
}

/// Sums of each particle's height and pressure over time. The profile needs a mean over time, since a single state also
/// contains the sound waves of that moment.
#[derive(Debug, Default)]
pub(super) struct Profile {
    sums: Vec<[f64; 2]>,
    samples: f64,
}

/// Errors of a pressure profile, over the pressure at the floor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Miss {
    /// Largest error of a layer.
    pub(super) largest: f64,
    /// Root mean square error over the layers.
    pub(super) rms: f64,
}

impl Profile {
    /// Adds the current state.
    pub(super) fn add(&mut self, solver: &Solver<'_>) {
        let fluid = fluid(solver);
        self.sums.resize(fluid.len(), [0.0; 2]);
        self.samples += 1.0;
        for (sum, particle) in self.sums.iter_mut().zip(&fluid) {
            sum[0] += f64::from(particle.position.y);
            sum[1] += f64::from(particle.pressure);
        }
    }

    /// Returns the mean height and pressure of each layer of one spacing, from the floor to the surface, without the
    /// excluded layers.
    pub(super) fn layers(&self, column: &Column) -> Vec<[f64; 2]> {
        let all = self.every_layer(column);
        let inner = all.len().saturating_sub(MARGIN);
        all.into_iter().take(inner).skip(MARGIN).flatten().collect()
    }

    /// Returns the mean height and pressure of every layer of one spacing, from the floor to the surface; `None` for a
    /// layer without particles.
    pub(super) fn every_layer(&self, column: &Column) -> Vec<Option<[f64; 2]>> {
        let count = (column.depth / column.spacing).round() as usize;
        let mut layers = vec![([0.0; 2], 0.0); count];
        for sum in &self.sums {
            let [height, pressure] = sum.map(|sum| sum / self.samples);
            let layer = (height / f64::from(column.spacing)).floor();
            if let Some((sums, particles)) = layers.get_mut(layer.max(0.0) as usize) {
                *sums = [sums[0] + height, sums[1] + pressure];
                *particles += 1.0;
            }
        }
        layers.into_iter().map(|(sums, n)| (n > 0.0).then(|| sums.map(|sum| sum / n))).collect()
    }

    /// Compares the profile with `p = rho0 g (H - y)`. The compression by the equation of state alone causes a
    /// difference of 0.4 % in the middle, if the density at the floor is 1 % higher than at rest.
    pub(super) fn miss(&self, column: &Column) -> Miss {
        let layers = self.layers(column);
        let off = |layer: &[f64; 2]| column.off(layer);
        let rms = mean(&layers, |layer| off(layer).powi(2)).sqrt();
        // without layers the error must not pass as zero
        let largest =
            if layers.is_empty() { f64::NAN } else { layers.iter().map(|l| off(l).abs()).fold(0.0, f64::max) };
        Miss { largest, rms }
    }
}
