//! The methods of this lab. To add one: a file in `algo::polygon`, its [`PolygonDemo`] beside the others, one
//! line below.

use std::fmt;

use crate::{algo::polygon, figure::Run, labs::MethodCard};

use super::{PolygonDemo, Scene, methods::faulty};

/// What is known of a method without running it.
pub struct MethodInfo {
    /// Names, source and pseudocode.
    pub card: MethodCard,
    /// Does it clip: against the window, or a clip polygon in its place?
    pub clips: bool,
    /// Does it carry texture coordinates along?
    pub carries_texture: bool,
    /// Does it know holes?
    pub knows_holes: bool,
    record: fn(&Scene) -> Box<dyn Run>,
}

const fn info<A: PolygonDemo>() -> MethodInfo {
    MethodInfo {
        card: MethodCard::of::<A>(),
        clips: A::CLIPS,
        carries_texture: A::CARRIES_TEXTURE,
        knows_holes: A::KNOWS_HOLES,
        record: |scene| A::record(scene).unwrap_or_else(|refusal| refusal.run(scene)),
    }
}

/// Every method, in the order in which they are taught.
pub static METHODS: [MethodInfo; 10] = [
    info::<polygon::SutherlandHodgman>(),
    info::<polygon::Pipeline>(),
    info::<polygon::weiler_atherton::WeilerAtherton>(),
    info::<polygon::EarClipping>(),
    info::<polygon::TriangulateAndClip>(),
    info::<faulty::OnBorder>(),
    info::<faulty::Open>(),
    info::<faulty::Clockwise>(),
    info::<faulty::Twice>(),
    info::<faulty::EndBeforeCrossing>(),
];

/// One of [`METHODS`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Method(usize);

impl Method {
    /// In the order of the registry.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        (0..METHODS.len()).map(Self)
    }

    /// The method with this id.
    #[must_use]
    pub fn by_id(id: &str) -> Option<Self> {
        METHODS.iter().position(|info| info.card.id == id).map(Self)
    }

    /// What is known of it.
    #[must_use]
    pub fn info(self) -> &'static MethodInfo {
        &METHODS[self.0]
    }

    /// Its names, source and pseudocode.
    #[must_use]
    pub fn card(self) -> &'static MethodCard {
        &self.info().card
    }

    /// Runs it on the scene; where it cannot take it, the run has no steps and says why.
    #[must_use]
    pub fn record(self, scene: &Scene) -> Box<dyn Run> {
        (self.info().record)(scene)
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.card().id)
    }
}
