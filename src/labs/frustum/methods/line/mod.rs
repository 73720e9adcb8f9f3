//! Clipping a segment by inequalities, shown: against a box, against planes, and in clip space.

mod bounds;
mod fates;
pub mod marks;
mod variants;
pub mod w_lens;

use crate::{
    algo::segment::{LineClip, LineRules, VisibleLine},
    labs::frustum::prelude::*,
};

use super::super::part::segment_verdict;

pub use bounds::SpaceLine;

impl<const N: usize> Answer for VisibleLine<N> {
    fn told(&self) -> impl Serialize {
        let segment = self.as_ref().map(|ends| ends.as_flattened());
        json!({ "visible": self.is_some(), "segment": segment })
    }
}

impl<const N: usize, B: SpaceLine<N>, L> SpaceTelling for LineClip<N, B, L>
where
    L: LineRules + LineVariant<N, B>,
{
    const SUBJECT: Subject = B::SUBJECT;

    fn input(scene: &Scene) -> B::Input {
        B::input(scene)
    }

    fn drawn(scene: &Scene, at: [f64; 3]) -> [f64; 3] {
        B::drawn(scene, at)
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let input = B::input(scene);
        let fate = |end| fates::fate::<N, B, L>(&input, end);
        segment_verdict(scene, (B::SUBJECT, about), fate, run)
    }
}
