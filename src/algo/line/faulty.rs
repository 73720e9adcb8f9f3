//! **Wrong on purpose.** Cyrus–Beck as by a program that turns every edge to the left for its normal and does not ask which way the
//! corners were given: the same algorithm with one rule changed ([`LineRules`]). Only "what is wrong here?" knows this room.

use crate::{
    algo::segment::{LineClip, LineRules},
    geom::ConvexPolygon,
};

/// The corners are clockwise, and every normal points outside: entering and leaving change places.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NormalsOutside;

impl LineRules for NormalsOutside {
    const TURNS_NORMALS: bool = true;
}

/// Cyrus–Beck with this mistake.
pub type OutwardCyrusBeck = LineClip<2, ConvexPolygon, NormalsOutside>;
