//! Reports on a fluid as a whole. Nothing here is part of a step.
use crate::arithmetic::real::vec3;
use crate::hash::tree_sum;
use crate::layout::f32x4;
use crate::memory::Arrays;
use crate::passes::lanes::material_of;
use crate::passes::lists::{ListReport, Lists};
use crate::solver::Solver;
use crate::terms::time_step::{bounded_sound, bounded_square};

/// Compression of the fluid beyond its rest density, relative to the rest density.
///
/// Only compression counts. At a free surface half of the neighbours are missing, so the summed density is low there in
/// any case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DensityError {
    /// Mean of `max(rho / rho0 - 1, 0)`.
    pub mean: f64,
    /// Largest value.
    pub max: f64,
}

/// Energies of the fluid, J (per metre of depth in 2D). Wall particles and inactive ones do not count.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Internal energy; 0 in scenes that do not track it.
    pub internal: f64,
    /// Potential energy in the field of gravity, relative to the origin; the buoyancy of the ambient medium is computed
    /// with rest densities.
    pub potential: f64,
    /// Energy of the springs.
    pub elastic: f64,
}

/// Courant numbers of a step, with the support radius H: the quantities limited by
/// [`AdaptiveTimeStep`](crate::scene::AdaptiveTimeStep).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Courant {
    /// `v dt / H`, with v the largest speed (Pirovano, eq. 2.41; Hinsch 2024, section 6.6.2).
    pub speed: f64,
    /// `dt sqrt(a / H)`, with a the largest acceleration.
    pub acceleration: f64,
    /// `c dt / H`, with c the largest speed of sound; 0 with pressure correction.
    pub sound: f64,
    /// `nu dt / H^2`, with nu the largest kinematic viscosity.
    pub viscosity: f64,
}

/// State of the air layer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AirReport {
    /// Number of active air particles.
    pub active: u32,
    /// Spawn requests in all steps for which `air.capacity` left no particle. An exposed particle repeats its request
    /// in each step.
    pub refused: u64,
}

impl Solver<'_> {
    /// State of the air layer; all zero in scenes without air.
    #[must_use]
    pub fn air(&self) -> AirReport {
        if self.plan().model.has_air == 0 {
            return AirReport::default();
        }
        AirReport { active: self.active_air(), refused: self.census.refused }
    }

    /// Courant numbers of a step of `time_step` seconds that led to this state.
    #[must_use]
    pub fn courant(&self, time_step: f32) -> Courant {
        let (state, p, m) = (self.state(), self.parameters(), &self.plan().model);
        let largest =
            |of: &dyn Fn(usize) -> f32| (0..state.id.len()).map(|slot| f64::from(of(slot))).fold(0.0, f64::max);
        let speed2 = largest(&|slot| bounded_square(vec3::<f32>::splat(state.velocity[slot])));
        let acceleration2 = largest(&|slot| bounded_square(vec3::<f32>::splat(state.acceleration[slot])));
        let sound = largest(&|slot| {
            let [.., sound, equation] = self.materials().states[material_of(state.velocity[slot][3])];
            bounded_sound::<f32>(m, state.density_pressure[slot][0], sound, equation)
        });
        let (dt, support) = (f64::from(time_step), f64::from(p.support));
        Courant {
            speed: libm::sqrt(speed2) * dt / support,
            acceleration: dt * libm::sqrt(libm::sqrt(acceleration2) / support),
            sound: if m.corrects_pressure() { 0.0 } else { sound * dt / support },
            viscosity: f64::from(self.constants.kinematic_viscosity) * dt / (support * support),
        }
    }

    /// Mean and largest compression of the fluid.
    #[must_use]
    pub fn density_error(&self) -> DensityError {
        let (slots, state) = (self.slots(), &self.state());
        let fluid = (0..slots.len()).filter(|&id| !self.is_wall(slots[id] as usize)).count();
        let error = |id: usize| {
            let slot = slots[id] as usize;
            if self.is_wall(slot) { 0.0 } else { f64::from(state.density_pressure[slot][0]).max(0.0) }
        };
        DensityError {
            mean: tree_sum(slots.len(), &error) / fluid.max(1) as f64,
            max: (0..slots.len()).map(error).fold(0.0, f64::max),
        }
    }

    /// Energies of the fluid, summed in order of ids.
    #[must_use]
    pub fn energies(&self) -> Energies {
        let (slots, state, p) = (self.slots(), self.state(), self.parameters());
        let dot = |a: f32x4, b: f32x4| (0..3).map(|i| f64::from(a[i]) * f64::from(b[i])).sum::<f64>();
        let lift = |slot: usize| 1.0 - f64::from(p.ambient_ratio) / f64::from(self.properties_of(slot)[2]);
        let sum = |energy: &dyn Fn(usize) -> f64| {
            let of = |id: usize| {
                let slot = slots[id] as usize;
                let [_, _, rest, _] = self.properties_of(slot);
                let mass = f64::from(state.position[slot][3]) * f64::from(p.particle_mass) * f64::from(rest);
                if self.is_wall(slot) { 0.0 } else { mass * energy(slot) }
            };
            tree_sum(slots.len(), &of)
        };
        Energies {
            kinetic: sum(&|slot| 0.5 * dot(state.velocity[slot], state.velocity[slot])),
            internal: sum(&|slot| state.internal_energy.get(slot).map_or(0.0, |heat| f64::from(heat[0]))),
            potential: sum(&|slot| -lift(slot) * dot(self.constants.step.gravity, state.position[slot])),
            elastic: self.elastic_energy(),
        }
    }

    /// How full the neighbour lists of the last step are. `None` with the half stencil, after a failed step, and after
    /// [`Solver::neighbours`], which overwrites the memory of the lists.
    #[must_use]
    pub fn lists(&self) -> Option<ListReport> {
        let Arrays { scratch, list_words, .. } = &self.memory;
        let particles = self.slots().len();
        self.has_lists.then(|| Lists::new(&scratch.neighbours[..*list_words], particles).report(particles))
    }
}
