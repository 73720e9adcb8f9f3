//! Cases of the polygons lab.

use clipscope::{
    case::{Format, Solver, Solvers},
    text::Lang,
};
use serde_json::{Value as Json, json};

use super::asked::{
    JSON, answer, answer_alone, answers, line, lines_are_at_most_a_hundred_columns_wide, output,
    refusal, refusal_said, reports_are_as_they_were, steps_are_all_that_is_left_out, style,
};

/// Those that take a polygon.
fn polygon_solvers() -> impl Iterator<Item = &'static Solver> {
    Solvers::standard()
        .iter()
        .filter(|solver| takes(solver, "polygon"))
}

fn takes(solver: &Solver, name: &str) -> bool {
    solver.fields.iter().any(|field| field.name == name)
}

/// A case that every one of them takes.
fn case_of(solver: &Solver, polygon: &str) -> String {
    let window = if takes(solver, "window") {
        r#""window":[-1,-1,1,1],"#
    } else {
        ""
    };
    let id = solver.card.id;
    format!(r#"{{"id":"{id}","algorithm":"{id}",{window}"polygon":{polygon}}}"#)
}

const TRIANGLE: &str = "[[0,0],[2,0],[0,2]]";
/// Two teeth of a comb reach into the window above y = 3.
const COMB: &str =
    r#""window":[-1,3,6,5],"polygon":[[0,0],[5,0],[5,4],[4,4],[4,2],[1,2],[1,4],[0,4]]"#;

#[test]
fn what_is_left_is_none_one_or_several_polygons() {
    let square = json!([[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]]);
    let fields = format!(r#""window":[-1,-1,1,1],"polygon":{TRIANGLE}"#);
    for id in ["sutherland-hodgman", "sutherland-hodgman-pipeline"] {
        let found = output(id, &fields);
        assert_eq!(found, json!({"polygons": square, "outcome": "cut"}), "{id}");
        let far = output(id, r#""window":[5,5,6,6],"polygon":[[0,0],[2,0],[0,2]]"#);
        assert_eq!(far, json!({"polygons": [], "outcome": "empty"}), "{id}");
        let touching = output(id, r#""window":[2,0,3,1],"polygon":[[0,0],[2,0],[0,2]]"#);
        assert_eq!(
            touching,
            json!({"polygons": [], "outcome": "degenerate"}),
            "{id}"
        );
        let whole = output(id, r#""window":[0,0,3,3],"polygon":[[0,0],[2,0],[0,2]]"#);
        assert_eq!(whole["outcome"], "whole", "{id}");
        let bridged = &output(id, COMB)["polygons"];
        assert_eq!(bridged.as_array().map(Vec::len), Some(1), "{id}");
    }
    let pieces = &output("triangulate-and-clip", COMB)["polygons"];
    assert_eq!(
        *pieces,
        json!([
            [[5.0, 3.0], [5.0, 4.0], [4.0, 4.0], [4.25, 3.0]],
            [[1.0, 3.0], [1.0, 4.0], [0.0, 4.0], [0.5, 3.0]],
            [[4.25, 3.0], [4.0, 4.0], [4.0, 3.0]],
            [[0.5, 3.0], [0.0, 4.0], [0.0, 3.0]]
        ])
    );
}

#[test]
fn outer_rings_run_counter_clockwise_and_holes_clockwise() {
    let teeth = output("weiler-atherton", COMB);
    let expected = json!([
        [[0.0, 3.0], [1.0, 3.0], [1.0, 4.0], [0.0, 4.0]],
        [[4.0, 3.0], [5.0, 3.0], [5.0, 4.0], [4.0, 4.0]]
    ]);
    assert_eq!(sorted(&teeth["polygons"]), sorted(&expected));
    assert_eq!(teeth["relation"], "crossing");
    let frame = output(
        "weiler-atherton",
        r#""clip":[[0,0],[0,9],[9,9],[9,0]],"polygon":[[1,1],[1,5],[5,5],[5,1]],"holes":[[[2,2],[3,2],[3,3],[2,3]]]"#,
    );
    let expected = json!([
        [[1.0, 1.0], [5.0, 1.0], [5.0, 5.0], [1.0, 5.0]],
        [[2.0, 2.0], [2.0, 3.0], [3.0, 3.0], [3.0, 2.0]]
    ]);
    assert_eq!(sorted(&frame["polygons"]), sorted(&expected));
    assert_eq!(frame["relation"], "subject-inside");
}

/// Rings from their lowest vertex on, in order.
fn sorted(rings: &Json) -> Vec<String> {
    let ring = |ring: &Json| {
        let ring = ring.as_array().expect("a ring");
        let text: Vec<String> = ring.iter().map(Json::to_string).collect();
        let first = (0..text.len())
            .min_by_key(|&i| &text[i])
            .expect("not empty");
        [&text[first..], &text[..first]].concat().join(" ")
    };
    let mut rings: Vec<String> = rings.as_array().expect("rings").iter().map(ring).collect();
    rings.sort();
    rings
}

#[test]
fn triangles_are_given_as_corners_and_as_numbers_of_vertices() {
    // Clockwise, with a vertex that is repeated.
    let found = output(
        "ear-clipping",
        r#""polygon":[[0,0],[2,4],[2,4],[4,0],[2,1]]"#,
    );
    let expected = json!({
        "triangles": [[[2.0, 4.0], [0.0, 0.0], [2.0, 1.0]], [[2.0, 1.0], [4.0, 0.0], [2.0, 4.0]]],
        "vertices": [[1, 0, 4], [4, 3, 1]]
    });
    assert_eq!(found, expected);
}

#[test]
fn texture_coordinates_are_interpolated_with_the_vertices() {
    let found = output(
        "sutherland-hodgman",
        r#""window":[-1,-1,1,1],"polygon":[[0,0],[2,0],[0,2]],"uv":[[0,0],[1,0],[0,1]]"#,
    );
    assert_eq!(
        found["uv"],
        json!([[[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]]])
    );
    let outside = output(
        "sutherland-hodgman",
        r#""window":[5,5,6,6],"polygon":[[0,0],[2,0],[0,2]],"uv":[[0,0],[1,0],[0,1]]"#,
    );
    assert_eq!(
        outside,
        json!({"polygons": [], "outcome": "empty", "uv": []})
    );
}

#[test]
fn an_answer_has_the_form_that_was_promised() {
    let case = r#"{"id":7,"algorithm":"ear-clipping","polygon":[[0,0],[4,0],[1,1],[0,4]]}"#;
    assert_eq!(
        answers(case, JSON),
        concat!(
            r#"{"id":7,"algorithm":"ear-clipping","output":{"triangles":[[[0.0,0.0],[4.0,0.0],[1.0,1.0]],"#,
            r#"[[0.0,0.0],[1.0,1.0],[0.0,4.0]]],"vertices":[[0,1,2],[0,2,3]]},"#,
            r#""counts":{"add":35,"mul":14,"div":0,"cmp":10},"events":["#,
            r#"{"event":"classify","vertex_idx":0,"prev_idx":3,"next_idx":1,"double_area":16.0,"corner":"convex"},"#,
            r#"{"event":"classify","vertex_idx":1,"prev_idx":0,"next_idx":2,"double_area":4.0,"corner":"convex"},"#,
            r#"{"event":"classify","vertex_idx":2,"prev_idx":1,"next_idx":3,"double_area":-8.0,"corner":"reflex"},"#,
            r#"{"event":"classify","vertex_idx":3,"prev_idx":2,"next_idx":0,"double_area":4.0,"corner":"convex"},"#,
            r#"{"event":"round","round_idx":0,"n_left":4},{"event":"candidate","triangle":[3,0,1]},"#,
            r#"{"event":"blocked","vertex_idx":0,"by_idx":2,"double_areas":[4.0,4.0,8.0]},"#,
            r#"{"event":"candidate","triangle":[0,1,2]},{"event":"ear","vertex_idx":1},"#,
            r#"{"event":"cut","triangle":[0,1,2],"n_left":3},{"event":"last","triangle":[0,2,3]},"#,
            r#"{"event":"done","n_triangles":2}]}"#,
            "\n"
        )
    );
}

#[test]
fn without_events_the_answer_is_the_same() {
    for solver in polygon_solvers() {
        let case = case_of(solver, "[[0,0],[3,0],[1,1],[0,3]]");
        steps_are_all_that_is_left_out(&case);
    }
}

/// Cases with their codes and places.
fn refused_as(cases: &[(String, &str, &str)]) {
    for (case, code, field) in cases {
        assert_eq!(refusal(case), [*code, *field], "{case:.200}");
    }
}

#[test]
fn a_polygons_mistakes_are_named_with_their_places() {
    let ear = |polygon: &str| line("ear-clipping", &format!(r#""polygon":{polygon}"#));
    let pieces = |clip: &str| {
        line(
            "triangulate-and-clip",
            &format!(r#""clip":{clip},"polygon":{TRIANGLE}"#),
        )
    };
    let many = |n: usize| format!("[{}[0,0]]", "[0,0],".repeat(n - 1));
    refused_as(&[
        (
            line("ear-clipping", r#""window":[0,0,1,1]"#),
            "unknown-field",
            "window",
        ),
        (ear("7"), "wrong-type", "polygon"),
        (ear("[[0,0],[1,0],[1]]"), "wrong-length", "polygon[2]"),
        (
            ear("[[0,0],[1,0],[1,1e999]]"),
            "not-finite",
            "polygon[2][1]",
        ),
        (ear("[[0,0],[1,0]]"), "degenerate", "polygon"),
        (ear("[[0,0],[1,0],[2,0]]"), "degenerate", "polygon[0]"),
        (ear("[[1,1],[1,1],[1,1],[1,1]]"), "degenerate", "polygon[0]"),
        (
            ear("[[5,5],[0,0],[2,2],[2,0],[0,2]]"),
            "self-intersecting",
            "polygon[0]",
        ),
        (
            ear("[[0,0],[2,0],[1,0],[1,1]]"),
            "self-intersecting",
            "polygon[0]",
        ),
        (ear(&many(10_001)), "too-large", "polygon"),
        (pieces("[[0,0],[4,0],[1,1],[0,4]]"), "not-convex", "clip[2]"),
        (pieces("[[0,0],[1,0]]"), "degenerate", "clip"),
    ]);
}

#[test]
fn mistakes_in_holes_and_texture_coordinates_are_too() {
    let sh = |fields: &str| {
        line(
            "sutherland-hodgman",
            &format!(r#""window":[0,0,1,1],{fields}"#),
        )
    };
    let wa = |fields: &str| {
        line(
            "weiler-atherton",
            &format!(r#""window":[0,0,1,1],"polygon":{TRIANGLE},{fields}"#),
        )
    };
    refused_as(&[
        (sh(r#""uv":[]"#), "missing-field", "polygon"),
        (
            line("sutherland-hodgman", r#""polygon":[]"#),
            "missing-field",
            "window",
        ),
        (wa(r#""holes":7"#), "wrong-type", "holes"),
        (wa(r#""holes":[[[0,0],[1,0]]]"#), "degenerate", "holes[0]"),
        (
            wa(r#""holes":[[[0.1,0.1],[0.2,0.1],[0.1,0.2]],[[0,0],[1,0],[1,7]]]"#),
            "self-intersecting",
            "holes[1]",
        ),
        (
            wa(r#""holes":[[[0.1,0.1],[0.5,0.5],[0.5,0.1],[0.1,0.5]]]"#),
            "self-intersecting",
            "holes[0][0]",
        ),
        (
            wa(r#""holes":[[[0,0],[1,"0"],[1,7]]]"#),
            "wrong-type",
            "holes[0][1][1]",
        ),
        (
            line(
                "weiler-atherton",
                &format!(r#""clip":[[0,0],[2,2],[2,0],[0,2]],"polygon":{TRIANGLE}"#),
            ),
            "self-intersecting",
            "clip[0]",
        ),
        (
            sh(&format!(r#""polygon":{TRIANGLE},"uv":[[0,0]]"#)),
            "wrong-length",
            "uv",
        ),
        (
            sh(&format!(r#""polygon":{TRIANGLE},"uv":[[0,0],[1],[0,1]]"#)),
            "wrong-length",
            "uv[1]",
        ),
        (
            sh(&format!(
                r#""polygon":{TRIANGLE},"uv":[[0,0],[1,1e999],[0,1]]"#
            )),
            "not-finite",
            "uv[1][1]",
        ),
    ]);
}

#[test]
fn two_edges_that_meet_are_named() {
    let case = r#"{"algorithm":"ear-clipping","polygon":[[0,0],[2,2],[2,0],[0,2]]}"#;
    let message = answer(case)["error"]["message"].clone();
    let message = message.as_str().expect("a sentence");
    assert!(message.contains("edges 0 and 2"), "{message}");
}

/// A star of `n` vertices around the origin: tips at a distance of 2, valleys at `valley`; the first is a tip, where
/// `turn` is even.
fn star(n: usize, valley: f64, turn: usize) -> String {
    let vertex = |i: usize| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * i as f64 / n as f64);
        let radius = if (i + turn).is_multiple_of(2) {
            2.0
        } else {
            valley
        };
        json!([radius * cos, radius * sin])
    };
    (0..n).map(vertex).collect::<Json>().to_string()
}

#[test]
fn as_much_as_ten_thousand_vertices_against_a_window_is_reported_and_more_answered() {
    let polygon = star(10_000, 1.5, 0);
    for solver in polygon_solvers() {
        let answer = answer_alone(&case_of(solver, &polygon));
        assert!(answer["error"].is_null(), "{}", answer["error"]);
        if takes(solver, "clip") {
            let clip = star(18, 2.0, 0);
            let case = line(
                solver.card.id,
                &format!(r#""clip":{clip},"polygon":{polygon}"#),
            );
            assert_eq!(refusal(&case), ["too-large", "polygon"]);
            let alone = answer_alone(&case);
            assert!(alone["error"].is_null(), "{}", alone["error"]);
        }
    }
}

/// The star of 200,000 vertices goes all around the window; that of two stars, one turned by a tooth, both keep their
/// valleys, and between two of these their edges cross.
#[test]
fn only_a_report_is_limited_and_the_refusal_says_so() {
    let many = star(200_000, 1.5, 0);
    let case = line(
        "sutherland-hodgman",
        &format!(r#""window":[-1,-1,1,1],"polygon":{many}"#),
    );
    let window = json!([[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]]);
    let clipped = answer_alone(&case)["output"]["polygons"].clone();
    assert_eq!(sorted(&clipped), sorted(&window));
    assert_eq!(refusal(&case), ["too-large", "polygon"]);
    for lang in Lang::ALL {
        let text = refusal_said(&case, lang);
        assert!(text.contains("--events false"), "{lang}: {text}");
    }

    let [one, other] = [0, 1].map(|turn| star(3_000, 1.5, turn));
    let case = line(
        "weiler-atherton",
        &format!(r#""clip":{one},"polygon":{other}"#),
    );
    assert_eq!(refusal(&case), ["too-large", "polygon"]);
    let output = &answer_alone(&case)["output"];
    assert_eq!(output["relation"], "crossing");
    let rings = output["polygons"].as_array().expect("rings");
    let n_vertices: Vec<usize> = rings
        .iter()
        .map(|ring| ring.as_array().map_or(0, Vec::len))
        .collect();
    assert_eq!(n_vertices, [2 * 1_500 + 3_000]);
}

/// Whatever is given, there is an answer or a refusal.
#[test]
fn degenerate_polygons_are_answered_or_refused() {
    for polygon in [
        "[[0,0],[0,0],[0,0]]",
        "[[0,0],[1,1],[2,2]]",
        "[[0,0],[1,1],[0,0],[1,1]]",
        "[[0,0],[1,0],[1,1],[1,0]]",
        "[[0,0],[1,0],[1,0],[1,1],[0,0]]",
        "[[-1,-1],[1,-1],[1,1],[-1,1]]",
        "[[1,1],[1,1],[2,2],[2,1]]",
        "[[1e308,0],[-1e308,0],[0,1e308]]",
        "[[5e-324,0],[0,5e-324],[0,0]]",
        "[[-0.0,0],[0,-0.0],[1,1],[0,1]]",
    ] {
        for solver in polygon_solvers() {
            let answer = answer(&case_of(solver, polygon));
            let is_answered = answer["output"].is_object();
            let is_refused = answer["error"]["code"].is_string();
            assert!(is_answered != is_refused, "{polygon}: {answer}");
            for lang in Lang::ALL {
                let report = answers(&case_of(solver, polygon), style(Format::Markdown, lang));
                assert!(!report.contains('⟦'), "{report}");
            }
        }
    }
}

fn reported() -> String {
    polygon_solvers()
        .map(|solver| case_of(solver, "[[0,0],[3,0],[0.75,0.5],[0,3]]") + "\n")
        .collect()
}

#[test]
fn reports_on_polygons_are_as_they_were() {
    let files = [
        ("polygons-en.md", Format::Markdown, Lang::En),
        ("polygons-zh-CN.txt", Format::Text, Lang::ZhCn),
        ("polygons-es.txt", Format::Text, Lang::Es),
        ("polygons-pt-BR.md", Format::Markdown, Lang::PtBr),
        ("polygons-worksheet-en.md", Format::Worksheet, Lang::En),
    ];
    reports_are_as_they_were(&reported(), &files);
}

#[test]
fn a_terminals_lines_fit_it() {
    let polygon = "[[0.123,-1.456],[3.333,0.1],[0.751,0.512],[-1.125,3.2],[-0.3,1.01]]";
    for solver in polygon_solvers() {
        lines_are_at_most_a_hundred_columns_wide(&case_of(solver, polygon));
    }
}
