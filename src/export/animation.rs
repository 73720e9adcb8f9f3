//! A run as a loop of pictures, an animated PNG: of each picture what differs from the one before is written.

use png::{
    BitDepth, BlendOp, ColorType, Compression, DisposeOp, Encoder, EncodingError, Filter, Writer,
};

use crate::{lesson::with_link, paint::Image};

/// What everyone has seen, and what takes time to read, in milliseconds: a picture that is new from edge to edge stands for both.
const LEAST_MS: u16 = 800;
const MORE_MS: f64 = 1_600.0;
const FIRST_MS: u16 = LEAST_MS + MORE_MS as u16;
/// The end of a run is looked at, then it begins anew.
const LAST_MS: u16 = 3_000;

/// What differs between two pictures: a rectangle, and how much of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Change {
    min: [usize; 2],
    size: [usize; 2],
    n_pixels: usize,
}

impl Change {
    /// A picture that is as the one before has a pixel of it written again: there is no frame without.
    fn between(before: &Image, now: &Image) -> Self {
        let [width, _] = now.size;
        let (mut min, mut max, mut n_pixels) = ([usize::MAX; 2], [0; 2], 0);
        let pairs = before.pixels().iter().zip(now.pixels());
        for (i, _) in pairs.enumerate().filter(|(_, (was, is))| was != is) {
            let at = [i % width, i / width];
            n_pixels += 1;
            for axis in 0..2 {
                min[axis] = min[axis].min(at[axis]);
                max[axis] = max[axis].max(at[axis] + 1);
            }
        }
        if n_pixels == 0 {
            (min, max) = ([0; 2], [1; 2]);
        }
        Self {
            min,
            size: [max[0] - min[0], max[1] - min[1]],
            n_pixels,
        }
    }

    fn milliseconds(&self, of: &Image) -> u16 {
        let share = self.n_pixels as f64 / of.pixels().len() as f64;
        LEAST_MS + (MORE_MS * share.min(1.0).sqrt()).round() as u16
    }

    /// What of it is as it was is left empty, which takes next to no bytes.
    fn pixels(&self, before: &Image, now: &Image) -> Vec<u8> {
        let [width, _] = now.size;
        let rows = self.min[1]..self.min[1] + self.size[1];
        let mut pixels = Vec::with_capacity(4 * self.size[0] * self.size[1]);
        for row in rows {
            let row = row * width + self.min[0]..row * width + self.min[0] + self.size[0];
            let pairs = before.pixels()[row.clone()].iter().zip(&now.pixels()[row]);
            let left = |(was, is): (&[u8; 4], &[u8; 4])| if was == is { [0; 4] } else { *is };
            pixels.extend(pairs.flat_map(left));
        }
        pixels
    }
}

/// The bytes of an animated PNG of `n_pictures` that plays for ever; programs that know none show the first picture. No more than two
/// pictures are kept in memory at a time.
///
/// # Panics
/// If there are not just `n_pictures`, at least one, all of one size.
pub fn animated(
    n_pictures: usize,
    pictures: impl Iterator<Item = Image>,
    link: Option<&str>,
) -> Vec<u8> {
    let mut bytes = Vec::new();
    encode(&mut bytes, n_pictures, pictures, link)
        .expect("so many pictures of one size, and memory takes every write");
    bytes
}

fn encode(
    bytes: &mut Vec<u8>,
    n_pictures: usize,
    mut pictures: impl Iterator<Item = Image>,
    link: Option<&str>,
) -> Result<(), EncodingError> {
    let mut before = pictures.next().expect("there is a first picture");
    let [width, height] = before.size.map(|side| side as u32);
    let mut encoder = Encoder::new(bytes, width, height);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    // Measured on a run of Liang–Barsky at 1280 × 720: a quarter fewer bytes than with the best filter of each row, for most of what is
    // written is empty.
    encoder.set_compression(Compression::High);
    encoder.set_filter(Filter::NoFilter);
    encoder.set_animated(n_pictures as u32, 0)?;
    encoder.set_frame_delay(FIRST_MS, 1000)?;
    encoder.set_dispose_op(DisposeOp::None)?;
    if let Some(link) = link {
        with_link(&mut encoder, link)?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&before.rgba)?;
    for (nth, now) in pictures.enumerate() {
        assert_eq!(now.size, before.size, "a loop's pictures are alike");
        write_change(&mut writer, (&before, &now), nth + 2 == n_pictures)?;
        before = now;
    }
    writer.finish()
}

fn write_change(
    writer: &mut Writer<&mut Vec<u8>>,
    (before, now): (&Image, &Image),
    is_last: bool,
) -> Result<(), EncodingError> {
    let change = Change::between(before, now);
    let [x, y] = change.min.map(|at| at as u32);
    let [width, height] = change.size.map(|side| side as u32);
    // The place first within the picture, then its size: each is checked against the other.
    writer.reset_frame_position()?;
    writer.set_frame_dimension(width, height)?;
    writer.set_frame_position(x, y)?;
    let milliseconds = if is_last {
        LAST_MS
    } else {
        change.milliseconds(now)
    };
    writer.set_frame_delay(milliseconds, 1000)?;
    writer.set_blend_op(BlendOp::Over)?;
    writer.write_image_data(&change.pixels(before, now))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(paint: impl Fn([usize; 2]) -> [u8; 3]) -> Image {
        let size = [12, 7];
        let pixels = (0..size[0] * size[1]).map(|i| paint([i % size[0], i / size[0]]));
        let rgba = pixels.flat_map(|[r, g, b]| [r, g, b, 255]).collect();
        Image { size, rgba }
    }

    /// The pictures as a program shows them, each over the one before, with their milliseconds.
    fn played(bytes: &[u8]) -> Vec<(Image, u16)> {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
            .read_info()
            .expect("a PNG");
        let info = reader.info();
        let size = [info.width as usize, info.height as usize];
        let n_frames = info.animation_control().expect("it is animated").num_frames;
        let mut shown = Image {
            size,
            rgba: vec![0; 4 * size[0] * size[1]],
        };
        let mut all = Vec::new();
        for _ in 0..n_frames {
            let mut frame = vec![0; reader.output_buffer_size().expect("it is small")];
            reader.next_frame(&mut frame).expect("as many as it says");
            let control = *reader.info().frame_control().expect("each has one");
            let of = |value: u32| value as usize;
            let [x, y] = [control.x_offset, control.y_offset].map(of);
            let [width, height] = [control.width, control.height].map(of);
            let rows = frame.chunks(4 * width).take(height);
            for (row, pixels) in rows.enumerate() {
                for (column, pixel) in pixels.as_chunks::<4>().0.iter().enumerate() {
                    let at = 4 * ((y + row) * size[0] + x + column);
                    if pixel[3] == 255 {
                        shown.rgba[at..at + 4].copy_from_slice(pixel);
                    }
                }
            }
            all.push((shown.clone(), control.delay_num));
        }
        all
    }

    #[test]
    fn what_is_played_is_what_was_drawn() {
        let pictures = [
            picture(|_| [255; 3]),
            picture(|[x, _]| if x == 3 { [9, 8, 7] } else { [255; 3] }),
            picture(|[x, _]| if x == 3 { [9, 8, 7] } else { [255; 3] }),
            picture(|[x, y]| if x > 9 && y == 6 { [0; 3] } else { [255; 3] }),
        ];
        let bytes = animated(pictures.len(), pictures.iter().cloned(), Some("#a/b"));
        let (shown, milliseconds): (Vec<_>, Vec<_>) = played(&bytes).into_iter().unzip();
        assert_eq!(shown, pictures);
        assert_eq!(milliseconds[0], FIRST_MS);
        assert_eq!(milliseconds[2], LEAST_MS, "nothing is new");
        assert!(milliseconds[1] > LEAST_MS && milliseconds[1] < FIRST_MS);
        assert_eq!(milliseconds[3], LAST_MS);
        assert_eq!(crate::lesson::link_in(&bytes).as_deref(), Some("#a/b"));
    }

    #[test]
    fn one_picture_is_a_loop_too() {
        let only = picture(|[x, y]| [x as u8, y as u8, 0]);
        let shown = played(&animated(1, std::iter::once(only.clone()), None));
        assert_eq!(shown, [(only, FIRST_MS)]);
    }
}
