//! The springs of elastic fluids, made once, at the start (Pirovano, section 2.2.6): who is joined to whom.
use super::derived::Derived;
use crate::arithmetic::real::{root, vec3};
use crate::error::SceneError;
use crate::layout::{Model, Parameters, f32x4, u32x2, u32x4};
use crate::scene::Scene;
use crate::terms::geometry::length2;
use crate::terms::pair::separation;

/// A little more than what a scene says, so that rounding does not tell one lattice neighbour from the next.
const REACH_MARGIN: f64 = 1.0 + 1e-5;

/// Which particles springs join, and what an end of one pulls with.
pub(crate) struct Bonds<'a> {
    derived: &'a Derived,
    model: Model,
    /// Largest distance of two that are joined, m.
    reach: f64,
}

/// A particle that may be joined: its position, the constants of its material (`Materials::species`).
pub(crate) type End = (f32x4, f32x4);

impl Bonds<'_> {
    pub(crate) fn of<'a>(scene: &Scene, derived: &'a Derived, model: Model) -> Bonds<'a> {
        let reach = f64::from(scene.elasticity.reach) * f64::from(scene.particle_spacing) * REACH_MARGIN;
        Bonds { derived, model, reach }
    }

    /// What the ends of a particle pull with for each metre, over its mass, 1/s2.
    pub(crate) fn pull(&self, (position, material): End) -> f32 {
        (self.at_rest(material) / f64::from(position[3])) as f32
    }

    /// The same of a particle of its fluid at rest; 0 of a wall's, and of air that is not there.
    fn at_rest(&self, [_, wall, _, fluid]: f32x4) -> f64 {
        if wall > 0.0 { 0.0 } else { self.derived.fluid(fluid as u32).spring_pull }
    }

    /// Distance of two particles that are to be joined, m; `None` where they are not.
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

/// Calls what it is given with the ids of two particles that are to be joined, and their distance, in both directions.
type EachBond<'a> = &'a mut dyn FnMut(&mut dyn FnMut(u32, u32, f32));

/// Writes the ends of all springs, and where those of each particle begin and how many they are. The ends of a particle stand in
/// the order of the ids at the other ends, so that no grid changes a sum.
///
/// # Errors
/// More springs than there is room for.
pub(crate) fn join(of: &mut [u32x4], ends: &mut [u32x2], each_bond: EachBond<'_>) -> Result<(), SceneError> {
    // how many ends each has, then where they begin, then who is there
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
