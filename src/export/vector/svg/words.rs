//! Text, as text or as outlines.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::Write,
};

use base64::{Engine, engine::general_purpose::STANDARD as BASE64};
use egui::Color32;
use skrifa::outline::OutlinePen;

use crate::{
    export::vector::{
        face::Face,
        ink::Ink,
        number::number,
        page::{Letter, SLANT, Text},
        web_font::web_font,
    },
    paint::Theme,
};

use super::attributes::{escaped, ink_class};

/// How text is written in a file of shapes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Letters {
    /// As text, with the fonts that it needs, cut down to its characters.
    #[default]
    Fonts,
    /// As shapes: alike in programs that take no fonts from a file.
    Outlines,
}

pub struct Words {
    letters: Letters,
    /// By the name of its file.
    fonts: BTreeMap<&'static str, Used>,
    /// Each letter's outline once.
    outlines: String,
    known: BTreeMap<(&'static str, char), usize>,
}

/// A font that text needs, with its characters.
struct Used {
    /// Of its class.
    nth: usize,
    face: &'static Face,
    chars: BTreeSet<char>,
}

impl Words {
    pub const fn new(letters: Letters) -> Self {
        Self {
            letters,
            fonts: BTreeMap::new(),
            outlines: String::new(),
            known: BTreeMap::new(),
        }
    }

    /// The fonts that text needs, cut down to its characters, and their classes.
    pub fn style(&self) -> String {
        let mut style = String::new();
        for Used { nth, face, chars } in self.fonts.values() {
            let (family, weight) = face.family();
            let font = format!("font-family: \"{family}\"; font-weight: {weight};");
            let bytes = BASE64.encode(web_font(face, chars.iter().copied()));
            let _ = writeln!(
                style,
                "@font-face {{ {font} src: url(data:font/otf;base64,{bytes}); }}\n.f{nth} {{ {font} }}"
            );
        }
        style
    }

    pub fn outlines(&self) -> &str {
        &self.outlines
    }

    pub fn write(&mut self, out: &mut String, theme: &Theme, text: &Text) {
        let turn = if text.turn.radians == 0.0 {
            String::new()
        } else {
            let [x, y] = [text.turn.around.x, text.turn.around.y].map(number);
            let degrees = number(text.turn.radians.to_degrees());
            format!(" transform=\"rotate({degrees} {x} {y})\"")
        };
        let (open, close) = match self.letters {
            Letters::Fonts => ("text", "</text>\n"),
            Letters::Outlines => ("g", "</g>\n"),
        };
        let colour = most_common(text);
        let (class, fill) = ink_class(Ink::of(theme, colour), "", "fill");
        let class = class.map_or(String::new(), |class| format!(" class=\"{class}\""));
        let _ = write!(out, "<{open}{class}{fill}{turn}>");
        for run in text.runs() {
            match self.letters {
                Letters::Fonts => self.text(out, theme, run, colour),
                Letters::Outlines => self.shapes(out, theme, run, colour),
            }
        }
        out.push_str(close);
    }

    /// Letters of one font; spaces at its ends say where words end.
    fn text(&mut self, out: &mut String, theme: &Theme, run: &[Letter], most: Color32) {
        let face = run[0].face();
        let nth = self.fonts.len();
        let font = self.fonts.entry(face.name).or_insert_with(|| Used {
            nth,
            face,
            chars: BTreeSet::new(),
        });
        font.chars.extend(run.iter().map(|letter| letter.c));
        let paint = own_paint(theme, &run[0], most, Some(format!("f{}", font.nth)));
        let size = number(run[0].font.size);
        let y = number(run[0].at.y);
        let slant = if run[0].is_italic {
            " font-style=\"oblique\""
        } else {
            ""
        };
        let mut x = run
            .iter()
            .map(|letter| number(letter.at.x))
            .collect::<Vec<_>>()
            .join(" ");
        // Letters as the font itself places them need no places of their own.
        if is_as_placed(face, run) {
            x = number(run[0].at.x);
        }
        let plain: String = run.iter().map(|letter| letter.c).collect();
        let _ = write!(
            out,
            "<tspan{paint} x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{slant}>{}</tspan>",
            escaped(&plain)
        );
    }

    fn shapes(&mut self, out: &mut String, theme: &Theme, run: &[Letter], most: Color32) {
        let face = run[0].face();
        let slant = libm::atanf(SLANT).to_degrees();
        let scale = run[0].font.size / face.units;
        let paint = own_paint(theme, &run[0], most, None);
        for letter in run.iter().filter(|letter| !letter.c.is_whitespace()) {
            let next = self.known.len();
            let nth = *self.known.entry((face.name, letter.c)).or_insert_with(|| {
                let mut pen = PathPen(String::new());
                face.draw(letter.c, &mut pen);
                let _ = writeln!(self.outlines, "<path id=\"g{next}\" d=\"{}\"/>", pen.0);
                next
            });
            let [x, y] = [letter.at.x, letter.at.y].map(number);
            let slant = if letter.is_italic {
                format!(" skewX(-{slant:.2})")
            } else {
                String::new()
            };
            let _ = write!(
                out,
                "<use{paint} xlink:href=\"#g{nth}\" transform=\"translate({x} {y}){slant} scale({scale:.6} -{scale:.6})\"/>"
            );
        }
    }
}

fn most_common(text: &Text) -> Color32 {
    let mut counts: BTreeMap<[u8; 4], usize> = BTreeMap::new();
    for letter in &text.letters {
        *counts.entry(letter.colour.to_array()).or_default() += 1;
    }
    let most = counts.into_iter().max_by_key(|(_, n)| *n);
    let [r, g, b, a] = most.map_or([0; 4], |(colour, _)| colour);
    Color32::from_rgba_premultiplied(r, g, b, a)
}

/// What a letter's colour is, where it is not that of all.
fn own_paint(theme: &Theme, letter: &Letter, most: Color32, class: Option<String>) -> String {
    let (own, fill) = if letter.colour == most {
        (None, String::new())
    } else {
        ink_class(Ink::of(theme, letter.colour), "", "fill")
    };
    let classes: Vec<String> = own.into_iter().chain(class).collect();
    if classes.is_empty() {
        fill
    } else {
        format!(" class=\"{}\"{fill}", classes.join(" "))
    }
}

/// Does each letter stand where the one before has ended, by the widths of the font?
fn is_as_placed(face: &Face, run: &[Letter]) -> bool {
    const NEAR_PTS: f32 = 0.02;
    let scale = run[0].font.size / face.units;
    let mut at = run[0].at.x;
    run.iter().all(|letter| {
        let is_there = (letter.at.x - at).abs() < NEAR_PTS;
        at += face
            .glyph(letter.c)
            .map_or(0.0, |glyph| face.advance(glyph))
            * scale;
        is_there
    })
}

struct PathPen(String);

impl OutlinePen for PathPen {
    fn move_to(&mut self, x: f32, y: f32) {
        let _ = write!(self.0, "M{x} {y}");
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let _ = write!(self.0, "L{x} {y}");
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        let _ = write!(self.0, "Q{cx} {cy} {x} {y}");
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        let _ = write!(self.0, "C{ax} {ay} {bx} {by} {x} {y}");
    }

    fn close(&mut self) {
        self.0.push('Z');
    }
}
