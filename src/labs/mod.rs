//! The labs: each has a scene, methods that work on it, and a file a method that says how its steps are shown. What
//! every lab has in common is here beside them; [`LABS`] is the table that a lab joins.

mod card;
mod crossing_formulas;
mod difference;
mod edit;
pub mod frustum;
mod handle;
mod interval;
mod lab;
pub mod lines;
mod moved;
pub mod polygons;
mod prelude;
pub mod recorded;
mod refused;
mod registry;
mod rings;
mod segments;
mod sketch;
mod smaller;
pub mod space;
mod split_mix;
pub mod surfaces;
pub mod telling;
mod typed;
mod why;
mod window_handles;
mod words;

pub use card::{CodeLine, MethodCard};
pub use difference::{Difference, comparison};
pub use edit::Edit;
pub use handle::{Handle, HandleKind, Motion};
pub use lab::{
    Answers, AtStep, Backdrop, Change, ChangeOf, Click, Document, Draggable, Lab, Lock,
    OutlineKind, Own, Plain, Scene, Verdict,
};
pub use moved::{listed, moved};
pub use registry::{Listed, Method, MethodEntry};
pub use sketch::Sketch;
pub use smaller::smaller;
pub use telling::Answer;
pub use typed::{not_read, typed_change, written};

pub(crate) use words::{numbered, plane_symbol, vertex_symbol};

/// Every lab, in the order in which they are taught.
pub static LABS: [&Lab; 4] = [lines::LAB, polygons::LAB, frustum::LAB, surfaces::LAB];
