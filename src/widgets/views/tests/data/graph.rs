//! What must come before what, as in the prototype B2, and trees.

use crate::{
    figure::{ArrowKind, Graph, GraphArrow, GraphNode, NodeStage, Places, Role},
    text::{Formula, Value},
};

use super::name;

fn node(of: &str, shade: f64) -> GraphNode {
    GraphNode {
        name: name(of),
        tone: (Role::Soft, shade),
        role: Role::Ink,
        stage: NodeStage::There,
        number: None,
        note: None,
        link: None,
    }
}

fn arrow([from, to]: [usize; 2], kind: ArrowKind, role: Role) -> GraphArrow {
    let far = 4.31 + from as f64;
    let reason = Formula::decimals().num(far).sym(" > ").num(3.47);
    GraphArrow {
        from,
        to,
        kind,
        role,
        reason: Some(Value::Formula(reason)),
    }
}

/// Each of three before the next.
pub fn cycle() -> Graph {
    let next = |i: usize| arrow([i, (i + 1) % 3], ArrowKind::Ring, Role::Signal);
    Graph {
        title: Value::Term("painter-must"),
        nodes: vec![node("A", 0.9), node("B", 0.7), node("C", 0.1)],
        arrows: (0..3).map(next).collect(),
        places: Places::Free(vec![[10.0, 8.0], [11.0, 5.0], [6.0, 5.0]]),
        ring: Some(Value::Term("painter-cycle")),
        focus: Some(0),
    }
}

/// Of many triangles on a heap, of which one is asked about another, and told no.
pub fn many(n: usize) -> Graph {
    let names = (1..=n).map(|i| node(&format!("A{i}"), 0.3));
    let mut nodes: Vec<GraphNode> = names.collect();
    nodes[n - 1].role = Role::Signal;
    nodes[0].number = Some(Value::Count(1));
    let refused = GraphArrow {
        reason: Some(Value::Term("watch-overlap")),
        ..arrow([n - 1, 2], ArrowKind::Refused, Role::Signal)
    };
    Graph {
        nodes,
        arrows: vec![
            arrow([2, n - 1], ArrowKind::Holds, Role::Soft),
            arrow([0, 2], ArrowKind::Holds, Role::Soft),
            refused,
        ],
        places: Places::Free((0..n).map(|i| [(i % 5) as f64, (i % 3) as f64]).collect()),
        ring: None,
        focus: Some(n - 1),
        ..cycle()
    }
}

/// A tree with so many nodes, each layer full; of those walked the first is the current one.
pub fn tree(n: usize, focus: usize) -> Graph {
    let below = |i: usize| [2 * i + 1, 2 * i + 2].map(|child| (child < n).then_some(child));
    let branch = |to: usize| GraphArrow {
        reason: Some(Value::Term(if to % 2 == 1 {
            "bsp-before"
        } else {
            "bsp-behind"
        })),
        ..arrow([(to - 1) / 2, to], ArrowKind::Branch, Role::Soft)
    };
    let mut nodes: Vec<GraphNode> = (0..n).map(|i| node(&format!("D{i}+"), 0.3)).collect();
    nodes[focus].role = Role::Signal;
    nodes[focus].note = Some(Value::Term("bsp-eye-before"));
    nodes[0].number = Some(Value::Count(3));
    Graph {
        title: Value::Term("bsp-tree"),
        nodes,
        arrows: (1..n).map(branch).collect(),
        places: Places::Layers((0..n).map(below).collect()),
        ring: None,
        focus: Some(focus),
    }
}
