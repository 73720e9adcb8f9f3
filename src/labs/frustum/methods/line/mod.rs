//! Clipping a segment by inequalities, shown: against a box, against planes, and in clip space.

mod bounds;
mod fates;
pub mod marks;
mod variants;
mod w_lens;

use serde_json::{Value as Json, json};

use crate::{
    algo::{
        ring::Right,
        segment::{LineClip, LineRules, VisibleLine},
    },
    labs::{frustum::prelude::*, segments::LineVariant},
};

use super::super::part::segment_verdict;

pub use bounds::{SpaceLine, face_equation, unit_box};

impl<const N: usize> Answer for VisibleLine<N> {
    fn json(&self) -> Json {
        let segment = self.as_ref().map(|ends| ends.as_flattened());
        json!({ "visible": self.is_some(), "segment": segment })
    }
}

impl<const N: usize, B: SpaceLine<N>, L> SpaceTelling for LineClip<N, B, L>
where
    L: LineRules + LineVariant<N, B>,
    Right: LineVariant<N, B>,
{
    const SUBJECT: Subject = B::SUBJECT;

    fn input(scene: &Scene) -> B::Input {
        B::input(scene)
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let input = B::input(scene);
        let fate = |end| fates::fate::<N, B, L>(&input, end);
        segment_verdict(scene, (B::SUBJECT, about), fate, run)
    }

    fn record(scene: &Scene) -> Box<dyn Run> {
        let run = Recorded::<Self>::beside::<LineClip<N, B, Right>>;
        Box::new(run(Self::input(scene), Some(scenery_of(scene))))
    }
}
