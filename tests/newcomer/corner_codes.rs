//! A bounding box by the outcodes of its eight corners in clip space. A bit that all eight have in common: the box is wholly beyond that
//! plane. No bit anywhere: it is inside. Else it may meet the volume, or lie outside beyond an edge: the codes cannot tell.
//!
//! *Exact*: the codes are, of the sums as they are rounded. *Bound*: one event a corner, and the end. *Cost*: twelve
//! multiplications, twelve additions and six comparisons a corner, and no division. *Source*: the codes of Cohen and Sutherland,
//! W. M. Newman and R. F. Sproull, *Principles of Interactive Computer Graphics*, 1973; of boxes, T. Akenine-Möller et al., *Real-Time
//! Rendering*.

use clipscope::{
    algo::{cull::Containment, pipeline::row_times, volume::SideCode},
    geom::{AlignedBox, Matrix},
    trace::{Method, Real, Tell, Told},
};
use serde::Serialize;

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct CornerCodes;

/// What to cull, and by what.
#[derive(Clone, PartialEq, Debug)]
pub struct CornerCodesInput {
    /// From the space of the box to clip space.
    pub clip_from_box: Matrix,
    /// Around what may be left out.
    pub bounds: AlignedBox,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum CornerCodesEvent {
    /// A corner gets its code.
    Corner {
        /// As [`AlignedBox::corners`] numbers them.
        corner_idx: usize,
        /// Where it is in clip space.
        clip: [f64; 4],
        /// Of the planes that it lies beyond.
        code: SideCode,
    },
    /// All have one: the end.
    Done {
        /// The bits that all of them have: the planes that the whole box lies beyond.
        and: SideCode,
        /// The bits that any of them has.
        or: SideCode,
        /// What that says of the box.
        class: Containment,
    },
}

/// The answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct CornerCodesOutput {
    /// Where the codes say that it lies.
    pub class: Containment,
    /// Of the corners.
    pub codes: [SideCode; 8],
}

impl Method for CornerCodes {
    type Input = CornerCodesInput;
    type Held = CornerCodesOutput;
    type Output = CornerCodesOutput;
    type Event = CornerCodesEvent;

    #[inline]
    fn begin(_: &Self::Input) -> Self::Held {
        CornerCodesOutput {
            class: Containment::Straddles,
            codes: [SideCode::default(); 8],
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let rows = input.clip_from_box.rows();
        for (corner_idx, corner) in input.bounds.corners().into_iter().enumerate() {
            let clip = rows.map(|row| row_times(row, corner.map(R::new)));
            let code = SideCode::of(clip);
            held.codes[corner_idx] = code;
            let clip = clip.map(R::get);
            let coded = CornerCodesEvent::Corner {
                corner_idx,
                clip,
                code,
            };
            tell.tell(held, coded)?;
        }
        let [first, others @ ..] = held.codes;
        let and = others.into_iter().fold(first, SideCode::and);
        let or = others.into_iter().fold(first, SideCode::or);
        held.class = match (and.is_inside(), or.is_inside()) {
            (false, _) => Containment::Outside,
            (true, true) => Containment::Inside,
            (true, false) => Containment::Straddles,
        };
        let class = held.class;
        tell.tell(held, CornerCodesEvent::Done { and, or, class })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held
    }

    /// One a corner, and the end.
    fn max_events(_: &Self::Input) -> usize {
        9
    }
}
