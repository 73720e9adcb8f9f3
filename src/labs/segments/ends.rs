//! What is said of a segment's ends.

use super::prelude::*;

pub const ENDS: &[&str] = &["P₁ = {P₁}", "P₂ = {P₂}"];

/// An end in a sentence.
pub fn end_named(end: End) -> Named {
    Named::from(end_name(end)).linked(end_link(end))
}

pub fn place<const N: usize>(at: &[f64; N]) -> Value {
    match at[..] {
        [x, y] => Value::Point([x, y]),
        _ => Value::Formula(sym("(").list(at).sym(")")),
    }
}

/// The names of the last word where something is visible; and the segment, of which steps decide what becomes.
pub fn left_in<const N: usize>(visible: Option<[[f64; N]; 2]>, name: &str) -> Option<Named> {
    match name {
        "segment" => Some(Named::empty().linked(Link::to("segment"))),
        "at" | "p1" => Some(place(&visible?[0]).into()),
        "p2" => Some(place(&visible?[1]).into()),
        _ => None,
    }
}

pub fn is_point<const N: usize>([p1, p2]: [[f64; N]; 2]) -> bool {
    p1 == p2
}
