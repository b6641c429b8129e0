//! The force of the fluid on walls in closed form, for the caller. Nothing here is part of a step.
use crate::arithmetic::real::vec3;
use crate::layout::{PLANES, Parameters};
use crate::neighbours::Neighbours;
use crate::passes::beyond::{self, Front};
use crate::passes::field;
use crate::scene::Face;
use crate::solids::solids;
use crate::terms::beyond::{completed3, wall_push, wall_rub};
use crate::terms::external::weight;
use crate::terms::neighbour::{acceleration_close, force_neighbour, pressure_neighbour};
use crate::terms::pair::{Local, density_ratio, separation};
use crate::terms::viscosity::has_friction;
use crate::wall_force::SolidForce;
use glam::{DVec3, Vec3};

impl Neighbours<'_, '_> {
    /// Force of the fluid on a face of the container, N (per metre of depth in 2D), with walls in closed form: the
    /// reaction to the accelerations by pressure and friction that the face causes, at the present positions (tensile
    /// control left out). A face without a plane, and a penalty plane, feel no force.
    #[must_use]
    pub fn force_on_face(&self, face: Face) -> Vec3 {
        let plane = plane_of(self.solver.parameters(), face);
        plane.map_or(Vec3::ZERO, |plane| self.on_closed_wall(plane, Vec3::ZERO).force)
    }

    /// Force and torque of the fluid on a solid: the reaction to the accelerations by pressure and friction that it
    /// causes, at the present positions (tensile control left out). `None` if there is no solid with this index. With
    /// [`SolidModel::Penalty`](crate::scene::SolidModel::Penalty) and
    /// [`SolidModel::Repulsion`](crate::scene::SolidModel::Repulsion) it is 0.
    #[must_use]
    pub fn force_on_solid(&self, solid: usize) -> Option<SolidForce> {
        let origin = self.solver.solid(solid)?.position;
        let state = self.solver.state();
        let all = solids(&self.solver.plan().model, self.solver.parameters(), state.pose);
        let is_closed = all.into_iter().nth(solid)?.is_closed();
        // a solid that is neither in closed form nor of particles has no particles to sum over
        Some(if is_closed { self.on_closed_wall(PLANES + solid, origin) } else { self.on_particles_of(solid, origin) })
    }

    /// Force and torque of the fluid on a wall in closed form.
    fn on_closed_wall(&self, wall: usize, origin: Vec3) -> SolidForce {
        let solver = self.solver;
        self.with_terms(|setup, particles| {
            let (m, p, u, t) = (setup.model, setup.parameters, setup.uniform, setup.tables);
            let mut sum = [DVec3::ZERO; 2];
            for slot in 0..solver.state().id.len() {
                let a: Local<f32> = particles.receivers(setup, slot, slot);
                if a.wall > 0.0 {
                    continue;
                }
                let Some(own) = beyond::of_wall(setup, Front::of(a), wall) else { continue };
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
                let push = |beyond| {
                    let push = wall_push(m, p, a, a.pressure, beyond, g);
                    if has_friction(m) { push + wall_rub(m, p, a, beyond) } else { push }
                };
                // what the walls add to the acceleration by the neighbours is their push, and of the whole the part
                // beyond them
                let whole = completed3(push(beyond) + pairs, beyond.gamma);
                let force = push(own.beyond) + whole * (beyond.gamma * own.share);
                let mass = a.mass * a.rest_ratio * p.particle_mass;
                let wide = |v: vec3<f32>| DVec3::new(v.x.into(), v.y.into(), v.z.into());
                let force = wide(force) * -f64::from(mass);
                let away = separation(m, p, a.position, vec3(origin.x, origin.y, origin.z));
                sum = [sum[0] + force, sum[1] + wide(away + own.foot).cross(force)];
            }
            SolidForce::of(sum)
        })
    }
}

/// Returns the number of the plane of a face, if it is a wall in closed form.
fn plane_of(p: &Parameters, face: Face) -> Option<usize> {
    let along = if face.is_high() { -1.0 } else { 1.0 };
    p.planes[..p.closed_planes as usize].iter().position(|plane| plane[face.axis()] == along)
}
