//! The spaces, and what their pictures say of the vertex that is followed.

use crate::algo::pipeline::PipelineSpace;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PictureSpace {
    Model,
    World,
    View,
    /// Before the divide.
    Clip,
    /// After it.
    Ndc,
    /// In pixels.
    Screen,
}

impl PictureSpace {
    /// In the order in which a vertex goes through them.
    pub const ALL: [Self; 6] = [
        Self::Model,
        Self::World,
        Self::View,
        Self::Clip,
        Self::Ndc,
        Self::Screen,
    ];

    pub const fn name_key(self) -> &'static str {
        match self {
            Self::Model => "space-model",
            Self::World => "space-world",
            Self::View => "space-view",
            Self::Clip => "space-clip",
            Self::Ndc => "space-ndc",
            Self::Screen => "space-screen",
        }
    }

    pub const fn title_key(self, is_parallel: bool) -> &'static str {
        match self {
            Self::Model => "space-model-title",
            Self::World => "space-world-title",
            Self::View => "space-view-title",
            Self::Clip if is_parallel => "space-clip-parallel-title",
            Self::Clip => "space-clip-title",
            Self::Ndc => "space-ndc-title",
            Self::Screen => "space-screen-title",
        }
    }

    pub const fn n_coordinates(self) -> usize {
        match self {
            Self::Clip => 4,
            Self::Screen => 2,
            Self::Model | Self::World | Self::View | Self::Ndc => 3,
        }
    }

    /// The space that a matrix leads into.
    pub const fn reached(into: PipelineSpace) -> Self {
        Self::ALL[into as usize + 1]
    }
}

#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Followed {
    pub at: [f64; 4],
    /// So many of its coordinates are known.
    pub n_known: usize,
    /// The coordinate that this step has found.
    pub current: Option<usize>,
    /// It is compared with −w and w.
    pub is_tested: bool,
    /// It has come here at this step.
    pub arrives: bool,
    /// The picture is large: axes are named, and other vertices can be chosen.
    pub is_large: bool,
}
