//! Triangles and crossings so far, of one polygon and of triangle by triangle.

use crate::{
    figure::{Cell, Role, Table, TableRow},
    labs::words::name,
    text::{Formula, Value},
};

use super::{super::super::stage::Scenery, stages::Stage};

/// Blocks beyond these are only counted.
const MOST_BLOCKS: usize = 12;

/// Not beside another method: there the pictures need it, and both say how many in the end.
pub fn has_room_for_totals(scenery: Option<&Scenery>) -> bool {
    scenery.is_none_or(|scenery| scenery.scene().compare.is_none())
}

/// Both methods after so many planes; `own` is the one that is stepped, 0 for one polygon.
pub fn tally(stages: [&[Stage]; 2], n_planes: usize, own: usize) -> Table {
    let mut header = vec![Formula::default().term("tally-so-far")];
    header.extend(["tally-triangles", "tally-crossings"].map(|key| Formula::default().term(key)));
    header.insert(2, Formula::default());
    let row = |(i, name_key): (usize, &'static str)| {
        let last = n_planes.min(stages[i].len()).checked_sub(1);
        let [n_triangles, n_crossings] = match last {
            Some(last) => [stages[i][last].n_triangles, stages[i][last].n_crossings],
            None => [1, 0],
        };
        let role = if i == own { Role::Accent } else { Role::Soft };
        let blocks = "■".repeat(n_triangles.min(MOST_BLOCKS));
        TableRow {
            name: Value::Term(name_key),
            cells: vec![
                Cell::new(role, Some(name(blocks))),
                Cell::new(Role::Ink, Some(Value::Count(n_triangles))),
                Cell::new(Role::Ink, Some(Value::Count(n_crossings))),
            ],
            is_current: false,
            link: None,
        }
    };
    let rows = ["tally-one-polygon", "tally-one-by-one"];
    Table {
        header,
        rows: rows.into_iter().enumerate().map(row).collect(),
        notes: Vec::new(),
    }
}
