//! The recipe that a formulation is nearest to.
use millpond_core::scene::{Formulation, Recipe};
use serde::Serialize;
use serde_json::{Map, Value};

/// A recipe, and the fields of the formulation in which a scene differs from it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Nearest {
    /// Name of the recipe.
    pub recipe: &'static str,
    /// Names of the fields.
    pub differs_in: Vec<String>,
}

impl Nearest {
    /// Returns the recipe that differs in the fewest fields, the first one of several.
    #[must_use]
    pub fn of(model: &Formulation) -> Nearest {
        let own = fields(model);
        let all = Recipe::ALL.iter().map(|recipe| {
            let other = fields(&Formulation::of(*recipe));
            let differs = own.iter().filter(|(name, value)| other.get(*name) != Some(value));
            Nearest { recipe: recipe.name(), differs_in: differs.map(|(name, _)| name.clone()).collect() }
        });
        let first = Nearest { recipe: Recipe::default().name(), differs_in: own.keys().cloned().collect() };
        all.fold(first, |best, next| if next.differs_in.len() < best.differs_in.len() { next } else { best })
    }

    /// Returns it in words.
    #[must_use]
    pub fn words(&self) -> String {
        match self.differs_in.as_slice() {
            [] => format!("recipe: {}", self.recipe),
            fields => format!("nearest recipe: {}, but for {}", self.recipe, fields.join(", ")),
        }
    }
}

fn fields(model: &Formulation) -> Map<String, Value> {
    match serde_json::to_value(model) {
        Ok(Value::Object(fields)) => fields,
        _ => Map::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::Nearest;
    use millpond_core::scene::{Formulation, Recipe};

    #[test]
    fn every_recipe_is_nearest_to_itself() {
        for &recipe in Recipe::ALL {
            let same = Nearest::of(&Formulation::of(recipe));
            assert_eq!(same, Nearest { recipe: recipe.name(), differs_in: Vec::new() });
            let other = Nearest::of(&Formulation { heat_gain: 0.5, ..Formulation::of(recipe) });
            assert_eq!(other.words(), format!("nearest recipe: {}, but for heat_gain", recipe.name()));
        }
    }
}
