//! Colours: the colour map for numbers, the palette for categories, and conversion between linear light and sRGB bytes.
//!
//! Colours are mixed and lit as linear light, a `Vec3` of red, green and blue from 0 to 1, and converted to sRGB bytes
//! last.

use glam::Vec3;

/// Nodes of the colour map in sRGB, from deep blue through blue, cyan and pale cyan to white.
const WATER: [u32; 6] = [0x0d_2b78, 0x12_52ad, 0x10_87cf, 0x30_bfe3, 0x98_e6ef, 0xff_ffff];

/// Palette for categories, the blue of water first. It follows Okabe and Ito 2008, so that colour-blind readers can
/// distinguish the colours.
const PALETTE: [u32; 8] = [0x14_72c0, 0xe6_9f00, 0x00_9e73, 0xcc_79a7, 0x56_b4e9, 0xd5_5e00, 0xf0_e442, 0x4a_5560];

/// Colour of a particle without a valid number or category. No other colour is similar to it.
const BROKEN: u32 = 0xd6_1f8d;

/// Colour of walls.
const WALL: u32 = 0xb9_c1c8;

/// Number of entries of a colour map.
const ENTRIES: usize = 256;

/// Colours of the particles of a picture, and the contents of the legend.
#[derive(Clone, Debug)]
pub enum Colouring {
    /// A number per particle (speed in m/s, or density in kg/m3), mapped from dark to light blue.
    Numbers {
        /// The numbers. A particle whose number is missing or not finite is drawn in magenta, which the colour map does
        /// not contain.
        of: Vec<f32>,
        /// Values at the two ends of the colour map.
        range: [f32; 2],
        /// Label of the colour bar, such as "speed, m/s".
        label: &'static str,
    },
    /// A category per particle.
    Kinds {
        /// Indices into `key`. A particle without a valid index is drawn in magenta.
        of: Vec<u32>,
        /// The categories, all of which are shown in the legend.
        key: Vec<Swatch>,
    },
}

impl Colouring {
    /// Returns the colours of the first `count` particles.
    pub(super) fn lights(&self, count: usize) -> Vec<Vec3> {
        match self {
            Colouring::Numbers { of, range, .. } => {
                let map = ColourMap::water(*range);
                (0..count).map(|i| map.at(of.get(i).copied().unwrap_or(f32::NAN))).collect()
            }
            Colouring::Kinds { of, key } => {
                let swatch = |i: usize| of.get(i).and_then(|kind| key.get(*kind as usize));
                let broken = from_srgb(BROKEN);
                (0..count).map(|i| swatch(i).map_or(broken, |swatch| swatch.light)).collect()
            }
        }
    }
}

/// A category: its name and its colour in the legend.
#[derive(Clone, Debug)]
pub struct Swatch {
    name: String,
    light: Vec3,
}

impl Swatch {
    /// Returns the category with this number. Its colour is `colour` (sRGB from 0 to 1) or, if there is none, an entry
    /// of the palette, whose eight colours repeat.
    #[must_use]
    pub fn new(name: String, number: usize, colour: Option<[f32; 3]>) -> Self {
        let light = colour.map_or(from_srgb(PALETTE[number % PALETTE.len()]), |parts| Vec3::from(parts.map(linear)));
        Self { name, light }
    }

    /// Name of the category.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Colour of the category.
    pub(super) fn light(&self) -> Vec3 {
        self.light
    }
}

/// Returns the pale grey of walls.
pub(super) fn wall() -> Vec3 {
    from_srgb(WALL)
}

/// A colour map over a range of numbers.
pub(super) struct ColourMap {
    range: [f32; 2],
    entries: Vec<Vec3>,
}

impl ColourMap {
    /// Returns the colour map for water, dark to light over `range`.
    ///
    /// Its entries are evenly spaced in lightness, so that equal differences of the number look like equal differences
    /// of colour.
    pub(super) fn water(range: [f32; 2]) -> Self {
        let steps = WATER.map(|hex| to_oklab(from_srgb(hex)));
        let (dark, light) = (steps[0].x, steps[WATER.len() - 1].x);
        let entry = |i: usize| {
            let lightness = dark + (light - dark) * i as f32 / (ENTRIES - 1) as f32;
            let next = steps.iter().position(|step| step.x >= lightness).unwrap_or(WATER.len() - 1).max(1);
            let (a, b) = (steps[next - 1], steps[next]);
            from_oklab(a.lerp(b, ((lightness - a.x) / (b.x - a.x)).clamp(0.0, 1.0)))
        };
        Self { range, entries: (0..ENTRIES).map(entry).collect() }
    }

    /// Returns the colour of `value`. Values outside of the range have the colour of the nearest end.
    pub(super) fn at(&self, value: f32) -> Vec3 {
        let [low, high] = self.range;
        let share = (value - low) / (high - low);
        match (value.is_finite(), share.is_nan()) {
            (false, _) => from_srgb(BROKEN),
            (true, true) => self.along(0.0), // an empty range, such as the speeds of water at rest
            (true, false) => self.along(share),
        }
    }

    /// Returns the colour at `share` of the length of the map, 0 to 1.
    pub(super) fn along(&self, share: f32) -> Vec3 {
        let last = self.entries.len() - 1;
        self.entries[(share.clamp(0.0, 1.0) * last as f32 + 0.5) as usize]
    }
}

/// Converts an sRGB colour written as `0xRRGGBB` to linear light.
pub(super) fn from_srgb(hex: u32) -> Vec3 {
    let part = |shift: u32| linear((hex >> shift & 0xff) as f32 / 255.0);
    Vec3::new(part(16), part(8), part(0))
}

/// Converts one component of an sRGB colour, 0 to 1, to linear light.
fn linear(part: f32) -> f32 {
    if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
}

/// Converts linear light to sRGB bytes by a table. Computing a power for each channel of each pixel would take longer
/// than the lighting.
pub(super) struct Encoder {
    table: Vec<u8>,
}

impl Encoder {
    /// Number of entries. The curve is steepest at black, where one entry still differs from the next by less than one
    /// byte value.
    const STEPS: usize = 4096;

    /// Returns a filled table.
    pub(super) fn new() -> Self {
        let byte = |i: usize| {
            let light = i as f32 / (Self::STEPS - 1) as f32;
            let part = if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
            (part * 255.0 + 0.5) as u8
        };
        Self { table: (0..Self::STEPS).map(byte).collect() }
    }

    /// Converts a colour to bytes. Light above 1 becomes white.
    pub(super) fn bytes(&self, light: Vec3) -> [u8; 3] {
        light.to_array().map(|part| self.table[(part.clamp(0.0, 1.0) * (Self::STEPS - 1) as f32 + 0.5) as usize])
    }
}

/// Converts linear light to Oklab (lightness, green-red, blue-yellow), a colour space in which equal distances look
/// equal.
fn to_oklab(light: Vec3) -> Vec3 {
    let cone = |r, g, b| light.dot(Vec3::new(r, g, b)).cbrt();
    let cones = Vec3::new(
        cone(0.412_221_46, 0.536_332_55, 0.051_445_995),
        cone(0.211_903_5, 0.680_699_5, 0.107_396_96),
        cone(0.088_302_46, 0.281_718_85, 0.629_978_7),
    );
    Vec3::new(
        cones.dot(Vec3::new(0.210_454_26, 0.793_617_8, -0.004_072_047)),
        cones.dot(Vec3::new(1.977_998_5, -2.428_592_2, 0.450_593_7)),
        cones.dot(Vec3::new(0.025_904_037, 0.782_771_77, -0.808_675_77)),
    )
}

/// Converts Oklab to linear light, the inverse of [`to_oklab`].
fn from_oklab(lab: Vec3) -> Vec3 {
    let cone = |a, b| lab.dot(Vec3::new(1.0, a, b)).powi(3);
    let cones = Vec3::new(
        cone(0.396_337_78, 0.215_803_76),
        cone(-0.105_561_346, -0.063_854_17),
        cone(-0.089_484_18, -1.291_485_5),
    );
    Vec3::new(
        cones.dot(Vec3::new(4.076_741_7, -3.307_711_6, 0.230_969_93)),
        cones.dot(Vec3::new(-1.268_438, 2.609_757_4, -0.341_319_4)),
        cones.dot(Vec3::new(-0.004_196_086_3, -0.703_418_6, 1.707_614_7)),
    )
}
