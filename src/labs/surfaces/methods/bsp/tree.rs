//! The tree, drawn: below each node what lies before its plane to the left, what lies behind it to the right. Every node has its
//! place from the start; walked, it has its place in the order of painting.

use crate::{
    algo::surface::{Bsp, BspEvent as Event, BspNode, BspSide},
    figure::{ArrowKind, Graph, GraphArrow, GraphNode, NodeStage, Places},
};

use super::super::prelude::*;

use super::names::{node_of, painted, piece_name, visited};

struct Tree<'a> {
    at: &'a At<'a, Bsp>,
    node: Option<u32>,
    visited: Vec<(u32, BspSide)>,
    painted: Vec<u32>,
}

pub fn tree(at: &At<'_, Bsp>, scene: &Scene) -> Graph {
    let tree = Tree {
        at,
        node: at.step.event().and_then(node_of),
        visited: visited(at.step.past).collect(),
        painted: painted(at.step.past).collect(),
    };
    let whole = at.step.input.whole_tree();
    let own = tree.node.map(|node| whole[node as usize].id);
    let n_nodes = at.step.held.nodes.len();
    let nodes = whole.iter().enumerate().map(|(number, node)| GraphNode {
        name: tree.name(number, node),
        tone: tone(node.id, own),
        role: tree.role(number as u32),
        stage: if number < n_nodes {
            NodeStage::There
        } else {
            NodeStage::ToCome
        },
        number: tree.number(node),
        note: tree.eye(number as u32),
        link: surface_link(scene, node.id),
    });
    let mut nodes: Vec<GraphNode> = nodes.collect();
    let mut arrows = tree.branches();
    for (name, arrow) in tree.waiting() {
        let node = &mut nodes[arrow.to];
        node.stage = NodeStage::Asked;
        node.name = name;
        node.role = arrow.role;
        arrows.push(arrow);
    }
    let below = |node: &BspNode| [node.front, node.back].map(|child| Some(child? as usize));
    Graph {
        title: Value::Term("bsp-tree"),
        nodes,
        arrows,
        places: Places::Layers(whole.iter().map(below).collect()),
        ring: None,
        focus: tree.node.map(|node| node as usize),
    }
}

impl Tree<'_> {
    fn name(&self, number: usize, node: &BspNode) -> Value {
        let now = self.at.step.held.nodes.get(number).unwrap_or(node);
        self.names(&now.on)
            .unwrap_or_else(|| name_of(self.at.scenery, node.id))
    }

    /// `B, D+`, of more than two pieces the first; none where none of them is known yet.
    fn names(&self, pieces: &[u32]) -> Option<Value> {
        let known = &self.at.step.held.pieces;
        let mut names = pieces.iter().filter_map(|&piece| {
            let piece = known.get(piece as usize)?;
            let name = piece_name(self.at.scenery, piece);
            Some(text_of(name, piece.id as usize))
        });
        let first = names.next()?;
        Some(Value::Name(match (names.next(), names.next()) {
            (None, _) => first,
            (Some(second), None) => format!("{first}, {second}"),
            (Some(_), Some(_)) => format!("{first} …"),
        }))
    }

    fn role(&self, number: u32) -> Role {
        if self.node == Some(number) {
            Role::Signal
        } else if self.is_visited(number) {
            Role::Accent
        } else {
            Role::Ink
        }
    }

    fn is_visited(&self, number: u32) -> bool {
        let mut visited = self.visited.iter();
        visited.any(|(node, _)| *node == number)
    }

    /// Its place in the order of painting; of several pieces the first and the last.
    fn number(&self, node: &BspNode) -> Option<Value> {
        let places = (1..).zip(&self.painted);
        let places = places.filter(|(_, piece)| node.on.contains(piece));
        let places: Vec<usize> = places.map(|(place, _)| place).collect();
        let (first, last) = (*places.first()?, *places.last()?);
        Some(if first == last {
            Value::Count(first)
        } else {
            Value::Name(format!("{first}–{last}"))
        })
    }

    fn eye(&self, number: u32) -> Option<Value> {
        let mut visited = self.visited.iter();
        let (_, eye) = visited.find(|(node, _)| *node == number)?;
        Some(Value::Term(match eye {
            BspSide::Front => "bsp-eye-before",
            BspSide::Back => "bsp-eye-behind",
            BspSide::On | BspSide::Cut => "bsp-eye-on",
        }))
    }

    fn branches(&self) -> Vec<GraphArrow> {
        let new = match self.at.step.event() {
            Some(Event::Node { node, .. } | Event::Visit { node, .. }) => Some(node),
            Some(Event::Ask { .. } | Event::Built { .. } | Event::Paint { .. } | Event::Done)
            | None => None,
        };
        let branch = |(number, node): (u32, &BspNode)| {
            let (parent, side) = node.parent?;
            // This step's, walked already, or neither.
            let role = if new == Some(number) {
                Role::Signal
            } else if self.is_visited(number) {
                Role::Accent
            } else {
                Role::Soft
            };
            Some(GraphArrow {
                from: parent as usize,
                to: number as usize,
                kind: ArrowKind::Branch,
                role,
                reason: Some(Value::Term(match side {
                    BspSide::Back => "bsp-behind",
                    BspSide::Front | BspSide::On | BspSide::Cut => "bsp-before",
                })),
            })
        };
        (0..)
            .zip(&self.at.step.held.nodes)
            .filter_map(branch)
            .collect()
    }

    /// The pieces that wait for a node of their own, each with the arrow from the node that has sorted them to where theirs will
    /// be; this step's stands out.
    fn waiting(&self) -> Vec<(Value, GraphArrow)> {
        let (nodes, event) = (&self.at.step.held.nodes, self.at.step.event());
        let is_to_come = |to: &u32| *to as usize >= nodes.len();
        let mut all = Vec::new();
        let whole = self.at.step.input.whole_tree();
        for (from, (node, whole)) in nodes.iter().zip(whole).enumerate() {
            let sides = [(whole.front, &node.before), (whole.back, &node.behind)];
            for (to, pieces) in sides {
                let (Some(to), Some(name)) = (to.filter(is_to_come), self.names(pieces)) else {
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
                all.push((name, arrow));
            }
        }
        all
    }
}

/// Is this step about that piece, or one that it is a part of?
fn is_sorted(event: Option<Event>, piece: u32) -> bool {
    matches!(event, Some(Event::Ask { piece: asked, parts, .. })
        if asked == piece || parts.is_some_and(|parts| parts.contains(&piece)))
}
