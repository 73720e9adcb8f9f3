//! The text of a lesson step: paragraphs, and questions whose answers are shown when asked for.

use egui::{Align, FontFamily, RichText, TextFormat, TextStyle, Ui, text::LayoutJob};

use crate::paint::theme;

use super::Look;

/// A run of text in one face.
pub type Span = (String, Face);

/// A face of the text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Face {
    /// The text face.
    #[default]
    Plain,
    /// Semibold.
    Strong,
    /// Monospaced.
    Code,
}

/// A part of a step's text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Block {
    /// Words.
    Paragraph(Vec<Span>),
    /// Items of a list.
    List(Vec<Vec<Span>>),
    /// Hidden until asked for.
    Answer(Vec<Block>),
}
