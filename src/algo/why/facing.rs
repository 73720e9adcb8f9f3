//! Why n·e > 0 says that a face shows its front. e leads from a vertex of the face to the eye; its shadow on n is how high the eye is above the
//! plane of the face, n·e / |n|. Above it one sees the side that n points to, the front: the angle between n and e is less than 90°. Laid on one
//! bar, all faces of a solid have the eye somewhere above or below. *Cost*: that of the back-face test, and a division a face.

use serde::Serialize;

use crate::{
    algo::cull::{BackFaceInput, Viewer, normal_and_viewer},
    trace::{Real, Told},
};

use super::Proof;

/// The proof; see the module.
#[derive(Clone, Copy, Debug)]
pub struct Facing;

/// Faces, the one that is looked at first, and who looks.
#[derive(Clone, PartialEq, Debug)]
pub struct FacingInput {
    /// Each counter-clockwise as seen from outside.
    pub faces: Vec<[[f64; 3]; 3]>,
    /// One of them.
    pub first: usize,
    /// The others that are laid on the same bar.
    pub others: Vec<usize>,
    /// Where they are looked at from.
    pub viewer: Viewer,
}

/// What is shown, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum FacingFact {
    /// n·e of the first face.
    Product,
    /// How long n is there. If it is 0 the face has no side, and this is the end.
    Length,
    /// How high the eye is above its plane: n·e / |n|.
    Height,
    /// The same of another face.
    Face {
        /// Which one.
        face: usize,
    },
    /// Above how many of them the eye is: the end.
    Fronts,
}

impl FacingInput {
    /// n and e of a face, and n·e; none where n has no length.
    #[must_use]
    pub fn measured<R: Real>(&self, face: usize) -> ([[R; 3]; 2], R) {
        let (triangle, viewer) = (self.faces[face], self.viewer);
        let [n, e] = normal_and_viewer::<R>(&BackFaceInput { triangle, viewer });
        ([n, e], n[0] * e[0] + n[1] * e[1] + n[2] * e[2])
    }

    /// |n| of a face.
    #[must_use]
    pub fn length(&self, face: usize) -> f64 {
        let ([n, _], _) = self.measured::<f64>(face);
        libm::hypot(libm::hypot(n[0], n[1]), n[2])
    }
}

impl Proof for Facing {
    type Input = FacingInput;
    type Fact = FacingFact;

    fn prove<R: Real, S>(
        input: &FacingInput,
        show: &mut impl FnMut(FacingFact, R) -> Told<S>,
    ) -> Told<S> {
        let (_, dot) = input.measured::<R>(input.first);
        show(FacingFact::Product, dot)?;
        let length = input.length(input.first);
        show(FacingFact::Length, R::new(length))?;
        if length == 0.0 {
            return Told::Continue(());
        }
        show(FacingFact::Height, dot / R::new(length))?;
        let mut n_fronts = i32::from(dot > R::new(0.0));
        for &face in &input.others {
            let ((_, dot), length) = (input.measured::<R>(face), input.length(face));
            n_fronts += i32::from(dot > R::new(0.0));
            if length > 0.0 {
                show(FacingFact::Face { face }, dot / R::new(length))?;
            }
        }
        show(FacingFact::Fronts, R::new(f64::from(n_fronts)))
    }

    fn max_facts(input: &FacingInput) -> usize {
        input.others.len() + 4
    }
}
