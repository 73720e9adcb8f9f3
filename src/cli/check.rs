//! `clipscope check`: are lessons and scene files in order?

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
  clipscope check my-course                every lesson of a folder
  clipscope check scene.toml               a scene file";

/// What it accepts.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lesson folders, folders of lessons, scene files, or lessons of the embedded course by name
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
    let counts = [
        ("cli-checked", chosen.lessons.len()),
        ("cli-checked-scenes", chosen.scenes.len()),
    ];
    let mut sum = String::new();
    for (key, count) in counts.into_iter().filter(|(_, count)| *count > 0) {
        sum += &Catalog::of(args.lang).message(&Message::new(key).with("count", count));
        sum += "\n";
    }
    if sum.is_empty() {
        return outcome;
    }
    match print(&sum, args.lang) {
        Outcome::Done => outcome,
        failed => failed,
    }
}
