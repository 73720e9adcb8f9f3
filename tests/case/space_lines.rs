//! Cases of segments in space.

use clipscope::{case::Format, text::Lang};
use serde_json::{Value as Json, json};

use super::asked::{answer, answers, line, output, refusal, style};

const UNIT: &str = r#""box":[-1,-1,-1,1,1,1]"#;
const BOTH: [&str; 2] = ["cohen-sutherland-3d", "liang-barsky-3d"];

#[test]
fn a_box_shows_a_part_a_touch_or_nothing() {
    for (segment, visible) in [
        ("[-2,-1,0,2,1,0]", json!([-1.0, -0.5, 0.0, 1.0, 0.5, 0.0])),
        ("[0,0,0,0.5,0.5,0.5]", json!([0.0, 0.0, 0.0, 0.5, 0.5, 0.5])),
        ("[-2,0,0,0,0,2]", json!([-1.0, 0.0, 1.0, -1.0, 0.0, 1.0])),
        ("[1,1,1,1,1,1]", json!([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])),
        ("[-2,0,0,0,0,2.5]", Json::Null),
        ("[2,0,0,2,0,0]", Json::Null),
    ] {
        let expected = json!({"visible": !visible.is_null(), "segment": visible});
        for id in BOTH {
            let found = output(id, &format!(r#"{UNIT},"segment":{segment}"#));
            assert_eq!(found, expected, "{id} of {segment}");
        }
    }
}

#[test]
fn codes_are_written_far_near_top_bottom_right_left_and_the_lowest_bit_is_cut_first() {
    let fields = format!(r#"{UNIT},"segment":[-2,-1.5,3,4,2,-3]"#);
    let answer = answer(&line(BOTH[0], &fields));
    let events = answer["events"].as_array().expect("steps");
    let codes: Vec<&Json> = events.iter().filter(|e| e["event"] == "code").collect();
    assert_eq!(codes[0]["code"], "100101", "beyond far, bottom and left");
    assert_eq!(codes[1]["code"], "011010", "beyond near, top and right");
    let sides = events.iter().filter(|e| e["event"] == "choose");
    let sides: Vec<&Json> = sides.map(|e| &e["side"]).collect();
    assert_eq!(sides[..2], ["left", "right"]);
}

#[test]
fn planes_are_asked_in_order_and_any_normal_will_do() {
    let wedge = r#""planes":[[3,4,0,5],[-1,-1,-1,4]]"#;
    let found = output(
        "plane-line",
        &format!(r#"{wedge},"segment":[-5,0,0,5,0,0]"#),
    );
    let part = [-5.0 / 3.0, 0.0, 0.0, 4.0, 0.0, 0.0];
    assert_eq!(found, json!({"visible": true, "segment": part}));
    let found = output("plane-line", &format!(r#"{wedge},"segment":[5,5,5,9,9,9]"#));
    assert_eq!(found, json!({"visible": false, "segment": null}));
    let answer = answer(&line(
        "plane-line",
        &format!(r#"{wedge},"segment":[-5,0,0,5,0,0]"#),
    ));
    let rows = answer["events"].as_array().expect("steps").iter();
    let rows: Vec<&Json> = rows.filter(|e| e["event"] == "row").collect();
    assert_eq!(
        (&rows[0]["plane"], &rows[1]["plane"]),
        (&json!(0), &json!(1))
    );
    assert_eq!(
        (&rows[0]["q"], &rows[0]["p"]),
        (&json!(-10.0), &json!(-30.0))
    );
}

#[test]
fn clip_space_is_cut_before_the_divide() {
    for (segment, visible) in [
        (
            "[1,0,0,2,2,0,0,-1]",
            json!([1.0, 0.0, 0.0, 2.0, 1.25, 0.0, 0.0, 1.25]),
        ),
        (
            "[0,0,0,1,0,0,0,2]",
            json!([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0]),
        ),
        // Through the eye.
        (
            "[0,0,0,1,0,0,0,-1]",
            json!([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]),
        ),
        ("[0,0,0,-1,1,0,0,-2]", Json::Null),
        ("[3,0,0,1,3,0,0,2]", Json::Null),
    ] {
        let found = output("homogeneous-line", &format!(r#""segment":{segment}"#));
        let expected = json!({"visible": !visible.is_null(), "segment": visible});
        assert_eq!(found, expected, "{segment}");
    }
}

#[test]
fn refusals_name_code_and_field() {
    let box_of = |bounds: &str| format!(r#""box":{bounds},"segment":[0,0,0,1,1,1]"#);
    let in_unit = |segment: &str| format!(r#"{UNIT},"segment":{segment}"#);
    for (id, fields, code, field) in [
        (BOTH[0], box_of("[0,0,0,1,1]"), "wrong-length", "box"),
        (BOTH[0], box_of("[0,0,0,1,0,1]"), "empty-window", "box"),
        (BOTH[1], box_of("[0,0,2,1,1,1]"), "empty-window", "box"),
        (BOTH[1], box_of("[0,0,1e999,1,1,1]"), "not-finite", "box[2]"),
        (BOTH[1], in_unit("[0,0,0,1,1]"), "wrong-length", "segment"),
        (
            BOTH[0],
            in_unit("[0,0,0,1,1,null]"),
            "wrong-type",
            "segment[5]",
        ),
        (BOTH[0], UNIT.to_owned(), "missing-field", "segment"),
        (
            "plane-line",
            r#""planes":[[1,0,0,0],[0,0,0,1]],"segment":[0,0,0,1,1,1]"#.to_owned(),
            "degenerate",
            "planes[1]",
        ),
        (
            "plane-line",
            r#""planes":[],"segment":[0,0,0,1,1,1]"#.to_owned(),
            "wrong-length",
            "planes",
        ),
        (
            "homogeneous-line",
            r#""segment":[1,0,0,1,0,0,0,0]"#.to_owned(),
            "degenerate",
            "segment",
        ),
        (
            "homogeneous-line",
            r#""segment":[1,0,0,1,0,0],"w":1"#.to_owned(),
            "unknown-field",
            "w",
        ),
    ] {
        assert_eq!(refusal(&line(id, &fields)), [code, field], "{id} {fields}");
    }
}

#[test]
fn answer_keys_say_every_step() {
    let cases = [
        (BOTH[0], format!(r#"{UNIT},"segment":[-2,-1.5,3,4,2,-3]"#)),
        (BOTH[1], format!(r#"{UNIT},"segment":[-2,0,0,0,0,2]"#)),
        (
            "plane-line",
            r#""planes":[[3,4,0,5]],"segment":[-5,0,0,5,0,0]"#.to_owned(),
        ),
        (
            "homogeneous-line",
            r#""segment":[1,0,0,2,2,0,0,-1]"#.to_owned(),
        ),
    ];
    for (id, fields) in cases {
        for format in [Format::Text, Format::Markdown] {
            let key = answers(&line(id, &fields), style(format, Lang::En));
            assert!(!key.contains('⟦') && key.lines().count() > 10, "{key}");
        }
    }
}
