//! The reference cases at resolutions that take seconds, each as one error: what `recipes`,
//! `other-forms` and the tables of evidence run forms on.
use super::flow::larger;
use super::form::Form;
use super::taylor_green::{Packed, Start};
use super::{Context, channel, hydrostatic, impact, standing_wave, still_tank, taylor_green, two_fluids};
use crate::failure::Failure;
use millpond_core::scene::Formulation;
use std::f64::consts::PI;

/// A reference case.
pub(super) struct Case {
    /// Its name in tables.
    pub(super) name: &'static str,
    /// What its error is, in words.
    pub(super) error: &'static str,
    /// The largest error with which a form passes.
    pub(super) limit: f64,
    /// Simulated time of a run, s.
    pub(super) seconds: f64,
    run: fn(&Context, &Form) -> Result<f64, Failure>,
}

impl Case {
    /// Runs a form, and returns its error.
    pub(super) fn error_of(&self, context: &Context, form: &Form) -> Result<f64, Failure> {
        (self.run)(context, form)
    }
}

/// Spacings of the tank that is watched for a minute, m: 27 rows, or 20 where many forms are run.
const MINUTE_SPACING: f32 = 1.0 / 30.0;
const COARSE_MINUTE_SPACING: f32 = 0.045;

/// Number of neighbours of all forms in two dimensions.
const NEIGHBOURS: f32 = 32.0;

pub(super) fn tank_settles() -> Case {
    Case {
        name: "tank settles",
        error: "largest error of any layer's pressure, over that at the floor",
        limit: hydrostatic::QUICK_LIMIT,
        seconds: hydrostatic::END,
        run: |context, form| {
            let column = hydrostatic::regular(hydrostatic::QUICK_SPACING).with(&at_rest(form));
            Ok(hydrostatic::settle(context, &column)?.every)
        },
    }
}

pub(super) fn tank_for_a_minute() -> Case {
    Case {
        name: "tank for a minute",
        error: "rms speed at the end, over sqrt(g H)",
        limit: still_tank::STILL_SPEED,
        seconds: still_tank::MINUTE,
        run: |context, form| minute(context, form, MINUTE_SPACING),
    }
}

pub(super) fn coarse_tank_for_a_minute() -> Case {
    Case { run: |context, form| minute(context, form, COARSE_MINUTE_SPACING), ..tank_for_a_minute() }
}

fn minute(context: &Context, form: &Form, spacing: f32) -> Result<f64, Failure> {
    let column = hydrostatic::regular(spacing).with(&at_rest(form));
    Ok(still_tank::rest(context, &column, still_tank::MINUTE)?.speed)
}

pub(super) fn standing_wave() -> Case {
    Case {
        name: "standing wave",
        error: "numerical viscosity over its limit, or error of the period over its limit, the larger one",
        limit: 1.0,
        seconds: standing_wave::QUICK_PERIODS * 2.0 * PI / standing_wave::frequency(),
        run: |context, form| {
            let (spacing, periods) = (standing_wave::QUICK_SPACING, standing_wave::QUICK_PERIODS);
            let wave = standing_wave::swing(context, spacing, periods, &at_rest(form))?;
            let (damping, period) =
                (wave.viscosity / standing_wave::QUICK_VISCOSITY, wave.period / standing_wave::PERIOD);
            // a wave that grows has a negative viscosity
            Ok(larger(damping.abs(), period.abs()))
        },
    }
}

pub(super) fn dam_break() -> Case {
    Case {
        name: "dam break",
        error: "error of the arrival at the three lower sensors, the largest",
        limit: impact::COARSE_ARRIVAL,
        seconds: impact::END * impact::unit_of_time(),
        run: |context, form| arrival(context, form, impact::ACROSS[0]),
    }
}

pub(super) fn coarse_dam_break() -> Case {
    Case { run: |context, form| arrival(context, form, impact::QUICK_ACROSS), ..dam_break() }
}

fn arrival(context: &Context, form: &Form, across: f32) -> Result<f64, Failure> {
    let (seen, _) = impact::fall(context, across, &at_rest(form))?;
    let real = impact::experiment()?;
    let off = seen.iter().zip(&real).take(3).map(|(seen, real)| (seen.arrival / real.arrival - 1.0).abs());
    Ok(off.fold(0.0, larger))
}

pub(super) fn vortices() -> Case {
    Case {
        name: "vortices",
        error: "error of the decay rate, 50 x 50 particles from a lattice",
        limit: taylor_green::LIMIT,
        seconds: taylor_green::FIT[1],
        run: |context, form| {
            let packed = Packed { model: form.model, looser: 1.0, neighbours: NEIGHBOURS };
            Ok(taylor_green::decay(context, taylor_green::QUICK_SIDE, &packed, Start::Lattice)?.rate.abs())
        },
    }
}

pub(super) fn fine_vortices() -> Case {
    Case {
        name: "fine vortices",
        error: "error of the decay rate, 100 x 100 particles from a lattice",
        run: |context, form| {
            let packed = Packed { model: form.model, looser: 1.0, neighbours: NEIGHBOURS };
            Ok(taylor_green::decay(context, taylor_green::SIDE, &packed, Start::Lattice)?.rate.abs())
        },
        ..vortices()
    }
}

pub(super) fn channel() -> Case {
    Case {
        name: "channel",
        error: "error of the profile, driven by a force, over the largest speed",
        limit: channel::LIMIT,
        seconds: channel::LAST,
        run: |context, form| channel::poiseuille_error(context, form, NEIGHBOURS),
    }
}

pub(super) fn sliding_wall() -> Case {
    Case {
        name: "sliding wall",
        error: "error of the profile, driven by a wall, over the largest speed",
        run: |context, form| channel::couette_error(context, form, NEIGHBOURS),
        ..channel()
    }
}

pub(super) fn two_fluids() -> Case {
    Case {
        name: "two fluids",
        error: "of their errors at rest, ratio 1 : 10, over their limits, the largest",
        limit: 1.0,
        seconds: two_fluids::CASES[1].end,
        run: |context, form| {
            let case = two_fluids::CASES[1];
            // the time to which the run time refers, in a quick study too
            let case = two_fluids::Case { quick_end: case.end, ..case };
            let rest = two_fluids::rest(context, two_fluids::QUICK_SIDE, case, &at_rest(form), NEIGHBOURS)?;
            let misses = rest.figures().into_iter().map(|figure| match figure.limit {
                // particles beyond the interface: none may be there
                0.0 if figure.value == 0.0 => 0.0,
                0.0 => 1.0 + figure.value,
                limit => figure.value / limit,
            });
            Ok(misses.fold(0.0, larger))
        },
    }
}

/// Returns the form with the start of a fluid at rest.
fn at_rest(form: &Form) -> Form {
    Form { model: Formulation { initialize_hydrostatic: true, ..form.model }, ..*form }
}
