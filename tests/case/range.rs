//! Numbers as large and as small as there are: an answer is right or the case refused, and none holds a null, a NaN or an infinity.

use clipscope::{
    case::{Format, Solvers},
    text::Lang,
};
use serde_json::{Map, Value as Json, json};

use super::asked::{JSON, answer, answer_alone, answers, line, refusal, style};

/// The powers of two that scale a case.
const POWERS: [i32; 15] = [
    -900, -700, -540, -501, -400, -300, -150, 1, 100, 260, 340, 501, 511, 700, 900,
];

/// Ordinary cases, at least one of each algorithm that takes real numbers.
const CASES: [(&str, &str); 35] = [
    ("brute-force", WINDOW_AND_SEGMENT),
    ("cohen-sutherland", WINDOW_AND_SEGMENT),
    ("liang-barsky", WINDOW_AND_SEGMENT),
    ("nicholl-lee-nicholl", WINDOW_AND_SEGMENT),
    ("cyrus-beck", WINDOW_AND_SEGMENT),
    (
        "cyrus-beck",
        r#""clip":[[0,-1.3],[1.7,0.2],[0.4,1.9],[-1,0.3]],"segment":[-2.1,-0.7,1.9,1.1]"#,
    ),
    ("sutherland-hodgman", WINDOW_AND_POLYGON),
    (
        "sutherland-hodgman",
        r#""window":[-1,-0.7,1,1.1],"polygon":[[-2.5,0.2],[1.9,-1.4],[0.3,1.7]],"uv":[[0,0],[1,0.25],[0.5,1]]"#,
    ),
    ("sutherland-hodgman", CLIP_AND_POLYGON),
    ("sutherland-hodgman-pipeline", WINDOW_AND_POLYGON),
    ("sutherland-hodgman-pipeline", CLIP_AND_POLYGON),
    ("weiler-atherton", WINDOW_AND_POLYGON),
    ("weiler-atherton", CLIP_AND_POLYGON),
    (
        "weiler-atherton",
        r#""clip":[[0,0],[4,0.1],[4.2,3],[2,1.3],[0.1,3.2]],"polygon":[[-1,0.7],[5,0.9],[5.1,2.3],[-1.2,2.1]],"holes":[[[1,1.1],[1.5,1.2],[1.3,1.6]]]"#,
    ),
    (
        "ear-clipping",
        r#""polygon":[[0,0],[4,0.1],[4.3,3.9],[2,1.3],[0.1,4.2]]"#,
    ),
    ("triangulate-and-clip", WINDOW_AND_POLYGON),
    (
        "point-planes",
        r#""planes":[[1,0,0,0.3],[0.3,-0.7,0.2,1.1]],"point":[0.7,0.4,-0.9]"#,
    ),
    (
        "sphere-cull",
        r#""planes":[[1,0,0,0.3],[0.3,-0.7,0.2,1.1]],"sphere":[0.7,0.4,-0.9,0.6]"#,
    ),
    (
        "sphere-cull",
        r#""frustum":{"fov_y_deg":70,"aspect":1.6,"near":1.1,"far":9.3},"sphere":[0.7,0.4,-3.9,1.6]"#,
    ),
    (
        "box-cull",
        r#""planes":[[1,0,0,0.3],[0.3,-0.7,0.2,1.1]],"box":[-0.7,0.4,-0.9,1.2,0.9,2.3]"#,
    ),
    (
        "box-cull",
        r#""frustum":{"fov_y_deg":70,"aspect":1.6,"near":1.1,"far":9.3},"box":[2.7,0.4,-9.9,6.2,0.9,-0.3]"#,
    ),
    (
        "back-face",
        r#""triangle":[[0.1,0,0.2],[1.3,0.1,0],[0,1.7,0.4]],"eye":[0.3,0.4,5.1]"#,
    ),
    (
        "back-face",
        r#""triangle":[[0.1,0,0.2],[1.3,0.1,0],[0,1.7,0.4]],"view_dir":[0.3,0.4,0.7]"#,
    ),
    ("cohen-sutherland-3d", BOX_AND_SEGMENT),
    ("liang-barsky-3d", BOX_AND_SEGMENT),
    (
        "plane-line",
        r#""planes":[[1,0,0,0.3],[0.3,-0.7,0.2,1.1]],"segment":[-1.7,0.4,-0.9,2.2,0.9,2.3]"#,
    ),
    (
        "homogeneous-line",
        r#""segment":[0.3,-0.2,0.9,1.1,3.2,0.7,-0.4,2.3]"#,
    ),
    ("plane-at-a-time", PLANES_AND_TRIANGLE),
    ("intersection-polygon", PLANES_AND_TRIANGLE),
    (
        "homogeneous-triangle",
        r#""triangle":[[0.3,-0.2,0.9,1.1],[3.2,0.7,-0.4,2.3],[-0.7,1.2,0.3,-0.6]]"#,
    ),
    (
        "viewing-pipeline",
        r#""point":[1,1.3,0.7],"model":[[1.5,0,0,2],[0,1.5,0,1.5],[0,0,1.5,0.5],[0,0,0,1]],"camera":{"position":[-1.9,1,4.2],"target":[0.5,1,1],"up":[0,1,0],"fov_y_deg":80,"aspect":1.6,"near":2,"far":10},"size":[640,400]"#,
    ),
    ("depth-buffer", SURFACES),
    ("ray-casting", SURFACES),
    ("painter", SURFACES),
    ("bsp", SURFACES),
];

const WINDOW_AND_SEGMENT: &str = r#""window":[-1,-0.7,1,1.1],"segment":[-2.1,-0.9,1.9,1.3]"#;
const WINDOW_AND_POLYGON: &str =
    r#""window":[-1,-0.7,1,1.1],"polygon":[[-2.5,0.2],[1.9,-1.4],[0.3,1.7]]"#;
const CLIP_AND_POLYGON: &str =
    r#""clip":[[0,-1.3],[1.7,0.2],[0.4,1.9],[-1,0.3]],"polygon":[[-2.5,0.2],[1.9,-1.4],[0.3,1.7]]"#;
const BOX_AND_SEGMENT: &str =
    r#""box":[-1,-0.7,-2,1,1.1,0.4],"segment":[-2.1,-0.9,-1.3,1.9,1.3,0.9]"#;
const PLANES_AND_TRIANGLE: &str = r#""planes":[[1,0,0,0.3],[0.3,-0.7,0.2,1.1],[0,0,-1,0.9]],"triangle":[[-1.1,0.2,0.4],[1.9,-0.4,1.3],[0.3,2.7,-0.6]]"#;
const SURFACES: &str = r#""size":[6,5],"frustum":{"fov_y_deg":70,"aspect":1.6,"near":1.1,"far":9.3},"triangles":[[[-3,-2,-4],[3.3,-1.7,-5],[0.2,2.9,-3.1]],[[-2,2.3,-3.9],[-2.2,-1.9,-2.7],[3.7,0.2,-8.4]]]"#;
const OBJECTS: &str = r#""size":[6,5],"frustum":{"fov_y_deg":70,"aspect":1.6,"near":1.1,"far":9.3},"objects":[[[[-3,-2,-4],[3.3,-1.7,-4],[0.2,2.9,-3.1]]],[[[-1,1.3,-7.9],[-1.2,-0.9,-7.7],[0.7,0.2,-8.4]]]]"#;

fn times(x: f64, exponent: i32) -> f64 {
    libm::scalbn(x, exponent)
}

/// Every number in it, that many powers of two larger.
fn scaled(json: &Json, exponent: i32) -> Json {
    match json {
        Json::Number(x) => json!(times(x.as_f64().expect("a double"), exponent)),
        Json::Array(list) => list.iter().map(|json| scaled(json, exponent)).collect(),
        other => other.clone(),
    }
}

/// A case with all its lengths larger; what is none stays: ratios, angles, directions and sizes in pixels.
fn scaled_case(fields: &Map<String, Json>, exponent: i32) -> Map<String, Json> {
    let one = |(key, json): (&String, &Json)| {
        let last_of_each = |json: &Json| {
            let rows = json.as_array().expect("rows").iter().map(|row| {
                let mut row = row.clone();
                row[3] = scaled(&row[3], exponent);
                row
            });
            rows.collect::<Json>()
        };
        let json = match (key.as_str(), json) {
            ("planes", rows) => last_of_each(rows),
            ("model", rows) => {
                let mut rows = last_of_each(rows);
                rows[3][3] = json!(1);
                rows
            }
            ("frustum" | "camera", Json::Object(fields)) => scaled_case(fields, exponent).into(),
            ("size" | "uv" | "up" | "view_dir" | "fov_y_deg" | "aspect", json) => json.clone(),
            (_, json) => scaled(json, exponent),
        };
        (key.clone(), json)
    };
    fields.iter().map(one).collect()
}

/// What is then right, of what was right before.
fn scaled_output(output: &Json, fields: &Map<String, Json>, exponent: i32) -> Json {
    let output = output.as_object().expect("an object").iter();
    let one = |(key, json): (&String, &Json)| {
        let json = match key.as_str() {
            "segment" | "polygons" | "triangles" | "distances" | "world" | "view" | "clip" => {
                scaled(json, exponent)
            }
            "dot" | "det" if fields.contains_key("eye") => scaled(json, 3 * exponent),
            "dot" | "det" => scaled(json, 2 * exponent),
            _ => json.clone(),
        };
        (key.clone(), json)
    };
    output.map(one).collect()
}

fn as_fields(fields: &str) -> Map<String, Json> {
    serde_json::from_str(&format!("{{{fields}}}")).expect("fields of JSON")
}

fn case_of(algorithm: &str, fields: &Map<String, Json>) -> String {
    let text = json!(fields).to_string();
    line(algorithm, &text[1..text.len() - 1])
}

/// Right or refused: alone wherever each number of the answer is one, as in the ordinary case's, and with its steps.
fn check(case: &str, expected: &Json, plain: &Json) {
    let alone = answer_alone(case);
    let [n_missing, n_usual] =
        [expected, plain].map(|json| json.to_string().matches("null").count());
    if n_missing == n_usual {
        assert_eq!(alone["output"], *expected, "{case}: {alone}");
    } else {
        assert_eq!(alone["error"]["code"], "not-finite", "{case}: {alone}");
    }
    let told = answer(case);
    if told["error"].is_null() {
        assert_eq!(told["output"], *expected, "{case}");
        if expected["depth"].is_null() {
            let events = told["events"].as_array().expect("steps");
            let has_null = |event: &&Json| event.as_object().is_some_and(holds_null_in_list);
            assert_eq!(events.iter().find(has_null), None, "{case}");
        }
    } else {
        assert_eq!(told["error"]["code"], "not-finite", "{case}: {told}");
    }
}

/// What is said of nothing is null; but in lists there are numbers.
fn holds_null_in_list(event: &Map<String, Json>) -> bool {
    let in_list = |json: &Json| matches!(json, Json::Array(list) if list.contains(&Json::Null));
    event.values().any(in_list)
}

pub fn all_cases() -> impl Iterator<Item = (&'static str, &'static str)> {
    CASES.into_iter().chain([("occlusion", OBJECTS)])
}

#[test]
fn every_algorithm_is_asked() {
    for solver in Solvers::standard().iter() {
        let id = solver.card.id;
        let asked = all_cases().any(|(algorithm, _)| algorithm == id);
        assert!(asked || id == "bresenham", "{id}");
    }
}

#[test]
fn all_lengths_larger_or_smaller_are_answered_alike_or_refused() {
    for (algorithm, fields) in all_cases() {
        let fields = as_fields(fields);
        let plain = answer_alone(&case_of(algorithm, &fields));
        assert!(plain["error"].is_null(), "{plain}");
        for power in POWERS {
            let case = case_of(algorithm, &scaled_case(&fields, power));
            let expected = scaled_output(&plain["output"], &fields, power);
            check(&case, &expected, &plain["output"]);
        }
    }
}

#[test]
fn planes_as_long_as_may_be_are_the_same_planes() {
    for (algorithm, fields) in all_cases() {
        let fields = as_fields(fields);
        let Some(planes) = fields.get("planes") else {
            continue;
        };
        let plain = answer_alone(&case_of(algorithm, &fields));
        for power in POWERS {
            let mut longer = fields.clone();
            longer.insert("planes".to_owned(), scaled(planes, power));
            check(
                &case_of(algorithm, &longer),
                &plain["output"],
                &plain["output"],
            );
        }
    }
}

#[test]
fn no_report_says_that_a_number_is_none() {
    for (algorithm, fields) in all_cases() {
        let fields = as_fields(fields);
        for power in [-900, -501, 340, 511, 900] {
            let case = case_of(algorithm, &scaled_case(&fields, power));
            for format in [Format::Text, Format::Markdown] {
                let report = answers(&case, style(format, Lang::En));
                let words = report.split(|c: char| !c.is_alphanumeric());
                let mut none = words.filter(|word| ["NaN", "inf"].contains(word));
                assert_eq!(none.next(), None, "{case}: {report}");
                let is_depth = algorithm == "depth-buffer" || algorithm == "ray-casting";
                assert!(is_depth || !report.contains('∞'), "{case}: {report}");
            }
        }
    }
}

/// Numbers of quite different sizes: what `hostile.md` found wrong.
#[test]
fn numbers_far_from_each_other_are_answered_or_refused_too() {
    let output = |case: &str| answer_alone(case)["output"].clone();
    let on_the_plane = line(
        "point-planes",
        r#""planes":[[1e160,1e160,0,0]],"point":[1e160,-1e160,0]"#,
    );
    assert_eq!(
        output(&on_the_plane),
        json!({"inside": true, "distances": [0.0]})
    );
    let front = line(
        "back-face",
        r#""triangle":[[0,0,0],[1e110,0,0],[0,1e110,0]],"eye":[0,0,1e110]"#,
    );
    assert_eq!(refusal(&front)[0], "not-finite");
    let front = front.replace("1e110", "1e100");
    assert_eq!(output(&front)["front"], true);
    let outside = line(
        "sphere-cull",
        r#""planes":[[1e160,0,0,0]],"sphere":[-1e160,0,0,1]"#,
    );
    let found = output(&outside);
    assert_eq!(found["class"], "outside");
    let distance = found["distances"][0].as_f64().expect("a number");
    assert!((distance / -1e160 - 1.0).abs() < 1e-15, "{distance}");
    let pipeline = line(
        "viewing-pipeline",
        r#""point":[1e308,1e308,1e308],"model":[[1e308,0,0,0],[0,1e308,0,0],[0,0,1e308,0],[0,0,0,1]],"camera":{"position":[0,0,5],"target":[0,0,0],"up":[0,1,0],"fov_y_deg":60,"aspect":1,"near":1,"far":10},"size":[64,64]"#,
    );
    let [code, field] = refusal(&pipeline);
    assert_eq!(code, "not-finite");
    assert!(
        field.starts_with("point") || field.starts_with("model"),
        "{field}"
    );
    assert_eq!(
        answers(&on_the_plane, JSON).matches("null").count(),
        1,
        "only its id"
    );
}
