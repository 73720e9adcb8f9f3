//! `clipscope list`: what there is.

use clap::ValueEnum;
use serde_json::{Value as Json, json};

use crate::{
    case::{Need, Solver, solvers},
    text::{Catalog, Lang},
};

use super::{Outcome, lang_parser, say::print};

const EXAMPLES: &str = "\
Examples:
  clipscope list
  clipscope list --format json";

/// What it accepts.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
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

/// Lists everything.
pub(super) fn list(args: &Args) -> Outcome {
    let catalog = Catalog::of(args.lang);
    let text = match args.format {
        Format::Text => as_text(catalog),
        Format::Json => format!("{:#}\n", as_json(catalog)),
    };
    print(&text, args.lang)
}

fn as_text(catalog: &Catalog) -> String {
    let mut lines = vec![catalog.term("list-algorithms")];
    for solver in solvers() {
        let name = catalog.term(solver.name_key());
        lines.push(format!("  {:<24}{name}", solver.id()));
        lines.push(format!("  {:<24}{}", "", fields_text(solver)));
    }
    lines.join("\n") + "\n"
}

/// `window | clip, segment, [bit_order]`
fn fields_text(solver: &dyn Solver) -> String {
    let mut parts: Vec<String> = Vec::new();
    let mut choosing = false;
    for field in solver.fields() {
        match (field.need, parts.last_mut()) {
            (Need::Choice, Some(part)) if choosing => *part = format!("{part} | {}", field.name),
            (Need::Optional, _) => parts.push(format!("[{}]", field.name)),
            _ => parts.push(field.name.to_owned()),
        }
        choosing = field.need == Need::Choice;
    }
    parts.join(", ")
}

fn as_json(catalog: &Catalog) -> Json {
    let algorithms: Vec<Json> = solvers()
        .map(|solver| {
            let names = |need| -> Vec<&str> {
                let of_need = solver.fields().iter().filter(|f| f.need == need);
                of_need.map(|f| f.name).collect()
            };
            json!({
                "id": solver.id(),
                "name": catalog.term(solver.name_key()),
                "source": solver.source(),
                "fields": {
                    "required": names(Need::Required),
                    "one_of": names(Need::Choice),
                    "optional": names(Need::Optional),
                },
            })
        })
        .collect();
    json!({ "algorithms": algorithms })
}
