//! Things, and arrows from one to another: what must come before what, or a tree.

mod layers;
mod spread;

use crate::text::Value;

use super::role::{Link, Role};

pub use layers::{Spot, Stands, layers};
pub use spread::spread;

/// Nodes and arrows between them.
#[derive(Clone, PartialEq, Debug)]
pub struct Graph {
    /// Over it: what an arrow says.
    pub title: Value,
    /// The same ones at every step of a run, in the same order.
    pub nodes: Vec<GraphNode>,
    /// Between them.
    pub arrows: Vec<GraphArrow>,
    /// Where the nodes stand.
    pub places: Places,
    /// What the heavy arrows are, all together: a cycle.
    pub ring: Option<Value>,
    /// The node that must be seen: where the step is.
    pub focus: Option<usize>,
}

/// Where the nodes of a [`Graph`] stand.
#[derive(Clone, PartialEq, Debug)]
pub enum Places {
    /// As the things themselves do in a picture: to the right, and down. What stands too close is moved apart.
    Free(Vec<[f64; 2]>),
    /// A tree from the first node: what is below each to the left, and to the right.
    Layers(Vec<[Option<usize>; 2]>),
}

/// A thing.
#[derive(Clone, PartialEq, Debug)]
pub struct GraphNode {
    /// What it is called.
    pub name: Value,
    /// Its tone in the picture: whose, and how dark from 0 to 1.
    pub tone: (Role, f64),
    /// [`Role::Signal`] for this step's, [`Role::Accent`] for what has been come past, [`Role::Faint`] for what is not known
    /// yet, else [`Role::Ink`].
    pub role: Role,
    /// Is it there?
    pub stage: NodeStage,
    /// Its place in an order that has been found.
    pub number: Option<Value>,
    /// What is said of it beside it, where there is room.
    pub note: Option<Value>,
    /// What it is about.
    pub link: Option<Link>,
}

/// Whether a [`GraphNode`] is there: its place is kept for it from the start.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NodeStage {
    /// Not yet: not drawn.
    ToCome,
    /// This step puts something where it is going to be: dashed.
    Asked,
    /// It is.
    There,
}

/// From one node to another.
#[derive(Clone, PartialEq, Debug)]
pub struct GraphArrow {
    /// Where it begins.
    pub from: usize,
    /// Where it ends.
    pub to: usize,
    /// How it is drawn.
    pub kind: ArrowKind,
    /// [`Role::Signal`] for this step's, [`Role::Accent`] for what has been walked, else [`Role::Soft`].
    pub role: Role,
    /// Why, where there is room for it.
    pub reason: Option<Value>,
}

/// How a [`GraphArrow`] is drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArrowKind {
    /// It holds: solid.
    Holds,
    /// It is asked whether it may, and it may: dashed.
    Allowed,
    /// It is asked whether it may, and it may not: dashed and crossed.
    Refused,
    /// One of a cycle: heavy.
    Ring,
    /// From a node of a tree to one below: a line without a head.
    Branch,
}

impl Graph {
    /// Of more nodes that stand freely no more are drawn than these, in their order: this step's, what they have arrows to, and then
    /// those nearest to the first of them.
    pub fn near(&self, most: usize) -> Vec<usize> {
        let n = self.nodes.len();
        if n <= most {
            return (0..n).collect();
        }
        let mut chosen: Vec<usize> = Vec::new();
        let take = |chosen: &mut Vec<usize>, node: usize| {
            if chosen.len() < most && !chosen.contains(&node) {
                chosen.push(node);
            }
        };
        let is_now = |role: Role| matches!(role, Role::Signal | Role::Accent);
        if let Some(node) = self.focus {
            take(&mut chosen, node);
        }
        for arrow in &self.arrows {
            if is_now(arrow.role) || arrow.kind == ArrowKind::Ring {
                take(&mut chosen, arrow.from);
                take(&mut chosen, arrow.to);
            }
        }
        let mut nth = 0;
        while let Some(&node) = chosen.get(nth) {
            for arrow in &self.arrows {
                if arrow.from == node || arrow.to == node {
                    take(&mut chosen, arrow.from);
                    take(&mut chosen, arrow.to);
                }
            }
            nth += 1;
        }
        let mut rest: Vec<usize> = (0..n).collect();
        if let (Places::Free(places), Some(&first)) = (&self.places, chosen.first()) {
            let to = |node: usize| {
                let [a, b] = [places[node], places[first]];
                (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)
            };
            rest.sort_by(|&a, &b| to(a).total_cmp(&to(b)));
        }
        for node in rest {
            take(&mut chosen, node);
        }
        chosen.sort_unstable();
        chosen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn node(name: usize) -> GraphNode {
        GraphNode {
            name: Value::Count(name),
            tone: (Role::Soft, 0.0),
            role: Role::Ink,
            stage: NodeStage::There,
            number: None,
            note: None,
            link: None,
        }
    }

    #[test]
    fn of_many_the_step_and_what_is_about_it_are_near() {
        let graph = Graph {
            title: Value::Count(0),
            nodes: (0..30).map(node).collect(),
            arrows: vec![
                GraphArrow {
                    from: 20,
                    to: 3,
                    kind: ArrowKind::Holds,
                    role: Role::Soft,
                    reason: None,
                },
                GraphArrow {
                    from: 29,
                    to: 20,
                    kind: ArrowKind::Allowed,
                    role: Role::Signal,
                    reason: None,
                },
            ],
            places: Places::Free((0..30).map(|x| [f64::from(x), 0.0]).collect()),
            ring: None,
            focus: Some(29),
        };
        assert_eq!(graph.near(30).len(), 30, "all of them");
        assert_eq!(graph.near(4), [3, 20, 28, 29]);
        assert_eq!(graph.near(2), [20, 29], "the step's own");
    }
}
