//! The map: the layout of the points and its table.
use super::axis::{Axis, TIME_STEP, choices};
use super::bisect::PRECISION;
use super::classify::Criterion;
use super::{Outcome, Run, Suite};
use crate::output::seconds;
use std::collections::BTreeMap;

/// Content of a cell of the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    /// The largest stable time step.
    Stable {
        /// Time step, s.
        time_step: f32,
        /// `c dt / H`; `None` with a pressure solver.
        courant: Option<f32>,
        /// Whether no longer time step was found unstable, so that the limit may be larger.
        at_least: bool,
    },
    /// No time step is stable; with the criterion that the shortest one broke.
    Unstable(Option<Criterion>),
    /// The scene cannot run.
    Refused,
    /// Skipped, because it needs too many steps.
    TooLong,
}

/// The cells for one value of each further axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Panel {
    /// Names and values of those axes; empty if there are at most two axes.
    pub(super) title: String,
    /// The cells, row by row.
    pub(super) cells: Vec<Vec<Cell>>,
}

/// Layout of the points.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Map {
    /// The axis of the rows; `None` if there is no axis, or only one of numbers.
    pub(super) rows: Option<Axis>,
    /// The axis of the columns; `None` if there is no axis, or only one of names.
    pub(super) columns: Option<Axis>,
    pub(super) panels: Vec<Panel>,
}

impl Map {
    /// Lays out the points. A cell shows the time step. The first two other axes are rows and columns, and each
    /// combination of values of further axes has a panel. Axes of numbers are columns, and axes of names are rows,
    /// where there is more space for them.
    pub(super) fn of(axes: &[Axis], runs: &[Run]) -> Map {
        let mut sides: Vec<&Axis> = axes.iter().filter(|axis| axis.name != TIME_STEP).collect();
        let others = sides.split_off(sides.len().min(2));
        let (rows, columns) = match sides[..] {
            [a, b] if a.is_of_numbers() && !b.is_of_numbers() => (Some(b), Some(a)),
            [a, b] => (Some(a), Some(b)),
            [a] if a.is_of_numbers() => (None, Some(a)),
            [a] => (Some(a), None),
            _ => (None, None),
        };
        let others: Vec<Axis> = others.into_iter().cloned().collect();
        let panels = choices(&others).into_iter().map(|fixed| {
            let title: Vec<String> = fixed.iter().map(|(name, value)| format!("{name} {value}")).collect();
            let fixed: BTreeMap<String, String> = fixed.into_iter().collect();
            let row = |row: Option<&String>| {
                let cell = |column: Option<&String>| {
                    let is_here = |axis: Option<&Axis>, value: Option<&String>, run: &Run| {
                        axis.is_none_or(|axis| run.choice.get(&axis.name) == value)
                    };
                    let own = runs.iter().filter(|run| {
                        is_here(rows, row, run)
                            && is_here(columns, column, run)
                            && fixed.iter().all(|(name, value)| run.choice.get(name) == Some(value))
                    });
                    cell_of(&own.collect::<Vec<_>>())
                };
                values(columns).into_iter().map(cell).collect()
            };
            Panel { title: title.join(", "), cells: values(rows).into_iter().map(row).collect() }
        });
        Map { panels: panels.collect(), rows: rows.cloned(), columns: columns.cloned() }
    }

    /// Returns all cells.
    pub(super) fn cells(&self) -> impl Iterator<Item = &Cell> {
        self.panels.iter().flat_map(|panel| panel.cells.iter().flatten())
    }
}

/// Returns the values of an axis, or one place without a value if there is no axis.
fn values(axis: Option<&Axis>) -> Vec<Option<&String>> {
    axis.map_or_else(|| vec![None], |axis| axis.values.iter().map(Some).collect())
}

/// Returns the content of a cell from its runs: one bisected point, or one run for each time step.
fn cell_of(runs: &[&Run]) -> Cell {
    let of = |outcome: Outcome| runs.iter().filter(move |run| run.outcome == outcome);
    let by_step = |a: &&&Run, b: &&&Run| a.time_step.unwrap_or(0.0).total_cmp(&b.time_step.unwrap_or(0.0));
    if let Some(best) = of(Outcome::Stable).max_by(by_step) {
        let time_step = best.time_step.unwrap_or(0.0);
        let longer = of(Outcome::Unstable).any(|run| run.time_step.is_some_and(|step| step > time_step));
        let at_least = !longer && best.unstable_time_step.is_none();
        return Cell::Stable { time_step, courant: best.courant.map(|courant| courant.support), at_least };
    }
    // a time step that was skipped may be stable
    if runs.iter().any(|run| run.too_long) {
        return Cell::TooLong;
    }
    of(Outcome::Unstable).min_by(by_step).map_or(Cell::Refused, |shortest| Cell::Unstable(shortest.criterion))
}

/// Returns the report.
pub(super) fn words(suite: &Suite, map: &Map) -> String {
    let names: Vec<&str> = suite.axes.iter().map(|axis| axis.name.as_str()).collect();
    let over = if names.is_empty() { String::new() } else { format!(" over {}", names.join(", ")) };
    let mut out = format!("# {}: the largest stable time step{over}\n\n", suite.suite);
    let listed = suite.axes.iter().any(|axis| axis.name == TIME_STEP);
    let found = if listed { "Of those given".to_owned() } else { format!("Bisected to {} %", PRECISION * 100.0) };
    out += &format!("{found}, over {} s of simulated time; C is c dt / H.\n", suite.time_s);
    if let Some(why) = &suite.energy_not_judged {
        out += &format!("Energy growth is not judged: {why}.\n");
    }
    for panel in &map.panels {
        out += &format!("\n{}\n", table(map, panel));
    }
    out += "\n| run | outcome | steps | |\n| --- | --- | --- | --- |\n";
    for run in &suite.runs {
        let outcome = run.outcome.name();
        let label = if run.label.is_empty() { "the scene as it is" } else { &run.label };
        out += &format!("| {label} | {outcome} | {} | {} |\n", run.steps, run.detail);
    }
    if let Some(picture) = &suite.picture {
        out += &format!("\nPicture: {}\n", picture.display());
    }
    out
}

fn table(map: &Map, panel: &Panel) -> String {
    let titles: Vec<&String> = values(map.columns.as_ref()).into_iter().flatten().collect();
    let name = |axis: &Option<Axis>| axis.as_ref().map_or("", Axis::title).to_owned();
    let corner = [name(&map.rows), name(&map.columns)].into_iter().filter(|name| !name.is_empty());
    let mut out = if panel.title.is_empty() { String::new() } else { format!("{}:\n\n", panel.title) };
    let row = |first: &str, rest: &mut dyn Iterator<Item = String>| {
        let cells: Vec<String> = rest.collect();
        format!("| {first} | {} |\n", cells.join(" | "))
    };
    let width = panel.cells.first().map_or(0, Vec::len);
    let mut heads = titles.into_iter().cloned().chain(std::iter::repeat(String::new())).take(width);
    out += &row(&corner.collect::<Vec<_>>().join(" \\ "), &mut heads);
    out += &row("---", &mut std::iter::repeat_n("---".to_owned(), width));
    for (value, cells) in values(map.rows.as_ref()).into_iter().zip(&panel.cells) {
        let first = value.map_or("largest stable step", |value| value);
        out += &row(first, &mut cells.iter().map(|cell| lines(cell).join(", ")));
    }
    out.trim_end().to_owned()
}

/// Returns the text of a cell: one line or two.
pub(super) fn lines(cell: &Cell) -> Vec<String> {
    match cell {
        Cell::Stable { time_step, courant, at_least } => {
            let sign = if *at_least { ">= " } else { "" };
            let number = courant.map(|courant| format!("C {courant:.2}"));
            [format!("{sign}{}", seconds(*time_step))].into_iter().chain(number).collect()
        }
        Cell::Unstable(criterion) => {
            ["none".to_owned()].into_iter().chain(criterion.map(|criterion| criterion.name().to_owned())).collect()
        }
        Cell::Refused => vec!["refused".into()],
        Cell::TooLong => vec!["skipped".into(), "too many steps".into()],
    }
}

#[cfg(test)]
mod tests {
    use super::super::axis::parse_all;
    use super::*;

    fn run(pairs: &[(&str, &str)], outcome: Outcome, time_step: Option<f32>) -> Run {
        let choice = pairs.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
        let criterion = (outcome == Outcome::Unstable).then_some(Criterion::EnergyGrowth);
        let (label, detail) = (String::new(), String::new());
        let (unstable_time_step, courant, too_long) = (None, None, false);
        Run {
            label,
            choice,
            outcome,
            detail,
            criterion,
            too_long,
            time_step,
            unstable_time_step,
            courant,
            particles: 1,
            steps: 1,
        }
    }

    #[test]
    fn a_cell_is_the_largest_stable_of_its_steps() {
        let axes = ["speed_of_sound=10,20", "model.integrator=Euler,Verlet", "time_step=0.1,0.2"];
        let axes = parse_all(&axes.map(str::to_owned)).expect("they parse");
        let limit = |c: &str, way: &str| match (c, way) {
            ("10", "Verlet") => 0.2,
            ("20", "Euler") => 0.0,
            _ => 0.1,
        };
        let runs: Vec<Run> = choices(&axes)
            .iter()
            .map(|choice| {
                let pairs: Vec<(&str, &str)> = choice.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
                let step: f32 = pairs[2].1.parse().expect("a number");
                let stable = step <= limit(pairs[0].1, pairs[1].1);
                run(&pairs, if stable { Outcome::Stable } else { Outcome::Unstable }, Some(step))
            })
            .collect();
        let map = Map::of(&axes, &runs);
        assert_eq!(map.rows.as_ref().map(|axis| axis.name.as_str()), Some("model.integrator"), "names are rows");
        let stable = |time_step, at_least| Cell::Stable { time_step, courant: None, at_least };
        let euler = vec![stable(0.1, false), Cell::Unstable(Some(Criterion::EnergyGrowth))];
        assert_eq!(map.panels[0].cells, [euler, vec![stable(0.2, true), stable(0.1, false)]]);
        assert_eq!(map.panels.len(), 1);
    }

    #[test]
    fn further_axes_have_panels() {
        let axes = parse_all(&["a=1,2", "b=1,2", "c=1,2"].map(str::to_owned)).expect("they parse");
        let map = Map::of(&axes, &[]);
        let titles: Vec<&str> = map.panels.iter().map(|panel| panel.title.as_str()).collect();
        assert_eq!(titles, ["c 1", "c 2"]);
        assert!(map.cells().all(|cell| *cell == Cell::Refused), "without runs no time step is stable");
        assert_eq!(Map::of(&[], &[]).panels[0].cells.len(), 1, "no axis: one cell");
        let lone = parse_all(&["integrator".to_owned()]).expect("it parses");
        assert!(Map::of(&lone, &[]).columns.is_none(), "names are rows");
    }

    #[test]
    fn times_are_readable() {
        let all = [1.5, 0.0123, 1e-3, 9.996e-3, 1.6e-4, 3.14e-6].map(seconds);
        assert_eq!(all, ["1.50 s", "12.3 ms", "1.00 ms", "10.0 ms", "160 µs", "3.14 µs"]);
    }
}
