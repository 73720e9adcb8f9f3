//! What is to be set, with its face and colour.

use egui::{Color32, FontId};

use crate::text::{Catalog, Formula, Message, Piece, Value};

/// Pieces in one face and colour.
#[derive(Clone, Debug)]
pub struct Span {
    /// What is set.
    pub pieces: Vec<Piece>,
    /// Its face, and the size of what is neither lowered nor stacked.
    pub font: FontId,
    /// Its colour, also of the lines of its quotients.
    pub colour: Color32,
    /// Slanted.
    pub italics: bool,
}

impl Span {
    /// Slanted or upright.
    pub const fn slanted(mut self, italics: bool) -> Self {
        self.italics = italics;
        self
    }

    /// Pieces as they stand.
    pub const fn upright(pieces: Vec<Piece>, font: FontId, colour: Color32) -> Self {
        Self {
            pieces,
            font,
            colour,
            italics: false,
        }
    }

    /// A value as it stands alone.
    pub fn value(catalog: &Catalog, value: &Value, font: FontId, colour: Color32) -> Self {
        let pieces = catalog.value_pieces(value);
        Self::upright(pieces, font, colour)
    }

    /// A formula.
    pub fn formula(catalog: &Catalog, formula: &Formula, font: FontId, colour: Color32) -> Self {
        let pieces = catalog.formula_pieces(formula);
        Self::upright(pieces, font, colour)
    }

    /// A sentence.
    pub fn message(catalog: &Catalog, message: &Message, font: FontId, colour: Color32) -> Self {
        let pieces = catalog.message_pieces(message);
        Self::upright(pieces, font, colour)
    }

    /// Words.
    pub fn text(text: &str, font: FontId, colour: Color32) -> Self {
        let pieces = Piece::words(text);
        Self::upright(pieces, font, colour)
    }
}
