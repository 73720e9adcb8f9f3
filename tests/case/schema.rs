//! The schema that describes cases and answers, and which methods it knows.

use std::sync::LazyLock;

use clipscope::{case::Solvers, labs::LABS};
use serde_json::{Value as Json, json};

use super::asked::{answer, line};

static SCHEMA: LazyLock<Json> = LazyLock::new(|| Solvers::standard().schema());

/// Holds a case and its answer to the schema; a refused case only its answer. An id may hold numbers that are none to the
/// library that reads them here: such a case is passed over.
pub fn check(case: &str, answer: &str) {
    let Ok(answer) = serde_json::from_str::<Json>(answer) else {
        return;
    };
    let Some(algorithm) = answer["algorithm"].as_str() else {
        return valid(&answer, &SCHEMA["refused"]).expect(case);
    };
    let schemas = &SCHEMA["algorithms"][algorithm];
    let case = case.trim_start_matches('\u{feff}');
    let case: Json = serde_json::from_str(case).expect("a case that is answered is JSON");
    valid(&case, &schemas["case"]).expect("an answered case is as the schema says");
    valid(&answer, &schemas["answer"]).expect("an answer is as the schema says");
}

/// As much of JSON Schema as the program's own schema uses: whatever else stands there is an error.
fn valid(value: &Json, schema: &Json) -> Result<(), String> {
    let fault = |what: &str| Err(format!("{value:.120} is not {what} of {schema:.300}"));
    for (word, bound) in schema.as_object().expect("a schema is an object") {
        let list = || bound.as_array().into_iter().flatten();
        let entries = || value.as_array().into_iter().flatten();
        let holds = match word.as_str() {
            "type" => is_of(value, bound.as_str().expect("a word")),
            "const" => value == bound,
            "enum" => list().any(|word| word == value),
            "required" => list().all(|name| value.get(name.as_str().expect("a name")).is_some()),
            "minimum" => value.as_f64() >= bound.as_f64(),
            "maximum" => value.as_f64() <= bound.as_f64(),
            "minItems" => entries().count() as u64 >= bound.as_u64().expect("a number"),
            "maxItems" => entries().count() as u64 <= bound.as_u64().expect("a number"),
            "oneOf" => list().filter(|schema| valid(value, schema).is_ok()).count() == 1,
            "anyOf" => list().any(|schema| valid(value, schema).is_ok()),
            "items" => {
                entries().try_for_each(|entry| valid(entry, bound))?;
                true
            }
            "additionalProperties" => {
                let known = schema["properties"].as_object().expect("an object");
                value
                    .as_object()
                    .is_none_or(|o| o.keys().all(|name| known.contains_key(name)))
            }
            "properties" => {
                for (name, schema) in bound.as_object().expect("an object") {
                    value
                        .get(name)
                        .map_or(Ok(()), |value| valid(value, schema))?;
                }
                true
            }
            "$schema" => true,
            word => panic!("{word} is not checked here"),
        };
        if !holds {
            return fault(word);
        }
    }
    Ok(())
}

fn is_of(value: &Json, kind: &str) -> bool {
    match kind {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.as_f64().is_some_and(|x| x.fract() == 0.0),
        kind => panic!("{kind} is no type"),
    }
}

#[test]
fn every_algorithm_has_its_schema() {
    assert_eq!(SCHEMA["version"], 2);
    let found = SCHEMA["algorithms"].as_object().expect("an object");
    let ids: Vec<&str> = Solvers::standard()
        .iter()
        .map(|solver| solver.card.id)
        .collect();
    assert_eq!(found.keys().collect::<Vec<_>>(), ids);
    let window =
        json!({"type": "array", "items": {"type": "number"}, "minItems": 4, "maxItems": 4});
    assert_eq!(
        found["liang-barsky"]["case"],
        json!({
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "type": "object",
            "properties": {
                "window": window,
                "segment": window,
                "id": {},
                "submission": {},
                "algorithm": {"const": "liang-barsky"},
            },
            "required": ["window", "segment", "algorithm"],
            "additionalProperties": false,
        })
    );
}

#[test]
fn what_the_schema_forbids_is_refused() {
    let case = r#"{"id":1,"algorithm":"cyrus-beck","window":[-1,-1,1,1],"segment":[0,0,1,1]}"#;
    let schema = &SCHEMA["algorithms"]["cyrus-beck"]["case"];
    let valid = |text: &str| valid(&serde_json::from_str(text).expect("JSON"), schema);
    assert_eq!(valid(case), Ok(()));
    for (old, new) in [
        ("cyrus-beck", "cyrus"),
        (r#""window":[-1,-1,1,1],"#, ""),
        ("window", "clip"),
        ("window", "windows"),
        ("[0,0,1,1]", "[0,0,1]"),
        ("[0,0,1,1]", "[0,0,1,null]"),
        (r#""segment""#, r#""clip":[[0,0],[1,0],[0,1]],"segment""#),
    ] {
        let broken = case.replace(old, new);
        assert!(valid(&broken).is_err(), "{broken}");
        assert!(answer(&broken)["error"].is_object(), "{broken}");
    }
}

/// The funnel takes a mesh. The textured triangle is a way to show the intersection polygon, whose cases may have `uv`. What
/// is wrong on purpose has no case, nor has a proof.
const WITHOUT: [&str; 3] = ["funnel", "textured-triangle", "undivided-texture"];

#[test]
fn every_method_has_a_case_but_the_funnel_the_proofs_and_the_mistakes() {
    for card in LABS.iter().flat_map(|lab| (lab.methods)()) {
        let has_case = Solvers::standard().by_id(card.id).is_some();
        let expected = !card.is_faulty && !card.is_proof && !WITHOUT.contains(&card.id);
        assert_eq!(has_case, expected, "{}", card.id);
    }
}

/// A wall that fills the picture, a small thing behind it and one before it.
#[test]
fn an_occluded_object_is_skipped() {
    let wall = "[[[-9,-9,-3],[9,-9,-3],[0,18,-3]]]";
    let behind = "[[[-1,-1,-6],[1,-1,-6],[0,1,-7]],[[-1,-1,-6],[1,-1,-6],[0,0,-6]]]";
    let before = "[[[-6,0,-2],[0,-6,-2],[6,0,-2]]]";
    let fields = format!(
        r#""size":[2,2],"frustum":{{"fov_y_deg":90,"aspect":1,"near":1,"far":9}},"objects":[{behind},{wall},[],{before}]"#
    );
    let found = answer(&line("occlusion", &fields));
    let expected = json!({"ids": [1, 1, 3, 3], "skipped": [0, 2]});
    assert_eq!(found["output"], expected, "{found}");
}

#[test]
fn every_algorithm_has_a_budget() {
    for (id, schemas) in SCHEMA["algorithms"].as_object().expect("an object") {
        let steps = schemas["budget"]["steps"].as_u64();
        assert!(steps.is_some_and(|steps| steps >= 1_000_000), "{id}");
    }
}
