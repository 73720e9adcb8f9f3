//! Cases of the frustum lab.

use clipscope::{case::Format, text::Lang};
use serde_json::{Value as Json, json};

use super::asked::{
    JSON, answer, answer_alone, answers, line, output, refusal, reports_are_as_they_were,
    steps_are_all_that_is_left_out, style,
};

const FRUSTUM: &str = r#""frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":10}"#;
/// In x and z the same as that of 90°: x ≤ −z and x ≥ z; between z = −1 and z = −9.
const PLANES: &str =
    r#""planes":[[0,0,-1,-1],[0,0,1,9],[1,0,-1,0],[-1,0,-1,0],[0,1,-1,0],[0,-1,-1,0]]"#;
/// Edges (1, 0, −1) and (0, 2, −1): their cross product is N1 = (2, 1, 2) of the slides.
const N1: &str = r#""triangle":[[0,0,0],[1,0,-1],[0,2,-1]]"#;
/// Edges (0, 1, 1/2) and (2, 0, −3): N2 = (−3, 1, −2).
const N2: &str = r#""triangle":[[4,4,4],[4,5,4.5],[6,4,1]]"#;

#[test]
fn a_point_has_a_distance_from_every_plane() {
    for (point, inside, distances) in [
        ("[0,0,-1]", true, json!([0.0, 8.0, 1.0, 1.0, 1.0, 1.0])),
        ("[2,0,-1]", false, json!([0.0, 8.0, 3.0, -1.0, 1.0, 1.0])),
    ] {
        let scaled = PLANES.replace("[0,0,-1,-1]", "[0,0,-4,-4]");
        let sides = [
            ("[1,0,-1,0]", "[1,0,0,1]"),
            ("[-1,0,-1,0]", "[-1,0,0,1]"),
            ("[0,1,-1,0]", "[0,1,0,1]"),
            ("[0,-1,-1,0]", "[0,-1,0,1]"),
        ];
        // A box: its planes have normals of length 1, but for the first.
        let planes = sides
            .iter()
            .fold(scaled, |text, (old, new)| text.replace(old, new));
        let found = output("point-planes", &format!(r#"{planes},"point":{point}"#));
        assert_eq!(found, json!({"inside": inside, "distances": distances}));
    }
}

#[test]
fn a_sphere_lies_inside_outside_or_on_both_sides() {
    let far = output(
        "sphere-cull",
        &format!(r#"{FRUSTUM},"sphere":[0,0,-11.5,1]"#),
    );
    assert_eq!(
        far,
        json!({"class": "outside", "distances": [10.5, -1.5]}),
        "the far plane rejects it, and no other is asked"
    );
    let inside = output("sphere-cull", &format!(r#"{FRUSTUM},"sphere":[0,0,-5,1]"#));
    assert_eq!(inside["class"], "inside");
    let found: Vec<f64> = numbers(&inside["distances"]);
    // Half of 90° to every side: 5·sin 45°.
    let side = 5.0 * std::f64::consts::FRAC_1_SQRT_2;
    for (found, expected) in found.iter().zip([4.0, 5.0, side, side, side, side]) {
        assert!((found - expected).abs() < 1e-14, "{inside}");
    }
    assert_eq!(found.len(), 6);
    for (sphere, class) in [
        ("[0,0,-1,0]", "inside"),
        ("[0,0,-1,0.5]", "straddles"),
        ("[0,0,0,1]", "straddles"),
        ("[0,0,0,0.875]", "outside"),
    ] {
        let found = output("sphere-cull", &format!(r#"{FRUSTUM},"sphere":{sphere}"#));
        assert_eq!(found["class"], class, "{sphere}");
    }
}

fn numbers(list: &Json) -> Vec<f64> {
    let list = list.as_array().expect("a list");
    list.iter().filter_map(Json::as_f64).collect()
}

#[test]
fn distances_are_divided_by_the_length_of_the_normal_and_touching_is_kept() {
    for (sphere, class, distance) in [
        ("[-3,-5,0,4]", "outside", -4.8),
        ("[-3,-4,0,4]", "straddles", -4.0),
        ("[-3,-4,0,3.75]", "outside", -4.0),
        ("[1,3,0,4]", "inside", 4.0),
        ("[1,3,0,4.25]", "straddles", 4.0),
    ] {
        let fields = format!(r#""planes":[[3,4,0,5]],"sphere":{sphere}"#);
        let found = output("sphere-cull", &fields);
        assert_eq!(found, json!({"class": class, "distances": [distance]}));
    }
}

#[test]
fn a_parallel_volume_has_a_height_and_may_begin_behind_the_eye() {
    let volume = r#""frustum":{"height":4,"aspect":2,"near":-1,"far":3}"#;
    for (sphere, class, distances) in [
        ("[0,0,0,1]", "inside", json!([1.0, 3.0, 4.0, 4.0, 2.0, 2.0])),
        (
            "[0,2,0,1]",
            "straddles",
            json!([1.0, 3.0, 4.0, 4.0, 4.0, 0.0]),
        ),
        ("[6,0,0,1]", "outside", json!([1.0, 3.0, 10.0, -2.0])),
    ] {
        let found = output("sphere-cull", &format!(r#"{volume},"sphere":{sphere}"#));
        assert_eq!(found, json!({"class": class, "distances": distances}));
    }
}

#[test]
fn a_box_is_asked_by_its_corners_and_then_whether_it_is_kept_in_vain() {
    for (bounds, class, in_vain) in [
        ("[-1,-1,-5,1,1,-4]", "inside", false),
        ("[-9,-9,-9,9,9,-9]", "inside", false),
        ("[-1,-1,-12,1,1,-9.5]", "outside", false),
        // Its only corner at z = −9 nearest to the middle is the volume's own.
        ("[9,9,-12,20,20,-9]", "straddles", false),
        ("[9.5,-1,-10,40,1,20]", "straddles", true),
        // A point, in the corner of three planes.
        ("[1,1,-1,1,1,-1]", "inside", false),
        ("[2,0,-1,2,0,-1]", "outside", false),
    ] {
        let found = output("box-cull", &format!(r#"{PLANES},"box":{bounds}"#));
        let expected = json!({"class": class, "false_positive": in_vain});
        assert_eq!(found, expected, "{bounds}");
    }
    let found = output(
        "box-cull",
        &format!(r#"{FRUSTUM},"box":[10.5,-1,-11,40,1,20]"#),
    );
    assert_eq!(found, json!({"class": "straddles", "false_positive": true}));
}

#[test]
fn two_planes_that_make_a_wedge_keep_a_box_below_their_edge() {
    // y ≥ 10·|x|
    let wedge = r#""planes":[[-10,1,0,0],[10,1,0,0]]"#;
    for (top, in_vain) in [(-1.0, true), (0.0, false), (1.0, false)] {
        let fields = format!(r#"{wedge},"box":[-3,-2,-1,3,{top},1]"#);
        let expected = json!({"class": "straddles", "false_positive": in_vain});
        assert_eq!(output("box-cull", &fields), expected, "{top}");
    }
}

#[test]
fn the_slides_faces_are_seen_and_not_seen() {
    for (triangle, front, dot) in [(N1, true, 10.0), (N2, false, -10.0)] {
        let fields = format!(r#"{triangle},"view_dir":[0,0,-5]"#);
        let expected = json!({"front": front, "dot": dot, "det": dot});
        assert_eq!(output("back-face", &fields), expected);
    }
    // From a point e = (1, 2, 3) − V0: (2, 1, 2)·(1, 2, 3) = 10 and (−3, 1, −2)·(−3, −2, −1) = 9.
    for (triangle, dot) in [(N1, 10.0), (N2, 9.0)] {
        let fields = format!(r#"{triangle},"eye":[1,2,3]"#);
        let expected = json!({"front": true, "dot": dot, "det": dot});
        assert_eq!(output("back-face", &fields), expected);
    }
    let edge_on = r#""triangle":[[0,0,0],[1,0,0],[0,1,0]],"eye":[7,-3,0]"#;
    let no_area = r#""triangle":[[0,0,0],[1,1,1],[2,2,2]],"eye":[7,-3,5]"#;
    for fields in [edge_on, no_area] {
        assert_eq!(output("back-face", fields)["front"], false, "{fields}");
    }
}

#[test]
fn an_answer_has_the_form_that_was_promised() {
    let case = format!(r#"{{"id":7,"algorithm":"back-face",{N1},"view_dir":[0,0,-5]}}"#);
    let [head, events] = [
        r#"{"id":7,"algorithm":"back-face","output":{"front":true,"dot":10.0,"det":10.0},"counts":{"#,
        r#""events":[{"event":"normal","edges":[[1.0,0.0,-1.0],[0.0,2.0,-1.0]],"normal":[2.0,1.0,2.0]},"#,
    ];
    let found = answers(&case, JSON);
    assert!(found.starts_with(head) && found.contains(events), "{found}");
    let asked = answer(&line(
        "sphere-cull",
        &format!(r#"{FRUSTUM},"sphere":[0,0,-9,0.5]"#),
    ));
    let planes: Vec<&Json> = asked["events"]
        .as_array()
        .into_iter()
        .flatten()
        .filter(|event| event["event"] == "plane")
        .map(|event| &event["plane_idx"])
        .collect();
    assert_eq!(
        planes,
        [0, 1, 2, 3, 4, 5],
        "near, far, left, right, bottom, top"
    );
}

#[test]
fn without_events_the_answer_is_the_same() {
    let cases = [
        line("sphere-cull", &format!(r#"{PLANES},"sphere":[0,0,-5,7]"#)),
        line(
            "box-cull",
            &format!(r#"{FRUSTUM},"box":[9.5,-1,-10,40,1,20]"#),
        ),
        line("back-face", &format!(r#"{N2},"eye":[0,0.5,9]"#)),
    ];
    for case in cases {
        steps_are_all_that_is_left_out(&case);
    }
}

#[test]
fn planes_and_volumes_are_refused_at_the_very_field() {
    for (given, code, field) in [
        (r#""planes":7"#, "wrong-type", "planes"),
        (r#""planes":[]"#, "wrong-length", "planes"),
        (r#""planes":[[1,0,0]]"#, "wrong-length", "planes[0]"),
        (
            r#""planes":[[1,0,0,0],[0,0,0,1]]"#,
            "degenerate",
            "planes[1]",
        ),
        (r#""planes":[[1,0,1e999,0]]"#, "not-finite", "planes[0][2]"),
        (r#""planes":[[1,0,"0",0]]"#, "wrong-type", "planes[0][2]"),
        (r#""frustum":[90,1,1,10]"#, "wrong-type", "frustum"),
        (r#""frustum":{}"#, "missing-field", "frustum.fov_y_deg"),
        (
            r#""frustum":{"fov_y_deg":90,"aspect":1,"near":1}"#,
            "missing-field",
            "frustum.far",
        ),
        (
            r#""frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":9,"fov_x":90}"#,
            "unknown-field",
            "frustum.fov_x",
        ),
        (
            r#""frustum":{"fov_y_deg":90,"height":2,"aspect":1,"near":1,"far":9}"#,
            "unknown-field",
            "frustum.height",
        ),
        (
            r#""frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":9,"near":2}"#,
            "bad-json",
            "frustum.near",
        ),
        (
            r#""frustum":{"fov_y_deg":180,"aspect":1,"near":1,"far":9}"#,
            "degenerate",
            "frustum.fov_y_deg",
        ),
        (
            r#""frustum":{"height":0,"aspect":1,"near":1,"far":9}"#,
            "degenerate",
            "frustum.height",
        ),
        (
            r#""frustum":{"fov_y_deg":90,"aspect":0,"near":1,"far":9}"#,
            "degenerate",
            "frustum.aspect",
        ),
        (
            r#""frustum":{"fov_y_deg":90,"aspect":1,"near":0,"far":9}"#,
            "degenerate",
            "frustum.near",
        ),
        (
            r#""frustum":{"fov_y_deg":90,"aspect":1,"near":1,"far":1}"#,
            "degenerate",
            "frustum.far",
        ),
        (
            r#""frustum":{"fov_y_deg":1e999,"aspect":1,"near":1,"far":2}"#,
            "not-finite",
            "frustum.fov_y_deg",
        ),
        (
            r#""frustum":{"fov_y_deg":90,"aspect":"wide","near":1,"far":2}"#,
            "wrong-type",
            "frustum.aspect",
        ),
    ] {
        let sphere = line("sphere-cull", &format!(r#"{given},"sphere":[0,0,0,1]"#));
        assert_eq!(refusal(&sphere), [code, field], "{given}");
        let boxed = line("box-cull", &format!(r#"{given},"box":[0,0,0,1,1,1]"#));
        assert_eq!(refusal(&boxed), [code, field], "{given}");
    }
}

#[test]
fn what_is_culled_is_refused_at_the_very_field() {
    let eye = r#""eye":[0,0,5]"#;
    for (id, fields, code, field) in [
        (
            "sphere-cull",
            format!(r#"{FRUSTUM},"sphere":[0,0,0,-1]"#),
            "degenerate",
            "sphere[3]",
        ),
        (
            "sphere-cull",
            format!(r#"{FRUSTUM},"sphere":[0,0,0]"#),
            "wrong-length",
            "sphere",
        ),
        ("sphere-cull", FRUSTUM.to_owned(), "missing-field", "sphere"),
        (
            "sphere-cull",
            r#""sphere":[0,0,0,1]"#.to_owned(),
            "missing-field",
            "planes",
        ),
        (
            "sphere-cull",
            format!(r#"{FRUSTUM},{PLANES},"sphere":[0,0,0,1]"#),
            "unknown-field",
            "frustum",
        ),
        (
            "sphere-cull",
            format!(r#"{FRUSTUM},"box":[0,0,0,1,1,1],"sphere":[0,0,0,1]"#),
            "unknown-field",
            "box",
        ),
        (
            "box-cull",
            format!(r#"{FRUSTUM},"box":[0,2,0,1,1,1]"#),
            "empty-window",
            "box",
        ),
        (
            "box-cull",
            format!(r#"{FRUSTUM},"box":[0,0,0,1,1,-1e400]"#),
            "not-finite",
            "box[5]",
        ),
        (
            "back-face",
            format!(r#""triangle":[[0,0,0],[1,0,0]],{eye}"#),
            "wrong-length",
            "triangle",
        ),
        (
            "back-face",
            format!(r#""triangle":[[0,0,0],[1,0],[0,1,0]],{eye}"#),
            "wrong-length",
            "triangle[1]",
        ),
        (
            "back-face",
            format!(r#""triangle":[[0,0,0],[1,0,0],[0,null,0]],{eye}"#),
            "wrong-type",
            "triangle[2][1]",
        ),
        ("back-face", N1.to_owned(), "missing-field", "eye"),
        (
            "back-face",
            format!(r#"{N1},{eye},"view_dir":[0,0,-1]"#),
            "unknown-field",
            "view_dir",
        ),
        (
            "back-face",
            format!(r#"{N1},"view_dir":[0,-0.0,0]"#),
            "degenerate",
            "view_dir",
        ),
    ] {
        assert_eq!(refusal(&line(id, &fields)), [code, field], "{fields}");
    }
}

#[test]
fn only_a_report_of_very_many_planes_is_refused() {
    let planes = vec!["[1,0,0,0]"; 2000].join(",");
    let case = line(
        "sphere-cull",
        &format!(r#""planes":[{planes}],"sphere":[1,0,0,1]"#),
    );
    assert_eq!(refusal(&case), ["too-large", "planes"]);
    let alone = answer_alone(&case);
    assert_eq!(alone["output"]["class"], "inside");
}

const CUT_SEGMENT: &str = r#""box":[-1,-1,-1,1,1,1],"segment":[-2,-1,0,2,1,0.5]"#;
const CUT_TRIANGLE: &str =
    r#""planes":[[1,0,0,1],[0,-1,0,2]],"triangle":[[-3,0,0],[1,0,2],[1,4,0]]"#;
const CAMERA_OF_REPORTS: &str = r#""model":[[1,0,0,2],[0,1,0,0],[0,0,1,-1],[0,0,0,1]],"camera":{"position":[0,1,4],"target":[0,1,0],"up":[0,1,0],"fov_y_deg":90,"aspect":1.6,"near":2,"far":10}"#;

fn reported() -> String {
    [
        line("point-planes", r#""planes":[[3,4,0,5]],"point":[-3,1,2]"#),
        line("sphere-cull", &format!(r#"{FRUSTUM},"sphere":[1,2,-4,1]"#)),
        line(
            "sphere-cull",
            r#""planes":[[3,4,0,5]],"sphere":[-3,-4,0,2]"#,
        ),
        line(
            "box-cull",
            &format!(r#"{PLANES},"box":[9.5,-1,-10,40,1,20]"#),
        ),
        line("back-face", &format!(r#"{N1},"view_dir":[0,0,-5]"#)),
        line("back-face", &format!(r#"{N2},"eye":[1,2,3]"#)),
        line("cohen-sutherland-3d", CUT_SEGMENT),
        line("liang-barsky-3d", CUT_SEGMENT),
        line(
            "plane-line",
            r#""planes":[[1,0,0,1],[1,1,0,1]],"segment":[-3,0,0,1,2,4]"#,
        ),
        line("homogeneous-line", r#""segment":[0,0,0,1,3,0,0,-1]"#),
        line("plane-at-a-time", CUT_TRIANGLE),
        line("intersection-polygon", CUT_TRIANGLE),
        line(
            "homogeneous-triangle",
            r#""triangle":[[-4,-4,4,5],[4,1,4,5],[2,5,-8,-1]]"#,
        ),
        line(
            "viewing-pipeline",
            &format!(r#""point":[0.5,1,-2],{CAMERA_OF_REPORTS},"size":[640,400]"#),
        ),
        line("bresenham", r#""from":[1,2],"to":[7,5]"#),
    ]
    .join("\n")
}

#[test]
fn reports_on_space_are_as_they_were() {
    let files = [
        ("frustum-en.md", Format::Markdown, Lang::En),
        ("frustum-zh-CN.txt", Format::Text, Lang::ZhCn),
        ("frustum-es.txt", Format::Text, Lang::Es),
        ("frustum-pt-BR.md", Format::Markdown, Lang::PtBr),
    ];
    reports_are_as_they_were(&reported(), &files);
}

/// A square in the plane z = −2, in view space, and a triangle around its lower left corner.
const SQUARE: &str = r#""planes":[[1,0,0,1],[-1,0,0,1],[0,1,0,1],[0,-1,0,1]]"#;

#[test]
fn a_triangle_is_cut_by_planes_in_both_ways() {
    let fields = format!(r#"{SQUARE},"triangle":[[0,0,-2],[-2,0,-2],[0,-2,-2]]"#);
    let polygon = output("intersection-polygon", &fields);
    // A pentagon would be left of a larger one; here the slanted edge runs through the corner (−1, −1).
    assert_eq!(
        polygon,
        json!({"triangles": [
            [[0.0, 0.0, -2.0], [-1.0, 0.0, -2.0], [-1.0, -1.0, -2.0]],
            [[0.0, 0.0, -2.0], [-1.0, -1.0, -2.0], [0.0, -1.0, -2.0]],
        ]})
    );
    let one_by_one = output("plane-at-a-time", &fields);
    assert_eq!(one_by_one, polygon, "one diagonal, which no plane cuts");
    let textured = format!(r#"{fields},"uv":[[0,0],[1,0],[0,1]]"#);
    for id in ["intersection-polygon", "plane-at-a-time"] {
        let found = output(id, &textured);
        assert_eq!(found["triangles"], polygon["triangles"]);
        assert_eq!(
            found["uv"],
            json!([
                [[0.0, 0.0], [0.5, 0.0], [0.5, 0.5]],
                [[0.0, 0.0], [0.5, 0.5], [0.0, 0.5]],
            ])
        );
        let nothing = format!(r#"{SQUARE},"triangle":[[0,0,0],[1,1,1],[2,2,2]]"#);
        assert_eq!(output(id, &nothing), json!({"triangles": []}), "no area");
        let outside =
            format!(r#"{FRUSTUM},"triangle":[[0,0,1],[1,0,1],[0,1,1]],"uv":[[0,0],[1,0],[0,1]]"#);
        assert_eq!(output(id, &outside), json!({"triangles": [], "uv": []}));
    }
}

#[test]
fn a_triangle_is_cut_before_the_divide() {
    let fields = r#""triangle":[[0,0,0,1],[4,0,0,1],[0,2,0,-1]],"uv":[[0,0],[1,0],[0,1]]"#;
    let found = output("homogeneous-triangle", fields);
    for vertex in found["triangles"].as_array().expect("triangles") {
        for at in vertex.as_array().expect("three corners") {
            assert!(at[3].as_f64().expect("w") > 0.0, "{found}");
        }
    }
    assert_eq!(
        found["triangles"].as_array().map(Vec::len),
        found["uv"].as_array().map(Vec::len)
    );
    let inside = r#""triangle":[[0,0,0,1],[1,0,0,1],[0,1,0,1]]"#;
    assert_eq!(
        output("homogeneous-triangle", inside),
        json!({"triangles": [[[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0]]]})
    );
}

#[test]
fn a_triangles_fields_are_checked() {
    for (id, fields, code, field) in [
        (
            "plane-at-a-time",
            r#""triangle":[[0,0,0],[1,0,0],[0,1,0]]"#,
            "missing-field",
            None,
        ),
        (
            "intersection-polygon",
            r#""planes":[[0,0,0,1]],"triangle":[[0,0,0],[1,0,0],[0,1,0]]"#,
            "degenerate",
            Some("planes[0]"),
        ),
        (
            "intersection-polygon",
            r#""planes":[[0,0,1,1]],"triangle":[[0,0,0],[1,0,0]]"#,
            "wrong-length",
            Some("triangle"),
        ),
        (
            "homogeneous-triangle",
            r#""triangle":[[0,0,0,1],[1,0,0,1],[0,1,0]]"#,
            "wrong-length",
            Some("triangle[2]"),
        ),
        (
            "homogeneous-triangle",
            r#""triangle":[[0,0,0,1],[1,0,0,1],[0,1,0,1]],"uv":[[0,0],[1,0]]"#,
            "wrong-length",
            Some("uv"),
        ),
    ] {
        let error = answer(&line(id, fields))["error"].clone();
        assert_eq!(error["code"], code, "{fields}: {error}");
        if let Some(field) = field {
            assert_eq!(error["field"], field, "{fields}: {error}");
        }
    }
}

#[test]
fn a_triangles_answer_key_says_everything_in_four_languages() {
    let cases = [
        line(
            "plane-at-a-time",
            &format!(r#"{SQUARE},"triangle":[[0,0,-2],[-2,0,-2],[0,-2,-2]]"#),
        ),
        line(
            "intersection-polygon",
            &format!(
                r#"{FRUSTUM},"triangle":[[0,0,0],[5,0,-3],[0,9,-6]],"uv":[[0,0],[1,0],[0,1]]"#
            ),
        ),
        line(
            "homogeneous-triangle",
            r#""triangle":[[0,0,0,1],[4,0,0,1],[0,2,0,-1]]"#,
        ),
    ]
    .join("\n");
    for lang in Lang::ALL {
        for format in [Format::Markdown, Format::Text] {
            let report = answers(&cases, style(format, lang));
            assert!(!report.contains('⟦'), "{lang}: {report}");
        }
    }
}
