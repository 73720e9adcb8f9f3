//! The facets of all solids, and how they look now: of very many a step changes the looks alone.

use std::{
    ops::Deref,
    sync::{Arc, OnceLock},
};

use rustc_hash::FxHashSet;

use super::{
    facet::Facet,
    role::{Link, Role},
    solid_mesh::SolidMesh,
};

/// Shared, so that a step that changes none copies none.
#[derive(Clone, Default, Debug)]
pub struct Facets {
    all: Arc<All>,
    /// In place of their own roles; none of a facet that is not there.
    looks: Option<Arc<[Option<Role>]>>,
}

#[derive(Default, Debug)]
struct All {
    facets: Box<[Facet]>,
    mesh: OnceLock<SolidMesh>,
    links: OnceLock<FxHashSet<Link>>,
}

impl Facets {
    /// The same facets with other roles; those without one are not there.
    pub fn looking(&self, looks: Vec<Option<Role>>) -> Self {
        Self {
            all: self.all.clone(),
            looks: Some(looks.into()),
        }
    }

    /// What is drawn of them wherever they are seen from: found once.
    pub fn mesh(&self) -> &SolidMesh {
        self.all.mesh.get_or_init(|| SolidMesh::of(self))
    }

    /// Is one of them about this?
    pub fn are_about(&self, link: Link) -> bool {
        let links = || self.iter().filter_map(|facet| facet.link).collect();
        self.all.links.get_or_init(links).contains(&link)
    }

    /// What a facet looks like; none where it is not there.
    pub fn role(&self, idx: usize) -> Option<Role> {
        match &self.looks {
            Some(looks) => *looks.get(idx)?,
            None => Some(self.get(idx)?.role),
        }
    }

    /// Those that are there, with their roles.
    pub fn shown(&self) -> impl Iterator<Item = (&Facet, Role)> {
        let all = self.iter().enumerate();
        all.filter_map(|(idx, facet)| Some((facet, self.role(idx)?)))
    }

    pub fn are_all_shown(&self) -> bool {
        let looks = self.looks.as_deref();
        looks.is_none_or(|looks| looks.iter().all(Option::is_some))
    }

    /// Are they the very same but for their looks?
    pub fn are_shared_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.all, &other.all)
    }
}

impl Deref for Facets {
    type Target = [Facet];

    fn deref(&self) -> &[Facet] {
        &self.all.facets
    }
}

impl From<Vec<Facet>> for Facets {
    fn from(facets: Vec<Facet>) -> Self {
        let all = All {
            facets: facets.into(),
            mesh: OnceLock::new(),
            links: OnceLock::new(),
        };
        Self {
            all: Arc::new(all),
            looks: None,
        }
    }
}

impl PartialEq for Facets {
    fn eq(&self, other: &Self) -> bool {
        self.looks == other.looks && (self.are_shared_with(other) || **self == **other)
    }
}
