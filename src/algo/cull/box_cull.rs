//! A bounding box against the planes of a volume. A plane that has all eight corners outside culls the box. One that is kept may have
//! no point inside all planes: then drawing it is in vain ([`BoxCullOutput::false_positive`]), which [`meets`] decides exactly.
//!
//! *Bound*: one event a plane, the second test, the end. *Cost*: of the planes, of which only signs count; the second test is not
//! counted, no renderer runs it. *Source*: U. Assarsson and T. Möller, "Optimized view frustum culling algorithms for bounding boxes",
//! Journal of Graphics Tools 5, 2000, pp. 9–22; the false positives: I. Quílez, "Frustum culling correctly", 2013.
//!
//! ```
//! use clipscope::{algo::cull::{BoxCull, BoxCullInput, Containment}, geom::{AlignedBox, ViewVolume}, trace::silent};
//! let planes = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?.planes().to_vec();
//! let bounds = AlignedBox::new([10.5, -1.0, -11.0, 40.0, 1.0, 20.0])?;
//! let output = silent::<BoxCull>(&BoxCullInput { planes, bounds });
//! assert_eq!((output.class, output.false_positive), (Containment::Straddles, true));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use serde::Serialize;

use crate::{
    algo::volume::{bounded_sum, is_plain, weighted_sum},
    geom::{AlignedBox, Plane, meets},
    trace::{Method, Real, Tell, Told},
};

use super::Containment;

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct BoxCull;

/// What to cull, and by what.
#[derive(Clone, PartialEq, Debug)]
pub struct BoxCullInput {
    /// Inside is what all of them have inside.
    pub planes: Vec<Plane>,
    /// Around what may be left out, in the planes' space.
    pub bounds: AlignedBox,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum BoxCullEvent {
    /// One plane is asked about all eight corners.
    Plane {
        /// As they were given.
        plane_idx: usize,
        /// n·p + d of each corner, numbered as [`AlignedBox::corners`] has them.
        sums: [f64; 8],
        /// How many of them are below 0.
        n_outside: usize,
        /// What this plane says of the box.
        class: Containment,
    },
    /// A box that no plane rejects, and that not all accept, is asked whether anything of it is inside.
    Meets {
        /// Has it a point inside all planes?
        meets: bool,
    },
    /// The end.
    Done {
        /// What all planes say.
        class: Containment,
    },
}

/// The answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct BoxCullOutput {
    /// Where the planes say that it lies.
    pub class: Containment,
    /// Do they keep it although nothing of it is inside?
    pub false_positive: bool,
}

/// The sum, or where that has left the range of f64 another number of its sign.
#[inline]
fn signed<R: Real>(plane: &Plane, corner: [f64; 3], sum: R) -> R {
    if is_plain(sum.get()) {
        sum
    } else {
        R::new(bounded_sum(plane, corner))
    }
}

impl Method for BoxCull {
    type Input = BoxCullInput;
    type Held = BoxCullOutput;
    type Output = BoxCullOutput;
    type Event = BoxCullEvent;

    #[inline]
    fn begin(_: &Self::Input) -> Self::Held {
        BoxCullOutput {
            class: Containment::Inside,
            false_positive: false,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let corners = input.bounds.corners();
        let zero = R::new(0.0);
        for (plane_idx, plane) in input.planes.iter().enumerate() {
            let sums = corners.map(|corner| weighted_sum::<R>(plane, corner));
            let n_outside = sums
                .iter()
                .zip(corners)
                .filter(|&(&sum, corner)| signed(plane, corner, sum) < zero)
                .count();
            let class = match n_outside {
                0 => Containment::Inside,
                8 => Containment::Outside,
                _ => Containment::Straddles,
            };
            held.class = held.class.and(class);
            let asked = BoxCullEvent::Plane {
                plane_idx,
                sums: sums.map(R::get),
                n_outside,
                class,
            };
            tell.tell(held, asked)?;
            if class == Containment::Outside {
                break;
            }
        }
        if held.class == Containment::Straddles {
            let meets = meets(&input.bounds, &input.planes);
            held.false_positive = !meets;
            tell.tell(held, BoxCullEvent::Meets { meets })?;
        }
        let class = held.class;
        tell.tell(held, BoxCullEvent::Done { class })
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held
    }

    /// One a plane, the second test, the end.
    fn max_events(input: &Self::Input) -> usize {
        input.planes.len() + 2
    }
}
