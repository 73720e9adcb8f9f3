//! What a person reads: languages, message catalogues, and numbers as people write them.
//!
//! The pure half never holds a sentence, but a [`Message`]: a key and the numbers of this very step.
//!
//! ```
//! use clipscope::text::{Catalog, Formula, Lang, Message};
//!
//! let step = Message::new("transport-step").with("step", 4_usize).with("total", 6_usize);
//! assert_eq!(Catalog::of(Lang::En).message(&step), "step 4 of 6");
//!
//! let t = Formula::default().sym("t = ").num(1.0).sym(" / ").operand(-4.0).equals(-0.25);
//! assert_eq!(Catalog::of(Lang::En).formula(&t), "t = 1 / (−4) = −1/4");
//! assert_eq!(Catalog::of(Lang::Es).point([-1.0, 1.5]), "(−1; 1,5)");
//! ```
//!
//! English is complete; a key missing elsewhere is said in English, one missing everywhere is shown as `⟦key⟧`.

mod catalog;
mod diagnostic;
mod fetched;
mod lang;
mod markdown;
mod message;
mod nearest;
mod number;
mod piece;
mod reading;
mod said;
mod writing;

pub use catalog::{AREAS, Catalog, sources};
pub use diagnostic::{Diagnostic, SystemError};
pub use fetched::Part;
pub use lang::Lang;
pub use markdown::as_markdown;
pub use message::{Formula, Message, Token, Value};
pub(crate) use nearest::{clipped, nearest, printable, suggestion};
pub use number::{Alike, Notation};
pub use piece::Piece;
pub use reading::read_numbers;
pub use said::Said;
