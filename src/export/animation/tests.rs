use super::*;
use crate::paint::ThemeKind;

fn picture(paint: impl Fn([usize; 2]) -> [u8; 3]) -> Image {
    let size = [12, 7];
    let pixels = (0..size[0] * size[1]).map(|i| paint([i % size[0], i / size[0]]));
    let rgba = pixels.flat_map(|[r, g, b]| [r, g, b, 255]).collect();
    Image { size, rgba }
}

fn reel<'a>(
    pictures: &'a [Image],
    link: Option<&'a str>,
) -> Reel<'a, impl Iterator<Item = Image> + use<'a>> {
    Reel {
        n_pictures: pictures.len(),
        pictures: pictures.iter().cloned(),
        theme: Theme::of(ThemeKind::Light),
        link,
    }
}

/// A part of a picture with its milliseconds, over the one before.
fn lay(shown: &mut Image, [x, y]: [usize; 2], width: usize, rgba: &[u8]) {
    for (row, pixels) in rgba.chunks(4 * width).enumerate() {
        for (column, pixel) in pixels.as_chunks::<4>().0.iter().enumerate() {
            let at = 4 * ((y + row) * shown.size[0] + x + column);
            if pixel[3] == 255 {
                shown.rgba[at..at + 4].copy_from_slice(pixel);
            }
        }
    }
}

fn played_apng(bytes: &[u8]) -> Vec<(Image, u16)> {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::ALPHA);
    let mut reader = decoder.read_info().expect("a PNG");
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
        let [width, height] = [control.width, control.height].map(of);
        let at = [control.x_offset, control.y_offset].map(of);
        lay(&mut shown, at, width, &frame[..4 * width * height]);
        all.push((shown.clone(), control.delay_num));
    }
    all
}

fn played_gif(bytes: &[u8]) -> Vec<(Image, u16)> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).expect("a GIF");
    let size = [decoder.width(), decoder.height()].map(usize::from);
    let mut shown = Image {
        size,
        rgba: vec![0; 4 * size[0] * size[1]],
    };
    let mut all = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("whole") {
        let at = [frame.left, frame.top].map(usize::from);
        lay(&mut shown, at, usize::from(frame.width), &frame.buffer);
        all.push((shown.clone(), 10 * frame.delay));
    }
    all
}

const WHITE: [u8; 3] = [255; 3];
/// The theme's ink, accent and signal.
const INK: [u8; 3] = [0x1B, 0x1F, 0x24];
const BLUE: [u8; 3] = [0x00, 0x72, 0xB2];
const RED: [u8; 3] = [0xD5, 0x5E, 0x00];

#[test]
fn what_is_played_is_what_was_drawn() {
    let pictures = [
        picture(|_| WHITE),
        picture(|[x, _]| if x == 3 { INK } else { WHITE }),
        picture(|[x, _]| if x == 3 { INK } else { WHITE }),
        picture(|[x, y]| match [x, y] {
            [10 | 11, 6] => BLUE,
            [0, 0] => RED,
            _ => WHITE,
        }),
    ];
    let apng = reel(&pictures, Some("#a/b")).apng();
    let gif = reel(&pictures, Some("#a/b")).gif();
    assert_eq!(crate::lesson::link_in(&apng).as_deref(), Some("#a/b"));
    for played in [played_apng(&apng), played_gif(&gif)] {
        let (shown, milliseconds): (Vec<_>, Vec<_>) = played.into_iter().unzip();
        assert_eq!(shown, pictures);
        assert_eq!(milliseconds[0], FIRST_MS);
        assert_eq!(milliseconds[2], LEAST_MS, "nothing is new");
        assert!(milliseconds[1] > LEAST_MS && milliseconds[1] < FIRST_MS);
        assert_eq!(milliseconds[3], LAST_MS);
    }
}

#[test]
fn one_picture_is_a_loop_too() {
    let only = [picture(|[x, _]| if x == 0 { BLUE } else { WHITE })];
    let expected = [(only[0].clone(), FIRST_MS)];
    assert_eq!(played_apng(&reel(&only, None).apng()), expected);
    assert_eq!(played_gif(&reel(&only, None).gif()), expected);
}

#[test]
fn soft_edges_keep_close_to_their_colour() {
    for kind in ThemeKind::ALL {
        let theme = Theme::of(kind);
        let mut palette = Palette::of(theme);
        assert!(Palette::alphas().len() == 256 && palette.bytes().len() == 768);
        for role in [
            theme.ink,
            theme.accent,
            theme.signal,
            theme.accepted,
            theme.soft,
        ] {
            for i in 0..=40_u8 {
                let colour = theme.background.lerp_to_gamma(role, f32::from(i) / 40.0);
                let [r, g, b, _] = colour.to_array();
                let image = Image {
                    size: [1, 1],
                    rgba: vec![r, g, b, 255],
                };
                let nth = usize::from(palette.plane(&image).indices[0]);
                let bytes = palette.bytes();
                let found = &bytes[3 * nth..3 * nth + 3];
                let off = found.iter().zip([r, g, b]).map(|(a, b)| a.abs_diff(b));
                assert!(off.max() <= Some(14), "{kind}: {found:?} for {r} {g} {b}");
            }
        }
    }
}
