//! A view of three dimensions: solids and marks, and the eye that sees them.

use crate::{geom::Orbit, text::Value};

use super::{Label, Link, Role};

/// What is seen in space. It is turned into marks of a plane by [`super::project`], before anything is painted.
#[derive(Clone, PartialEq, Debug)]
pub struct Space {
    /// Where the eye stands until the viewer turns it.
    pub eye: Orbit,
    /// The faces of all solids.
    pub facets: Vec<Facet>,
    /// What is drawn over them.
    pub marks: Vec<Mark3>,
}

/// A face of a solid: convex and flat.
#[derive(Clone, PartialEq, Debug)]
pub struct Facet {
    /// Three or more, counter-clockwise as seen from outside.
    pub corners: Vec<[f64; 3]>,
    /// What it means.
    pub role: Role,
}

/// A mark in space.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark3 {
    /// Where and what.
    pub shape: Shape3,
    /// Its meaning.
    pub role: Role,
    /// Text beside it.
    pub label: Option<Label>,
    /// What it is about.
    pub link: Option<Link>,
}

/// Something to draw, at world coordinates.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shape3 {
    /// From a to b; dashed where a solid hides it.
    Segment([[f64; 3]; 2]),
    /// A filled point, seen through everything.
    Dot([f64; 3]),
    /// A hollow point, seen through everything.
    Ring([f64; 3]),
}

impl Facet {
    /// Its edges, each from a corner to the next.
    pub fn edges(&self) -> impl Iterator<Item = [[f64; 3]; 2]> + '_ {
        let n = self.corners.len();
        (0..n).map(move |i| [self.corners[i], self.corners[(i + 1) % n]])
    }
}

impl Mark3 {
    /// Without label or link.
    #[must_use]
    pub const fn new(role: Role, shape: Shape3) -> Self {
        Self {
            shape,
            role,
            label: None,
            link: None,
        }
    }

    /// With a label in the text face.
    #[must_use]
    pub fn labelled(mut self, text: impl Into<Value>) -> Self {
        self.label = Some(Label::new(text, false));
        self
    }

    /// About `link`.
    #[must_use]
    pub fn linked(mut self, link: impl Into<Link>) -> Self {
        self.link = Some(link.into());
        self
    }
}
