//! From a vertex of a model to a place on the screen, and from two such places to the pixels of a line.

mod bresenham;
mod line_to_pixels;
mod viewing_pipeline;

pub use bresenham::{Bresenham, BresenhamEvent, BresenhamInput, TooManyPixels};
pub use line_to_pixels::{DrawnSegment, LineToPixels, LineToPixelsEvent, LineToPixelsInput};
pub use viewing_pipeline::{
    PipelineSpace, ViewingPipeline, ViewingPipelineEvent, ViewingPipelineInput,
    ViewingPipelineOutput, row_times,
};
