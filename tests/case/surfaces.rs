//! Cases of visible surfaces.

use serde_json::{Value as Json, json};

use super::asked::{answer, answer_alone, refusal};

const ALGORITHMS: [&str; 4] = ["depth-buffer", "ray-casting", "painter", "bsp"];
const FRUSTUM: &str = r#"{"fov_y_deg":90,"aspect":1,"near":1,"far":9}"#;
/// A wall that fills the picture, 3 before the eye, and half a wall before it: its upper edge is level with the eye.
const WALLS: &str = "[[[-9,-9,-3],[9,-9,-3],[0,18,-3]],[[-6,0,-2],[0,-6,-2],[6,0,-2]]]";

fn case_of(algorithm: &str, size: &str, triangles: &str, more: &str) -> String {
    format!(
        r#"{{"algorithm":"{algorithm}","size":{size},"frustum":{FRUSTUM},"triangles":{triangles}{more}}}"#
    )
}

fn solved(algorithm: &str, size: &str, triangles: &str, more: &str) -> Json {
    answer(&case_of(algorithm, size, triangles, more))
}

#[test]
fn all_say_who_is_seen() {
    let ids = json!([0, 0, 1, 1]);
    for algorithm in ALGORITHMS {
        let found = solved(algorithm, "[2,2]", WALLS, "");
        assert_eq!(found["output"]["ids"], ids, "{found}");
    }
    // 9/8 · (1 − 1/3) and 9/8 · (1 − 1/2)
    for algorithm in ["depth-buffer", "ray-casting"] {
        let found = solved(algorithm, "[2,2]", WALLS, "");
        let depth = found["output"]["depth"].as_array().expect("a list");
        for (depth, expected) in depth.iter().zip([0.75, 0.75, 0.5625, 0.5625]) {
            let depth = depth.as_f64().expect("a number");
            assert!((depth - expected).abs() < 1e-15, "{algorithm}: {depth}");
        }
        assert_eq!(depth.len(), 4);
    }
    assert_eq!(
        solved("painter", "[2,2]", WALLS, "")["output"]["order"],
        json!([0, 1])
    );
}

#[test]
fn light_comes_through_what_is_not_opaque() {
    let tints = r#","tints":[[1,0],[0.5,0.25]]"#;
    for algorithm in ["depth-buffer", "painter"] {
        let found = solved(algorithm, "[2,2]", WALLS, tints);
        let brightness = json!([0.0, 0.0, 0.125, 0.125]);
        assert_eq!(found["output"]["brightness"], brightness, "{found}");
        let plain = solved(algorithm, "[2,2]", WALLS, "");
        assert!(plain["output"].get("brightness").is_none(), "{plain}");
    }
    // The pane first: the wall behind it is lost.
    let turned = "[[[-6,0,-2],[0,-6,-2],[6,0,-2]],[[-9,-9,-3],[9,-9,-3],[0,18,-3]]]";
    let tints = r#","tints":[[0.5,0.25],[1,0]]"#;
    for (algorithm, expected) in [("depth-buffer", 0.625), ("painter", 0.125)] {
        let found = solved(algorithm, "[2,2]", turned, tints);
        assert_eq!(found["output"]["brightness"][2], json!(expected), "{found}");
    }
    for (tints, code, field) in [
        ("[[1,0]]", "wrong-length", "tints"),
        ("[[1,0],[0.5,1.5]]", "degenerate", "tints[1]"),
    ] {
        let more = format!(r#","tints":{tints}"#);
        let refused = refusal(&case_of("painter", "[2,2]", WALLS, &more));
        assert_eq!(refused, [code, field], "{tints}");
    }
}

#[test]
fn backs_are_left_out_where_they_are_culled() {
    let turned = "[[[-9,-9,-3],[9,-9,-3],[0,18,-3]],[[-6,0,-2],[6,0,-2],[0,-6,-2]]]";
    for algorithm in ALGORITHMS {
        let [both, fronts] =
            ["", r#","cull":"back""#].map(|more| solved(algorithm, "[2,2]", turned, more));
        assert_eq!(both["output"]["ids"], json!([0, 0, 1, 1]), "{both}");
        assert_eq!(fronts["output"]["ids"], json!([0, 0, 0, 0]), "{fronts}");
    }
    let order = solved("painter", "[2,2]", turned, r#","cull":"back""#);
    assert_eq!(
        order["output"]["order"],
        json!([0]),
        "what is culled is left out"
    );
}

#[test]
fn nothing_is_seen_where_nothing_is() {
    let none = solved("depth-buffer", "[2,1]", "[]", "");
    assert_eq!(
        none["output"],
        json!({"ids": [-1, -1], "depth": [null, null]})
    );
    let flat = "[[[0,0,-3],[1,1,-3],[2,2,-3]]]";
    for algorithm in ["depth-buffer", "ray-casting"] {
        let flat = solved(algorithm, "[2,1]", flat, "");
        assert_eq!(flat["output"]["depth"], json!([null, null]), "{algorithm}");
    }
    let named = solved("painter", "[2,1]", flat, "");
    assert_eq!(
        named["output"]["order"],
        json!([0]),
        "every triangle is named"
    );
}

#[test]
fn a_cycle_has_no_order_and_no_picture() {
    let pierced = "[[[-2,-1,-4],[2,-1,-6],[0,2,-5]],[[-2,-1,-6],[2,-1,-4],[0,2,-5]]]";
    let found = solved("painter", "[4,4]", pierced, "");
    assert_eq!(found["output"], json!({"cycle": [0, 1]}));
}

#[test]
fn a_tree_cuts_what_pierces_each_other() {
    let pierced = "[[[-2,-1,-4],[2,-1,-6],[0,2,-5]],[[-2,-1,-6],[2,-1,-4],[0,2,-5]]]";
    let of = |algorithm| solved(algorithm, "[8,8]", pierced, "")["output"].clone();
    let tree = of("bsp");
    assert_eq!(tree["n_pieces"], 3);
    assert_eq!(tree["ids"], of("depth-buffer")["ids"]);
}

#[test]
fn a_tree_that_would_be_too_large_is_refused() {
    // 300 upright walls and 300 level ones: each of the first cuts each of the others.
    let triangles: Vec<Json> = (0..300)
        .flat_map(|i| {
            let at = 0.001 * f64::from(i) - 0.15;
            let upright = json!([[at, -9, -2], [at, 9, -2], [at, 0, -8]]);
            let level = json!([[-9, at, -2], [9, at, -2], [0, at, -8]]);
            [upright, level]
        })
        .collect();
    let case = format!(
        r#"{{"algorithm":"bsp","size":[2,2],"frustum":{FRUSTUM},"triangles":{}}}"#,
        Json::from(triangles)
    );
    let error = &answer_alone(&case)["error"];
    assert_eq!(
        (&error["code"], &error["field"]),
        (&json!("too-large"), &json!("triangles")),
        "{error}"
    );
}

#[test]
fn every_refusal_names_its_place() {
    let cases = [
        ("[0,2]", "[]", "", "degenerate", "size[0]"),
        ("[2,4097]", "[]", "", "too-large", "size[1]"),
        ("[2]", "[]", "", "wrong-length", "size"),
        ("[2.5,2]", "[]", "", "wrong-type", "size[0]"),
        ("[300,300]", "[]", "", "too-large", "size"),
        (
            "[2,2]",
            "[[[0,0,-2],[1,0,-2]]]",
            "",
            "wrong-length",
            "triangles[0]",
        ),
        (
            "[2,2]",
            "[[[0,0,-2],[1,0,-2],[1,1]]]",
            "",
            "wrong-length",
            "triangles[0][2]",
        ),
        (
            "[2,2]",
            "[[[0,0,-2],[1,0,1e999],[1,1,0]]]",
            "",
            "not-finite",
            "triangles[0][1][2]",
        ),
        ("[2,2]", "{}", "", "wrong-type", "triangles"),
        ("[2,2]", "[]", r#","cull":"front""#, "wrong-type", "cull"),
        ("[2,2]", "[]", r#","eye":[0,0,0]"#, "unknown-field", "eye"),
    ];
    for algorithm in ALGORITHMS {
        for (size, triangles, more, code, field) in cases {
            let case = case_of(algorithm, size, triangles, more);
            assert_eq!(refusal(&case), [code, field], "{case}");
        }
        let case = format!(
            r#"{{"algorithm":"{algorithm}","size":[2,2],"triangles":[],"frustum":{{"fov_y_deg":90,"aspect":1,"near":2,"far":1}}}}"#
        );
        assert_eq!(refusal(&case), ["degenerate", "frustum.far"], "{case}");
    }
}

#[test]
fn an_answer_alone_may_be_large() {
    let many = vec!["[[-9,-9,-3],[9,-9,-3],[0,18,-3]]"; 40].join(",");
    let case = format!(
        r#"{{"algorithm":"depth-buffer","size":[50,50],"frustum":{FRUSTUM},"triangles":[{many}]}}"#
    );
    let refused = answer(&case);
    assert_eq!(refused["error"]["code"], "too-large");
    assert_eq!(refused["error"]["field"], "triangles");
    let solved = answer_alone(&case);
    assert_eq!(solved["output"]["ids"].as_array().map(Vec::len), Some(2500));
}
