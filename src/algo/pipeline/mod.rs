//! From a vertex of a model to a place on the screen, and from two such places to the pixels of a line.

mod bresenham;
mod line_to_pixels;
mod viewing_pipeline;

pub use bresenham::{Bresenham, BresenhamEvent, BresenhamInput, BresenhamState, TooManyPixels};
pub use line_to_pixels::{
    DrawnSegment, LineToPixels, LineToPixelsEvent, LineToPixelsInput, LineToPixelsState,
};
pub use viewing_pipeline::{
    PipelineSpace, ViewingPipeline, ViewingPipelineEvent, ViewingPipelineInput,
    ViewingPipelineOutput, ViewingPipelineState, row_times,
};
