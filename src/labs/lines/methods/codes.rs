//! The codes of Cohen–Sutherland as bits, one over the other, and the column that decides.

use crate::{
    algo::line::{BitOrder, CohenSutherland, CohenSutherlandEvent as Event, End, Outcode},
    figure::{BitRow, Bits, Role},
    geom::Edge,
    labs::{Step, words::name},
    text::{Message, Value},
};

use super::shared::{end_link, end_name_now, side_key};

/// The side whose bit decides at this step: that both ends lie beyond, or that is cut at.
pub fn deciding_edge(step: &Step<'_, CohenSutherland>) -> Option<Edge> {
    let order = step.input.bit_order;
    match step.event? {
        Event::And { and } | Event::Reject { and } => and.edges(order).next(),
        Event::Choose { edge, .. } | Event::Cut { edge, .. } => Some(edge),
        Event::Code { .. } | Event::Or { .. } | Event::Accept { .. } => None,
    }
}

/// Both codes, and what an operator makes of them once it is asked.
pub fn codes(step: &Step<'_, CohenSutherland>) -> Bits {
    let order = step.input.bit_order;
    let column = |edge| order.written().iter().position(|&e| e == edge);
    let combined = combined(step);
    Bits {
        columns: order.written().map(|e| Value::Term(side_key(e))).to_vec(),
        rows: End::BOTH.map(|end| code_row(end, step)).to_vec(),
        note: Some(Message::new(match combined {
            None => "cs-note-code",
            Some(("OR", _)) => "cs-note-or",
            Some(_) => "cs-note-and",
        })),
        result: combined.map(|(operator, code)| BitRow {
            name: name(operator),
            bits: bits(code, order),
            role: if matches!(step.event, Some(Event::Or { .. } | Event::And { .. })) {
                Role::Signal
            } else {
                Role::Ink
            },
            link: None,
        }),
        deciding: deciding_edge(step).and_then(column),
    }
}

fn code_row(end: End, step: &Step<'_, CohenSutherland>) -> BitRow {
    let moved = step.state.ends[end.idx()] != end.of(&step.input.segment);
    let found_now = matches!(step.event, Some(Event::Code { end: e, .. }) if e == end);
    let code = step.state.codes[end.idx()];
    BitRow {
        name: end_name_now(end, moved),
        bits: code.map_or_else(Vec::new, |code| bits(code, step.input.bit_order)),
        role: if found_now { Role::Signal } else { Role::Ink },
        link: Some(end_link(end)),
    }
}

/// The operator that the step is about, and what it gives.
fn combined(step: &Step<'_, CohenSutherland>) -> Option<(&'static str, Outcode)> {
    let or = step.state.or.map(|or| ("OR", or));
    let and = step.state.and.map(|and| ("AND", and));
    match step.event? {
        Event::Code { .. } | Event::Cut { .. } => None,
        Event::Or { .. } | Event::Accept { .. } | Event::Choose { .. } => or,
        Event::And { .. } | Event::Reject { .. } => and,
    }
}

fn bits(code: Outcode, order: BitOrder) -> Vec<bool> {
    order.written().map(|edge| code.has(edge, order)).to_vec()
}
