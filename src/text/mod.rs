//! What a person reads: languages, message catalogues, and numbers as people write them.
//!
//! The pure half of the program never holds a sentence. It holds a [`Message`]: a key into the
//! catalogues and the numbers of this very step. A [`Catalog`] turns it into a sentence of one
//! [`Lang`], and writes numbers and [`Formula`]s the way a reader of that language expects.
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
//! The catalogues lie in `assets/messages/<language>/*.ftl` and are compiled in: nothing is read
//! at run time. English is complete at all times; a key missing elsewhere is said in English, and
//! a key missing everywhere is shown as `⟦key⟧`, so that it cannot pass unseen.

mod catalog;
mod diagnostic;
mod lang;
mod message;
mod number;
mod piece;
mod reading;
mod system;
mod writing;

pub use catalog::{AREAS, Catalog, sources};
pub use diagnostic::Diagnostic;
pub use lang::{Lang, UnknownLang};
pub use message::{Formula, Message, Token, Value};
pub use number::Notation;
pub use piece::Piece;
pub use reading::read_numbers;
pub use system::SystemError;
