//! Figures 2.3 to 2.8 and 2.11 to 2.14 of Pirovano, with a panel for each integrator: in one frame, integrators that
//! give the same positions would hide each other. The analytic solution of figures 2.2 and 2.10 is the black line in
//! each panel.
use super::swings::{START, STIFFNESSES, Swing, TIME_STEP};
use super::{Measured, NAME};
use crate::failure::Failure;
use crate::output::make_folder;
use crate::plot::SERIES;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::io;
use std::path::Path;

/// Size in pixels, and number of panels down and across.
const SIZE: (u32, u32) = (1400, 1000);
const PANELS: (usize, usize) = (5, 2);

/// Height of the frame over the amplitude at the start. A motion that diverges leaves the frame.
const FRAME: f64 = 2.0;

/// Points per second of the analytic line.
const FINE: u32 = 60;

/// A figure of Pirovano.
struct Sheet {
    number: &'static str,
    /// Index into [`STIFFNESSES`].
    stiffness: usize,
    damped: bool,
    velocity: bool,
    /// Time that is shown, s.
    seconds: u32,
}

const fn undamped(number: &'static str, stiffness: usize, velocity: bool, seconds: u32) -> Sheet {
    Sheet { number, stiffness, damped: false, velocity, seconds }
}

const fn damped(number: &'static str, stiffness: usize, seconds: u32) -> Sheet {
    Sheet { number, stiffness, damped: true, velocity: false, seconds }
}

const SHEETS: [Sheet; 10] = [
    undamped("2.3", 0, false, 30),
    undamped("2.4", 1, false, 30),
    undamped("2.5", 4, false, 10),
    undamped("2.6", 0, true, 30),
    undamped("2.7", 1, true, 30),
    undamped("2.8", 4, true, 10),
    damped("2.11", 0, 20),
    damped("2.12", 1, 5),
    damped("2.13", 2, 5),
    damped("2.14", 3, 5),
];

/// Error of a drawing.
pub(super) type Trouble = DrawingAreaErrorKind<io::Error>;

/// A drawing that is written to a file.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws all figures into a folder.
///
/// # Errors
/// Returns an error if a file cannot be written.
pub(super) fn draw(folder: &Path, all: &[Measured]) -> Result<(), Failure> {
    make_folder(folder)?;
    for sheet in &SHEETS {
        let path = folder.join(format!("{NAME}-s0-figure-{}.svg", sheet.number));
        in_file(&path, SIZE, |area| sheet.draw(area, all))?;
    }
    Ok(())
}

/// Draws into a file.
///
/// # Errors
/// Returns an error if the file cannot be written.
pub(super) fn in_file(
    path: &Path,
    size: (u32, u32),
    draw: impl FnOnce(&Area<'_>) -> Result<(), Trouble>,
) -> Result<(), Failure> {
    let area = SVGBackend::new(path, size).into_drawing_area();
    let done = area.fill(&WHITE).and_then(|()| draw(&area)).and_then(|()| area.present());
    done.map_err(Failure::unwritten(path))
}

impl Sheet {
    fn draw(&self, area: &Area<'_>, all: &[Measured]) -> Result<(), Trouble> {
        let Sheet { number, stiffness, damped, velocity, .. } = *self;
        let what = if velocity { "velocity, m/s" } else { "position, m" };
        let kind = if damped { "critically damped" } else { "undamped" };
        let k = STIFFNESSES.get(stiffness).copied().unwrap_or(f64::NAN);
        let title = format!("Pirovano figure {number}: {what}, {kind}, K = {k} N/m (black: the exact motion)");
        let panels = area.titled(&title, ("sans-serif", 24))?.split_evenly(PANELS);
        let once = all.iter().filter(|one| !one.scheme.twice);
        for (panel, one) in panels.iter().zip(once) {
            let swings = if damped { &one.damped } else { &one.undamped };
            if let Some(swing) = swings.get(stiffness) {
                self.panel(panel, &one.scheme.name(), swing)?;
            }
        }
        Ok(())
    }

    fn panel(&self, area: &Area<'_>, name: &str, swing: &Swing) -> Result<(), Trouble> {
        let (component, values) = if self.velocity { (1, &swing.velocities) } else { (0, &swing.positions) };
        let height = FRAME * START * if self.velocity { swing.oscillator.omega } else { 1.0 };
        let seconds = f64::from(self.seconds);
        let mut chart = ChartBuilder::on(area)
            .caption(name, ("sans-serif", 16))
            .margin(6)
            .margin_right(16)
            .x_label_area_size(22)
            .y_label_area_size(48)
            .build_cartesian_2d(0.0..seconds, -height..height)?;
        chart
            .configure_mesh()
            .x_labels(6)
            .y_labels(5)
            .label_style(("sans-serif", 13))
            .light_line_style(WHITE)
            .draw()?;
        let stepped = values.iter().zip(0u32..).map(|(y, step)| (f64::from(step) * TIME_STEP, *y));
        let stepped = stepped.take_while(|(t, _)| *t <= seconds);
        let colour = SERIES[0];
        chart.draw_series(LineSeries::new(until_out(stepped, height), colour.stroke_width(2)))?;
        let exact = (0..=self.seconds * FINE).map(|i| f64::from(i) / f64::from(FINE));
        let exact = exact.map(|t| (t, swing.oscillator.exact([START, 0.0], t)[component]));
        chart.draw_series(LineSeries::new(exact, BLACK.stroke_width(1)))?;
        Ok(())
    }
}

/// Cuts a curve off where it leaves the frame.
fn until_out(points: impl Iterator<Item = (f64, f64)>, height: f64) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    for (x, y) in points {
        if y.abs() <= height {
            kept.push((x, y));
            continue;
        }
        if let Some(&(x0, y0)) = kept.last()
            && !y.is_nan()
        {
            let edge = height.copysign(y);
            kept.push((x0 + (x - x0) * (edge - y0) / (y - y0), edge));
        }
        break;
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_ends_at_the_edge() {
        let points = [(0.0, 0.0), (1.0, 4.0), (2.0, 0.0)];
        assert_eq!(until_out(points.into_iter(), 2.0), [(0.0, 0.0), (0.5, 2.0)]);
        assert_eq!(until_out([(0.0, 1.0), (1.0, f64::NAN)].into_iter(), 2.0), [(0.0, 1.0)]);
    }
}
