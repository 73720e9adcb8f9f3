//! What a program can get wrong, one answer each.

use std::io::{self, Read};

use clipscope::{
    case::Detail,
    grade::{Options, Tolerance},
};
use serde_json::{Value as Json, json};

use super::{graded, reports_of, traced};

/// Two cuts; a segment that is not visible; one that is refused.
const CASES: &str = r#"{"id":1,"algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-2,-1,2,1.5]}
{"id":2,"algorithm":"cohen-sutherland","window":[-1,-1,1,1],"segment":[-2,2,2,2]}
{"id":3,"algorithm":"cohen-sutherland","window":[1,1,1,1],"segment":[0,0,2,2]}"#;

const FIRST: &str = r#"{"id":1,"output":{"visible":true,"segment":[-1,-0.375,1,0.875]}}"#;
const SECOND: &str = r#"{"id":2,"output":{"visible":false,"segment":null}}"#;
const THIRD: &str = r#"{"id":3,"error":"empty"}"#;

fn first_wrong(answers: &[&str]) -> Json {
    let report = graded(CASES, &answers.join("\n"));
    report["wrong"][0].clone()
}

#[test]
fn answers_are_right_however_they_are_written() {
    let spaced = r#"{ "output" : { "segment": [ -1.0, -3.75e-1, 1, 0.8750000000001 ], "visible": true, "note": "" }, "counts": 0, "id": 1 }"#;
    let mut twice = FIRST.to_owned();
    twice.insert_str(1, r#""id":9,"#);
    for answers in [
        format!("{FIRST}\n{SECOND}\n{THIRD}"),
        format!("\u{feff}{FIRST}\r\n{SECOND}\r\n\r\n{THIRD}\r\n"),
        format!("{THIRD}\n{FIRST}\n{SECOND}"),
        format!("{spaced}\n{SECOND}\n{THIRD}"),
        format!("{twice}\n{SECOND}\n{THIRD}"),
        // One that says no id stands in its place.
        format!("{}\n{SECOND}\n{THIRD}", FIRST.replace("\"id\":1,", "")),
        format!(
            "{}\n{SECOND}\n{THIRD}",
            FIRST.replace("\"id\":1,", "\"id\":null,\"error\":null,")
        ),
    ] {
        let report = graded(CASES, &answers);
        assert_eq!(
            report,
            json!({"version": 1, "cases": 3, "right": 3, "wrong": []}),
            "{answers}"
        );
    }
}

#[test]
fn each_difference_has_its_kind_and_its_sentence() {
    let first = |output: &str| format!(r#"{{"id":1,"output":{output}}}"#);
    let rows: [(String, &str, &str); 14] = [
        (
            first(r#"{"visible":true,"segment":[-1,-0.376,1,0.875]}"#),
            "output",
            "segment[1] is -0.375; the program says -0.376.",
        ),
        (
            first(r#"{"visible":true,"segment":[1,0.875,-1,-0.375]}"#),
            "output",
            "segment[0] is -1.0; the program says 1.",
        ),
        (
            first(r#"{"visible":true,"segment":[-1,-0.375,1]}"#),
            "output",
            "The answer lacks segment[3], which is 0.875.",
        ),
        (
            first(r#"{"visible":true}"#),
            "output",
            "The answer lacks segment",
        ),
        (
            first(r#"{"visible":1,"segment":[-1,-0.375,1,0.875]}"#),
            "output",
            "visible is true; the program says 1.",
        ),
        (first("null"), "output", "output is"),
        (
            first(r#"{"visible":true,"segment":[-1,1e999,1,0.875]}"#),
            "output",
            "output is",
        ),
        (r#"{"id":1}"#.into(), "output", "The answer lacks output"),
        (
            r#"{"id":1,"error":{"code":"degenerate"}}"#.into(),
            "refused",
            "The program refuses this case",
        ),
        (
            first(r#"{"visible":true,"segment":[-1,NaN,1,0.875]}"#),
            "bad-json",
            "Line 1 of the answers cannot be read.",
        ),
        (
            r#"{"id":1,"output":{"visible":tr"#.into(),
            "bad-json",
            "Line 1 of the answers cannot be read.",
        ),
        (
            "Traceback (most recent call last):".into(),
            "bad-json",
            "see column 1",
        ),
        ("[1]".into(), "bad-json", "not an object"),
        (
            r#"{"id":9,"output":null}"#.into(),
            "missing",
            "The program gives no answer",
        ),
    ];
    for (answer, kind, sentence) in rows {
        let wrong = first_wrong(&[&answer, SECOND, THIRD]);
        assert_eq!(wrong["kind"], kind, "{answer}");
        assert_eq!(
            (&wrong["id"], &wrong["line"]),
            (&json!(1), &json!(1)),
            "{answer}"
        );
        assert_eq!(wrong["step"], Json::Null);
        let said = wrong["message"].as_str().unwrap();
        assert!(said.contains(sentence), "{answer}: {said}");
    }
    let wrong = first_wrong(&[
        FIRST,
        SECOND,
        r#"{"id":3,"output":{"visible":false,"segment":null}}"#,
    ]);
    assert_eq!(
        (&wrong["kind"], &wrong["true"]["error"]["code"]),
        (&json!("refused"), &json!("empty-window"))
    );
}

#[test]
fn an_answer_to_no_case_is_named_and_takes_no_point() {
    for extra in [FIRST, r#"{"id":"x","output":{}}"#, r#"{"output":{}}"#] {
        let report = graded(CASES, &[FIRST, SECOND, THIRD, extra].join("\n"));
        assert_eq!((&report["right"], &report["cases"]), (&json!(3), &json!(3)));
        assert_eq!(report["wrong"][0]["kind"], "extra");
        assert_eq!(report["wrong"][0]["line"], 4);
    }
}

#[test]
fn lines_between_the_answers_are_named_and_the_answers_count() {
    let report = graded(
        CASES,
        &["start", FIRST, "debug", SECOND, THIRD, "end"].join("\n"),
    );
    assert_eq!(report["right"], 3);
    let wrong = report["wrong"].as_array().unwrap();
    let lines: Vec<&Json> = wrong.iter().map(|wrong| &wrong["line"]).collect();
    assert_eq!(lines, [1, 3, 6]);
    assert!(
        wrong
            .iter()
            .all(|wrong| wrong["kind"] == "bad-json" && wrong["id"] == Json::Null)
    );
}

#[test]
fn ids_that_come_twice_are_joined_in_their_order() {
    let cases = CASES.replace("\"id\":2", "\"id\":1");
    let second = SECOND.replace("\"id\":2", "\"id\":1");
    assert_eq!(
        graded(&cases, &[FIRST, &second, THIRD].join("\n"))["right"],
        3
    );
    let without = CASES
        .replace("\"id\":1,", "")
        .replace("\"id\":2,", "")
        .replace("\"id\":3,", "");
    // Whatever answers call themselves: cases without ids are joined by their order.
    assert_eq!(
        graded(&without, &[FIRST, SECOND, THIRD].join("\n"))["right"],
        3
    );
    assert_eq!(
        graded(&without, &[SECOND, FIRST, THIRD].join("\n"))["right"],
        1
    );
}

#[test]
fn a_program_that_is_silent_or_stops_is_told_what_is_missing() {
    for (answers, right) in [("", 0), ("\n\n", 0), (FIRST, 1)] {
        let report = graded(CASES, answers);
        assert_eq!(
            (report["right"].as_u64(), report["cases"].as_u64()),
            (Some(right), Some(3))
        );
        let wrong = report["wrong"].as_array().unwrap();
        assert!(
            wrong.iter().all(|wrong| wrong["kind"] == "missing"),
            "{wrong:?}"
        );
    }
    let cut = format!("{FIRST}\n{}", &SECOND[..20]);
    assert_eq!(graded(CASES, &cut)["wrong"][0]["kind"], "bad-json");
    let empty = graded("", "");
    assert_eq!(
        empty,
        json!({"version": 1, "cases": 0, "right": 0, "wrong": []})
    );
}

#[test]
fn a_line_of_a_gigabyte_is_skipped_and_the_rest_is_read() {
    let noise = io::repeat(b'x').take(1 << 30);
    let rest = format!("\n{SECOND}\n{THIRD}");
    let answers = noise.chain(rest.as_bytes());
    let report: Json =
        serde_json::from_str(&reports_of(CASES.as_bytes(), answers, Options::default())).unwrap();
    assert_eq!(report["right"], 2);
    assert_eq!(report["wrong"][0]["kind"], "bad-json");
    assert!(
        report["wrong"][0]["message"]
            .as_str()
            .unwrap()
            .contains("64 MiB")
    );
}

#[test]
fn numbers_agree_as_far_as_they_have_to() {
    let answer = FIRST.replace("-0.375", "-0.3751");
    for (tolerance, right) in [(1e-9, 2), (0.001, 3), (0.0, 2)] {
        let tolerance = Tolerance::new(tolerance).unwrap();
        let options = Options {
            tolerance,
            ..Options::default()
        };
        let answers = [&answer, SECOND, THIRD].join("\n");
        let report: Json =
            serde_json::from_str(&reports_of(CASES.as_bytes(), answers.as_bytes(), options))
                .unwrap();
        assert_eq!(report["right"], right, "{tolerance:?}");
    }
    assert!(Tolerance::new(f64::NAN).is_none() && Tolerance::new(-1.0).is_none());
}

/// The true events of the first case, of these kinds.
fn events(kinds: &[&str]) -> Vec<Json> {
    let answer: Json =
        serde_json::from_str(traced(CASES, Detail::Steps).lines().next().unwrap()).unwrap();
    let all = answer["events"].as_array().unwrap().iter();
    let is_kept = |event: &&Json| kinds.contains(&event["event"].as_str().unwrap());
    all.filter(is_kept).cloned().collect()
}

fn with_events(events: &[Json]) -> String {
    let mut answer: Json = serde_json::from_str(FIRST).unwrap();
    answer["events"] = json!(events);
    answer.to_string()
}

#[test]
fn the_first_step_that_differs_is_found_among_the_kinds_that_are_told() {
    let cuts = events(&["cut", "accept"]);
    assert_eq!(cuts.len(), 3);
    let changed = |i: usize, field: &str, value: Json| {
        let mut events = cuts.clone();
        events[i][field] = value;
        events
    };
    let swapped = vec![cuts[1].clone(), cuts[0].clone(), cuts[2].clone()];
    let mut long = cuts.clone();
    long.push(cuts[0].clone());
    let rows: [(Vec<Json>, usize, &str); 8] = [
        (
            changed(1, "to", json!([1, 0.9])),
            2,
            "Step 2, “cut”, is the first that differs: to[1] is 0.9, and 0.875 is true.",
        ),
        (
            changed(0, "edge", json!("top")),
            1,
            "edge is \"top\", and \"left\" is true.",
        ),
        (
            changed(0, "colour", json!("red")),
            1,
            "such an event has no colour",
        ),
        (swapped, 1, "Steps 1 and 2 change places"),
        (cuts[..2].to_vec(), 3, ""),
        (long, 4, "is one too many"),
        (vec![json!(7)], 1, "Step 1 is no event"),
        (
            changed(2, "event", json!("accpet")),
            3,
            "“accpet”, is one too many",
        ),
    ];
    for (events, step, sentence) in rows {
        let wrong = first_wrong(&[&with_events(&events), SECOND, THIRD]);
        // What is never told is not compared.
        if sentence.is_empty() {
            assert_eq!(wrong, Json::Null);
            continue;
        }
        assert_eq!(
            (&wrong["kind"], &wrong["step"]),
            (&json!("event"), &json!(step)),
            "{events:?}"
        );
        let said = wrong["message"].as_str().unwrap();
        assert!(said.contains(sentence), "{said}");
    }
}

#[test]
fn fields_of_an_event_may_be_left_out() {
    let cuts = [
        json!({"event": "cut", "end": "p1"}),
        json!({"event": "cut", "to": [1, 0.875]}),
    ];
    assert_eq!(
        first_wrong(&[&with_events(&cuts), SECOND, THIRD]),
        Json::Null
    );
    let cuts = [json!({"event": "cut", "end": "p1"})];
    let wrong = first_wrong(&[&with_events(&cuts), SECOND, THIRD]);
    assert_eq!(
        wrong["message"],
        "The program stops after step 1: “cut” comes next."
    );
    assert_eq!(
        (&wrong["said"], &wrong["true"]["event"]),
        (&Json::Null, &json!("cut"))
    );
}

#[test]
fn a_kind_that_is_told_late_counts_from_the_beginning() {
    let cases = [CASES.lines().next().unwrap(), CASES.lines().next().unwrap()].join("\n");
    let some = with_events(&events(&["cut"]));
    let all = with_events(&events(&["cut", "accept"]));
    assert_eq!(graded(&cases, &[&*some, &*some].join("\n"))["right"], 2);
    for answers in [[&*some, &*all], [&*all, &*some]] {
        let report = graded(&cases, &answers.join("\n"));
        assert_eq!(report["right"], 1);
        assert_eq!(report["wrong"][0]["step"], 3);
        assert_eq!(report["wrong"][0]["true"]["event"], "accept");
    }
}

#[test]
fn rings_agree_wherever_they_start_and_in_any_order() {
    let case = r#"{"id":1,"algorithm":"weiler-atherton","window":[0,-2,4,0.5],"polygon":[[0,3],[0,-1],[1,-1],[1,1],[3,1],[3,-1],[4,-1],[4,3]]}"#;
    let answer: Json = serde_json::from_str(&traced(case, Detail::Answers)).unwrap();
    let rings = answer["output"]["polygons"].as_array().unwrap().clone();
    assert_eq!(rings.len(), 2);
    let said = |rings: &[Json]| json!({"id": 1, "output": {"polygons": rings}}).to_string();
    let mut turned = rings.clone();
    turned.reverse();
    for ring in &mut turned {
        ring.as_array_mut().unwrap().rotate_left(1);
    }
    assert_eq!(graded(case, &said(&turned))["right"], 1);
    let mut backwards = rings.clone();
    backwards[0].as_array_mut().unwrap().reverse();
    let mut doubled = rings.clone();
    doubled.push(rings[0].clone());
    for wrong in [backwards, doubled, Vec::new()] {
        assert_eq!(graded(case, &said(&wrong))["wrong"][0]["kind"], "output");
    }
}

#[test]
fn texture_goes_with_its_vertex() {
    let case = r#"{"algorithm":"sutherland-hodgman","window":[-1,-1,1,1],"polygon":[[0,0],[2,0],[0,2]],"uv":[[0,0],[1,0],[0,1]]}"#;
    let answer: Json = serde_json::from_str(&traced(case, Detail::Answers)).unwrap();
    let turned = |fields: &[&str]| {
        let mut answer = answer.clone();
        for field in fields {
            answer["output"][*field][0]
                .as_array_mut()
                .unwrap()
                .rotate_left(1);
        }
        graded(case, &answer.to_string())["right"].as_u64()
    };
    assert_eq!(turned(&["polygons", "uv"]), Some(1));
    assert_eq!(turned(&["polygons"]), Some(0));
}

#[test]
fn any_valid_order_of_painting_will_do() {
    let apart = "[[[-3,-1,-3],[-2,-1,-3],[-2,1,-3]],[[2,-1,-5],[3,-1,-5],[2,1,-5]],[[-6,-2,-6],[-4,-2,-6],[-4,2,-6]]]";
    let case = format!(
        r#"{{"algorithm":"painter","size":[8,8],"frustum":{{"fov_y_deg":90,"aspect":1,"near":1,"far":10}},"triangles":{apart}}}"#
    );
    let answer: Json = serde_json::from_str(&traced(&case, Detail::Answers)).unwrap();
    for (order, right) in [
        ([2, 1, 0], 1),
        ([1, 2, 0], 1),
        ([2, 0, 1], 1),
        ([0, 1, 2], 0),
        ([2, 2, 0], 0),
    ] {
        let mut answer = answer.clone();
        answer["output"]["order"] = json!(order);
        assert_eq!(
            graded(&case, &answer.to_string())["right"],
            right,
            "{order:?}"
        );
    }
}
