//! Marks: the things that are drawn, in world coordinates.

use crate::{geom::Axis, text::Value};

use super::{
    role::{Label, Link, Role, told},
    solids::Solids,
};

/// A corner of a textured triangle: its place, and (u, v) in the unit square that the texture fills.
pub type Texel = ([f64; 2], [f64; 2]);

#[derive(Clone, PartialEq, Debug)]
pub enum Shape {
    Segment([[f64; 2]; 2]),
    Arrow([[f64; 2]; 2]),
    /// A head alone, midway from a to b: the direction in which an edge runs.
    Heading([[f64; 2]; 2]),
    Border(Axis, f64),
    Line([[f64; 2]; 2]),
    Ray([[f64; 2]; 2]),
    Area(Vec<Vec<[f64; 2]>>),
    Fill(Vec<Vec<[f64; 2]>>),
    /// Strokes across what an odd number of outlines goes round: what is not agreed about.
    Hatch(Vec<Vec<[f64; 2]>>),
    Outline(Vec<[f64; 2]>),
    Path(Vec<[f64; 2]>),
    /// What is to the left of a → b, shaded, and the line. Its label stands on the other side, unless it says otherwise.
    HalfPlane([[f64; 2]; 2]),
    /// Everything to the left of the line from a to b, shaded, without the line.
    Wash([[f64; 2]; 2]),
    /// A bound: an arrowhead whose flat side is at a, pointing towards b, to where the bound allows.
    Bound([[f64; 2]; 2]),
    Angle([[f64; 2]; 3]),
    RightAngle([[f64; 2]; 3]),
    Solids(Solids),
    Textured(Vec<[Texel; 3]>),
    Dot([f64; 2]),
    Vertex([f64; 2]),
    Ring([f64; 2]),
    Cross([f64; 2]),
    /// Many segments, each too thin to be read by itself: the ones out of focus.
    Crowd(Vec<[[f64; 2]; 2]>),
    /// A label alone, anywhere inside the rectangle from a to b; infinite sides end at the stage's.
    Region([[f64; 2]; 2]),
    Label([f64; 2]),
}

impl Shape {
    pub const fn dot_or_ring(is_dot: bool, at: [f64; 2]) -> Self {
        if is_dot {
            Self::Dot(at)
        } else {
            Self::Ring(at)
        }
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct Mark {
    pub shape: Shape,
    pub role: Role,
    pub label: Option<Label>,
    pub link: Option<Link>,
    /// Dashed whatever its role: not there to stay, and yet what the step is about.
    pub is_dashed: bool,
    /// It crosses tones of solids, and stands out from any of them by a casing in the ground's colour.
    pub is_cased: bool,
    pub weight: Option<Weight>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Weight {
    /// Its width in points, before the theme's factor.
    pub points: f32,
    /// Of its colour, from 0 to 1.
    pub strength: f32,
}

impl Weight {
    pub const fn of(points: f32) -> Self {
        let strength = 1.0;
        Self { points, strength }
    }
}

told!(Mark);

impl Mark {
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

    pub const fn weighing(mut self, weight: Weight) -> Self {
        self.weight = Some(weight);
        self
    }

    pub fn coded(mut self, text: impl Into<Value>) -> Self {
        self.label = Some(Label::new(text, true));
        self
    }

    pub const fn toward(mut self, direction: [f64; 2]) -> Self {
        if let Some(label) = &mut self.label {
            label.toward = Some(direction);
        }
        self
    }

    pub const fn lit(mut self, character: usize) -> Self {
        if let Some(label) = &mut self.label {
            label.lit = Some(character);
        }
        self
    }
}
