//! `clipscope list`: what there is.

use std::path::PathBuf;

use clap::ValueEnum;
use serde_json::{Value as Json, json};

use crate::{
    case::{Solver, Solvers},
    input::Presence,
    lesson::{Course, Lesson},
    text::{Catalog, Lang, Message, printable},
};

use super::{
    Outcome, lang_parser,
    lessons::{choose, is_error},
    say::print,
};

const EXAMPLES: &str = "\
Examples:
  clipscope list
  clipscope list my-course
  clipscope list --format json | jq '.algorithms[].id'";

#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Lesson folders, folders of lessons, or lessons of the embedded course by name
    #[arg(value_name = "LESSON")]
    lessons: Vec<PathBuf>,
    /// For people or for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Language of titles and names
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    lang: Lang,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// Indented lines
    Text,
    /// One JSON object
    Json,
}

pub(super) fn list(args: &Args) -> Outcome {
    let catalog = Catalog::of(args.lang);
    let chosen = choose(&args.lessons, Course::load);
    let outcome = chosen.report(args.lang, is_error);
    let text = match args.format {
        Format::Text => printable(&as_text(&chosen.lessons, catalog)),
        Format::Json => format!("{:#}\n", as_json(&chosen.lessons, catalog)),
    };
    match print(&text, args.lang) {
        Outcome::Done => outcome,
        failed => failed,
    }
}

fn as_text(lessons: &[Lesson], catalog: &Catalog) -> String {
    let mut lines = vec![catalog.term("list-lessons")];
    for lesson in lessons {
        let lang = catalog.lang();
        lines.push(format!("  {:<28}{}", lesson.id, lesson.title(lang)));
        for (i, step) in lesson.steps.iter().enumerate() {
            let title = lesson.step_title(i, lang).unwrap_or_default();
            let figure = step.figure.as_ref().map_or_else(String::new, |figure| {
                let message = Message::new("list-figure").with("name", figure.clone());
                format!("  [{}]", catalog.message(&message))
            });
            lines.push(format!("    {:<26}{}{figure}", step.id, title));
        }
    }
    lines.extend([String::new(), catalog.term("list-algorithms")]);
    for solver in Solvers::standard().iter() {
        let name = catalog.term(solver.card.name_key);
        lines.push(format!("  {:<28}{name}", solver.card.id));
        lines.push(format!("    {:<26}{}", "", fields_text(solver)));
    }
    lines.join("\n") + "\n"
}

/// `window | clip, segment, [bit_order]`
fn fields_text(solver: &Solver) -> String {
    let mut parts: Vec<String> = Vec::new();
    let mut choosing = false;
    for field in solver.fields {
        match (field.need, parts.last_mut()) {
            (Presence::Choice, Some(part)) if choosing => {
                *part = format!("{part} | {}", field.name);
            }
            (Presence::Optional, _) => parts.push(format!("[{}]", field.name)),
            _ => parts.push(field.name.to_owned()),
        }
        choosing = field.need == Presence::Choice;
    }
    parts.join(", ")
}

fn as_json(lessons: &[Lesson], catalog: &Catalog) -> Json {
    let lessons: Vec<Json> = lessons.iter().map(|l| lesson_json(l, catalog)).collect();
    let solvers = Solvers::standard().iter();
    let algorithms: Vec<Json> = solvers.map(|s| solver_json(s, catalog)).collect();
    json!({ "lessons": lessons, "algorithms": algorithms })
}

fn lesson_json(lesson: &Lesson, catalog: &Catalog) -> Json {
    let lang = catalog.lang();
    let steps = lesson.steps.iter().enumerate().map(|(i, step)| {
        json!({
            "id": step.id,
            "title": lesson.step_title(i, lang),
            "moment": step.moment.to_string(),
            "figure": step.figure,
        })
    });
    json!({
        "id": lesson.id,
        "title": lesson.title(lang),
        "lab": lesson.lab,
        "source": lesson.source,
        "steps": steps.collect::<Vec<_>>(),
    })
}

fn solver_json(solver: &Solver, catalog: &Catalog) -> Json {
    let names = |need| -> Vec<&str> {
        let of_need = solver.fields.iter().filter(|f| f.need == need);
        of_need.map(|f| f.name).collect()
    };
    json!({
        "id": solver.card.id,
        "name": catalog.term(solver.card.name_key),
        "source": solver.card.source,
        "fields": {
            "required": names(Presence::Required),
            "one_of": names(Presence::Choice),
            "optional": names(Presence::Optional),
        },
    })
}
