//! A figure's files of shapes show what its picture shows. The reader is one that is not ours: resvg.

use std::process::Command;

use clipscope::{
    export::{Format, Handout, Letters, Options, Paper, Steps, Studio, Way, in_format, jobs},
    lesson::{Block, Course, Inline, Lesson, link_in},
    paint::{Image, ThemeKind},
    text::Lang,
};
use resvg::{tiny_skia, usvg};

const SIZE_PX: [u32; 2] = [1280, 720];

/// A pixel differs where its colour is beyond what the other picture has within a pixel of it, by more than this in any channel: what
/// is drawn half a pixel further, or with softer edges, does not.
const TOLERANCE: u8 = 64;
/// In thousandths of the pixels. The most that was seen: 0.13 in light, 0.08 in dark.
const MOST_DIFFERING: f64 = 0.5;

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

/// Each third figure in one theme or another: all of them in all themes take minutes.
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
        for (picture, shapes) in pictures.iter().zip(&shapes).skip(3 * nth).step_by(step()) {
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
        9
    }
}

#[test]
fn every_file_of_shapes_is_the_same_twice_and_carries_its_words_and_its_link() {
    let course = Course::embedded();
    let lesson = course.lesson("05-intervals").unwrap();
    let way = Way::of(options(ThemeKind::Light));
    for format in [Format::Svg, Format::Pdf, Format::Tikz] {
        let job = &in_format(jobs([lesson], Steps::Figures), format)[0];
        let mut studio = Studio::new(ThemeKind::Dark);
        let bytes = job.bytes(&mut studio, way);
        assert!(job.bytes(&mut studio, way) == bytes, "{format:?}");
        assert!(
            job.bytes(&mut Studio::new(ThemeKind::Light), way) == bytes,
            "{format:?}"
        );
        let text = String::from_utf8_lossy(&bytes);
        let parts: &[&str] = match format {
            Format::Svg => &[
                "<title",
                "<desc",
                "<g class=\"strokes\">",
                "class=\"accent\"",
                "<text",
            ],
            Format::Pdf => &[
                "/StructTreeRoot",
                "/Alt",
                "/Lang",
                "/ToUnicode",
                "/ActualText",
            ],
            _ => &["\\begin{tikzpicture}", "% strokes", "cs-accent", "$P_1$"],
        };
        for part in parts {
            // Contents are packed: what is in them is found by other readers.
            let is_packed = format == Format::Pdf && *part == "/ActualText";
            assert!(is_packed || text.contains(part), "{format:?}: {part}");
        }
        assert!(text.contains("#05-intervals/"), "{format:?}: its link");
        let opens = link_in(&bytes).is_some_and(|link| link.starts_with("#05-intervals/"));
        assert_eq!(opens, format == Format::Svg, "{format:?}");
    }
}

/// By poppler's program, where it is there.
fn text_of(pdf: &[u8]) -> Option<String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("handout.pdf");
    std::fs::write(&path, pdf).unwrap();
    let read = Command::new("pdftotext")
        .arg("-raw")
        .arg(&path)
        .arg("-")
        .output();
    let Ok(read) = read else {
        println!("there is no pdftotext: handouts have not been read");
        return None;
    };
    assert!(
        read.status.success(),
        "{}",
        String::from_utf8_lossy(&read.stderr)
    );
    Some(without_spaces(&String::from_utf8_lossy(&read.stdout)))
}

/// Where lines end differs.
fn without_spaces(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}

fn paragraphs(lesson: &Lesson, lang: Lang) -> Vec<String> {
    let plain = |text: &[Inline]| text.iter().map(|part| &*part.text).collect::<String>();
    let steps = (0..lesson.steps.len()).filter_map(|step| lesson.step_text(step, lang));
    let blocks = steps.flat_map(|text| &text.body);
    let blocks = blocks.filter_map(|block| match block {
        Block::Paragraph(text) | Block::ListItem { text, .. } | Block::Goal { text, .. } => {
            Some(without_spaces(&plain(text)))
        }
        Block::Answer(_) | Block::Code(_) | Block::Note(_) | Block::Wait => None,
    });
    blocks.collect()
}

#[test]
fn another_reader_finds_every_sentence_of_a_handout_in_its_order() {
    let course = Course::embedded();
    let lesson = course.lesson("05-intervals").unwrap();
    let mut studio = Studio::new(ThemeKind::Projector);
    for lang in Lang::ALL {
        let handout = Handout {
            paper: Paper::A4,
            lang,
            is_answered: false,
            page: Some("https://example.org/"),
        };
        let pdf = handout.pdf(&mut studio, lesson);
        assert!(handout.pdf(&mut studio, lesson) == pdf, "the same twice");
        let Some(text) = text_of(&pdf) else { return };
        let mut rest = &*text;
        for paragraph in paragraphs(lesson, lang) {
            let at = rest.find(&paragraph);
            let at = at.unwrap_or_else(|| panic!("{lang:?}: “{paragraph}” is not in\n{rest}"));
            rest = &rest[at + paragraph.len()..];
        }
        let answered = Handout {
            is_answered: true,
            ..handout
        };
        let answered = text_of(&answered.pdf(&mut studio, lesson)).unwrap();
        assert!(answered.len() > text.len(), "with answers there is more");
    }
}
