//! What every command says, and how it ends.

use std::{
    io::{self, Write},
    process::ExitCode,
};

use crate::text::{Catalog, Diagnostic, Lang, Message};

/// How a command ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outcome {
    /// All of it.
    Done,
    /// Some of the input was refused; each refusal has been named.
    Refused,
    /// Wrong usage, or nothing could be read.
    Unusable,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(match outcome {
            Outcome::Done => 0,
            Outcome::Refused => 1,
            Outcome::Unusable => 2,
        })
    }
}

/// Says a sentence on standard error, where there is one.
pub fn say(lang: Lang, message: &Message) {
    say_text(&Catalog::of(lang).message(message));
}

/// Says a text on standard error, where there is one.
pub(super) fn say_text(text: &str) {
    let _ = writeln!(io::stderr(), "{text}");
}

/// Writes a result to standard output. A reader that has gone is no mistake.
pub(super) fn print(text: &str, lang: Lang) -> Outcome {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Ok(()) => Outcome::Done,
        Err(error) => not_written(error, lang),
    }
}

/// Where standard output failed: quietly where its reader has gone.
pub(super) fn not_written(error: io::Error, lang: Lang) -> Outcome {
    if error.kind() == io::ErrorKind::BrokenPipe {
        return Outcome::Done;
    }
    let message = Message::new("trace-not-written").with("reason", Diagnostic::from(error));
    say(lang, &message);
    Outcome::Unusable
}
