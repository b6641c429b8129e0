//! Summary of a state. To be the same for every backend, it is computed by a CPU solver that is started from the state.
use crate::energy::{scale, total};
use crate::failure::Failure;
use crate::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::backend::layout::f32x4;
use millpond_core::backend::report::{Courant, DensityError, Energies};
use millpond_core::scene::{Elasticity, GridStructure, Integrator, Scene};
use millpond_core::{Plan, Requirements, Solver};
use serde::Serialize;

/// Summary of a state.
#[derive(Clone, Debug)]
pub struct StateSummary {
    /// Mean number of particles inside the support radius of a fluid particle, the particle itself included.
    pub average_neighbours: f64,
    /// Compression beyond the rest density.
    pub density_error: DensityError,
    /// Energies. The internal energy is missing, since the solver that computes the summary does not know it.
    pub energies: Energies,
    /// Mechanical energy including that stored in compression, J; without springs and surface tension.
    pub mechanical: f64,
    /// Energy available to a scene that starts in this state, J.
    pub to_spend: f64,
    /// Largest speed of a particle, m/s.
    pub fastest: f64,
    /// Time step that led to this state, s.
    pub time_step: f64,
    /// Courant numbers of that step.
    pub courant: Courant,
    /// Largest absolute coordinate of a particle, m.
    pub farthest: f64,
}

/// A value before the first step and after the last step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FirstLast {
    /// Before the first step.
    pub first: f64,
    /// After the last step.
    pub last: f64,
}

/// Mean and maximum.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MeanMax {
    /// Mean.
    pub mean: f64,
    /// Maximum.
    pub max: f64,
}

impl From<DensityError> for MeanMax {
    fn from(error: DensityError) -> Self {
        MeanMax { mean: error.mean, max: error.max }
    }
}

/// Summarizes a state of `scene`.
///
/// # Errors
/// A state from which no solver can start.
pub fn summarize(scene: &Scene, state: &Snapshot) -> Result<StateSummary, Failure> {
    let count = state.position().len();
    // penalty walls may have moved particles into full cells, and the index sort has no limit per cell
    let mut scene = scene.clone();
    scene.grid.structure = GridStructure::IndexSort;
    // springs are created between the initial positions, and these are not
    scene.fluids.iter_mut().for_each(|fluid| fluid.elastic_stiffness = 0.0);
    scene.elasticity = Elasticity::default();
    // nor is there a history for the integrator
    (scene.model.integrator, scene.model.reevaluate, scene.adaptive) = (Integrator::default(), false, None);
    let refused = |error| Failure::Scene { origin: "state_summary".into(), error };
    let scene = &scene.check().map_err(refused)?;
    let mut heap = OwnedMemory::with(&Requirements::of(scene).for_particles(count));
    let solver = Solver::with_particles(scene, Plan::of(scene), count, state.places(), heap.lend());
    let mut solver = solver.map_err(refused)?;
    let speed = |v: &f32x4| v[..3].iter().map(|x| f64::from(*x) * f64::from(*x)).sum::<f64>().sqrt();
    Ok(StateSummary {
        average_neighbours: solver.neighbours().average(),
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
