//! The shared algorithm module: one file an algorithm, each in the shape of its published pseudocode.
//!
//! Nothing here draws, says or formats anything: an algorithm takes validated input, returns its answer,
//! and reports small events on the way (see [`crate::trace`]).
#![warn(
    missing_docs,
    clippy::missing_errors_doc,
    clippy::must_use_candidate,
    clippy::return_self_not_must_use
)]

pub mod cull;
pub mod line;
pub mod parameter;
pub mod pipeline;
pub mod polygon;
pub mod ring;
pub mod segment;
pub mod surface;
pub mod volume;
pub mod why;
