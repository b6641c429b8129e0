//! `evidence-surface` and its like: every kind of walls with every density, diffusion of density and shifting that goes
//! with it, on the reference cases: error against run time. The recipes rest on these tables.
use super::cases::{
    Case, channel, coarse_dam_break, coarse_tank_for_a_minute, fine_vortices, sliding_wall, standing_wave,
    tank_settles, two_fluids, vortices,
};
use super::enclosure::Enclosure;
use super::form::Form;
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table_of;
use crate::output::progress;
use millpond_core::scene::{DensityDiffusion, DensityForm, Formulation, PressureForce, Recipe, Shifting};
use std::time::Instant;

/// A density, its diffusion, and a shifting.
type Sums = (DensityForm, DensityDiffusion, Shifting);

/// What goes with one fluid.
const ONE_FLUID: [Sums; 8] = [
    (DensityForm::Summation, DensityDiffusion::Off, Shifting::Off),
    (DensityForm::Summation, DensityDiffusion::Off, Shifting::Fickian),
    (DensityForm::Continuity, DensityDiffusion::Off, Shifting::Off),
    (DensityForm::Continuity, DensityDiffusion::Plain, Shifting::Off),
    (DensityForm::Continuity, DensityDiffusion::Hydrostatic, Shifting::Off),
    (DensityForm::Continuity, DensityDiffusion::Hydrostatic, Shifting::Fickian),
    (DensityForm::Continuity, DensityDiffusion::Renormalised, Shifting::Off),
    (DensityForm::Continuity, DensityDiffusion::Renormalised, Shifting::Fickian),
];

/// What goes with a domain that the fluid fills, besides.
const FILLED: [Sums; 2] = [
    (DensityForm::Summation, DensityDiffusion::Off, Shifting::TransportVelocity),
    (DensityForm::Continuity, DensityDiffusion::Hydrostatic, Shifting::TransportVelocity),
];

/// What goes with several fluids.
const SEVERAL_FLUIDS: [Sums; 5] = [
    (DensityForm::Summation, DensityDiffusion::Off, Shifting::Off),
    (DensityForm::SummationAdapted, DensityDiffusion::Off, Shifting::Off),
    (DensityForm::ContinuityAdapted, DensityDiffusion::Off, Shifting::Off),
    (DensityForm::ContinuityAdapted, DensityDiffusion::Hydrostatic, Shifting::Off),
    (DensityForm::ContinuityAdapted, DensityDiffusion::Hydrostatic, Shifting::Fickian),
];

const WALLS: [Enclosure; 5] =
    [Enclosure::PENALTY, Enclosure::MIRRORED, Enclosure::DYNAMIC, Enclosure::EXTRAPOLATED, Enclosure::CLOSED_FORM];

/// A periodic domain has no walls of any kind.
const NO_WALLS: Enclosure = Enclosure::CLOSED_FORM;

/// Errors beyond this are those of a fluid that has left its place.
const LOST: f64 = 1000.0;

/// Result of a form in a case: error and wall time per simulated second, s.
type Cell = Result<(f64, f64), Failure>;

/// A liquid with a free surface.
pub(super) fn of_surfaces(context: &Context) -> Result<Outcome, Failure> {
    let cases = [tank_settles(), coarse_tank_for_a_minute(), standing_wave(), coarse_dam_break()];
    study(context, "evidence-surface", Recipe::FreeSurface, &cases, &WALLS, &ONE_FLUID)
}

/// A fluid that fills its domain, which is periodic.
pub(super) fn of_filled_domains(context: &Context) -> Result<Outcome, Failure> {
    let sums = [&ONE_FLUID[..], &FILLED].concat();
    study(context, "evidence-filled", Recipe::ClosedBox, &[vortices(), fine_vortices()], &[NO_WALLS], &sums)
}

/// A viscous fluid.
pub(super) fn of_friction(context: &Context) -> Result<Outcome, Failure> {
    let cases = [channel(), sliding_wall()];
    study(context, "evidence-friction", Recipe::Viscous, &cases, &WALLS, &ONE_FLUID)
}

/// Two fluids.
pub(super) fn of_two_fluids(context: &Context) -> Result<Outcome, Failure> {
    study(context, "evidence-fluids", Recipe::SeveralFluids, &[two_fluids()], &WALLS, &SEVERAL_FLUIDS)
}

/// Runs all forms that differ from a recipe in walls and sums on some cases. The recipe, with walls in closed form,
/// must give a result; its limits are those of the study `recipes`, whose cases are finer.
#[expect(clippy::unnecessary_wraps, reason = "a study returns a result")]
fn study(
    context: &Context,
    name: &str,
    recipe: Recipe,
    cases: &[Case],
    walls: &[Enclosure],
    sums: &[Sums],
) -> Result<Outcome, Failure> {
    let model = Formulation::of(recipe);
    let forms: Vec<Form> =
        walls.iter().flat_map(|walls| sums.iter().map(move |sums| form(model, *walls, *sums))).collect();
    let (mut figures, mut cells) = (Vec::new(), Vec::new());
    for case in cases {
        let bar = progress(&format!("{name}, {}", case.name), forms.len() as u64);
        let measure = |form| {
            bar.inc(1);
            measured(context, case, form)
        };
        let results: Vec<Cell> = forms.iter().map(measure).collect();
        let own = forms.iter().zip(&results).find(|(form, _)| is_of(form, recipe));
        let works = own.is_some_and(|(_, result)| result.as_ref().is_ok_and(|(error, _)| error.is_finite()));
        let name = format!("{}, {}: runs without a result", recipe.name(), case.name);
        figures.push(Metric::below(name, f64::from(u8::from(!works)), 0.0));
        cells.push(in_words(case, &results));
    }
    Ok(Outcome::new(name, figures, vec![of_forms(cases, &forms, &cells)]))
}

/// Returns the form of a model with these walls and sums.
fn form(model: Formulation, walls: Enclosure, (density, density_diffusion, shifting): Sums) -> Form {
    let classic = density == DensityForm::Summation && model.pressure_force == PressureForce::DensityWeighted;
    let pressure_force = if classic { PressureForce::Monaghan } else { model.pressure_force };
    // the two go together
    let tensile_control = shifting == Shifting::Fickian && model.negative_pressure;
    Form {
        walls,
        model: Formulation { density, density_diffusion, shifting, tensile_control, pressure_force, ..model },
    }
}

/// Returns whether a form is a recipe with walls in closed form.
fn is_of(form: &Form, recipe: Recipe) -> bool {
    form.walls == Enclosure::CLOSED_FORM && form.model == Formulation::of(recipe)
}

fn measured(context: &Context, case: &Case, form: &Form) -> Cell {
    let start = Instant::now();
    let error = case.error_of(context, form)?;
    Ok((error, start.elapsed().as_secs_f64() / case.seconds))
}

/// Returns the results of a case as text. A star marks the front: no other form is better in both error and time.
fn in_words(case: &Case, results: &[Cell]) -> Vec<String> {
    let all = || results.iter().filter_map(|result| result.as_ref().ok());
    let word = |result: &Cell| match result {
        Ok((error, _)) if error.is_nan() => "no result".into(),
        Ok((error, _)) if *error > LOST => "lost".into(),
        Ok((error, time)) => {
            let front = !all().any(|(e, t)| e <= error && t <= time && (e, t) != (error, time));
            let percent = case.limit < 1.0;
            let error = if percent { format!("{:.2} %", error * 100.0) } else { format!("{error:.2}") };
            format!("{error} in {time:.2} s{}", if front { " *" } else { "" })
        }
        Err(Failure::Scene { .. }) => "refused".into(),
        Err(_) => "fails".into(),
    };
    results.iter().map(word).collect()
}

/// Returns the table of forms, with a column for each case.
fn of_forms(cases: &[Case], forms: &[Form], cells: &[Vec<String>]) -> String {
    let columns = |i: usize| cells.iter().map(move |column| column[i].clone());
    let lines = forms.iter().enumerate().map(|(i, form)| std::iter::once(form.name()).chain(columns(i)).collect());
    let titles = std::iter::once("walls, density, diffusion, shifting").chain(cases.iter().map(|case| case.name));
    let errors: Vec<String> = cases.iter().map(|case| format!("- {}: {}", case.name, case.error)).collect();
    let rows = table_of(&titles.collect::<Vec<_>>(), lines.collect::<Vec<Vec<String>>>());
    format!("Errors, and wall time per simulated second; a star marks the front.\n\n{}\n\n{rows}", errors.join("\n"))
}
