//! Roofline model: arithmetic and memory traffic of each pass per time, compared with two peak rates that are measured
//! by small probes.
use super::operations::{of_density, of_force, of_test};
use super::{Ceilings, PassTime, Roof};
use crate::pool::Pool;
use crate::timing::timed;
use millpond_core::backend::ListReport;
use millpond_core::backend::arithmetic::probe::multiply_and_add;
use millpond_core::backend::plan::schedule::Command;
use millpond_core::{Array, Executor, Pass, Requirements, Simd, Solver};
use std::hint::black_box;

/// Rounds of the arithmetic probe, which takes some milliseconds.
const ROUNDS: u32 = 1 << 20;
/// Length of each of the three arrays of the memory probe. They take 192 MiB together, more than most caches hold.
const NUMBERS: usize = 1 << 24;
/// Number of runs of each probe, of which the fastest counts.
const ATTEMPTS: usize = 5;

/// Measures the two peak rates with as many threads as the passes use.
pub(super) fn ceilings(simd: Simd, pool: &Pool) -> Ceilings {
    let mut best = Ceilings { gigaoperations_per_second: 0.0, gigabytes_per_second: 0.0 };
    let [mut a, b, c] = [0.0f32, 1.0, 2.0].map(|x| vec![x; NUMBERS]);
    let share = NUMBERS.div_ceil(pool.width());
    for _ in 0..ATTEMPTS {
        let mut counts = vec![0; pool.width()];
        let ((), ms) = timed(|| pool.run(&mut counts, |count| *count = multiply_and_add(simd, ROUNDS)));
        let operations = counts.iter().sum::<u64>() as f64;
        best.gigaoperations_per_second = best.gigaoperations_per_second.max(operations / ms * 1e-6);
        let mut shares: Vec<_> = a.chunks_mut(share).zip(b.chunks(share)).zip(c.chunks(share)).collect();
        let ((), ms) = timed(|| {
            pool.run(&mut shares, |((a, b), c)| {
                for ((a, b), c) in a.iter_mut().zip(*b).zip(*c) {
                    *a = b + 0.5 * c;
                }
            });
        });
        let bytes = (3 * NUMBERS * size_of::<f32>()) as f64;
        best.gigabytes_per_second = best.gigabytes_per_second.max(bytes / ms * 1e-6);
    }
    black_box(a);
    best
}

/// Operations of each pass of a step, and the least number of bytes that it must read and write.
pub(super) struct Costs {
    bytes: Vec<(&'static str, u64)>,
    operations: Vec<(&'static str, u64)>,
}

/// Counts operations and bytes for the current state of a solver. `lists` describes the neighbour lists of its last
/// step.
pub(super) fn costs(solver: &mut Solver<'_>, requirements: &Requirements, lists: Option<ListReport>) -> Costs {
    let tested = solver.neighbours().tested_pairs();
    let (plan, p) = (solver.plan(), solver.parameters());
    let m = &plan.model;
    // pairs of groups without lists are not counted
    let pairs = lists.filter(|lists| lists.listed == lists.groups).map(|lists| lists.pairs);
    let forces = plan.schedule().iter().filter(|command| command.pass() == Some(Pass::Force)).count() as u64;
    let trying = of_test(m, p) * tested;
    let mut operations = Vec::new();
    if Pass::Neighbours.runs(m) {
        operations.push((Pass::Neighbours.name(), trying));
    }
    if let Some(pairs) = pairs {
        let finding = if Pass::Neighbours.runs(m) { 0 } else { trying };
        operations.push((Pass::Density.name(), finding + of_density(m, p) * pairs));
        operations.push((Pass::Force.name(), of_force(m, p) * pairs * forces));
    }
    let of_array = |array: Array| (requirements.entries(array) * array.words() * size_of::<u32>()) as u64;
    // on the CPU the passes over pairs read neighbour lists, where those on a GPU read cells
    let of_lists = lists.map_or(0, |lists| 2 * lists.places + 16 * lists.groups as u64);
    let of_pass = |pass: Pass| -> u64 {
        if pass == Pass::Neighbours {
            return of_array(Array::position) + of_lists;
        }
        let arrays = pass.bindings().iter().filter(|binding| binding.array.exists(m));
        let sorted = pass.folder() != Pass::Count.folder();
        arrays
            .map(
                |binding| if binding.array == Array::cell_start && sorted { of_lists } else { of_array(binding.array) },
            )
            .sum()
    };
    let mut bytes: Vec<(&'static str, u64)> = Vec::new();
    for command in &plan.schedule() {
        let (pass, moved) = match *command {
            Command::Run(pass) | Command::RunAgain(pass) => (pass, of_pass(pass)),
            Command::Gather { from: (from, _), to } => {
                (Pass::Gather, of_array(from) + of_array(to) + of_array(Array::source_slot))
            }
            Command::Validate(array) => (Pass::Validate, of_array(array) + of_array(Array::id)),
            // the number of repetitions is not known in advance
            Command::Repeat { .. } => return Costs { bytes: Vec::new(), operations },
        };
        match bytes.iter_mut().find(|(name, _)| *name == pass.name()) {
            Some((_, bytes)) => *bytes += moved,
            None => bytes.push((pass.name(), moved)),
        }
    }
    Costs { bytes, operations }
}

impl Costs {
    /// Compares a timed pass with the peak rates.
    pub(super) fn roof(&self, pass: &PassTime, ceilings: &Ceilings) -> Roof {
        let of = |all: &[(&'static str, u64)]| all.iter().find(|(name, _)| *name == pass.name).map(|(_, count)| *count);
        let rate = |count: Option<u64>| count.map(|count| count as f64 / pass.ms.max(1e-9) * 1e-6);
        let (operations, bytes) = (of(&self.operations), of(&self.bytes).filter(|bytes| *bytes > 0));
        Roof {
            operations,
            share_of_arithmetic: rate(operations).map(|rate| rate / ceilings.gigaoperations_per_second),
            bytes,
            share_of_memory: rate(bytes).map(|rate| rate / ceilings.gigabytes_per_second),
        }
    }
}
