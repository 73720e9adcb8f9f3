//! What a step shows: one view or several, side by side.

use crate::text::{Formula, Value};

use super::{
    graph::Graph,
    mark::Mark,
    role::Link,
    small_pictures::{Multiples, Raster, Ribbon, SpaceRow, Story},
    space::Space,
    values::{Bits, Costs, Gauges, Lists, MatrixProduct, Products, Table},
};

/// The same from step to step and for compared methods: pan, zoom and orbit are remembered under it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub struct ViewId(pub &'static str);

impl ViewId {
    pub const PLANE: Self = Self("plane");
    /// What a method leaves and takes for it, where it is told that another one leaves the same.
    pub const AGREEMENT: Self = Self("agreement");
    /// What a method asks, as a row of a table: seen only where several are one drawing.
    pub const ASKED: Self = Self("asked-beside");
}

#[derive(Clone, PartialEq, Debug)]
pub struct View {
    pub id: ViewId,
    pub body: Body,
}

impl View {
    pub const fn plane(marks: Vec<Mark>) -> Self {
        Self {
            id: ViewId::PLANE,
            body: Body::Plane(marks),
        }
    }

    pub const fn new(id: &'static str, body: Body) -> Self {
        let id = ViewId(id);
        Self { id, body }
    }
}

#[derive(Clone, PartialEq, Debug)]
pub enum Body {
    Plane(Vec<Mark>),
    Space(Space),
    Raster(Raster),
    Bits(Bits),
    Table(Table),
    Lists(Lists),
    Products(Products),
    NumberLine(NumberLine),
    Clippers(ClipperRow),
    Gauges(Gauges),
    Ribbon(Ribbon),
    Multiples(Multiples),
    Matrix(MatrixProduct),
    Spaces(SpaceRow),
    Graph(Graph),
    Story(Story),
    Costs(Costs),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    Entering,
    Leaving,
}

impl Side {
    /// Of a line that is inside a border for u·p ≤ q, p not being 0.
    pub fn of(p: f64) -> Self {
        if p < 0.0 {
            Self::Entering
        } else {
            Self::Leaving
        }
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct LineTick {
    pub u: f64,
    pub value: Formula,
    pub side: Side,
    pub holds: bool,
    pub current: bool,
    pub name: Value,
    pub link: Option<Link>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct NumberLine {
    pub symbol: &'static str,
    pub ends: [Value; 2],
    /// The part of the axis that is shown, 0 and 1 always: the same at every step of a run.
    pub shown: [f64; 2],
    /// Lower and upper bound so far: out of order where they have passed each other.
    pub interval: [f64; 2],
    pub values: [Formula; 2],
    pub empty: bool,
    pub ticks: Vec<LineTick>,
    /// Into how many equal parts the segment is divided, and what is said of the part that is left.
    pub kept: Option<(usize, Value)>,
}

impl NumberLine {
    const MOST: f64 = 0.2;

    pub fn showing(crossings: impl IntoIterator<Item = f64>) -> [f64; 2] {
        let near = |u: &f64| (-Self::MOST..=1.0 + Self::MOST).contains(u);
        let widened = |[low, high]: [f64; 2], u: f64| [low.min(u), high.max(u)];
        crossings.into_iter().filter(near).fold([0.0, 1.0], widened)
    }
}

/// The arrows between them are numbered: 0 leads into the first clipper, 1 from it into the second, and as many as
/// there are clippers out of the last one.
#[derive(Clone, PartialEq, Debug)]
pub struct ClipperRow {
    pub clippers: Vec<ClipperBox>,
    pub at_work: Option<usize>,
    pub travellers: Vec<Traveller>,
    pub output: Value,
    pub n_out: usize,
}

#[derive(Clone, PartialEq, Debug)]
pub struct ClipperBox {
    pub name: Value,
    pub first: Option<[f64; 2]>,
    pub previous: Option<[f64; 2]>,
    pub is_closed: bool,
    pub link: Option<Link>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Traveller {
    pub name: Value,
    pub arrow: usize,
    pub fate: Fate,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fate {
    GoesOn,
    Due,
    Dropped,
}
