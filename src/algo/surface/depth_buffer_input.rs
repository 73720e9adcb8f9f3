//! What the depth buffer is filled with, and how much is told of it.

use super::{DepthFormat, Surfaces};

/// How much happens in one step.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum DepthSteps {
    /// One fragment: the pixel of one triangle.
    #[default]
    Fragments,
    /// All of a triangle's fragments in one row.
    Spans,
    /// All of a triangle's fragments.
    Triangles,
}

/// Triangles, in the order in which they are drawn.
#[derive(Clone, PartialEq, Debug)]
pub struct DepthBufferInput {
    /// What is to be seen.
    pub surfaces: Surfaces,
    /// Ids, the first that is drawn first. Of two that are as near the one that came first is seen: in the order of ids,
    /// the lower id. What names no triangle is passed over.
    pub order: Vec<u32>,
    /// How depths are stored.
    pub format: DepthFormat,
    /// How much happens in one step.
    pub steps: DepthSteps,
    /// Only what happens at this pixel, where one is named.
    pub pixel: Option<[u32; 2]>,
}

impl DepthBufferInput {
    /// All of them in the order of their ids, at all pixels, fragment by fragment, and nothing rounded.
    #[must_use]
    pub fn new(surfaces: Surfaces) -> Self {
        Self {
            order: surfaces.ids().collect(),
            surfaces,
            format: DepthFormat::default(),
            steps: DepthSteps::default(),
            pixel: None,
        }
    }
}
