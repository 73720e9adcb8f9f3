//! Marks: the things that are drawn, in world coordinates, and the text beside them.

use crate::{geom::Axis, text::Value};

use super::{
    role::{Link, Role},
    solids::Solids,
};

/// A corner of a textured triangle: its place, and (u, v) in the unit square that the texture fills.
pub type Texel = ([f64; 2], [f64; 2]);

/// Something to draw, at world coordinates.
#[derive(Clone, PartialEq, Debug)]
pub enum Shape {
    /// From a to b.
    Segment([[f64; 2]; 2]),
    /// A segment with a head at b: a vector, a normal.
    Arrow([[f64; 2]; 2]),
    /// A head alone, midway from a to b: the direction in which an edge runs.
    Heading([[f64; 2]; 2]),
    /// The whole line where a coordinate is constant.
    Border(Axis, f64),
    /// The line through two points, across the whole stage.
    Line([[f64; 2]; 2]),
    /// The ray from the first point through the second.
    Ray([[f64; 2]; 2]),
    /// Closed outlines of any shape, filled where an odd number of them goes round.
    Area(Vec<Vec<[f64; 2]>>),
    /// The same without the outlines.
    Fill(Vec<Vec<[f64; 2]>>),
    /// A closed outline of any shape, not filled.
    Outline(Vec<[f64; 2]>),
    /// From point to point, not closed.
    Path(Vec<[f64; 2]>),
    /// Everything to the left of the line from a to b, shaded, and the line itself. Its label stands on the other
    /// side, unless it says otherwise.
    HalfPlane([[f64; 2]; 2]),
    /// Everything to the left of the line from a to b, shaded, without the line.
    Wash([[f64; 2]; 2]),
    /// A bound: an arrowhead whose flat side is at a, pointing towards b, to where the bound allows.
    Bound([[f64; 2]; 2]),
    /// The arc at the first point, from the direction of the second to that of the third, the shorter way round.
    Angle([[f64; 2]; 3]),
    /// The small square that says that the directions from the first point to the other two are at right angles.
    RightAngle([[f64; 2]; 3]),
    /// Solids: the faces of them that are seen.
    Solids(Solids),
    /// Triangles with a texture on them: each corner's place, and its texture coordinates.
    Textured(Vec<[Texel; 3]>),
    /// A filled point.
    Dot([f64; 2]),
    /// A corner of an outline: smaller than a dot.
    Vertex([f64; 2]),
    /// A hollow point.
    Ring([f64; 2]),
    /// A small cross: a crossing that is not used.
    Cross([f64; 2]),
    /// Many segments, each too thin to be read by itself: the ones out of focus.
    Crowd(Vec<[[f64; 2]; 2]>),
    /// A label alone, anywhere inside the rectangle from a to b; infinite sides end at the stage's.
    Region([[f64; 2]; 2]),
    /// A label alone, beside a point.
    Label([f64; 2]),
}

/// A shape with its meaning.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark {
    /// Where and what.
    pub shape: Shape,
    /// Its meaning.
    pub role: Role,
    /// Text beside it.
    pub label: Option<Label>,
    /// What it is about.
    pub link: Option<Link>,
    /// Dashed whatever its role: not there to stay, and yet what the step is about.
    pub is_dashed: bool,
    /// It crosses tones of solids, and stands out from any of them by a casing in the ground's colour.
    pub is_cased: bool,
    /// Of its lines, where its role and its shape do not settle it.
    pub weight: Option<Weight>,
}

/// How much a line is to be seen.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Weight {
    /// Its width in points, before the theme's factor.
    pub points: f32,
    /// Of its colour, from 0 to 1.
    pub strength: f32,
}

impl Mark {
    /// Without label or link.
    pub const fn new(role: Role, shape: Shape) -> Self {
        Self {
            shape,
            role,
            label: None,
            link: None,
            is_dashed: false,
            is_cased: false,
            weight: None,
        }
    }

    /// With lines of this weight.
    pub const fn weighing(mut self, weight: Weight) -> Self {
        self.weight = Some(weight);
        self
    }

    /// Drawn with dashes, in its role's colour.
    pub const fn dashed(mut self) -> Self {
        self.is_dashed = true;
        self
    }

    /// With a label in the text face.
    pub fn labelled(mut self, text: impl Into<Value>) -> Self {
        self.label = Some(Label::new(text, false));
        self
    }

    /// With a label in the monospaced face.
    pub fn coded(mut self, text: impl Into<Value>) -> Self {
        self.label = Some(Label::new(text, true));
        self
    }

    /// Its label set semibold.
    pub fn strong(mut self) -> Self {
        if let Some(label) = &mut self.label {
            label.strong = true;
        }
        self
    }

    /// Its label in this direction from it, in the world.
    pub const fn toward(mut self, direction: [f64; 2]) -> Self {
        if let Some(label) = &mut self.label {
            label.toward = Some(direction);
        }
        self
    }

    /// With one character of its label in the signal's colour.
    pub const fn lit(mut self, character: usize) -> Self {
        if let Some(label) = &mut self.label {
            label.lit = Some(character);
        }
        self
    }

    /// About `link`.
    pub fn linked(mut self, link: impl Into<Link>) -> Self {
        self.link = Some(link.into());
        self
    }
}

/// Text beside a mark. The painter finds a place near the anchor where it covers nothing.
#[derive(Clone, PartialEq, Debug)]
pub struct Label {
    /// What it says.
    pub text: Value,
    /// Set in the monospaced face: codes and numbers.
    pub mono: bool,
    /// The one thing that matters here: semibold.
    pub strong: bool,
    /// The direction, in the world, in which it has to stand off its mark; for an inequality, where it holds.
    pub toward: Option<[f64; 2]>,
    /// The character, by its index, that is this step's: drawn in the signal's colour, as one bit of a code.
    pub lit: Option<usize>,
}

impl Label {
    pub(super) fn new(text: impl Into<Value>, mono: bool) -> Self {
        Self {
            text: text.into(),
            mono,
            strong: false,
            toward: None,
            lit: None,
        }
    }
}
