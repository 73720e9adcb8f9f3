//! Proofs by picture: where the formulas of this lab come from.

mod shadow;
mod similar;
