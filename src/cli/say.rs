//! What every command says, and how it ends.

use std::{
    io::{self, Write},
    path::Path,
    process::ExitCode,
    time::{Duration, Instant},
};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::text::{Catalog, Diagnostic, Lang, Message};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outcome {
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

/// A path that cannot be read, and why.
pub(super) fn unreadable(path: &Path, error: io::Error, lang: Lang) -> Outcome {
    let message = Message::new("cli-unreadable")
        .with("path", path.display().to_string())
        .with("reason", Diagnostic::from(error));
    say(lang, &message);
    Outcome::Unusable
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

/// Shorter work shows no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// How far a piece of work has come. Where standard error is no terminal, nothing is shown.
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    shown: bool,
}

impl Progress {
    pub fn new(total: u64) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {eta}") {
            bar.set_style(style);
        }
        Self {
            bar,
            started: Instant::now(),
            shown: false,
        }
    }

    pub fn advance(&mut self, n: u64) {
        self.bar.inc(n);
        if !self.shown && self.started.elapsed() > PATIENCE {
            self.shown = true;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
