//! The four rules in words.

use crate::{
    algo::polygon::Rule,
    figure::Caption,
    geom::Point,
    labs::words::{name, vertex_symbol},
    text::{Message, Value},
};

use super::clip_edge::ClipEdge;

/// The four rules, on the border and on the closing edge.
pub fn test_caption(
    edge: &ClipEdge<'_>,
    idx: [usize; 2],
    ends: [Point; 2],
    distances: [f64; 2],
    rule: Rule,
) -> Caption {
    let symbols = idx.map(vertex_symbol);
    let is_closing = idx[1] == 0;
    let key = rule_key(rule, is_crossed(rule, distances), is_closing);
    let message = Message::new(key)
        .with("from", name(symbols[0].clone()))
        .with("to", name(symbols[1].clone()));
    let message = if is_closing {
        message.with("rule", Value::Term(rule_term(rule)))
    } else {
        message
    };
    let is_inside = [starts_inside(rule), rule.ends_inside()];
    let positions =
        (0..2).map(|i| edge.position(&(symbols[i].clone(), ends[i]), distances[i], is_inside[i]));
    positions.fold(Caption::new(message), Caption::so)
}

/// Does an edge that changes sides have a crossing? Not if it only touches the border with its inside end.
pub fn is_crossed(rule: Rule, distances: [f64; 2]) -> bool {
    rule.changes_side() && distances.iter().all(|&d| d != 0.0)
}

/// Catalogue key of the side on which a vertex lies.
pub const fn side_term(is_inside: bool) -> &'static str {
    if is_inside { "sh-inside" } else { "sh-outside" }
}

/// Does the edge begin inside?
pub const fn starts_inside(rule: Rule) -> bool {
    matches!(rule, Rule::InIn | Rule::InOut)
}

const fn rule_key(rule: Rule, is_crossed: bool, is_closing: bool) -> &'static str {
    match (rule, is_crossed, is_closing) {
        (_, true, true) => "sh-closing-cross",
        (_, false, true) => "sh-closing",
        (Rule::InIn, ..) => "sh-in-in",
        (Rule::OutOut, ..) => "sh-out-out",
        (Rule::InOut, true, _) => "sh-in-out",
        (Rule::InOut, false, _) => "sh-in-out-touch",
        (Rule::OutIn, true, _) => "sh-out-in",
        (Rule::OutIn, false, _) => "sh-out-in-touch",
    }
}

/// Catalogue key of a rule's name.
pub const fn rule_term(rule: Rule) -> &'static str {
    match rule {
        Rule::InIn => "rule-in-in",
        Rule::InOut => "rule-in-out",
        Rule::OutIn => "rule-out-in",
        Rule::OutOut => "rule-out-out",
    }
}
