//! Plots of error against run time, as SVG.
use crate::failure::Failure;
use plotters::prelude::*;
use std::path::Path;

/// A run in a plot.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Its name.
    pub label: String,
    /// Run time.
    pub x: f64,
    /// Error.
    pub y: f64,
    /// No other run is both faster and better.
    pub on_front: bool,
}

const SIZE: (u32, u32) = (900, 600);
const FRONT: RGBColor = RGBColor(13, 90, 160);
const BEHIND: RGBColor = RGBColor(150, 160, 170);

/// Draws marks in double logarithmic axes, the front joined by a line.
///
/// # Errors
/// The file cannot be written.
pub fn front_plot(path: &Path, title: &str, [x_label, y_label]: [&str; 2], marks: &[Mark]) -> Result<(), Failure> {
    draw(path, title, [x_label, y_label], marks).map_err(|e| Failure::System(format!("{}: {e}", path.display())))
}

fn draw(
    path: &Path,
    title: &str,
    [x_label, y_label]: [&str; 2],
    marks: &[Mark],
) -> Result<(), DrawingAreaErrorKind<std::io::Error>> {
    let range = |value: fn(&Mark) -> f64, margin: f64| {
        let values = || marks.iter().map(value).filter(|v| *v > 0.0);
        let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max));
        if low <= high { low / margin..high * margin } else { 0.1..10.0 }
    };
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(title, ("sans-serif", 24))
        .margin(16)
        .x_label_area_size(48)
        .y_label_area_size(72)
        .build_cartesian_2d(range(|m| m.x, 2.0).log_scale(), range(|m| m.y, 1.4).log_scale())?;
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
    chart.draw_series(LineSeries::new(front.iter().map(|m| (m.x, m.y)), FRONT.stroke_width(2)))?;
    for mark in marks {
        let colour = if mark.on_front { FRONT } else { BEHIND };
        chart.draw_series([Circle::new((mark.x, mark.y), 5, colour.filled())])?;
        let style = ("sans-serif", 12).into_font().color(&colour);
        let text = EmptyElement::at((mark.x, mark.y)) + Text::new(mark.label.clone(), (8, -6), style);
        chart.draw_series([text])?;
    }
    area.present()
}
