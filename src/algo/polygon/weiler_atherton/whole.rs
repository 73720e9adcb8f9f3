//! Rings that change no lists, as a whole; and how the two polygons lie, once all rings are known.

use std::cmp::Ordering;

use crate::{
    geom::Location,
    trace::{Real, Tell, Told},
};

use super::{
    Clipping, WeilerAtherton,
    event::WeilerAthertonEvent as Event,
    input::List,
    predicate::side,
    rings::{BorderRing, Relation},
    side::{IntersectionLabel, Labelled, Side},
    walk::{kind, whole_ring_bounds},
};

/// Where the parts of both borders lie, by the other polygon: all that [`Relation`] asks.
#[derive(Default)]
pub struct Sides {
    subject_inside: bool,
    subject_outside: bool,
    clip_outside: bool,
}

impl Sides {
    fn of(labels: &[Labelled]) -> Self {
        let mut sides = Self::default();
        for labelled in labels {
            for side in labelled.subject {
                sides.add(List::Subject, side);
            }
            for side in labelled.clip {
                sides.add(List::Clip, side);
            }
        }
        sides
    }

    fn add(&mut self, list: List, side: Side) {
        let outside = matches!(side, Side::Outside | Side::Against);
        match list {
            List::Subject => {
                self.subject_inside |= side == Side::Inside;
                self.subject_outside |= outside;
            }
            List::Clip => self.clip_outside |= outside,
        }
    }

    pub fn relation(&self, common_area: bool, common_points: bool) -> Relation {
        if !common_area {
            return if common_points {
                Relation::Touching
            } else {
                Relation::Disjoint
            };
        }
        match (
            self.subject_outside,
            self.clip_outside || self.subject_inside,
        ) {
            (false, false) => Relation::Equal,
            (false, true) => Relation::SubjectInside,
            (true, false) => Relation::ClipInside,
            (true, true) => Relation::Crossing,
        }
    }
}

impl<T: Tell<WeilerAtherton>> Clipping<'_, T> {
    pub fn whole_rings<R: Real>(&mut self) -> Told<T::Stop, Sides> {
        let mut sides = Sides::of(&self.held.labels);
        for list in [List::Subject, List::Clip] {
            for ring_idx in 0..self.borders[list.idx()].n_rings() {
                self.whole_ring::<R>(list, ring_idx, &mut sides)?;
            }
        }
        Told::Continue(sides)
    }

    /// Where nothing crosses a ring it bounds the result all along or nowhere: one intersection tells, or one vertex.
    fn whole_ring<R: Real>(
        &mut self,
        list: List,
        ring_idx: usize,
        sides: &mut Sides,
    ) -> Told<T::Stop> {
        let lists = &self.held.lists;
        let starts = &lists.starts[list.idx()];
        let places = [starts[ring_idx], starts[ring_idx + 1]];
        let entries = &lists.entries[list.idx()][places[0] as usize..places[1] as usize];
        let nodes = entries.iter().filter_map(super::lists::Entry::node);
        let mut labels = nodes.map(|node| &self.held.labels[node as usize]);
        let changes = |labelled: &Labelled| labelled.label != IntersectionLabel::Touching;
        if labels.clone().any(changes) {
            return Told::Continue(());
        }
        let side = match (labels.next(), list) {
            (Some(labelled), List::Subject) => labelled.subject[1],
            (Some(labelled), List::Clip) => labelled.clip[1],
            (None, _) => {
                let side = self.side_of::<R>(list, ring_idx);
                sides.add(list, side);
                side
            }
        };
        let is_hole = list == List::Subject && ring_idx > 0;
        let ring = whole_ring_bounds(list, side).then(|| {
            let corners = entries.iter().filter(|it| it.is_corner(&self.held.labels));
            let border = self.borders[list.idx()];
            let points: Vec<_> = corners.map(|entry| lists.at(entry, border)).collect();
            let kind = kind(&points, is_hole);
            BorderRing { points, kind }
        });
        let kind = ring.as_ref().map(|ring| ring.kind);
        self.held.rings.extend(ring);
        self.held.walk.end();
        self.tell(Event::Whole {
            list,
            ring_idx: ring_idx as u32,
            places,
            side,
            kind,
        })
    }

    fn side_of<R: Real>(&self, list: List, ring_idx: usize) -> Side {
        let at = self.borders[list.idx()].ring(ring_idx)[0];
        let other = self.borders[1 - list.idx()];
        let at_most = |a, b| R::new(a) <= R::new(b);
        let turn = |a, b, c| {
            let order = side::<R>(a, b, c).partial_cmp(&R::new(0.0));
            order.unwrap_or(Ordering::Equal)
        };
        let location = other.locate_by(at, at_most, turn);
        if location == Location::Outside {
            Side::Outside
        } else {
            Side::Inside
        }
    }
}
