//! Fine sweeps over omega dt: theoretical growth per step, and results of 30 s of an undamped oscillator. They are
//! written as figures and as a table of numbers.
use super::plots::{Area, Trouble, in_file};
use super::swings::{Swing, TIME_STEP};
use super::{NAME, Scheme, theory};
use crate::failure::Failure;
use crate::output::write_text;
use crate::plot::SERIES;
use millpond_core::scene::Integrator;
use plotters::prelude::SeriesLabelPosition::{LowerRight, UpperLeft};
use plotters::prelude::*;
use std::path::Path;

/// Size of a figure with two panels, pixels.
const SIZE: (u32, u32) = (1500, 640);

/// Spacing and number of the values of omega dt.
const STEP: f64 = 0.02;
const STEPS: u32 = 120;

/// First value, in spacings. Below it the last 5 s of a run would hold less than half a period.
const FIRST: u32 = 5;

/// Ranges of the axes: growth per step (with space for the legend), decades of amplitude, error of the frequency in per
/// cent.
const GROWTH: [f64; 2] = [0.0, 2.6];
const AMPLITUDE: [f64; 2] = [-3.0, 3.0];
const FREQUENCY: [f64; 2] = [-30.0, 60.0];

/// Curves with a smaller relative difference are drawn as one.
const SAME: f64 = 1e-4;

/// A curve, and the names of the schemes that it represents.
#[derive(Clone, Debug)]
struct Curve {
    names: Vec<String>,
    points: Vec<[f64; 2]>,
}

/// Writes the figures and the table of the sweep.
///
/// # Errors
/// Returns an error if a file cannot be written.
pub(super) fn draw(folder: &Path) -> Result<(), Failure> {
    let growth = |damping| curves(GROWTH, |scheme, p| Some(theory::growth(scheme, p, damping)));
    in_file(&folder.join(format!("{NAME}-growth.svg")), SIZE, |area| {
        let (left, right) = area.split_horizontally(50.percent_width());
        panel(&left, "growth in a step, undamped", GROWTH, UpperLeft, &growth(0.0))?;
        panel(&right, "growth in a step, critically damped", GROWTH, UpperLeft, &growth(1.0))
    })?;
    let amplitude = curves(AMPLITUDE, |scheme, p| Some(Swing::of(scheme, p, 0.0).amplitude().log10()));
    let frequency = curves(FREQUENCY, |scheme, p| {
        let [_, angle] = Swing::of(scheme, p, 0.0).growth_and_angle()?;
        Some((angle / p - 1.0) * 100.0)
    });
    in_file(&folder.join(format!("{NAME}-sweep.svg")), SIZE, |area| {
        let (left, right) = area.split_horizontally(50.percent_width());
        let title = "log10 of the amplitude after 30 s over the first, undamped";
        panel(&left, title, AMPLITUDE, LowerRight, &amplitude)?;
        panel(&right, "error of the frequency, %, undamped", FREQUENCY, UpperLeft, &frequency)
    })?;
    write_text(&folder.join(format!("{NAME}-sweep.csv")), &table())
}

/// Returns the sweep of all schemes as lines of CSV.
fn table() -> String {
    let mut out =
        String::from("scheme,omega_dt,omega_per_s,amplitude,velocity_amplitude,frequency_ratio,damped_error\n");
    for scheme in Scheme::all() {
        let name = scheme.name().replace(", ", " ");
        for p in sweep() {
            let (free, damped) = (Swing::of(scheme, p, 0.0), Swing::of(scheme, p, 1.0));
            let frequency = free.growth_and_angle().map_or(String::new(), |[_, angle]| format!("{:.6}", angle / p));
            let [x, v, error] = [free.amplitude(), free.velocity_amplitude(), damped.error()];
            out += &format!("{name},{p:.2},{:.3},{x:.4e},{v:.4e},{frequency},{error:.4e}\n", p / TIME_STEP);
        }
    }
    out
}

fn sweep() -> impl Iterator<Item = f64> {
    (FIRST..=STEPS).map(|step| STEP * f64::from(step))
}

/// Returns a curve for each integrator, without points outside of the frame. Curves that coincide are merged.
fn curves([low, high]: [f64; 2], value: impl Fn(Scheme, f64) -> Option<f64>) -> Vec<Curve> {
    let mut all: Vec<Curve> = Vec::new();
    for scheme in Integrator::ALL.iter().copied().map(Scheme::once) {
        let seen = |p| value(scheme, p).filter(|y| (low..=high).contains(y)).map(|y| [p, y]);
        let points: Vec<[f64; 2]> = sweep().filter_map(seen).collect();
        match all.iter_mut().find(|curve| same(&curve.points, &points)) {
            Some(curve) => curve.names.push(scheme.name()),
            None => all.push(Curve { names: vec![scheme.name()], points }),
        }
    }
    all
}

fn same(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    let close = |([p, x], [q, y]): (&[f64; 2], &[f64; 2])| p == q && (x - y).abs() <= SAME * (1.0 + x.abs());
    a.len() == b.len() && a.iter().zip(b).all(close)
}

/// Draws curves over omega dt.
fn panel(
    area: &Area<'_>,
    title: &str,
    [low, high]: [f64; 2],
    legend: SeriesLabelPosition,
    curves: &[Curve],
) -> Result<(), Trouble> {
    let last = STEP * f64::from(STEPS);
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 20))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(52)
        .build_cartesian_2d(0.0..last, low..high)?;
    chart.configure_mesh().x_desc("omega dt").label_style(("sans-serif", 14)).light_line_style(WHITE).draw()?;
    // the colour of a seventh curve is black
    let colours = SERIES.into_iter().chain([BLACK]).cycle();
    for (Curve { names, points }, colour) in curves.iter().zip(colours) {
        let style = colour.stroke_width(2);
        let key = move |(x, y)| PathElement::new([(x, y), (x + 22, y)], style);
        chart.draw_series(LineSeries::new([], style))?.label(names.join(", ")).legend(key);
        // a curve that leaves the frame and returns is drawn in two pieces
        for piece in points.chunk_by(|a, b| b[0] - a[0] < 1.5 * STEP) {
            chart.draw_series(LineSeries::new(piece.iter().map(|[p, y]| (*p, *y)), style))?;
        }
    }
    chart
        .configure_series_labels()
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.4))
        .label_font(("sans-serif", 13))
        .position(legend)
        .margin(10)
        .draw()
}
