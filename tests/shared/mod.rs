//! What several suites use.

pub mod event_log;
#[cfg(feature = "gui")]
pub mod pictures;
pub mod space_bytes;
