//! `clipscope handout`: lessons on paper.

use std::path::PathBuf;

use crate::{
    export::{Failure, Handout, Paper, Studio, write_whole},
    lesson::Course,
    paint::ThemeKind,
    text::{Lang, Message},
};

use super::{
    Outcome, Progress, lang_parser,
    lessons::{Chosen, choose, is_error},
    say,
    written::{Names, made, told},
};

const EXAMPLES: &str = "\
Examples:
  clipscope handout 05-intervals --out paper
  clipscope handout 05-intervals --out paper --answers
  clipscope handout --out apostilas --lang pt-BR --paper letter
  clipscope handout 03-outcodes --out paper --link=https://example.org/clipscope/

The same input gives the same bytes on every machine. A file is written whole or not at all.";

#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lessons of the embedded course by name, or lesson folders; all of the course where none is given
    #[arg(value_name = "LESSON")]
    pub lessons: Vec<PathBuf>,
    /// The folder to write to; it is made where it is not there
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// What it is printed on
    #[arg(long, value_enum, default_value_t = Paper::A4)]
    pub paper: Paper,
    /// Language of text, labels and captions
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    pub lang: Lang,
    /// With the answers, and the run worked out
    #[arg(long)]
    pub answers: bool,
    /// The address of a page that links are opened on
    #[arg(long, value_name = "ADDRESS")]
    pub link: Option<String>,
}

/// The file of each lesson. Scenes are none, and two that would be one file are refused.
fn files(chosen: &Chosen) -> Result<Vec<String>, Message> {
    if let Some((name, _)) = chosen.scenes.first() {
        return Err(Message::new("handout-of-scene").with("name", name.clone()));
    }
    let mut names = Names::default();
    let mut files = Vec::new();
    for (lesson, asked) in chosen.lessons.iter().zip(&chosen.asked) {
        let file = format!("{}.pdf", lesson.id);
        names.take(&file, asked)?;
        files.push(file);
    }
    Ok(files)
}

pub(super) fn handout(args: &Args) -> Outcome {
    let chosen = choose(&args.lessons, Course::load);
    let read = chosen.report(args.lang, is_error);
    if chosen.is_empty() {
        return read;
    }
    let files = files(&chosen).and_then(|files| made(&args.out).map(|()| files));
    let files = match files {
        Ok(files) => files,
        Err(message) => {
            say(args.lang, &message);
            return Outcome::Unusable;
        }
    };
    let handout = Handout {
        paper: args.paper,
        lang: args.lang,
        is_answered: args.answers,
        page: args.link.as_deref(),
    };
    let mut studio = Studio::new(ThemeKind::Projector);
    let mut progress = Progress::new(chosen.lessons.len() as u64);
    let mut failures = Vec::new();
    for (lesson, file) in chosen.lessons.iter().zip(files) {
        let path = args.out.join(file);
        if let Err(error) = write_whole(&path, &handout.pdf(&mut studio, lesson)) {
            let path = path.display().to_string();
            failures.push(Failure { path, error });
        }
        progress.advance(1);
    }
    drop(progress);
    let sum = ("cli-handouts", chosen.lessons.len());
    told(args.lang, &args.out, sum, failures, read)
}
