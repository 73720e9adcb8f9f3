//! `clipscope check`: are lesson files in order?

use std::path::PathBuf;

use super::{Outcome, say::say_text};

const EXAMPLES: &str = "\
Examples:
  clipscope check
  clipscope check my-course/01-outcodes";

/// What it accepts.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lessons of the embedded course by name, or lesson folders; all of the course where none is given
    #[arg(value_name = "LESSON")]
    lessons: Vec<PathBuf>,
}

/// Checks the lessons.
pub(super) fn check(_args: &Args) -> Outcome {
    say_text("not built yet");
    Outcome::Unusable
}
