//! Axes of a map: what varies, over which values, and how a value gets into a scene.
use crate::failure::Failure;
use crate::scenes::{SceneFile, with};
use glam::Vec3;
use millpond_core::scene::{EquationOfState, Fluid, Integrator, Scene, Viscosity};
use serde::Serialize;

/// Name of the axis that is the time step itself.
pub(super) const TIME_STEP: &str = "time_step";

/// Something that varies.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Axis {
    /// One of the short names, or a field as `--set` takes it.
    pub name: String,
    /// Its values, as they were given.
    pub values: Vec<String>,
}

/// A value on each axis.
pub(super) type Choice = Vec<(String, String)>;

/// How a value gets into a scene.
enum AxisSetter {
    /// A field, as by `--set`.
    Field(&'static str),
    /// The same, where the scene has a use for it.
    FieldIf(&'static str, fn(&Scene) -> Result<(), &'static str>),
    /// A number in several fields.
    Number(fn(&mut Scene, f32)),
    /// A number in several fields, where the scene has a use for it.
    NumberIf(fn(&mut Scene, f32) -> Result<(), &'static str>),
}

/// An axis with a short name.
struct KnownAxis {
    name: &'static str,
    /// What it is called in a picture.
    title: &'static str,
    /// Its values where none are given.
    values: fn() -> Vec<String>,
    way: AxisSetter,
}

/// The axes with short names, in the order in which they get into a scene: a ratio of densities follows the speed of sound.
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
        title: "density of the second fluid over the first's",
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

/// What may stand without values.
fn alone() -> String {
    let known: Vec<&str> = KNOWN.iter().map(|known| known.name).collect();
    format!("give NAME=VALUE,VALUE, or one of {} alone", known.join(", "))
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
    /// Of `NAME=VALUE,VALUE` or, where the name has values of its own, of `NAME`.
    ///
    /// # Errors
    /// No name, no values, a value twice.
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
            return Err(wrong(&format!("{} is there twice", twice.1)));
        }
        Ok(Axis { name: name.to_owned(), values })
    }

    /// What it is called in a picture.
    #[must_use]
    pub fn title(&self) -> &str {
        KNOWN.iter().find(|known| known.name == self.name).map_or(self.name.as_str(), |known| known.title)
    }

    /// Are its values numbers?
    #[must_use]
    pub fn is_of_numbers(&self) -> bool {
        self.values.iter().all(|value| value.parse::<f64>().is_ok())
    }
}

/// All axes of a call.
///
/// # Errors
/// As for [`Axis::parse`]; also one that is there twice.
pub(super) fn parse_all(texts: &[String]) -> Result<Vec<Axis>, Failure> {
    let axes = texts.iter().map(|text| Axis::parse(text)).collect::<Result<Vec<_>, _>>()?;
    match axes.iter().enumerate().find(|(i, axis)| axes[..*i].iter().any(|other| other.name == axis.name)) {
        Some((_, twice)) => Err(Failure::Call(format!("--axis {} is there twice", twice.name))),
        None => Ok(axes),
    }
}

/// Every combination of values, the last axis fastest.
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

/// `file` with a choice made. Whether the scene can run is its own to say.
///
/// # Errors
/// No such field, a value that does not fit, an axis that the scene has no use for.
pub(super) fn choose(file: &SceneFile, choice: &Choice) -> Result<SceneFile, Failure> {
    let order = |name: &str| KNOWN.iter().position(|known| known.name == name);
    let mut sorted: Vec<&(String, String)> = choice.iter().collect();
    // fields by their own names come first
    sorted.sort_by_key(|(name, _)| order(name));
    let mut file = file.clone();
    for (name, value) in sorted {
        let wrong = |what: String| Failure::Call(format!("--axis {name}={value}: {what}"));
        let number = || value.parse().map_err(|_| "give numbers".to_owned());
        match KNOWN.iter().find(|known| known.name == name).map(|known| &known.way) {
            None => {
                let changed = with(&file, name, value).map_err(wrong)?;
                if changed.scene == file.scene && changed != file {
                    return Err(wrong("it says how a scene is shown, and nothing of what runs".into()));
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
        Err("the scene iterates its pressure, so that equations of state have no effect")
    } else {
        Ok(())
    }
}

fn average_neighbours(scene: &mut Scene, value: f32) {
    scene.average_neighbours = value;
    each_fluid(scene, |fluid| fluid.average_neighbours = None);
}

/// Of the first fluid; those of the others stay in proportion.
fn speed_of_sound(scene: &mut Scene, value: f32) -> Result<(), &'static str> {
    if scene.fluids.iter().any(|fluid| fluid.stiffness.is_some()) || scene.stiffness_for_time_step.is_some() {
        return Err("the scene's sound follows from its stiffness");
    }
    let share = value / scene.fluids[0].speed_of_sound;
    scene.fluids.iter_mut().skip(1).for_each(|fluid| fluid.speed_of_sound *= share);
    scene.fluids[0].speed_of_sound = value;
    Ok(())
}

fn stiffness(scene: &mut Scene, value: f32) {
    each_fluid(scene, |fluid| fluid.stiffness = Some(value));
}

/// Of everything that flows, blocks with a viscosity of their own too.
fn viscosity(scene: &mut Scene, value: f32) -> Result<(), &'static str> {
    if matches!(scene.model.viscosity, Viscosity::Artificial | Viscosity::VelocityExchange) {
        return Err("the scene's model.viscosity takes none");
    }
    each_fluid(scene, |fluid| fluid.dynamic_viscosity = value);
    scene.blocks.iter_mut().for_each(|block| block.dynamic_viscosity = None);
    Ok(())
}

/// At equal bulk moduli: a fluid with the other's pressure and a share of its density has the faster sound. With the same
/// sound it would be crushed by the other's weight at any step.
fn density_ratio(scene: &mut Scene, value: f32) -> Result<(), &'static str> {
    let first = scene.fluids[0];
    let second = scene.fluids.get_mut(1).ok_or("the scene has one fluid, and a ratio needs two")?;
    second.rest_density = value * first.rest_density;
    second.speed_of_sound = first.speed_of_sound / value.sqrt();
    Ok(())
}

/// Of the last block, along gravity; down where there is none.
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
        assert!(chosen("dam-break", &[("duration", "1")]).is_err(), "nothing of what runs");
        assert_eq!(Axis::parse("scene.time_step=1,2").expect("one name for one thing").name, TIME_STEP);
        assert!(chosen("dam-break", &[("density_ratio", "0.1")]).is_err(), "one fluid has no ratio");
        assert!(chosen("stiff-tank", &[("viscosity", "1")]).is_err(), "an artificial viscosity takes none");
        assert!(chosen("tower", &[("speed_of_sound", "10")]).is_err(), "its stiffness says how fast sound is");
        assert!(chosen("dam-break", &[("equation_of_state", "Nobody")]).is_err());
        assert!(chosen("corrected-column", &[("equation_of_state", "Tait")]).is_err(), "its pressure is iterated");
    }

    #[test]
    fn an_axis_alone_has_values_of_its_own() {
        for known in KNOWN {
            let axis = Axis::parse(known.name).expect("it is known");
            assert!(axis.values.len() > 2, "{}", known.name);
        }
        assert_eq!(Axis::parse("model.viscosity=Mueller, Morris").expect("any field will do").values.len(), 2);
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
        // whichever way round: a ratio follows the speed of sound
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
