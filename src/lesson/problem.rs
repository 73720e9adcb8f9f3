//! What is wrong with a lesson file, and where: as a compiler would say it.

use std::fmt::Write as _;

use crate::text::{Catalog, Diagnostic, printable};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Severity {
    /// The lesson is left out.
    Error,
    /// The lesson is shown all the same.
    Warning,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Place {
    /// From 1.
    pub line: usize,
    /// From 1, counted in characters.
    pub column: usize,
    /// The line itself; of a very long line, what surrounds the place.
    pub source_line: String,
    /// Index in `source_line`, in characters, of the first one that is meant.
    pub caret: usize,
    /// How many characters are meant, at least 1; the last may stand past the end of the line.
    pub length: usize,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Problem {
    /// As the person who runs the program knows it.
    pub file: String,
    /// `None` where it is about the file as a whole.
    pub place: Option<Place>,
    pub severity: Severity,
    pub what: Diagnostic,
}

impl Problem {
    pub const fn code(&self) -> &'static str {
        self.what.code
    }

    /// As a compiler prints it, without a line break at the end:
    ///
    /// ```text
    /// lessons/03-x/lesson.toml:5:10: error: The window is empty: xmin = 1 must be less than xmax = −1.
    ///   5 | window = [1, -1, -1, 1]
    ///     |           ^
    ///     = Expected: [xmin, ymin, xmax, ymax], with xmin < xmax and ymin < ymax.
    /// ```
    pub fn render(&self, catalog: &Catalog) -> String {
        let mut text = self.file.clone();
        if let Some(place) = &self.place {
            let _ = write!(text, ":{}:{}", place.line, place.column);
        }
        let severity = catalog.term(match self.severity {
            Severity::Error => "lesson-error",
            Severity::Warning => "lesson-warning",
        });
        let _ = write!(
            text,
            ": {severity}: {}",
            catalog.message(&self.what.message)
        );
        let mut margin = 2;
        if let Some(place) = &self.place {
            let number = place.line.to_string();
            margin += number.len();
            let (line, marks) = place.underlined();
            let _ = write!(text, "\n  {number} | {line}\n{:margin$} | {marks}", "");
        }
        for note in &self.what.notes {
            let _ = write!(text, "\n{:margin$} = {}", "", catalog.message(note));
        }
        printable(&text)
    }
}

impl Place {
    /// The line as a terminal shows it, and the carets under the place.
    fn underlined(&self) -> (String, String) {
        let (mut line, mut marks) = (String::new(), String::new());
        let mut column = 0;
        for (i, c) in self.source_line.chars().enumerate() {
            let width = if c == '\t' {
                TAB - column % TAB
            } else {
                width(c)
            };
            match c {
                '\t' => line.extend(std::iter::repeat_n(' ', width)),
                c => line.push(c),
            }
            if i < self.caret {
                marks.extend(std::iter::repeat_n(' ', width));
            } else if i < self.caret + self.length {
                marks.extend(std::iter::repeat_n('^', width));
            }
            column += width;
        }
        if !marks.ends_with('^') {
            marks.push('^');
        }
        (line, marks)
    }
}

/// Columns between tab stops.
const TAB: usize = 4;

/// Columns that a character takes on a terminal: two for what Unicode's UAX 11 calls wide.
fn width(c: char) -> usize {
    match u32::from(c) {
        0x0300..=0x036f | 0x200b..=0x200f | 0x20d0..=0x20ff | 0xfe00..=0xfe0f => 0,
        0x1100..=0x115f
        | 0x2e80..=0x303e
        | 0x3041..=0xa4cf
        | 0xac00..=0xd7a3
        | 0xf900..=0xfaff
        | 0xfe30..=0xfe6f
        | 0xff01..=0xff60
        | 0xffe0..=0xffe6
        | 0x1f300..=0x1f64f
        | 0x1f900..=0x1f9ff
        | 0x20000..=0x3fffd => 2,
        _ => 1,
    }
}

/// Is this a character of a script that is written without spaces between words?
pub(super) fn is_wide(c: char) -> bool {
    width(c) == 2
}
