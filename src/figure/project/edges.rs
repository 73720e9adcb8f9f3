//! Edges of solids: outlines, creases, and what is behind.

use super::super::{
    mark::{Mark, Shape, Weight},
    role::Role,
    space::Edge3,
};
use super::{Seen, weight};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    /// Behind it there is nothing of its solid.
    Silhouette,
    /// Both its facets are seen, and meet at an angle that is meant.
    Crease,
    /// Both its facets are seen; it is there because round solids are made of facets.
    Facet,
    /// Both its facets are turned away: seen only where the solid is open, or a part of it is left out.
    Behind,
}

const SILHOUETTE: Weight = weight(1.25, 1.0);
const CREASE: Weight = weight(1.0, 1.0);
const FACET: Weight = weight(0.6, 0.33);
const HIDDEN: Weight = weight(0.9, 0.5);
const CUT: Weight = weight(2.0, 1.0);

impl Seen {
    pub(super) fn edge(&mut self, edge: &Edge3) -> Vec<Mark> {
        let kind = self.kind(edge);
        let is_solid = matches!(edge.role, Role::Ink | Role::Soft | Role::Faint);
        let is_round = !edge.is_crease && is_solid;
        if kind == Kind::Behind && !edge.is_crease {
            return Vec::new();
        }
        let parted = self.parted(edge.ends, edge.facets);
        let line = |ends: [[f64; 2]; 2], role| Mark::new(role, Shape::Path(ends.to_vec()));
        let mut marks = Vec::new();
        for ends in parted.hidden {
            if is_round || kind == Kind::Facet {
                continue;
            }
            let role = if is_solid { Role::Soft } else { edge.role };
            marks.push(line(ends, role).dashed().weighing(HIDDEN));
        }
        for ends in parted.visible {
            let weight = match (kind, edge.role) {
                (Kind::Facet, _) => FACET,
                (_, Role::Accent | Role::Signal | Role::Accepted) => CUT,
                (Kind::Silhouette, _) => SILHOUETTE,
                (Kind::Crease | Kind::Behind, _) => CREASE,
            };
            let mut mark = line(ends, edge.role).weighing(weight);
            mark.is_dashed = edge.role == Role::Discarded && kind != Kind::Facet;
            marks.push(mark);
        }
        marks
    }

    fn kind(&self, edge: &Edge3) -> Kind {
        let faces_eye = |facet: Option<u32>| facet.and_then(|facet| self.facets.faces_eye(facet));
        match edge.facets.map(faces_eye) {
            [None, None] if !edge.is_crease => Kind::Facet,
            [Some(true), Some(true)] if edge.is_crease => Kind::Crease,
            [Some(true), Some(true)] => Kind::Facet,
            [Some(false), Some(false)] => Kind::Behind,
            [Some(_), Some(_)] | [None, _] | [_, None] => Kind::Silhouette,
        }
    }
}
