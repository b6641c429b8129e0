//! The map as a picture: one cell for each point, coloured by its largest stable time step, with the number written
//! into it.
use super::Suite;
use super::axis::Axis;
use super::map::{Cell, Map, Panel, lines};
use crate::failure::Failure;
use crate::output::seconds;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::path::Path;

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(40, 48, 56);
const QUIET: RGBColor = RGBColor(110, 118, 126);
/// Fill colour of cells without a stable time step.
const EMPTY: RGBColor = RGBColor(232, 234, 236);

/// Sizes in pixels.
const NARROWEST: i32 = 112;
const CELL_HEIGHT: i32 = 54;
const GAP: i32 = 2;
const MARGIN: i32 = 28;
const HEAD: i32 = 76;
/// Height below a panel for the values of its columns and their title, and above it for its own title.
const FOOT: i32 = 58;
const PANEL_TITLE: i32 = 26;
const LETTER: i32 = 8;
const LEGEND: i32 = 128;
const BAR: (i32, i32) = (18, 160);

/// Draws the map.
///
/// # Errors
/// Returns an error if the file cannot be written.
pub(super) fn draw(path: &Path, suite: &Suite, map: &Map) -> Result<(), Failure> {
    paint(path, suite, map).map_err(Failure::unwritten(path))
}

/// Positions and sizes, pixels.
struct Layout {
    /// Left edge of the cells.
    left: i32,
    cell: (i32, i32),
    columns: i32,
    rows: i32,
    panel_height: i32,
}

fn paint(path: &Path, suite: &Suite, map: &Map) -> Drawn {
    let side = map.rows.as_ref().map_or(0, |axis| longest(axis) + 40);
    let cell = (map.columns.as_ref().map_or(0, |axis| longest(axis) + 2 * GAP).max(NARROWEST), CELL_HEIGHT);
    let columns = map.panels.first().and_then(|panel| panel.cells.first()).map_or(1, Vec::len) as i32;
    let rows = map.panels.first().map_or(1, |panel| panel.cells.len()) as i32;
    let titled = if map.panels.len() > 1 { PANEL_TITLE } else { 0 };
    let layout = Layout { left: MARGIN + side, cell, columns, rows, panel_height: titled + rows * cell.1 + FOOT };
    let title = format!("{}: largest stable time step", suite.suite);
    let width = (layout.left + columns * cell.0 + LEGEND + MARGIN).max(title.chars().count() as i32 * 12 + 2 * MARGIN);
    let height = (HEAD + layout.panel_height * map.panels.len() as i32).max(HEAD + BAR.1 + MARGIN);
    let area = SVGBackend::new(path, (width as u32, height as u32)).into_drawing_area();
    area.fill(&WHITE)?;
    text(&area, &title, (MARGIN, 30), 24, INK, (HPos::Left, VPos::Center))?;
    let about = format!("over {} s of simulated time; C = c dt / H", suite.time_s);
    text(&area, &about, (MARGIN, 54), 14, QUIET, (HPos::Left, VPos::Center))?;
    let scale = Scale::of(map);
    for (i, panel) in map.panels.iter().enumerate() {
        let top = HEAD + i as i32 * layout.panel_height;
        if titled > 0 {
            text(&area, &panel.title, (layout.left, top + 10), 15, INK, (HPos::Left, VPos::Center))?;
        }
        draw_panel(&area, map, panel, &layout, top + titled, &scale)?;
    }
    legend(&area, &scale, (layout.left + columns * cell.0 + 24, HEAD + titled))?;
    area.present()
}

/// Returns the width of the longest value of an axis, pixels.
fn longest(axis: &Axis) -> i32 {
    axis.values.iter().map(|name| name.chars().count()).max().unwrap_or(0) as i32 * LETTER
}

fn draw_panel(area: &Canvas<'_>, map: &Map, panel: &Panel, at: &Layout, top: i32, scale: &Scale) -> Drawn {
    let size = at.cell;
    for (row, cells) in (0..).zip(&panel.cells) {
        for (column, cell) in (0..).zip(cells) {
            draw_cell(area, cell, [(at.left + column * size.0, top + row * size.1), size], scale)?;
        }
    }
    if let Some(axis) = &map.rows {
        for (row, name) in (0..).zip(&axis.values) {
            let place = (at.left - 10, top + row * size.1 + size.1 / 2);
            text(area, name, place, 14, INK, (HPos::Right, VPos::Center))?;
        }
        let upright = TextStyle::from((FONT, 14).into_font().transform(FontTransform::Rotate270)).color(&QUIET);
        let style = upright.pos(Pos::new(HPos::Center, VPos::Center));
        area.draw_text(axis.title(), &style, (MARGIN - 6, top + at.rows * size.1 / 2))?;
    }
    if let Some(axis) = &map.columns {
        let bottom = top + at.rows * size.1;
        for (column, name) in (0..).zip(&axis.values) {
            let place = (at.left + column * size.0 + size.0 / 2, bottom + 14);
            text(area, name, place, 14, INK, (HPos::Center, VPos::Center))?;
        }
        let place = (at.left + at.columns * size.0 / 2, bottom + 36);
        text(area, axis.title(), place, 14, QUIET, (HPos::Center, VPos::Center))?;
    }
    Ok(())
}

fn draw_cell(area: &Canvas<'_>, cell: &Cell, [(x, y), size]: [(i32, i32); 2], scale: &Scale) -> Drawn {
    let (fill, ink) = match cell {
        Cell::Stable { time_step, .. } => scale.colours(*time_step),
        Cell::Unstable(_) => (EMPTY, INK),
        Cell::Refused | Cell::TooLong => (WHITE, QUIET),
    };
    let corners = [(x + GAP, y + GAP), (x + size.0 - GAP, y + size.1 - GAP)];
    area.draw(&Rectangle::new(corners, fill.filled()))?;
    if matches!(cell, Cell::Refused | Cell::TooLong) {
        area.draw(&Rectangle::new(corners, EMPTY.stroke_width(2)))?;
    }
    let lines = lines(cell);
    let middle = (x + size.0 / 2, y + size.1 / 2);
    let centre = (HPos::Center, VPos::Center);
    if let [first, second] = &lines[..] {
        text(area, first, (middle.0, middle.1 - 9), 16, ink, centre)?;
        return text(area, second, (middle.0, middle.1 + 11), 12, ink, centre);
    }
    text(area, &lines.concat(), middle, 16, ink, centre)
}

/// Draws the colour bar, with the longest time step on top.
fn legend(area: &Canvas<'_>, scale: &Scale, (x, y): (i32, i32)) -> Drawn {
    let Some([low, high]) = scale.range else { return Ok(()) };
    for i in 0..BAR.1 {
        let share = 1.0 - f64::from(i) / f64::from(BAR.1 - 1);
        let corners = [(x, y + i), (x + BAR.0, y + i + 1)];
        area.draw(&Rectangle::new(corners, ViridisRGB.get_color(share).filled()))?;
    }
    let ends = [(high, y + 6), ((low * high).sqrt(), y + BAR.1 / 2), (low, y + BAR.1 - 6)];
    for (step, y) in ends {
        text(area, &seconds(step), (x + BAR.0 + 8, y), 13, INK, (HPos::Left, VPos::Center))?;
    }
    Ok(())
}

fn text(
    area: &Canvas<'_>,
    words: &str,
    place: (i32, i32),
    size: i32,
    colour: RGBColor,
    (across, along): (HPos, VPos),
) -> Drawn {
    let style = TextStyle::from((FONT, size).into_font()).color(&colour).pos(Pos::new(across, along));
    area.draw_text(words, &style, place)
}

/// Maps time steps to colours on a logarithmic scale. The colours of Viridis can be distinguished with any kind of
/// colour vision, and in black and white.
struct Scale {
    /// Range of stable time steps, s; `None` if none is stable.
    range: Option<[f32; 2]>,
}

impl Scale {
    fn of(map: &Map) -> Scale {
        let steps = || {
            map.cells().filter_map(|cell| match cell {
                Cell::Stable { time_step, .. } => Some(*time_step),
                _ => None,
            })
        };
        let (low, high) = (steps().fold(f32::INFINITY, f32::min), steps().fold(0.0, f32::max));
        // values that are nearly equal get similar colours
        let room = (4.0 / (high / low)).max(1.0).sqrt();
        Scale { range: (low <= high && low > 0.0).then_some([low / room, high * room]) }
    }

    /// Returns the fill colour of a cell, and the colour of its text.
    fn colours(&self, step: f32) -> (RGBColor, RGBColor) {
        let share = match self.range {
            Some([low, high]) if step > 0.0 => f64::from((step / low).ln() / (high / low).ln()),
            _ => 0.0,
        };
        let fill = ViridisRGB.get_color(share.clamp(0.0, 1.0));
        let light = 0.299 * f64::from(fill.0) + 0.587 * f64::from(fill.1) + 0.114 * f64::from(fill.2);
        (fill, if light > 125.0 { INK } else { WHITE })
    }
}
