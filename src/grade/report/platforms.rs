//! A report as `results.json` of PrairieLearn and of Gradescope.

use base64::{Engine, prelude::BASE64_STANDARD};
use serde_json::{Value as Json, json};

use crate::text::{Catalog, Message};

use super::{
    super::tally::{Report, Wrong},
    text::{score, sentence, title},
};

/// PrairieLearn takes no more than 1 MB: so many tests, and pictures no larger than that, are always less.
const MOST_TESTS: usize = 200;
const MOST_PICTURE_BYTES: usize = 500_000;

/// A figure of the first answer that is wrong.
pub struct Picture<'a> {
    /// As a file.
    pub png: &'a [u8],
    /// Its title and its sentence, for who cannot see it.
    pub alternative: &'a str,
}

/// What a test says: its name, whether it is passed, and why not.
struct Test {
    name: String,
    message: Option<String>,
}

/// One a case, as long as they are few; else one for each that is wrong, and one for all that are right.
fn tests(report: &Report, catalog: &Catalog) -> Vec<Test> {
    let failed = |wrong: &Wrong| Test {
        name: title(wrong.case, &wrong.id, catalog),
        message: Some(sentence(wrong, catalog)),
    };
    let strays = report
        .wrong
        .iter()
        .filter(|wrong| wrong.case.is_none())
        .map(failed);
    if report.n_cases <= MOST_TESTS {
        let mut wrong = report
            .wrong
            .iter()
            .filter(|wrong| wrong.case.is_some())
            .peekable();
        let of_case = |(i, id)| {
            let own = wrong.next_if(|wrong| wrong.case == Some(i + 1));
            own.map_or_else(
                || Test {
                    name: title(Some(i + 1), id, catalog),
                    message: None,
                },
                failed,
            )
        };
        let cases: Vec<Test> = report.names.iter().enumerate().map(of_case).collect();
        return cases
            .into_iter()
            .chain(strays)
            .take(2 * MOST_TESTS)
            .collect();
    }
    let passed = Test {
        name: score(report, catalog),
        message: None,
    };
    let failed = report.wrong.iter().take(MOST_TESTS).map(failed);
    std::iter::once(passed).chain(failed).collect()
}

/// What stands above all tests.
fn summary(report: &Report, catalog: &Catalog) -> String {
    let score = score(report, catalog);
    let n_more = report.wrong.len().saturating_sub(MOST_TESTS) + report.n_unlisted;
    if n_more == 0 || report.n_cases <= MOST_TESTS {
        return score;
    }
    let more = Message::new("grade-unlisted").with("count", n_more);
    format!("{score} {}", catalog.message(&more))
}

/// Cases that are right, of all; 1 where there are none.
fn share(report: &Report) -> f64 {
    if report.n_cases == 0 {
        return 1.0;
    }
    report.n_right as f64 / report.n_cases as f64
}

/// For PrairieLearn.
#[must_use]
pub fn prairielearn(report: &Report, picture: Option<&Picture<'_>>, catalog: &Catalog) -> Json {
    let test = |test: Test| {
        let points = u8::from(test.message.is_none());
        let message = test.message.unwrap_or_default();
        json!({ "name": test.name, "points": points, "max_points": 1, "message": message })
    };
    let tests = tests(report, catalog).into_iter().map(test);
    let small = picture.filter(|picture| picture.png.len() <= MOST_PICTURE_BYTES);
    let image = small.map(|picture| {
        let url = format!(
            "data:image/png;base64,{}",
            BASE64_STANDARD.encode(picture.png)
        );
        json!({ "label": picture.alternative, "url": url })
    });
    json!({
        "gradable": true,
        "score": share(report),
        "message": summary(report, catalog),
        "tests": tests.collect::<Vec<_>>(),
        "images": image.into_iter().collect::<Vec<_>>(),
    })
}

/// For Gradescope: as many points as there are cases.
#[must_use]
pub fn gradescope(report: &Report, catalog: &Catalog) -> Json {
    let test = |test: Test| {
        let status = if test.message.is_none() {
            "passed"
        } else {
            "failed"
        };
        let output = test.message.unwrap_or_default();
        json!({ "name": test.name, "status": status, "output": output })
    };
    let tests = tests(report, catalog).into_iter().map(test);
    json!({
        "score": report.n_right,
        "output": summary(report, catalog),
        "tests": tests.collect::<Vec<_>>(),
    })
}
