//! A drawing surface of bytes: pictures, error maps, the error scale and lettering, saved as PNG.

use super::picture::{error_color, Picture};
use embedded_graphics::mono_font::{ascii, MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Pixel, Point, Size};
use embedded_graphics::text::{Alignment, Baseline, Text};
use embedded_graphics::Drawable;
use std::convert::Infallible;
use std::path::Path;

/// Sizes of lettering.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letters {
    /// 6×12 pixels a letter.
    Small,
    /// 8×13 pixels a letter, bold.
    Bold,
}

impl Letters {
    fn font(self) -> &'static MonoFont<'static> {
        match self {
            Self::Small => &ascii::FONT_6X12,
            Self::Bold => &ascii::FONT_8X13_BOLD,
        }
    }

    /// Width of a text in pixels.
    pub fn width(self, text: &str) -> usize {
        text.chars().count() * self.font().character_size.width as usize
    }
}

/// An image of sRGB bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<[u8; 3]>,
}

impl Canvas {
    /// A canvas of one color.
    pub fn new(width: usize, height: usize, color: [u8; 3]) -> Self {
        Self { width, height, pixels: vec![color; width * height] }
    }

    /// Draws a picture with its upper left corner at a place, all of it.
    pub fn picture(&mut self, picture: &Picture, at: [usize; 2]) {
        self.bytes(&picture.encoded(), picture.width, at);
    }

    /// Draws the errors of a picture `width` pixels wide; `largest` is drawn brightest.
    pub fn errors(&mut self, errors: &[f32], width: usize, largest: f32, at: [usize; 2]) {
        let bytes: Vec<[u8; 3]> = errors.iter().map(|error| error_color(error / largest)).collect();
        self.bytes(&bytes, width, at);
    }

    /// Draws the colors of error maps from left to right.
    pub fn error_scale(&mut self, at: [usize; 2], size: [usize; 2]) {
        let row = (0..size[0]).map(|column| error_color((column as f32 + 0.5) / size[0] as f32));
        let row: Vec<[u8; 3]> = row.collect();
        self.bytes(&row.repeat(size[1]), size[0], at);
    }

    /// Fills a rectangle with colors that change from `top` to `bottom`.
    pub fn shade(&mut self, at: [usize; 2], size: [usize; 2], top: [u8; 3], bottom: [u8; 3]) {
        for row in 0..size[1] {
            let along = row as f32 / size[1].max(2).saturating_sub(1) as f32;
            let mix = |from: u8, to: u8| (f32::from(from) + along * (f32::from(to) - f32::from(from)) + 0.5) as u8;
            let color = std::array::from_fn(|channel| mix(top[channel], bottom[channel]));
            self.bytes(&vec![color; size[0]], size[0], [at[0], at[1] + row]);
        }
    }

    /// Writes a line of ASCII text whose upper left corner is at a place.
    pub fn text(&mut self, text: &str, at: [usize; 2], letters: Letters, color: [u8; 3]) {
        let style = MonoTextStyle::new(letters.font(), Rgb888::new(color[0], color[1], color[2]));
        let place = Point::new(at[0] as i32, at[1] as i32);
        let mut line = Text::with_baseline(text, place, style, Baseline::Top);
        line.text_style.alignment = Alignment::Left;
        let Ok(_) = line.draw(self);
    }

    /// The canvas with a line of ASCII text below it.
    pub fn with_line(&self, text: &str, color: [u8; 3]) -> Self {
        let mut taller = Self::new(self.width, self.height + 16, [255; 3]);
        taller.bytes(&self.pixels, self.width, [0, 0]);
        taller.text(text, [4, self.height + 2], Letters::Small, color);
        taller
    }

    /// Writes the canvas as a PNG file.
    ///
    /// # Errors
    /// Those of the encoder and of the file system.
    pub fn save(&self, path: &Path) -> Result<(), image::ImageError> {
        let bytes: Vec<u8> = self.pixels.iter().flatten().copied().collect();
        let file = std::io::BufWriter::new(std::fs::File::create(path)?);
        let encoder = image::codecs::png::PngEncoder::new_with_quality(
            file,
            image::codecs::png::CompressionType::Best,
            image::codecs::png::FilterType::Adaptive,
        );
        let (width, height) = (self.width as u32, self.height as u32);
        image::ImageEncoder::write_image(encoder, &bytes, width, height, image::ExtendedColorType::Rgb8)
    }

    /// Writes the canvas as a PNG file of 256 colors, chosen from its own: less than half as large.
    ///
    /// # Errors
    /// Those of the encoder and of the file system.
    pub fn save_indexed(&self, path: &Path) -> Result<(), png::EncodingError> {
        let opaque: Vec<u8> = self.pixels.iter().flat_map(|[red, green, blue]| [*red, *green, *blue, 255]).collect();
        // 1 looks at every pixel.
        let palette = color_quant::NeuQuant::new(1, 256, &opaque);
        let indices: Vec<u8> = opaque.chunks_exact(4).map(|pixel| palette.index_of(pixel) as u8).collect();
        let file = std::io::BufWriter::new(std::fs::File::create(path)?);
        let mut encoder = png::Encoder::new(file, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_palette(palette.color_map_rgb());
        encoder.set_compression(png::Compression::High);
        // Neighboring indices are no neighboring colors: differences say nothing.
        encoder.set_filter(png::Filter::NoFilter);
        encoder.write_header()?.write_image_data(&indices)
    }

    fn bytes(&mut self, bytes: &[[u8; 3]], width: usize, at: [usize; 2]) {
        for (row, line) in bytes.chunks(width.max(1)).enumerate() {
            let (left, top) = (at[0].min(self.width), at[1] + row);
            let shown = line.len().min(self.width - left);
            if top < self.height {
                let start = top * self.width + left;
                self.pixels[start..start + shown].copy_from_slice(&line[..shown]);
            }
        }
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.width as u32, self.height as u32)
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            let inside = |place: i32, size: usize| usize::try_from(place).ok().filter(|&place| place < size);
            if let (Some(column), Some(row)) = (inside(at.x, self.width), inside(at.y, self.height)) {
                self.pixels[row * self.width + column] = [color.r(), color.g(), color.b()];
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawing_stays_on_the_canvas() {
        let mut canvas = Canvas::new(20, 20, [9; 3]);
        canvas.shade([15, 19], [30, 30], [0; 3], [255; 3]);
        canvas.error_scale([40, 40], [3, 3]);
        canvas.text("wide lettering", [2, 1], Letters::Bold, [1; 3]);
        assert_eq!(canvas.pixels.len(), 400);
        assert_eq!(canvas.pixels[0], [9; 3]);
        assert_eq!(canvas.pixels[19 * 20 + 19], [0; 3]);
        assert!(canvas.pixels.contains(&[1; 3]));
        let taller = canvas.with_line("below", [2; 3]);
        assert!(taller.pixels[..400] == canvas.pixels && taller.pixels[400..].contains(&[2; 3]));
    }
}
