//! What stands on the pages of a file, and what each part is.

use egui::{Pos2, Rect, Vec2};

use crate::export::vector::page::VectorPage;

/// One page of paper.
pub struct PdfPage<'a> {
    /// In points.
    pub size: Vec2,
    /// In the order in which they are read.
    pub parts: Vec<PdfPart<'a>>,
}

/// A drawing on it.
pub struct PdfPart<'a> {
    pub tag: Tag,
    pub drawing: &'a VectorPage,
    pub at: Pos2,
    pub scale: f32,
    /// Where a press on it leads.
    pub link: Option<String>,
}

impl PdfPart<'_> {
    pub fn rect(&self) -> Rect {
        Rect::from_min_size(self.at, self.scale * self.drawing.size)
    }
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Tag {
    /// The title of the whole.
    Title,
    Heading,
    Paragraph,
    Code,
    /// With what it shows in words.
    Figure(String),
    /// What repeats on every page, or is empty: nothing to be read.
    Furniture,
}
