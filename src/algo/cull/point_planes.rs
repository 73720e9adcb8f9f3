//! A point against the planes of a volume: a distance from each of them, and inside is what none has outside.
//!
//! *Bound*: one event a plane, and the end. *Cost*: three multiplications and three additions a plane, a division where the normal is
//! not of length 1, and one or two comparisons.
//!
//! ```
//! use clipscope::{algo::cull::{PointPlanes, PointPlanesInput}, geom::ViewVolume, trace::silent};
//! let planes = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?.planes().to_vec();
//! let at = |point| silent::<PointPlanes>(&PointPlanesInput { planes: planes.clone(), point });
//! assert!(at([0.0, 0.0, -1.0]).inside, "on the near plane");
//! assert_eq!(at([0.0, 0.0, -12.0]).distances[1], -2.0);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use serde::Serialize;

use crate::{
    algo::volume::{PlaneSide, signed_distance},
    geom::Plane,
    trace::{Method, Real, Tell, Told},
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct PointPlanes;

/// What is asked, of what.
#[derive(Clone, PartialEq, Debug)]
pub struct PointPlanesInput {
    /// Inside is what all of them have inside.
    pub planes: Vec<Plane>,
    /// p, finite.
    pub point: [f64; 3],
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum PointPlanesEvent {
    /// One plane is asked.
    Plane {
        /// As they were given.
        plane_idx: usize,
        /// (n·p + d) / |n|
        distance: f64,
        /// Which of the three answers it is.
        side: PlaneSide,
    },
    /// All have been asked.
    Done {
        /// Has no plane the point outside?
        inside: bool,
    },
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct PointPlanesOutput {
    /// Has no plane the point outside?
    pub inside: bool,
    /// From each plane.
    pub distances: Vec<f64>,
}

impl Method for PointPlanes {
    type Input = PointPlanesInput;
    type Held = PointPlanesOutput;
    type Output = PointPlanesOutput;
    type Event = PointPlanesEvent;

    #[inline]
    fn begin(input: &Self::Input) -> Self::Held {
        PointPlanesOutput {
            inside: true,
            distances: Vec::with_capacity(input.planes.len()),
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        for (plane_idx, plane) in input.planes.iter().enumerate() {
            let distance = signed_distance::<R>(plane, input.point);
            let side = PlaneSide::of(distance);
            held.inside &= side != PlaneSide::Outside;
            held.distances.push(distance.get());
            let asked = PointPlanesEvent::Plane {
                plane_idx,
                distance: distance.get(),
                side,
            };
            tell.tell(held, asked)?;
        }
        let inside = held.inside;
        tell.tell(held, PointPlanesEvent::Done { inside })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held
    }

    /// One a plane, and the end.
    fn max_events(input: &Self::Input) -> usize {
        input.planes.len() + 1
    }
}
