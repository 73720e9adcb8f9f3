//! `clipscope pack`: lessons in one file, for a page or for a learning platform.

mod scorm;

use std::path::{Path, PathBuf};

use crate::{
    export::write_whole,
    lesson::{Course, Folder, PACKED_FILE, packed},
    text::{Catalog, Diagnostic, Lang, Message},
};

use super::{
    Outcome, lang_parser,
    lessons::{choose, is_error},
    say::{say, say_text},
};

const EXAMPLES: &str = "\
Examples:
  clipscope pack --web my-course                   writes my-course/course.json, for PAGE?course=my-course/
  clipscope pack --scorm 05-intervals --lang es    writes 05-intervals.zip, for Moodle and others";

#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// With --web a folder of lessons, or one lesson's; with --scorm lessons of the embedded course by name
    #[arg(value_name = "LESSON", required = true)]
    lessons: Vec<PathBuf>,
    /// For a page: one file with all that the lessons of a folder need
    #[arg(long, required_unless_present = "scorm", conflicts_with = "scorm")]
    web: bool,
    /// For a learning platform: a SCORM 1.2 package
    #[arg(long)]
    scorm: bool,
    /// Where web/build.sh has put the page
    #[arg(long, value_name = "DIR", default_value = "web/dist")]
    page: PathBuf,
    /// The file to write; course.json in the folder, or a zip by the first lesson's name, where none is given
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Language of messages, and of the package
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    lang: Lang,
}

pub(super) fn pack(args: &Args) -> Outcome {
    if args.web {
        return pack_web(args);
    }
    let chosen = choose(&args.lessons, Course::load);
    let read = chosen.report(args.lang, is_error);
    let Some(first) = chosen.lessons.first() else {
        return read;
    };
    if !matches!(read, Outcome::Done) {
        return Outcome::Unusable;
    }
    if let Some(kept) = scorm::too_much(&chosen.lessons) {
        let message = Message::new("pack-too-many").with("count", kept);
        say(args.lang, &message.with("most", scorm::MOST_STATE));
        return Outcome::Unusable;
    }
    let out = args.out.clone();
    let out = out.unwrap_or_else(|| format!("{}.zip", first.id).into());
    match scorm::package(&args.page, &chosen.lessons, args.lang) {
        Ok(bytes) => write(args, &out, &bytes),
        Err(error) => {
            say(args.lang, &at(&args.page, error));
            Outcome::Unusable
        }
    }
}

/// One folder after the other would be one course over the other.
fn pack_web(args: &Args) -> Outcome {
    let [folder] = &args.lessons[..] else {
        say(args.lang, &Message::new("pack-one-folder"));
        return Outcome::Unusable;
    };
    let (text, loaded) = packed(&Folder::new(folder));
    for problem in loaded.problems.iter().filter(|problem| is_error(problem)) {
        say_text(&problem.render(Catalog::of(args.lang)));
    }
    if loaded.problems.iter().any(is_error) {
        return Outcome::Unusable;
    }
    let out = args.out.clone();
    write(
        args,
        &out.unwrap_or_else(|| folder.join(PACKED_FILE)),
        text.as_bytes(),
    )
}

fn write(args: &Args, out: &Path, bytes: &[u8]) -> Outcome {
    match write_whole(out, bytes) {
        Ok(()) => {
            let path = out.display().to_string();
            say(args.lang, &Message::new("status-saved").with("path", path));
            Outcome::Done
        }
        Err(error) => {
            say(args.lang, &at(out, error));
            Outcome::Unusable
        }
    }
}

fn at(path: &Path, problem: impl Into<Diagnostic>) -> Message {
    let message = Message::new("error-at").with("place", path.display().to_string());
    message.with("problem", problem.into())
}
