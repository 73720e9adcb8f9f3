//! The lines of a reader, one at a time.

use std::io::{self, BufRead, BufReader, Read};

/// A longer line is refused: room for an outline of millions of vertices, and little enough to be held in memory.
pub const MAX_LINE_BYTES: usize = 64 << 20;

/// Read in pieces of this size: large enough that calls into the system cost nothing.
const CHUNK_BYTES: usize = 1 << 16;

const MARK: &[u8] = "\u{feff}".as_bytes();

/// One line, without its line break.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CaseLine<'a> {
    /// As it was read: not yet known to be text.
    Bytes(&'a [u8]),
    /// More than [`MAX_LINE_BYTES`], skipped.
    TooLong,
}

/// The lines of a reader that are not empty, with their numbers from 1.
pub struct CaseLines<R> {
    reader: BufReader<R>,
    buffer: Vec<u8>,
    number: usize,
}

impl<R: Read> CaseLines<R> {
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
    pub fn next_line(&mut self) -> io::Result<Option<(usize, CaseLine<'_>)>> {
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
                return Ok(Some((self.number, CaseLine::TooLong)));
            }
            // Some systems put a mark at the start of a text.
            let has_mark = self.number == 1 && self.buffer.starts_with(MARK);
            let from = if has_mark { MARK.len() } else { 0 };
            if !self.buffer[from..].iter().all(u8::is_ascii_whitespace) {
                let bytes = &self.buffer[from..content];
                return Ok(Some((self.number, CaseLine::Bytes(bytes))));
            }
        }
    }

    /// Is a whole line there already, so that reading on waits for nobody?
    pub(super) fn is_ready(&self) -> bool {
        self.reader.buffer().contains(&b'\n')
    }
}
