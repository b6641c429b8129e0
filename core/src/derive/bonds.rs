//! Springs of elastic fluids: which particles they join. They are made once, at the start (Pirovano, section 2.2.6).
use super::derived::Derived;
use crate::arithmetic::real::{root, vec3};
use crate::error::SceneError;
use crate::layout::{Model, Parameters, f32x4, u32x2, u32x4};
use crate::scene::Scene;
use crate::terms::geometry::length2;
use crate::terms::pair::separation;

/// Factor on the reach given by the scene, so that rounding does not separate lattice neighbours at the same distance.
const REACH_MARGIN: f64 = 1.0 + 1e-5;

/// Decides which particles are joined by springs, and how strongly a spring pulls at its ends.
pub(crate) struct Bonds<'a> {
    derived: &'a Derived,
    model: Model,
    /// Largest distance of two joined particles, m.
    reach: f64,
}

/// A particle that may be joined: its position, and the constants of its material (`Materials::properties`).
pub(crate) type End = (f32x4, f32x4);

impl Bonds<'_> {
    pub(crate) fn of<'a>(scene: &Scene, derived: &'a Derived, model: Model) -> Bonds<'a> {
        let reach = f64::from(scene.elasticity.reach) * f64::from(scene.particle_spacing) * REACH_MARGIN;
        Bonds { derived, model, reach }
    }

    /// Acceleration per metre of elongation that a spring causes at this particle, `k / (2 m)`, 1/s2.
    pub(crate) fn pull(&self, (position, material): End) -> f32 {
        (self.at_rest(material) / f64::from(position[3])) as f32
    }

    /// The same for a particle of the fluid at rest mass; 0 for wall particles and inactive air particles.
    fn at_rest(&self, [_, wall, _, fluid]: f32x4) -> f64 {
        if wall > 0.0 { 0.0 } else { self.derived.fluid(fluid as u32).spring_pull }
    }

    /// Rest length of a spring between two particles, m; `None` if they are not to be joined.
    pub(crate) fn length(&self, p: &Parameters, (x_a, a): End, (x_b, b): End) -> Option<f32> {
        let one_fluid = a[3] == b[3] && a[1] == 0.0 && b[1] == 0.0;
        let is_elastic = self.at_rest(a) as f32 > 0.0;
        if !one_fluid || !is_elastic {
            return None;
        }
        let x_ab = separation(&self.model, p, vec3::<f32>::splat(x_a), vec3::splat(x_b));
        let r = root(length2(x_ab));
        (f64::from(r) <= self.reach).then_some(r)
    }
}

/// Calls the given function with the ids of two particles that are to be joined and their distance, for each such pair
/// and in both directions.
type EachBond<'a> = &'a mut dyn FnMut(&mut dyn FnMut(u32, u32, f32));

/// Writes the ends of all springs, and for each particle the index of its first end and the number of its ends. The
/// ends of a particle are sorted by the ids at the other ends, so that sums do not depend on the grid.
///
/// # Errors
/// [`SceneError::CapacityExceeded`] if there are more springs than there is room for.
pub(crate) fn join(of: &mut [u32x4], ends: &mut [u32x2], each_bond: EachBond<'_>) -> Result<(), SceneError> {
    // first the number of ends of each particle, then their first index, then the ends themselves
    each_bond(&mut |a, _, _| of[a as usize][1] += 1);
    let mut needed = 0usize;
    for [first, count, ..] in of.iter_mut() {
        *first = needed as u32;
        needed += *count as usize;
        *count = 0;
    }
    if needed > ends.len() || needed > u32::MAX as usize {
        let (needed, capacity) = (needed / 2, ends.len() / 2);
        return Err(SceneError::CapacityExceeded { what: "springs (elasticity.capacity)", needed, capacity });
    }
    each_bond(&mut |a, b, length| {
        let [first, count, ..] = &mut of[a as usize];
        ends[(*first + *count) as usize] = [b, length.to_bits()];
        *count += 1;
    });
    for &[first, count, ..] in of.iter() {
        ends[first as usize..(first + count) as usize].sort_unstable_by_key(|&[other, _]| other);
    }
    Ok(())
}
