//! Clipping a segment, told: what is said of it in the plane and in space alike. What each calls its sides and its numbers, and
//! how it draws them, stands with its own lab.

mod code_step;
pub mod codes;
mod ends;
pub mod inequalities;
mod line_look;
mod line_step;
mod line_table;

pub use code_step::CodeStep;
pub use ends::{ENDS, is_point, left_in, place};
pub use line_look::{LineKeys, LineLook, LineVariant};
pub use line_step::{LineStep, SeenRow};
pub use line_table::row_values;
