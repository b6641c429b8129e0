//! Plots as SVG files: error against run time, and series over time.
use crate::failure::Failure;
use plotters::prelude::*;
use std::path::Path;

/// A run in a plot: one marker.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Series of the marker; each series has one colour and one entry in the legend.
    pub series: String,
    /// Label that distinguishes the markers of a series.
    pub label: String,
    /// Run time.
    pub x: f64,
    /// Error.
    pub y: f64,
    /// Whether no other run is both faster and more accurate.
    pub on_front: bool,
}

const SIZE: (u32, u32) = (900, 600);
const FRONT: RGBColor = RGBColor(60, 70, 80);
/// Colours of Okabe and Ito 2008, which most colour-blind readers can distinguish.
pub(crate) const SERIES: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

/// Smallest ratio of the ends of an axis to the values next to them.
const MARGIN: f64 = 1.2;

/// Draws markers in double logarithmic axes, and joins those on the Pareto front by a line.
///
/// # Errors
/// A file that cannot be written.
pub fn front_plot(path: &Path, title: &str, [x_label, y_label]: [&str; 2], marks: &[Mark]) -> Result<(), Failure> {
    draw(path, title, [x_label, y_label], marks).map_err(Failure::unwritten(path))
}

fn draw(
    path: &Path,
    title: &str,
    [x_label, y_label]: [&str; 2],
    marks: &[Mark],
) -> Result<(), DrawingAreaErrorKind<std::io::Error>> {
    // whole decades, whose ends have labels
    let range = |value: fn(&Mark) -> f64| {
        let values = || marks.iter().map(value).filter(|v| *v > 0.0);
        let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max));
        let decade = |exponent: f64| 10.0f64.powf(exponent);
        if low <= high {
            decade((low / MARGIN).log10().floor())..decade((high * MARGIN).log10().ceil())
        } else {
            0.1..10.0
        }
    };
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(title, ("sans-serif", 24))
        .margin(16)
        .x_label_area_size(48)
        .y_label_area_size(72)
        .build_cartesian_2d(range(|m| m.x).log_scale(), range(|m| m.y).log_scale())?;
    chart
        .configure_mesh()
        .x_desc(x_label)
        .y_desc(y_label)
        .y_label_formatter(&|y| format!("{:.2} %", y * 100.0))
        .label_style(("sans-serif", 14))
        .light_line_style(WHITE)
        .draw()?;
    let mut front: Vec<&Mark> = marks.iter().filter(|m| m.on_front).collect();
    front.sort_by(|a, b| a.x.total_cmp(&b.x));
    let line = LineSeries::new(front.iter().map(|m| (m.x, m.y)), FRONT.stroke_width(1));
    let key = |(x, y)| PathElement::new([(x, y), (x + 16, y)], FRONT.stroke_width(1));
    chart.draw_series(line)?.label("Pareto front").legend(key);
    let mut series: Vec<&str> = marks.iter().map(|m| m.series.as_str()).collect();
    series.sort_unstable();
    series.dedup();
    for (name, colour) in series.into_iter().zip(SERIES.into_iter().cycle()) {
        let own = marks.iter().filter(|m| m.series == name);
        let dots = own.map(|m| Circle::new((m.x, m.y), if m.on_front { 6 } else { 4 }, colour.filled()));
        let key = move |(x, y)| Circle::new((x + 8, y), 5, colour.filled());
        chart.draw_series(dots)?.label(name).legend(key);
    }
    // markers with the same label lie close together, so the label is written once, at the leftmost of them
    let mut labels: Vec<&str> = marks.iter().map(|m| m.label.as_str()).collect();
    labels.sort_unstable();
    labels.dedup();
    for label in labels {
        let first = marks.iter().filter(|m| m.label == label).min_by(|a, b| a.x.total_cmp(&b.x));
        let text =
            first.map(|m| EmptyElement::at((m.x, m.y)) + Text::new(label.to_owned(), (-18, -24), ("sans-serif", 14)));
        chart.draw_series(text)?;
    }
    chart
        .configure_series_labels()
        .background_style(WHITE)
        .border_style(FRONT)
        .label_font(("sans-serif", 14))
        // the runs that are better than the front would be at the lower left
        .position(SeriesLabelPosition::UpperRight)
        .margin(12)
        .draw()?;
    area.present()
}

/// A line in a plot.
#[derive(Clone, Debug)]
pub struct Line {
    /// Entry in the legend.
    pub label: String,
    /// Points in ascending order of x.
    pub points: Vec<[f64; 2]>,
}

/// Draws lines in linear axes.
///
/// # Errors
/// A file that cannot be written.
pub fn line_plot(path: &Path, title: &str, axes: [&str; 2], lines: &[Line]) -> Result<(), Failure> {
    draw_lines(path, title, axes, lines).map_err(Failure::unwritten(path))
}

fn draw_lines(
    path: &Path,
    title: &str,
    [x_label, y_label]: [&str; 2],
    lines: &[Line],
) -> Result<(), DrawingAreaErrorKind<std::io::Error>> {
    let range = |axis: usize| {
        let values = || lines.iter().flat_map(|line| &line.points).map(|point| point[axis]).filter(|v| v.is_finite());
        let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        if low < high { low..high } else { 0.0..1.0 }
    };
    let (x, y) = (range(0), range(1));
    let room = 0.06 * (y.end - y.start);
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(title, ("sans-serif", 24))
        .margin(16)
        .margin_right(32)
        .x_label_area_size(48)
        .y_label_area_size(72)
        .build_cartesian_2d(x, y.start - room..y.end + room)?;
    chart
        .configure_mesh()
        .x_desc(x_label)
        .y_desc(y_label)
        .x_label_formatter(&|x| ((x * 1e6).round() / 1e6).to_string())
        .y_label_formatter(&|y| format!("{:.1} %", y * 100.0))
        .label_style(("sans-serif", 14))
        .light_line_style(WHITE)
        .draw()?;
    for (line, colour) in lines.iter().zip(SERIES.into_iter().cycle()) {
        let points = line.points.iter().filter(|[x, y]| x.is_finite() && y.is_finite()).map(|[x, y]| (*x, *y));
        let key = move |(x, y)| PathElement::new([(x, y), (x + 16, y)], colour.stroke_width(3));
        chart.draw_series(LineSeries::new(points, colour.stroke_width(2)))?.label(&line.label).legend(key);
    }
    chart
        .configure_series_labels()
        .background_style(WHITE)
        .border_style(FRONT)
        .label_font(("sans-serif", 14))
        .position(SeriesLabelPosition::UpperRight)
        .margin(12)
        .draw()?;
    area.present()
}
