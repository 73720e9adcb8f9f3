//! Proofs by picture: where the formulas of this lab come from.

mod crosses_once;
mod fence;
