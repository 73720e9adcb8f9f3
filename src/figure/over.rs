//! A mistake over what is right, in one frame: what both show is drawn once, under the name that the right one gives it; what only the
//! wrong one shows is crossed, and what only the right one shows lies under it.

use std::collections::HashSet;

use super::{
    extent::Stand,
    facet::Facet,
    frame::{Caption, Frame},
    mark::{Mark, Shape},
    role::{Label, Role},
    space::{Edge3, Mark3, Seer, Shape3, Space},
    values::{ItemMarker, ListColumn, ListLink, ListRow, Lists},
    view::Body,
};
use crate::text::{Message, Value};

/// The frame of a wrong method over that of the right one at the same moment.
pub fn over(wrong: &Frame, right: &Frame) -> Frame {
    let mut frame = wrong.clone();
    frame.caption = said(&wrong.caption, &right.caption);
    // How much is left is not what differs.
    (frame.views).retain(|view| view.need().stand != Stand::Across);
    for view in &mut frame.views {
        match (&mut view.body, right.body(view.id)) {
            (Body::Plane(marks), Some(Body::Plane(right))) => plane(marks, right),
            (Body::Space(space), Some(Body::Space(right))) => solids(space, right),
            (Body::Lists(lists), Some(Body::Lists(right))) => *lists = results(lists, right),
            _ => {}
        }
    }
    frame
}

/// Both verdicts.
fn said(wrong: &Caption, right: &Caption) -> Caption {
    if wrong.decision == right.decision {
        return wrong.clone();
    }
    let decision = Message::new("wrong-and-right")
        .with("wrong", wrong.decision.clone())
        .with("right", right.decision.clone());
    Caption {
        decision,
        arithmetic: wrong.arithmetic.clone(),
    }
}

/// What marks of the plane and of space are told by.
trait Told: Clone {
    /// The same thing: points whatever they are called.
    fn is_same(&self, other: &Self) -> bool;
    fn parts(&mut self) -> (&mut Role, &mut Option<Label>, &mut bool);
}

macro_rules! told_by {
    ($mark:ty, $point:pat) => {
        impl Told for $mark {
            fn is_same(&self, other: &Self) -> bool {
                let is_point = matches!(self.shape, $point);
                self.shape == other.shape && (is_point || self.label == other.label)
            }

            fn parts(&mut self) -> (&mut Role, &mut Option<Label>, &mut bool) {
                (&mut self.role, &mut self.label, &mut self.is_dashed)
            }
        }
    };
}

told_by!(Mark, Shape::Dot(_) | Shape::Ring(_));
told_by!(Mark3, Shape3::Dot(_) | Shape3::Ring(_));

const fn is_quiet(role: Role) -> bool {
    matches!(role, Role::Soft | Role::Faint | Role::Discarded)
}

fn with_what(key: &'static str, what: Value) -> Value {
    Message::new(key).with("what", what).into()
}

fn not_so(text: Value) -> Value {
    with_what("not-so", text)
}

/// Crosses in `marks` what is not right, and returns what is missing in them.
fn crossed<M: Told>(marks: &mut [M], right: &[M]) -> Vec<M> {
    let is_there = |mark: &M| marks.iter().any(|own| own.is_same(mark));
    let missing = right.iter().filter(|mark| !is_there(mark)).cloned();
    let mut missing: Vec<M> = missing.collect();
    for mark in &mut missing {
        let (role, ..) = mark.parts();
        if !is_quiet(*role) {
            *role = Role::Accent;
        }
    }
    for mark in marks {
        let known = right.iter().find(|other| mark.is_same(other)).cloned();
        let (role, label, is_dashed) = mark.parts();
        if let Some(mut known) = known {
            label.clone_from(known.parts().1);
        } else if *role != Role::Discarded {
            (*role, *is_dashed) = (Role::Signal, true);
            if let Some(label) = label {
                label.text = not_so(label.text.clone());
            }
        }
    }
    missing
}

fn plane(marks: &mut Vec<Mark>, right: &[Mark]) {
    let [own, others] = [&marks[..], right].map(corners);
    let n = |all: &[[f64; 2]], at: [f64; 2]| all.iter().filter(|&&it| it == at).count();
    let mut surplus = own.clone();
    surplus.retain(|&at| n(&others, at) > 0 && n(&own, at) > n(&others, at));
    surplus.dedup();
    let shapes: Vec<Shape> = marks.iter().map(|mark| mark.shape.clone()).collect();
    let mut missing = crossed(marks, right);
    // Of the side of another border nothing is said.
    missing
        .retain(|mark| !matches!(mark.shape, Shape::HalfPlane(_)) || shapes.contains(&mark.shape));
    for mark in &mut missing {
        if let (Shape::Dot(at), Some(label)) = (&mark.shape, &mut mark.label)
            && !own.is_empty()
            && !own.contains(at)
        {
            label.text = not_so(with_what("is-missing", label.text.clone()));
            (mark.shape, mark.role) = (Shape::Ring(*at), Role::Signal);
        }
        // Of what is on the same side and has another name the line is enough.
        if let Shape::HalfPlane(ends) = mark.shape {
            mark.shape = Shape::Line(ends);
        }
    }
    marks.extend(missing);
    for at in surplus {
        let cross = Mark::new(Role::Signal, Shape::Cross(at));
        let dot = marks.iter_mut().find(|mark| mark.shape == Shape::Dot(at));
        let label = dot.and_then(|dot| dot.label.take());
        marks.push(match label {
            Some(label) => cross.labelled(not_so(with_what("again", label.text))),
            None => cross,
        });
    }
}

/// Of all outlines: one that is there twice is twice among them.
fn corners(marks: &[Mark]) -> Vec<[f64; 2]> {
    let outlines = marks.iter().filter_map(|mark| match &mark.shape {
        Shape::Outline(corners) | Shape::Path(corners) => Some(corners),
        _ => None,
    });
    outlines.flatten().copied().collect()
}

const fn is_dot(mark: &Mark3) -> bool {
    matches!(mark.shape, Shape3::Dot(_))
}

fn solids(space: &mut Space, right: &Space) {
    for mark in &mut space.marks {
        if let Shape3::Ring(at) = mark.shape
            && right.marks.iter().any(|it| it.shape == Shape3::Dot(at))
        {
            *mark = Mark3::new(Role::Signal, Shape3::Ring(at)).labelled(Value::Term("sh-outside"));
        }
    }
    let mut missing = crossed(&mut space.marks, &right.marks);
    let n_dots = |marks: &[Mark3]| marks.iter().filter(|it| is_dot(it)).count();
    let are_fewer = n_dots(&space.marks) < n_dots(&right.marks);
    for mark in missing.iter_mut().filter(|it| are_fewer && is_dot(it)) {
        if let Some(label) = &mut mark.label {
            label.text = not_so(with_what("is-missing", label.text.clone()));
        }
    }
    space.marks.extend(missing);
    let facet = |it: &(&Facet, Role)| (it.1 != Role::Discarded).then(|| bits(&it.0.corners));
    let edge = |it: &&Edge3| (it.role != Role::Discarded).then(|| bits(&it.ends));
    let facets = lacking(space.facets.shown(), right.facets.shown(), facet);
    let edges = lacking(space.edges.iter(), right.edges.iter(), edge);
    let signal = |shape| Mark3::new(Role::Signal, shape);
    let dashes = edges.iter().map(|it| signal(Shape3::Segment(it.ends)));
    space.marks.extend(dashes.map(|it| it.edge().dashed()));
    // Who goes round sees solids that are left out, by what is crossed there; which of their faces are, the camera sees.
    let names_why =
        |mark: &Mark3| mark.is_dashed && mark.role == Role::Signal && mark.label.is_some();
    let is_seen_around = !edges.is_empty() && !space.marks.iter().any(names_why);
    let is_said = matches!(space.seer, Seer::Camera(_)) || is_seen_around;
    let object = |it: &Facet| it.link.and_then(|link| link.number_of("object"));
    for (i, (facet, _)) in facets.iter().enumerate() {
        let mut wash = signal(Shape3::Wash(facet.corners.clone()));
        if is_said && (i == 0 || object(facet) != object(facets[i - 1].0)) {
            wash = wash.labelled(not_so(Value::Term("part-missing"))).strong();
        }
        space.marks.push(wash);
    }
}

type Bits = [u64; 3];

fn bits(places: &[[f64; 3]]) -> Vec<Bits> {
    places.iter().map(|at| at.map(f64::to_bits)).collect()
}

/// What is right and not there, by where it is.
fn lacking<T>(
    own: impl Iterator<Item = T>,
    right: impl Iterator<Item = T>,
    at: impl Fn(&T) -> Option<Vec<Bits>>,
) -> Vec<T> {
    let own: HashSet<Vec<Bits>> = own.filter_map(|it| at(&it)).collect();
    let is_lacking = |it: &T| at(it).is_some_and(|place| !own.contains(&place));
    right.filter(is_lacking).collect()
}

/// The lists that both make, beside each other: of the wrong one what is not in its place is crossed.
fn results(wrong: &Lists, right: &Lists) -> Lists {
    let [Some(wrong), Some(right)] = [wrong, right].map(|lists| lists.lists.last()) else {
        return wrong.clone();
    };
    let titled = |list: &ListColumn, key| ListColumn {
        title: Message::new(key)
            .with("n", list.n_before + list.entries.len() + list.n_after)
            .into(),
        ..list.clone()
    };
    let mut lists = [titled(right, "result-right"), titled(wrong, "result-wrong")];
    let mut links = Vec::new();
    let mut from = 0;
    let is = |entry: &ListRow, other: &ListRow| entry.details == other.details;
    for (to, entry) in lists[1].entries.iter_mut().enumerate() {
        let ahead = right.entries[from..].iter();
        if let Some(found) = ahead.into_iter().position(|other| is(entry, other)) {
            from += found + 1;
            entry.name.clone_from(&right.entries[from - 1].name);
            links.push(ListLink::between(from - 1, to, Role::Soft));
            continue;
        }
        let known = right.entries.iter().find(|other| is(entry, other));
        if let Some(known) = known {
            entry.name.clone_from(&known.name);
        }
        (entry.role, entry.marker) = (Role::Signal, Some(ItemMarker::Cross));
    }
    Lists {
        links,
        lists: lists.into(),
        legend: Vec::new(),
    }
}
