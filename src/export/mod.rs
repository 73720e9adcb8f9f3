//! Pictures for slides and books: a lesson's figures drawn with no display and no GPU, the same bytes on
//! every machine.

mod figure;
mod files;
mod graded;
mod jobs;

pub use figure::{Options, Picture, Steps, Studio};
pub use files::write_whole;
pub use graded::{Drawn, draw_graded};
pub use jobs::{Content, Failure, Job, Source, jobs, jobs_of, run};
