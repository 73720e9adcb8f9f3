//! The command line: what it accepts, and where it goes from there.
//!
//! Results go to standard output, messages to standard error. Exit status: 0 done, 1 some of the input was
//! refused (each refusal named), 2 wrong usage or nothing could be read.

mod export;
mod grade;
mod handout;
mod lessons;
mod list;
mod pack;
mod progress;
mod say;
mod slides;
mod source;
mod trace;
mod usage;
mod written;

use std::{
    env,
    path::{Path, PathBuf},
    process::ExitCode,
};

use clap::{
    Parser, Subcommand,
    builder::{PossibleValuesParser, TypedValueParser},
};

use crate::{
    app::{Opening, Settings, is_mesh, run_native},
    lesson::{
        Course, Folder, Link, MAX_SCENE_BYTES, Problem, SceneFormats, ask, is_picture, link_in,
        read_file, said,
    },
    text::{Catalog, Diagnostic, Lang, Message},
};

use say::{Outcome, Progress, say, say_text};

#[derive(Parser)]
#[command(
    name = "clipscope",
    version,
    about = "Shows, step by step, how graphics programs decide what is visible",
    long_about = "Shows, step by step and with the real numbers, how graphics programs decide what is \
                  visible.\n\nWithout a command it opens the app with the embedded course.",
    after_help = EXAMPLES,
    args_conflicts_with_subcommands = true
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

const EXAMPLES: &str = "\
Examples:
  clipscope                                open the app
  clipscope trace cases.ndjson             every step of every case
  clipscope export --out figures           every figure of the course
  clipscope handout 05-intervals --out .   a lesson on paper

Exit status: 0 done, 1 some of the input was refused, 2 wrong usage or nothing could be read.";

#[derive(Subcommand)]
enum Command {
    /// Open a lesson folder, a scene file, a mesh, a figure or a link in the app
    #[command(
        after_help = "Examples:\n  clipscope open my-course/01-outcodes\n  clipscope open cow.obj\n  \
                      clipscope open figure.png\n  clipscope open '#05-intervals/entering'"
    )]
    Open {
        /// A lesson folder, a folder of lessons, a scene file, a mesh, an exported figure or a link
        path: PathBuf,
    },
    /// Draw figures to files: needs no display and no GPU
    Export(export::Args),
    /// Print lessons on paper: text, figures, questions and a run to work out, as PDF files
    Handout(handout::Args),
    /// Run algorithms on cases, one JSON object a line, and print every step
    Trace(trace::Args),
    /// Compare a program's answers with the true ones
    Grade(grade::Args),
    /// Validate lesson files: every mistake with file, line and column
    Check(lessons::Args),
    /// List lessons with their steps and figures, and the algorithms that `trace` knows
    List(list::Args),
    /// Put the lessons of a folder into one file, for a page
    Pack(pack::Args),
    /// Make one table of the progress that a class has handed in
    Progress(progress::Args),
}

pub fn run() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            let args = env::args_os().map(|arg| arg.to_string_lossy().into_owned());
            return usage::explain(&error, &args.collect::<Vec<_>>()).into();
        }
    };
    match cli.command {
        None => open_app(None),
        Some(Command::Open { path }) => open_app(Some(path)),
        Some(Command::Export(args)) => export::export(&args).into(),
        Some(Command::Handout(args)) => handout::handout(&args).into(),
        Some(Command::Trace(args)) => trace::trace(&args).into(),
        Some(Command::Grade(args)) => grade::grade(&args),
        Some(Command::Check(args)) => lessons::check(&args).into(),
        Some(Command::List(args)) => list::list(&args).into(),
        Some(Command::Pack(args)) => pack::pack(&args).into(),
        Some(Command::Progress(args)) => progress::progress(&args).into(),
    }
}

fn lang_parser() -> impl TypedValueParser<Value = Lang> {
    PossibleValuesParser::new(Lang::ALL.map(Lang::id))
        .map(|id| Lang::from_id(&id).unwrap_or_default())
}

/// Opens the app on a path, or on the embedded course. What goes wrong is said in the system's language.
fn open_app(path: Option<PathBuf>) -> ExitCode {
    let catalog = Catalog::of(Settings::of_system().lang);
    let opened = path.map_or_else(|| Ok(Opening::default()), |path| opening(&path, catalog));
    let ran =
        opened.and_then(|opening| run_native(opening).map_err(|message| catalog.message(&message)));
    match ran {
        Ok(()) => Outcome::Done.into(),
        Err(reason) => {
            say_text(&reason);
            Outcome::Unusable.into()
        }
    }
}

/// A folder is a course or a lesson; a file is a scene, or a mesh, which is read when the window is there.
fn opening(path: &Path, catalog: &Catalog) -> Result<Opening, String> {
    if path.is_dir() {
        return Ok(Opening {
            folder: Some(Folder::new(path)),
            ..Opening::default()
        });
    }
    let name = path.display().to_string();
    if !path.exists() && Link::is_one(&name) {
        return linked(name, catalog);
    }
    let unread = |reason: Diagnostic| {
        let message = Message::new("status-open-failed").with("path", name.clone());
        catalog.message(&message.with("reason", reason))
    };
    if is_mesh(path) {
        ask(path, MAX_SCENE_BYTES).map_err(|error| unread(error.into()))?;
        return Ok(Opening {
            mesh: Some(name),
            ..Opening::default()
        });
    }
    let bytes = read_file(path, MAX_SCENE_BYTES).map_err(|error| unread(error.into()))?;
    if is_picture(&bytes) {
        let without = || unread(Message::new("problem-picture-without-link").into());
        return linked(link_in(&bytes).ok_or_else(without)?, catalog);
    }
    let scene = SceneFormats::standard().read(&name, &bytes);
    Ok(Opening {
        scene: Some((name, scene.map_err(|problems| listed(&problems, catalog))?)),
        ..Opening::default()
    })
}

fn listed(problems: &[Problem], catalog: &Catalog) -> String {
    let rendered = problems.iter().map(|problem| problem.render(catalog));
    rendered.collect::<Vec<_>>().join("\n")
}

/// A link that leads somewhere in the embedded course, or to a scene.
fn linked(link: String, catalog: &Catalog) -> Result<Opening, String> {
    let read = link.parse().map_err(said);
    let opened =
        read.and_then(|link| Course::embedded().open_link(&link, SceneFormats::standard()));
    opened.map_err(|problems| listed(&problems, catalog))?;
    Ok(Opening {
        link: Some(link),
        ..Opening::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_commands_are_well_formed() {
        use clap::CommandFactory;
        Cli::command().debug_assert();
    }
}
