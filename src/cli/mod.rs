//! The command line: what it accepts, and where it goes from there.
//!
//! Results go to standard output, messages to standard error. Exit status: 0 done, 1 some of the input was
//! refused (each refusal named), 2 wrong usage or nothing could be read.

mod check;
mod export;
mod lessons;
mod list;
mod open;
mod progress;
mod say;
mod trace;
mod usage;

use std::{env, path::PathBuf, process::ExitCode};

use clap::{
    Parser, Subcommand,
    builder::{PossibleValuesParser, TypedValueParser},
};

use crate::text::Lang;

pub use progress::Progress;
pub use say::{Outcome, say};

/// What an invocation asks for.
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

Exit status: 0 done, 1 some of the input was refused, 2 wrong usage or nothing could be read.";

#[derive(Subcommand)]
enum Command {
    /// Open a lesson folder, a scene file or a mesh in the app
    #[command(
        after_help = "Examples:\n  clipscope open my-course/01-outcodes\n  clipscope open cow.obj"
    )]
    Open {
        /// A lesson folder, a folder of lessons, a scene file or a mesh
        path: PathBuf,
    },
    /// Draw figures to files: needs no display and no GPU
    Export(export::Args),
    /// Run algorithms on cases, one JSON object a line, and print every step
    Trace(trace::Args),
    /// Validate lesson files: every mistake with file, line and column
    Check(check::Args),
    /// List lessons with their steps and figures, and the algorithms that `trace` knows
    List(list::Args),
}

/// Does what the command line asks for.
pub fn run() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            let args: Vec<String> = env::args_os()
                .map(|arg| arg.to_string_lossy().into_owned())
                .collect();
            usage::explain(&error, &args);
            return match error.exit_code() {
                0 => Outcome::Done.into(),
                _ => Outcome::Unusable.into(),
            };
        }
    };
    match cli.command {
        None => open::open_app(None),
        Some(Command::Open { path }) => open::open_app(Some(path)),
        Some(Command::Export(args)) => export::export(&args).into(),
        Some(Command::Trace(args)) => trace::trace(&args).into(),
        Some(Command::Check(args)) => check::check(&args).into(),
        Some(Command::List(args)) => list::list(&args).into(),
    }
}

/// Reads a language's id.
fn lang_parser() -> impl TypedValueParser<Value = Lang> {
    PossibleValuesParser::new(Lang::ALL.map(Lang::id)).try_map(|id| id.parse::<Lang>())
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
