//! A scene on either backend, with one interface.
use crate::arguments::BackendName;
use crate::failure::Failure;
use crate::pool::Pool;
use crate::scenes::LoadedScene;
use crate::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::backend::layout::{Materials, Parameters, u32x4};
use millpond_core::backend::springs::energy;
use millpond_core::scene::Scene;
use millpond_core::{AirReport, Array, Census, CorrectionReport, Plan, Solver, TimeReport};
use millpond_gpu::{Gpu, GpuSolver, Mode};

/// Environment variable: if it is `1`, a missing GPU is an error, so that no comparison is skipped unnoticed.
pub const REQUIRE_GPU: &str = "MILLPOND_REQUIRE_GPU";

/// A fluid on one of the backends.
#[derive(Debug)]
pub enum Fluid<'a> {
    /// On the CPU.
    Cpu {
        /// The solver.
        solver: Box<Solver<'a>>,
        /// Threads to run on.
        pool: &'a Pool,
    },
    /// On a GPU.
    Gpu {
        /// The solver.
        solver: Box<GpuSolver>,
        /// Name of the device.
        device: String,
        /// Data to compute the elastic energy from a snapshot.
        springs: Box<Springs>,
        /// A solver on the CPU, which takes over the state where something is measured.
        host: Box<Solver<'a>>,
    },
}

/// Constant data of a scene and its springs.
#[derive(Clone, Debug)]
pub struct Springs {
    plan: Plan,
    parameters: Parameters,
    materials: Materials,
    ranges: Vec<u32x4>,
}

impl<'a> Fluid<'a> {
    /// Starts a scene on a backend.
    ///
    /// # Errors
    /// A scene that cannot start, or a backend that is not available.
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
                Fluid::Gpu {
                    solver: Box::new(GpuSolver::new(&gpu, &solver)?),
                    device: gpu.name(),
                    springs,
                    host: Box::new(solver),
                }
            }
        })
    }

    /// Makes `count` steps.
    ///
    /// # Errors
    /// A step that fails.
    pub fn step(&mut self, count: u32) -> Result<(), Failure> {
        match self {
            Fluid::Cpu { solver, pool } => (0..count).try_for_each(|_| solver.step(*pool)).map_err(Failure::Step),
            Fluid::Gpu { solver, .. } => Ok(solver.step(count)?),
        }
    }

    /// Returns a solver on the CPU that has the current state.
    ///
    /// # Errors
    /// A failure of the device.
    pub fn measured(&mut self) -> Result<&mut Solver<'a>, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(solver),
            Fluid::Gpu { solver, host, .. } => {
                let own = |error| Failure::Call(format!("the state of the device cannot be taken over: {error}"));
                host.restore(&solver.save()?).map_err(own)?;
                Ok(host)
            }
        }
    }

    /// Returns the current state.
    ///
    /// # Errors
    /// A failure of the device.
    pub fn snapshot(&self) -> Result<Snapshot, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(Snapshot::of_cpu(solver)),
            Fluid::Gpu { solver, .. } => Snapshot::of_gpu(solver),
        }
    }

    /// Returns iterations and residual of the pressure correction.
    ///
    /// # Errors
    /// A failure of the device.
    pub fn correction(&self) -> Result<CorrectionReport, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(solver.correction()),
            Fluid::Gpu { solver, .. } => Ok(solver.correction()?),
        }
    }

    /// Returns the state of the clock: simulated time, last and next time step.
    ///
    /// # Errors
    /// A failure of the device.
    pub fn time_report(&self) -> Result<TimeReport, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(solver.time_report()),
            Fluid::Gpu { solver, .. } => Ok(solver.time_report()?),
        }
    }

    /// Returns the number of active air particles and of refused spawn requests.
    ///
    /// # Errors
    /// A failure of the device.
    pub fn air(&self) -> Result<AirReport, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(solver.air()),
            Fluid::Gpu { solver, .. } => Ok(solver.air()?),
        }
    }

    /// Returns the number of active particles, and how many came and went.
    ///
    /// # Errors
    /// A failure of the device.
    pub fn census(&self) -> Result<Census, Failure> {
        match self {
            Fluid::Cpu { solver, .. } => Ok(solver.census()),
            Fluid::Gpu { solver, .. } => Ok(solver.census()?),
        }
    }

    /// Returns the elastic energy of the springs, J (per metre of depth in 2D). `state` is the current state.
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

    /// Returns a description of the backend.
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

/// Starts a CPU solver for a scene.
///
/// # Errors
/// A scene that cannot start.
pub fn start<'a>(name: &str, scene: &Scene, heap: &'a mut OwnedMemory) -> Result<Solver<'a>, Failure> {
    Solver::new(scene, heap.lend()).map_err(|error| Failure::Scene { origin: name.to_owned(), error })
}

/// Opens a GPU in strict mode. Without one, prints a line on stderr and returns `None`.
///
/// # Errors
/// A missing GPU, if [`REQUIRE_GPU`] is set to `1`.
pub fn device_if_any() -> Result<Option<Gpu>, Failure> {
    match Gpu::open(None, Mode::Strict) {
        Ok(gpu) => Ok(Some(gpu)),
        Err(error) => {
            if std::env::var_os(REQUIRE_GPU).is_some_and(|v| v == "1") {
                return Err(error.into());
            }
            eprintln!("the GPU is left out: {error}");
            Ok(None)
        }
    }
}
