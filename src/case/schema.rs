//! What `clipscope trace --schema` prints.

use serde_json::Map;

use crate::input::{of_fields, of_shape};

use super::{Solver, Solvers, prelude::*};

/// The version of cases and answers that the schema describes.
const VERSION: u32 = 2;

impl Solvers {
    /// `version`, and a JSON Schema of the cases and of the answers of every algorithm; `refused` is that of the answer to
    /// a case that is refused.
    #[must_use]
    pub fn schema(self) -> Json {
        let schemas = |solver: &Solver| {
            let schemas = json!({
                "case": of_cases(solver),
                "answer": of_answers(solver),
                "budget": { "steps": solver.budget },
            });
            (solver.card.id.to_owned(), schemas)
        };
        let algorithms: Map<String, Json> = self.iter().map(schemas).collect();
        let error = [
            ("code", json!({ "enum": Code::IDS.map(|(_, id)| id) })),
            ("field", of_shape(&Shape::Text)),
            ("message", of_shape(&Shape::Text)),
        ];
        let line = json!({ "type": "integer", "minimum": 1 });
        let refused = [
            ("id", json!({})),
            ("submission", json!({})),
            ("line", line),
            ("error", of_object(error, &[])),
        ];
        json!({
            "version": VERSION,
            "algorithms": algorithms,
            "refused": of_object(refused, &["submission"]),
        })
    }
}

/// An object of these properties and no others, of which all but some must be there.
fn of_object<const N: usize>(properties: [(&'static str, Json); N], optional: &[&str]) -> Json {
    let names = properties.iter().map(|(name, _)| *name);
    let required: Vec<&str> = names.filter(|name| !optional.contains(name)).collect();
    let properties = properties.map(|(name, schema)| (name.to_owned(), schema));
    json!({
        "type": "object",
        "properties": Map::from_iter(properties),
        "required": required,
        "additionalProperties": false,
    })
}

fn of_cases(solver: &Solver) -> Json {
    let mut schema = of_fields(solver.fields);
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema".into();
    schema["properties"]["id"] = json!({});
    schema["properties"]["submission"] = json!({});
    schema["properties"]["algorithm"] = json!({ "const": solver.card.id });
    if let Some(required) = schema["required"].as_array_mut() {
        required.push("algorithm".into());
    }
    schema
}

fn of_answers(solver: &Solver) -> Json {
    const COUNTS: [Field; 4] = [
        Field::required("add", &Shape::COUNT),
        Field::required("mul", &Shape::COUNT),
        Field::required("div", &Shape::COUNT),
        Field::required("cmp", &Shape::COUNT),
    ];
    // What else it says depends on the kind of event.
    let event = json!({
        "type": "object",
        "properties": { "event": of_shape(&Shape::Text) },
        "required": ["event"],
    });
    let properties = [
        ("id", json!({})),
        ("submission", json!({})),
        ("algorithm", json!({ "const": solver.card.id })),
        ("output", of_fields(solver.output)),
        ("counts", of_fields(&COUNTS)),
        ("events", json!({ "type": "array", "items": event })),
    ];
    of_object(properties, &["submission", "events"])
}
