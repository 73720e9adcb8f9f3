//! Takes the references out of a text, so that Markdown does not read them.

use std::ops::Range;

/// Stands where a reference stood, until it is filled in. From the private use area: no text has it.
pub const SLOT: char = '\u{e000}';
/// The rest of the bytes of a reference, so that places in the text stay where they are.
const FILLER: char = '\u{1}';

/// A text without its references, and where they were.
pub struct Braces {
    pub text: String,
    pub spans: Vec<Range<usize>>,
    /// The first brace that holds nothing, or is not closed in its line.
    pub unclosed: Option<usize>,
}

impl Braces {
    /// Takes the references out of a text, but for blocks of code. Each leaves as many bytes as it had.
    pub fn of(source: &str) -> Self {
        let mut text = source.replace(SLOT, "\u{fffd}");
        let (mut spans, mut unclosed) = (Vec::new(), None);
        let mut is_code = false;
        let mut start = 0;
        for line in source.split_inclusive('\n') {
            is_code ^= line.trim_start().starts_with("```");
            let mut from = 0;
            while !is_code && let Some(open) = line[from..].find('{').map(|at| from + at) {
                let Some(close) = line[open..].find('}').map(|at| open + at + 1) else {
                    unclosed.get_or_insert(start + open);
                    break;
                };
                // A slot has three bytes, as the shortest reference has.
                if close - open < SLOT.len_utf8() {
                    unclosed.get_or_insert(start + open);
                } else {
                    spans.push(start + open..start + close);
                }
                from = close;
            }
            start += line.len();
        }
        for span in &spans {
            let filler = FILLER.to_string().repeat(span.len() - SLOT.len_utf8());
            text.replace_range(span.clone(), &format!("{SLOT}{filler}"));
        }
        Self {
            text,
            spans,
            unclosed,
        }
    }

    pub fn without_filler(text: &str) -> String {
        text.replace(FILLER, "")
    }
}
