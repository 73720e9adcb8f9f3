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
    for node in &mut nodes[..state.nodes.len()] {
        node.stage = NodeStage::There;
    }
    let mut arrows = branches(state, event);
    for waiting in waiting(state, event, input) {
        let node = &mut nodes[waiting.arrow.to];
        node.stage = NodeStage::Asked;
        node.name = waiting.name;
        node.role = waiting.arrow.role;
        arrows.push(waiting.arrow);
    }
    let below = |node: &BspNode| [node.front, node.back].map(|child| Some(child? as usize));
    Graph {
        title: Value::Term("bsp-tree"),
        nodes,
        arrows,
        places: Places::Layers(whole.iter().map(below).collect()),
        ring: None,
        focus: state.node.map(|node| node as usize),
    }
}

/// The pieces in the plane.
fn node_name(state: &State, input: &Input, number: u32, node: &BspNode) -> Value {
    let now = state.nodes.get(number as usize).unwrap_or(node);
    names(state, input, &now.on).unwrap_or_else(|| name_of(input, node.id))
}

/// `B, D+`, of more than two pieces the first; none where none of them is known yet.
fn names(state: &State, input: &Input, pieces: &[u32]) -> Option<Value> {
    let mut names = pieces.iter().filter_map(|&piece| {
        let piece = state.piece(piece)?;
        Some(if let Value::Name(name) = piece_name(input, piece) {
            name
        } else {
            piece.id.to_string()
        })
    });
    let first = names.next()?;
    Some(Value::Name(match (names.next(), names.next()) {
        (None, _) => first,
        (Some(second), None) => format!("{first}, {second}"),
        (Some(_), Some(_)) => format!("{first} …"),
    }))
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

/// Pieces that wait for a node of their own.
struct Waiting {
    name: Value,
    /// From the node that has sorted them to where theirs will be.
    arrow: GraphArrow,
}

/// What has been sorted, and is not built yet; this step's stands out.
fn waiting(state: &State, event: Option<Event>, input: &Input) -> Vec<Waiting> {
    let is_to_come = |to: &u32| *to as usize >= state.nodes.len();
    let mut all = Vec::new();
    for (from, (node, whole)) in state.nodes.iter().zip(state.whole_tree()).enumerate() {
        let sides = [(whole.front, &node.before), (whole.back, &node.behind)];
        for (to, pieces) in sides {
            let (Some(to), Some(name)) = (to.filter(is_to_come), names(state, input, pieces))
            else {
                continue;
            };
            let is_now = pieces.last().is_some_and(|last| is_sorted(event, *last));
            let (kind, role) = if is_now {
                (ArrowKind::Holds, Role::Signal)
            } else {
                (ArrowKind::Branch, Role::Soft)
            };
            let arrow = GraphArrow {
                from,
                to: to as usize,
                kind,
                role,
                reason: None,
            };
            all.push(Waiting { name, arrow });
        }
    }
    all
}

/// Is this step about that piece, or one that it is a part of?
fn is_sorted(event: Option<Event>, piece: u32) -> bool {
    match event {
        Some(Event::Ask {
            piece: asked,
            parts,
            ..
        }) => asked == piece || parts.is_some_and(|parts| parts.contains(&piece)),
        Some(
            Event::Node { .. }
            | Event::Built { .. }
            | Event::Visit { .. }
            | Event::Paint { .. }
            | Event::Done,
        )
        | None => false,
    }
}
