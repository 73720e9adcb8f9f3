//! The methods of this lab. To add one: a file in `algo::polygon`, its [`PolygonDemo`] beside the others, one
//! line below.

use crate::{
    algo::polygon,
    figure::Run,
    labs::{self, Listed, MethodCard},
};

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
pub type Method = labs::Method<MethodInfo>;

impl Listed for MethodInfo {
    fn all() -> &'static [Self] {
        &METHODS
    }

    fn card(&self) -> &MethodCard {
        &self.card
    }
}

impl MethodInfo {
    /// Runs it on the scene; where it cannot take it, the run has no steps and says why.
    #[must_use]
    pub fn record(&self, scene: &Scene) -> Box<dyn Run> {
        (self.record)(scene)
    }
}
