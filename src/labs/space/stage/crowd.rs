//! Solids of very many faces: built once for a run, of which a step only says how each face looks.

use std::sync::{Arc, Mutex, PoisonError};

use super::{
    prelude::*,
    solids::{FaceLook, Fate, Solids},
};

/// Of more faces none is built anew at each step.
pub const MANY: usize = 20_000;

/// What was built last, for the camera's view and for the observer's: before something is cut, and after.
#[derive(Default)]
pub struct Crowd([Mutex<Vec<Arc<Built>>>; 2]);

const MOST_KEPT: usize = 2;

pub struct Built {
    /// Of each object, is it cut?
    cut: Vec<bool>,
    facets: Facets,
    edges: Arc<[Edge3]>,
    /// Of each facet, its object and which of its faces it is; those after them are of cameras.
    faces: Vec<[usize; 2]>,
}

impl Crowd {
    /// What is known of objects with these fates, or else is built.
    pub fn known(
        &self,
        is_observed: bool,
        fates: &[Fate],
        build: impl FnOnce() -> (Solids, Vec<[usize; 2]>),
    ) -> Arc<Built> {
        let cut: Vec<bool> = fates.iter().map(|&fate| fate == Fate::Cut).collect();
        let known = self.0[usize::from(is_observed)].lock();
        let mut known = known.unwrap_or_else(PoisonError::into_inner);
        if let Some(built) = known.iter().find(|built| built.cut == cut) {
            return built.clone();
        }
        let (solids, faces) = build();
        let built = Arc::new(Built {
            cut,
            facets: solids.facets.into(),
            edges: solids.edges.into(),
            faces,
        });
        known.truncate(MOST_KEPT - 1);
        known.insert(0, built.clone());
        built
    }
}

impl Built {
    /// Each face by its look or by its object's fate, and so the edges that are drawn one by one.
    pub fn looking(
        &self,
        fate: &dyn Fn(usize) -> Option<Fate>,
        look: &dyn Fn(usize, usize) -> FaceLook,
    ) -> (Facets, Arc<[Edge3]>) {
        let looks = self.facets.iter().enumerate().map(|(i, facet)| {
            let Some(&[object, face]) = self.faces.get(i) else {
                return Some(facet.role);
            };
            let fate = fate(object)?;
            let role = match look(object, face) {
                FaceLook::Whole => fate.role(),
                FaceLook::Own(role) => role,
                FaceLook::Hidden => return None,
            };
            // What is cut off stays so.
            let is_cut_off = facet.role == Role::Discarded;
            Some(if is_cut_off { facet.role } else { role })
        });
        let looks = looks.collect();
        let edges = if self.edges.is_empty() {
            self.edges.clone()
        } else {
            let edges = self.edges.iter();
            edges
                .filter_map(|edge| self.edge(edge, fate, look))
                .collect()
        };
        (self.facets.looking(looks), edges)
    }

    /// An edge as its object looks, if one of its facets is there.
    fn edge(
        &self,
        edge: &Edge3,
        fate: &dyn Fn(usize) -> Option<Fate>,
        look: &dyn Fn(usize, usize) -> FaceLook,
    ) -> Option<Edge3> {
        let face_of = |facet: u32| self.faces.get(facet as usize).copied();
        let [object, _] = edge.facets.into_iter().flatten().find_map(face_of)?;
        let fate = fate(object)?;
        let is_there = |facet: &u32| {
            let face = face_of(*facet);
            face.is_some_and(|[object, face]| look(object, face) != FaceLook::Hidden)
        };
        let facets = edge.facets.map(|facet| facet.filter(is_there));
        let role = if self.cut[object] {
            edge.role
        } else {
            fate.edge_role()
        };
        (facets != [None; 2]).then_some(Edge3 {
            facets,
            role,
            ..edge.clone()
        })
    }
}
