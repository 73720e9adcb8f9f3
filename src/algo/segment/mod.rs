//! Clipping a segment in however many dimensions: by codes, and by the interval of the parameter. [`crate::algo::line`] and
//! [`crate::algo::volume`] have what is clipped against.

mod code;
mod code_clip;
mod fields;
mod line_clip;
mod line_event;

pub use code::Code;
pub use code_clip::{CodeClip, CodeEvent, CodeRules, Coded};
pub(super) use fields::Fields;
pub use line_clip::{Bounds, EventOf, Given, LineClip, LineInput, LineRules};
pub use line_event::{Ends, LineAnswer, LineEvent, PlaneRow, RowNumbers, Spelling, VisibleLine};
