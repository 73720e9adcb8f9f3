//! Solids as they are seen: which facet at each pixel.

use std::sync::Arc;

use super::{Facet, Lens};

/// The faces of solids, and what they are seen through.
#[derive(Clone, PartialEq, Debug)]
pub struct Solids {
    /// All of them.
    pub facets: Arc<[Facet]>,
    /// What they are seen through.
    pub lens: Lens,
}
