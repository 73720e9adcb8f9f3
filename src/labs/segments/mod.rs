//! Clipping a segment, told: what is said of it in the plane and in space alike. What each calls its sides and its numbers, and
//! how it draws them, stands with its own lab.

pub mod code_step;
mod ends;
pub mod inequalities;
mod line_step;
mod line_table;
mod prelude;

pub use code_step::CodeStep;
pub use ends::{ENDS, end_named, left_in};
pub use line_step::{LineKeys, LineLook, LineStep, LineVariant, SeenRow};
pub use line_table::row_values;
