//! Entering or leaving? What the subject does at each intersection, from the four edges that meet there.
//!
//! ```text
//!     before ╲     ╱ after        The two edges of the subject as rays, by the corner of the clip polygon: each
//!             ╲   ╱               goes inside, outside, along one of its edges in the same direction, or
//!    clip ─────╲●╱───── clip      against it.
//!
//!    inside for the walk = inside, or along;   outside for the walk = outside, or against.
//! ```
//!
//! Where both borders run the same way, the shared edge bounds the result, and the subject's copy is walked; where they run against each
//! other it bounds nothing. So each label is decided on the spot; Foster, Hormann and Popa carry undecided ones along a shared
//! chain to its end ("delayed crossing", "delayed bouncing").

use crate::{
    geom::{Point, Rings},
    trace::{Real, Tell, Told},
};

use super::{
    Clipping, WeilerAtherton,
    event::WeilerAthertonEvent as Event,
    lists::Intersection,
    meeting::Contact,
    predicate::{Ray, ray},
    side::{IntersectionLabel, Labelled, Side, bounds_the_result},
};

impl<T: Tell<WeilerAtherton>> Clipping<'_, T> {
    pub fn label<R: Real>(&mut self) -> Told<T::Stop> {
        let [subject, clip] = self.borders;
        let n_nodes = self.held.lists.nodes.len();
        self.held
            .labels
            .reserve_exact(n_nodes - self.held.labels.len());
        for node_idx in self.held.labels.len()..n_nodes {
            self.rest(node_idx, n_nodes);
            let labelled = of_node::<R>(subject, clip, &self.held.lists.nodes[node_idx]);
            let Labelled {
                label,
                subject: [before, after],
                ..
            } = labelled;
            self.held.labels.push(labelled);
            self.tell(Event::Labelled {
                node_idx: node_idx as u32,
                label,
                before,
                after,
            })?;
        }
        Told::Continue(())
    }
}

fn of_node<R: Real>(subject: &Rings, clip: &Rings, node: &Intersection) -> Labelled {
    if node.meeting.contact == Contact::Crossing {
        let (inwards, outwards) = ([Side::Outside, Side::Inside], [Side::Inside, Side::Outside]);
        // The subject comes from the right of the clip edge, so the clip polygon comes from its left.
        return if node.meeting.from_right {
            Labelled {
                label: IntersectionLabel::Entering,
                subject: inwards,
                clip: outwards,
            }
        } else {
            Labelled {
                label: IntersectionLabel::Leaving,
                subject: outwards,
                clip: inwards,
            }
        };
    }
    let [at_subject_vertex, at_clip_vertex] = node.meeting.contact.at_vertex();
    let [s, c] = [
        corner(subject, node.edges[0], at_subject_vertex, node.meeting.at),
        corner(clip, node.edges[1], at_clip_vertex, node.meeting.at),
    ];
    let [subject, clip] = [sides::<R>(s, c), sides::<R>(c, s)];
    let label = match (subject.map(bounds_the_result), clip) {
        ([false, true], _) => IntersectionLabel::Entering,
        ([true, false], _) => IntersectionLabel::Leaving,
        ([true, true], [Side::Inside, Side::Inside]) => IntersectionLabel::Pinching,
        _ => IntersectionLabel::Touching,
    };
    Labelled {
        label,
        subject,
        clip,
    }
}

/// A point of a border, with the vertices before and after it.
fn corner(rings: &Rings, edge_idx: u32, at_vertex: bool, at: Point) -> [Point; 3] {
    let edge_idx = edge_idx as usize;
    let [from, to] = rings.edge(edge_idx);
    if at_vertex {
        [rings.points()[rings.previous(edge_idx)], from, to]
    } else {
        [from, at, to]
    }
}

fn sides<R: Real>([before, _, after]: [Point; 3], other: [Point; 3]) -> [Side; 2] {
    let side = |to, back: bool| match (ray::<R>(other, to), back) {
        (Ray::Inside, _) => Side::Inside,
        (Ray::Outside, _) => Side::Outside,
        (Ray::OnNext, false) | (Ray::OnPrevious, true) => Side::Along,
        (Ray::OnNext, true) | (Ray::OnPrevious, false) => Side::Against,
    };
    [side(before, true), side(after, false)]
}
