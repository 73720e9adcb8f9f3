//! What differs, as a picture: the case as it was given, what is true, and what the program says instead.
//!
//! Which picture it is the case says: pixels, a plane, clip space, or space. What has no place in any is shown as the
//! algorithm's own views show it, and always stand the numbers of the true step beside it ([`Wrong::numbers`]).

mod clip_space;
mod plane;
mod raster;
mod space;
mod told;

use serde_json::Value as Json;

use crate::{
    case::Solvers,
    figure::{Body, Caption, Mark, View},
};

use super::{
    tally::Wrong,
    truth::{Known, Right},
    whole::Whole,
};

/// A picture of what differs.
pub enum Scenery {
    /// Marks of the plane, and the least and the largest coordinates of it, with some room.
    Plane {
        /// What is drawn.
        marks: Vec<Mark>,
        /// With some room.
        bounds: [[f64; 2]; 2],
    },
    /// Views that stand beside each other.
    Views(Vec<View>),
}

impl Wrong {
    /// Of the first of a report; none where there is no case, or nothing of it can be drawn.
    #[must_use]
    pub fn scenery(&self, solvers: Solvers) -> Option<Scenery> {
        let (whole, right) = self.drawn()?;
        let case = right.case()?;
        raster::scenery(&case, &right.output, whole)
            .or_else(|| plane::scenery(&case, whole))
            .or_else(|| clip_space::scenery(&case, whole))
            .or_else(|| space::scenery(&case, whole))
            .or_else(|| {
                let views = right.shown(solvers, whole.step, |shown| shown.views())?;
                let views: Vec<View> = views.into_iter().filter(has_numbers).take(1).collect();
                (!views.is_empty()).then_some(Scenery::Views(views))
            })
    }

    /// What the true run says at the step that differs, or at its end, with its formulas.
    #[must_use]
    pub fn numbers(&self, solvers: Solvers) -> Option<Caption> {
        let (whole, right) = self.drawn()?;
        right.shown(solvers, whole.step, |shown| shown.caption())
    }

    /// Where the two differ, as a path and both values there; of the first of a report.
    #[must_use]
    pub fn parts(&self) -> Option<(&str, &[Json; 2])> {
        let whole = self.whole.as_ref()?;
        (!whole.path.is_empty()).then_some((&whole.path, &whole.parts))
    }

    /// What is true there; where no answer can be read, the whole true one.
    #[must_use]
    pub fn expected(&self) -> &Json {
        let whole = self.whole.as_ref().filter(|_| self.truth.is_null());
        whole.map_or(&self.truth, |whole| &whole.truth)
    }

    fn drawn(&self) -> Option<(&Whole, &Right)> {
        let Known { truth, .. } = self.known.as_ref()?;
        Some((self.whole.as_ref()?, truth.as_ref().as_ref().ok()?))
    }
}

const fn has_numbers(view: &View) -> bool {
    !matches!(view.body, Body::Plane(_) | Body::Space(_))
}
