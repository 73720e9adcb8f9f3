//! `clipscope pack`: lessons in one file, for a page.

use std::path::PathBuf;

use crate::{
    export::write_whole,
    lesson::{Folder, PACKED_FILE, packed},
    text::{Catalog, Diagnostic, Lang, Message},
};

use super::{
    Outcome, lang_parser,
    lessons::is_error,
    say::{say, say_text},
};

const EXAMPLES: &str = "\
Examples:
  clipscope pack --web my-course    writes my-course/course.json, for PAGE?course=my-course/";

#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// A lesson folder, or a folder of lessons
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// For a page: one file with all that the lessons need
    #[arg(long, required = true)]
    web: bool,
    /// The file to write; course.json in the folder where none is given
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Language of messages
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    lang: Lang,
}

pub(super) fn pack(args: &Args) -> Outcome {
    let (text, loaded) = packed(&Folder::new(&args.folder));
    for problem in loaded.problems.iter().filter(|problem| is_error(problem)) {
        say_text(&problem.render(Catalog::of(args.lang)));
    }
    if loaded.problems.iter().any(is_error) {
        return Outcome::Unusable;
    }
    let out = args.out.clone();
    let out = out.unwrap_or_else(|| args.folder.join(PACKED_FILE));
    let path = out.display().to_string();
    match write_whole(&out, text.as_bytes()) {
        Ok(()) => {
            say(args.lang, &Message::new("status-saved").with("path", path));
            Outcome::Done
        }
        Err(error) => {
            let at = Message::new("error-at").with("place", path);
            say(args.lang, &at.with("problem", Diagnostic::from(error)));
            Outcome::Unusable
        }
    }
}
