//! The tree as an indented list: each node over what lies before it, and that over what lies behind it.

use crate::{
    algo::surface::{BspEvent as Event, BspSide, BspState as State},
    figure::{ItemMarker, ListColumn, ListRow, Lists, Role},
    labs::{
        space::{Scene, soup::surface_link},
        surfaces::methods::on_raster::name_of,
    },
    text::Value,
};

use super::captions::{Input, piece_name};

/// The tree, and the order in which pieces are painted.
pub fn tree(state: &State, event: Option<Event>, input: &Input, scene: &Scene) -> Lists {
    let mut rows = Vec::new();
    let mut open: Vec<(u32, usize, Option<BspSide>)> = Vec::new();
    open.extend((!state.nodes.is_empty()).then_some((0, 0, None)));
    let mut focus = None;
    while let Some((number, depth, side)) = open.pop() {
        let Some(node) = state.nodes.get(number as usize) else {
            continue;
        };
        let is_current = state.node == Some(number);
        if is_current {
            focus = Some(rows.len());
        }
        let name = if let Value::Name(name) = name_of(input, node.id) {
            name
        } else {
            node.id.to_string()
        };
        let word = side.map(|side| match side {
            BspSide::Back => Value::Term("bsp-behind"),
            BspSide::Front | BspSide::On | BspSide::Cut => Value::Term("bsp-before"),
        });
        let visited = state.visited.iter().find(|(visited, _)| *visited == number);
        let eye = visited.map(|(_, eye)| match eye {
            BspSide::Front => Value::Term("bsp-eye-before"),
            BspSide::Back => Value::Term("bsp-eye-behind"),
            BspSide::On | BspSide::Cut => Value::Term("bsp-eye-on"),
        });
        rows.push(ListRow {
            details: vec![word, eye],
            marker: is_current.then_some(ItemMarker::Dot),
            role: if is_current { Role::Signal } else { Role::Ink },
            link: surface_link(scene, node.id),
            ..ListRow::new(Value::Name("\u{2003}".repeat(depth) + &name))
        });
        // What stands above comes out last.
        open.extend(node.back.map(|back| (back, depth + 1, Some(BspSide::Back))));
        open.extend(
            node.front
                .map(|front| (front, depth + 1, Some(BspSide::Front))),
        );
    }
    let painted = state
        .painted
        .iter()
        .filter_map(|&number| state.piece(number));
    let painted = painted.map(|piece| ListRow {
        role: Role::Accepted,
        link: surface_link(scene, piece.id),
        ..ListRow::new(piece_name(input, piece))
    });
    let mut painted: Vec<ListRow> = painted.collect();
    if let (Some(last), Some(Event::Paint { .. })) = (painted.last_mut(), event) {
        last.role = Role::Signal;
    }
    let reach = ListColumn::reach(rows.len(), focus);
    let (first, n_after) = (reach.start, rows.len() - reach.end);
    let tree = ListColumn {
        n_before: first,
        n_after,
        focus: focus.map(|at| at - first),
        ..ListColumn::new(Value::Term("bsp-tree"), rows.drain(reach).collect())
    };
    let last = painted.len().checked_sub(1);
    let reach = ListColumn::reach(painted.len(), last);
    let (first, n_after) = (reach.start, painted.len() - reach.end);
    let order = ListColumn {
        n_before: first,
        n_after,
        focus: last.map(|at| at - first),
        ..ListColumn::new(Value::Term("bsp-painted"), painted.drain(reach).collect())
    };
    Lists {
        lists: vec![tree, order],
        links: Vec::new(),
        legend: Vec::new(),
    }
}
