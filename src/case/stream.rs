//! Cases from a reader, answers to a writer, in order and in constant memory.

use std::{
    fmt,
    io::{self, BufRead, BufReader, Read, Write},
};

use crate::text::{Catalog, Lang};

use super::{Case, Refused, read, report};

/// A longer line is refused: far more than any case needs, and little enough to be held in memory.
pub const MAX_LINE_BYTES: usize = 16 << 20;

/// Read and written in pieces of this size: large enough that calls into the system cost nothing.
const CHUNK_BYTES: usize = 1 << 16;

/// One line, without its line break.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Line<'a> {
    /// As it was read: not yet known to be text.
    Bytes(&'a [u8]),
    /// More than [`MAX_LINE_BYTES`], skipped.
    TooLong,
}

/// The lines of a reader that are not empty, with their numbers from 1.
pub struct Lines<R> {
    reader: BufReader<R>,
    buffer: Vec<u8>,
    number: usize,
}

impl<R: Read> Lines<R> {
    /// From where the reader stands.
    pub fn new(reader: R) -> Self {
        Self {
            reader: BufReader::with_capacity(CHUNK_BYTES, reader),
            buffer: Vec::new(),
            number: 0,
        }
    }

    /// The next line that holds more than spaces; `None` at the end.
    ///
    /// # Errors
    /// Where the reader fails.
    pub fn next_line(&mut self) -> io::Result<Option<(usize, Line<'_>)>> {
        loop {
            self.buffer.clear();
            // One more for the line break, one more to see that it is too long.
            let mut limited = self.reader.by_ref().take(MAX_LINE_BYTES as u64 + 2);
            if limited.read_until(b'\n', &mut self.buffer)? == 0 {
                return Ok(None);
            }
            self.number += 1;
            let ended = self.buffer.last() == Some(&b'\n');
            let content = self.buffer.len() - usize::from(ended);
            if content > MAX_LINE_BYTES {
                if !ended {
                    self.reader.skip_until(b'\n')?;
                }
                return Ok(Some((self.number, Line::TooLong)));
            }
            let from = match self.number {
                1 => byte_order_mark(&self.buffer),
                _ => 0,
            };
            if !self.buffer[from..].iter().all(u8::is_ascii_whitespace) {
                return Ok(Some((
                    self.number,
                    Line::Bytes(&self.buffer[from..content]),
                )));
            }
        }
    }

    /// Is a whole line there already, so that reading on waits for nobody?
    fn is_ready(&self) -> bool {
        self.reader.buffer().contains(&b'\n')
    }
}

/// Some systems put a mark at the start of a text: its length.
fn byte_order_mark(line: &[u8]) -> usize {
    const MARK: &[u8] = "\u{feff}".as_bytes();
    if line.starts_with(MARK) {
        MARK.len()
    } else {
        0
    }
}

/// What is written for each case.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// One answer a line.
    Json,
    /// Tables for a terminal.
    Text,
    /// An answer key to hand out.
    Markdown,
}

/// How much of each case is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Detail {
    /// Every step.
    Steps,
    /// The answer and its cost.
    Answers,
}

/// How answers are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Style {
    /// For whom.
    pub format: Format,
    /// How much.
    pub detail: Detail,
    /// In which language; JSON is the same in all of them.
    pub lang: Lang,
}

/// How many cases there were.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Tally {
    /// Answered.
    pub answered: usize,
    /// Refused.
    pub refused: usize,
}

/// Why a stream of cases broke off.
#[derive(Debug)]
pub enum TraceError {
    /// The cases could not be read.
    Read(io::Error),
    /// The answers could not be written.
    Write(io::Error),
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read(error) => write!(f, "reading cases: {error}"),
            Self::Write(error) => write!(f, "writing answers: {error}"),
        }
    }
}

impl std::error::Error for TraceError {}

/// A case that was refused, for those who keep count.
#[derive(Clone, Copy, Debug)]
pub struct Refusing<'a> {
    /// The line that it stands in, from 1; empty lines count.
    pub line: usize,
    /// How many cases came before it, and one.
    pub number: usize,
    /// Which, and why.
    pub refused: &'a Refused,
}

impl Refusing<'_> {
    /// Where it stands, which it is, and why it is refused, for people.
    #[must_use]
    pub fn sentence(&self, catalog: &Catalog) -> String {
        report::refusing(self, catalog)
    }
}

/// Answers every case, in order. `on_refusal` hears of each refusal.
///
/// Answers are written in large pieces, and whenever the next case has not come yet: who sends one case and
/// waits for its answer gets it.
///
/// # Errors
/// [`TraceError`] where reading or writing fails; what was answered by then is written.
pub fn trace(
    cases: impl Read,
    mut answers: impl Write,
    style: Style,
    mut on_refusal: impl FnMut(Refusing<'_>),
) -> Result<Tally, TraceError> {
    let mut lines = Lines::new(cases);
    let mut tally = Tally::default();
    let mut out = Vec::with_capacity(2 * CHUNK_BYTES);
    let mut hand_over = |out: &mut Vec<u8>| {
        let written = answers.write_all(out).and_then(|()| answers.flush());
        out.clear();
        written.map_err(TraceError::Write)
    };
    loop {
        if out.len() >= CHUNK_BYTES || !(out.is_empty() || lines.is_ready()) {
            hand_over(&mut out)?;
        }
        let Some((line, text)) = lines.next_line().map_err(TraceError::Read)? else {
            return hand_over(&mut out).map(|()| tally);
        };
        let case = read(text);
        let number = tally.answered + tally.refused + 1;
        write_answer(number, &case, style, &mut out).map_err(TraceError::Write)?;
        match &case {
            Ok(_) => tally.answered += 1,
            Err(refused) => {
                tally.refused += 1;
                on_refusal(Refusing {
                    line,
                    number,
                    refused,
                });
            }
        }
    }
}

fn write_answer(
    number: usize,
    case: &Result<Case, Refused>,
    style: Style,
    out: &mut Vec<u8>,
) -> io::Result<()> {
    let Style {
        format,
        detail,
        lang,
    } = style;
    let report = match format {
        Format::Json => {
            match case {
                Ok(case) => case.write_json(detail, out)?,
                Err(refused) => refused.write_json(out)?,
            }
            out.push(b'\n');
            return Ok(());
        }
        Format::Text => report::text(number, case, detail, Catalog::of(lang)),
        Format::Markdown => report::markdown(number, case, detail, Catalog::of(lang)),
    };
    out.extend_from_slice(report.as_bytes());
    Ok(())
}
