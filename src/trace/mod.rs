//! Traced execution: one implementation of each algorithm, silent or recorded.
//!
//! An algorithm is written once, in the shape of its published pseudocode, over a [`Real`] scalar and
//! with an `emit` closure. Production runs it over `f64` with `|_| {}`, which compiles to nothing; a
//! [`Trace`] runs it over [`Counted`], keeps the events it emitted and how many operations it had done by
//! then. A picture of step *k* is a fold over the first *k* events.

mod algorithm;
mod counts;
pub mod laws;
mod log;
mod recording;
pub mod told;
mod transport;

pub use algorithm::{Algorithm, silent};
pub use counts::{Counted, Counts, Real};
pub use log::Log;
pub use recording::Trace;
pub use transport::Transport;
