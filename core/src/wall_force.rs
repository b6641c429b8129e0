//! The force of the fluid on walls of particles, for the caller. Nothing here is part of a step.
use crate::arithmetic::real::vec3;
use crate::derive::material::FIRST_WALL;
use crate::neighbours::Neighbours;
use crate::passes::lanes::material_of;
use crate::scene::WALLS;
use crate::terms::extrapolation::{extrapolates_velocity, wall_velocity, wall_weight};
use crate::terms::neighbour::{force_neighbour, pressure_neighbour};
use crate::terms::pair::{Local, inverse_density};
use glam::Vec3;

impl Neighbours<'_, '_> {
    /// Force of the fluid on a wall of the scene, N (per metre of depth in 2D): the reaction to the forces of pressure,
    /// viscosity and tension that the particles of the wall exert, at the present positions. `wall` is its index in
    /// [`Scene::walls`](crate::scene::Scene::walls); a wall that does not exist feels no force.
    #[must_use]
    pub fn force_on_wall(&self, wall: usize) -> Vec3 {
        if wall >= WALLS {
            return Vec3::ZERO;
        }
        let state = self.solver.state();
        self.with_terms(|setup, particles| {
            let (m, p, t) = (setup.model, setup.parameters, setup.tables);
            let local = |slot: usize| -> Local<f32> { particles.receivers(setup, slot, slot) };
            let mut sum = [0.0f64; 3];
            for slot in 0..state.id.len() {
                if material_of(state.velocity[slot][3]) != FIRST_WALL as usize + wall {
                    continue;
                }
                let mut b = local(slot);
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
                    for (sum, force) in sum.iter_mut().zip([force.x, force.y, force.z]) {
                        *sum -= f64::from(force) * f64::from(volume);
                    }
                }
            }
            Vec3::from_array(sum.map(|sum| sum as f32))
        })
    }
}
