//! Shapes as JSON Schema (draft 2020-12).

use serde_json::{Map, Value as Json, json};

use super::{Dim, Field, Presence, Shape};

pub fn of_shape(shape: &Shape) -> Json {
    match shape {
        Shape::Bool => json!({ "type": "boolean" }),
        Shape::Number => json!({ "type": "number" }),
        Shape::Whole(least, most) => whole(*least, *most),
        Shape::Text => json!({ "type": "string" }),
        Shape::Word(words) => json!({ "enum": words }),
        Shape::Numbers(dims) => lists(dims, of_shape(&Shape::Number)),
        Shape::Wholes(dims, least, most) => lists(dims, whole(*least, *most)),
        Shape::Table(table) => of_fields(table.fields),
        Shape::List(entry) => lists(&[Dim::ANY], of_shape(entry)),
        Shape::OrNull(shape) => json!({ "anyOf": [of_shape(shape), { "type": "null" }] }),
    }
}

pub fn of_fields(fields: &[Field]) -> Json {
    let property = |field: &Field| (field.name.to_owned(), of_shape(field.shape));
    let properties: Map<String, Json> = fields.iter().map(property).collect();
    let of_need = |need| {
        let fields = fields.iter().filter(move |field| field.need == need);
        fields.map(|field| field.name)
    };
    let required: Vec<&str> = of_need(Presence::Required).collect();
    let choices = of_need(Presence::Choice).map(|name| json!({ "required": [name] }));
    let choices: Vec<Json> = choices.collect();
    let mut schema = json!({
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    });
    if !choices.is_empty() {
        schema["oneOf"] = choices.into();
    }
    schema
}

/// A whole number; a bound that every number keeps is left out.
fn whole(least: i64, most: i64) -> Json {
    let mut schema = json!({ "type": "integer" });
    if least > i64::MIN {
        schema["minimum"] = least.into();
    }
    if most < i64::MAX {
        schema["maximum"] = most.into();
    }
    schema
}

fn lists(dims: &[Dim], entry: Json) -> Json {
    dims.iter().rev().fold(entry, |items, dim| match dim {
        Dim::Exactly(n) => json!({ "type": "array", "items": items, "minItems": n, "maxItems": n }),
        Dim::UpTo(_) => json!({ "type": "array", "items": items }),
    })
}
