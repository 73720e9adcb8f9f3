//! `clipscope check`: are lesson files in order?

use std::path::PathBuf;

use crate::{
    lesson::Course,
    text::{Catalog, Lang, Message},
};

use super::{Outcome, lang_parser, lessons::choose, say::print};

const EXAMPLES: &str = "\
Examples:
  clipscope check                          the embedded course
  clipscope check my-course/01-outcodes    one lesson
  clipscope check my-course                every lesson of a folder";

/// What it accepts.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lesson folders, folders of lessons, or lessons of the embedded course by name
    #[arg(value_name = "LESSON")]
    lessons: Vec<PathBuf>,
    /// Language of messages
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    lang: Lang,
}

/// Checks the lessons: names every mistake on standard error, and says how many lessons have none.
pub(super) fn check(args: &Args) -> Outcome {
    let chosen = choose(&args.lessons, Course::check);
    let outcome = chosen.report(args.lang);
    if chosen.lessons.is_empty() {
        return outcome;
    }
    let sum = Message::new("cli-checked").with("count", chosen.lessons.len());
    let sum = Catalog::of(args.lang).message(&sum) + "\n";
    match print(&sum, args.lang) {
        Outcome::Done => outcome,
        failed => failed,
    }
}
