//! A drawing as what each format has: paths, lines of text and pictures, in named groups. Lengths are points, y down.

use egui::{Color32, FontId, Pos2, Rect, Vec2, emath::Rot2};

use crate::paint::{Image, Theme};

use super::face::Face;

/// How far egui slants what has no italics of its own: of its height.
pub const SLANT: f32 = 0.25;

pub struct VectorPage {
    pub size: Vec2,
    pub pixels_per_point: f32,
    pub theme: &'static Theme,
    /// Lowest first.
    pub items: Vec<Item>,
}

pub enum Item {
    Begin(&'static str),
    End,
    Drawn(Drawn),
}

pub struct Drawn {
    /// What lies outside of it is not seen; nothing where all of it is inside.
    pub clip: Option<Rect>,
    pub what: What,
}

pub enum What {
    Path(Path),
    Text(Text),
    Picture(Picture),
}

#[derive(Clone, PartialEq)]
pub struct Path {
    pub form: Form,
    pub fill: Option<Color32>,
    /// In the middle of the outline.
    pub stroke: Option<(f32, Color32)>,
}

#[derive(Clone, PartialEq)]
pub enum Form {
    /// An odd number of them goes round what is filled.
    Lines(Vec<Run>),
    Circle(Pos2, f32),
    /// With the radius of its corners.
    Rect(Rect, f32),
}

#[derive(Clone, PartialEq)]
pub struct Run {
    pub points: Vec<Pos2>,
    pub is_closed: bool,
}

/// What is read as one: a word, a formula, a sentence on several lines.
pub struct Text {
    /// As it is copied.
    pub plain: String,
    pub turn: Turn,
    pub letters: Vec<Letter>,
    /// Lines of quotients, and what else is drawn with letters.
    pub bars: Vec<Path>,
}

/// Round this point.
#[derive(Clone, Copy, PartialEq)]
pub struct Turn {
    pub around: Pos2,
    pub radians: f32,
}

#[derive(Clone)]
pub struct Letter {
    pub c: char,
    pub font: FontId,
    pub colour: Color32,
    /// Where its pen begins, on the line of letters.
    pub at: Pos2,
    pub advance: f32,
    pub is_italic: bool,
    /// Of its galley.
    pub row: usize,
}

/// Pixels, where shapes cannot say it.
pub struct Picture {
    pub rect: Rect,
    pub image: Image,
}

impl Item {
    pub const fn path(&self) -> Option<&Path> {
        match self {
            Self::Drawn(Drawn {
                what: What::Path(path),
                ..
            }) => Some(path),
            _ => None,
        }
    }

    /// Are both paths that may be one?
    pub fn joins(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Drawn(a), Self::Drawn(b)) if a.clip == b.clip => {
                let paths = self.path().zip(other.path());
                paths.is_some_and(|(a, b)| a.joins(b))
            }
            _ => false,
        }
    }
}

impl Drawn {
    /// Itself, where it is one, or those that stand among letters.
    pub fn paths(&self) -> &[Path] {
        match &self.what {
            What::Path(path) => std::slice::from_ref(path),
            What::Text(text) => &text.bars,
            What::Picture(_) => &[],
        }
    }
}

impl Turn {
    pub fn place(self, at: Pos2) -> Pos2 {
        self.around + Rot2::from_angle(self.radians) * (at - self.around)
    }
}

impl Text {
    /// Letters of one font file, size, colour and line, from left to right.
    pub fn runs(&self) -> impl Iterator<Item = &[Letter]> {
        self.letters.chunk_by(|a, b| {
            a.font == b.font
                && a.face().name == b.face().name
                && a.colour == b.colour
                && a.is_italic == b.is_italic
                && a.at.y == b.at.y
                && a.row == b.row
        })
    }
}

impl Letter {
    /// The font that it is taken from.
    pub fn face(&self) -> &'static Face {
        Face::of(&self.font.family, self.c).expect("every family has a font")
    }
}

impl Form {
    /// Triangles that stand for an area all turn the same way, and may touch: it is filled wherever one of them is, and not only where an
    /// odd number is.
    pub fn are_triangles(&self) -> bool {
        match self {
            Self::Lines(runs) => runs.len() > 1 && runs.iter().all(|run| run.points.len() == 3),
            Self::Circle(..) | Self::Rect(..) => false,
        }
    }
}

impl Path {
    /// May both be one element? Where they overlap, the colour must not count twice, nor a second outline make a hole.
    pub fn joins(&self, other: &Self) -> bool {
        let is_line = |path: &Self| matches!(path.form, Form::Lines(_)) && path.fill.is_none();
        let is_box = |path: &Self| matches!(path.form, Form::Rect(_, 0.0)) && path.stroke.is_none();
        let colours = [self.fill, self.stroke.map(|(_, colour)| colour)];
        (self.fill, self.stroke) == (other.fill, other.stroke)
            && colours
                .into_iter()
                .flatten()
                .all(|colour| colour.is_opaque())
            && ((is_line(self) && is_line(other)) || (is_box(self) && is_box(other)))
    }

    pub fn bounds(&self) -> Rect {
        let around = self.stroke.map_or(0.0, |(width, _)| 0.5 * width);
        let rect = match &self.form {
            Form::Lines(runs) => {
                let mut bounds = Rect::NOTHING;
                for at in runs.iter().flat_map(|run| &run.points) {
                    bounds.extend_with(*at);
                }
                bounds
            }
            Form::Circle(middle, radius) => {
                Rect::from_center_size(*middle, Vec2::splat(2.0 * radius))
            }
            Form::Rect(rect, _) => *rect,
        };
        rect.expand(around)
    }
}
