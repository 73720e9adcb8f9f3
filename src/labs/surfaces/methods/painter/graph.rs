//! What must come before what, as a graph: each triangle where it is in the picture, an arrow to each that it must precede.

use crate::{
    algo::surface::{Painter, PainterEvent as Event, PainterHeld},
    figure::{ArrowKind, Graph, GraphArrow, GraphNode, NodeStage, Places},
    geom::pairs_around,
};

use super::super::prelude::*;

use super::{
    names::{overlap, test_key},
    variant::Variant,
};

/// Of more triangles not every pair is looked at once more.
const MOST_EXPLAINED: usize = 8;

/// The graph; `now` are the triangle that the step is about, and the one that is asked beside it.
pub fn graph<L: Variant>(at: &At<'_, Painter<L>>, scene: &Scene, now: [Option<u32>; 2]) -> Graph {
    let (held, surfaces) = (at.step.held, at.step.input);
    // What is left out stands nowhere.
    let is_asked = |id: &u32| {
        let triangle = surfaces.triangles().get(*id as usize);
        !surfaces.culls_backs() || triangle.is_some_and(|triangle| surfaces.shows(triangle))
    };
    let ids: Vec<u32> = surfaces.ids().filter(is_asked).collect();
    let place = |id: u32| ids.iter().position(|&other| other == id);
    let nodes = ids.iter().map(|&id| GraphNode {
        name: name_of(at.scenery, id),
        tone: tone(id, now[0]),
        role: role_of(held, id, now),
        stage: NodeStage::There,
        number: number_of(held, id),
        note: None,
        link: surface_link(scene, id),
    });
    let nowhere = surfaces.size().map(|side| 0.5 * f64::from(side));
    let place_of = |&id: &u32| middle_of(surfaces, id).unwrap_or(nowhere);
    Graph {
        title: Value::Term("painter-must"),
        nodes: nodes.collect(),
        arrows: arrows(at, now, place),
        places: Places::Free(ids.iter().map(place_of).collect()),
        ring: (!held.cycle.is_empty()).then_some(Value::Term("painter-cycle")),
        focus: now[0].and_then(place),
    }
}

fn role_of(held: &PainterHeld, id: u32, now: [Option<u32>; 2]) -> Role {
    if now.contains(&Some(id)) || held.cycle.contains(&id) {
        Role::Signal
    } else if held.list.iter().any(|(of, _)| of.id == id) {
        Role::Ink
    } else {
        Role::Faint
    }
}

fn number_of(held: &PainterHeld, id: u32) -> Option<Value> {
    let place = held.placed.iter().position(|&placed| placed == id)?;
    Some(Value::Count(place + 1))
}

/// From node to node, each at the `place` of its triangle.
fn arrows<L: Variant>(
    at: &At<'_, Painter<L>>,
    now: [Option<u32>; 2],
    place: impl Fn(u32) -> Option<usize>,
) -> Vec<GraphArrow> {
    let held = at.step.held;
    let arrow = |[from, to]: [u32; 2], kind, role, reason| {
        Some(GraphArrow {
            from: place(from)?,
            to: place(to)?,
            kind,
            role,
            reason,
        })
    };
    // What is asked now is an arrow of its own.
    let is_asked = |ends: [u32; 2]| {
        matches!(at.step.event(), Some(Event::Pair { .. })) && ends.map(Some) == now
    };
    let found = held.constraints.iter().filter(|&&ends| !is_asked(ends));
    let found = found.filter_map(|&ends| {
        let (kind, role) = if is_in_ring(&held.cycle, ends) {
            (ArrowKind::Ring, Role::Signal)
        } else if ends.map(Some) == now {
            (ArrowKind::Holds, Role::Signal)
        } else {
            (ArrowKind::Holds, Role::Soft)
        };
        arrow(ends, kind, role, hides(at, ends))
    });
    let mut arrows: Vec<GraphArrow> = found.collect();
    // In the end the order has its reasons.
    let placed = &held.placed;
    if at.step.event() == Some(Event::Done) && placed.len() <= MOST_EXPLAINED {
        let after =
            |(i, &before): (usize, &u32)| placed[i + 1..].iter().map(move |&after| [before, after]);
        let pairs = placed.iter().enumerate().flat_map(after);
        let unknown = pairs.filter(|ends| !held.constraints.contains(ends));
        arrows.extend(unknown.filter_map(|ends| {
            let reason = hides(at, ends)?;
            arrow(ends, ArrowKind::Holds, Role::Accent, Some(reason))
        }));
    }
    let asked = asked_now(at);
    arrows.extend(asked.and_then(|(ends, kind, why)| arrow(ends, kind, Role::Signal, Some(why))));
    arrows
}

/// The pair that the step is about, and its answer with the reason.
fn asked_now<L: Variant>(at: &At<'_, Painter<L>>) -> Option<([u32; 2], ArrowKind, Value)> {
    let Some(Event::Pair {
        id,
        other,
        test,
        may,
        ..
    }) = at.step.event()
    else {
        return None;
    };
    let asked = Value::Term(test_key(test));
    let (kind, reason) = if may {
        (ArrowKind::Allowed, asked)
    } else {
        let refused = hides(at, [other, id]);
        (ArrowKind::Refused, refused.unwrap_or(asked))
    };
    Some(([id, other], kind, reason))
}

/// `A 4.31 > B 3.47`: how far both are before the eye's plane where the second hides the first.
fn hides<L: Variant>(at: &At<'_, Painter<L>>, [far, near]: [u32; 2]) -> Option<Value> {
    let overlap = overlap(at.step.input, [far, near])?;
    let name = |id: u32| text_of(name_of(at.scenery, id), id as usize);
    let [far_depth, near_depth] = overlap.depths;
    let formula = Formula::decimals().sym(name(far) + " ").num(far_depth);
    let formula = formula.sym(format!(" > {} ", name(near)));
    Some(Value::Formula(formula.num(near_depth)))
}

fn is_in_ring(cycle: &[u32], [before, after]: [u32; 2]) -> bool {
    pairs_around(cycle).any(|pair| pair == [before, after])
}

/// Where in the picture this step's arrow has its reason; of a cycle, all of its arrows.
pub fn overlaps<L: Variant>(at: &At<'_, Painter<L>>) -> Vec<[f64; 2]> {
    let held = at.step.held;
    let shown = match at.step.event() {
        Some(Event::Constraint { before, after }) => vec![[before, after]],
        Some(Event::Pair {
            id,
            other,
            may: false,
            ..
        }) => vec![[other, id]],
        Some(Event::Cycle { .. } | Event::Done) => {
            let mut ring = held.constraints.clone();
            ring.retain(|&ends| is_in_ring(&held.cycle, ends));
            ring
        }
        Some(
            Event::Key { .. }
            | Event::Sort { .. }
            | Event::Pair { .. }
            | Event::Place { .. }
            | Event::Paint { .. },
        )
        | None => Vec::new(),
    };
    let place = |ends| Some(overlap(at.step.input, ends)?.at);
    shown.into_iter().filter_map(place).collect()
}
