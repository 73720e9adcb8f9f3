//! The codes of the triangle that is asked: what its vertices lie beyond, and what all three do.

use crate::{
    algo::cull::FunnelEvent as Event,
    labs::{frustum::prelude::*, space::stage::side_key},
};

use super::{super::cut_triangle::vertex_symbol, n_inside};

pub fn table(event: Option<Event>) -> Option<Table> {
    let Some(Event::Triangle {
        codes, n_pieces, ..
    }) = event
    else {
        return None;
    };
    let row = |symbol: Value, code: SideCode, none: &'static str, role: Role| {
        let mut beyond = Formula::default();
        for (i, side) in code.sides().enumerate() {
            beyond = beyond.sym(["", ", "][i.min(1)]).term(side_key(side));
        }
        if code.is_inside() {
            beyond = beyond.term(none);
        }
        TableRow {
            name: symbol,
            cells: vec![
                Cell::new(role, Some(name(code.to_string()))),
                Cell::new(role, Some(beyond)),
            ],
            is_current: role == Role::Signal,
            link: None,
        }
    };
    let vertex = |(i, code)| row(name(vertex_symbol(i)), code, "sh-inside", Role::Ink);
    let vertices = codes.into_iter().enumerate().map(vertex);
    let [a, b, c] = codes;
    let all = row(name("AND"), a.and(b).and(c), "no-side", Role::Signal);
    let text = Message::new("codes-left")
        .with("inside", n_inside(codes))
        .with("pieces", n_pieces);
    let applies = true;
    Some(Table {
        header: ["column-vertex", "column-code", "column-beyond"]
            .map(|key| Formula::default().term(key))
            .into(),
        rows: vertices.chain([all]).collect(),
        notes: vec![TableNote { text, applies }],
    })
}
