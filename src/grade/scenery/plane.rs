//! Cases of the plane, and points of a screen.

use serde_json::Value as Json;

use crate::{
    figure::{Mark, Role, Shape},
    text::{Message, Value},
};

use super::{
    super::whole::Whole,
    Scenery,
    told::{Told, numbers, outline, place},
};

type At = [f64; 2];

pub(super) fn scenery(case: &Json, whole: &Whole) -> Option<Scenery> {
    if whole.field() == "screen" {
        return screen(case, whole);
    }
    let mut marks = given(case)?;
    for (json, is_true) in whole.each() {
        marks.extend(told(&Told::of(json), is_true));
    }
    Some(framed(marks))
}

/// A point in the frame of its pixels, whose rows count downwards.
fn screen(case: &Json, whole: &Whole) -> Option<Scenery> {
    let [width, height] = case.get("size").and_then(numbers)?;
    let frame = Shape::Outline(rectangle([0.0, 0.0, width, height]));
    let mut marks = vec![Mark::new(Role::Ink, frame)];
    for (json, is_true) in whole.each() {
        let [x, y] = json.get("screen").and_then(place)?;
        marks.push(pointed([x, height - y], [x, y], is_true));
    }
    Some(framed(marks))
}

pub(super) fn framed(marks: Vec<Mark>) -> Scenery {
    let [mut min, mut max] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for at in marks.iter().flat_map(|mark| places(&mark.shape)) {
        for axis in 0..2 {
            min[axis] = min[axis].min(at[axis]);
            max[axis] = max[axis].max(at[axis]);
        }
    }
    let side = (max[0] - min[0]).max(max[1] - min[1]).max(1e-9);
    let bounds = [min.map(|x| x - 0.12 * side), max.map(|x| x + 0.12 * side)];
    Scenery::Plane { marks, bounds }
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

fn rectangle([xmin, ymin, xmax, ymax]: [f64; 4]) -> Vec<At> {
    vec![[xmin, ymin], [xmax, ymin], [xmax, ymax], [xmin, ymax]]
}

/// What the case gives.
fn given(case: &Json) -> Option<Vec<Mark>> {
    let mut marks = Vec::new();
    let clip = case.get("clip").and_then(outline).or_else(|| {
        let window = case.get("window").and_then(numbers)?;
        Some(rectangle(window))
    });
    if let Some(clip) = &clip {
        marks.push(Mark::new(Role::Ink, Shape::Outline(clip.clone())));
    }
    let mut subject = ["segment", "polygon"].into_iter();
    let subject = subject.find_map(|name| outline(case.get(name)?))?;
    // Without a border a segment is one of space.
    if subject.len() == 2 && clip.is_none() {
        return None;
    }
    marks.extend(subject_of(&subject));
    Some(marks)
}

/// What is to be clipped.
pub(super) fn subject_of(corners: &[At]) -> Vec<Mark> {
    let &[a, b] = corners else {
        let outline = Shape::Outline(corners.to_vec());
        return vec![Mark::new(Role::Discarded, outline)];
    };
    let ends = [(a, "P₁"), (b, "P₂")].map(|(end, name)| {
        let ring = Mark::new(Role::Discarded, Shape::Ring(end));
        ring.labelled(name.to_owned()).strong()
    });
    let line = Mark::new(Role::Discarded, Shape::Segment([a, b]));
    [line].into_iter().chain(ends).collect()
}

pub(super) const fn role(is_true: bool) -> Role {
    if is_true { Role::Accent } else { Role::Signal }
}

/// `true: …` or `the program's: …`.
pub(super) fn name(at: impl Into<Value>, is_true: bool) -> Message {
    let key = if is_true {
        "grade-mark-true"
    } else {
        "grade-mark-said"
    };
    Message::new(key).with("at", at)
}

fn point(at: At, is_true: bool) -> Mark {
    let shape = if is_true {
        Shape::Ring(at)
    } else {
        Shape::Cross(at)
    };
    Mark::new(role(is_true), shape)
}

pub(super) fn pointed(at: At, named: impl Into<Value>, is_true: bool) -> Mark {
    point(at, is_true).labelled(name(named, is_true))
}

/// An answer, or an event: its places, and what joins them.
pub(super) fn told(told: &Told<2>, is_true: bool) -> Vec<Mark> {
    let line = |corners: &Vec<At>| {
        let shape = match corners[..] {
            [a, b] => Shape::Segment([a, b]),
            _ => Shape::Outline(corners.clone()),
        };
        let line = Mark::new(role(is_true), shape);
        if is_true { line } else { line.dashed() }
    };
    let lines = told.outlines.iter().map(line);
    let corners = told.corners().map(|at| point(at, is_true));
    let at = told.at.map(|at| pointed(at, at, is_true));
    lines.chain(corners).chain(at).collect()
}
