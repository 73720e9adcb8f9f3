//! The cuts of Cohen–Sutherland: in what proportion each of them divides the segment, and what it was good for. Where bits are in
//! another order than most books', the cuts in theirs, too.

use crate::{
    algo::line::{BitOrder, CohenSutherland, CohenSutherlandEvent as Event, CohenSutherlandInput},
    labs::{crossing_formulas::Weights, interval::value_of, segments::CodeStep},
};

use super::{
    crossings::{Fate, fate_word},
    prelude::*,
    shared::side_key,
};

type Shown<'a> = CodeStep<'a, 2, CohenSutherlandInput>;

fn cuts(input: CohenSutherlandInput) -> Vec<Event> {
    let run = Recording::<CohenSutherland>::new(input);
    let is_cut = |event: &&Event| matches!(event, Event::Cut { .. });
    run.events().iter().filter(is_cut).copied().collect()
}

/// Where bits are in another order than the usual one: the cuts in that.
fn usual_cuts(input: &CohenSutherlandInput) -> Option<Vec<Event>> {
    let bit_order = BitOrder::default();
    let usual = CohenSutherlandInput {
        bit_order,
        ..*input
    };
    (usual != *input).then(|| cuts(usual))
}

/// A later cut of the same end makes one useless.
fn fate(cuts: &[Event], nth: usize, end: End) -> Fate {
    let is_same = |later: &Event| matches!(later, Event::Cut { end: of, .. } if *of == end);
    if cuts[nth + 1..].iter().any(is_same) {
        Fate::InVain
    } else {
        Fate::Replaces(end)
    }
}

/// While one is made, and at the end.
pub fn cut_table(shown: &Shown<'_>) -> Option<Table> {
    let n = shown.cuts.len();
    let is_over = matches!(shown.event?, Event::Accept { .. });
    if n == 0 || !(is_over || matches!(shown.event?, Event::Cut { .. })) {
        return None;
    }
    let heading = |key| TableRow {
        name: Value::Term(key),
        cells: Vec::new(),
        is_current: false,
        link: None,
    };
    let rows = |cuts: &[Event], is_own| {
        let rows = (0..cuts.len()).filter_map(|nth| row(shown, cuts, nth, is_own));
        rows.collect::<Vec<_>>()
    };
    let own = cuts(*shown.input);
    let rows = match usual_cuts(shown.input) {
        None => rows(&own[..n], true),
        Some(usual) => [
            vec![heading("cs-this-order")],
            rows(&own, true),
            vec![heading("cs-usual-order")],
            rows(&usual, false),
        ]
        .concat(),
    };
    Some(Table {
        header: vec![
            Formula::default().term("cs-cuts"),
            sym("w₁"),
            sym("w₂"),
            sym("t = ").over(sym("w₁"), sym("w₁ + w₂")),
            Formula::default(),
        ],
        rows,
        notes: Vec::new(),
    })
}

fn row(shown: &Shown<'_>, cuts: &[Event], nth: usize, is_own: bool) -> Option<TableRow> {
    let Event::Cut { end, side, u, .. } = cuts[nth] else {
        return None;
    };
    let is_now = matches!(shown.event, Some(Event::Cut { .. }));
    let is_current = is_now && is_own && nth + 1 == shown.cuts.len();
    let fate = fate(cuts, nth, end);
    let role = match fate {
        Fate::Replaces(_) if is_current => Role::Signal,
        Fate::Replaces(_) if is_own => Role::Ink,
        Fate::Replaces(_) | Fate::InVain | Fate::Parallel => Role::Soft,
    };
    let [w1, w2] = weights(shown, side).map(Value::Number);
    let cells = [w1, w2, value_of(u), fate_word(fate)];
    let name = sym(format!("{} ", numbered('I', nth))).term(side_key(side));
    Some(TableRow {
        name: name.into(),
        cells: cells.map(|value| Cell::new(role, Some(value))).to_vec(),
        is_current,
        link: Some(edge_link(side)),
    })
}

fn weights(shown: &Shown<'_>, edge: Edge) -> [f64; 2] {
    let ends = End::BOTH.map(|end| along(end.of(&shown.input.segment), edge.axis())[0]);
    Weights::along(ends, shown.input.window.border(edge)).ends
}

/// Several cuts have numbers, in the order in which they were made; a cross is where an end was cut off again. Of the usual order
/// the cuts that this one has not made; and the distances that one divides the segment by.
pub fn cut_marks(shown: &Shown<'_>) -> Vec<Mark> {
    let made = &shown.cuts;
    let numbers = (0..made.len()).filter(|_| made.len() > 1);
    let mut marks: Vec<Mark> = numbers
        .map(|nth| {
            let is_end = shown.ends.contains(&made[nth]);
            let shape = if is_end { Shape::Vertex } else { Shape::Cross };
            let role = if is_end { Role::Soft } else { Role::Discarded };
            Mark::new(role, shape(made[nth])).labelled(name(numbered('I', nth)))
        })
        .collect();
    if let Some(Event::Cut { side, .. }) = shown.event {
        for (end, (symbol, w)) in End::BOTH
            .into_iter()
            .zip(["w₁ = ", "w₂ = "].into_iter().zip(weights(shown, side)))
        {
            let at = end.of(&shown.input.segment).to_array();
            let mut foot = at;
            foot[side.axis() as usize] = shown.input.window.border(side);
            let leg = Mark::new(Role::Soft, Shape::Segment([at, foot])).dashed();
            marks.push(leg.labelled(sym(symbol).ratio(w, 1.0)));
        }
    }
    let usual = usual_cuts(shown.input).filter(|_| !made.is_empty());
    let usual = usual.unwrap_or_default();
    for (nth, cut) in usual.iter().enumerate() {
        let Event::Cut { end, u, to, .. } = *cut else {
            continue;
        };
        if !made.contains(&to) {
            let is_in_vain = fate(&usual, nth, end) == Fate::InVain;
            let shape = if is_in_vain {
                Shape::Cross
            } else {
                Shape::Ring
            };
            marks.push(Mark::new(Role::Discarded, shape(to)).labelled(equal_to("t", u)));
        }
    }
    marks
}
