//! All integration tests, as one program: it is linked once, and all its tests share the processor's cores.
//!
//! Each suite is a module. `cargo test --test all figures::` runs one of them, `cargo test --test all -- figures:: window::`
//! runs two. The suites without the window are compiled and run with `--no-default-features` as well.
//!
//! All tests run as threads of one process: none may change its environment or its working directory.
#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot be set up should stop where it stands"
)]

mod architecture;
mod captions;
mod case;
mod course;
mod diagnostics;
mod ear_clipping;
mod forms;
mod grade;
mod line_exactness;
mod links;
mod messages;
mod moments;
mod newcomer;
mod polygon_exactness;
mod questions;
mod shared;
mod signs;
mod space_bytes;
mod space_exactness;
mod surface_exactness;
mod weiler_atherton;
mod why;

#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
mod cli_grade;
#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
mod cli_trace;
#[cfg(feature = "gui")]
mod figures;
#[cfg(feature = "gui")]
mod glyphs;
#[cfg(all(feature = "gui", target_os = "linux"))]
mod hostile;
#[cfg(feature = "gui")]
mod labels;
#[cfg(feature = "gui")]
mod painting;
#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
mod vector;
#[cfg(feature = "gui")]
mod window;
