//! The room of a table, from how long what stands in it is.

use crate::{
    figure::Table,
    text::{Catalog, Lang, Value},
};

/// What a column of names has room for, in ems.
const WORD: f32 = 5.0;
/// A letter, in ems: in English, whose words other languages' are as long as, give or take a few.
const LETTER: f32 = 0.52;

/// In ems, of what a column says in words.
fn words_width(table: &Table, idx: usize) -> f32 {
    let catalog = Catalog::of(Lang::En);
    let values = table.rows.iter().filter_map(|row| match idx {
        0 => Some(&row.name),
        _ => row.cells.get(idx - 1)?.value.as_ref(),
    });
    let words = values.filter(|value| matches!(value, Value::Term(_) | Value::Message(_)));
    let letters = words.map(|value| catalog.value(value).chars().count());
    LETTER * letters.max().unwrap_or(0) as f32
}

/// The least and the natural one.
pub fn table_need(table: &Table) -> [[f32; 2]; 2] {
    let columns = table.header.len().saturating_sub(1) as f32;
    let (rows, notes) = (table.rows.len() as f32, table.notes.len() as f32);
    let columns_of_words = (0..table.header.len()).map(|idx| words_width(table, idx));
    let words: f32 = columns_of_words.map(|it| (it - WORD).max(0.0)).sum();
    // Rows are folded where there is no room for all.
    let least = [
        4.5 + 2.8 * columns + 0.6 * words,
        3.0 + 1.8 * rows.min(4.0) + 1.5 * notes,
    ];
    let natural = [6.0 + 3.0 * columns + words, 3.0 + 3.2 * rows + 2.0 * notes];
    [least, natural]
}

/// All columns, and rows before notes, of text of 12 points: an em of these is as large as that.
pub fn whole_table(table: &Table) -> [f32; 2] {
    const SIZE: f32 = 12.0 / 13.0;
    const DIGIT: f32 = 0.6;
    const SHORT: f32 = 5.0 * DIGIT;
    const MOST_ROWS: usize = 5;
    let catalog = Catalog::of(Lang::En);
    let column = |idx: usize| {
        let values = table.rows.iter().filter_map(|row| match idx {
            0 => Some(&row.name),
            _ => row.cells.get(idx - 1)?.value.as_ref(),
        });
        let number = |value: &Value| {
            let said = catalog.value(value);
            // One number stands over the other.
            let letters = said.chars().count() - 2 * said.matches('/').count();
            DIGIT * letters as f32
        };
        let is_number = |value: &&Value| !matches!(value, Value::Term(_) | Value::Message(_));
        let numbers = values.filter(is_number).map(number).fold(0.0, f32::max);
        let least = if idx == 0 { 0.0 } else { SHORT };
        words_width(table, idx).max(numbers).max(least)
    };
    let columns: f32 = (0..table.header.len()).map(column).sum();
    let gaps = table.header.len().saturating_sub(1) as f32;
    let rows = (table.rows.len().min(MOST_ROWS) + 1) as f32;
    [SIZE * (columns + gaps + 1.7), SIZE * 2.5 * rows]
}
