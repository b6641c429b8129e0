//! The force of the fluid on walls, for the caller. Nothing here is part of a step.
use crate::arithmetic::real::vec3;
use crate::derive::material::FIRST_WALL;
use crate::layout::{PLANES, Parameters};
use crate::neighbours::Neighbours;
use crate::passes::beyond::{self, Front};
use crate::passes::field;
use crate::passes::lanes::material_of;
use crate::scene::{Face, WALLS};
use crate::terms::beyond::{completed3, wall_push, wall_rub};
use crate::terms::external::weight;
use crate::terms::extrapolation::{extrapolates_velocity, wall_velocity, wall_weight};
use crate::terms::geometry::dot3;
use crate::terms::neighbour::{acceleration_close, force_neighbour, pressure_neighbour};
use crate::terms::pair::{Local, density_ratio, inverse_density};
use crate::terms::viscosity::has_friction;
use glam::Vec3;

impl Neighbours<'_, '_> {
    /// Force of the fluid on a face of the container, N (per metre of depth in 2D), with walls in closed form: the
    /// reaction to the accelerations by pressure and friction that the face causes, at the present positions (tensile
    /// control left out). A face without a plane, and a penalty plane, feel no force.
    #[must_use]
    pub fn force_on_face(&self, face: Face) -> Vec3 {
        let solver = self.solver;
        let Some(plane) = plane_of(solver.parameters(), face) else { return Vec3::ZERO };
        self.with_terms(|setup, particles| {
            let (m, p, u, t) = (setup.model, setup.parameters, setup.uniform, setup.tables);
            let mut sum = [0.0f64; 3];
            for slot in 0..solver.state().id.len() {
                let a: Local<f32> = particles.receivers(setup, slot, slot);
                if a.wall > 0.0 {
                    continue;
                }
                let each = beyond::beyond_each(setup, Front::of(a));
                if each[plane] == 0.0 {
                    continue;
                }
                let beyond = beyond::of_pressure::<f32>(setup, Front::of(a));
                let mut g = weight(m, p, u, density_ratio(m, a.deviation, a.rest_ratio));
                if m.has_acceleration_field == 1 {
                    g = g + field::at(setup, a.position);
                }
                let mut pairs = vec3(0.0, 0.0, 0.0);
                for b in self.around(slot).filter(|&b| b != slot).map(|slot| particles.receivers(setup, slot, slot)) {
                    pairs = pairs + force_neighbour(m, p, t, a, b);
                    if m.corrects_pressure() {
                        pairs = pairs + pressure_neighbour(m, p, t, a, b);
                    }
                }
                let pairs = acceleration_close(m, p, pairs, a);
                let mut walls = wall_push(m, p, a, a.pressure, beyond, g);
                if has_friction(m) {
                    walls = walls + wall_rub(m, p, a, beyond);
                }
                let all = completed3(walls + pairs * beyond.gamma, beyond.gamma);
                let force = of_plane(p, &each, plane, all);
                let mass = a.mass * a.rest_ratio * p.particle_mass;
                for (sum, force) in sum.iter_mut().zip([force.x, force.y, force.z]) {
                    *sum -= f64::from(force) * f64::from(mass);
                }
            }
            Vec3::from_array(sum.map(|sum| sum as f32))
        })
    }

    /// Force of the fluid on a wall of the scene, N (per metre of depth in 2D): the reaction to the forces of pressure,
    /// viscosity and tension that the particles of the wall exert, at the present positions (tensile control left out).
    /// `wall` is its index in [`Scene::walls`](crate::scene::Scene::walls); a wall that does not exist feels no force.
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

/// Returns what of an acceleration by all walls is due to one plane: the part along its normal, and of the part along
/// all planes within the support radius as much as of what lies beyond them lies beyond it.
fn of_plane(p: &Parameters, each: &[f32; PLANES], plane: usize, all: vec3<f32>) -> vec3<f32> {
    let mut along = all;
    for (normal, _) in p.planes.iter().zip(each).filter(|(_, beyond)| **beyond > 0.0) {
        let normal = vec3::splat(*normal);
        along = along - normal * dot3(all, normal);
    }
    let normal = vec3::splat(p.planes[plane]);
    normal * dot3(all, normal) + along * (each[plane] / each.iter().sum::<f32>())
}

/// Returns the number of the plane of a face, if it is a wall in closed form.
fn plane_of(p: &Parameters, face: Face) -> Option<usize> {
    let along = if face.is_high() { -1.0 } else { 1.0 };
    p.planes[..p.closed_planes as usize].iter().position(|plane| plane[face.axis()] == along)
}
