//! Runs a case on every backend and says what came of it.
use super::{Case, End, Run};
use crate::failure::Failure;
use crate::outcome::Metric;
use crate::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::scene::InitialParticle;
use millpond_core::{Array, Plan, Requirements, SceneError, Serial, Simd, Solver, StepError};
use millpond_gpu::{Gpu, GpuError, GpuSolver};
use std::fmt;

/// What came of a case.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The case.
    pub name: String,
    /// In words: the refusal, or what was measured.
    pub came: String,
    /// Refusals of a step, each of them tried twice.
    pub refusals: usize,
    /// Pairs of backends that were compared.
    pub compared: usize,
    /// What should have been otherwise.
    pub faults: Vec<Fault>,
}

/// What should have been otherwise.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// It did not end as it must.
    End(String),
    /// A refused step left another state behind, or another refusal at the second try.
    Changed(String),
    /// Two backends do not agree.
    Parted(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::End(came) => write!(f, "should have ended otherwise: {came}"),
            Fault::Changed(backend) => write!(f, "refused by {backend}, and yet changed"),
            Fault::Parted(ends) => write!(f, "ended in two ways: {ends}"),
        }
    }
}

/// How a backend ended.
struct Ended {
    backend: &'static str,
    /// Steps that count.
    steps: u64,
    refusal: Option<StepError>,
    /// The same error a second time, and the same bits as before the first?
    kept: bool,
    start: Snapshot,
    end: Snapshot,
}

/// Runs a case on the CPU, by one number at a time and by lanes, and on a device, where there is one.
///
/// # Errors
/// A device that failed.
pub fn judge(case: &Case, gpu: Option<&Gpu>) -> Result<Verdict, Failure> {
    let scalar = match on_cpu(case, "scalar", Simd::Scalar) {
        Ok(ended) => ended,
        Err(error) => return Ok(refused(case, &error)),
    };
    let scene = |error| Failure::Scene { origin: case.name.clone(), error };
    let mut others = vec![on_cpu(case, "lanes", Simd::detect()).map_err(scene)?];
    if let Some(gpu) = gpu {
        others.push(with_solver(case, |solver| on_device(case, gpu, &solver, &scalar)).map_err(scene)??);
    }
    let (came, fault) = outcome(case, &scalar)?;
    let mut faults: Vec<Fault> = fault.into_iter().collect();
    faults.extend(between(&scalar, &others));
    let all = || std::iter::once(&scalar).chain(&others);
    let refusals = all().filter(|ended| ended.refusal.is_some()).count();
    Ok(Verdict { name: case.name.clone(), came, refusals, compared: others.len(), faults })
}

/// What backends did to a state that they were to keep, and where they part.
fn between(scalar: &Ended, others: &[Ended]) -> Vec<Fault> {
    let all = std::iter::once(scalar).chain(others);
    let mut faults: Vec<Fault> =
        all.filter(|ended| !ended.kept).map(|ended| Fault::Changed(ended.backend.into())).collect();
    for other in others {
        let same = (other.refusal, other.steps) == (scalar.refusal, scalar.steps);
        if !same || other.end != scalar.end {
            let [one, two] = [scalar, other].map(|ended| format!("{}, {}", ended.backend, ended.words()));
            faults.push(Fault::Parted(format!("{one}; {two}")));
        }
    }
    faults
}

/// A scene that did not start.
fn refused(case: &Case, error: &SceneError) -> Verdict {
    let meant = match case.end {
        End::Refused(is_meant) => is_meant(error),
        End::NotANumber(name) => matches!(
            *error,
            SceneError::NotFinite { field, value } | SceneError::OutOfBounds { field, value, .. }
                if field == name && !value.is_finite()
        ),
        End::Naming(fields, _) => fields.iter().any(|field| names(error, field)),
        End::Either(_) => true,
        End::Stopped(_) | End::Runs(_) => false,
    };
    let came = format!("refused: {error}");
    let faults = if meant { Vec::new() } else { vec![Fault::End(came.clone())] };
    Verdict { name: case.name.clone(), came, refusals: 0, compared: 0, faults }
}

/// Does its sentence name this field, by the last part of its path? A refusal of the first step names a particle instead.
fn names(error: &SceneError, field: &str) -> bool {
    let last = field.rsplit('.').next();
    let sentence = error.to_string();
    let mut words = sentence.split(|c: char| !c.is_alphanumeric() && c != '_');
    matches!(error, SceneError::FirstStep(_)) || words.any(|word| Some(word) == last)
}

/// What came of a case that started, in words; and again as a fault, where it is not what must come of it.
fn outcome(case: &Case, ended: &Ended) -> Result<(String, Option<Fault>), Failure> {
    let mut came = ended.words();
    let meant = match (case.end, ended.refusal) {
        (End::Stopped(is_meant), Some(error)) => is_meant(&error),
        (End::Either(_) | End::Naming(..), Some(_)) => true,
        (End::Runs(measure) | End::Either(measure) | End::Naming(_, measure), None) => {
            let seconds = ended.end.clock.time;
            let run = Run { scene: &case.scene, start: &ended.start, end: &ended.end, seconds };
            let none = not_finite(&ended.end);
            // from a state with numbers that are none nothing more can be measured
            let figures =
                if none == 0 { measure.figures(&run)? } else { vec![Metric::below("no numbers", none as f64, 0.0)] };
            for Metric { name, value, .. } in &figures {
                came += &format!("; {name} {value:.1e}");
            }
            figures.iter().all(|figure| figure.ok)
        }
        (End::Refused(_) | End::NotANumber(_), _) | (End::Stopped(_), None) | (End::Runs(_), Some(_)) => false,
    };
    let fault = (!meant).then(|| Fault::End(came.clone()));
    Ok((came, fault))
}

impl Ended {
    fn words(&self) -> String {
        self.refusal.map_or_else(|| format!("{} steps", self.steps), |error| error.to_string())
    }
}

/// Does something with a case at its start.
fn with_solver<T>(case: &Case, work: impl FnOnce(Solver<'_>) -> T) -> Result<T, SceneError> {
    let scene = case.scene.check()?;
    let at: Vec<InitialParticle> = case.places.clone().unwrap_or_else(|| scene.initial_particles().collect());
    let mut heap = OwnedMemory::with(&Requirements::of(&scene).for_particles(at.len()));
    Solver::with_particles(&scene, Plan::of(&scene), at.len(), at, heap.lend()).map(work)
}

fn on_cpu(case: &Case, backend: &'static str, simd: Simd) -> Result<Ended, SceneError> {
    with_solver(case, |solver| {
        let mut solver = solver.at_level(simd);
        let start = Snapshot::of_cpu(&solver);
        let mut refusal = None;
        let mut kept = true;
        for _ in 0..case.steps {
            let state = |solver: &Solver<'_>| (Snapshot::of_cpu(solver), solver.steps());
            let before = state(&solver);
            refusal = solver.step(&Serial).err();
            if refusal.is_some() {
                kept = state(&solver) == before && solver.step(&Serial).err() == refusal && state(&solver) == before;
                break;
            }
        }
        Ended { backend, steps: solver.steps(), refusal, kept, start, end: Snapshot::of_cpu(&solver) }
    })
}

/// A device is told of all steps at once. The state that a refusal must leave is the one that the CPU's left.
fn on_device(case: &Case, gpu: &Gpu, solver: &Solver<'_>, cpu: &Ended) -> Result<Ended, Failure> {
    let mut fluid = GpuSolver::new(gpu, solver)?;
    let start = Snapshot::of_gpu(&fluid)?;
    let refusal = step(&mut fluid, case.steps)?;
    let end = Snapshot::of_gpu(&fluid)?;
    let kept = refusal.is_none()
        || end == cpu.end && step(&mut fluid, case.steps)? == refusal && Snapshot::of_gpu(&fluid)? == end;
    Ok(Ended { backend: "device", steps: fluid.steps(), refusal, kept, start, end })
}

/// Makes steps; the refusal, if any.
fn step(fluid: &mut GpuSolver, steps: u32) -> Result<Option<StepError>, Failure> {
    match fluid.step(steps) {
        Ok(()) => Ok(None),
        Err(GpuError::Step(error)) => Ok(Some(error)),
        Err(error) => Err(error.into()),
    }
}

/// Numbers of a state that are none, or infinite.
fn not_finite(state: &Snapshot) -> usize {
    let vectors = Array::ALL.iter().filter(|array| array.is_vector());
    vectors.flat_map(|&array| state.vectors(array)).flatten().filter(|x| !x.is_finite()).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_that_was_changed_and_one_that_is_another_are_found() {
        let ended = |end: Snapshot| Ended { backend: "", steps: 1, refusal: None, kept: true, start: end.clone(), end };
        let state = Snapshot::of_particles(&[[1.0; 4]], &[]);
        assert!(between(&ended(state.clone()), &[ended(state.clone())]).is_empty());
        let mut other = state.clone();
        other.words_mut(Array::position)[1] = 1.0f32.next_up().to_bits();
        assert!(matches!(between(&ended(state.clone()), &[ended(other)])[..], [Fault::Parted(_)]));
        let changed = Ended { kept: false, ..ended(state.clone()) };
        assert!(matches!(between(&ended(state), &[changed])[..], [Fault::Changed(_)]));
    }
}
