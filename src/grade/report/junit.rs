//! A report as JUnit's XML, which build servers read: one test a case.

use std::{
    collections::HashMap,
    fmt::Write as _,
    io::{self, Write},
};

use crate::text::Catalog;

use super::{
    super::tally::{Report, Wrong},
    text::{sentence, title},
};

/// A document with one suite.
///
/// # Errors
/// Where it cannot be written.
pub fn write_junit(report: &Report, catalog: &Catalog, mut out: impl Write) -> io::Result<()> {
    let of_cases: HashMap<usize, &Wrong> = report
        .wrong
        .iter()
        .filter_map(|wrong| Some((wrong.case?, wrong)))
        .collect();
    let strays: Vec<&Wrong> = report
        .wrong
        .iter()
        .filter(|wrong| wrong.case.is_none())
        .collect();
    let n_listed = report.names.len();
    let late: Vec<&Wrong> = of_cases
        .values()
        .copied()
        .filter(|wrong| wrong.case > Some(n_listed))
        .collect();
    let n_tests = n_listed + late.len() + strays.len();
    let n_failures = report.wrong.len();
    writeln!(out, r#"<?xml version="1.0" encoding="UTF-8"?>"#)?;
    writeln!(
        out,
        r#"<testsuites tests="{n_tests}" failures="{n_failures}">"#
    )?;
    let counts = format!(r#"tests="{n_tests}" failures="{n_failures}" errors="0" skipped="0""#);
    writeln!(out, r#"  <testsuite name="clipscope grade" {counts}>"#)?;
    for (i, id) in report.names.iter().enumerate() {
        let name = title(Some(i + 1), id, catalog);
        write_test(&name, of_cases.get(&(i + 1)).copied(), catalog, &mut out)?;
    }
    for wrong in late.into_iter().chain(strays) {
        write_test(
            &title(wrong.case, &wrong.id, catalog),
            Some(wrong),
            catalog,
            &mut out,
        )?;
    }
    writeln!(out, "  </testsuite>\n</testsuites>")
}

fn write_test(
    name: &str,
    wrong: Option<&Wrong>,
    catalog: &Catalog,
    out: &mut impl Write,
) -> io::Result<()> {
    let name = escaped(name);
    let Some(wrong) = wrong else {
        return writeln!(
            out,
            r#"    <testcase classname="clipscope" name="{name}"/>"#
        );
    };
    let (kind, message) = (wrong.kind.id(), escaped(&sentence(wrong, catalog)));
    let [said, truth] = [&wrong.said, &wrong.truth].map(|value| escaped(&value.to_string()));
    writeln!(out, r#"    <testcase classname="clipscope" name="{name}">"#)?;
    writeln!(
        out,
        r#"      <failure type="{kind}" message="{message}">said {said}"#
    )?;
    writeln!(out, "true {truth}</failure>\n    </testcase>")
}

/// As XML holds it; what XML cannot hold is replaced.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\t' => {
                let _ = write!(out, "&#{};", c as u32);
            }
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c if c.is_control() => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}
