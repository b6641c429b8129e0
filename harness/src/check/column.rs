//! Water at rest in a tank of wall particles in the plane, open at the top: what three studies look at.
use super::flow::{fluid, grid, mean};
use super::recipes::WENDLAND;
use glam::Vec3;
use millpond_core::Solver;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{Block, Dimension, Face, Fluid, Formulation, Kernel, Scene, Wall, WallShape};

/// A tank of water.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    /// Distance between particles, m.
    pub(super) spacing: f32,
    /// Width of the tank, m.
    pub(super) width: f32,
    /// Depth of the water, m.
    pub(super) depth: f32,
    /// Downward acceleration, m/s2.
    pub(super) gravity: f32,
    /// m/s.
    pub(super) speed_of_sound: f32,
    /// Share of a support radius that sound travels in a time step.
    pub(super) courant: f64,
    /// Kernel of all terms, and particles inside its support.
    pub(super) kernel: (Kernel, f32),
    /// Displacement at the start, spacings.
    pub(super) jitter: f32,
}

/// With so many neighbours the gradient of the cubic spline is exact on the lattice; with others it is up to 2 % too small,
/// and the pressure that holds the water up as much too large.
const EXACT: (Kernel, f32) = (Kernel::CubicSpline, 27.0);

/// An even lattice settles into rows whose pressures alternate, which no density sum sees.
const JITTER: f32 = 0.2;

/// kg/m3.
const REST_DENSITY: f32 = 1000.0;

/// How far the walls rise above the water, as a share of its depth.
const HEADROOM: f32 = 0.2;

/// Layers at the floor and at the surface that do not count: half of their neighbours are walls, or missing.
const MARGIN: usize = 2;

impl Column {
    /// The tank of the catalogue's case H1: g = 1 m/s2 and ten times the speed of a wave, which leaves 1 % of compression at
    /// the floor.
    pub(super) fn of_catalogue(spacing: f32) -> Column {
        let (depth, gravity) = (0.9f32, 1.0f32);
        // an eighth of a support a step is a quarter of the textbook's h
        Column {
            spacing,
            width: 1.0,
            depth,
            gravity,
            speed_of_sound: 10.0 * (gravity * depth).sqrt(),
            courant: 0.125,
            kernel: EXACT,
            jitter: JITTER,
        }
    }

    /// The scene: one kernel that does not pair, masses for which the lattice has the rest density, no suction at the
    /// surface.
    pub(super) fn scene(&self) -> Scene {
        let fluid = Fluid { rest_density: REST_DENSITY, speed_of_sound: self.speed_of_sound, ..Fluid::default() };
        let block = Block { size: Vec3::new(self.width, self.depth, 0.0), jitter: self.jitter, ..Block::default() };
        let mut scene = Scene::of(Dimension::Two, self.spacing, 1.0, fluid, block);
        scene.gravity = Vec3::new(0.0, -self.gravity, 0.0);
        let (kernel, neighbours) = self.kernel;
        scene.average_neighbours = neighbours;
        scene.time_step = (self.courant * support_radius(&scene) / f64::from(self.speed_of_sound)) as f32;
        scene.model = Formulation {
            density_kernel: kernel,
            pressure_kernel: kernel,
            viscosity_kernel: kernel,
            normalize_mass: true,
            negative_pressure: false,
            ..WENDLAND
        };
        let high = Vec3::new(self.width, self.depth * (1.0 + HEADROOM), 0.0);
        let shape = WallShape::Box { low: Vec3::ZERO, high, open: [Face::Ceiling].into_iter().collect() };
        scene.walls = [Wall::still(shape)].into_iter().collect();
        scene.grid = grid(Dimension::Two, 32);
        scene
    }

    /// `sqrt(g H)`, the speed of a long wave, m/s.
    pub(super) fn wave_speed(&self) -> f64 {
        (f64::from(self.gravity) * f64::from(self.depth)).sqrt()
    }

    /// By how much the weight lowers the mean height, `g H^2 / (3 c^2)`: a layer at y sinks by the integral of
    /// `g (H - y) / c^2` up to there, m.
    pub(super) fn compression(&self) -> f64 {
        let [gravity, depth, sound] = [self.gravity, self.depth, self.speed_of_sound].map(f64::from);
        gravity * depth.powi(2) / (3.0 * sound.powi(2))
    }

    /// Pressure at the floor, Pa.
    pub(super) fn floor_pressure(&self) -> f64 {
        f64::from(REST_DENSITY) * f64::from(self.gravity) * f64::from(self.depth)
    }

    /// Particles of the fluid that are not between the walls any more.
    pub(super) fn lost(&self, solver: &Solver<'_>) -> usize {
        let inside = |x: f32, y: f32| x >= 0.0 && x <= self.width && y >= 0.0 && y <= self.depth * (1.0 + HEADROOM);
        fluid(solver).iter().filter(|p| !inside(p.position.x, p.position.y)).count()
    }

    /// Mean height of the fluid, m.
    pub(super) fn mean_height(solver: &Solver<'_>) -> f64 {
        mean(&fluid(solver), |particle| f64::from(particle.position.y))
    }
}

/// Sums over time of each particle's height and pressure: a single state shows where the sound just is.
#[derive(Debug, Default)]
pub(super) struct Profile {
    sums: Vec<[f64; 2]>,
    samples: f64,
}

/// How far a profile is off, over the pressure at the floor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Miss {
    /// Of the layer that is furthest off.
    pub(super) largest: f64,
    /// Root of the mean square over the layers.
    pub(super) rms: f64,
}

impl Profile {
    /// Adds the state now.
    pub(super) fn add(&mut self, solver: &Solver<'_>) {
        let fluid = fluid(solver);
        self.sums.resize(fluid.len(), [0.0; 2]);
        self.samples += 1.0;
        for (sum, particle) in self.sums.iter_mut().zip(&fluid) {
            sum[0] += f64::from(particle.position.y);
            sum[1] += f64::from(particle.pressure);
        }
    }

    /// Mean height and pressure of each layer of one spacing, from the floor to the surface, margins left out.
    pub(super) fn layers(&self, column: &Column) -> Vec<[f64; 2]> {
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
        let inner = layers.into_iter().take(count.saturating_sub(MARGIN)).skip(MARGIN);
        inner.filter(|(_, n)| *n > 0.0).map(|(sums, n)| sums.map(|sum| sum / n)).collect()
    }

    /// Against `p = rho0 g (H - y)`. Compression by the equation of state alone makes 0.4 % of difference in the middle, at
    /// 1 % of density at the floor.
    pub(super) fn miss(&self, column: &Column) -> Miss {
        let floor = column.floor_pressure();
        let layers = self.layers(column);
        let off = |[height, pressure]: &[f64; 2]| pressure / floor - (1.0 - height / f64::from(column.depth));
        let rms = mean(&layers, |layer| off(layer).powi(2)).sqrt();
        // no layers at all are no good layers
        let largest =
            if layers.is_empty() { f64::NAN } else { layers.iter().map(|l| off(l).abs()).fold(0.0, f64::max) };
        Miss { largest, rms }
    }
}
