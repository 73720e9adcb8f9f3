//! Facets as they are seen: which show their outer side, and what they hide.
//!
//! ```text
//!    eye ●───────────╱▔╲            hidden by a facet is what lies behind its plane and, seen from the eye,
//!         ╲      A ━╱━━━╲┅┅┅ B      within its edges: the part of a segment on the inner side of those planes,
//!          ╲       ╲____╱          found as a clipper finds it, with an interval of the parameter
//! ```

use std::ops::Range;

use glam::DVec3;

use crate::{algo::volume::clipped, geom::Plane};

use super::super::{facet::normal, facets::Facets, lens::Optics};
use super::{
    grid::{Bounds, Found, Grid},
    interval::{inside, union},
};

/// A part of the distance: edges lie in the planes of facets as exactly as rounding lets them.
const BEHIND: f64 = 1e-7;

#[derive(Clone, Debug)]
struct InView {
    idx: u32,
    corners: Range<usize>,
    /// Away from the solid; not normalised.
    normal: DVec3,
    nearest: f64,
}

#[derive(Clone, Debug)]
pub struct FacetsInView {
    optics: Optics,
    pub is_closed: bool,
    faces_eye: Vec<bool>,
    corners: Vec<DVec3>,
    facets: Vec<InView>,
    bounds: Vec<Bounds>,
    grid: Grid,
    found: Found,
    /// As they look now: what is not there hides nothing.
    pub looks: Facets,
}

impl FacetsInView {
    /// Of closed solids those that are turned away hide nothing that the others do not: they are left out.
    pub fn new(facets: Facets, is_closed: bool, optics: Optics) -> Self {
        let mut seen = Self {
            optics,
            is_closed,
            faces_eye: Vec::with_capacity(facets.len()),
            corners: Vec::with_capacity(2 * facets.len()),
            facets: Vec::with_capacity(facets.len() / 2),
            bounds: Vec::with_capacity(facets.len() / 2),
            grid: Grid::new(&[]),
            found: Found::default(),
            looks: Facets::default(),
        };
        let mut corners = Vec::new();
        for facet in &*facets {
            corners.clear();
            let in_view = facet.corners.iter();
            corners.extend(in_view.map(|&at| optics.view_from_world(at.into())));
            seen.push(&corners);
        }
        seen.grid = Grid::new(&seen.bounds);
        seen.looks = facets;
        seen
    }

    fn push(&mut self, corners: &[DVec3]) {
        let idx = self.faces_eye.len() as u32;
        let Some(&first) = corners.first() else {
            return self.faces_eye.push(false);
        };
        let normal = normal(corners);
        let faces_eye = normal.dot(self.optics.toward_eye(first)) > 0.0;
        self.faces_eye.push(faces_eye);
        if self.is_closed && !faces_eye {
            return;
        }
        let start = self.corners.len();
        if corners.iter().all(|at| at.z <= -self.optics.near) {
            self.corners.extend(corners);
        } else {
            self.corners.extend(cut_at(corners, -self.optics.near));
        }
        let seen = start..self.corners.len();
        let shown = &self.corners[seen.clone()];
        let places = shown.iter().map(|&at| self.optics.picture_from_view(at));
        self.bounds.push(Bounds::around(places));
        self.facets.push(InView {
            idx,
            nearest: shown.iter().fold(f64::NEG_INFINITY, |z, at| z.max(at.z)),
            corners: seen,
            normal,
        });
    }

    pub fn faces_eye(&self, facet: u32) -> Option<bool> {
        self.faces_eye.get(facet as usize).copied()
    }

    /// Hidden intervals of a segment's parameter, in order. Neither end is too near; it is no edge of the facets `but`.
    pub fn hidden(&mut self, ends: [DVec3; 2], but: [Option<u32>; 2]) -> Vec<[f64; 2]> {
        let places = ends.map(|at| self.optics.picture_from_view(at));
        let bounds = Bounds::around(places);
        let farthest = ends[0].z.min(ends[1].z);
        let mut hidden = Vec::new();
        for &nth in self.grid.near(places, &mut self.found) {
            let facet = &self.facets[nth as usize];
            let its_bounds = &self.bounds[nth as usize];
            let is_before = farthest < facet.nearest
                && bounds.meets(its_bounds)
                && its_bounds.meets_line(places);
            let is_there = self.looks.role(facet.idx as usize).is_some();
            if is_before && is_there && !but.contains(&Some(facet.idx)) {
                let corners = &self.corners[facet.corners.clone()];
                let faces_eye = self.faces_eye[facet.idx as usize];
                let shadow = shadow(&self.optics, (facet.normal, faces_eye), corners);
                hidden.extend(inside(ends, shadow));
            }
        }
        union(hidden)
    }
}

/// What is hidden lies inside all of these planes: n·p − d ≥ 0. One is behind the facet, the others hold its edges.
fn shadow<'a>(
    optics: &'a Optics,
    (normal, faces_eye): (DVec3, bool),
    corners: &'a [DVec3],
) -> impl Iterator<Item = (DVec3, f64)> + 'a {
    let turn = if faces_eye { 1.0 } else { -1.0 };
    let n = corners.len();
    let through_eye = (0..n).map(move |i| {
        let [a, b] = [corners[i], corners[(i + 1) % n]];
        let normal = optics.toward_eye(a).cross(b - a) * turn;
        (normal, normal.dot(a))
    });
    let back = -normal * turn;
    let depth = corners.first().map_or(f64::INFINITY, |&first| {
        back.dot(first) + BEHIND * back.length() * first.length()
    });
    std::iter::once((back, depth)).chain(through_eye)
}

pub fn cut_at(corners: &[DVec3], most: f64) -> Vec<DVec3> {
    let corners: Vec<[f64; 3]> = corners.iter().map(|&at| at.into()).collect();
    let plane = Plane::new([0.0, 0.0, -1.0, most]);
    let kept = plane.map_or_else(|_| Vec::new(), |plane| clipped(&corners, &plane));
    kept.into_iter().map(DVec3::from).collect()
}
