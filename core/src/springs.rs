//! The springs of elastic fluids: made once, at the start (S0 section 2.2.6), and looked at from outside.
use crate::error::SceneError;
use crate::hash::tree_sum;
use crate::kinds::spring_pull;
use crate::layout::{Parameters, f32x4, u32x2, u32x4};
use crate::plan::Plan;
use crate::scene::Scene;
use crate::solver::Solver;
use crate::terms::pair::separation;
use crate::{arithmetic::real::vec3, terms::geometry::length2};

/// A spring that is not broken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Id of the particle at one end, the smaller one.
    pub a: u32,
    /// At the other.
    pub b: u32,
    /// Length at rest, m.
    pub rest_length: f32,
}

/// A little more than what a scene says, so that rounding does not tell one lattice neighbour from the next.
const REACH_MARGIN: f64 = 1.0 + 1e-5;

/// Joins the particles of each elastic fluid that are within reach of each other. The ends of a particle stand in the order of
/// the ids at the other ends, so that no grid changes a sum.
pub(crate) fn join(solver: &mut Solver<'_>, scene: &Scene) -> Result<(), SceneError> {
    if solver.plan().model.springs == 0 {
        return Ok(());
    }
    let (m, p) = (solver.plan().model, *solver.parameters());
    let reach = f64::from(scene.elasticity.reach) * f64::from(scene.particle_spacing) * REACH_MARGIN;
    let pull = |[_, wall, _, fluid]: f32x4, share: f32| {
        let of_rest = if wall > 0.0 { 0.0 } else { spring_pull(scene, scene.fluid_of(fluid as u32)) };
        (of_rest / f64::from(share)) as f32
    };
    // how many ends each has, then where they begin, then who is there
    let distance = |solver: &Solver<'_>, a: usize, b: usize| -> Option<f32> {
        let (state, kinds) = (solver.state(), [a, b].map(|slot| solver.kind(slot)));
        let one_fluid = kinds[0][3] == kinds[1][3] && kinds[0][1] == 0.0 && kinds[1][1] == 0.0;
        let x_ab = separation(&m, &p, vec3::<f32>::splat(state.position[a]), vec3::splat(state.position[b]));
        let r = crate::arithmetic::real::root(length2(x_ab));
        (a != b && one_fluid && pull(kinds[0], 1.0) > 0.0 && f64::from(r) <= reach).then_some(r)
    };
    let of = core::mem::take(&mut solver.memory.given.spring_ranges);
    let [ends, other_ends] = solver.take_spring_ends();
    solver.visit_pairs(|solver, a, b| {
        if distance(solver, a, b).is_some() {
            of[solver.state().id[a] as usize][1] += 1;
        }
    });
    let mut needed = 0usize;
    for (id, of) in of.iter_mut().enumerate() {
        let slot = solver.slots()[id] as usize;
        of[0] = needed as u32;
        of[2] = pull(solver.kind(slot), solver.state().position[slot][3]).to_bits();
        needed += of[1] as usize;
        of[1] = 0;
    }
    if needed > ends.len() || needed > u32::MAX as usize {
        let (needed, capacity) = (needed / 2, ends.len() / 2);
        return Err(SceneError::CapacityExceeded { what: "springs (elasticity.capacity)", needed, capacity });
    }
    solver.visit_pairs(|solver, a, b| {
        if let Some(r) = distance(solver, a, b) {
            let [a, b] = [a, b].map(|slot| solver.state().id[slot]);
            let [first, count, ..] = &mut of[a as usize];
            ends[(*first + *count) as usize] = [b, r.to_bits()];
            *count += 1;
        }
    });
    for &[first, count, ..] in of.iter() {
        ends[first as usize..(first + count) as usize].sort_unstable_by_key(|&[other, _]| other);
    }
    other_ends.copy_from_slice(&ends[..other_ends.len()]);
    solver.memory.given.spring_ranges = of;
    solver.put_spring_ends([ends, other_ends]);
    Ok(())
}

impl Solver<'_> {
    /// The springs that hold, each once.
    pub fn springs(&self) -> impl Iterator<Item = Spring> {
        (0..).zip(self.memory.given.spring_ranges.iter()).flat_map(move |(a, &[first, count, ..])| {
            let ends = &self.spring_ends()[first as usize..(first + count) as usize];
            let spring = move |&[b, length]: &[u32; 2]| Spring { a, b, rest_length: f32::from_bits(length) };
            ends.iter().map(spring).filter(|spring| spring.a < spring.b && spring.rest_length >= 0.0)
        })
    }

    /// Energy of the springs, J (per metre of depth in 2D).
    pub(crate) fn elastic_energy(&self) -> f64 {
        let state = self.state();
        let slot = |id: u32| self.slots()[id as usize] as usize;
        let position = |id: u32| state.position[slot(id)];
        energy(self.plan(), self.parameters(), (self.memory.given.spring_ranges, self.spring_ends()), |id| {
            (position(id), self.kind(slot(id))[2])
        })
    }
}

/// Energy of springs, J (per metre of depth in 2D), where `particle` has the position of each particle by id, its mass in w, and the
/// rest density of its fluid over the first one's. A spring is as stiff as half of `k`: `k / 4 (r - L0)^2` (S0 eq. 2.26 per errata).
pub fn energy(
    plan: &Plan,
    p: &Parameters,
    (of, ends): (&[u32x4], &[u32x2]),
    particle: impl Fn(u32) -> (f32x4, f32),
) -> f64 {
    let spring = |a: u32, [first, count, pull, _]: u32x4| {
        let (x_a, rest) = particle(a);
        // what an end pulls with for each metre, as a force
        let mass = f64::from(p.particle_mass) * f64::from(rest) * f64::from(x_a[3]);
        let half_stiffness = f64::from(f32::from_bits(pull)) * mass;
        let own = ends.get(first as usize..(first + count) as usize).unwrap_or_default();
        let energy = |&[b, length]: &u32x2| {
            let rest_length = f32::from_bits(length);
            if a > b || rest_length < 0.0 {
                return 0.0;
            }
            let x_ab = separation(&plan.model, p, vec3::<f32>::splat(x_a), vec3::splat(particle(b).0));
            let strain = libm::sqrt(f64::from(length2(x_ab))) - f64::from(rest_length);
            0.5 * half_stiffness * strain * strain
        };
        own.iter().map(energy).sum::<f64>()
    };
    tree_sum(of.len(), &|a| spring(a as u32, of[a]))
}
