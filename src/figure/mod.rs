//! What a picture of a step says: a display list with roles, a caption, a watch table, a place in the
//! pseudocode. No colours, no pixels, no language: those are chosen when it is drawn.

mod frame;
mod mark;
mod run;
mod second;
mod watch;

pub use frame::{Caption, Frame};
pub use mark::{Label, Link, Mark, Role, Shape, Texel};
pub use run::{Moment, MomentError, Run, Tick};
pub use second::{Clipper, ClipperRow, Fate, LineTick, NumberLine, Second, Side, Traveller};
pub use watch::{Watch, WatchRow, WatchSection, mark_changes};
