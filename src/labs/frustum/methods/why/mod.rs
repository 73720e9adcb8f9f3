//! Proofs by picture: where the formulas of this lab come from.

mod error_term;
mod facing;
mod projection_row;
mod quarter_turn;
mod shadow;
mod similar;
