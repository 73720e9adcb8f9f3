//! Pictures for slides and books: a lesson's figures drawn with no display and no GPU, the same bytes on
//! every machine.

#[cfg(not(target_arch = "wasm32"))]
mod animation;
#[cfg(not(target_arch = "wasm32"))]
mod crew;
mod figure;
#[cfg(not(target_arch = "wasm32"))]
mod files;
#[cfg(not(target_arch = "wasm32"))]
mod format;
#[cfg(not(target_arch = "wasm32"))]
mod graded;
#[cfg(not(target_arch = "wasm32"))]
mod handout;
#[cfg(not(target_arch = "wasm32"))]
mod jobs;
#[cfg(not(target_arch = "wasm32"))]
mod shapes;
#[cfg(not(target_arch = "wasm32"))]
mod slides;
#[cfg(not(target_arch = "wasm32"))]
mod vector;

#[cfg(not(target_arch = "wasm32"))]
pub use crew::{Content, Failure, run};
pub use figure::{Options, Picture, Steps, Studio};
#[cfg(not(target_arch = "wasm32"))]
pub use files::write_whole;
#[cfg(not(target_arch = "wasm32"))]
pub use format::Format;
#[cfg(not(target_arch = "wasm32"))]
pub use graded::{Drawn, draw_graded};
#[cfg(not(target_arch = "wasm32"))]
pub use handout::{Handout, Paper};
#[cfg(not(target_arch = "wasm32"))]
pub use jobs::{Job, Missing, Source, Way, between, in_format, jobs, jobs_of};
#[cfg(not(target_arch = "wasm32"))]
pub use shapes::{Made, Shapes, shapes};
#[cfg(not(target_arch = "wasm32"))]
pub use slides::{Slide, slides};
#[cfg(not(target_arch = "wasm32"))]
pub use vector::Letters;
