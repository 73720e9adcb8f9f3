//! Edges of solids: outlines, creases, and what is behind.

use super::super::{
    mark::{Mark, Shape},
    role::Role,
    space::Edge3,
};
use super::{Seen, light};

/// What an edge is, as it is seen.
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

/// Widths in points, and how strong.
const SILHOUETTE: (f32, f32) = (1.25, 1.0);
const CREASE: (f32, f32) = (1.0, 1.0);
const FACET: (f32, f32) = (0.6, 0.33);
const HIDDEN: (f32, f32) = (0.9, 0.5);
const CUT: (f32, f32) = (2.0, 1.0);

impl Seen {
    /// The visible and the hidden parts of an edge.
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
            marks.push(light(line(ends, role).dashed(), HIDDEN.0, HIDDEN.1));
        }
        for ends in parted.visible {
            let (width, strength) = match (kind, edge.role) {
                (Kind::Facet, _) => FACET,
                (_, Role::Accent | Role::Signal | Role::Accepted) => CUT,
                (Kind::Silhouette, _) => SILHOUETTE,
                (Kind::Crease | Kind::Behind, _) => CREASE,
            };
            let mark = line(ends, edge.role);
            let is_dashed = edge.role == Role::Discarded && kind != Kind::Facet;
            let mark = if is_dashed { mark.dashed() } else { mark };
            marks.push(light(mark, width, strength));
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
