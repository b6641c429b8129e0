//! The springs of a solver: made at its start, and read by the caller.
use crate::arithmetic::real::vec3;
use crate::derive::bonds::{Bonds, End, join};
use crate::error::SceneError;
use crate::hash::tree_sum;
use crate::layout::{Parameters, f32x4, u32x2, u32x4};
use crate::plan::Plan;
use crate::solver::Solver;
use crate::terms::geometry::length2;
use crate::terms::pair::separation;
use crate::validate::Checked;

/// A spring that is not broken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Id of the particle at one end, the smaller one.
    pub a: u32,
    /// Id of the particle at the other end.
    pub b: u32,
    /// Rest length, m.
    pub rest_length: f32,
}

impl Solver<'_> {
    /// Makes springs between those particles of each elastic fluid that are within reach of each other.
    pub(crate) fn join(&mut self, checked: &Checked<'_>) -> Result<(), SceneError> {
        if self.plan().model.has_springs == 0 {
            return Ok(());
        }
        let bonds = Bonds::of(checked, checked.derived(), self.plan().model);
        let of = core::mem::take(&mut self.memory.given.spring_ranges);
        let [ends, other_ends] = self.take_spring_ends();
        for (id, of) in of.iter_mut().enumerate() {
            of[2] = bonds.pull(self.end(self.slots()[id] as usize)).to_bits();
        }
        join(of, ends, &mut |found| {
            let neighbours = self.neighbours();
            let solver = neighbours.solver;
            let id = |slot: usize| solver.state().id[slot];
            neighbours.each_pair_of_slots(|a, b| {
                if a != b
                    && let Some(length) = bonds.length(solver.parameters(), solver.end(a), solver.end(b))
                {
                    found(id(a), id(b), length);
                }
            });
        })?;
        other_ends.copy_from_slice(&ends[..other_ends.len()]);
        self.memory.given.spring_ranges = of;
        self.put_spring_ends([ends, other_ends]);
        Ok(())
    }

    /// Position and material constants of the particle in a slot, as needed to make springs.
    fn end(&self, slot: usize) -> End {
        (self.state().position[slot], self.properties_of(slot))
    }

    /// The springs that are not broken, each once.
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
            (position(id), self.properties_of(slot(id))[2])
        })
    }
}

/// Energy of springs, J (per metre of depth in 2D). `particle` returns, by id, the position of a particle with its mass
/// in w, and the rest density of its fluid over that of the first fluid. The stiffness of a spring is half of `k`, so
/// its energy is `k / 4 (r - L0)^2` (Pirovano, eq. 2.26, corrected).
pub fn energy(
    plan: &Plan,
    p: &Parameters,
    (of, ends): (&[u32x4], &[u32x2]),
    particle: impl Fn(u32) -> (f32x4, f32),
) -> f64 {
    let spring = |a: u32, [first, count, pull, _]: u32x4| {
        let (x_a, rest) = particle(a);
        // force at an end per metre of elongation
        let mass = f64::from(p.particle_mass) * f64::from(rest) * f64::from(x_a[3]);
        let half_stiffness = f64::from(f32::from_bits(pull)) * mass;
        let first = first as usize;
        let own = ends.get(first..first.saturating_add(count as usize)).unwrap_or_default();
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
