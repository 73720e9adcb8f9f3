//! What is said of a segment's ends.

use crate::{
    figure::Link,
    labs::telling::Named,
    text::{Formula, Value},
};

/// Of a whole segment, given in its catalogue's words.
pub const ENDS: &[&str] = &["P₁ = {P₁}", "P₂ = {P₂}"];

/// A point as a value, in however many dimensions.
pub fn place<const N: usize>(at: &[f64; N]) -> Value {
    match at[..] {
        [x, y] => Value::Point([x, y]),
        _ => Value::Formula(Formula::default().sym("(").list(at).sym(")")),
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

/// Are both ends the same?
pub fn is_point<const N: usize>([p1, p2]: [[f64; N]; 2]) -> bool {
    p1 == p2
}
