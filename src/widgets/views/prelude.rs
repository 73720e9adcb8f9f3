//! What every view draws with, beside what every widget does.

pub use super::super::prelude::*;
pub use super::fold::{Fold, more};
pub use super::slate::{
    Face, LEAST_SCALE, Links, OnSlate, Slate, bracketed, colour, joined, now, tone, wash,
};
pub use crate::{
    figure::{CellStage, Role},
    paint::text_colour,
};
