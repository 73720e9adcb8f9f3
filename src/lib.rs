//! stub

#[cfg(feature = "gui")]
pub mod paint;
