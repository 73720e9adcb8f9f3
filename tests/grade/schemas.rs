//! What platforms publish of the files that they read, term by term, and reports held against it.

use clipscope::{
    case::Detail,
    grade::{Picture, gradescope, prairielearn, write_junit},
    text::{Catalog, Lang},
};
use serde_json::Value as Json;

use super::{reports::with_report, traced};

/// An element: the attributes that it must have, others that it may have, and what may stand in it.
type Element = (
    &'static str,
    &'static [&'static str],
    &'static [&'static str],
    &'static [&'static str],
);

/// `junit-10.xsd` of Jenkins' xUnit plugin (commit 031e285). Text stands in none but the last ones.
const JUNIT: [Element; 5] = [
    (
        "testsuites",
        &[],
        &["name", "time", "tests", "failures", "errors"],
        &["testsuite"],
    ),
    (
        "testsuite",
        &["name", "tests", "failures", "errors"],
        &[
            "group",
            "time",
            "skipped",
            "timestamp",
            "hostname",
            "id",
            "package",
            "file",
            "log",
            "url",
        ],
        &[
            "testsuite",
            "properties",
            "testcase",
            "system-out",
            "system-err",
        ],
    ),
    (
        "testcase",
        &["name"],
        &["time", "classname", "group"],
        &["skipped", "error", "failure", "system-out", "system-err"],
    ),
    ("failure", &[], &["type", "message"], &["#text"]),
    ("error", &[], &["type", "message"], &["#text"]),
];

/// https://prairielearn.readthedocs.io/en/latest/externalGrading/, "Grading results": of all, of a test, of an image.
const PRAIRIELEARN: [&[&str]; 3] = [
    &[
        "gradable",
        "score",
        "message",
        "output",
        "images",
        "tests",
        "format_errors",
    ],
    &[
        "name",
        "description",
        "points",
        "max_points",
        "message",
        "output",
        "images",
    ],
    &["label", "url"],
];

/// https://gradescope-autograders.readthedocs.io/en/latest/specs/, "Output format": of all, of a test.
const GRADESCOPE: [&[&str]; 2] = [
    &[
        "score",
        "execution_time",
        "output",
        "output_format",
        "test_output_format",
        "test_name_format",
        "visibility",
        "stdout_visibility",
        "extra_data",
        "tests",
        "leaderboard",
    ],
    &[
        "score",
        "max_score",
        "status",
        "name",
        "name_format",
        "number",
        "output",
        "output_format",
        "tags",
        "visibility",
        "extra_data",
    ],
];

const CASES: &str = r#"{"id":"<a & \"b\">","algorithm":"sphere-cull","planes":[[1,0,0,0]],"sphere":[2,0,0,1]}
{"id":2,"algorithm":"bresenham","from":[0,0],"to":[3,1]}
{"id":3,"algorithm":"depth-buffer","size":[0,3]}"#;
/// Wrong, none, and an answer to no case.
const WRONG: &str = "{\"id\":\"<a & \\\"b\\\">\",\"output\":{\"class\":\"\\u0007]]>\",\"distances\":[2]}}\nnonsense\n{\"id\":9}";

fn each_of(answers: &str, look: impl Fn(&clipscope::grade::Report)) {
    with_report(CASES, answers, &look);
}

/// Right and wrong, empty and full.
fn answers() -> [String; 3] {
    [
        traced(CASES, Detail::Answers),
        WRONG.to_owned(),
        String::new(),
    ]
}

#[test]
fn junit_keeps_to_the_schema_that_jenkins_reads() {
    for answers in answers() {
        each_of(&answers, |report| {
            let mut out = Vec::new();
            write_junit(report, Catalog::of(Lang::En), &mut out).unwrap();
            let xml = String::from_utf8(out).unwrap();
            let mut body = xml
                .strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>")
                .unwrap();
            let mut open: Vec<Element> = Vec::new();
            while let Some(at) = body.find('<') {
                let text = &body[..at];
                let is_mixed = open.last().is_some_and(|it| it.3 == ["#text"]);
                assert!(is_mixed || text.trim().is_empty(), "{text}");
                let end = at + body[at..].find('>').unwrap();
                element(&body[at + 1..end], &mut open, &xml);
                body = &body[end + 1..];
            }
            assert!(open.is_empty() && body.trim().is_empty(), "{xml}");
        });
    }
}

fn element(tag: &str, open: &mut Vec<Element>, xml: &str) {
    if let Some(name) = tag.strip_prefix('/') {
        assert_eq!(open.pop().map(|it| it.0), Some(name), "{xml}");
        return;
    }
    let is_empty = tag.ends_with('/');
    let (name, mut rest) = tag.trim_end_matches('/').split_once(' ').unwrap();
    let known = JUNIT
        .iter()
        .find(|it| it.0 == name)
        .unwrap_or_else(|| panic!("{name}"));
    match open.last() {
        Some(parent) => assert!(parent.3.contains(&name), "{name} in {}", parent.0),
        None => assert_eq!(name, "testsuites"),
    }
    let mut attributes = Vec::new();
    while let Some((attribute, after)) = rest.split_once("=\"") {
        let (value, after) = after.split_once('"').unwrap();
        assert!(
            !value.contains('<') && !attributes.contains(&attribute.trim()),
            "{tag}"
        );
        attributes.push(attribute.trim());
        rest = after;
    }
    assert!(
        known.1.iter().all(|must| attributes.contains(must)),
        "{tag}"
    );
    assert!(
        attributes
            .iter()
            .all(|it| known.1.contains(it) || known.2.contains(it)),
        "{tag}"
    );
    if !is_empty {
        open.push(*known);
    }
}

fn has_none_but(object: &Json, known: &[&str]) {
    for name in object.as_object().unwrap().keys() {
        assert!(known.contains(&&**name), "{name}");
    }
}

#[test]
fn prairielearn_knows_every_field() {
    let [all, test, image] = PRAIRIELEARN;
    let picture = Picture {
        png: b"\x89PNG",
        alternative: "title",
    };
    for answers in answers() {
        each_of(&answers, |report| {
            let results = prairielearn(report, Some(&picture), Catalog::of(Lang::Es));
            has_none_but(&results, all);
            assert!((0.0..=1.0).contains(&results["score"].as_f64().unwrap()));
            assert!(results["gradable"].is_boolean() && results["message"].is_string());
            for own in results["tests"].as_array().unwrap() {
                has_none_but(own, test);
                let [points, most] =
                    ["points", "max_points"].map(|name| own[name].as_f64().unwrap());
                assert!((0.0..=most).contains(&points));
            }
            for own in results["images"].as_array().unwrap() {
                has_none_but(own, image);
                assert!(
                    own["url"]
                        .as_str()
                        .unwrap()
                        .starts_with("data:image/png;base64,")
                );
            }
        });
    }
}

#[test]
fn gradescope_knows_every_field() {
    let [all, test] = GRADESCOPE;
    for answers in answers() {
        each_of(&answers, |report| {
            let results = gradescope(report, Catalog::of(Lang::PtBr));
            has_none_but(&results, all);
            // Of all, or of each test.
            assert!(results["score"].is_number() && results["output"].is_string());
            for own in results["tests"].as_array().unwrap() {
                has_none_but(own, test);
                assert!(["passed", "failed"].contains(&own["status"].as_str().unwrap()));
                assert!(own["name"].is_string() && own["output"].is_string());
            }
        });
    }
}
