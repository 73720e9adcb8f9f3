//! Things, and arrows from one to another: what must come before what, or a tree.

mod layers;
mod spread;

use crate::text::Value;

use super::role::{Link, Role};

pub use layers::{Spot, Stands, layers, size_of};
pub use spread::spread;

#[derive(Clone, PartialEq, Debug)]
pub struct Graph {
    pub title: Value,
    /// The same ones at every step of a run, in the same order.
    pub nodes: Vec<GraphNode>,
    pub arrows: Vec<GraphArrow>,
    pub places: Places,
    /// What the heavy arrows are, all together: a cycle.
    pub ring: Option<Value>,
    pub focus: Option<usize>,
}

#[derive(Clone, PartialEq, Debug)]
pub enum Places {
    Free(Vec<[f64; 2]>),
    /// A tree from the first node: what is below each to the left, and to the right.
    Layers(Vec<[Option<usize>; 2]>),
}

#[derive(Clone, PartialEq, Debug)]
pub struct GraphNode {
    pub name: Value,
    pub tone: (Role, f64),
    /// [`Role::Signal`] this step's, [`Role::Accent`] come past, [`Role::Faint`] not known yet, else [`Role::Ink`].
    pub role: Role,
    pub stage: NodeStage,
    pub number: Option<Value>,
    pub note: Option<Value>,
    pub link: Option<Link>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NodeStage {
    ToCome,
    Asked,
    There,
}

#[derive(Clone, PartialEq, Debug)]
pub struct GraphArrow {
    pub from: usize,
    pub to: usize,
    pub kind: ArrowKind,
    /// [`Role::Signal`] for this step's, [`Role::Accent`] for what has been walked, else [`Role::Soft`].
    pub role: Role,
    pub reason: Option<Value>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArrowKind {
    Holds,
    Allowed,
    Refused,
    Ring,
    Branch,
}

impl Graph {
    /// Of nodes that stand freely so many are drawn: this step's, what they have arrows to, then the nearest.
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
        let arrow = |from, to, kind, role| GraphArrow {
            from,
            to,
            kind,
            role,
            reason: None,
        };
        let graph = Graph {
            title: Value::Count(0),
            nodes: (0..30).map(node).collect(),
            arrows: vec![
                arrow(20, 3, ArrowKind::Holds, Role::Soft),
                arrow(29, 20, ArrowKind::Allowed, Role::Signal),
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
