//! Axes of a map: what varies, the values that it takes, and how a value is set in a scene.
use crate::failure::Failure;
use crate::overrides::with;
use crate::scene_file::SceneFile;
use glam::Vec3;
use millpond_core::scene::{EquationOfState, Fluid, Integrator, Scene, Viscosity};
use serde::Serialize;

/// Name of the axis of time steps.
pub(super) const TIME_STEP: &str = "time_step";

/// A parameter that varies.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Axis {
    /// A short name, or a field as `--set` takes it.
    pub name: String,
    /// Its values as they were given.
    pub values: Vec<String>,
}

/// A value for each axis, as pairs of name and value.
pub(super) type Choice = Vec<(String, String)>;

/// How a value is set in a scene.
enum AxisSetter {
    /// A field is set, as by `--set`.
    Field(&'static str),
    /// A field is set, if the scene uses it.
    FieldIf(&'static str, fn(&Scene) -> Result<(), &'static str>),
    /// A number is set in several fields.
    Number(fn(&mut Scene, f32)),
    /// A number is set in several fields, if the scene uses them.
    NumberIf(fn(&mut Scene, f32) -> Result<(), &'static str>),
}

/// An axis that has a short name.
struct KnownAxis {
    name: &'static str,
    /// Title in a picture.
    title: &'static str,
    /// Its values if none are given.
    values: fn() -> Vec<String>,
    way: AxisSetter,
}

/// The axes that have short names, in the order in which their values are set: the density ratio must follow the speed
/// of sound, on which it depends.
const KNOWN: &[KnownAxis] = &[
    KnownAxis {
        name: "integrator",
        title: "integrator",
        values: integrators,
        way: AxisSetter::Field("model.integrator"),
    },
    KnownAxis {
        name: "equation_of_state",
        title: "equation of state",
        values: equations_of_state,
        way: AxisSetter::FieldIf("model.equation_of_state", has_equation_of_state),
    },
    KnownAxis {
        name: "average_neighbours",
        title: "particles per support",
        values: || words("16,24,32,48,64"),
        way: AxisSetter::Number(average_neighbours),
    },
    KnownAxis {
        name: "speed_of_sound",
        title: "speed of sound, m/s",
        values: || words("10,30,100,300,1500"),
        way: AxisSetter::NumberIf(speed_of_sound),
    },
    KnownAxis {
        name: "stiffness",
        title: "stiffness k, Pa",
        values: || words("1e3,1e4,1e5,1e6,1e7"),
        way: AxisSetter::Number(stiffness),
    },
    KnownAxis {
        name: "viscosity",
        title: "dynamic viscosity, Pa s",
        values: || words("0,1,10,100,1000"),
        way: AxisSetter::NumberIf(viscosity),
    },
    KnownAxis {
        name: "density_ratio",
        title: "density of the second fluid over the first",
        values: || words("1,0.1,0.01,0.001"),
        way: AxisSetter::NumberIf(density_ratio),
    },
    KnownAxis {
        name: "drop_speed",
        title: "drop speed, m/s",
        values: || words("1,5,10,20,50"),
        way: AxisSetter::NumberIf(drop_speed),
    },
    KnownAxis {
        name: TIME_STEP,
        title: "time step, s",
        values: || words("1e-4,3e-4,1e-3,3e-3,1e-2"),
        way: AxisSetter::Field("scene.time_step"),
    },
];

/// Returns a hint that lists the names that may be given without values.
fn alone() -> String {
    let known: Vec<&str> = KNOWN.iter().map(|known| known.name).collect();
    format!("give NAME=VALUE,VALUE, or only the name of one of {}", known.join(", "))
}

fn words(list: &str) -> Vec<String> {
    list.split(',').map(str::to_owned).collect()
}

fn integrators() -> Vec<String> {
    Integrator::ALL.iter().map(|integrator| integrator.name().to_owned()).collect()
}

fn equations_of_state() -> Vec<String> {
    EquationOfState::ALL.iter().map(|equation| equation.name().to_owned()).collect()
}

impl Axis {
    /// Parses `NAME=VALUE,VALUE` or, if the name has default values, `NAME`.
    ///
    /// # Errors
    /// Returns an error if the name or the values are missing, or if a value is given twice.
    pub fn parse(text: &str) -> Result<Axis, Failure> {
        let wrong = |what: &str| Failure::Call(format!("--axis {text}: {what}"));
        let known = || KNOWN.iter().find(|known| known.name == text);
        let (name, values): (&str, Vec<String>) = match text.split_once('=') {
            Some((name, list)) => (name, list.split(',').map(|value| value.trim().to_owned()).collect()),
            None => (text, (known().ok_or_else(|| wrong(&alone()))?.values)()),
        };
        let name = name.trim().strip_prefix("scene.").unwrap_or(name.trim());
        if name.is_empty() || values.iter().any(String::is_empty) {
            return Err(wrong("give NAME=VALUE,VALUE"));
        }
        if let Some(twice) = values.iter().enumerate().find(|(i, value)| values[..*i].contains(value)) {
            return Err(wrong(&format!("the value {} is given twice", twice.1)));
        }
        Ok(Axis { name: name.to_owned(), values })
    }

    /// Returns its title in a picture.
    #[must_use]
    pub fn title(&self) -> &str {
        KNOWN.iter().find(|known| known.name == self.name).map_or(self.name.as_str(), |known| known.title)
    }

    /// Returns whether all its values are numbers.
    #[must_use]
    pub fn is_of_numbers(&self) -> bool {
        self.values.iter().all(|value| value.parse::<f64>().is_ok())
    }
}

/// Parses all axes of a call.
///
/// # Errors
/// Returns the errors of [`Axis::parse`], and an error for an axis that is given twice.
pub(super) fn parse_all(texts: &[String]) -> Result<Vec<Axis>, Failure> {
    let axes = texts.iter().map(|text| Axis::parse(text)).collect::<Result<Vec<_>, _>>()?;
    match axes.iter().enumerate().find(|(i, axis)| axes[..*i].iter().any(|other| other.name == axis.name)) {
        Some((_, twice)) => Err(Failure::Call(format!("--axis {} is given twice", twice.name))),
        None => Ok(axes),
    }
}

/// Returns every combination of values; the last axis varies fastest.
#[must_use]
pub(super) fn choices(axes: &[Axis]) -> Vec<Choice> {
    axes.iter().fold(vec![Choice::new()], |so_far, axis| {
        let with = |choice: &Choice| {
            let choice = choice.clone();
            axis.values.iter().map(move |value| {
                let pair = (axis.name.clone(), value.clone());
                choice.iter().cloned().chain([pair]).collect()
            })
        };
        so_far.iter().flat_map(with).collect::<Vec<Choice>>()
    })
}

/// Returns `file` with the values of a choice set. It does not check whether the scene can run.
///
/// # Errors
/// Returns an error for an unknown field, a value that does not fit, or an axis that the scene does not use.
pub(super) fn choose(file: &SceneFile, choice: &Choice) -> Result<SceneFile, Failure> {
    let order = |name: &str| KNOWN.iter().position(|known| known.name == name);
    let mut sorted: Vec<&(String, String)> = choice.iter().collect();
    // fields without a short name come first
    sorted.sort_by_key(|(name, _)| order(name));
    let mut file = file.clone();
    for (name, value) in sorted {
        let wrong = |what: String| Failure::Call(format!("--axis {name}={value}: {what}"));
        let number = || value.parse().map_err(|_| "the values must be numbers".to_owned());
        match KNOWN.iter().find(|known| known.name == name).map(|known| &known.way) {
            None => {
                let changed = with(&file, name, value).map_err(wrong)?;
                if changed.scene == file.scene && changed != file {
                    return Err(wrong("this field does not affect the simulation".into()));
                }
                file = changed;
            }
            Some(AxisSetter::Field(field)) => file = with(&file, field, value).map_err(wrong)?,
            Some(AxisSetter::FieldIf(field, has_use)) => {
                has_use(&file.scene).map_err(|what| wrong(what.into()))?;
                file = with(&file, field, value).map_err(wrong)?;
            }
            Some(AxisSetter::Number(put)) => put(&mut file.scene, number().map_err(wrong)?),
            Some(AxisSetter::NumberIf(put)) => {
                put(&mut file.scene, number().map_err(wrong)?).map_err(|what| wrong(what.into()))?;
            }
        }
    }
    Ok(file)
}

fn has_equation_of_state(scene: &Scene) -> Result<(), &'static str> {
    if scene.corrects_pressure() {
        Err("the scene uses a pressure solver, so the equation of state has no effect")
    } else {
        Ok(())
    }
}

fn average_neighbours(scene: &mut Scene, value: f32) {
    scene.average_neighbours = Some(value);
    each_fluid(scene, |fluid| fluid.average_neighbours = None);
}

/// Sets the speed of sound of the first fluid and scales those of the other fluids in proportion.
fn speed_of_sound(scene: &mut Scene, value: f32) -> Result<(), &'static str> {
    if scene.fluids.iter().any(|fluid| fluid.stiffness.is_some()) || scene.stiffness_for_time_step.is_some() {
        return Err("the scene's speed of sound follows from its stiffness");
    }
    let share = value / scene.fluids[0].speed_of_sound;
    scene.fluids.iter_mut().skip(1).for_each(|fluid| fluid.speed_of_sound *= share);
    scene.fluids[0].speed_of_sound = value;
    Ok(())
}

fn stiffness(scene: &mut Scene, value: f32) {
    each_fluid(scene, |fluid| fluid.stiffness = Some(value));
}

/// Sets the dynamic viscosity of all fluids, including blocks that have their own.
fn viscosity(scene: &mut Scene, value: f32) -> Result<(), &'static str> {
    if matches!(scene.model.viscosity, Viscosity::Artificial | Viscosity::VelocityExchange) {
        return Err("the scene's model.viscosity does not use a dynamic viscosity");
    }
    each_fluid(scene, |fluid| fluid.dynamic_viscosity = value);
    scene.blocks.iter_mut().for_each(|block| block.dynamic_viscosity = None);
    Ok(())
}

/// Sets the ratio of the densities of two fluids, keeping their bulk moduli equal: the lighter fluid then has the
/// larger speed of sound. With equal speeds of sound it would be compressed too far by the weight of the other fluid,
/// whatever the time step.
fn density_ratio(scene: &mut Scene, value: f32) -> Result<(), &'static str> {
    let first = scene.fluids[0];
    let second = scene.fluids.get_mut(1).ok_or("the scene has one fluid, but a density ratio needs two")?;
    second.rest_density = value * first.rest_density;
    second.speed_of_sound = first.speed_of_sound / value.sqrt();
    Ok(())
}

/// Sets the velocity of the last block along gravity, or downwards without gravity.
fn drop_speed(scene: &mut Scene, value: f32) -> Result<(), &'static str> {
    let down = scene.gravity.try_normalize().unwrap_or(Vec3::NEG_Y);
    let block = scene.blocks.last_mut().ok_or("the scene has no block to drop")?;
    block.velocity = down * value;
    Ok(())
}

fn each_fluid(scene: &mut Scene, put: impl FnMut(&mut Fluid)) {
    scene.fluids.iter_mut().for_each(put);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::{Changes, load};

    fn file(name: &str) -> SceneFile {
        load(name, &Changes::default()).expect("it is built in").file
    }

    fn chosen(name: &str, pairs: &[(&str, &str)]) -> Result<Scene, Failure> {
        let choice = pairs.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
        choose(&file(name), &choice).map(|file| file.scene)
    }

    #[test]
    fn nonsense_is_refused() {
        let bad = ["", "=", "no_such_name", "viscosity=", "viscosity=1,", "=1,2", "viscosity=1,2,1"];
        for text in bad {
            assert!(Axis::parse(text).is_err(), "{text:?}");
        }
        assert!(parse_all(&["viscosity=1".into(), "viscosity=2".into()]).is_err());
        assert!(chosen("dam-break", &[("viscosity", "thick")]).is_err());
        assert!(chosen("dam-break", &[("no_such_field", "1")]).is_err());
        assert!(chosen("dam-break", &[("duration", "1")]).is_err(), "it does not affect the simulation");
        assert_eq!(Axis::parse("scene.time_step=1,2").expect("both names mean the same field").name, TIME_STEP);
        assert!(chosen("dam-break", &[("density_ratio", "0.1")]).is_err(), "a ratio needs two fluids");
        let artificial = [("model.viscosity", "Artificial"), ("viscosity", "1")];
        assert!(chosen("stiff-tank", &artificial).is_err(), "artificial viscosity has no dynamic viscosity");
        assert!(chosen("tower", &[("speed_of_sound", "10")]).is_err(), "its stiffness sets the speed of sound");
        assert!(chosen("dam-break", &[("equation_of_state", "Nobody")]).is_err());
        assert!(chosen("corrected-column", &[("equation_of_state", "Tait")]).is_err(), "it has a pressure solver");
    }

    #[test]
    fn an_axis_alone_has_values_of_its_own() {
        for known in KNOWN {
            let axis = Axis::parse(known.name).expect("it is known");
            assert!(axis.values.len() > 2, "{}", known.name);
        }
        assert_eq!(Axis::parse("model.viscosity=Mueller, Morris").expect("any field is accepted").values.len(), 2);
    }

    #[test]
    fn the_last_axis_is_the_fastest() {
        let axes = parse_all(&["a=1,2".into(), "b=x,y".into()]).expect("they parse");
        let all: Vec<String> =
            choices(&axes).iter().map(|c| c.iter().map(|(_, value)| value.as_str()).collect()).collect();
        assert_eq!(all, ["1x", "1y", "2x", "2y"]);
        assert_eq!(choices(&[]), [Choice::new()], "no axis: one point");
    }

    #[test]
    fn values_get_to_where_they_belong() {
        // the order does not matter: the density ratio is set after the speed of sound
        let pairs = [("density_ratio", "0.01"), ("speed_of_sound", "50"), ("viscosity", "7")];
        let scene = chosen("oil-and-water", &pairs).expect("it has two fluids");
        let second = scene.fluids[1];
        assert_eq!((scene.fluids[0].speed_of_sound, second.rest_density), (50.0, 10.0));
        assert!((second.speed_of_sound - 500.0).abs() < 0.01, "{}", second.speed_of_sound);
        assert_eq!((scene.fluids[0].dynamic_viscosity, second.dynamic_viscosity), (7.0, 7.0));
        let scene = chosen("dam-break", &[("drop_speed", "5"), ("time_step", "0.002")]).expect("it has a block");
        assert_eq!((scene.blocks[0].velocity, scene.time_step), (Vec3::new(0.0, -5.0, 0.0), 0.002));
    }
}
