//! What each lab adds to the window.

mod clock;
pub mod lines;

pub use clock::Stopwatch;
