//! `hydrostatic`: the catalogue's case H1. A tank of water settles, and its pressure must be the weight of what is above.
use super::column::{Column, Miss, Profile};
use super::flow::{checked, start_with, step, steps_to};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::scene::{DensityForm, Viscosity, WallPressure, Wind};

const NAME: &str = "hydrostatic";

/// m; between the catalogue's middle and finest level.
const SPACING: f32 = 0.0125;
const QUICK_SPACING: f32 = 0.02;

/// Still air that takes the waves out of the water, 1/s: the state at rest does not feel it, and the sound of letting the
/// water go, a period of 0.4 s, is gone long before the profile is taken.
const DRAG: f32 = 10.0;

/// Artificial viscosity, for what is too small for the drag.
const ALPHA: f32 = 0.1;

/// When it has settled and when it ends, s.
const SETTLED: f64 = 2.0;
const END: f64 = 3.0;

/// Steps between two samples of the mean.
const STEPS_PER_SAMPLE: u64 = 5;

/// Of the issue: 2 % of the pressure at the floor, in every layer but the two at the floor and at the surface.
const LIMIT: f64 = 0.02;

/// The same number of rows' weight where rows are thicker. The worst layer is the third one from the surface, whose kernel
/// still reaches out of the water: it is off by 0.9 to 1.0 of the weight of one row at spacings of 0.03, 0.025, 0.02, 0.018, 0.015
/// and 0.0125 m (2.95, 2.54, 2.21, 2.02, 1.49 and 1.27 % of the pressure at the floor), which is an error of the first order.
const QUICK_LIMIT: f64 = LIMIT * (QUICK_SPACING / SPACING) as f64;

/// What varies: the forms that a wall and the density can have. The first has the limit; the others are
/// there to be compared with it, unless it has to be quick.
const FORMS: [(WallPressure, DensityForm); 4] = [
    (WallPressure::Mirrored, DensityForm::Summation),
    (WallPressure::Dynamic, DensityForm::Summation),
    (WallPressure::Mirrored, DensityForm::Continuity),
    (WallPressure::Dynamic, DensityForm::Continuity),
];
const LIMITED: usize = 1;

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let (spacing, limit, forms) =
        if context.quick { (QUICK_SPACING, QUICK_LIMIT, LIMITED) } else { (SPACING, LIMIT, FORMS.len()) };
    let column = Column::of_catalogue(spacing);
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    for (i, (wall, density)) in FORMS.into_iter().take(forms).enumerate() {
        let result = settle(context, &column, wall, density);
        let name = format!("{}, {}", wall.name(), density.name());
        let words = match (&result, i < LIMITED) {
            // what has no limit may fail: that is what the note is there to say
            (Err(Failure::Step(error)), false) => [error.to_string(), String::new()],
            (Ok((miss, sunk)), _) => {
                let percent = |x: f64| format!("{:.2} %", x * 100.0);
                [format!("{}, rms {}", percent(miss.largest), percent(miss.rms)), percent(*sunk)]
            }
            (Err(_), _) => [String::new(), String::new()],
        };
        let [off, sunk] = words;
        lines.push([name.clone(), off, sunk]);
        match result {
            Ok((miss, _)) if i < LIMITED => {
                figures.push(Metric::below(format!("pressure off by, {name}"), miss.largest, limit));
            }
            Ok(_) => {}
            Err(Failure::Step(_)) if i >= LIMITED => {}
            Err(failure) => return Err(failure),
        }
    }
    let titles = ["walls, density", "largest miss of a layer, over rho g H", "sunk, over the mean height"];
    Ok(Outcome::new(NAME, figures, vec![table(titles, lines)]))
}

/// How far the profile is off, and how far the water sank, as a share of its mean height.
fn settle(
    context: &Context,
    column: &Column,
    wall: WallPressure,
    density: DensityForm,
) -> Result<(Miss, f64), Failure> {
    let mut scene = column.scene();
    scene.model.wall_pressure = wall;
    scene.model.density = density;
    scene.model.initialize_hydrostatic = true;
    scene.model.viscosity = Viscosity::Artificial;
    scene.model.alpha = ALPHA;
    scene.model.beta = 0.0;
    scene.wind = Some(Wind { velocity: Vec3::ZERO, drag: DRAG });
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let title = format!("{NAME} {}", wall.name());
    let mut profile = Profile::default();
    step(&title, context, &mut solver, steps_to(&scene, END), STEPS_PER_SAMPLE, |solver| {
        if solver.time() > SETTLED {
            profile.add(solver);
        }
    })?;
    let full = f64::from(column.depth) / 2.0;
    Ok((profile.miss(column), 1.0 - Column::mean_height(&solver) / full))
}
