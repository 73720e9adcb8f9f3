//! The vertices of the two lists of Sutherland–Hodgman: their names, on stage and as rows of the watch table.

use super::{prelude::*, skin::LabVertex};

pub const LISTS: &str = "lists";
/// Lists up to this length are shown whole, side by side.
const FEW: usize = 12;
const ROWS: usize = 6;
/// Up to this many vertices get their names on stage.
pub const NAMED: usize = 24;

/// `V₃′`: in the output list.
pub fn output_symbol(idx: usize) -> String {
    format!("{}′", vertex_symbol(idx))
}

pub const fn vertex_link(idx: usize) -> Link {
    Link::nth("vertex", idx)
}

fn point<V: Vertex>(vertex: &V) -> Value {
    Value::Point(vertex.at().to_array())
}

/// Input list and output list, with their places in the texture where they have such. Where they are long: the
/// input about `current`, and the output's end.
pub fn rows<V: LabVertex>(input: &[V], output: &[V], current: usize) -> Vec<WatchSection> {
    let n = input.len().max(output.len());
    if n <= FEW {
        let table = |header: [&'static str; 2], value: fn(&V) -> Option<Value>| {
            let row = |i: usize| {
                let cells = [input, output].map(|list| list.get(i).and_then(value));
                WatchRow::table(name((i + 1).to_string()), cells.to_vec()).linked(vertex_link(i))
            };
            WatchSection::table(header.to_vec(), (0..n).map(row).collect())
        };
        let places = table(["V", "V′"], |v| Some(point(v)));
        let texels = V::IS_TEXTURED.then(|| table(["uv", "uv′"], |v| v.uv().map(Value::Point)));
        return std::iter::once(places).chain(texels).collect();
    }
    let first = current
        .saturating_sub(ROWS / 2)
        .min(input.len().saturating_sub(ROWS));
    let shown = input.iter().enumerate().skip(first).take(ROWS);
    let input_rows = shown
        .map(|(i, v)| WatchRow::new(name(vertex_symbol(i)), Some(point(v))).linked(vertex_link(i)));
    let start = output.len().saturating_sub(ROWS);
    let shown = output.iter().enumerate().skip(start);
    let output_rows = shown.map(|(i, v)| WatchRow::new(name(output_symbol(i)), Some(point(v))));
    vec![
        WatchSection::list(input_rows.collect()).part(first, input.len()),
        WatchSection::list(output_rows.collect()).part(start, output.len()),
    ]
}

/// Vertices with their names, and their places in the texture, where they are few; but for those that this step shows
/// by themselves. Hollow where they are known to be outside. Those at one place have one label.
pub fn names<V: LabVertex>(
    list: &[V],
    symbol: fn(usize) -> String,
    role: Role,
    sides: &[(f64, bool)],
    shown: &[usize],
) -> Vec<Mark> {
    if list.len() > NAMED {
        return Vec::new();
    }
    let others: Vec<usize> = (0..list.len()).filter(|i| !shown.contains(i)).collect();
    let is_first =
        |&&i: &&usize| others.iter().find(|&&k| list[k].at() == list[i].at()) == Some(&i);
    let mark = |&i: &usize| {
        let at = list[i].at();
        let here = others.iter().filter(|&&k| list[k].at() == at);
        let symbols: Vec<String> = here.map(|&k| symbol(k)).collect();
        let point = at.to_array();
        let is_outside = matches!(sides.get(i), Some((_, false)));
        let role = if is_outside { Role::Discarded } else { role };
        Mark::new(role, Shape::dot_or_ring(!is_outside, point))
            .labelled(with_texel(symbols.join(", "), &list[i]))
            .linked(vertex_link(i))
    };
    others.iter().filter(is_first).map(mark).collect()
}

/// `V₂ (1, 1/4)`, or the name alone of a vertex that has no place in a texture.
pub fn with_texel<V: LabVertex>(symbol: String, vertex: &V) -> Value {
    match vertex.uv() {
        Some(uv) => Formula::default().sym(symbol).sym(" ").point(uv).into(),
        None => name(symbol),
    }
}

/// In the middle of its vertices.
pub fn middle(ring: &[Point]) -> [f64; 2] {
    let mean = |of: fn(&Point) -> f64| ring.iter().map(of).sum::<f64>() / ring.len() as f64;
    [mean(|at| at.x()), mean(|at| at.y())]
}

pub fn outline<V: Vertex>(ring: &[V]) -> Vec<[f64; 2]> {
    ring.iter().map(|v| v.at().to_array()).collect()
}
