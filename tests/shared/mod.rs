//! What several suites use.

use std::io::{Write, stderr};

pub mod event_log;
#[cfg(feature = "gui")]
pub mod pictures;
pub mod space_bytes;

/// Says what a test leaves out, where it is always seen: what a test that passes has printed is not shown.
pub fn say_left_out(what: &str) {
    writeln!(stderr(), "\nnote: {what}").expect("the note is written");
}
