//! A run as a loop of pictures, in the colours of its theme's palette: of each picture what differs from the one before is written.

mod change;
mod palette;
#[cfg(test)]
mod tests;

use gif::{AnyExtension, DisposalMethod, EncodingError as GifError, Frame, Repeat};
use png::{BitDepth, BlendOp, ColorType, Compression, DisposeOp, EncodingError, Filter};

use crate::{
    lesson::with_link,
    paint::{Image, Theme},
};

use change::{Change, LEAST_MS, MORE_MS};
use palette::{CLEAR, Palette, Plane};

/// The first picture is new from edge to edge.
const FIRST_MS: u16 = LEAST_MS + MORE_MS as u16;
/// The end of a run is looked at, then it begins anew.
const LAST_MS: u16 = 3_000;

/// The pictures of a run, to be drawn one after the other.
pub struct Reel<'a, P> {
    /// At least one.
    pub n_pictures: usize,
    /// Just so many, all of one size.
    pub pictures: P,
    pub theme: &'a Theme,
    pub link: Option<&'a str>,
}

/// What is written of a picture: a part of it, and for how long it stands.
struct Part {
    min: [usize; 2],
    size: [usize; 2],
    /// By number in the palette; [`CLEAR`] where it is as before.
    indices: Vec<u8>,
    milliseconds: u16,
}

impl<P: Iterator<Item = Image>> Reel<'_, P> {
    /// The bytes of an animated PNG that plays for ever; programs that know none show the first picture.
    pub fn apng(self) -> Vec<u8> {
        let mut bytes = Vec::new();
        self.encode_apng(&mut bytes)
            .expect("so many pictures of one size, and memory takes every write");
        bytes
    }

    /// The bytes of a GIF that plays for ever.
    pub fn gif(self) -> Vec<u8> {
        let mut bytes = Vec::new();
        self.encode_gif(&mut bytes)
            .expect("so many pictures of one size, and memory takes every write");
        bytes
    }

    /// What is written of each picture. No more than two are kept in memory at a time.
    fn parts(self, mut palette: Palette) -> impl Iterator<Item = Part> {
        let mut before: Option<Plane> = None;
        let last = self.n_pictures - 1;
        self.pictures.enumerate().map(move |(nth, picture)| {
            let now = palette.plane(&picture);
            let mut part = match &before {
                Some(before) => {
                    let change = Change::between(before, &now);
                    Part {
                        min: change.min,
                        size: change.size,
                        indices: change.indices(before, &now),
                        milliseconds: change.milliseconds(&now),
                    }
                }
                None => Part {
                    min: [0; 2],
                    size: now.size,
                    indices: now.indices.clone(),
                    milliseconds: FIRST_MS,
                },
            };
            if nth > 0 && nth == last {
                part.milliseconds = LAST_MS;
            }
            before = Some(now);
            part
        })
    }

    fn encode_apng(self, bytes: &mut Vec<u8>) -> Result<(), EncodingError> {
        let (n_pictures, link) = (self.n_pictures as u32, self.link);
        let palette = Palette::of(self.theme);
        let colours = palette.bytes();
        let mut parts = self.parts(palette).peekable();
        let first = parts.peek().expect("a loop has a picture");
        let [width, height] = first.size.map(|side| side as u32);
        let mut encoder = png::Encoder::new(bytes, width, height);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_palette(colours);
        encoder.set_trns(Palette::alphas());
        // Most of what is written is empty: filters would only hide that.
        encoder.set_compression(Compression::High);
        encoder.set_filter(Filter::NoFilter);
        encoder.set_animated(n_pictures, 0)?;
        encoder.set_blend_op(BlendOp::Over)?;
        encoder.set_dispose_op(DisposeOp::None)?;
        if let Some(link) = link {
            with_link(&mut encoder, link)?;
        }
        let mut writer = encoder.write_header()?;
        for part in parts {
            let [x, y] = part.min.map(|at| at as u32);
            let [width, height] = part.size.map(|side| side as u32);
            // The place first within the picture, then its size: each is checked against the other.
            writer.reset_frame_position()?;
            writer.set_frame_dimension(width, height)?;
            writer.set_frame_position(x, y)?;
            writer.set_frame_delay(part.milliseconds, 1000)?;
            writer.write_image_data(&part.indices)?;
        }
        writer.finish()
    }

    fn encode_gif(self, bytes: &mut Vec<u8>) -> Result<(), GifError> {
        let link = self.link;
        let palette = Palette::of(self.theme);
        let colours = palette.bytes();
        let mut parts = self.parts(palette).peekable();
        let first = parts.peek().expect("a loop has a picture");
        let [width, height] = first.size.map(|side| side as u16);
        let mut encoder = gif::Encoder::new(bytes, width, height, &colours)?;
        encoder.set_repeat(Repeat::Infinite)?;
        if let Some(link) = link {
            const COMMENT: AnyExtension = AnyExtension(0xFE);
            let blocks: Vec<&[u8]> = link.as_bytes().chunks(255).collect();
            encoder.write_raw_extension(COMMENT, &blocks)?;
        }
        for part in parts {
            let [left, top] = part.min.map(|at| at as u16);
            let [width, height] = part.size.map(|side| side as u16);
            encoder.write_frame(&Frame {
                delay: part.milliseconds / 10,
                dispose: DisposalMethod::Keep,
                transparent: Some(CLEAR),
                left,
                top,
                width,
                height,
                buffer: part.indices.into(),
                ..Frame::default()
            })?;
        }
        Ok(())
    }
}
