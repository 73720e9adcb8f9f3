//! What must come before what, as a graph: each triangle where it is in the picture, an arrow to each that it must precede.

use crate::{
    algo::surface::{PainterEvent as Event, PainterState as State},
    figure::{ArrowKind, Graph, GraphArrow, GraphNode, NodeStage, Places, Role},
    labs::{
        Step,
        space::{Scene, soup::surface_link},
        surfaces::methods::on_raster::{middle_of, name_of, tone},
    },
    text::{Formula, Value},
};

use super::{Shown, overlap::overlap, test_key, variant::Variant};

/// The graph; `now` are the triangle that the step is about, and the one that is asked beside it.
pub fn graph<L: Variant>(step: &Step<'_, Shown<L>>, scene: &Scene, now: [Option<u32>; 2]) -> Graph {
    let (state, surfaces) = (step.state, &step.input.own);
    // What is left out stands nowhere.
    let is_asked = |id: &u32| {
        let triangle = surfaces.triangles().get(*id as usize);
        !surfaces.culls_backs() || triangle.is_some_and(|triangle| surfaces.shows(triangle))
    };
    let ids: Vec<u32> = surfaces.ids().filter(is_asked).collect();
    let place = |id: u32| ids.iter().position(|&other| other == id);
    let nodes = ids.iter().map(|&id| GraphNode {
        name: name_of(step.input, id),
        tone: tone(id, now[0]),
        role: role_of(state, id, now),
        stage: NodeStage::There,
        number: number_of(state, id),
        note: None,
        link: surface_link(scene, id),
    });
    let nowhere = surfaces.size().map(|side| 0.5 * f64::from(side));
    let place_of = |&id: &u32| middle_of(surfaces, id).unwrap_or(nowhere);
    let arrows = arrows(step, now).into_iter().filter_map(|arrow| {
        let [from, to] = [place(arrow.ends[0])?, place(arrow.ends[1])?];
        Some(GraphArrow {
            from,
            to,
            kind: arrow.kind,
            role: arrow.role,
            reason: arrow.reason,
        })
    });
    Graph {
        title: Value::Term("painter-must"),
        nodes: nodes.collect(),
        arrows: arrows.collect(),
        places: Places::Free(ids.iter().map(place_of).collect()),
        ring: (!state.cycle.is_empty()).then_some(Value::Term("painter-cycle")),
        focus: now[0].and_then(place),
    }
}

fn role_of(state: &State, id: u32, now: [Option<u32>; 2]) -> Role {
    if now.contains(&Some(id)) || state.cycle.contains(&id) {
        Role::Signal
    } else if state.keys.iter().any(|(of, ..)| *of == id) {
        Role::Ink
    } else {
        Role::Faint
    }
}

fn number_of(state: &State, id: u32) -> Option<Value> {
    let place = state.placed.iter().position(|&placed| placed == id)?;
    Some(Value::Count(place + 1))
}

/// Between two triangles, by their ids.
struct Arrow {
    ends: [u32; 2],
    kind: ArrowKind,
    role: Role,
    reason: Option<Value>,
}

/// What has been found, what this step asks.
fn arrows<L: Variant>(step: &Step<'_, Shown<L>>, now: [Option<u32>; 2]) -> Vec<Arrow> {
    let state = step.state;
    let found = state.constraints.iter().map(|&ends| {
        let is_in_ring = is_in_ring(&state.cycle, ends);
        let is_now = ends.map(Some) == now;
        Arrow {
            ends,
            kind: if is_in_ring {
                ArrowKind::Ring
            } else {
                ArrowKind::Holds
            },
            role: if is_in_ring || is_now {
                Role::Signal
            } else {
                Role::Soft
            },
            reason: hides(step, ends),
        }
    });
    let mut arrows: Vec<Arrow> = found.collect();
    if let Some(Event::Pair {
        id,
        other,
        test,
        may,
        ..
    }) = step.event
    {
        let refused = hides(step, [other, id]).filter(|_| !may);
        arrows.push(Arrow {
            ends: [id, other],
            kind: if may {
                ArrowKind::Allowed
            } else {
                ArrowKind::Refused
            },
            role: Role::Signal,
            reason: Some(refused.unwrap_or(Value::Term(test_key(test)))),
        });
    }
    arrows
}

/// `A 4.31 > B 3.47`: how far both are before the eye's plane where the second hides the first.
fn hides<L: Variant>(step: &Step<'_, Shown<L>>, [far, near]: [u32; 2]) -> Option<Value> {
    let overlap = overlap(&step.input.own, [far, near])?;
    let name = |id: u32| {
        if let Value::Name(name) = name_of(step.input, id) {
            name
        } else {
            id.to_string()
        }
    };
    let [far_depth, near_depth] = overlap.depths;
    let formula = Formula::decimals().sym(name(far) + " ").num(far_depth);
    let formula = formula.sym(format!(" > {} ", name(near)));
    Some(Value::Formula(formula.num(near_depth)))
}

/// Does the second follow the first in a cycle, as far as it has been found?
fn is_in_ring(cycle: &[u32], [before, after]: [u32; 2]) -> bool {
    let next = cycle.iter().cycle().skip(1);
    let mut pairs = cycle.iter().zip(next);
    pairs.any(|(&one, &next)| [one, next] == [before, after])
}

/// Where in the picture this step's arrow has its reason; of a cycle, all of its arrows.
pub fn overlaps<L: Variant>(step: &Step<'_, Shown<L>>) -> Vec<[f64; 2]> {
    let state = step.state;
    let shown = match step.event {
        Some(Event::Constraint { before, after }) => vec![[before, after]],
        Some(Event::Pair {
            id,
            other,
            may: false,
            ..
        }) => vec![[other, id]],
        Some(Event::Cycle { .. } | Event::Done) => {
            let is_in_ring = |ends: &&[u32; 2]| is_in_ring(&state.cycle, **ends);
            state
                .constraints
                .iter()
                .filter(is_in_ring)
                .copied()
                .collect()
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
    let at = |ends| Some(overlap(&step.input.own, ends)?.at);
    shown.into_iter().filter_map(at).collect()
}
