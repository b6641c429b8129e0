//! `compare`: runs a scene on all paths in lockstep, and compares every bit with the scalar path after every step.
use crate::arguments::{BackendName, Common, Length};
use crate::failure::Failure;
use crate::fluid::{device_if_any, start};
use crate::output::{deliver, progress};
use crate::pool::Pool;
use crate::run_length::RunLength;
use crate::scenes::{LoadedScene, MOST_BYTES, load};
use crate::snapshot::Snapshot;
use crate::timing::{Milliseconds, timed};
use millpond_core::OwnedMemory;
use millpond_core::scene::{GridStructure, Scene, Traversal};
use millpond_core::{Requirements, SceneError, Simd, Solver};
use millpond_gpu::{Gpu, GpuSolver, Mode};

mod difference;
mod pair;
pub use difference::{Difference, PerQuantity, difference, ulp_distance};
pub use pair::{Comparison, Pair, table};

/// Options of `compare`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    common: Common,
    #[command(flatten)]
    length: Length,
    /// Compare with the other paths of the CPU only, or with the GPU only, which then must exist (default: all paths)
    #[arg(long)]
    backend: Option<BackendName>,
    /// Also run the GPU in plain mode, which does not promise equal bits
    #[arg(long)]
    plain: bool,
}

/// Default number of steps.
const DEFAULT_STEPS: u64 = 200;

/// A path of computation that is compared with the scalar path.
struct Candidate<'a> {
    path: Path<'a>,
    pair: Pair,
    times: Vec<f64>,
}

enum Path<'a> {
    Cpu(Box<Solver<'a>>, &'a Pool),
    Gpu(Box<GpuSolver>),
}

impl Path<'_> {
    fn step(&mut self) -> Result<Snapshot, Failure> {
        match self {
            Path::Cpu(solver, pool) => {
                solver.step(*pool)?;
                Ok(Snapshot::of_cpu(solver))
            }
            Path::Gpu(solver) => {
                solver.step(1)?;
                Snapshot::of_gpu(solver)
            }
        }
    }
}

/// Runs `compare`. Returns false if a path did not keep its promise.
///
/// # Errors
/// A scene that cannot run, a step that fails, or a GPU that is required and missing.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let named = load(&options.common.scene, &options.common.changes)?;
    let file = &named.file;
    let span = options.length.of(&file.scene, || Ok(RunLength::Steps(DEFAULT_STEPS)))?;
    let gpu = match options.backend {
        Some(BackendName::Cpu) => None,
        Some(BackendName::Gpu) => Some(Gpu::open(None, Mode::Strict)?),
        None => device_if_any()?,
    };
    let plain = if options.plain { Some(Gpu::open(None, Mode::Plain)?) } else { None };
    let paths = Paths {
        cpu: options.backend != Some(BackendName::Gpu),
        threads: if options.common.threads == 0 { 2 } else { options.common.threads },
        devices: gpu.into_iter().chain(plain).collect(),
    };
    let comparison = compare(&named, span, &paths, &mut |_, _| ())?;
    deliver(&options.common, "compare.md", &comparison, &table(&comparison))?;
    Ok(comparison.kept())
}

/// The paths that are compared with the scalar path.
#[derive(Debug)]
pub struct Paths {
    /// Whether to include the other paths of the CPU.
    pub cpu: bool,
    /// Number of threads of the path with several threads.
    pub threads: usize,
    /// GPUs to include.
    pub devices: Vec<Gpu>,
}

/// Returns the scene with the other grid structure. Cell lists get four times as many places per cell as the fullest
/// cell needs at the start, and at least 64.
fn other_grid(scene: &Scene, solver: &mut Solver<'_>) -> Scene {
    let mut other = scene.clone();
    other.grid.structure = match scene.grid.structure {
        GridStructure::IndexSort => {
            GridStructure::CellLists { places: solver.neighbours().fullest_cell().saturating_mul(4).max(64) }
        }
        GridStructure::CellLists { .. } => GridStructure::IndexSort,
    };
    other
}

/// Compares every path with the scalar path over a run. `tamper` may change the state of the first path before it is
/// compared; tests use it to show that the comparison can fail.
///
/// # Errors
/// A scene that cannot run, or a step that fails on the scalar path. The failure of another path is recorded in its
/// pair.
pub fn compare(
    named: &LoadedScene,
    span: RunLength,
    paths: &Paths,
    tamper: &mut dyn FnMut(u64, &mut Snapshot),
) -> Result<Comparison, Failure> {
    let scene = &named.checked()?;
    let (one, many) = (Pool::new(1)?, Pool::new(paths.threads)?);
    let mut heaps = [scene; 2].map(OwnedMemory::of);
    let [first, many_heap] = &mut heaps;
    let mut level_heaps: Vec<_> = Simd::available().skip(1).map(|simd| (simd, OwnedMemory::of(scene))).collect();
    let mut reference = start(&named.name, scene, first)?.at_level(Simd::Scalar);
    let other = other_grid(scene, &mut reference);
    // cell lists with so many places may exceed the limits of a scene, and inactive particles do not go with them
    let needs = match other.check() {
        Ok(other) => Some(Requirements::of(&other)).filter(|needs| needs.bytes() <= MOST_BYTES),
        Err(SceneError::TooManyCells { .. }) => None,
        Err(SceneError::NotTogether { .. }) if scene.inactive_at_start() > 0 || !scene.drains.is_empty() => None,
        Err(error) => return Err(Failure::Scene { origin: format!("{}, other grid", named.name), error }),
    };
    let with_other = needs.is_some();
    let mut other_heap = needs.as_ref().map(OwnedMemory::with).unwrap_or_default();
    let mut rivals = Vec::new();
    let mut enter = |b: String, promised: bool, path| {
        rivals.push(Candidate { path, pair: Pair::new(b, promised), times: Vec::new() });
    };
    // a GPU does not support the half stencil, so it is left out if there are other paths of the CPU to compare
    let leaves_out = paths.cpu && scene.grid.traversal == Traversal::HalfStencil;
    if leaves_out && !paths.devices.is_empty() {
        eprintln!(
            "the GPU is left out: grid.traversal HalfStencil is only for the CPU; set it to FullStencil to compare the \
             GPU too"
        );
    }
    for gpu in paths.devices.iter().filter(|_| !leaves_out) {
        let solver = GpuSolver::new(gpu, &reference)?;
        let mode = format!("{:?}", gpu.mode()).to_lowercase();
        enter(format!("gpu {mode}, {}", gpu.name()), gpu.mode() == Mode::Strict, Path::Gpu(Box::new(solver)));
    }
    if paths.cpu {
        let mut cpu = |name: &str, scene: &Scene, heap, simd, pool| {
            let solver = start(&named.name, scene, heap)?.at_level(simd);
            enter(name.into(), true, Path::Cpu(Box::new(solver), pool));
            Ok::<_, Failure>(())
        };
        let best = Simd::detect();
        let name = format!("cpu lanes ({best:?})").to_lowercase();
        for (simd, heap) in &mut level_heaps {
            cpu(&format!("cpu lanes ({simd:?})").to_lowercase(), scene, heap, *simd, &one)?;
        }
        cpu(&format!("{name}, {} threads", paths.threads), scene, many_heap, best, &many)?;
        if with_other {
            cpu(&format!("{name}, other grid"), &other, &mut other_heap, best, &one)?;
        } else {
            eprintln!(
                "the other grid structure is left out: it would need more cells than a scene can have, or more than \
                 {} GiB, or it does not go with air, emitters or drains",
                MOST_BYTES >> 30
            );
        }
    }

    let bar = progress(&format!("compare {}", named.name), span.length() as u64);
    let mut times = Vec::new();
    let mut step = 0;
    while span.passed(step, reference.time()) < span.length() {
        step += 1;
        let (made, ms) = timed(|| reference.step(&one));
        made?;
        times.push(ms);
        let want = Snapshot::of_cpu(&reference);
        for (i, rival) in rivals.iter_mut().enumerate().filter(|(_, rival)| rival.pair.failure.is_none()) {
            let (got, ms) = timed(|| rival.path.step());
            let mut got = match got {
                Ok(got) => got,
                Err(failure) => {
                    rival.pair.stop(step, &failure);
                    continue;
                }
            };
            rival.times.push(ms);
            if i == 0 {
                tamper(step, &mut got);
            }
            if let Some(found) = difference(&want, &got) {
                rival.pair.note(step, found, scene);
            }
        }
        bar.set_position(span.passed(step, reference.time()) as u64);
    }
    bar.finish_and_clear();
    Ok(Comparison {
        scene: named.name.clone(),
        steps: step,
        particles: reference.slots().len(),
        hash: format!("{:016x}", reference.hash()),
        ms_per_step: Milliseconds::of(&times),
        pairs: rivals
            .into_iter()
            .map(|rival| Pair { ms_per_step: Milliseconds::of(&rival.times), ..rival.pair })
            .collect(),
    })
}
