//! Runs a case on every backend and checks its result.
use super::{Case, End, Run};
use crate::failure::Failure;
use crate::outcome::Metric;
use crate::pool::Pool;
use crate::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::scene::InitialParticle;
use millpond_core::{Array, Plan, Requirements, SceneError, Simd, Solver, StepError};
use millpond_gpu::{Gpu, GpuError, GpuSolver};
use std::fmt;

/// Result of a case.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Name of the case.
    pub name: String,
    /// The error or the measured figures, as text.
    pub result: String,
    /// Number of steps that failed; each of them was tried twice.
    pub refusals: usize,
    /// Number of pairs of backends that were compared.
    pub compared: usize,
    /// Deviations from the expected result.
    pub faults: Vec<Fault>,
}

/// A deviation from the expected result.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The case did not end as expected.
    End(String),
    /// A failed step changed the state, or failed with another error at the second try.
    Changed(String),
    /// Two backends disagree.
    Parted(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::End(result) => write!(f, "unexpected result: {result}"),
            Fault::Changed(backend) => write!(f, "a refused step changed the state on {backend}"),
            Fault::Parted(ends) => write!(f, "backends disagree: {ends}"),
        }
    }
}

/// A way to run a case on the CPU. All ways must give the same bits.
struct Path {
    backend: &'static str,
    simd: Simd,
    threads: usize,
    /// Whether the plan keeps every term, although the scene does not need it.
    every_term: bool,
}

/// Result of a case on one backend.
struct Ended {
    backend: &'static str,
    /// Whether the plan kept every term, and the state therefore has more arrays.
    every_term: bool,
    /// Number of completed steps.
    steps: u64,
    refusal: Option<StepError>,
    /// Whether a failed step fails with the same error again, and leaves the state unchanged both times.
    kept: bool,
    start: Snapshot,
    end: Snapshot,
}

/// The way with which all others are compared.
const PLAIN: Path = Path { backend: "scalar", simd: Simd::Scalar, threads: 1, every_term: false };

/// Runs a case on the CPU at the scalar and at the best SIMD level, and on a GPU if there is one.
///
/// # Errors
/// A failure of the device.
pub fn judge(case: &Case, gpu: Option<&Gpu>) -> Result<Verdict, Failure> {
    let lanes = Path { backend: "lanes on two threads", simd: Simd::detect(), threads: 2, ..PLAIN };
    on_paths(case, gpu, &[lanes])
}

/// Runs a case as [`judge`] does, and also with every term that its plan leaves out. Such terms have a coefficient of
/// 0, so this is not for cases in which a term would be infinite.
///
/// # Errors
/// A failure of the device.
pub fn judge_with_every_term(case: &Case, gpu: Option<&Gpu>) -> Result<Verdict, Failure> {
    let lanes = Path { backend: "lanes on two threads", simd: Simd::detect(), threads: 2, ..PLAIN };
    let whole = Path { backend: "with every term", simd: Simd::detect(), every_term: true, ..PLAIN };
    on_paths(case, gpu, &[lanes, whole])
}

fn on_paths(case: &Case, gpu: Option<&Gpu>, paths: &[Path]) -> Result<Verdict, Failure> {
    let scalar = match on_cpu(case, &PLAIN)? {
        Ok(ended) => ended,
        Err(error) => return Ok(refused(case, &error)),
    };
    let scene = |error| Failure::Scene { origin: case.name.clone(), error };
    let mut others = Vec::new();
    for path in paths {
        others.push(on_cpu(case, path)?.map_err(scene)?);
    }
    if let Some(gpu) = gpu {
        others.push(with_solver(case, false, |solver| on_device(case, gpu, &solver, &scalar)).map_err(scene)??);
    }
    let (result, fault) = outcome(case, &scalar)?;
    let mut faults: Vec<Fault> = fault.into_iter().collect();
    faults.extend(between(&scalar, &others));
    let all = || std::iter::once(&scalar).chain(&others);
    let refusals = all().filter(|ended| ended.refusal.is_some()).count();
    Ok(Verdict { name: case.name.clone(), result, refusals, compared: others.len(), faults })
}

/// Returns states that a failed step changed, and differences between backends.
fn between(scalar: &Ended, others: &[Ended]) -> Vec<Fault> {
    let all = std::iter::once(scalar).chain(others);
    let mut faults: Vec<Fault> =
        all.filter(|ended| !ended.kept).map(|ended| Fault::Changed(ended.backend.into())).collect();
    for other in others {
        let same_end = if other.every_term { other.end.hash() == scalar.end.hash() } else { other.end == scalar.end };
        if !same_end || (other.refusal, other.steps) != (scalar.refusal, scalar.steps) {
            let [one, two] = [scalar, other].map(|ended| format!("{}, {}", ended.backend, ended.words()));
            faults.push(Fault::Parted(format!("{one}; {two}")));
        }
    }
    faults
}

/// Returns the result of a case whose scene was rejected.
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
    let result = format!("refused: {error}");
    let faults = if meant { Vec::new() } else { vec![Fault::End(result.clone())] };
    Verdict { name: case.name.clone(), result, refusals: 0, compared: 0, faults }
}

/// Returns whether the error message names this field, by the last part of its path. An error of the first step names a
/// particle and no field, and is accepted.
fn names(error: &SceneError, field: &str) -> bool {
    let last = field.rsplit('.').next();
    let sentence = error.to_string();
    let mut words = sentence.split(|c: char| !c.is_alphanumeric() && c != '_');
    matches!(error, SceneError::FirstStep(_)) || words.any(|word| Some(word) == last)
}

/// Returns the result of a case that started, as text, and a fault if it is not the expected one.
fn outcome(case: &Case, ended: &Ended) -> Result<(String, Option<Fault>), Failure> {
    let mut result = ended.words();
    let meant = match (case.end, ended.refusal) {
        (End::Stopped(is_meant), Some(error)) => is_meant(&error),
        (End::Either(_) | End::Naming(..), Some(_)) => true,
        (End::Runs(measure) | End::Either(measure) | End::Naming(_, measure), None) => {
            let seconds = ended.end.clock.time;
            let run = Run { scene: &case.scene, start: &ended.start, end: &ended.end, seconds };
            let none = not_finite(&ended.end);
            // nothing else can be measured in a state with values that are not finite
            let figures =
                if none == 0 { measure.figures(&run)? } else { vec![Metric::below("not finite", none as f64, 0.0)] };
            for Metric { name, value, .. } in &figures {
                result += &format!("; {name} {value:.1e}");
            }
            figures.iter().all(|figure| figure.ok)
        }
        (End::Refused(_) | End::NotANumber(_), _) | (End::Stopped(_), None) | (End::Runs(_), Some(_)) => false,
    };
    let fault = (!meant).then(|| Fault::End(result.clone()));
    Ok((result, fault))
}

impl Ended {
    fn words(&self) -> String {
        self.refusal.map_or_else(|| format!("{} steps", self.steps), |error| error.to_string())
    }
}

/// Calls `work` with a solver at the start of a case.
fn with_solver<T>(case: &Case, every_term: bool, work: impl FnOnce(Solver<'_>) -> T) -> Result<T, SceneError> {
    let scene = case.scene.check()?;
    let plan = if every_term { Plan::everything(&scene) } else { Plan::of(&scene) };
    let at: Vec<InitialParticle> = case.places.clone().unwrap_or_else(|| scene.initial_particles().collect());
    let mut heap = OwnedMemory::with(&Requirements::by_plan(&scene, &plan).for_particles(at.len()));
    Solver::with_particles(&scene, plan, at.len(), at, heap.lend()).map(work)
}

fn on_cpu(case: &Case, path: &Path) -> Result<Result<Ended, SceneError>, Failure> {
    let pool = Pool::new(path.threads)?;
    let &Path { backend, every_term, .. } = path;
    Ok(with_solver(case, every_term, |solver| {
        let mut solver = solver.at_level(path.simd);
        let start = Snapshot::of_cpu(&solver);
        let mut refusal = None;
        let mut kept = true;
        for _ in 0..case.steps {
            let state = |solver: &Solver<'_>| (Snapshot::of_cpu(solver), solver.steps());
            let before = state(&solver);
            refusal = solver.step(&pool).err();
            if refusal.is_some() {
                kept = state(&solver) == before && solver.step(&pool).err() == refusal && state(&solver) == before;
                break;
            }
        }
        Ended { backend, every_term, steps: solver.steps(), refusal, kept, start, end: Snapshot::of_cpu(&solver) }
    }))
}

/// Runs a case on a GPU, which is given all steps at once. A failed step must leave the state that it left on the CPU.
fn on_device(case: &Case, gpu: &Gpu, solver: &Solver<'_>, cpu: &Ended) -> Result<Ended, Failure> {
    let mut fluid = GpuSolver::new(gpu, solver)?;
    let start = Snapshot::of_gpu(&fluid)?;
    let refusal = step(&mut fluid, case.steps)?;
    let end = Snapshot::of_gpu(&fluid)?;
    let kept = refusal.is_none()
        || end == cpu.end && step(&mut fluid, case.steps)? == refusal && Snapshot::of_gpu(&fluid)? == end;
    Ok(Ended { backend: "device", every_term: false, steps: fluid.steps(), refusal, kept, start, end })
}

/// Makes steps and returns the error of the step that failed, if one did.
fn step(fluid: &mut GpuSolver, steps: u32) -> Result<Option<StepError>, Failure> {
    match fluid.step(steps) {
        Ok(()) => Ok(None),
        Err(GpuError::Step(error)) => Ok(Some(error)),
        Err(error) => Err(error.into()),
    }
}

/// Returns the number of values in a state that are not finite.
fn not_finite(state: &Snapshot) -> usize {
    let vectors = Array::ALL.iter().filter(|array| array.is_vector());
    vectors.flat_map(|&array| state.vectors(array)).flatten().filter(|x| !x.is_finite()).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_that_was_changed_and_one_that_is_another_are_found() {
        let ended = |end: Snapshot| Ended {
            backend: "",
            every_term: false,
            steps: 1,
            refusal: None,
            kept: true,
            start: end.clone(),
            end,
        };
        let state = Snapshot::of_particles(&[[1.0; 4]], &[]);
        assert!(between(&ended(state.clone()), &[ended(state.clone())]).is_empty());
        let mut other = state.clone();
        other.words_mut(Array::position)[1] = 1.0f32.next_up().to_bits();
        assert!(matches!(between(&ended(state.clone()), &[ended(other)])[..], [Fault::Parted(_)]));
        let changed = Ended { kept: false, ..ended(state.clone()) };
        assert!(matches!(between(&ended(state), &[changed])[..], [Fault::Changed(_)]));
    }
}
