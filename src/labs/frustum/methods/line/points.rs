//! The points of a segment in clip space: a coordinate, w, how far inside a side they are, and where the divide puts them.

use crate::{
    algo::{
        parameter::End,
        volume::{ClipSpace, side_distances},
    },
    figure::{Cell, Role, Table, TableRow},
    geom::VolumeSide,
    labs::{
        segments::LineStep,
        words::{end_link, end_name, end_name_now},
    },
    text::{Formula, Value},
};

use super::marks::on_line;

/// The ends of what is left, to be shown before they are put: on the side that set each, as they will be.
pub fn left_so_far(shown: &LineStep<'_, 4, ClipSpace>) -> [[f64; 4]; 2] {
    End::BOTH.map(|end| {
        let i = end.idx();
        let mut at = on_line(&shown.ends, shown.bounds[i]);
        if let Some(side) = shown.set_by[i] {
            at[side.axis()] = if side.is_high() { at[3] } else { 0.0 - at[3] };
        }
        shown.put[i].unwrap_or(at)
    })
}

/// Is nothing of it left?
pub fn is_rejected(shown: &LineStep<'_, 4, ClipSpace>) -> bool {
    shown.verdict == Some(None) || shown.bounds[0] > shown.bounds[1]
}

/// Both ends, and what they have become: of the coordinate across the side in hand, else of x.
pub fn points_table(shown: &LineStep<'_, 4, ClipSpace>) -> Table {
    let side = shown.in_hand().unwrap_or(VolumeSide::Right);
    let axis = ["x", "y", "z"][side.axis()];
    let sign = if side.is_high() { "−" } else { "+" };
    let symbol = |symbol: String| Formula::default().sym(symbol);
    let ends = &shown.ends;
    let given = End::BOTH.map(|end| {
        let is_behind = ends[end.idx()][3] < 0.0;
        let role = if is_behind { Role::Signal } else { Role::Ink };
        let link = Some(end_link(end));
        row(end_name(end), ends[end.idx()], side, role, link)
    });
    let is_left = !is_rejected(shown);
    let left = left_so_far(shown);
    let moved = End::BOTH.into_iter().filter(|end| {
        let bound = shown.bounds[end.idx()];
        is_left && bound != [0.0, 1.0][end.idx()]
    });
    let moved = moved.map(|end| {
        let link = Some(end_link(end));
        row(
            end_name_now(end, true),
            left[end.idx()],
            side,
            Role::Accent,
            link,
        )
    });
    Table {
        header: vec![
            Formula::default(),
            symbol(axis.to_owned()),
            symbol("w".to_owned()),
            symbol(format!("w {sign} {axis}")),
            symbol(format!("{axis} / w")),
        ],
        rows: given.into_iter().chain(moved).collect(),
        notes: Vec::new(),
    }
}

fn row(
    name: Value,
    at: [f64; 4],
    side: VolumeSide,
    role: Role,
    link: Option<crate::figure::Link>,
) -> TableRow {
    let (along, w) = (at[side.axis()], at[3]);
    let [distance, _] = side_distances::<f64>(side, &[at; 2]);
    let image = (w != 0.0).then_some(along / w);
    TableRow {
        name,
        cells: vec![
            Cell::new(Role::Ink, Some(along)),
            Cell::new(role, Some(w)),
            Cell::new(Role::Ink, Some(distance)),
            Cell::new(role, image).strong(),
        ],
        is_current: false,
        link,
    }
}
