//! What can be said of a state as a whole, the same for every backend: a CPU solver is set up from it and asked.
use crate::energy::{scale, total};
use crate::failure::Failure;
use crate::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::backend::layout::f32x4;
use millpond_core::backend::report::{Courant, DensityError, Energies};
use millpond_core::scene::{Elasticity, GridStructure, Integrator, Scene};
use millpond_core::{Plan, Requirements, Solver};
use serde::Serialize;

/// A state in a few numbers.
#[derive(Clone, Debug)]
pub struct StateSummary {
    /// Mean number of particles inside a support radius, each counting itself.
    pub average_neighbours: f64,
    /// Compression.
    pub density_error: DensityError,
    /// Energies but for heat, which the solver that was set up knows nothing of.
    pub energies: Energies,
    /// Mechanical energy with what compression stores, J; springs and surfaces left out.
    pub mechanical: f64,
    /// Energy that a scene in this state has to spend, J.
    pub to_spend: f64,
    /// Fastest particle, m/s.
    pub fastest: f64,
    /// The step before it, s.
    pub time_step: f64,
    /// Its Courant numbers.
    pub courant: Courant,
    /// Largest coordinate of a particle, m.
    pub farthest: f64,
}

/// A number at the first and at the last step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FirstLast {
    /// At the first.
    pub first: f64,
    /// At the last.
    pub last: f64,
}

/// Mean and largest of something.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MeanMax {
    /// Mean.
    pub mean: f64,
    /// Largest.
    pub max: f64,
}

impl From<DensityError> for MeanMax {
    fn from(error: DensityError) -> Self {
        MeanMax { mean: error.mean, max: error.max }
    }
}

/// Takes the state_summary of a state of `scene`.
///
/// # Errors
/// A state that no step could start from.
pub fn summarize(scene: &Scene, state: &Snapshot) -> Result<StateSummary, Failure> {
    let count = state.position().len();
    // walls may have moved particles into cells that are full: the index sort takes any number
    let mut scene = scene.clone();
    scene.grid.structure = GridStructure::IndexSort;
    // springs are made where particles start, and this is not where they did
    scene.fluids.iter_mut().for_each(|fluid| fluid.elastic_stiffness = 0.0);
    scene.elasticity = Elasticity::default();
    // nor does an integrator remember anything of them
    (scene.model.integrator, scene.model.reevaluate, scene.adaptive) = (Integrator::default(), false, None);
    let refused = |error| Failure::Scene { origin: "state_summary".into(), error };
    let scene = &scene.check().map_err(refused)?;
    let mut heap = OwnedMemory::with(&Requirements::of(scene).for_particles(count));
    let solver = Solver::with_particles(scene, Plan::of(scene), count, state.places(), heap.lend());
    let mut solver = solver.map_err(refused)?;
    let speed = |v: &f32x4| v[..3].iter().map(|x| f64::from(*x) * f64::from(*x)).sum::<f64>().sqrt();
    Ok(StateSummary {
        average_neighbours: solver.average_neighbours(),
        density_error: solver.density_error(),
        energies: solver.energies(),
        time_step: f64::from(state.clock.time_step),
        courant: solver.courant(state.clock.time_step),
        mechanical: total(scene, &solver),
        to_spend: scale(scene, &solver),
        fastest: state.velocity().iter().map(speed).fold(0.0, f64::max),
        farthest: state.position().iter().flat_map(|x| &x[..3]).map(|x| f64::from(x.abs())).fold(0.0, f64::max),
    })
}
