//! `still-tank`: the catalogue's case H2. A tank that starts at rest, in the density that its weight asks for, stays so.
use super::column::Column;
use super::flow::{checked, rms_speed, start_with, step, steps_to};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use millpond_core::OwnedMemory;
use millpond_core::scene::{DensityForm, Kernel, Viscosity};

const NAME: &str = "still-tank";

/// m: whole shares of the tank's width and of the water's depth.
const SPACING: f32 = 0.02;
const QUICK_SPACING: f32 = 0.025;

/// Artificial viscosity; with the support radius in place of Monaghan's h it is twice his 0.1. It ends the trembling of
/// single rows; the slow sound of the whole column it leaves alone.
const ALPHA: f32 = 0.1;

/// s, and the part at its end over which the largest speed counts: the sound of the column has a period of 0.4 s, and a
/// single state might show it just turning round.
const END: f64 = 5.0;
const WINDOW: f64 = 0.5;
const STEPS_PER_SAMPLE: u64 = 10;

/// Of the issue: 1 % of the speed of a long wave, `sqrt(g H)`.
const LIMIT: f64 = 0.01;

/// Its square for the coarser spacing. What moves are single rows that fall into place, as fast as a fall through a share of a
/// row: by `sqrt(g dx)`, an error of order 1/2. The speed is 5.7, 5.6, 5.6, 5.7, 5.8, 5.7 and 5.4 % of that at spacings of 0.05,
/// 0.045, 0.04, 0.036, 0.03, 0.025 and 0.02 m (1.33, 1.25, 1.17, 1.14, 1.07, 0.95 and 0.80 % of the wave's), and the limit is 6.7 %
/// of it.
const QUICK_LIMIT_SQUARED: f64 = LIMIT * LIMIT * (QUICK_SPACING / SPACING) as f64;

/// By how much the water may sink or rise, over what its weight compresses it by. A pressure that does not answer to the weight
/// as it must is off by about as much of itself.
const SINKING: f64 = 0.05;

/// The first one has limits; a quick study has no other.
const FORMS: [DensityForm; 2] = [DensityForm::Continuity, DensityForm::Summation];

/// What a run came to.
struct Rest {
    /// Largest rms speed of the window, over that of a wave.
    speed: f64,
    /// Particles that are not in the tank any more.
    lost: usize,
    /// How far the water sank, in spacings.
    sunk: f64,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    // an even start and a kernel that does not pair: what moves is what the walls and the surface do
    let kernel = (Kernel::WendlandC2, 32.0);
    let (spacing, limit, forms) =
        if context.quick { (QUICK_SPACING, QUICK_LIMIT_SQUARED.sqrt(), 1) } else { (SPACING, LIMIT, FORMS.len()) };
    let column = Column { kernel, jitter: 0.0, ..Column::of_catalogue(spacing) };
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    for (i, density) in FORMS.into_iter().take(forms).enumerate() {
        match rest(context, &column, density) {
            Ok(Rest { speed, lost, sunk }) => {
                if i == 0 {
                    figures.push(Metric::below("rms speed over sqrt(g H)", speed, limit));
                    let moved = sunk * f64::from(column.spacing) / column.compression();
                    figures.push(Metric::below("mean height moved, over its compression", moved.abs(), SINKING));
                    figures.push(Metric::below("particles lost", lost as f64, 0.0));
                }
                let speed = format!("{:.3} %", speed * 100.0);
                lines.push([density.name().into(), speed, lost.to_string(), format!("{sunk:.2}")]);
            }
            Err(Failure::Step(error)) if i > 0 => {
                lines.push([density.name().into(), error.to_string(), String::new(), String::new()]);
            }
            Err(failure) => return Err(failure),
        }
    }
    let titles = ["density", "rms speed over sqrt(g H)", "lost", "mean height sunk, spacings"];
    Ok(Outcome::new(NAME, figures, vec![table(titles, lines)]))
}

fn rest(context: &Context, column: &Column, density: DensityForm) -> Result<Rest, Failure> {
    let mut scene = column.scene();
    scene.model.density = density;
    scene.model.initialize_hydrostatic = true;
    scene.model.viscosity = Viscosity::Artificial;
    scene.model.alpha = ALPHA;
    scene.model.beta = 0.0;
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let start = Column::mean_height(&solver);
    let mut speed = 0.0f64;
    step(NAME, context, &mut solver, steps_to(&scene, END), STEPS_PER_SAMPLE, |solver| {
        if solver.time() > END - WINDOW {
            speed = speed.max(rms_speed(solver));
        }
    })?;
    Ok(Rest {
        speed: speed / column.wave_speed(),
        lost: column.lost(&solver),
        sunk: (start - Column::mean_height(&solver)) / f64::from(column.spacing),
    })
}
