//! Cases of the way to the screen.

use serde_json::{Value as Json, json};

use super::asked::{answer, line, refusal};

const POINT: &str = r#""point":[1,1,1]"#;
const MODEL: &str = r#""model":[[1.5,0,0,2],[0,1.5,0,1.5],[0,0,1.5,0.5],[0,0,0,1]]"#;
const CAMERA: &str = r#""camera":{"position":[-1.9,1,4.2],"target":[0.5,1,1],"up":[0,1,0],"fov_y_deg":90,"aspect":1.6,"near":2,"far":10}"#;
const SIZE: &str = r#""size":[640,400]"#;

fn case_of(fields: &[&str]) -> String {
    line("viewing-pipeline", &fields.join(","))
}

fn pipeline(fields: &[&str]) -> Json {
    answer(&case_of(fields))
}

#[test]
fn a_vertex_has_a_place_in_every_space() {
    let found = pipeline(&[POINT, MODEL, CAMERA, SIZE]);
    let expected = json!({
        "world": [3.5, 3.0, 2.0],
        "view": [3.0, 2.0, -5.0],
        "clip": [1.875, 2.0, 2.5, 5.0],
        "inside": true,
        "ndc": [0.375, 0.4, 0.5],
        "screen": [440.0, 120.0],
    });
    assert_eq!(found["output"], expected);
    let events: Vec<&str> = found["events"]
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|event| event["event"].as_str())
        .collect();
    assert_eq!(events[..10], ["row"; 10]);
    assert_eq!(events[10..], ["test", "divide", "screen"]);
    assert_eq!(found["counts"]["div"], 3);
}

#[test]
fn what_is_not_before_the_eye_has_no_place_on_the_screen() {
    let behind = r#""point":[-5,1,9]"#;
    let found = pipeline(&[behind, CAMERA, SIZE]);
    let output = found["output"].as_object().expect("an object");
    assert_eq!(output["world"], json!([-5.0, 1.0, 9.0]), "no model");
    assert_eq!(output["inside"], false);
    assert!(!output.contains_key("ndc") && !output.contains_key("screen"));
    let parallel = CAMERA.replace(r#""fov_y_deg":90"#, r#""height":8"#);
    let found = pipeline(&[behind, &parallel, SIZE]);
    assert_eq!(found["output"]["clip"][3], 1.0);
    assert!(found["output"]["screen"].is_array());
}

#[test]
fn a_pipeline_that_is_none_is_refused_where_it_is_wrong() {
    let with = |old: &str, new: &str| {
        let fields = [POINT, MODEL, CAMERA, SIZE].map(|field| field.replace(old, new));
        let fields: Vec<&str> = fields.iter().map(String::as_str).collect();
        refusal(&case_of(&fields))
    };
    for (old, new, code, field) in [
        ("[0,0,0,1]]", "[0,0,1,1]]", "degenerate", "model[3]"),
        ("[0,0,0,1]]", "[0,0,1]]", "wrong-length", "model[3]"),
        ("[0.5,1,1]", "[-1.9,1,4.2]", "degenerate", "camera.target"),
        (
            r#""up":[0,1,0]"#,
            r#""up":[0,0,0]"#,
            "degenerate",
            "camera.up",
        ),
        (":90", ":180", "degenerate", "camera.fov_y_deg"),
        (r#""near":2"#, r#""near":0"#, "degenerate", "camera.near"),
        (r#""far":10"#, r#""far":2"#, "degenerate", "camera.far"),
        (r#""up":[0,1,0],"#, "", "missing-field", "camera.up"),
        (r#""near":2"#, r#""nera":2"#, "unknown-field", "camera.nera"),
        ("[640,400]", "[640,0]", "degenerate", "size[1]"),
        ("[640,400]", "[640.5,400]", "wrong-type", "size[0]"),
        ("[640,400]", "[4097,400]", "too-large", "size[0]"),
        ("[1,1,1]", "[1,1e999,1]", "not-finite", "point[1]"),
    ] {
        assert_eq!(with(old, new), [code, field], "{old} → {new}");
    }
    let singular = pipeline(&[
        POINT,
        r#""model":[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,1]]"#,
        CAMERA,
        SIZE,
    ]);
    assert_eq!(singular["output"]["world"], json!([0.0, 0.0, 0.0]));
}

fn drawn(from: &str, to: &str) -> String {
    line("bresenham", &format!(r#""from":{from},"to":{to}"#))
}

#[test]
fn a_line_has_its_pixels_in_both_directions() {
    let found = answer(&drawn("[0,0]", "[4,2]"));
    let pixels = json!([[0, 0], [1, 0], [2, 1], [3, 1], [4, 2]]);
    assert_eq!(found["output"], json!({ "pixels": pixels }));
    let events = found["events"].as_array().expect("a list");
    assert_eq!(
        events[1],
        json!({"event": "pixel", "at": [1, 0], "diagonal": false, "error": 4})
    );
    let mut back = answer(&drawn("[4,2]", "[0.0,0e3]"))["output"]["pixels"].clone();
    back.as_array_mut().expect("a list").reverse();
    assert_eq!(back, pixels);
    let point = answer(&drawn(
        "[-7,9223372036854775807]",
        "[-7,9223372036854775807]",
    ));
    assert_eq!(point["output"]["pixels"], json!([[-7, i64::MAX]]));
}

#[test]
fn a_line_that_is_none_is_refused() {
    for (to, code, field) in [
        ("[65536,0]", "too-large", "to"),
        ("[0,-65536]", "too-large", "to"),
        ("[1e30,0]", "too-large", "to[0]"),
        ("[0.5,0]", "wrong-type", "to[0]"),
        ("[0]", "wrong-length", "to"),
        ("[0,1e999]", "not-finite", "to[1]"),
        (r#"[0,"1"]"#, "wrong-type", "to[1]"),
    ] {
        assert_eq!(refusal(&drawn("[0,0]", to)), [code, field], "{to}");
    }
    let longest = answer(&drawn("[0,0]", "[65535,7]"));
    let pixels = longest["output"]["pixels"].as_array().expect("a list");
    assert_eq!(pixels.len(), 65_536);
}
