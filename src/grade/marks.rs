//! What differs, as marks of the plane: the case as it was given, what is true, and what the program says instead.

use serde_json::Value as Json;

use crate::{
    figure::{Mark, Role, Shape},
    text::Message,
};

use super::tally::Wrong;

type At = [f64; 2];

/// What differs, and the least and the largest coordinates of it.
pub struct Scenery {
    /// What is drawn.
    pub marks: Vec<Mark>,
    /// With some room.
    pub bounds: [At; 2],
}

impl Wrong {
    /// None where the case is not one of the plane.
    #[must_use]
    pub fn scenery(&self) -> Option<Scenery> {
        let right = self.known.as_ref()?.truth.as_ref().as_ref().ok()?;
        let mut marks = given(&right.case()?)?;
        marks.extend(told(&self.truth, true));
        marks.extend(told(&self.said, false));
        let bounds = bounds(&marks);
        Some(Scenery { marks, bounds })
    }
}

/// Around all that has been marked, with room.
fn bounds(marks: &[Mark]) -> [At; 2] {
    let [mut min, mut max] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for at in marks.iter().flat_map(|mark| places(&mark.shape)) {
        for axis in 0..2 {
            min[axis] = min[axis].min(at[axis]);
            max[axis] = max[axis].max(at[axis]);
        }
    }
    let side = (max[0] - min[0]).max(max[1] - min[1]).max(1e-9);
    [min.map(|x| x - 0.12 * side), max.map(|x| x + 0.12 * side)]
}

/// Of the shapes that are made here.
fn places(shape: &Shape) -> &[At] {
    match shape {
        Shape::Outline(ring) => ring,
        Shape::Segment(ends) => ends,
        Shape::Ring(at) | Shape::Cross(at) => std::slice::from_ref(at),
        _ => &[],
    }
}

/// What the case gives.
fn given(case: &Json) -> Option<Vec<Mark>> {
    let mut marks = Vec::new();
    let clip = case.get("clip").and_then(points).or_else(|| {
        let [xmin, ymin, xmax, ymax] = case.get("window").and_then(four)?;
        Some(vec![[xmin, ymin], [xmax, ymin], [xmax, ymax], [xmin, ymax]])
    });
    if let Some(clip) = &clip {
        marks.push(Mark::new(Role::Ink, Shape::Outline(clip.clone())));
    }
    if let Some([x1, y1, x2, y2]) = case.get("segment").and_then(four) {
        let ends = [[x1, y1], [x2, y2]];
        marks.push(Mark::new(Role::Discarded, Shape::Segment(ends)));
        for (end, name) in ends.into_iter().zip(["P₁", "P₂"]) {
            let ring = Mark::new(Role::Discarded, Shape::Ring(end));
            marks.push(ring.labelled(name.to_owned()).strong());
        }
        return clip.map(|_| marks);
    }
    let polygon = case.get("polygon").and_then(points)?;
    marks.push(Mark::new(Role::Discarded, Shape::Outline(polygon)));
    Some(marks)
}

/// An answer, or an event: its places, and what joins them.
fn told(said: &Json, is_true: bool) -> Vec<Mark> {
    let (role, key) = if is_true {
        (Role::Accent, "grade-mark-true")
    } else {
        (Role::Signal, "grade-mark-said")
    };
    let line = |shape| {
        let line = Mark::new(role, shape);
        if is_true { line } else { line.dashed() }
    };
    let place = |at: At| {
        let shape = if is_true {
            Shape::Ring(at)
        } else {
            Shape::Cross(at)
        };
        Mark::new(role, shape)
    };
    let mut marks = Vec::new();
    if let Some([x1, y1, x2, y2]) = said.get("segment").and_then(four) {
        let ends = [[x1, y1], [x2, y2]];
        marks.push(line(Shape::Segment(ends)));
        marks.extend(ends.map(place));
    }
    for rings in ["polygons", "triangles"]
        .into_iter()
        .filter_map(|name| said.get(name)?.as_array())
    {
        let rings: Vec<Vec<At>> = rings.iter().filter_map(points).collect();
        let corners = rings.concat();
        marks.extend(rings.into_iter().map(|ring| line(Shape::Outline(ring))));
        marks.extend(corners.into_iter().map(place));
    }
    let named = ["to", "at"]
        .into_iter()
        .find_map(|name| said.get(name).and_then(two));
    marks.extend(named.map(|at| place(at).labelled(Message::new(key).with("at", at))));
    marks
}

fn two(value: &Json) -> Option<At> {
    let [x, y] = value.as_array()?.as_slice() else {
        return None;
    };
    finite(x).zip(finite(y)).map(|(x, y)| [x, y])
}

fn four(value: &Json) -> Option<[f64; 4]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(finite).collect();
    numbers?.try_into().ok()
}

fn points(value: &Json) -> Option<Vec<At>> {
    value.as_array()?.iter().map(two).collect()
}

/// A number that can be drawn.
fn finite(value: &Json) -> Option<f64> {
    value.as_f64().filter(|x| x.abs() < 1e9)
}
