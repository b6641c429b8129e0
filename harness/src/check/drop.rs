//! A round drop in two dimensions, calmed by viscosity. The studies `laplace-drop` and `oscillating-drop` start from
//! it.
//!
//! The drop lies in vacuum, or in an identical fluid: a second fluid with the same properties, in a periodic square.
//! With an identical fluid the particles are packed more densely than at rest, so that pressure is positive everywhere.
//! Where pressure is negative particles clump, and it is lowest at an interface.
use super::Context;
use super::flow::{checked, fluid, grid, heap_for, larger, mean, start_with, step, steps_to};
use super::formulas::SEVERAL_FLUIDS;
use crate::failure::Failure;
use glam::Vec3;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{
    Block, Dimension, Fluid, Formulation, InitialParticle, Kernel, Periodic, Scene, SurfaceTension,
};
use millpond_core::{Particle, Solver};
use std::f64::consts::PI;

/// Particle spacing at the start, m. The radius of the drop of cases S1 and S2, R = 0.2 m, is 20 spacings.
pub(super) const SPACING: f32 = 0.01;

/// Rest density, kg/m3, and surface tension, N/m, of cases S1 and S2. The tension is for the models whose coefficient
/// is a surface tension.
pub(super) const REST_DENSITY: f32 = 1.0;
pub(super) const SIGMA: f32 = 1.0;

/// Side of the periodic square over the radius of the drop.
pub(super) const SIDE: u16 = 4;

/// Limits of the time step: share of the support radius that sound travels, and shares of the longest steps for
/// viscosity (Morris et al. 1997), `h^2 / nu`, and surface tension (Brackbill et al. 1992),
/// `sqrt(rho h^3 / (2 pi sigma))`. h is half of the support radius.
const COURANT: f64 = 0.2;
const DIFFUSION: f64 = 0.125;
const CAPILLARY: f64 = 0.25;

/// A particle is inside of a drop if its distance from the centre is less than the first share of the radius, and
/// outside if it is more than the second.
const INSIDE: f64 = 0.5;
const OUTSIDE: f64 = 1.5;

/// Radius of the drops to which the calming times apply, m. Viscosity calms a smaller drop sooner, in proportion to the
/// square of its radius, which a quick study uses.
const CALMED_RADIUS: f64 = 0.2;

/// Share of the calming time after which pressures are averaged.
const CALM: f64 = 0.5;
const STEPS_PER_SAMPLE: u64 = 10;

/// Settings of a surface tension model.
#[derive(Clone, Copy, Debug)]
struct Setting {
    /// `Fluid::surface_tension`, in the unit of the model.
    coefficient: f32,
    /// Kernel of all terms, and number of neighbours.
    kernel: (Kernel, f32),
    /// Speed of sound, m/s. `10 sqrt(sigma / (rho R))` limits the compression by a tension of 1 N/m to 1 % at
    /// R = 0.2 m.
    speed_of_sound: f32,
    /// Spacing of the scene over that of the particles, with a fluid around the drop. The background pressure is
    /// `rho0 c0^2 (looser^14 - 1) / 7`.
    looser: f32,
    /// Kinematic viscosity that calms the drop, m2/s, and calming time, s.
    calming: (f32, f64),
}

/// The curvature from the colour field also contains the second derivative of the colour across the surface. That part
/// is equal on both sides and so does not change the pressure jump, but it pulls the sides apart with about
/// `sigma / H`, many times `sigma / R` (H is the support radius). This takes a wide support, a stiff fluid and a high
/// background pressure.
const CURVATURE: Setting = Setting {
    coefficient: SIGMA,
    kernel: (Kernel::WendlandC4, 80.0),
    speed_of_sound: 45.0,
    looser: 1.05,
    calming: (0.1, 0.4),
};

const NORMAL_CURVATURE: Setting = Setting {
    coefficient: SIGMA,
    kernel: (Kernel::WendlandC4, 50.0),
    speed_of_sound: 22.4,
    looser: 1.015,
    calming: (0.05, 0.3),
};

/// Attraction lowers the pressure of the fluid that it holds together by about 0.3 times its coefficient, in pascals at
/// 1 kg/m3. The background pressure must be larger than that. A lattice under that pressure also resists shear, as a
/// surface does; with these neighbours the resistance is small enough (`millpond check kernels` prints the table).
const ATTRACTION: Setting = Setting {
    coefficient: 60.0,
    kernel: (Kernel::WendlandC4, 55.0),
    speed_of_sound: 22.4,
    looser: 1.045,
    calming: (0.05, 1.0),
};

/// As for attraction, but the sum of gradients lowers the pressure by about half of its coefficient.
const GRADIENT_SUM: Setting = Setting { kernel: (Kernel::WendlandC4, 57.0), looser: 1.05, ..ATTRACTION };

/// What surrounds a drop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Around {
    /// A second fluid with the same properties.
    Like,
    /// Vacuum.
    Nothing,
}

impl Around {
    /// Returns its name for tables and figures.
    pub(super) fn name(self) -> &'static str {
        match self {
            Around::Like => "an identical fluid",
            Around::Nothing => "vacuum",
        }
    }
}

/// Set-up of a drop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Droplet {
    /// Model of surface tension.
    pub(super) tension: SurfaceTension,
    /// What surrounds the drop.
    pub(super) around: Around,
    /// Radius in spacings.
    pub(super) radius: u16,
    /// Particle spacing, m.
    pub(super) spacing: f32,
    /// Centre of the disc that is cut out of the lattice, relative to a corner of four lattice cells, in spacings.
    pub(super) offset: [f64; 2],
}

/// A drop at rest, apart from its spurious currents.
#[derive(Clone, Debug)]
pub(super) struct Calm {
    /// Particles of the drop and around it, without their velocities.
    pub(super) places: Vec<InitialParticle>,
    /// Centre of the drop, m.
    pub(super) centre: [f64; 2],
    /// Pressure inside less pressure outside, Pa.
    pub(super) jump: f64,
    /// Radius of a disc with the drop's volume, m.
    pub(super) radius: f64,
    /// Density of the packing at the start: mass over volume, kg/m3.
    pub(super) density: f64,
    /// Dynamic viscosity times the root mean square speed, and times the largest speed, N/m. Divided by the surface
    /// tension they are capillary numbers.
    pub(super) currents: [f64; 2],
}

impl Droplet {
    /// Returns the drop of cases S1 and S2 with a radius of `radius` spacings.
    pub(super) fn of_reference_case(tension: SurfaceTension, around: Around, radius: u16) -> Droplet {
        Droplet { tension, around, radius, spacing: SPACING * 20.0 / f32::from(radius), offset: [0.0; 2] }
    }

    fn setting(&self) -> &'static Setting {
        match self.tension {
            SurfaceTension::Curvature => &CURVATURE,
            SurfaceTension::NormalCurvature => &NORMAL_CURVATURE,
            SurfaceTension::Attraction => &ATTRACTION,
            SurfaceTension::GradientSum | SurfaceTension::Off => &GRADIENT_SUM,
        }
    }

    /// Returns its name for tables and figures.
    pub(super) fn title(&self) -> String {
        format!("{} in {}, R/dx = {}", self.tension.name(), self.around.name(), self.radius)
    }

    /// Returns its coefficient of surface tension.
    pub(super) fn coefficient(&self) -> f64 {
        f64::from(self.setting().coefficient)
    }

    /// Returns half of the side of the square around it, m.
    fn half_side(&self) -> f32 {
        f32::from(SIDE * self.radius) * self.spacing / 2.0
    }

    /// Returns the scene with a kinematic viscosity, m2/s. Negative pressure is allowed in vacuum too. There it adds a
    /// tension at the surface, but without it particles would detach.
    pub(super) fn scene(&self, viscosity: f32) -> Scene {
        let setting = self.setting();
        let like = self.around == Around::Like;
        let drop = Fluid {
            rest_density: REST_DENSITY,
            speed_of_sound: setting.speed_of_sound,
            dynamic_viscosity: viscosity * REST_DENSITY,
            surface_tension: setting.coefficient,
            ..Fluid::default()
        };
        let half = self.half_side();
        let block = Block {
            corner: Vec3::new(-half, -half, 0.0),
            size: Vec3::new(2.0 * half, 2.0 * half, 0.0),
            ..Block::default()
        };
        let spacing = if like { self.spacing * setting.looser } else { self.spacing };
        let mut scene = Scene::of(Dimension::Two, spacing, 1.0, drop, block);
        if like {
            scene.fluids.extend([drop]);
            scene.periodic = Some(Periodic {
                low: Vec3::new(-half, -half, 0.0),
                high: Vec3::new(half, half, 0.0),
                axes: [true, true, false],
            });
        }
        let (kernel, neighbours) = setting.kernel;
        scene.average_neighbours = Some(neighbours);
        scene.time_step = time_step(&scene, f64::from(viscosity)) as f32;
        scene.model = Formulation {
            density_kernel: kernel,
            pressure_kernel: kernel,
            viscosity_kernel: kernel,
            normalize_mass: true,
            surface_tension: self.tension,
            ..SEVERAL_FLUIDS
        };
        scene.grid = grid(Dimension::Two, 32);
        scene
    }

    /// Returns a lattice. Points inside of the disc belong to the drop. The others belong to the fluid around it, or
    /// are left out in vacuum.
    fn places(&self) -> Vec<InitialParticle> {
        let count = SIDE * self.radius;
        let along = |i: u16| (f64::from(i) + 0.5 - f64::from(count) / 2.0) * f64::from(self.spacing);
        let radius = f64::from(self.radius) * f64::from(self.spacing);
        let middle = self.offset.map(|offset| offset * f64::from(self.spacing));
        let mut all = Vec::new();
        for j in 0..count {
            for i in 0..count {
                let (x, y) = (along(i), along(j));
                let outside = (x - middle[0]).hypot(y - middle[1]) >= radius;
                if !outside || self.around == Around::Like {
                    all.push(InitialParticle::of_fluid(u32::from(outside), [x as f32, y as f32, 0.0], [0.0; 3]));
                }
            }
        }
        all
    }

    /// Runs the drop until it is calm, and averages its pressures in the later part of the run.
    ///
    /// # Errors
    /// The scene cannot start, or a step fails.
    pub(super) fn calm(&self, context: &Context, study: &str) -> Result<Calm, Failure> {
        let (viscosity, end) = self.setting().calming;
        let radius = f64::from(self.radius) * f64::from(self.spacing);
        let end = if context.quick { end * (radius / CALMED_RADIUS).powi(2) } else { end };
        let scene = self.scene(viscosity);
        let places = self.places();
        let scene = checked(study, &scene)?;
        let mut heap = heap_for(&scene, places.len());
        let mut solver = start_with(study, &scene, places, &mut heap)?;
        let mut sums = Sums::default();
        let title = format!("{study} {}", self.title());
        step(&title, context, &mut solver, steps_to(&scene, end), STEPS_PER_SAMPLE, |solver| {
            if solver.time() > end * CALM {
                sums.add(self, solver);
            }
        })?;
        let mass = scene.derived().particle_mass;
        let samples = sums.samples;
        let volume = sums.particles / samples * mass / (sums.density / samples);
        let viscosity = f64::from(viscosity * REST_DENSITY);
        Ok(Calm {
            places: solver
                .particles()
                .map(|p| InitialParticle::of_fluid(p.fluid, p.position.to_array(), [0.0; 3]))
                .collect(),
            centre: centre(&of_drop(&solver)),
            jump: sums.jump / samples,
            radius: (volume / PI).sqrt(),
            density: mass / f64::from(self.spacing).powi(2),
            currents: [viscosity * sums.rms / samples, viscosity * sums.fastest / samples],
        })
    }
}

/// Returns the longest time step that sound, viscosity and surface tension allow, s.
fn time_step(scene: &Scene, viscosity: f64) -> f64 {
    let support = support_radius(scene);
    let h = support / 2.0;
    let sound = COURANT * support / f64::from(scene.fluids[0].speed_of_sound);
    let diffusion = DIFFUSION * h * h / viscosity;
    // models whose coefficient is not a surface tension cause less tension than this
    let capillary = CAPILLARY * (f64::from(REST_DENSITY) * h.powi(3) / (2.0 * PI * f64::from(SIGMA))).sqrt();
    sound.min(diffusion).min(capillary)
}

/// Returns the particles of the drop, which is the first fluid.
pub(super) fn of_drop(solver: &Solver<'_>) -> Vec<Particle> {
    solver.particles().filter(|particle| particle.fluid == 0).collect()
}

/// Returns the mean position of particles, m. A drop stays in the middle of its square, so no particle of it crosses a
/// side.
pub(super) fn centre(particles: &[Particle]) -> [f64; 2] {
    [0, 1].map(|axis| mean(particles, |particle| f64::from(particle.position[axis])))
}

/// Sums over samples.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    jump: f64,
    density: f64,
    particles: f64,
    rms: f64,
    fastest: f64,
    samples: f64,
}

impl Sums {
    /// Adds the current state.
    fn add(&mut self, drop: &Droplet, solver: &Solver<'_>) {
        let all = fluid(solver);
        let own = of_drop(solver);
        let [x, y] = centre(&own);
        let radius = f64::from(drop.radius) * f64::from(drop.spacing);
        let distance = |p: &Particle| (f64::from(p.position.x) - x).hypot(f64::from(p.position.y) - y) / radius;
        let pressure = |of: &[Particle]| mean(of, |particle| f64::from(particle.pressure));
        self.particles += own.len() as f64;
        let inner: Vec<Particle> = own.into_iter().filter(|particle| distance(particle) < INSIDE).collect();
        self.density += mean(&inner, |particle| f64::from(particle.density));
        let ambient = match drop.around {
            Around::Like => {
                let outer = all.iter().filter(|particle| particle.fluid != 0 && distance(particle) > OUTSIDE);
                pressure(&outer.copied().collect::<Vec<_>>())
            }
            Around::Nothing => 0.0,
        };
        self.jump += pressure(&inner) - ambient;
        let speed = |particle: &Particle| f64::from(particle.velocity.length());
        self.rms += mean(&all, |particle| speed(particle).powi(2)).sqrt();
        self.fastest += all.iter().map(speed).fold(0.0, larger);
        self.samples += 1.0;
    }
}
