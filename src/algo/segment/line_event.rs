//! What a clipper of segments by inequalities reports, whatever is clipped against what.

use std::fmt::Debug;

use serde::{Serialize, Serializer};

use crate::{algo::parameter::End, trace::Real};

use super::Fields;

/// P₁ and P₂.
pub type Ends<const N: usize> = [[f64; N]; 2];

/// The visible part of a segment by its ends; `None` where there is none.
pub type VisibleLine<const N: usize> = Option<Ends<N>>;

/// The visible part of a segment, as a program asks for it.
pub trait LineAnswer<const N: usize>: Clone + PartialEq {
    /// From its ends.
    fn of(visible: VisibleLine<N>) -> Self;
}

impl<const N: usize> LineAnswer<N> for VisibleLine<N> {
    #[inline]
    fn of(visible: Self) -> Self {
        visible
    }
}

/// What happens, in order; `P` are planes, `W` the numbers of a row.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum LineEvent<P, const N: usize, W = PlaneRow> {
    /// P₂ − P₁, where it is worked out once for all planes.
    Delta {
        /// Of each coordinate.
        delta: [f64; N],
    },
    /// In clip space: what is clipped, and which ends lie behind the eye.
    Depths {
        /// Both ends as they will be clipped.
        ends: Ends<N>,
        /// w < 0, of each end: where both have it, nothing is visible.
        behind: [bool; 2],
    },
    /// One inequality `u·p ≤ q`.
    Row {
        /// The plane.
        plane: P,
        /// p and q, or what they follow from.
        row: W,
    },
    /// p = 0: this plane alone decides nothing if `inside`, everything if not.
    Parallel {
        /// The plane.
        plane: P,
        /// The row's q.
        q: f64,
        /// q ≥ 0
        inside: bool,
    },
    /// The line comes in across this plane.
    Enter {
        /// The plane.
        plane: P,
        /// q / p
        r: f64,
        /// Does it raise u_min?
        raises: bool,
        /// From now on.
        u_min: f64,
    },
    /// The line goes out across this plane.
    Leave {
        /// The plane.
        plane: P,
        /// q / p
        r: f64,
        /// Does it lower u_max?
        lowers: bool,
        /// From now on.
        u_max: f64,
    },
    /// Is anything left of the interval?
    Interval {
        /// Where it begins.
        u_min: f64,
        /// Where it ends.
        u_max: f64,
        /// u_min > u_max
        empty: bool,
    },
    /// An end is put at its parameter.
    Put {
        /// Which end.
        end: End,
        /// u_min or u_max.
        u: f64,
        /// The plane that set it; `None` where the end was inside and stays.
        plane: Option<P>,
        /// Where.
        at: [f64; N],
    },
    /// What is left is visible.
    Accept {
        /// The ends of the visible part.
        ends: Ends<N>,
    },
    /// Nothing is visible.
    Reject {
        /// The plane at which it was decided; `None` where none had to be asked.
        plane: Option<P>,
    },
}

impl<P, const N: usize, W> LineEvent<P, N, W> {
    pub(in crate::algo) fn delta<R: Real>(delta: [R; N]) -> Self {
        let delta = delta.map(R::get);
        Self::Delta { delta }
    }
}

/// The numbers of a row.
pub trait RowNumbers: Copy + PartialEq + Debug + 'static {
    /// What the fields of its events are called.
    const SPELLING: Spelling;

    /// p: how much the way to P₂ takes away. q: how far P₁ lies inside.
    fn p_and_q(&self) -> [f64; 2];

    /// The same of the plane's other side.
    #[must_use]
    fn turned(self) -> Self;

    /// Its own fields.
    ///
    /// # Errors
    /// Those of the serializer.
    fn with<S: Serializer>(&self, fields: Fields<S>) -> Result<Fields<S>, S::Error> {
        let [p, q] = self.p_and_q();
        fields.with("p", &p)?.with("q", &q)
    }
}

/// What the fields of events are called.
#[derive(Clone, Copy, Debug)]
pub struct Spelling {
    /// The event of a row.
    pub row: &'static str,
    /// A plane, in two dimensions and in more.
    pub plane: [&'static str; 2],
    /// q, where it stands alone.
    pub q: &'static str,
    /// The parameter of a crossing.
    pub r: &'static str,
    /// That of an end that is put in place.
    pub u: &'static str,
    /// The interval.
    pub bounds: [&'static str; 2],
}

/// p and q of a plane, or of a side.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PlaneRow {
    /// Which way the line goes: inside where negative.
    pub p: f64,
    /// How far P₁ lies inside the plane.
    pub q: f64,
}

impl PlaneRow {
    /// As they are shown: a zero has no sign.
    pub fn of<R: Real>([p, q]: [R; 2]) -> Self {
        Self {
            p: p.get() + 0.0,
            q: q.get() + 0.0,
        }
    }
}

impl RowNumbers for PlaneRow {
    const SPELLING: Spelling = Spelling {
        row: "row",
        plane: ["edge", "plane"],
        q: "q",
        r: "r",
        u: "u",
        bounds: ["u_min", "u_max"],
    };

    fn p_and_q(&self) -> [f64; 2] {
        [self.p, self.q]
    }

    fn turned(self) -> Self {
        let [p, q] = self.p_and_q().map(|x| 0.0 - x);
        Self { p, q }
    }
}

impl<P: Serialize, const N: usize, W: RowNumbers> Serialize for LineEvent<P, N, W> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let names = W::SPELLING;
        let [min_field, max_field] = names.bounds;
        let plane_field = names.plane[usize::from(N > 2)];
        let of_plane = |to, event, plane: &P| Fields::of(to, event)?.with(plane_field, plane);
        let fields = match self {
            Self::Delta { delta } => {
                let fields = Fields::of(to, "delta")?;
                match delta[..] {
                    [dx, dy] => fields.with("dx", &dx)?.with("dy", &dy)?,
                    _ => fields.with("delta", &delta[..])?,
                }
            }
            Self::Depths { ends, behind } => {
                let fields = Fields::of(to, "depths")?.with_ends(ends)?;
                fields.with("behind", behind)?
            }
            Self::Row { plane, row } => row.with(of_plane(to, names.row, plane)?)?,
            Self::Parallel { plane, q, inside } => {
                let fields = of_plane(to, "parallel", plane)?.with(names.q, q)?;
                fields.with("inside", inside)?
            }
            Self::Enter {
                plane,
                r,
                raises,
                u_min,
            } => {
                let fields = of_plane(to, "enter", plane)?.with(names.r, r)?;
                fields.with("raises", raises)?.with(min_field, u_min)?
            }
            Self::Leave {
                plane,
                r,
                lowers,
                u_max,
            } => {
                let fields = of_plane(to, "leave", plane)?.with(names.r, r)?;
                fields.with("lowers", lowers)?.with(max_field, u_max)?
            }
            Self::Interval {
                u_min,
                u_max,
                empty,
            } => {
                let fields = Fields::of(to, "interval")?.with(min_field, u_min)?;
                fields.with(max_field, u_max)?.with("empty", empty)?
            }
            Self::Put { end, u, plane, at } => {
                let fields = Fields::of(to, "put")?.with("end", end)?.with(names.u, u)?;
                fields.with(plane_field, plane)?.with("at", &at[..])?
            }
            Self::Accept { ends } => Fields::of(to, "accept")?.with_ends(ends)?,
            Self::Reject { plane } => Fields::of(to, "reject")?.with(plane_field, plane)?,
        };
        fields.end()
    }
}
