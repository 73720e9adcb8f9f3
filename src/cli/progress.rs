//! `clipscope progress`: the files of a class as one table.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use crate::{
    lesson::{Course, Folder, MAX_PROGRESS_BYTES, Progress, Tally, read_file},
    text::{Catalog, Diagnostic, Lang, Message, printable},
};

use super::{
    Outcome, lang_parser,
    say::{print, say},
};

const EXAMPLES: &str = "\
Examples:
  clipscope progress handed-in/*.json > class.csv
  clipscope progress ana.json ben.json --format markdown
  clipscope progress *.json --course my-course

A row a file: steps seen; questions told beforehand, told after the numbers, and open; goals reached;
the score (told beforehand and reached count 1, told after the numbers 1/2, of all); and a column a lesson
with what of it was told or reached.";

#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Files that students handed in
    #[arg(value_name = "FILE", required = true)]
    files: Vec<PathBuf>,
    /// A folder of lessons in place of the embedded course
    #[arg(long, value_name = "FOLDER")]
    course: Option<PathBuf>,
    /// For a spreadsheet or for a page
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    format: Format,
    /// Language of the table's head
    #[arg(long, value_name = "LANG", default_value_t = Lang::En, value_parser = lang_parser())]
    lang: Lang,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Csv,
    Markdown,
}

pub(super) fn progress(args: &Args) -> Outcome {
    let course = match &args.course {
        None => Course::embedded(),
        Some(folder) => Course::load(&Folder::new(folder)).course,
    };
    let mut outcome = Outcome::Done;
    let mut rows = vec![head(&course, Catalog::of(args.lang))];
    for path in &args.files {
        match read(path) {
            Ok(progress) => rows.push(row(path, &progress, &course)),
            Err(reason) => {
                let message = Message::new("cli-unreadable").with("path", shown(path));
                say(args.lang, &message.with("reason", reason));
                outcome = Outcome::Refused;
            }
        }
    }
    if rows.len() == 1 {
        return Outcome::Unusable;
    }
    let text = match args.format {
        Format::Csv => rows.iter().map(|row| csv(row)).collect(),
        Format::Markdown => markdown(&rows),
    };
    match print(&text, args.lang) {
        Outcome::Done => outcome,
        failed => failed,
    }
}

fn read(path: &Path) -> Result<Progress, Diagnostic> {
    let bytes = read_file(path, MAX_PROGRESS_BYTES).map_err(Diagnostic::from)?;
    Progress::read(&bytes)
}

fn shown(path: &Path) -> String {
    printable(&path.display().to_string())
}

fn head(course: &Course, catalog: &Catalog) -> Vec<String> {
    let names = [
        "table-file",
        "told-seen",
        "told-beforehand",
        "told-after",
        "told-open",
        "mark-reached",
        "table-score",
    ];
    let names = names.map(|key| catalog.term(key));
    let lessons = course.lessons.iter().map(|lesson| lesson.id.clone());
    names.into_iter().chain(lessons).collect()
}

fn row(path: &Path, progress: &Progress, course: &Course) -> Vec<String> {
    let all = progress.of_course(course);
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let counts = [all.seen, all.beforehand, all.after, all.open(), all.reached];
    let mut row = vec![printable(&stem)];
    row.extend(counts.map(|count| count.to_string()));
    row.push(format!("{:.3}", all.score()));
    let of_lesson = |tally: Tally| {
        let done = tally.beforehand + tally.after + tally.reached;
        format!("{done}/{}", tally.asked + tally.goals)
    };
    let lessons = course.lessons.iter();
    row.extend(lessons.map(|lesson| of_lesson(progress.of_lesson(lesson))));
    row
}

/// A field that a spreadsheet would take for a formula is none: a file's name is anybody's.
fn csv(row: &[String]) -> String {
    let field = |field: &String| {
        let is_formula = field.starts_with(['=', '+', '-', '@', '\t']);
        let field = format!("{}{field}", if is_formula { "'" } else { "" });
        if field.contains([',', '"', '\n']) {
            format!("\"{}\"", field.replace('"', "\"\""))
        } else {
            field
        }
    };
    row.iter().map(field).collect::<Vec<_>>().join(",") + "\n"
}

fn markdown(rows: &[Vec<String>]) -> String {
    let line = |row: &Vec<String>| {
        let cells: Vec<_> = row.iter().map(|cell| cell.replace('|', "\\|")).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let mut text = line(&rows[0]);
    text += "|---|";
    text += &"--:|".repeat(rows[0].len() - 1);
    text.push('\n');
    text.extend(rows[1..].iter().map(line));
    text
}
