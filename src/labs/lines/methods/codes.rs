//! The codes of Cohen–Sutherland as bits, one over the other, and the column that decides.

use crate::{
    algo::line::{BitOrder, CohenSutherland, CohenSutherlandEvent as Event, End, Outcode},
    figure::{BitRow, Bits, Role},
    geom::Edge,
    labs::{Step, operator::Operator, words::name},
    text::{Message, Value},
};

use super::shared::side_key;
use crate::labs::words::{end_link, end_name_now};

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
    let is_now = matches!(step.event, Some(Event::Or { .. } | Event::And { .. }));
    Bits {
        columns: order.written().map(|e| Value::Term(side_key(e))).to_vec(),
        rows: End::BOTH.map(|end| code_row(end, step)).to_vec(),
        note: Some(match combined {
            None => in_the_usual_order(step).unwrap_or_else(|| Message::new("cs-note-code")),
            Some((operator, _)) => operator.note(),
        }),
        result: combined.map(|(operator, code)| operator.row(bits(code, order), is_now)),
        deciding: deciding_edge(step).and_then(column),
    }
}

/// Where codes are written in another order than most books': what the code found now is in theirs.
fn in_the_usual_order(step: &Step<'_, CohenSutherland>) -> Option<Message> {
    let Some(Event::Code { code, .. }) = step.event else {
        return None;
    };
    let (order, usual) = (step.input.bit_order, BitOrder::default());
    let edges: Vec<Edge> = code.edges(order).collect();
    let message = || {
        let other = Outcode::from_edges(&edges, usual);
        Message::new("cs-note-order").with("other", name(other.to_string()))
    };
    (order != usual).then(message)
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
fn combined(step: &Step<'_, CohenSutherland>) -> Option<(Operator, Outcode)> {
    let operator = match step.event? {
        Event::Code { .. } | Event::Cut { .. } => return None,
        Event::Or { .. } | Event::Accept { .. } | Event::Choose { .. } => Operator::Or,
        Event::And { .. } | Event::Reject { .. } => Operator::And,
    };
    operator.of([step.state.or, step.state.and])
}

fn bits(code: Outcode, order: BitOrder) -> Vec<bool> {
    order.written().map(|edge| code.has(edge, order)).to_vec()
}
