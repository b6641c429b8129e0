//! The finished picture, and writing it as a PNG file.

use std::ffi::OsString;
use std::io::{Error, ErrorKind, Result};
use std::path::Path;

/// A picture of sRGB pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canvas {
    width: u32,
    height: u32,
    /// Red, green and blue of every pixel, row by row from the top.
    bytes: Vec<u8>,
}

impl Canvas {
    /// Returns a picture of the given bytes, three per pixel.
    pub(super) fn new(width: u32, height: u32, bytes: Vec<u8>) -> Self {
        Self { width, height, bytes }
    }

    /// Width, pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height, pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Returns red, green and blue of the pixel `x` from the left and `y` from the top; `None` outside of the picture.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        if x >= self.width {
            return None;
        }
        let start = (y as usize * self.width as usize + x as usize) * 3;
        self.bytes.get(start..)?.first_chunk().copied()
    }

    /// Fills a rectangle, clipped to the picture.
    pub(super) fn fill(&mut self, [x, y]: [i32; 2], [wide, high]: [i32; 2], colour: [u8; 3]) {
        let (width, height) = (self.width as i32, self.height as i32);
        let [left, right] = [x, x + wide].map(|x| x.clamp(0, width) as usize * 3);
        for row in y.clamp(0, height)..(y + high).clamp(0, height) {
            let start = row as usize * self.width as usize * 3;
            for pixel in self.bytes[start + left..start + right.max(left)].chunks_exact_mut(3) {
                pixel.copy_from_slice(&colour);
            }
        }
    }

    /// Writes the picture as a PNG file.
    ///
    /// The bytes go to a temporary file next to it that is then renamed, so that no reader sees a partial picture:
    /// another program may watch the path to show the latest frame of a run.
    ///
    /// # Errors
    ///
    /// If the path has no file name, or the file cannot be written. The message contains the path.
    pub fn write_png(&self, path: &Path) -> Result<()> {
        let told = |error: Error| Error::new(error.kind(), format!("cannot write picture {}: {error}", path.display()));
        let name = path.file_name().ok_or_else(|| told(Error::new(ErrorKind::InvalidInput, "no file name")))?;
        let mut part = OsString::from(name);
        part.push(format!(".{}.part", std::process::id()));
        let part = path.with_file_name(part);

        let bytes = self.encode().map_err(told)?;
        std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, path)).map_err(|error| {
            let _ = std::fs::remove_file(&part); // the first error is the one to report
            told(error)
        })
    }

    /// Returns the bytes of the PNG file.
    fn encode(&self) -> Result<Vec<u8>> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.bytes)?;
        writer.finish()?;
        Ok(file)
    }
}
