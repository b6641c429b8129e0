//! `plan`: what a scene needs, what it leaves out, and how much memory and time that saves.
use crate::arguments::Common;
use crate::failure::Failure;
use crate::nearest::Nearest;
use crate::output::deliver;
use crate::pool::Pool;
use crate::scenes::{LoadedScene, load};
use crate::timing::{Milliseconds, timed};
use millpond_core::OwnedMemory;
use millpond_core::backend::layout::Model;
use millpond_core::backend::plan::schedule::Command;
use millpond_core::backend::terms::correction::PRESSURE_CORRECTION;
use millpond_core::backend::terms::shifting::FICKIAN;
use millpond_core::backend::terms::table::TABLE;
use millpond_core::scene::Scene;
use millpond_core::{Array, Checked, Plan, Requirements, Solver};
use serde::Serialize;

/// Options of `plan`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    common: Common,
    /// Number of steps to time with the scene's plan and with everything included (0: do not time)
    #[arg(long, default_value_t = 20, value_name = "N")]
    steps: u32,
}

/// Result of `plan`.
#[derive(Clone, Debug, Serialize)]
pub struct PlanView {
    /// Name of the scene.
    pub scene: String,
    /// Number of particles.
    pub particles: usize,
    /// The recipe that the formulas are nearest to.
    pub formulas: Nearest,
    /// Passes that run, in order.
    pub passes: Vec<PassView>,
    /// Commands of a step, as text.
    pub commands: Vec<String>,
    /// Parts that are left out, and why.
    pub left_out: Vec<LeftOutView>,
    /// Memory of the scene.
    pub bytes: Bytes,
    /// Allocated arrays and their sizes.
    pub arrays: Vec<ArrayView>,
    /// Shortest step with each plan, timed alternately, ms.
    pub ms_per_step: PlanTimes,
    /// Median step with each plan, ms.
    pub median_ms_per_step: PlanTimes,
}

/// A pass and its terms.
#[derive(Clone, Debug, Serialize)]
pub struct PassView {
    /// Name of the pass.
    pub name: &'static str,
    /// Terms of the pass, in order.
    pub terms: Vec<&'static str>,
}

/// A part that is left out.
#[derive(Clone, Debug, Serialize)]
pub struct LeftOutView {
    /// Name of the part.
    pub what: &'static str,
    /// Reason.
    pub why: &'static str,
    /// Memory that is saved, bytes.
    pub bytes: usize,
}

/// An array and its size.
#[derive(Clone, Debug, Serialize)]
pub struct ArrayView {
    /// Name of the array.
    pub name: &'static str,
    /// Size, bytes.
    pub bytes: usize,
}

/// Memory of a scene, bytes.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Bytes {
    /// With the scene's plan.
    pub used: usize,
    /// With everything included that this version can leave out.
    pub everything: usize,
}

/// Times with the two plans, ms.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PlanTimes {
    /// With the scene's plan.
    pub plan: f64,
    /// With every term included.
    pub everything: f64,
}

/// Places per cell assumed for the cell lists of a scene that uses the index sort: a little more than the
/// default number of neighbours in 3D.
pub(crate) const USUAL_PLACES: u32 = 64;

/// Runs `plan`.
///
/// # Errors
/// A scene that cannot run.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let named = load(&options.common.scene, &options.common.changes)?;
    let view = view(&named, &Pool::new(options.common.threads)?, options.steps)?;
    deliver(&options.common, "plan.txt", &view, &table(&view))?;
    Ok(true)
}

/// Describes the plan of a scene, timed over `steps` steps.
///
/// # Errors
/// A scene that cannot run.
pub fn view(named: &LoadedScene, pool: &Pool, steps: u32) -> Result<PlanView, Failure> {
    let scene = &named.checked()?;
    let plan = Plan::of(scene);
    let requirements = Requirements::of(scene);
    let used = requirements.bytes();
    let [by_plan, by_everything] = time(named, pool, steps)?;
    let passes = plan.passes().map(|p| PassView { name: p.name(), terms: plan.terms(p).into_iter().collect() });
    let bytes_of = |what: &str| bytes_saved(scene, &requirements, what);
    let left_out = plan.left_out();
    let left_out = left_out.iter().map(|l| LeftOutView { what: l.what, why: l.why, bytes: bytes_of(l.what) });
    Ok(PlanView {
        scene: named.name.clone(),
        particles: requirements.counts.particles,
        formulas: Nearest::of(&scene.model),
        passes: passes.collect(),
        commands: plan.schedule().iter().map(|command| in_words(*command)).collect(),
        left_out: left_out.collect(),
        bytes: Bytes { used, everything: everything(scene, &requirements) },
        arrays: arrays(&requirements),
        ms_per_step: PlanTimes { plan: by_plan.min, everything: by_everything.min },
        median_ms_per_step: PlanTimes { plan: by_plan.median, everything: by_everything.median },
    })
}

/// Describes a command of a step.
fn in_words(command: Command) -> String {
    match command {
        Command::Run(pass) => pass.name().into(),
        Command::RunAgain(pass) => format!("{}, with the velocities at the end of the step", pass.name()),
        Command::Gather { from: (from, _), to } if from == to => format!("gather {}", to.name()),
        Command::Gather { from: (from, _), to } => format!("gather {} from {}", to.name(), from.name()),
        Command::Validate(array) => format!("validate {}", array.name()),
        Command::Repeat { commands, most } => {
            format!("repeat the next {commands} commands until the pressure has converged, at most {most} times")
        }
    }
}

/// Returns the allocated arrays with their sizes.
pub(crate) fn arrays(requirements: &Requirements) -> Vec<ArrayView> {
    let all = Array::ALL.iter().map(|&array| ArrayView { name: array.name(), bytes: requirements.bytes_of(array) });
    all.filter(|array| array.bytes > 0).collect()
}

/// Returns the memory that a part that is left out would take, bytes.
fn bytes_saved(scene: &Checked<'_>, requirements: &Requirements, what: &str) -> usize {
    let mut model = *requirements.model();
    if let Some((_, include)) = OPTIONAL.iter().find(|(name, _)| *name == what) {
        include(&mut model);
    }
    with(scene, requirements, model).bytes().saturating_sub(requirements.bytes())
}

/// Includes an optional part in a model.
type Include = fn(&mut Model);
const OPTIONAL: &[(&str, Include)] = &[
    ("cell lists", |m| m.cell_places = m.cell_places.max(USUAL_PLACES)),
    ("XSPH", |m| m.has_xsph = 1),
    ("shifting", |m| m.shifting = FICKIAN),
    ("tensile control", |m| m.has_tensile_control = 1),
    ("renormalised gradients", |m| m.has_tensile_control = 1),
    ("internal energy", |m| m.has_internal_energy = 1),
    ("variable support", |m| m.has_variable_support = 1),
    ("pressure correction", |m| m.pressure_solver = PRESSURE_CORRECTION),
    ("kernel tables", |m| m.evaluation = TABLE),
    ("normals", |m| m.has_normals = 1),
    ("elasticity", |m| m.has_springs = 1),
    ("plasticity", |m| (m.has_springs, m.is_plastic) = (1, 1)),
    ("air", |m| m.has_air = 1),
];

/// Returns the requirements of the scene with another model.
fn with(scene: &Checked<'_>, requirements: &Requirements, model: Model) -> Requirements {
    let mut counts = requirements.counts;
    if model.has_springs == 1 && counts.spring_ends == 0 {
        counts.spring_ends = ends_if_elastic(scene);
    }
    Requirements::by_model(model, counts)
}

/// Returns the number of spring ends that the scene would have if all of its fluids were elastic; 0 if such a scene is
/// invalid.
fn ends_if_elastic(scene: &Scene) -> usize {
    let mut elastic = scene.clone();
    let air = scene.air.map(|air| air.fluid);
    let fluids = elastic.fluids.iter_mut();
    for (_, fluid) in (0..).zip(fluids).filter(|(number, _)| Some(*number) != air) {
        fluid.elastic_stiffness = 1.0;
    }
    elastic.check().map_or(0, |elastic| elastic.derived().spring_ends)
}

/// Returns the memory of a scene with everything included that this version can leave out, bytes.
fn everything(scene: &Checked<'_>, requirements: &Requirements) -> usize {
    let mut model = Plan::everything(scene).model;
    for (_, include) in OPTIONAL {
        include(&mut model);
    }
    with(scene, requirements, model).bytes()
}

/// Times the two plans alternately, so that slow phases of the machine affect both equally.
fn time(named: &LoadedScene, pool: &Pool, steps: u32) -> Result<[Milliseconds; 2], Failure> {
    let scene = &named.checked()?;
    let plans = [Plan::of(scene), Plan::everything(scene)];
    let mut heaps = plans.map(|plan| OwnedMemory::with(&Requirements::by_plan(scene, &plan)));
    let mut times = [Vec::new(), Vec::new()];
    let mut solvers = Vec::new();
    for (heap, plan) in heaps.iter_mut().zip(plans) {
        let count = scene.derived().particles();
        let solver = Solver::with_particles(scene, plan, count, scene.initial_particles(), heap.lend());
        solvers.push(solver.map_err(|error| Failure::Scene { origin: named.name.clone(), error })?);
    }
    for _ in 0..steps {
        for (solver, times) in solvers.iter_mut().zip(&mut times) {
            let (result, ms) = timed(|| solver.step(pool));
            result?;
            times.push(ms);
        }
    }
    Ok(times.map(|times| Milliseconds::of(&times)))
}

/// Formats the plan as text.
#[must_use]
pub fn table(view: &PlanView) -> String {
    let mut out = format!("{}\n{}\n", view.scene, view.formulas.words());
    for pass in &view.passes {
        out += &format!("  {:22} {}\n", pass.name, pass.terms.join(", "));
    }
    out += "commands of a step\n";
    for command in &view.commands {
        out += &format!("  {command}\n");
    }
    out += "left out\n";
    for left_out in &view.left_out {
        out += &format!("  {:22} {} ({} bytes)\n", left_out.what, left_out.why, left_out.bytes);
    }
    out += "arrays\n";
    for array in &view.arrays {
        out += &format!("  {:22} {} bytes\n", array.name, array.bytes);
    }
    let (bytes, ms) = (view.bytes, view.ms_per_step);
    let particles = view.particles.max(1);
    out += &format!(
        "bytes: {} used ({:.0} per particle), {} with everything\n",
        bytes.used,
        bytes.used as f64 / particles as f64,
        bytes.everything
    );
    if ms.plan > 0.0 {
        out += &format!("ms per step, minimum: {:.3} with the plan, {:.3} with everything\n", ms.plan, ms.everything);
    }
    out
}
