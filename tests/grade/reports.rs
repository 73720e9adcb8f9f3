//! Reports in the formats of platforms, against what their pages say of them.

use clipscope::{
    case::{Detail, Solvers},
    grade::{Options, Picture, Report, grade, gradescope, prairielearn, write_junit, write_text},
    text::{Catalog, Lang},
};
use serde_json::{Map, Value as Json, json};

use super::traced;

const CASES: &str = r#"{"id":"<a&b>","algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-2,-1,2,1.5]}
{"id":2,"algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-2,2,2,2]}"#;

/// The first is wrong, the second is right, a third answers nothing.
const ANSWERS: &str = r#"{"id":"<a&b>","output":{"visible":true,"segment":[-1,0.5,1,0.875]}}
{"id":2,"output":{"visible":false,"segment":null}}
{"id":3,"output":{}}"#;

pub fn with_report<T>(cases: &str, answers: &str, look: impl Fn(&Report) -> T) -> T {
    let mut seen = None;
    let solvers = Solvers::standard();
    let done = grade(
        solvers,
        cases.as_bytes(),
        answers.as_bytes(),
        Options::default(),
        |report| {
            seen = Some(look(report));
            Ok(())
        },
    );
    done.unwrap();
    seen.unwrap()
}

fn written(write: impl Fn(&Report, &mut Vec<u8>) -> std::io::Result<()>) -> String {
    with_report(CASES, ANSWERS, |report| {
        let mut out = Vec::new();
        write(report, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    })
}

#[test]
fn people_read_sentences_in_their_language() {
    let english = written(|report, out| write_text(report, Catalog::of(Lang::En), out));
    assert_eq!(
        english,
        "1 of 2 cases are answered correctly.\n\
         ✗ case 1 (<a&b>): segment[1] is -0.375; the program says 0.5.\n\
         ✗ no case: Line 3 of the answers belongs to no case: its id is unknown, or the case has an answer already.\n"
    );
    for lang in Lang::ALL {
        let text = written(|report, out| write_text(report, Catalog::of(lang), out));
        assert!(!text.contains('⟦') && text.contains("-0.375"), "{text}");
        assert_eq!(text == english, lang == Lang::En);
    }
}

/// The form that Jenkins, GitLab and the schema of `junit-10.xsd` have in common.
#[test]
fn junit_has_one_test_a_case_and_one_an_answer_to_none() {
    let xml = written(|report, out| write_junit(report, Catalog::of(Lang::En), out));
    let expected = r#"<?xml version="1.0" encoding="UTF-8"?>
<testsuites tests="3" failures="2">
  <testsuite name="clipscope grade" tests="3" failures="2" errors="0" skipped="0">
    <testcase classname="clipscope" name="case 1 (&lt;a&amp;b&gt;)">
      <failure type="output" message="segment[1] is -0.375; the program says 0.5.">said {&quot;visible&quot;:true,&quot;segment&quot;:[-1,0.5,1,0.875]}
true {&quot;visible&quot;:true,&quot;segment&quot;:[-1.0,-0.375,1.0,0.875]}</failure>
    </testcase>
    <testcase classname="clipscope" name="case 2"/>
    <testcase classname="clipscope" name="no case">
      <failure type="extra" message="Line 3 of the answers belongs to no case: its id is unknown, or the case has an answer already.">said null
true null</failure>
    </testcase>
  </testsuite>
</testsuites>
"#;
    assert_eq!(xml, expected);
}

/// A field, and what is asked of it.
type Expected<'a> = (&'a str, fn(&Json) -> bool);

/// An object has these fields and no others, each of a type.
fn check(object: &Json, fields: &[Expected<'_>]) {
    let object: &Map<String, Json> = object.as_object().unwrap();
    assert_eq!(object.len(), fields.len(), "{object:?}");
    for (name, is_of_type) in fields {
        assert!(
            object.get(*name).is_some_and(is_of_type),
            "{name} of {object:?}"
        );
    }
}

/// https://prairielearn.readthedocs.io/en/latest/externalGrading/: `gradable`, `score` from 0 to 1, `tests` with `points`, images as
/// data URLs.
#[test]
fn prairielearn_reads_its_results() {
    let picture = Picture {
        png: b"\x89PNG",
        alternative: "title",
    };
    let results = with_report(CASES, ANSWERS, |report| {
        prairielearn(report, Some(&picture), Catalog::of(Lang::En))
    });
    check(
        &results,
        &[
            ("gradable", |json| *json == true),
            ("score", |json| {
                json.as_f64()
                    .is_some_and(|score| (0.0..=1.0).contains(&score))
            }),
            ("message", Json::is_string),
            ("tests", Json::is_array),
            ("images", Json::is_array),
        ],
    );
    assert_eq!(results["score"], 0.5);
    assert_eq!(
        results["images"][0]["url"],
        "data:image/png;base64,iVBORw=="
    );
    let tests = results["tests"].as_array().unwrap();
    let points: Vec<&Json> = tests.iter().map(|test| &test["points"]).collect();
    assert_eq!(points, [0, 1, 0]);
    for test in tests {
        check(
            test,
            &[
                ("name", Json::is_string),
                ("points", Json::is_number),
                ("max_points", Json::is_number),
                ("message", Json::is_string),
            ],
        );
    }
}

#[test]
fn results_of_very_many_cases_are_less_than_a_megabyte() {
    let case = |i: usize| {
        format!(
            r#"{{"id":"{}{i}","algorithm":"bresenham","from":[0,0],"to":[9,{i}]}}"#,
            "long ".repeat(100)
        )
    };
    let cases: Vec<String> = (0..2_000).map(case).collect();
    let results = with_report(&cases.join("\n"), "", |report| {
        let png = vec![7; 499_999];
        let picture = Picture {
            png: &png,
            alternative: "",
        };
        prairielearn(report, Some(&picture), Catalog::of(Lang::ZhCn))
    });
    assert!(results.to_string().len() < 1_000_000);
    assert_eq!(results["images"].as_array().map(Vec::len), Some(1));
    let message = results["message"].as_str().unwrap();
    assert!(
        message.contains("1,800") || message.contains("1800"),
        "{message}"
    );
}

/// https://gradescope-autograders.readthedocs.io/en/latest/specs/: `score` of all, `tests` with `status` and `output`.
#[test]
fn gradescope_reads_its_results() {
    let results = with_report(CASES, ANSWERS, |report| {
        gradescope(report, Catalog::of(Lang::En))
    });
    check(
        &results,
        &[
            ("score", Json::is_number),
            ("output", Json::is_string),
            ("tests", Json::is_array),
        ],
    );
    assert_eq!(results["score"], 1);
    let tests = results["tests"].as_array().unwrap();
    let status: Vec<&Json> = tests.iter().map(|test| &test["status"]).collect();
    assert_eq!(status, ["failed", "passed", "failed"]);
    for test in tests {
        check(
            test,
            &[
                ("name", Json::is_string),
                ("status", |json| *json == "passed" || *json == "failed"),
                ("output", Json::is_string),
            ],
        );
    }
    let right = traced(CASES, Detail::Answers);
    let all = with_report(CASES, &right, |report| {
        gradescope(report, Catalog::of(Lang::En))
    });
    assert_eq!(
        (&all["score"], all["tests"][0]["status"].clone()),
        (&json!(2), json!("passed"))
    );
}
