//! Files that a command writes: the folder that they go to, and what is said of them.

use std::{collections::BTreeMap, fs, io, path::Path};

use crate::{
    export::Failure,
    text::{Diagnostic, Lang, Message},
};

use super::{Outcome, say};

/// The folder, where it was not there.
pub(super) fn made(out: &Path) -> Result<(), Message> {
    fs::create_dir_all(out).map_err(|error| {
        // What is there already is something else.
        let error = match error.kind() {
            io::ErrorKind::AlreadyExists => io::ErrorKind::NotADirectory.into(),
            _ => error,
        };
        failed(out.display().to_string(), error)
    })
}

/// Files that are about to be written, each with the name that it was asked for by.
#[derive(Default)]
pub(super) struct Names<'a>(BTreeMap<String, &'a str>);

impl<'a> Names<'a> {
    /// Two that would be one file are refused: many systems take capitals and small letters for one.
    pub fn take(&mut self, path: &str, asked: &'a str) -> Result<(), Message> {
        let Some(first) = self.0.insert(path.to_lowercase(), asked) else {
            return Ok(());
        };
        let message = Message::new("export-same-name").with("path", path.to_owned());
        let message = message.with("first", first.to_owned());
        Err(message.with("second", asked.to_owned()))
    }
}

/// Says why files were not written, and how many were.
pub(super) fn told(
    lang: Lang,
    out: &Path,
    (key, n_files): (&'static str, usize),
    failures: Vec<Failure>,
    read: Outcome,
) -> Outcome {
    let is_whole = failures.is_empty();
    let n_written = n_files - failures.len();
    for Failure { path, error } in failures {
        say(lang, &failed(path, error));
    }
    let sum = Message::new(key)
        .with("count", n_written)
        .with("path", out.display().to_string());
    say(lang, &sum);
    match (is_whole, n_written) {
        (true, _) => read,
        (false, 0) => Outcome::Unusable,
        (false, _) => Outcome::Refused,
    }
}

fn failed(path: String, error: io::Error) -> Message {
    let reason = Message::new("error-at").with("place", path);
    let reason = reason.with("problem", Diagnostic::from(error));
    Message::new("status-export-failed").with("reason", reason)
}
