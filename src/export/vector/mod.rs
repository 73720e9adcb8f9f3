//! Figures as shapes, for books and slides: what the painter is given, written down instead of filled in.

mod about;
mod face;
mod ink;
mod number;
mod page;
mod pdf;
mod read;
mod svg;
mod tikz;
mod web_font;

pub use about::About;
pub use page::VectorPage;
pub use pdf::{PdfPage, PdfPart, Tag, pdf, pdf_of_one};
pub use read::read;
pub use svg::{Letters, svg};
pub use tikz::tikz;
