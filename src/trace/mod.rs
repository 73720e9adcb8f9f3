//! Told runs: one implementation of each algorithm, silent or recorded.
//!
//! An algorithm is written once, in the shape of its published pseudocode, over a [`Real`] scalar. It works in a memory of its
//! own, which has the answer after the end, and tells small events as it goes. A program runs it with [`silent`]: nobody listens,
//! and what is told compiles to nothing. A [`Recording`] runs it over [`Counted`], and keeps the events and how many operations
//! had been done by each. To show step *k*, the run is made again up to its *k*-th event.
#![warn(
    missing_docs,
    clippy::missing_errors_doc,
    clippy::must_use_candidate,
    clippy::return_self_not_must_use
)]

mod counts;
pub mod laws;
mod method;
mod recording;
mod transport;

pub use counts::{Counted, Counts, Real, wide_quotient};
pub use method::{Hear, Includes, Listening, Method, Silent, Tell, Told, held_after, silent, told};
pub use recording::{Recording, Step};
pub use transport::Transport;
