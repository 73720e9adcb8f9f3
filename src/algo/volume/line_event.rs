//! What a clipper of segments reports, whatever is clipped against what.

use serde::{Serialize, Serializer};

use crate::algo::parameter::End;

/// The visible part of a segment by its ends; `None` where there is none.
pub type VisibleLine<const N: usize> = Option<[[f64; N]; 2]>;

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum LineEvent<P, const N: usize> {
    /// P₂ − P₁, where it is worked out once for all planes.
    Delta {
        /// Of each coordinate.
        #[serde(serialize_with = "list")]
        delta: [f64; N],
    },
    /// In clip space: what is clipped, and which ends lie behind the eye.
    Depths {
        /// Both ends as they will be clipped.
        #[serde(serialize_with = "lists")]
        ends: [[f64; N]; 2],
        /// w < 0, of each end: where both have it, nothing is visible.
        behind: [bool; 2],
    },
    /// One inequality `u·p ≤ q`.
    Row {
        /// The plane.
        plane: P,
        /// Which way the line goes: inside where negative.
        p: f64,
        /// How far P₁ lies inside the plane.
        q: f64,
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
        #[serde(serialize_with = "list")]
        at: [f64; N],
    },
    /// What is left is visible.
    Accept {
        /// The ends of the visible part.
        #[serde(serialize_with = "lists")]
        ends: [[f64; N]; 2],
    },
    /// Nothing is visible.
    Reject {
        /// The plane at which it was decided; `None` where none had to be asked.
        plane: Option<P>,
    },
}

/// Arrays of any length, which Serde does not know.
fn list<const N: usize, S: Serializer>(at: &[f64; N], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(at)
}

fn lists<const N: usize, S: Serializer>(
    ends: &[[f64; N]; 2],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(ends.iter().map(|at| &at[..]))
}

/// One line of the table.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LineRow<P> {
    /// The plane.
    pub plane: P,
    /// How much the way to P₂ takes away.
    pub p: f64,
    /// How far P₁ lies inside.
    pub q: f64,
    /// q / p, where there is one.
    pub r: Option<f64>,
    /// u_min and u_max after it, once known.
    pub left: Option<[f64; 2]>,
}
