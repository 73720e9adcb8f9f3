//! `clipscope` and `clipscope open`: the app.

use std::{path::PathBuf, process::ExitCode};

use super::{Outcome, say::say_text};

/// Opens the app on a path, or on the embedded course.
pub(super) fn open_app(_path: Option<PathBuf>) -> ExitCode {
    say_text("not built yet");
    Outcome::Unusable.into()
}
