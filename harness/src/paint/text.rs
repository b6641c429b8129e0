//! The text in a picture: a font of 5 x 7 dots plus one row for descenders, the caption and the legend.
#![expect(clippy::unreadable_literal, reason = "a glyph is five columns of two digits each")]

use super::canvas::Canvas;
use super::colour::{ColourMap, Colouring, Encoder, Swatch};

/// Colour of letters.
const INK: [u8; 3] = [0x2b, 0x38, 0x45];

/// Distance between letters and between lines, dots.
const ADVANCE: [i32; 2] = [6, 12];

/// The characters from space to tilde. A glyph is five columns from left to right, with the top dot in the lowest bit;
/// the eighth row is for descenders.
#[rustfmt::skip]
const GLYPHS: [u64; 95] = [
    0x0000000000, 0x00005f0000, 0x0007000700, 0x147f147f14, 0x242a7f2a12, 0x2313086462, 0x3649552250, 0x0005030000,
    0x001c224100, 0x0041221c00, 0x14083e0814, 0x08083e0808, 0x00a0600000, 0x0808080808, 0x0060600000, 0x2010080402,
    0x3e5149453e, 0x00427f4000, 0x4261514946, 0x2141454b31, 0x1814127f10, 0x2745454539, 0x3c4a494930, 0x0171090503,
    0x3649494936, 0x064949291e, 0x0036360000, 0x00ac6c0000, 0x0814224100, 0x1414141414, 0x0041221408, 0x0201510906,
    0x324979413e, 0x7e1111117e, 0x7f49494936, 0x3e41414122, 0x7f4141221c, 0x7f49494941, 0x7f09090901, 0x3e4149497a,
    0x7f0808087f, 0x00417f4100, 0x2040413f01, 0x7f08142241, 0x7f40404040, 0x7f020c027f, 0x7f0408107f, 0x3e4141413e,
    0x7f09090906, 0x3e4151215e, 0x7f09192946, 0x4649494931, 0x01017f0101, 0x3f4040403f, 0x1f2040201f, 0x3f4038403f,
    0x6314081463, 0x0708700807, 0x6151494543, 0x007f414100, 0x0204081020, 0x0041417f00, 0x0402010204, 0x4040404040,
    0x0001020400, 0x2054545478, 0x7f48444438, 0x3844444420, 0x384444487f, 0x3854545418, 0x087e090102, 0x18a4a4a47c,
    0x7f08040478, 0x00447d4000, 0x4080847d00, 0x7f10284400, 0x00417f4000, 0x7c04180478, 0x7c08040478, 0x3844444438,
    0xfc24242418, 0x18242424fc, 0x7c08040408, 0x4854545420, 0x043f444020, 0x3c4040207c, 0x1c2040201c, 0x3c4030403c,
    0x4428102844, 0x1ca0a0a07c, 0x4464544c44, 0x0008364100, 0x00007f0000, 0x0041360800, 0x1008081008,
];

/// Returns the size of a dot in pixels, for a picture of this height.
fn dot(height: u32) -> i32 {
    (height / 270).clamp(1, 16) as i32
}

/// Returns the margin at every side that the scene leaves free for text, pixels.
pub(super) fn margin(height: u32) -> f32 {
    (19 * dot(height)).min(height as i32 / 5) as f32
}

/// Writes the caption into the upper left corner.
pub(super) fn caption(canvas: &mut Canvas, text: &str) {
    let dot = dot(canvas.height());
    for (line, row) in text.lines().zip(0..64) {
        write(canvas, [6 * dot, 6 * dot + row * ADVANCE[1] * dot], dot, line);
    }
}

/// Draws the legend on one line in the lower right corner.
pub(super) fn legend(canvas: &mut Canvas, colouring: &Colouring) {
    match colouring {
        Colouring::Numbers { range, label, .. } => colour_bar(canvas, *range, label),
        Colouring::Kinds { key, .. } => swatches(canvas, key),
    }
}

/// Draws the colour bar: label, low end, bar, high end.
fn colour_bar(canvas: &mut Canvas, range: [f32; 2], label: &str) {
    let (wide, high, dot) = (canvas.width() as i32, canvas.height() as i32, dot(canvas.height()));
    let map = ColourMap::water(range);
    let [low, top] = numbers(range);
    let (gap, bar, y) = (4 * dot, [80 * dot, 7 * dot], high - 13 * dot);

    let after = wide - 6 * dot - width(&top, dot);
    let start = after - gap - bar[0];
    write(canvas, [after, y], dot, &top);
    canvas.fill([start - 1, y - 1], [bar[0] + 2, bar[1] + 2], INK);
    let encoder = Encoder::new();
    for x in 0..bar[0] {
        let colour = encoder.bytes(map.along(x as f32 / (bar[0] - 1) as f32));
        canvas.fill([start + x, y], [1, bar[1]], colour);
    }
    let before = start - gap - width(&low, dot);
    write(canvas, [before, y], dot, &low);
    write(canvas, [before - 3 * gap - width(label, dot), y], dot, label);
}

/// Draws the colour and the name of each category.
fn swatches(canvas: &mut Canvas, key: &[Swatch]) {
    let (wide, high, dot) = (canvas.width() as i32, canvas.height() as i32, dot(canvas.height()));
    let (gap, side, y) = (4 * dot, 7 * dot, high - 13 * dot);
    let encoder = Encoder::new();
    let mut after = wide - 6 * dot;
    for swatch in key.iter().rev() {
        let name = after - width(swatch.name(), dot);
        let square = name - gap - side;
        write(canvas, [name, y], dot, swatch.name());
        canvas.fill([square - 1, y - 1], [side + 2, side + 2], INK);
        canvas.fill([square, y], [side, side], encoder.bytes(swatch.light()));
        after = square - gap;
    }
}

/// Formats the ends of the range with enough decimals for about three significant digits of the difference.
fn numbers(range: [f32; 2]) -> [String; 2] {
    let span = (range[1] - range[0]).abs();
    let decimals = if span > 0.0 && span.is_finite() { (2 - span.log10().floor() as i32).clamp(0, 6) } else { 2 };
    range.map(|end| {
        let number = format!("{end:.*}", decimals as usize);
        let short = if decimals > 0 { number.trim_end_matches('0').trim_end_matches('.') } else { &number };
        if short == "-0" { "0".to_owned() } else { short.to_owned() }
    })
}

/// Returns the width of a line of text, pixels.
fn width(text: &str, dot: i32) -> i32 {
    text.chars().count().min(1000) as i32 * ADVANCE[0] * dot
}

/// Writes one line of text with its upper left corner at the given position.
fn write(canvas: &mut Canvas, [x, y]: [i32; 2], dot: i32, text: &str) {
    for (character, place) in text.chars().zip(0..1000) {
        let glyph = glyph(character);
        let left = x + place * ADVANCE[0] * dot;
        for (column, row) in (0..5).flat_map(|column| (0..8).map(move |row| (column, row))) {
            if glyph >> ((4 - column) * 8 + row) & 1 == 1 {
                canvas.fill([left + column * dot, y + row * dot], [dot, dot], INK);
            }
        }
    }
}

/// Returns the dots of a character. Characters that the font does not have become question marks.
fn glyph(character: char) -> u64 {
    match character {
        '²' => 0x0019151200,
        '³' => 0x0011151f00,
        '°' => 0x0006090600,
        '·' => 0x0000080000,
        _ => {
            let index = (character as usize).wrapping_sub(' ' as usize);
            GLYPHS.get(index).copied().unwrap_or(GLYPHS['?' as usize - ' ' as usize])
        }
    }
}
