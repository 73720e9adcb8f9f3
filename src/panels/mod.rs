//! What each lab adds to the window.

mod clock;
mod edit;
pub mod lines;
mod pickers;
pub mod polygons;
mod seeded;
mod spots;

pub use clock::Stopwatch;
pub use edit::{Edit, EditError};
pub use pickers::{compare_picker, method_picker};
pub use seeded::Seeded;
pub use spots::{Reach, spots};
