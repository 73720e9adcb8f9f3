//! The tree, drawn: below each node what lies before its plane to the left, what lies behind it to the right. Every node has its
//! place from the start; walked, it has its place in the order of painting.

use crate::{
    algo::surface::{BspEvent as Event, BspNode, BspSide, BspState as State},
    figure::{ArrowKind, Graph, GraphArrow, GraphNode, NodeStage, Places, Role},
    labs::{
        space::{Scene, soup::surface_link},
        surfaces::methods::on_raster::{name_of, tone},
    },
    text::Value,
};

use super::captions::{Input, piece_name};

/// The tree so far.
pub fn tree(state: &State, event: Option<Event>, input: &Input, scene: &Scene) -> Graph {
    let whole = state.whole_tree();
    let own = state.node.and_then(|node| whole.get(node as usize));
    let own = own.map(|node| node.id);
    let nodes = (0..).zip(whole).map(|(number, node)| GraphNode {
        name: node_name(state, input, number, node),
        tone: tone(node.id, own),
        role: role_of(state, number),
        stage: NodeStage::ToCome,
        number: number_of(state, node),
        note: eye_at(state, number),
        link: surface_link(scene, node.id),
    });
    let mut nodes: Vec<GraphNode> = nodes.collect();
    nodes[..state.nodes.len()]
        .iter_mut()
        .for_each(|node| node.stage = NodeStage::There);
    let below = |node: &BspNode| [node.front, node.back].map(|child| Some(child? as usize));
    let mut arrows = branches(state, event);
    for (to, piece) in asked(state, event, input) {
        if let (Some(node), Some(from)) = (nodes.get_mut(to), state.node) {
            if node.stage == NodeStage::ToCome {
                node.stage = NodeStage::Asked;
                node.name = piece;
            }
            arrows.retain(|arrow| arrow.to != to);
            arrows.push(GraphArrow {
                from: from as usize,
                to,
                kind: ArrowKind::Holds,
                role: Role::Signal,
                reason: None,
            });
        }
    }
    Graph {
        title: Value::Term("bsp-tree"),
        nodes,
        arrows,
        places: Places::Layers(whole.iter().map(below).collect()),
        ring: None,
        focus: state.node.map(|node| node as usize),
    }
}

/// The pieces in the plane, of many the first.
fn node_name(state: &State, input: &Input, number: u32, node: &BspNode) -> Value {
    let on = state
        .nodes
        .get(number as usize)
        .map_or(&node.on, |node| &node.on);
    let mut names = on.iter().filter_map(|&piece| {
        let piece = state.piece(piece)?;
        Some(if let Value::Name(name) = piece_name(input, piece) {
            name
        } else {
            piece.id.to_string()
        })
    });
    let Some(first) = names.next() else {
        return name_of(input, node.id);
    };
    match (names.next(), names.next()) {
        (None, _) => Value::Name(first),
        (Some(second), None) => Value::Name(format!("{first}, {second}")),
        (Some(_), Some(_)) => Value::Name(format!("{first} …")),
    }
}

fn role_of(state: &State, number: u32) -> Role {
    if state.node == Some(number) {
        Role::Signal
    } else if state.visited.iter().any(|(visited, _)| *visited == number) {
        Role::Accent
    } else {
        Role::Ink
    }
}

/// Its place in the order of painting; of several pieces the first and the last.
fn number_of(state: &State, node: &BspNode) -> Option<Value> {
    let places = (1..)
        .zip(&state.painted)
        .filter(|(_, piece)| node.on.contains(piece));
    let places: Vec<usize> = places.map(|(place, _)| place).collect();
    let (first, last) = (*places.first()?, *places.last()?);
    Some(if first == last {
        Value::Count(first)
    } else {
        Value::Name(format!("{first}–{last}"))
    })
}

/// On which side of a visited node the eye is.
fn eye_at(state: &State, number: u32) -> Option<Value> {
    let (_, eye) = state
        .visited
        .iter()
        .find(|(visited, _)| *visited == number)?;
    Some(Value::Term(match eye {
        BspSide::Front => "bsp-eye-before",
        BspSide::Back => "bsp-eye-behind",
        BspSide::On | BspSide::Cut => "bsp-eye-on",
    }))
}

/// From every node that there is to those below it.
fn branches(state: &State, event: Option<Event>) -> Vec<GraphArrow> {
    let is_new = |number: u32| match event {
        Some(Event::Node { node, .. } | Event::Visit { node, .. }) => node == number,
        Some(Event::Ask { .. } | Event::Built { .. } | Event::Paint { .. } | Event::Done)
        | None => false,
    };
    let branch = |(number, node): (u32, &BspNode)| {
        let (parent, side) = node.parent?;
        Some(GraphArrow {
            from: parent as usize,
            to: number as usize,
            kind: ArrowKind::Branch,
            role: branch_role(state, number, is_new(number)),
            reason: Some(Value::Term(match side {
                BspSide::Back => "bsp-behind",
                BspSide::Front | BspSide::On | BspSide::Cut => "bsp-before",
            })),
        })
    };
    (0..).zip(&state.nodes).filter_map(branch).collect()
}

/// This step's, walked already, or neither.
fn branch_role(state: &State, number: u32, is_new: bool) -> Role {
    if is_new {
        Role::Signal
    } else if state.visited.iter().any(|(visited, _)| *visited == number) {
        Role::Accent
    } else {
        Role::Soft
    }
}

/// Where in the tree the piece goes that is asked, or its parts: the node that will be there, and what goes there.
fn asked(state: &State, event: Option<Event>, input: &Input) -> Vec<(usize, Value)> {
    let Some(Event::Ask {
        node,
        piece,
        side,
        parts,
        ..
    }) = event
    else {
        return Vec::new();
    };
    let Some(node) = state.whole_tree().get(node as usize) else {
        return Vec::new();
    };
    let goes = match (side, parts) {
        (BspSide::Front, _) => vec![(node.front, piece)],
        (BspSide::Back, _) => vec![(node.back, piece)],
        (BspSide::Cut, Some([first, second])) => vec![(node.front, first), (node.back, second)],
        (BspSide::On, _) | (BspSide::Cut, None) => Vec::new(),
    };
    let place = |(node, piece): (Option<u32>, u32)| {
        let name = piece_name(input, state.piece(piece)?);
        Some((node? as usize, name))
    };
    goes.into_iter().filter_map(place).collect()
}
