//! A program's answers against the true ones: what graders build on.

mod many;
mod mistakes;
mod pictures;
mod reports;
mod schemas;
mod wrongs;

use std::{fs, io::Read, path::Path};

use clipscope::{
    case::{Detail, Format, Solvers, Style, trace},
    grade::{Options, grade, write_json},
    text::{Catalog, Lang},
};
use serde_json::Value as Json;

/// The reports, one a line.
pub fn reports_of(cases: impl Read, answers: impl Read, options: Options) -> String {
    let (mut out, catalog) = (Vec::new(), Catalog::of(Lang::En));
    let done = grade(Solvers::standard(), cases, answers, options, |report| {
        write_json(report, catalog, &mut out)
    });
    done.unwrap();
    String::from_utf8(out).unwrap()
}

/// The one report.
pub fn graded(cases: &str, answers: &str) -> Json {
    let report = reports_of(cases.as_bytes(), answers.as_bytes(), Options::default());
    serde_json::from_str(&report).unwrap()
}

/// What `trace` answers.
pub fn traced(cases: &str, detail: Detail) -> String {
    let style = Style {
        format: Format::Json,
        detail,
        lang: Lang::En,
    };
    let mut answers = Vec::new();
    trace(
        Solvers::standard(),
        cases.as_bytes(),
        &mut answers,
        style,
        |_| {},
    )
    .unwrap();
    String::from_utf8(answers).unwrap()
}

/// Cases of all kinds, some of them refused: those that the fuzzer starts from. Each has an id that is its own.
pub fn public_cases() -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds/trace");
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    files.sort();
    let texts = files
        .iter()
        .filter_map(|file| fs::read_to_string(file).ok());
    let lines: Vec<String> = texts
        .flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>())
        .collect();
    let more = [
        r#"{"algorithm":"painter","size":[4,4],"frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"triangles":[[[-1,-1,-3],[1,-1,-3],[0,1,-3]],[[-1,-1,-2],[1,-1,-2],[0,1,-2]]]}"#,
        r#"{"algorithm":"depth-buffer","size":[3,3],"frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10},"triangles":[[[-3,-3,-3],[3,-3,-3],[0,3,-3]]]}"#,
        r#"{"algorithm":"bresenham","from":[0,0],"to":[5,2]}"#,
        r#"{"algorithm":"homogeneous-triangle","triangle":[[0,0,0,1],[3,0,0,1],[0,3,0,1]]}"#,
    ];
    let lines = lines.iter().map(String::as_str).chain(more);
    let lines = lines.filter(|line| !line.trim().is_empty() && !line.contains("\"id\""));
    let named = |(i, line): (usize, &str)| match line.strip_prefix('{') {
        Some(rest) if rest.len() > 1 => format!("{{\"id\":{},{rest}", i + 1),
        _ => line.to_owned(),
    };
    lines.enumerate().map(named).collect::<Vec<_>>().join("\n")
}

#[test]
fn what_trace_answers_is_right() {
    let cases = public_cases();
    for detail in [Detail::Steps, Detail::Answers] {
        let report = graded(&cases, &traced(&cases, detail));
        assert_eq!(report["wrong"], serde_json::json!([]), "{detail:?}");
        assert_eq!(report["right"], report["cases"]);
        assert!(report["cases"].as_u64() > Some(20));
    }
}

#[test]
fn the_order_of_answers_does_not_matter_where_cases_have_ids() {
    let cases: Vec<String> = (0..300)
        .map(|i| {
            let x = f64::from(i) / 100.0;
            format!(r#"{{"id":"c{i}","algorithm":"liang-barsky","window":[-1,-1,1,1],"segment":[-2,-1,2,{x}]}}"#)
        })
        .collect();
    let cases = cases.join("\n");
    let answers = traced(&cases, Detail::Answers);
    let mut turned: Vec<&str> = answers.lines().collect();
    turned.reverse();
    assert_eq!(graded(&cases, &turned.join("\n"))["right"], 300);
    let every_other: Vec<&str> = answers.lines().step_by(2).collect();
    let report = graded(&cases, &every_other.join("\n"));
    assert_eq!(report["right"], 150);
    assert!(
        report["wrong"]
            .as_array()
            .unwrap()
            .iter()
            .all(|wrong| wrong["kind"] == "missing")
    );
}
