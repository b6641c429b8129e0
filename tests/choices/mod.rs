//! Every choice that a scene can make, one at a time against the defaults. The scenes are made from the lists of the
//! choices themselves.
#![allow(unreachable_pub, reason = "a module of a test")]
mod closed_walls;
mod fluids;
mod formulas;
mod plainest;
mod solids;
mod surroundings;
mod time;
mod turnover;

use millpond::check::matrix::scenes;
use millpond_core::scene::Scene;
pub use plainest::plainest;
pub use scenes::base;

/// A callback that takes a name and a change of the scene.
type Add<'a> = &'a mut dyn FnMut(String, &dyn Fn(&mut Scene));

/// Returns every choice, one at a time, with its name.
pub fn choices(base: &Scene) -> Vec<(String, Scene)> {
    let mut all = vec![("defaults".to_owned(), base.clone())];
    let mut add = |what: String, change: &dyn Fn(&mut Scene)| {
        let mut scene = base.clone();
        change(&mut scene);
        all.push((what, scene));
    };
    formulas::kernels_and_pressure(&mut add);
    formulas::shifting(&mut add);
    formulas::viscosity_and_tension(&mut add);
    time::time(&mut add);
    fluids::fluids(&mut add);
    surroundings::surroundings(&mut add);
    closed_walls::closed_walls(&mut add);
    turnover::turnover(&mut add);
    solids::solid_choices(&mut add);
    all
}
