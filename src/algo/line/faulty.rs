//! **Wrong on purpose.** Clipping lines with one mistake each: the same algorithms with one rule changed ([`LineRules`],
//! [`CodeRules`]). Only "what is wrong here?" and what names the mistakes of answers know this room.

use crate::{
    algo::{
        parameter::Ratio,
        segment::{CodeClip, CodeRules, Coded, Ends, LineClip, LineRules},
    },
    geom::{Axis, ConvexPolygon, Edge, Window},
    trace::Real,
};

use super::CohenSutherlandInput;

/// The corners are clockwise, and every normal points outside: entering and leaving change places.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NormalsOutside;

impl LineRules for NormalsOutside {
    const TURNS_NORMALS: bool = true;
}

/// Cyrus–Beck with this mistake.
pub type OutwardCyrusBeck = LineClip<2, ConvexPolygon, NormalsOutside>;

/// p = 0 is passed over as if nothing had to be asked: what runs parallel outside a side stays.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ForgetsParallel;

impl LineRules for ForgetsParallel {
    const FORGETS_PARALLEL: bool = true;
}

/// Liang–Barsky with this mistake.
pub type FaultyLiangBarsky = LineClip<2, Window, ForgetsParallel>;

/// The slope is turned over, Δx/Δy where Δy/Δx belongs; measured, as most programs do, along what is left.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TurnsSlope;

impl CodeRules<2, CohenSutherlandInput> for TurnsSlope {
    fn crossing<R: Real>(
        input: &CohenSutherlandInput,
        edge: Edge,
        left: &Ends<2>,
    ) -> ([f64; 2], Ratio) {
        let (_, u) = input.crossing::<R>(edge, left);
        let [[x1, y1], [x2, y2]] = left.map(|at| at.map(R::new));
        let border = R::new(input.window.border(edge));
        let to = match edge.axis() {
            Axis::X => [border, y1 + (x2 - x1) / (y2 - y1) * (border - x1)],
            Axis::Y => [x1 + (y2 - y1) / (x2 - x1) * (border - y1), border],
        };
        (to.map(R::get), u)
    }
}

/// `if` where `while` belongs: after one cut nobody looks again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LooksOnce;

impl CodeRules<2, CohenSutherlandInput> for LooksOnce {
    const CUTS_ONCE: bool = true;
}

/// Two ends outside are taken for two ends beyond one side.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RejectsTwoOutside;

impl CodeRules<2, CohenSutherlandInput> for RejectsTwoOutside {
    const REJECTS_TWO_OUTSIDE: bool = true;
}

/// Cohen–Sutherland with the mistake `L`.
pub type FaultyCohenSutherland<L> = CodeClip<2, CohenSutherlandInput, L>;
