//! A round drop in the plane, calmed by viscosity: what `laplace-drop` and `oscillating-drop` look at.
//!
//! What is around it is a like fluid, another one by number only, in a periodic square; or nothing. A like fluid is packed
//! denser than at rest. Its pressure then is positive everywhere: where it were negative particles would clump, and at an
//! interface it is lowest.
use super::Context;
use super::flow::{checked, fluid, grid, heap_for, larger, mean, start_with, step, steps_to};
use super::recipes::SEVERAL_FLUIDS;
use crate::failure::Failure;
use glam::Vec3;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{
    Block, Dimension, Fluid, Formulation, InitialParticle, Kernel, Periodic, Scene, SurfaceTension,
};
use millpond_core::{Particle, Solver};
use std::f64::consts::PI;

/// Distance between particles at the start, m: the catalogue's drop of R = 0.2 m has a radius of 20.
pub(super) const SPACING: f32 = 0.01;

/// The catalogue's: kg/m3, and N/m for the models that have a tension of their own.
pub(super) const REST_DENSITY: f32 = 1.0;
pub(super) const SIGMA: f32 = 1.0;

/// Side of the periodic square over the radius of the drop.
pub(super) const SIDE: u16 = 4;

/// Share of the support that sound travels in a step; of the longest steps that viscosity (Morris et al. 1997) and tension
/// (Brackbill et al. 1992) allow, `h^2 / nu` and `sqrt(rho h^3 / (2 pi sigma))`, h being half of the support.
const COURANT: f64 = 0.2;
const DIFFUSION: f64 = 0.125;
const CAPILLARY: f64 = 0.25;

/// The inside of a drop is what is nearer to its centre than this share of its radius, the outside what is farther than that.
const INSIDE: f64 = 0.5;
const OUTSIDE: f64 = 1.5;

/// Radius of the drops that the times to calm down are for, m. Viscosity calms a smaller one sooner, as the square of its
/// radius, which a quick study makes use of.
const CALMED_RADIUS: f64 = 0.2;

/// Share of the time to calm down after which pressures are averaged.
const CALM: f64 = 0.5;
const STEPS_PER_SAMPLE: u64 = 10;

/// What each model of tension is tried with.
#[derive(Clone, Copy, Debug)]
struct Setting {
    /// `Fluid::surface_tension`, in the model's unit.
    coefficient: f32,
    /// Kernel of all terms, and particles inside its support.
    kernel: (Kernel, f32),
    /// m/s. `10 sqrt(sigma / (rho R))` keeps the compression by a tension of 1 N/m to 1 % at R = 0.2 m.
    speed_of_sound: f32,
    /// Spacing of the scene over that of the particles, with a fluid around: the pressure at large is
    /// `rho0 c0^2 (looser^14 - 1) / 7`.
    looser: f32,
    /// Kinematic viscosity that calms the drop, m2/s, and for how long, s.
    calming: (f32, f64),
}

/// The curvature of the colour has the second derivative across the surface in it as well. It acts alike on both sides and so
/// is no jump, but it pulls them apart by some `sigma / H`, many times `sigma / R`: it takes a wide support, a stiff fluid and
/// much pressure at large to bear that.
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

/// Attraction takes about 0.3 times its coefficient, in pascals at 1 kg/m3, from the pressure of what it holds together: the
/// pressure at large must be the larger one. And a lattice under that pressure bears shear, as a surface does: little enough
/// with these neighbours (`millpond check kernels` has the table).
const ATTRACTION: Setting = Setting {
    coefficient: 60.0,
    kernel: (Kernel::WendlandC4, 55.0),
    speed_of_sound: 22.4,
    looser: 1.045,
    calming: (0.05, 1.0),
};

/// The same, with about half of the coefficient.
const GRADIENT_SUM: Setting = Setting { kernel: (Kernel::WendlandC4, 57.0), looser: 1.05, ..ATTRACTION };

/// What is around a drop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Around {
    /// Another fluid with the same properties.
    Like,
    /// Nothing.
    Nothing,
}

impl Around {
    /// In words.
    pub(super) fn name(self) -> &'static str {
        match self {
            Around::Like => "a like fluid",
            Around::Nothing => "nothing",
        }
    }
}

/// A drop before anything happened to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Droplet {
    /// What holds it together.
    pub(super) tension: SurfaceTension,
    /// What it is in.
    pub(super) around: Around,
    /// Radius in spacings.
    pub(super) radius: u16,
    /// Distance between particles, m.
    pub(super) spacing: f32,
    /// Where the centre of the disc is that is cut out of the lattice, from a corner of four cells, spacings.
    pub(super) offset: [f64; 2],
}

/// A drop that has come to rest, but for its spurious currents.
#[derive(Clone, Debug)]
pub(super) struct Calm {
    /// Its particles, and those around it, without their velocities.
    pub(super) places: Vec<InitialParticle>,
    /// Where its centre is, m.
    pub(super) centre: [f64; 2],
    /// Pressure inside less pressure outside, Pa.
    pub(super) jump: f64,
    /// Radius of a disc of its volume, m.
    pub(super) radius: f64,
    /// Mass over volume, kg/m3.
    pub(super) density: f64,
    /// Viscosity, Pa s, times the root of the mean square speed, and times the largest one: N/m.
    pub(super) currents: [f64; 2],
}

impl Droplet {
    /// The catalogue's, as fine as so many spacings along its radius.
    pub(super) fn of_catalogue(tension: SurfaceTension, around: Around, radius: u16) -> Droplet {
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

    /// What it is called in tables and figures.
    pub(super) fn title(&self) -> String {
        format!("{} in {}, R/dx = {}", self.tension.name(), self.around.name(), self.radius)
    }

    /// Its coefficient of tension.
    pub(super) fn coefficient(&self) -> f64 {
        f64::from(self.setting().coefficient)
    }

    /// Half of the side of the square that holds it, m.
    fn half_side(&self) -> f32 {
        f32::from(SIDE * self.radius) * self.spacing / 2.0
    }

    /// The scene, with a kinematic viscosity in m2/s. There is suction in nothing too, which is a tension of its own at a
    /// surface: without it particles come off.
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
        scene.average_neighbours = neighbours;
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

    /// A lattice whose points inside of the disc are the drop's, and the others those of what is around it, if anything.
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

    /// Lets it calm down, and measures it meanwhile.
    ///
    /// # Errors
    /// A scene that cannot start, a step that could not be made.
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

/// The longest step that sound, viscosity and tension allow, s.
fn time_step(scene: &Scene, viscosity: f64) -> f64 {
    let support = support_radius(scene);
    let h = support / 2.0;
    let sound = COURANT * support / f64::from(scene.fluids[0].speed_of_sound);
    let diffusion = DIFFUSION * h * h / viscosity;
    // models without a tension of their own make less than this one
    let capillary = CAPILLARY * (f64::from(REST_DENSITY) * h.powi(3) / (2.0 * PI * f64::from(SIGMA))).sqrt();
    sound.min(diffusion).min(capillary)
}

/// Particles of the drop: it is the first fluid.
pub(super) fn of_drop(solver: &Solver<'_>) -> Vec<Particle> {
    solver.particles().filter(|particle| particle.fluid == 0).collect()
}

/// Mean position of particles, m. A drop stays in the middle of its square, so none of it is beyond a side.
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
    /// Adds the state now.
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
