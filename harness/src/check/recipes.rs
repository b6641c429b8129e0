//! `recipes`: each recipe for a kind of flow, without any change, on the reference cases of that kind. Walls are planes
//! in closed form.
use super::cases::{
    Case, channel, dam_break, sliding_wall, standing_wave, tank_for_a_minute, tank_settles, two_fluids, vortices,
};
use super::enclosure::Enclosure;
use super::form::Form;
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use millpond_core::scene::{Formulation, Recipe};

const NAME: &str = "recipes";

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    // a quick study leaves out what takes longest
    let long = |case: Case| if context.quick { vec![] } else { vec![case] };
    let cases: [(Recipe, Vec<Case>); 7] = [
        (Recipe::FreeSurface, vec![tank_settles(), standing_wave()]),
        (Recipe::FreeSurface, long(tank_for_a_minute())),
        (Recipe::Impact, vec![tank_settles()]),
        (Recipe::Impact, long(dam_break())),
        (Recipe::ClosedBox, vec![vortices()]),
        (Recipe::Viscous, vec![channel(), sliding_wall()]),
        (Recipe::SeveralFluids, vec![two_fluids()]),
    ];
    let mut figures = Vec::new();
    for (recipe, cases) in cases {
        let form = Form { walls: Enclosure::CLOSED_FORM, model: Formulation::of(recipe) };
        for case in cases {
            let name = format!("{}, {}: {}", recipe.name(), case.name, case.error);
            figures.push(Metric::below(name, case.error_of(context, &form)?, case.limit));
        }
    }
    Ok(Outcome::new(NAME, figures, Vec::new()))
}
