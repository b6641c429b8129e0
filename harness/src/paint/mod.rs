//! A small software renderer that draws particles.
//!
//! Every particle is drawn as a lit sphere, in three passes without a GPU:
//!
//! 1. `camera` projects the particles, and `discs` finds the nearest sphere at every sample; `tank` adds the edges of
//!    the container to the same depth buffer, and `solids` follows the lines of sight to the solids.
//! 2. `light` computes the colour of each sample from its sphere and from the depths around it, so that the large shape
//!    of the water is visible as well as the single particle. It averages a square of samples into a pixel.
//! 3. `text` draws the caption and the legend on the finished [`Canvas`], which can be saved as PNG.
//!
//! The same input gives the same bytes with any number of threads: each thread owns whole rows, and in a row the
//! particles are always drawn in the same order.

mod camera;
mod canvas;
mod colour;
mod discs;
mod light;
mod solids;
mod tank;
mod text;

use camera::Camera;
pub use canvas::Canvas;
pub use colour::{Colouring, Swatch};
use discs::{Disc, Layer};
use glam::Vec3;
pub use solids::Distances;
use tank::Floor;

/// Samples along one side of a pixel.
const SUPERSAMPLING: u32 = 2;

/// Largest width and height of a picture, pixels. The samples of a larger picture would not fit into the memory of an
/// ordinary machine.
const MAX_SIDE: u32 = 8192;

/// The contents of a picture.
#[derive(Clone, Copy)]
pub struct Frame<'a> {
    /// Positions, xyz in metres with y up; w is ignored. Positions that are not finite are not drawn.
    pub positions: &'a [[f32; 4]],
    /// Colours of the particles.
    pub colouring: &'a Colouring,
    /// Positions of wall particles, drawn with the same radius in pale grey.
    pub walls: &'a [[f32; 4]],
    /// Drawn radius of a particle, metres.
    pub radius: f32,
    /// Opposite corners of the container to outline, if any.
    pub container: Option<[Vec3; 2]>,
    /// Distances from the solids of the scene, if it has any.
    pub solids: Option<&'a Distances<'a>>,
    /// Caption in the upper left corner, such as "t = 0.50 s   speed 0 .. 4 m/s"; may have several lines.
    pub caption: &'a str,
}

/// Point of view of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum View {
    /// Straight along -z without perspective, for flow in the xy plane.
    Flat,
    /// In perspective, looking at the middle of the bounds from a circle around it.
    Orbit {
        /// Turn about the y axis: 0 looks along -z, 90 looks along -x.
        yaw_degrees: f32,
        /// Height above the horizon: 0 looks level, 90 looks straight down.
        pitch_degrees: f32,
    },
}

/// Draws `frame` as seen by `view` in a picture of `width` x `height` pixels that shows the box `bounds`.
///
/// The middle of `bounds` is the middle of the picture, and all of the box is visible. Width and height are clamped to
/// 1 to 8192 pixels.
#[must_use]
pub fn paint(frame: &Frame, view: &View, bounds: [Vec3; 2], width: u32, height: u32) -> Canvas {
    let (width, height) = (width.clamp(1, MAX_SIDE), height.clamp(1, MAX_SIDE));
    let (wide, high) = (width * SUPERSAMPLING, height * SUPERSAMPLING);
    let camera = Camera::new(view, bounds, wide as f32, high as f32, text::margin(height) * SUPERSAMPLING as f32);
    let container = frame.container.filter(|[a, b]| a.is_finite() && b.is_finite());

    let discs = Disc::project(frame, &camera);
    let mut layer = Layer::new(wide as usize, high as usize);
    layer.draw_discs(&discs);
    if let Some(corners) = container {
        tank::outline(&mut layer, &camera, corners);
    }
    let floor = container.and_then(|corners| Floor::new(&camera, corners, frame));
    let solids = frame.solids.map(|distances| solids::look(&camera, distances, wide as usize, high as usize));
    let mut canvas = light::expose(&layer, &discs, &camera, floor.as_ref(), solids.as_deref());
    text::caption(&mut canvas, frame.caption);
    text::legend(&mut canvas, frame.colouring);
    canvas
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: [Vec3; 2] = [Vec3::new(-1.0, 0.0, -1.0), Vec3::new(1.0, 2.0, 1.0)];

    fn frame<'a>(positions: &'a [[f32; 4]], colouring: &'a Colouring) -> Frame<'a> {
        Frame { positions, colouring, walls: &[], radius: 0.2, container: None, solids: None, caption: "" }
    }

    fn numbers(of: &[f32]) -> Colouring {
        Colouring::Numbers { of: of.to_vec(), range: [0.0, 1.0], label: "" }
    }

    /// Returns how much darker a pixel is than the background.
    fn darkness(canvas: &Canvas, x: u32, y: u32) -> i32 {
        let sum = |pixel: [u8; 3]| pixel.map(i32::from).iter().sum::<i32>();
        let [corner, here] = [(0, 0), (x, y)].map(|(x, y)| canvas.pixel(x, y).map_or(0, sum));
        corner - here
    }

    #[test]
    fn nearer_disc_hides_the_farther_one_in_any_order() {
        // Seen horizontally from +x, the slow particle (deep blue) is in front of the fast one (white), then behind it.
        let view = View::Orbit { yaw_degrees: 90.0, pitch_degrees: 0.0 };
        let (near, far) = ([0.5, 1.0, 0.0, 0.0], [-0.5, 1.0, 0.0, 0.0]);
        let middle = |positions: &[[f32; 4]], shade: &[f32]| {
            darkness(&paint(&frame(positions, &numbers(shade)), &view, BOUNDS, 200, 100), 100, 50)
        };
        let slow_in_front = middle(&[near, far], &[0.0, 1.0]);
        assert!(slow_in_front > middle(&[near, far], &[1.0, 0.0]) + 150);
        assert_eq!(slow_in_front, middle(&[far, near], &[1.0, 0.0]));
    }

    #[test]
    fn same_input_gives_the_same_bytes_on_any_number_of_threads() {
        let positions: Vec<[f32; 4]> = (0..500)
            .map(|i| [(i * 7 % 97) as f32 / 60.0 - 0.8, (i * 13 % 89) as f32 / 60.0, (i % 11) as f32 / 8.0 - 0.7, 0.0])
            .collect();
        let colouring = numbers(&(0..500).map(|i| (i % 10) as f32 / 9.0).collect::<Vec<_>>());
        let picture = || {
            let frame = Frame { container: Some(BOUNDS), caption: "t = 1 s", ..frame(&positions, &colouring) };
            paint(&frame, &View::Orbit { yaw_degrees: 30.0, pitch_degrees: 20.0 }, BOUNDS, 160, 90)
        };
        let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool of one thread");
        assert!(picture() == picture() && picture() == alone.install(picture));
    }

    #[test]
    fn kinds_have_their_own_colours_and_walls_are_grey() {
        let key = [None, Some([0.9, 0.2, 0.1])].map(|own| Swatch::new("it".to_owned(), 0, own));
        let colouring = Colouring::Kinds { of: vec![0, 1, 2], key: key.into() };
        let positions = [[-0.6, 1.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.6, 1.0, 0.0, 0.0]];
        let frame = Frame { walls: &[[0.0, 0.4, 0.0, 0.0]], ..frame(&positions, &colouring) };
        let canvas = paint(&frame, &View::Flat, BOUNDS, 200, 100);
        // a metre takes 31 pixels
        let at = |x: u32, y: u32| canvas.pixel(x, y).map_or([0; 3], |pixel| pixel.map(i32::from));
        let [blue, red, none, grey] = [at(81, 50), at(100, 50), at(119, 50), at(100, 68)];
        assert!(blue[2] > blue[0] + 50, "{blue:?}");
        assert!(red[0] > red[2] + 50, "{red:?}");
        assert!(none[0] > none[1] + 50 && none[2] > none[1] + 50, "{none:?}");
        assert!(grey.iter().all(|part| (part - grey[1]).abs() < 50), "{grey:?}");
    }

    #[test]
    fn middle_of_the_bounds_is_the_middle_of_the_picture_and_broken_numbers_do_no_harm() {
        let positions = [[0.0, 1.0, 0.0, 0.0], [f32::NAN; 4], [f32::INFINITY, 0.0, 0.0, 0.0]];
        for view in [View::Flat, View::Orbit { yaw_degrees: -70.0, pitch_degrees: 35.0 }] {
            let canvas = paint(&frame(&positions, &numbers(&[0.0])), &view, BOUNDS, 200, 100);
            let dark: Vec<_> = (0..100)
                .flat_map(|y| (0..200).map(move |x| (x, y)))
                .filter(|&(x, y)| y < 80 && darkness(&canvas, x, y) > 100)
                .collect();
            let count = dark.len() as f32;
            let [x, y] = [dark.iter().map(|p| p.0).sum::<u32>(), dark.iter().map(|p| p.1).sum::<u32>()];
            assert!(count > 20.0);
            assert!((x as f32 / count + 0.5 - 100.0).abs() < 0.6 && (y as f32 / count + 0.5 - 50.0).abs() < 0.6);
        }
    }
}
