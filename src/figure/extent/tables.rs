//! The room of a table, from how long what stands in it is.

use crate::{
    figure::Table,
    text::{Catalog, Lang, Value},
};

/// What a column of names has room for, in ems.
const WORD: f32 = 5.0;
/// A letter, in ems: in English, whose words other languages' are as long as, give or take a few.
const LETTER: f32 = 0.52;
/// All text of a window has 12 points: an em of these is as large as that.
const SIZE: f32 = 12.0 / 13.0;
const DIGIT: f32 = 0.6;
const SHORT: f32 = 5.0 * DIGIT;
/// With room for a stacked fraction.
const ROW: f32 = 2.8;
const MOST_ROWS: usize = 5;

/// How many letters the values of a table have, one after the other: from step to step most of them stay.
#[derive(Default)]
pub struct Letters(Vec<Option<(Value, usize)>>);

/// More letters do not stand on one line of 20 ems.
const LINE: usize = 40;

impl Letters {
    /// Does a title take more than one line beside a drawing?
    pub fn wraps(&mut self, nth: usize, title: &Value) -> bool {
        self.of(nth, title) > LINE
    }

    /// Of the value that is the `nth`.
    fn of(&mut self, nth: usize, value: &Value) -> usize {
        if self.0.len() <= nth {
            self.0.resize(nth + 1, None);
        }
        match &self.0[nth] {
            Some((known, letters)) if known == value => *letters,
            _ => {
                let said = Catalog::of(Lang::En).value(value);
                let letters = said.chars().count();
                // One number stands over the other.
                let unset = if is_word(value) {
                    0
                } else {
                    2 * said.matches('/').count()
                };
                let letters = letters - unset;
                self.0[nth] = Some((value.clone(), letters));
                letters
            }
        }
    }
}

const fn is_word(value: &Value) -> bool {
    matches!(value, Value::Term(_) | Value::Message(_))
}

pub struct TableRoom {
    pub least: [f32; 2],
    pub natural: [f32; 2],
    /// All columns, and rows before notes.
    pub whole: [f32; 2],
}

impl TableRoom {
    pub fn of(table: &Table, letters: &mut Letters) -> Self {
        let n_columns = table.header.len();
        let gaps = n_columns.saturating_sub(1) as f32;
        let (n_rows, notes) = (table.rows.len(), table.notes.len() as f32);
        let (mut words, mut whole) = (0.0, 0.0);
        for idx in 0..n_columns {
            let [said, numbers] = longest(table, idx, letters);
            words += (said - WORD).max(0.0);
            let least = if idx == 0 { 0.0 } else { SHORT };
            whole += said.max(numbers).max(least);
        }
        let rows = n_rows as f32;
        Self {
            // Rows are folded where there is no room for all.
            least: [
                4.5 + 2.8 * gaps + 0.6 * words,
                3.0 + 1.8 * rows.min(4.0) + 1.5 * notes,
            ],
            natural: [6.5 + 3.5 * gaps + words, 3.0 + 3.2 * rows + 2.0 * notes],
            whole: [
                SIZE * (whole + gaps + 1.7),
                SIZE * ROW * (n_rows.min(MOST_ROWS) + 1) as f32,
            ],
        }
    }
}

/// The longest words of a column, and its longest number, in ems.
fn longest(table: &Table, idx: usize, letters: &mut Letters) -> [f32; 2] {
    let mut longest = [0.0_f32; 2];
    for (nth, row) in table.rows.iter().enumerate() {
        let value = match idx {
            0 => Some(&row.name),
            _ => row.cells.get(idx - 1).and_then(|cell| cell.value.as_ref()),
        };
        if let Some(value) = value {
            let letters = letters.of(idx * table.rows.len() + nth, value) as f32;
            let [words, numbers] = &mut longest;
            let (longest, letter) = if is_word(value) {
                (words, LETTER)
            } else {
                (numbers, DIGIT)
            };
            *longest = longest.max(letter * letters);
        }
    }
    longest
}
