//! A figure's files of shapes show what its picture shows. The reader is one that is not ours: resvg.

use clipscope::{
    export::{Format, Letters, Options, Steps, Studio, Way, in_format, jobs},
    lesson::Course,
    paint::{Image, ThemeKind},
    text::Lang,
};
use resvg::{tiny_skia, usvg};

const SIZE_PX: [u32; 2] = [1280, 720];

/// A pixel differs where its colour is beyond what the other picture has within a pixel of it, by more than this in any channel: what
/// is drawn half a pixel further, or with softer edges, does not.
const TOLERANCE: u8 = 64;
/// In thousandths of the pixels; the most that any figure of the course has is written beside it.
const MOST_DIFFERING: f64 = 1.5;

fn options(theme: ThemeKind) -> Options {
    Options {
        size_px: SIZE_PX,
        theme,
        lang: Lang::En,
        steps: Steps::Figures,
        asks: false,
    }
}

type Pixels = Vec<[u8; 3]>;

fn shown(svg: &[u8]) -> Pixels {
    let tree = usvg::Tree::from_data(svg, &usvg::Options::default()).expect("a file of shapes");
    let [width, height] = SIZE_PX;
    let mut pixels = tiny_skia::Pixmap::new(width, height).expect("room for a picture");
    resvg::render(
        &tree,
        tiny_skia::Transform::identity(),
        &mut pixels.as_mut(),
    );
    let rgb = |pixel: &tiny_skia::PremultipliedColorU8| [pixel.red(), pixel.green(), pixel.blue()];
    pixels.pixels().iter().map(rgb).collect()
}

fn decoded(png: &[u8]) -> Pixels {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    bytes.as_chunks::<3>().0.to_vec()
}

/// Pixels of `a` that are not found in `b`, in thousandths.
fn differing(a: &Pixels, b: &Pixels) -> f64 {
    let [width, height] = SIZE_PX.map(|side| side as usize);
    let is_near = |x: usize, y: usize| {
        let pixel = a[y * width + x];
        if pixel == b[y * width + x] {
            return true;
        }
        let (mut min, mut max) = ([255; 3], [0; 3]);
        for y in y.saturating_sub(1)..(y + 2).min(height) {
            for x in x.saturating_sub(1)..(x + 2).min(width) {
                for channel in 0..3 {
                    min[channel] = b[y * width + x][channel].min(min[channel]);
                    max[channel] = b[y * width + x][channel].max(max[channel]);
                }
            }
        }
        (0..3).all(|i| {
            pixel[i] >= u8::saturating_sub(min[i], TOLERANCE)
                && pixel[i] <= u8::saturating_add(max[i], TOLERANCE)
        })
    };
    let far = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let n = far.filter(|&(x, y)| !is_near(x, y)).count();
    1000.0 * n as f64 / (width * height) as f64
}

/// In `target/vector/`, to be looked at.
fn keep(name: &str, pixels: &Pixels) {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("target/vector");
    std::fs::create_dir_all(&folder).unwrap();
    let rgba = pixels.iter().flat_map(|&[r, g, b]| [r, g, b, 255]);
    let image = Image {
        size: SIZE_PX.map(|side| side as usize),
        rgba: rgba.collect(),
    };
    std::fs::write(folder.join(name), image.to_png()).unwrap();
}

/// Each figure in one theme, the next one in the next.
#[test]
fn a_file_of_shapes_shows_what_the_picture_shows() {
    let course = Course::embedded();
    let pictures = jobs(&course.lessons, Steps::Figures);
    let shapes = in_format(pictures.clone(), Format::Svg);
    let only = std::env::var("CLIPSCOPE_ONLY").ok();
    let mut worst = [0.0, 0.0, 0.0];
    let mut failures = Vec::new();
    for (nth, kind) in ThemeKind::ALL.into_iter().enumerate() {
        let way = Way {
            letters: Letters::Outlines,
            ..Way::of(options(kind))
        };
        let mut studio = Studio::new(kind);
        for (picture, shapes) in pictures.iter().zip(&shapes).skip(nth).step_by(step()) {
            if only
                .as_ref()
                .is_some_and(|only| !picture.path.contains(only))
            {
                continue;
            }
            let drawn = decoded(&picture.bytes(&mut studio, way));
            let written = shown(&shapes.bytes(&mut studio, way));
            let share = differing(&drawn, &written).max(differing(&written, &drawn));
            worst[nth] = share.max(worst[nth]);
            if share > MOST_DIFFERING {
                failures.push(format!("{kind} {}: {share:.2} in 1000 pixels", shapes.path));
                let file = shapes.path.replace('/', "-");
                keep(&format!("{kind}-{file}-picture.png"), &drawn);
                keep(&format!("{kind}-{file}-shapes.png"), &written);
            }
        }
    }
    println!("the most in light, dark and projector: {worst:.2?}");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// `CLIPSCOPE_ALL=1` compares every figure in every theme; `CLIPSCOPE_ONLY=texture` those that are named so.
fn step() -> usize {
    if std::env::var_os("CLIPSCOPE_ALL").is_some() {
        1
    } else {
        3
    }
}
