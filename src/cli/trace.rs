//! `clipscope trace`: answers to cases.

use std::{
    io::{self, IsTerminal},
    path::PathBuf,
};

use clap::{ArgAction, ValueEnum};

use crate::{
    case::{self, Detail, Refusing, Solvers, Style, Tally, TraceError},
    text::{Catalog, Lang, Message},
};

use super::{
    Outcome, lang_parser, say,
    say::{not_written, print, say_text, unreadable},
    source::Source,
};

const EXAMPLES: &str = r#"Examples:
  clipscope trace cases.ndjson --events false > answers.ndjson
  clipscope trace cases.ndjson --format markdown --lang es > respuestas.md
  clipscope trace cases.ndjson --format worksheet --lang es > ejercicios.md
  clipscope trace --schema > schema.json
  echo '{"algorithm":"liang-barsky","window":[-1,-1,1,1],"segment":[-2,-1,2,1.5]}' |
    clipscope trace

One case a line in, one answer a line out, in order. A refused case is answered with an
error (on standard error only where people read the answers) and the rest is carried on;
exit status 1 tells that there was one, unless --refused-ok is given. An empty input has no answers and is no mistake."#;

/// Refusals named on standard error where the answers name them all.
const MAX_NAMED: usize = 10;

#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// A file of cases, one JSON object a line; `-` is standard input
    #[arg(value_name = "FILE", default_value = "-")]
    file: PathBuf,
    /// How answers are written [default: text on a terminal, json elsewhere]
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Write every step, or the answers only
    #[arg(long, value_name = "BOOL", default_value_t = true, action = ArgAction::Set)]
    events: bool,
    /// Print a JSON Schema of the cases and answers of every algorithm, and answer nothing
    #[arg(long, conflicts_with_all = ["file", "format", "events"])]
    schema: bool,
    /// Exit with 0 also where cases were refused
    #[arg(long)]
    refused_ok: bool,
    /// Language of text, markdown, worksheet and messages
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    lang: Lang,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// One JSON object a line
    Json,
    /// Step tables for a terminal
    Text,
    /// An answer key to hand out
    Markdown,
    /// The same as a worksheet: with blanks in place of the answers
    Worksheet,
}

pub(super) fn trace(args: &Args) -> Outcome {
    let lang = args.lang;
    if args.schema {
        let schema = Solvers::standard().schema();
        return print(&format!("{schema:#}\n"), lang);
    }
    let unreadable = |error: io::Error| unreadable(&args.file, error, lang);
    let source = match Source::open(&args.file, lang) {
        Ok(source) => source,
        Err(error) => return unreadable(error),
    };
    let style = style(args);
    let most_named = match style.format {
        case::Format::Json => MAX_NAMED,
        case::Format::Text | case::Format::Markdown | case::Format::Worksheet => usize::MAX,
    };
    // Kept until the end, so that they do not stand between the answers on a terminal.
    let mut refusals = Vec::new();
    let name = |refusing: Refusing<'_>| {
        if refusals.len() < most_named {
            refusals.push(refusing.sentence(Catalog::of(lang)));
        }
    };
    let out = io::stdout().lock();
    match case::trace(Solvers::standard(), source, out, style, name) {
        Ok(tally) => sum_up(tally, &refusals, args),
        Err(TraceError::Read(error)) => unreadable(error),
        Err(TraceError::Write(error)) => not_written(error, lang),
    }
}

fn sum_up(tally: Tally, refusals: &[String], args: &Args) -> Outcome {
    if tally.refused == 0 {
        return Outcome::Done;
    }
    for sentence in refusals {
        say_text(sentence);
    }
    let unnamed = tally.refused.saturating_sub(refusals.len());
    let counts = [
        ("trace-more-refused", unnamed),
        ("cli-refused", tally.refused),
    ];
    for (key, count) in counts.into_iter().filter(|(_, count)| *count > 0) {
        say(args.lang, &Message::new(key).with("count", count));
    }
    if args.refused_ok {
        Outcome::Done
    } else {
        Outcome::Refused
    }
}

fn style(args: &Args) -> Style {
    let default = if io::stdout().is_terminal() {
        Format::Text
    } else {
        Format::Json
    };
    Style {
        format: match args.format.unwrap_or(default) {
            Format::Json => case::Format::Json,
            Format::Text => case::Format::Text,
            Format::Markdown => case::Format::Markdown,
            Format::Worksheet => case::Format::Worksheet,
        },
        detail: if args.events {
            Detail::Steps
        } else {
            Detail::Answers
        },
        lang: args.lang,
    }
}
