//! The force of the fluid on walls of particles, for the caller. Nothing here is part of a step.
use crate::arithmetic::real::vec3;
use crate::derive::material::{FIRST_SOLID, FIRST_WALL};
use crate::neighbours::Neighbours;
use crate::passes::lanes::material_of;
use crate::scene::WALLS;
use crate::terms::extrapolation::{extrapolates_velocity, wall_velocity, wall_weight};
use crate::terms::neighbour::{force_neighbour, pressure_neighbour};
use crate::terms::pair::{Local, inverse_density, separation};
use glam::{DVec3, Vec3};

/// Force and torque of the fluid on a solid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolidForce {
    /// Force, N (per metre of depth in 2D).
    pub force: Vec3,
    /// Torque about the origin of the solid, N m (per metre of depth in 2D).
    pub torque: Vec3,
}

impl SolidForce {
    pub(crate) fn of([force, torque]: [DVec3; 2]) -> SolidForce {
        SolidForce { force: force.as_vec3(), torque: torque.as_vec3() }
    }
}

impl Neighbours<'_, '_> {
    /// Force of the fluid on a wall of the scene, N (per metre of depth in 2D): the reaction to the forces of pressure,
    /// viscosity and tension that the particles of the wall exert, at the present positions (tensile control left out).
    /// `wall` is its index in [`Scene::walls`](crate::scene::Scene::walls); a wall that does not exist feels no force.
    #[must_use]
    pub fn force_on_wall(&self, wall: usize) -> Vec3 {
        if wall >= WALLS { Vec3::ZERO } else { self.on_particles(FIRST_WALL as usize + wall, Vec3::ZERO).force }
    }

    /// Force and torque of the fluid on the particles of a solid.
    pub(crate) fn on_particles_of(&self, solid: usize, origin: Vec3) -> SolidForce {
        self.on_particles(FIRST_SOLID as usize + solid, origin)
    }

    /// Force and torque of the fluid on wall particles of this material.
    fn on_particles(&self, material: usize, origin: Vec3) -> SolidForce {
        let state = self.solver.state();
        self.with_terms(|setup, particles| {
            let (m, p, t) = (setup.model, setup.parameters, setup.tables);
            let local = |slot: usize| -> Local<f32> { particles.receivers(setup, slot, slot) };
            let mut sum = [DVec3::ZERO; 2];
            for slot in 0..state.id.len() {
                if material_of(state.velocity[slot][3]) != material {
                    continue;
                }
                let mut b = local(slot);
                let away = separation(m, setup.parameters, b.position, vec3(origin.x, origin.y, origin.z));
                let arm = DVec3::new(away.x.into(), away.y.into(), away.z.into());
                let fluid = || self.around(slot).map(local).filter(|a| a.wall == 0.0);
                if extrapolates_velocity(m) {
                    let (mut velocities, mut weights) = (vec3(0.0, 0.0, 0.0), 0.0);
                    for a in fluid() {
                        let w = wall_weight(m, p, t, b, a);
                        velocities = velocities + a.velocity * w;
                        weights += w;
                    }
                    b.velocity = wall_velocity(b.velocity, velocities, weights);
                }
                for a in fluid() {
                    let mut force = force_neighbour(m, p, t, a, b);
                    if m.corrects_pressure() {
                        force = force + pressure_neighbour(m, p, t, a, b);
                    }
                    let volume = a.mass * a.rest_ratio * p.particle_mass * inverse_density(m, p, a);
                    let force = DVec3::new(force.x.into(), force.y.into(), force.z.into()) * -f64::from(volume);
                    sum = [sum[0] + force, sum[1] + arm.cross(force)];
                }
            }
            SolidForce::of(sum)
        })
    }
}
