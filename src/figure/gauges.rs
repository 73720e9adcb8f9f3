//! Signed numbers on axes of their own, one over the other: distances from planes, dot products.

use crate::text::{Message, Value};

use super::{Link, Role};

/// Axes at one scale, 0 in the middle of all of them: what is out is left of it, what is in is right.
#[derive(Clone, PartialEq, Debug)]
pub struct Gauges {
    /// Over it: "One sphere, six planes".
    pub title: Message,
    /// What is said of either side of 0, left and right.
    pub sides: [Message; 2],
    /// A strip either side of 0 that is marked: from −r to r, and what is written at its ends.
    pub band: Option<f64>,
    /// From top to bottom; every row is there from the start, so that nothing moves when it is filled.
    pub rows: Vec<Gauge>,
}

/// One number.
#[derive(Clone, PartialEq, Debug)]
pub struct Gauge {
    /// At the left: "left", "face 6".
    pub name: Value,
    /// Where, once it is known.
    pub value: Option<f64>,
    /// A word at the right, once it is known: "culled".
    pub verdict: Option<Message>,
    /// [`Role::Accent`] kept, [`Role::Discarded`] culled, [`Role::Signal`] this step's.
    pub role: Role,
    /// A bar from 0, or a dot.
    pub is_bar: bool,
    /// What it is about.
    pub link: Option<Link>,
}
