//! The labs: each has a document, methods that work on it, and a file a method that says how its steps are
//! shown. What every lab has in common is here beside them.

mod card;
mod demo;
mod difference;
mod document;
mod handle;
pub mod lines;
pub mod polygons;
mod split_mix;
mod words;

pub use card::{CodeLine, MethodCard};
pub use demo::{Answer, Demo, Step};
pub use difference::Difference;
pub use document::{Document, Lab, Scene};
pub use handle::{Corner, Handle, Lock};

use card::code_line;
pub(crate) use demo::{record, record_wrong};
pub(crate) use words::vertex_symbol;
