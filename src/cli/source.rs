//! What a command reads: a file, or standard input.

use std::{
    fs::File,
    io::{self, IsTerminal, Read},
    path::Path,
};

use crate::text::{Lang, Message};

use super::{Progress, say};

/// Where lines come from, with a progress bar where their size is known.
pub(super) struct Source {
    reader: Box<dyn Read>,
    progress: Option<Progress>,
}

impl Source {
    pub(super) fn open(path: &Path, lang: Lang) -> io::Result<Self> {
        if path == Path::new("-") {
            if io::stdin().is_terminal() {
                say(lang, &Message::new("trace-from-terminal"));
            }
            return Ok(Self {
                reader: Box::new(io::stdin()),
                progress: None,
            });
        }
        let file = File::open(path)?;
        let metadata = file.metadata()?;
        // Answers on the same terminal show by themselves how far the work has come.
        let silent = metadata.is_file() && !io::stdout().is_terminal();
        Ok(Self {
            reader: Box::new(file),
            progress: silent.then(|| Progress::new(metadata.len())),
        })
    }
}

impl Read for Source {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let n = self.reader.read(buffer)?;
        if let Some(progress) = &mut self.progress {
            progress.advance(n as u64);
        }
        Ok(n)
    }
}
