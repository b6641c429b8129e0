//! A scene on a backend, behind one face.
use crate::arguments::BackendName;
use crate::failure::Failure;
use crate::memory::Heap;
use crate::pool::Pool;
use crate::scenes::Named;
use millpond_core::hash::state_hash;
use millpond_core::layout::{Parameters, f32x4, u32x2, u32x4};
use millpond_core::scene::{InitialParticle, Scene};
use millpond_core::springs::energy;
use millpond_core::{AirReport, CorrectionReport, Plan, Solver, TimeReport};
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
    of: Vec<u32x4>,
}

/// A state, by particle id.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// Position, m.
    pub position: Vec<f32x4>,
    /// Velocity, m/s.
    pub velocity: Vec<f32x4>,
    /// [`QUANTITIES`](millpond_core::layout::QUANTITIES).
    pub density_pressure: Vec<f32x4>,
    /// Thermal energy, J/kg, and its rate, W/kg; empty where the scene keeps no account of it.
    pub heat: Vec<f32x4>,
    /// Inward normals of surfaces, 1/m, and in w the curvature that tension takes; empty where the scene finds none.
    pub surface: Vec<f32x4>,
    /// Ends of springs, each particle's side by side; empty where the scene has none.
    pub spring_ends: Vec<u32x2>,
    /// What became of the time step.
    pub clock: TimeReport,
}

impl Snapshot {
    fn of(slots: &[u32], [position, velocity, density_pressure, heat]: [&[f32x4]; 4]) -> Snapshot {
        let by_id =
            |array: &[f32x4]| slots.iter().filter_map(|&slot| array.get(slot as usize)).copied().collect::<Vec<_>>();
        Snapshot {
            position: by_id(position),
            velocity: by_id(velocity),
            density_pressure: by_id(density_pressure),
            heat: by_id(heat),
            ..Snapshot::default()
        }
    }

    /// And what only some scenes have: normals with the curvature that is kept beside accelerations, ends of springs, a time
    /// step of its own.
    fn with(
        mut self,
        slots: &[u32],
        [normal, acceleration]: [&[f32x4]; 2],
        ends: &[u32x2],
        clock: TimeReport,
    ) -> Snapshot {
        let of = |&slot: &u32| {
            let [x, y, z, _] = *normal.get(slot as usize)?;
            Some([x, y, z, acceleration.get(slot as usize)?[3]])
        };
        self.surface = slots.iter().filter_map(of).collect();
        self.spring_ends = ends.to_vec();
        self.clock = clock;
        self
    }

    /// Where particles would be to go on from here.
    pub fn places(&self) -> impl Iterator<Item = InitialParticle> {
        let vector = |[x, y, z, _]: f32x4| [x, y, z];
        let all = self.position.iter().zip(&self.velocity).zip(&self.density_pressure);
        all.map(move |((x, v), d)| InitialParticle {
            position: vector(*x),
            velocity: vector(*v),
            material: v[3] as u32,
            mass: x[3],
            deviation: d[0],
            pressure: d[1],
        })
    }

    /// The state hash, as core computes it.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let slots: Vec<u32> = (0..self.position.len() as u32).collect();
        state_hash(&slots, &self.position, &self.velocity)
    }

    /// Of a CPU solver.
    #[must_use]
    pub fn of_cpu(solver: &Solver<'_>) -> Snapshot {
        let state = solver.state();
        Snapshot::of(solver.slots(), [state.position, state.velocity, state.density_pressure, state.heat]).with(
            solver.slots(),
            [state.normal, state.acceleration],
            solver.spring_ends(),
            solver.time_report(),
        )
    }

    /// Of a GPU solver.
    ///
    /// # Errors
    /// The device failed.
    pub fn of_gpu(solver: &GpuSolver) -> Result<Snapshot, Failure> {
        let state = solver.read()?;
        let slots = state.slots();
        let known = Snapshot::of(&slots, [&state.position, &state.velocity, &state.density_pressure, &state.heat]);
        let clock = solver.time_report()?;
        Ok(known.with(&slots, [&state.normal, &state.acceleration], &state.spring_ends, clock))
    }
}

impl<'a> Fluid<'a> {
    /// `scene` at its start.
    ///
    /// # Errors
    /// A scene that cannot start, or no such backend.
    pub fn start(
        named: &Named,
        backend: BackendName,
        heap: &'a mut Heap,
        pool: &'a Pool,
    ) -> Result<Fluid<'a>, Failure> {
        let solver = start(&named.name, &named.file.scene, heap)?;
        Ok(match backend {
            BackendName::Cpu => Fluid::Cpu { solver: Box::new(solver), pool },
            BackendName::Gpu => {
                let gpu = Gpu::open(None, Mode::Strict)?;
                let (plan, parameters) = (*solver.plan(), *solver.parameters());
                let springs = Box::new(Springs { plan, parameters, of: solver.springs_of().to_vec() });
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
                    let kind = state.velocity[id as usize][3] as usize;
                    springs.parameters.species.get(kind).map_or(1.0, |species| species[2])
                };
                let particle = |id: u32| (state.position[id as usize], rest(id));
                energy(&springs.plan, &springs.parameters, (&springs.of, &state.spring_ends), particle)
            }
        }
    }

    /// What it runs on, in words.
    #[must_use]
    pub fn backend(&self) -> String {
        match self {
            Fluid::Cpu { solver, pool } => {
                let threads = millpond_core::Executor::width(*pool);
                format!("cpu ({:?}, {threads} threads)", solver.simd()).to_lowercase()
            }
            Fluid::Gpu { device, .. } => format!("gpu (strict, {device})"),
        }
    }
}

/// A CPU solver for `scene` at its start.
///
/// # Errors
/// A scene that cannot start.
pub fn start<'a>(name: &str, scene: &Scene, heap: &'a mut Heap) -> Result<Solver<'a>, Failure> {
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
