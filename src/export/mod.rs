//! Pictures for slides and books: a lesson's figures drawn with no display and no GPU, the same bytes on
//! every machine.

#[cfg(not(target_arch = "wasm32"))]
mod animation;
mod figure;
#[cfg(not(target_arch = "wasm32"))]
mod files;
#[cfg(not(target_arch = "wasm32"))]
mod graded;
#[cfg(not(target_arch = "wasm32"))]
mod jobs;
#[cfg(not(target_arch = "wasm32"))]
mod slides;

pub use figure::{Options, Picture, Steps, Studio};
#[cfg(not(target_arch = "wasm32"))]
pub use files::write_whole;
#[cfg(not(target_arch = "wasm32"))]
pub use graded::{Drawn, draw_graded};
#[cfg(not(target_arch = "wasm32"))]
pub use jobs::{Content, Failure, Job, Source, jobs, jobs_of, loops, run};
#[cfg(not(target_arch = "wasm32"))]
pub use slides::{Slide, slides};
