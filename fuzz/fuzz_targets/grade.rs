//! Bytes into `clipscope grade`: before the first empty line cases, behind it answers.
#![no_main]

use clipscope::{
    case::{Detail, Format, Solvers, Style, trace},
    grade::{Options, Totals, grade, merge, write_json, write_junit, write_text},
    text::{Catalog, Lang},
};
use libfuzzer_sys::fuzz_target;
use serde_json::Value as Json;

fuzz_target!(|bytes: &[u8]| {
    let cut = bytes.windows(2).position(|pair| pair == b"\n\n");
    let (cases, answers) = bytes.split_at(cut.unwrap_or(bytes.len()));
    let reports = graded(cases, answers);
    assert_eq!(reports, graded(cases, answers), "the same input, the same report");
    let mut totals = Totals::new();
    merge(&mut totals, reports.as_bytes(), |line| panic!("line {line} is no report")).expect("memory can be read");
    for line in reports.lines() {
        let report: Json = serde_json::from_str(line).expect("a report is JSON");
        assert!(report["right"].as_u64() <= report["cases"].as_u64(), "{report}");
    }
    merge(&mut totals, bytes, |_| {}).expect("memory can be read");

    // What is true is right, but where its steps are more than a report takes.
    let style = Style { format: Format::Json, detail: Detail::Answers, lang: Lang::En };
    let mut truth = Vec::new();
    trace(Solvers::standard(), cases, &mut truth, style, |_| {}).expect("memory can be written");
    for line in graded(cases, &truth).lines() {
        let report: Json = serde_json::from_str(line).expect("a report is JSON");
        assert_eq!(report["right"], report["cases"], "{report}");
    }
});

fn graded(cases: &[u8], answers: &[u8]) -> String {
    let (mut out, mut other) = (Vec::new(), Vec::new());
    let catalog = Catalog::of(Lang::En);
    let done = grade(Solvers::standard(), cases, answers, Options::default(), |report| {
        write_text(report, Catalog::of(Lang::Es), &mut other)?;
        write_junit(report, catalog, &mut other)?;
        write_json(report, catalog, &mut out)
    });
    done.expect("memory can be read");
    String::from_utf8(out).expect("reports are text")
}
