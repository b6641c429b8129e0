//! `still-tank`: case H2. A tank of water starts at rest, with the density that its weight requires, and must stay at
//! rest.
use super::column::Column;
use super::column::Profile;
use super::enclosure::Enclosure;
use super::flow::{checked, larger, rms_speed, start_with, step, steps_to};
use super::form::{Form, Rules};
use super::hydrostatic::{damped, regular};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use millpond_core::OwnedMemory;
use millpond_core::scene::{DensityDiffusion, DensityForm};

const NAME: &str = "still-tank";

/// Spacing, m, in a full and in a quick study. It divides the width of the tank and the depth of the water.
const SPACING: f32 = 0.02;
const QUICK_SPACING: f32 = 0.025;

/// End of the run, s, and the part at its end over which the largest speed counts, s. The sound wave of the column has
/// a period of 0.4 s, and a single state could be one in which the wave reverses.
const END: f64 = 5.0;
const WINDOW: f64 = 0.5;
const STEPS_PER_SAMPLE: u64 = 10;

/// Required limit: 1 % of the speed of a long wave, `sqrt(g H)` (H is the depth).
const LIMIT: f64 = 0.01;

/// Square of the limit for the coarser spacing. The motion consists of single rows that settle, as fast as by a fall
/// through a share of a row. It is proportional to `sqrt(g dx)`, an error of order 1/2. The speed is 5.7, 5.6, 5.6,
/// 5.7, 5.8, 5.7 and 5.4 % of `sqrt(g dx)` at spacings of 0.05, 0.045, 0.04, 0.036, 0.03, 0.025 and 0.02 m (1.33, 1.25,
/// 1.17, 1.14, 1.07, 0.95 and 0.80 % of the wave's speed), and the limit is 6.7 % of it.
const QUICK_LIMIT_SQUARED: f64 = LIMIT * LIMIT * (QUICK_SPACING / SPACING) as f64;

/// Limit of the change of mean height, over the compression by the weight. If the pressure does not respond to the
/// weight correctly, it has a relative error of about as much.
const SINKING: f64 = 0.05;

/// Compared forms of walls, density and diffusion. The first one has the limits above.
const FORMS: [Rules; 2] = [
    (Enclosure::MIRRORED, DensityForm::Continuity, DensityDiffusion::Off),
    (Enclosure::MIRRORED, DensityForm::Summation, DensityDiffusion::Off),
];

/// The forms that keep still for a minute. The first one has the limits below, and a quick study runs only that one.
const STILL: [Rules; 2] = [
    (Enclosure::CLOSED_FORM, DensityForm::Continuity, DensityDiffusion::Hydrostatic),
    (Enclosure::EXTRAPOLATED, DensityForm::Continuity, DensityDiffusion::Hydrostatic),
];
pub(super) const MINUTE: f64 = 60.0;

/// Required limits after a minute: rms speed over that of a long wave, and error of every layer over the pressure at
/// the floor.
pub(super) const STILL_SPEED: f64 = 0.002;
const STILL_PROFILE: f64 = 0.02;

/// Results of a run.
pub(super) struct Rest {
    /// Largest rms speed at the end of the run, over the speed of a long wave.
    pub(super) speed: f64,
    /// Largest error of a layer in that time, over the pressure at the floor.
    profile: f64,
    /// Particles that are no longer in the tank.
    lost: usize,
    /// Loss of mean height, in spacings.
    sunk: f64,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let (spacing, limit, forms) =
        if context.quick { (QUICK_SPACING, QUICK_LIMIT_SQUARED.sqrt(), 1) } else { (SPACING, LIMIT, FORMS.len()) };
    // The start is regular, and particles do not pair with this kernel: all motion is caused by the walls and the
    // surface.
    let column = regular(spacing);
    let of = |rules: Rules| Form::of(damped(column.model), rules);
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    for (i, form) in FORMS.into_iter().take(forms).map(of).enumerate() {
        match rest(context, &column.with(&form), END) {
            Ok(Rest { speed, profile, lost, sunk }) => {
                if i == 0 {
                    figures.push(Metric::below("rms speed over sqrt(g H)", speed, limit));
                    let moved = sunk * f64::from(column.spacing) / column.compression();
                    figures.push(Metric::below("change of mean height, over compression", moved.abs(), SINKING));
                    figures.push(Metric::below("particles lost", lost as f64, 0.0));
                }
                lines.push(line(&form, END, &Rest { speed, profile, lost, sunk }));
            }
            Err(Failure::Step(error)) if i > 0 => {
                let empty = String::new;
                lines.push([form.name(), END.to_string(), error.to_string(), empty(), empty(), empty()]);
            }
            Err(failure) => return Err(failure),
        }
    }
    for (i, form) in STILL.into_iter().take(forms).map(of).enumerate() {
        let still = rest(context, &column.with(&form), MINUTE)?;
        if i == 0 {
            let of = |what: &str| format!("{what} after {MINUTE} s, {}", form.name());
            figures.push(Metric::below(of("rms speed over sqrt(g H)"), still.speed, STILL_SPEED));
            figures.push(Metric::below(of("largest error of a layer"), still.profile, STILL_PROFILE));
            figures.push(Metric::below(of("particles lost"), still.lost as f64, 0.0));
        }
        lines.push(line(&form, MINUTE, &still));
    }
    let titles = [
        "walls, density, diffusion",
        "end, s",
        "rms speed over sqrt(g H)",
        "largest error of a layer, over rho g H",
        "lost",
        "loss of mean height, spacings",
    ];
    Ok(Outcome::new(NAME, figures, vec![table(titles, lines)]))
}

fn line(form: &Form, end: f64, rest: &Rest) -> [String; 6] {
    let percent = |x: f64| format!("{:.3} %", x * 100.0);
    [
        form.name(),
        end.to_string(),
        percent(rest.speed),
        percent(rest.profile),
        rest.lost.to_string(),
        format!("{:.2}", rest.sunk),
    ]
}

/// Watches the tank until `end`, s.
pub(super) fn rest(context: &Context, column: &Column, end: f64) -> Result<Rest, Failure> {
    let scene = column.scene();
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let start = Column::mean_height(&solver);
    let (mut speed, mut profile) = (0.0f64, Profile::default());
    step(NAME, context, &mut solver, steps_to(&scene, end), STEPS_PER_SAMPLE, |solver| {
        if solver.time() > end - WINDOW {
            speed = speed.max(rms_speed(solver));
            profile.add(solver);
        }
    })?;
    Ok(Rest {
        speed: speed / column.wave_speed(),
        profile: profile
            .every_layer(column)
            .iter()
            .map(|layer| layer.map_or(f64::NAN, |layer| column.off(&layer).abs()))
            .fold(0.0, larger),
        lost: column.lost(&solver),
        sunk: (start - Column::mean_height(&solver)) / f64::from(column.spacing),
    })
}
