//! A small lesson in order, and ways to break it.

mod broken;
mod drafts;
mod frustum_scenes;
mod reading;
mod references;

use std::collections::BTreeMap;

use crate::text::Lang;

use super::*;

pub(crate) const LESSON: &str = r#"lab = "lines"
source = "D. Cohen and I. Sutherland, 1967"

[scenes.practice]
method = "cohen-sutherland"
window = [-1, -1, 1, 1]
segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]]

[[step]]
id = "first"
scene = "practice"
figure = "one"

[[step]]
id = "second"
at = "end"
lock = ["window"]
code = "words"
"#;

pub(crate) const TEXT: &str = "# Regions

## first: The first step

What is *this*?

> The **answer** is `0000`.

## second: The second step

- one
- two
";

type Memory = BTreeMap<String, Vec<u8>>;

fn with(toml: &str, english: &str) -> Memory {
    let texts = Lang::ALL.map(|lang| (format!("01-a/{lang}.md"), english.into()));
    let mut files: Memory = texts.into_iter().collect();
    files.insert("01-a/lesson.toml".to_owned(), toml.into());
    files
}

/// `line:column code` of each problem of the one lesson, without its folder.
fn found(files: &Memory) -> Vec<String> {
    let problems = Course::check(files).problems;
    problems.iter().map(spot).collect()
}

fn spot(problem: &Problem) -> String {
    let file = problem.file.trim_start_matches("01-a/");
    let place = problem.place.as_ref();
    let place = place.map_or(String::new(), |p| format!(":{}:{}", p.line, p.column));
    format!("{file}{place} {}", problem.code())
}

/// The lesson with each replacement made once.
fn lesson(replacements: &[(&str, &str)]) -> Memory {
    let mut toml = LESSON.to_owned();
    for (old, new) in replacements {
        assert!(toml.contains(old), "the lesson has no {old:?}");
        toml = toml.replacen(old, new, 1);
    }
    with(&toml, TEXT)
}

/// Rows of a table: what is replaced, by what, and what is found then. `\n` is a line break.
pub(super) fn cases<const N: usize>(table: &str) -> impl Iterator<Item = [String; N]> {
    table.trim_matches('\n').lines().map(|row| {
        let cells = row.split(" => ").map(|cell| cell.replace("\\n", "\n"));
        let cells: Vec<String> = cells.collect();
        cells
            .try_into()
            .expect("as many cells as the table has columns")
    })
}
