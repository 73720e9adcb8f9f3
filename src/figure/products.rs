//! Dot products seen: two vectors from one point, and the foot of the perpendicular.

use crate::text::{Formula, Message, Value};

use super::Role;

/// Dot products with one vector in common, and what they measure along it.
#[derive(Clone, PartialEq, Debug)]
pub struct Products {
    /// From top to bottom.
    pub products: Vec<Product>,
    /// The same in one dimension.
    pub measured: Option<Measured>,
}

/// One dot product.
#[derive(Clone, PartialEq, Debug)]
pub struct Product {
    /// The vector that is projected on: the normal.
    pub onto: Vector,
    /// The vector that is projected.
    pub of: Vector,
    /// What its sign says: "n·D > 0: the line enters".
    pub decision: Message,
    /// The arithmetic: `3·11 + 2·(−3) = 27`.
    pub arithmetic: Formula,
    /// Was it worked out at this step?
    pub is_current: bool,
}

/// A vector with a name, in the coordinates of the world.
#[derive(Clone, PartialEq, Debug)]
pub struct Vector {
    /// `n`, `D`.
    pub name: Value,
    /// Its two coordinates.
    pub to: [f64; 2],
    /// How it is drawn, here and on the stage.
    pub role: Role,
}

/// A bar along the normal: 0 is the border, the inside to its right.
#[derive(Clone, PartialEq, Debug)]
pub struct Measured {
    /// "Measured along n, from the edge".
    pub title: Message,
    /// Over 0.
    pub zero: Value,
    /// Both ends: their names and distances.
    pub ends: [(Value, f64); 2],
    /// Lengths under the bar: from, to, and what is written on it.
    pub spans: Vec<([f64; 2], Value, Role)>,
}
