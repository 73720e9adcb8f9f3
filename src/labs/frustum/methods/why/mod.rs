//! Proofs by picture: where the formulas of this lab come from.

mod facing;
mod projection_row;
mod shadow;
mod similar;
