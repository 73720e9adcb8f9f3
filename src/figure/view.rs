//! What a step shows: one view or several, side by side. A view is a picture of where things are, or of what an
//! algorithm holds.

use crate::text::{Formula, Value};

use super::{
    graph::Graph,
    lists::Lists,
    mark::Mark,
    raster::Raster,
    role::Link,
    small_pictures::{Multiples, Ribbon, Screens, SpaceRow, Story},
    space::Space,
    values::{Bits, Gauges, MatrixProduct, Products, Table},
};

/// A name that a view keeps from step to step, and from one method to the one beside it: pan, zoom and orbit are
/// remembered under it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub struct ViewId(pub &'static str);

impl ViewId {
    /// The drawing that every lab of the plane has.
    pub const PLANE: Self = Self("plane");
}

/// One view of a step.
#[derive(Clone, PartialEq, Debug)]
pub struct View {
    /// The same at every step of a run.
    pub id: ViewId,
    /// What it shows.
    pub body: Body,
}

impl View {
    /// The drawing in the plane.
    pub const fn plane(marks: Vec<Mark>) -> Self {
        Self {
            id: ViewId::PLANE,
            body: Body::Plane(marks),
        }
    }

    /// A view under this name.
    pub const fn new(id: &'static str, body: Body) -> Self {
        let id = ViewId(id);
        Self { id, body }
    }
}

/// The kinds of views.
#[derive(Clone, PartialEq, Debug)]
pub enum Body {
    /// Marks in the coordinates of a plane.
    Plane(Vec<Mark>),
    /// Solids and marks in space.
    Space(Space),
    /// Large pixels, and what is stored at them.
    Raster(Raster),
    /// Codes over each other, bit by bit.
    Bits(Bits),
    /// Rows and columns of values.
    Table(Table),
    /// Vertex lists and what links them.
    Lists(Lists),
    /// Dot products, each with its own small drawing.
    Products(Products),
    /// What is left of a parameter's interval.
    NumberLine(NumberLine),
    /// A pipeline, and what flows through it.
    Clippers(ClipperRow),
    /// Signed numbers on axes over each other.
    Gauges(Gauges),
    /// How much is left after each of several tests.
    Ribbon(Ribbon),
    /// Pictures of the screen over each other.
    Screens(Screens),
    /// Small drawings of the plane in a row.
    Multiples(Multiples),
    /// A matrix times a vector, row by row.
    Matrix(MatrixProduct),
    /// Small pictures of several spaces in a row.
    Spaces(SpaceRow),
    /// Things, and arrows from one to another.
    Graph(Graph),
    /// What has come to one place, in order.
    Story(Story),
}

/// What a crossing does to the interval on a [`NumberLine`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// The line comes in: pushes the lower end up.
    Entering,
    /// The line goes out: pulls the upper end down.
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

/// A value on a [`NumberLine`].
#[derive(Clone, PartialEq, Debug)]
pub struct LineTick {
    /// Where.
    pub u: f64,
    /// The same as it is written: the quotient that it was computed as.
    pub value: Formula,
    /// Which bound it belongs to.
    pub side: Side,
    /// Does it hold the bound now?
    pub holds: bool,
    /// Is it this step's?
    pub current: bool,
    /// The border's name.
    pub name: Value,
    /// What it is about.
    pub link: Option<Link>,
}

/// The second view of parametric clippers: the interval of the parameter that is left.
#[derive(Clone, PartialEq, Debug)]
pub struct NumberLine {
    /// `u` or `t`.
    pub symbol: &'static str,
    /// What stands at 0 and at 1: P₁, P₂.
    pub ends: [Value; 2],
    /// The part of the axis that is shown, 0 and 1 always: the same at every step of a run.
    pub shown: [f64; 2],
    /// Lower and upper bound so far: out of order where they have passed each other.
    pub interval: [f64; 2],
    /// Both as they are written.
    pub values: [Formula; 2],
    /// Nothing is left, because the bounds have passed each other or for another reason.
    pub empty: bool,
    /// Every crossing computed so far.
    pub ticks: Vec<LineTick>,
}

impl NumberLine {
    /// Of what lies beyond 0 and 1, no more is shown than this.
    const MOST: f64 = 0.2;

    /// The part of an axis that shows all these crossings, as far as they are not too far out.
    pub fn showing(crossings: impl IntoIterator<Item = f64>) -> [f64; 2] {
        let near = |u: &f64| (-Self::MOST..=1.0 + Self::MOST).contains(u);
        let widened = |[low, high]: [f64; 2], u: f64| [low.min(u), high.max(u)];
        crossings.into_iter().filter(near).fold([0.0, 1.0], widened)
    }
}

/// The second view of a pipeline: clippers in a row, what each of them holds, and what is on its way.
///
/// The arrows between them are numbered: 0 leads into the first clipper, 1 from it into the second, and as many as
/// there are clippers out of the last one.
#[derive(Clone, PartialEq, Debug)]
pub struct ClipperRow {
    /// From the first to the last.
    pub clippers: Vec<ClipperBox>,
    /// The one that looks at an edge, or is about to.
    pub at_work: Option<usize>,
    /// What is on its way, the foremost first; all on one arrow.
    pub travellers: Vec<Traveller>,
    /// What it all comes to: `V′`.
    pub output: Value,
    /// How many vertices have come out at the end.
    pub n_out: usize,
}

/// A clipper of a [`ClipperRow`].
#[derive(Clone, PartialEq, Debug)]
pub struct ClipperBox {
    /// Its border.
    pub name: Value,
    /// F, once it has come.
    pub first: Option<[f64; 2]>,
    /// S, once it has come.
    pub previous: Option<[f64; 2]>,
    /// Will no vertex come any more?
    pub is_closed: bool,
    /// What it is about.
    pub link: Option<Link>,
}

/// A vertex on its way.
#[derive(Clone, PartialEq, Debug)]
pub struct Traveller {
    /// How this step's sentence calls it.
    pub name: Value,
    /// The arrow it is on.
    pub arrow: usize,
    /// Does it get to the arrow's end?
    pub fate: Fate,
}

/// What becomes of a [`Traveller`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fate {
    /// It goes on.
    GoesOn,
    /// It will, as soon as it has been worked out.
    Due,
    /// It stays behind.
    Dropped,
}
