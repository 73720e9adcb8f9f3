//! What is selected in a field of text: what is typed first replaces it.

use std::ops::Range;

use egui::{
    text::{CCursor, CCursorRange},
    text_edit::TextEditState,
};

use egui::{Context, Id};

/// Selects these characters.
pub fn select(ctx: &Context, field: Id, characters: Range<usize>) {
    let mut state = TextEditState::load(ctx, field).unwrap_or_default();
    let [start, end] = [characters.start, characters.end].map(CCursor::new);
    let range = CCursorRange::two(start, end);
    state.cursor.set_char_range(Some(range));
    state.store(ctx, field);
}
