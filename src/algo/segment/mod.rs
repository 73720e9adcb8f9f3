//! Clipping a segment, whatever is clipped against what and in however many dimensions: by codes, and by the interval of the
//! parameter.
//!
//! [`crate::algo::line`] and [`crate::algo::volume`] have what is clipped against: windows and polygons, boxes, planes and clip
//! space.

mod code_clip;
mod fields;
mod line_clip;
mod line_event;
mod line_rules;

pub use code_clip::{CodeClip, CodeEvent, Coded};
pub use fields::Fields;
pub use line_clip::{Bounds, EventOf, Given, LineClip, LineInput};
pub use line_event::{LineEvent, PlaneRow, RowNumbers, Spelling, VisibleLine};
pub use line_rules::LineRules;
