//! What is seen of a space, kept: of the next one only what differs is found anew.

use std::sync::Arc;

use super::super::{
    lens::Lens,
    mark::{Mark, Shape},
    role::Role,
    solids::Solids,
    space::{Mark3, Shape3, Space},
};
use super::Seen;

#[derive(Clone, Debug)]
pub struct Projected {
    space: Space,
    lens: Lens,
    /// Are facets known that hide lines? They are where none is drawn, too.
    hides: bool,
    seen: Option<Seen>,
    solids: Vec<Mark>,
    parts: Vec<Parts>,
    marks: Arc<[Mark]>,
}

#[derive(Clone, Debug, Default)]
struct Parts {
    tint: Option<Mark>,
    lines: Vec<Mark>,
}

impl Projected {
    pub fn new(space: &Space, lens: &Lens) -> Self {
        let hides = hides(space);
        let mut seen = Seen::of(space, lens, hides);
        let solids = seen.as_mut().map(|seen| seen.solids(space, lens));
        let projected = Self {
            space: Space {
                marks: Vec::new(),
                ..space.clone()
            },
            lens: *lens,
            hides,
            seen,
            solids: solids.unwrap_or_default(),
            parts: Vec::new(),
            marks: Arc::new([]),
        };
        projected.with_marks(space)
    }

    /// Is what is known of its solids good for this space through this lens?
    pub fn is_of(&self, space: &Space, lens: &Lens) -> bool {
        self.lens == *lens && self.has_solids_of(space) && (self.hides || !hides(space))
    }

    pub fn again(self, space: &Space, lens: &Lens) -> Self {
        if !self.is_of(space, lens) {
            Self::new(space, lens)
        } else if self.space.facets != space.facets || *self.space.edges != *space.edges {
            self.with_looks(space).with_marks(space)
        } else if self.space.marks == space.marks {
            self
        } else {
            self.with_marks(space)
        }
    }

    /// Where facets are not there, other parts of lines may be hidden.
    fn with_looks(mut self, space: &Space) -> Self {
        let are_whole = [&self.space, space].map(|space| space.facets.are_all_shown());
        self.space.facets.clone_from(&space.facets);
        self.space.edges.clone_from(&space.edges);
        if let Some(seen) = &mut self.seen {
            seen.facets.looks.clone_from(&space.facets);
            self.solids = seen.solids(space, &self.lens);
        }
        if are_whole != [true; 2] {
            self.parts.clear();
            self.space.marks.clear();
        }
        self
    }

    pub const fn marks(&self) -> &Arc<[Mark]> {
        &self.marks
    }

    /// Are they the same, whatever they look like now? The edges of those that are shared look as their facets do.
    fn has_solids_of(&self, space: &Space) -> bool {
        let (facets, edges) = (&self.space.facets, &self.space.edges);
        // Where some are not there, those behind them hide, too.
        let knows_all = self
            .seen
            .as_ref()
            .is_some_and(|seen| !seen.facets.is_closed);
        let is_as_whole = knows_all || facets.are_all_shown() == space.facets.are_all_shown();
        let is_shared = facets.are_shared_with(&space.facets) && is_as_whole;
        is_shared || (*facets == space.facets && *edges == space.edges)
    }

    fn with_marks(mut self, space: &Space) -> Self {
        let Some(seen) = &mut self.seen else {
            return self;
        };
        let known = self.space.marks.iter().zip(self.parts.drain(..));
        let mut known = known.map(Some).chain(std::iter::repeat_with(|| None));
        let parts = space.marks.iter().map(|mark| match known.next().flatten() {
            Some((known, parts)) if known == mark => parts,
            _ => Parts {
                tint: seen.wash(mark),
                lines: seen.mark(mark),
            },
        });
        let parts: Vec<Parts> = parts.collect();
        let tints = parts.iter().filter_map(|parts| parts.tint.as_ref());
        let lines = parts.iter().flat_map(|parts| &parts.lines);
        let marks = tints.chain(&self.solids).chain(lines).cloned().collect();
        self.space.marks.clone_from(&space.marks);
        Self {
            parts,
            marks,
            ..self
        }
    }
}

fn hides(space: &Space) -> bool {
    let is_line = |mark: &Mark3| {
        matches!(
            mark.shape,
            Shape3::Segment(_) | Shape3::Outline(_) | Shape3::Sheet(_)
        )
    };
    !space.edges.is_empty() || space.marks.iter().any(is_line)
}

impl Seen {
    fn solids(&mut self, space: &Space, lens: &Lens) -> Vec<Mark> {
        let mut marks = Vec::new();
        if !space.facets.is_empty() {
            let solids = Solids {
                facets: space.facets.clone(),
                lens: *lens,
            };
            marks.push(Mark::new(Role::Ink, Shape::Solids(solids)));
        }
        marks.extend(space.edges.iter().flat_map(|edge| self.edge(edge)));
        marks
    }
}
