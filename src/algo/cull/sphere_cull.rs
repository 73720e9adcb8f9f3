//! A bounding sphere against the planes of a volume: with d the distance of its centre from a plane, d < −r is outside, and no other
//! plane is asked; d ≥ r is inside; between, it straddles. One that straddles planes and lies outside every corner is kept in vain.
//!
//! *Bound*: one event a plane, and the end. *Cost*: three multiplications and three additions a plane, a division where the normal is
//! not of length 1, one or two comparisons. *Source*: J. H. Clark, "Hierarchical geometric models for visible surface algorithms",
//! Communications of the ACM 19, 1976, pp. 547–554.
//!
//! ```
//! use clipscope::{algo::cull::{Containment, SphereCull, SphereCullInput}, geom::{Sphere, ViewVolume}, trace::silent};
//! let planes = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?.planes().to_vec();
//! let sphere = Sphere::new([0.0, 0.0, -11.5, 1.0])?;
//! let output = silent::<SphereCull>(&SphereCullInput { planes, sphere });
//! assert_eq!((output.class, output.distances), (Containment::Outside, vec![10.5, -1.5]));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    algo::{ring::Right, volume::signed_distance},
    geom::{Plane, Sphere},
    trace::{Method, Real, Tell, Told},
};

use super::{Containment, CullRules};

/// The algorithm; see the module. `L` are its rules.
#[derive(Clone, Copy, Debug)]
pub struct SphereCull<L = Right>(PhantomData<L>);

/// What to cull, and by what.
#[derive(Clone, PartialEq, Debug)]
pub struct SphereCullInput {
    /// Inside is what all of them have inside.
    pub planes: Vec<Plane>,
    /// Around what may be left out.
    pub sphere: Sphere,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum SphereCullEvent {
    /// One plane is asked.
    Plane {
        /// As they were given.
        plane_idx: usize,
        /// d, of the centre.
        distance: f64,
        /// What this plane says of the sphere.
        class: Containment,
    },
    /// One plane has rejected it, or none is left.
    Done {
        /// What all planes say.
        class: Containment,
    },
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct SphereCullOutput {
    /// Where it lies.
    pub class: Containment,
    /// Of the centre from each plane that was asked: the last one is that which rejects, if one does.
    pub distances: Vec<f64>,
}

impl SphereCullOutput {
    /// No plane has been asked.
    #[inline]
    pub(super) fn unasked(n_planes: usize) -> Self {
        Self {
            class: Containment::Inside,
            distances: Vec::with_capacity(n_planes),
        }
    }

    /// Asks one plane more: how far from it the centre lies, and what it says of the sphere.
    #[inline]
    pub(super) fn ask<R: Real, L: CullRules>(
        &mut self,
        plane: &Plane,
        sphere: &Sphere,
    ) -> (f64, Containment) {
        let distance = signed_distance::<R>(plane, sphere.center());
        let class = sphere_side::<R, L>(distance, R::new(sphere.radius()));
        self.distances.push(distance.get());
        self.class = self.class.and(class);
        (distance.get(), class)
    }
}

/// What a plane says of a sphere whose centre lies at this distance.
#[inline]
pub fn sphere_side<R: Real, L: CullRules>(distance: R, radius: R) -> Containment {
    let inwards = if L::TURNS_SIGN { -distance } else { distance };
    if inwards < -radius {
        Containment::Outside
    } else if inwards >= radius {
        Containment::Inside
    } else {
        // Also where sums are larger than any number: a test that cannot tell keeps.
        Containment::Straddles
    }
}

impl<L: CullRules> Method for SphereCull<L> {
    type Input = SphereCullInput;
    type Held = SphereCullOutput;
    type Output = SphereCullOutput;
    type Event = SphereCullEvent;

    #[inline]
    fn begin(input: &Self::Input) -> Self::Held {
        SphereCullOutput::unasked(input.planes.len())
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        for (plane_idx, plane) in input.planes.iter().enumerate() {
            let (distance, class) = held.ask::<R, L>(plane, &input.sphere);
            let asked = SphereCullEvent::Plane {
                plane_idx,
                distance,
                class,
            };
            tell.tell(held, asked)?;
            if class == Containment::Outside {
                break;
            }
        }
        let class = held.class;
        tell.tell(held, SphereCullEvent::Done { class })
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
