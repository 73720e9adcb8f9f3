//! Proofs by picture: where the formulas of this lab come from.

mod double_area;
mod mean;
mod strips;
