//! Triangles and crossings so far, of one polygon and of triangle by triangle.

use crate::{
    figure::{WatchRow, WatchSection},
    text::Value,
};

use super::stages::Stage;

/// Both methods after so many planes, one polygon first.
pub fn tally(stages: [&[Stage]; 2], n_planes: usize) -> WatchSection {
    let names = ["tally-one-polygon", "tally-one-by-one"];
    let row = |(stages, name_key): (&[Stage], &'static str)| {
        let last = n_planes.min(stages.len()).checked_sub(1);
        let counts = match last {
            Some(last) => [stages[last].n_triangles, stages[last].n_crossings],
            None => [1, 0],
        };
        let cells = counts.map(|count| Some(Value::Count(count)));
        WatchRow::table(Value::Term(name_key), cells.into())
    };
    let header = ["tally-triangles", "tally-crossings"].map(Value::Term);
    let rows = stages.into_iter().zip(names).map(row);
    WatchSection::titled(header.into(), rows.collect())
}
