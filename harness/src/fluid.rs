//! A scene on a backend, behind one face.
use crate::arguments::BackendName;
use crate::failure::Failure;
use crate::pool::Pool;
use crate::scenes::LoadedScene;
use crate::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::backend::layout::{Materials, Parameters, u32x4};
use millpond_core::backend::springs::energy;
use millpond_core::scene::Scene;
use millpond_core::{AirReport, Array, CorrectionReport, Plan, Solver, TimeReport};
use millpond_gpu::{Gpu, GpuSolver, Mode};

/// Set to `1`, it turns a missing GPU into a failure, so that no comparison is skipped unseen.
pub const REQUIRE_GPU: &str = "MILLPOND_REQUIRE_GPU";

/// A fluid that can be stepped and looked at.
#[derive(Debug)]
pub enum Fluid<'a> {
    /// On the CPU.
    Cpu {
        /// The fluid.
        solver: Box<Solver<'a>>,
        /// Who works.
        pool: &'a Pool,
    },
    /// On a device.
    Gpu {
        /// The fluid.
        solver: Box<GpuSolver>,
        /// Name of the device.
        device: String,
        /// What it needs to know of springs to say what is in them.
        springs: Box<Springs>,
    },
}

/// What does not change of springs, and of the scene that they are in.
#[derive(Clone, Debug)]
pub struct Springs {
    plan: Plan,
    parameters: Parameters,
    materials: Materials,
    ranges: Vec<u32x4>,
}

impl<'a> Fluid<'a> {
    /// `scene` at its start.
    ///
    /// # Errors
    /// A scene that cannot start, or no such backend.
    pub fn start(
        named: &LoadedScene,
        backend: BackendName,
        heap: &'a mut OwnedMemory,
        pool: &'a Pool,
    ) -> Result<Fluid<'a>, Failure> {
        let solver = start(&named.name, &named.file.scene, heap)?;
        Ok(match backend {
            BackendName::Cpu => Fluid::Cpu { solver: Box::new(solver), pool },
            BackendName::Gpu => {
                let gpu = Gpu::open(None, Mode::Strict)?;
                let (plan, parameters) = (*solver.plan(), *solver.parameters());
                let ranges = bytemuck::cast_slice(solver.words(Array::spring_ranges)).to_vec();
                let springs = Box::new(Springs { plan, parameters, materials: *solver.materials(), ranges });
                Fluid::Gpu { solver: Box::new(GpuSolver::new(&gpu, &solver)?), device: gpu.name(), springs }
            }
        })
    }

    /// Makes `count` steps.
    ///
    /// # Errors
    /// A step that could not be made.
    pub fn step(&mut self, count: u32) -> Result<(), Failure> {
        match self {
            Fluid::Cpu { solver, pool } => (0..count).try_for_each(|_| solver.step(*pool)).map_err(Failure::Step),
            Fluid::Gpu { solver, .. } => Ok(solver.step(count)?),
        }
    }

    /// Its state now.
    ///
    /// # Errors
    /// The device failed.
    pub fn snapshot(&self) -> Result<Snapshot, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(Snapshot::of_cpu(solver)),
            Fluid::Gpu { solver, .. } => Snapshot::of_gpu(solver),
        }
    }

    /// What the pressure correction came to.
    ///
    /// # Errors
    /// The device failed.
    pub fn correction(&self) -> Result<CorrectionReport, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(solver.correction()),
            Fluid::Gpu { solver, .. } => Ok(solver.correction()?),
        }
    }

    /// What became of the time step.
    ///
    /// # Errors
    /// The device failed.
    pub fn time_report(&self) -> Result<TimeReport, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(solver.time_report()),
            Fluid::Gpu { solver, .. } => Ok(solver.time_report()?),
        }
    }

    /// What became of the coat of air.
    ///
    /// # Errors
    /// The device failed.
    pub fn air(&self) -> Result<AirReport, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(solver.air()),
            Fluid::Gpu { solver, .. } => Ok(solver.air()?),
        }
    }

    /// Energy in its springs, J (per metre of depth in 2D), its state now being this one.
    #[must_use]
    pub fn elastic_energy(&self, state: &Snapshot) -> f64 {
        match self {
            Fluid::Cpu { solver, .. } => solver.energies().elastic,
            Fluid::Gpu { springs, .. } => {
                let rest = |id: u32| {
                    let material = state.velocity()[id as usize][3] as usize;
                    springs.materials.properties.get(material).map_or(1.0, |row| row[2])
                };
                let particle = |id: u32| (state.position()[id as usize], rest(id));
                energy(&springs.plan, &springs.parameters, (&springs.ranges, state.spring_ends()), particle)
            }
        }
    }

    /// What it runs on, in words.
    #[must_use]
    pub fn backend(&self) -> String {
        match self {
            Fluid::Cpu { solver, pool } => {
                let threads = millpond_core::Executor::width(*pool);
                format!("cpu ({:?}, {threads} thread{})", solver.simd(), if threads == 1 { "" } else { "s" })
                    .to_lowercase()
            }
            Fluid::Gpu { device, .. } => format!("gpu (strict, {device})"),
        }
    }
}

/// A CPU solver for `scene` at its start.
///
/// # Errors
/// A scene that cannot start.
pub fn start<'a>(name: &str, scene: &Scene, heap: &'a mut OwnedMemory) -> Result<Solver<'a>, Failure> {
    Solver::new(scene, heap.lend()).map_err(|error| Failure::Scene { origin: name.to_owned(), error })
}

/// A device in strict mode, or `None` with a line on stderr where there is none.
///
/// # Errors
/// None where [`REQUIRE_GPU`] wants one.
pub fn device_if_any() -> Result<Option<Gpu>, Failure> {
    match Gpu::open(None, Mode::Strict) {
        Ok(gpu) => Ok(Some(gpu)),
        Err(error) => {
            if std::env::var_os(REQUIRE_GPU).is_some_and(|v| v == "1") {
                return Err(error.into());
            }
            eprintln!("GPU left out: {error}");
            Ok(None)
        }
    }
}
