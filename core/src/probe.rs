//! Probes: pressure, velocity and density of the fluid at a point, and the level of its surface, for the caller.
//! Nothing here is part of a step.
use crate::arithmetic::real::vec3;
use crate::neighbours::Neighbours;
use crate::passes::field;
use crate::terms::extrapolation::{wall_pressure_neighbour, wall_weight};
use crate::terms::pair::{Local, local_density};
use glam::Vec3;

/// Smallest sum of weights from which a mean is taken. Below, the fluid only touches the edge of the support.
const LEAST_WEIGHT: f32 = 1e-12;

/// Share of the support that the fluid fills on its surface.
const SURFACE: f32 = 0.5;

/// Number of steps per support radius in which the surface is looked for.
const STEPS_PER_SUPPORT: f32 = 16.0;

/// The fluid at a point, as [`Neighbours::sample`] finds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Pressure, Pa.
    pub pressure: f32,
    /// Velocity, m/s.
    pub velocity: Vec3,
    /// Density, kg/m3.
    pub density: f32,
    /// Share of the kernel's support that the fluid fills: about 1 inside the fluid, and 1/2 on its surface and on
    /// walls.
    pub share: f32,
}

impl Neighbours<'_, '_> {
    /// Pressure, velocity and density of the fluid at a point; `None` where no fluid is within the support radius.
    ///
    /// They are means over the fluid particles around the point, weighted by the density kernel (Shepard 1968). Each
    /// pressure is first continued to the point with the weight of the fluid, as walls that are extrapolated do (Adami,
    /// Hu and Adams 2012), so that the pressure is also right at a wall, where all fluid is on one side. This is one
    /// definition for every kind of wall.
    #[must_use]
    pub fn sample(&self, point: Vec3) -> Option<Sample> {
        self.with_terms(|setup, particles| {
            let (m, p, u, t) = (setup.model, setup.parameters, setup.uniform, setup.tables);
            let at = at(point);
            let zero = vec3(0.0, 0.0, 0.0);
            let there = if m.has_acceleration_field == 1 { field::at(setup, at.position) } else { zero };
            let (mut weights, mut pressure, mut density, mut velocity) = (0.0, 0.0, 0.0, Vec3::ZERO);
            let mut share = 0.0;
            for slot in self.near(point.extend(0.0).to_array(), 1.0) {
                let b: Local<f32> = particles.receivers(setup, slot, slot);
                let w = wall_weight(m, p, t, at, b);
                weights += w;
                pressure += wall_pressure_neighbour(m, p, u, at, b, there, w);
                density += local_density(m, p, b) * w;
                share += b.mass * w * p.density_constant / (1.0 + b.deviation);
                velocity += Vec3::new(b.velocity.x, b.velocity.y, b.velocity.z) * w;
            }
            (weights > LEAST_WEIGHT).then(|| Sample {
                pressure: pressure / weights,
                velocity: velocity / weights,
                density: density / weights,
                share,
            })
        })
    }

    /// Height of the fluid's surface above a point along `up`, m: the greatest height at which the fluid fills half of
    /// the kernel's support. `None` where there is no fluid above the point, or if `up` is 0. Single drops in the air
    /// do not count. Less than a support radius away from a wall that is parallel to `up` the height is too low, since
    /// a part of the support lies behind the wall.
    #[must_use]
    pub fn level(&self, point: Vec3, up: Vec3) -> Option<f32> {
        let up = up.try_normalize()?;
        let support = self.solver.parameters().support;
        let step = support / STEPS_PER_SUPPORT;
        let share = |height: f32| self.sample(point + up * height).map_or(0.0, |there| there.share);
        let mut height = self.highest_below(point, up, f32::INFINITY)? + support;
        let mut above = 0.0;
        while height > 0.0 {
            let here = share(height);
            if here >= SURFACE {
                // linear between the two heights
                return Some(height + step * (here - SURFACE) / (here - above));
            }
            above = here;
            // nothing is here: down to where the next particle may be felt
            let next = if here == 0.0 { self.highest_below(point, up, height)? + support } else { height };
            let lower = (height - step).min(next);
            // so far out f32 has no such steps
            height = if lower < height { lower } else { return None };
        }
        None
    }

    /// Returns the greatest height of a fluid particle below a height, among those less than a support radius beside
    /// the line through a point.
    fn highest_below(&self, point: Vec3, up: Vec3, most: f32) -> Option<f32> {
        let support = self.solver.parameters().support;
        let heights = self.solver.fluid_positions().filter_map(|position| {
            let height = (position - point).dot(up);
            let beside = (position - point - up * height).length();
            (beside < support && height > 0.0 && height < most).then_some(height)
        });
        heights.reduce(f32::max)
    }
}

/// Returns a point in the form of a wall particle, for the terms of extrapolated walls.
fn at(point: Vec3) -> Local<f32> {
    Local {
        position: vec3(point.x, point.y, point.z),
        velocity: vec3(0.0, 0.0, 0.0),
        support: 1.0,
        mass: 1.0,
        deviation: 0.0,
        pressure: 0.0,
        near_pressure: 0.0,
        volume: 0.0,
        viscosity: 0.0,
        wall: 1.0,
        rest_ratio: 1.0,
        fluid: 0.0,
        speed_of_sound: 0.0,
        state_equation: 0.0,
        tension: 0.0,
    }
}
