//! The sentences of one polygon and of triangle by triangle.

use crate::{
    algo::{
        ring::Rule,
        volume::{
            IntersectionPolygonEvent, IntersectionPolygonState, PlaneAtATimeEvent,
            PlaneAtATimeState, SpaceVertex, TrianglePlanes,
        },
    },
    figure::Caption,
    geom::Plane,
    labs::words::{name, subscript},
    text::{Formula, Message, Value},
};

use super::{
    super::{
        super::OnSceneInput,
        planes::{distance_formula, plane_name, triple},
    },
    marks::{cut_symbol, vertex_symbol},
};

type Input = OnSceneInput<TrianglePlanes>;

/// `V₀, V₂`
fn names(symbols: impl IntoIterator<Item = String>) -> Value {
    let symbols: Vec<String> = symbols.into_iter().collect();
    name(symbols.join(", "))
}

fn vertex(idx: usize) -> Value {
    name(vertex_symbol(idx))
}

/// With the name of a plane.
fn on_plane(key: &'static str, input: &Input, plane_idx: Option<usize>) -> Message {
    let plane = plane_name(input.scenery.as_deref(), plane_idx.unwrap_or(0));
    Message::new(key).with("plane", plane)
}

fn plane_formulas(caption: Caption, plane: Option<&Plane>) -> Caption {
    match plane {
        Some(plane) => caption
            .so(triple("n", plane.normal()))
            .so(Formula::default().sym("D").equals(plane.d())),
        None => caption,
    }
}

/// `d₂ = n·V₂ + D = …`
fn distance(plane: &Plane, idx: usize, at: [f64; 3], d: f64) -> Formula {
    let symbols = [format!("d{}", subscript(idx)), vertex_symbol(idx)];
    let relation = if d > 0.0 {
        " > 0"
    } else if d < 0.0 {
        " < 0"
    } else {
        ""
    };
    distance_formula([&symbols[0], &symbols[1]], plane, at, d).sym(relation)
}

/// `t = d₂ / (d₂ − d₃) = 1.26 / (1.26 − (−1.81)) = 0.41`
fn parameter(symbol: &str, idx: [usize; 2], [d1, d2]: [f64; 2]) -> Formula {
    let [s, p] = idx.map(|i| format!("d{}", subscript(i)));
    let whole = Formula::default().sym(s.clone()).sym(" − ").sym(p);
    let numbers = Formula::default().num(d1).sym(" − ").operand(d2);
    Formula::default()
        .sym(format!("{symbol} = "))
        .over(Formula::default().sym(s), whole)
        .sym(" = ")
        .over(Formula::default().num(d1), numbers)
        .equals(d1 / (d1 - d2))
}

/// Between which vertices a crossing lies, where it is, and where in the texture.
fn cross_caption(
    on_plane: Message,
    nth: usize,
    (idx, d): ([usize; 2], [f64; 2]),
    at: SpaceVertex,
) -> Caption {
    let symbol = cut_symbol(nth);
    let message = on_plane
        .with("from", vertex(idx[0]))
        .with("to", vertex(idx[1]))
        .with("cut", name(symbol.clone()));
    let caption = Caption::new(message).so(parameter("t", idx, d));
    match at.uv {
        Some(uv) => {
            let [s, p] = idx.map(|i| format!("uv{}", subscript(i)));
            let formula = format!("uv({symbol}) = {s} + t·({p} − {s}) = ");
            caption.so(Formula::default().sym(formula).point(uv))
        }
        None => caption.so(Formula::default().sym(format!("{symbol} = ")).place(at.at)),
    }
}

pub fn polygon_caption(
    event: &IntersectionPolygonEvent,
    before: &IntersectionPolygonState,
    input: &Input,
) -> Caption {
    use IntersectionPolygonEvent as Event;
    let own = &input.own;
    let at_work = before.plane_idx.and_then(|i| own.planes.get(i));
    match *event {
        Event::Plane { plane_idx } => {
            let message = on_plane("ip-plane", input, Some(plane_idx));
            let caption = Caption::new(message.with("n", before.input.len()));
            plane_formulas(caption, own.planes.get(plane_idx))
        }
        Event::First {
            at,
            distance: d,
            inside,
        } => {
            let key = if inside {
                "ip-first-inside"
            } else {
                "ip-first-outside"
            };
            let message = on_plane(key, input, before.plane_idx).with("vertex", vertex(0));
            let formula = at_work.map(|plane| distance(plane, 0, at.at, d));
            formula.into_iter().fold(Caption::new(message), Caption::so)
        }
        Event::Test {
            idx,
            ends,
            distances,
            rule,
        } => {
            let cut = cut_symbol(before.crossings.len());
            let caption = Caption::new(test_message(idx, distances, rule, cut));
            let formula = at_work.map(|plane| distance(plane, idx[1], ends[1].at, distances[1]));
            formula.into_iter().fold(caption, Caption::so)
        }
        Event::Cross { at, .. } => {
            let test = before.test.map(|(idx, d, _)| (idx, d));
            let on_plane = on_plane("ip-cross", input, before.plane_idx);
            let test = test.unwrap_or(([0; 2], [1.0, 0.0]));
            cross_caption(on_plane, before.crossings.len(), test, at)
        }
        Event::Output { at } => {
            let symbol = put_out(before, at);
            let message = Message::new("ip-output").with("vertex", name(symbol.clone()));
            Caption::new(message.with("n", before.output.len() + 1))
                .so(Formula::default().sym(format!("{symbol} = ")).place(at.at))
        }
        Event::Pass { n_vertices, .. } => pass_caption(before, input, n_vertices),
        Event::Fan { triangle } => fan_caption(before, &triangle),
        Event::Done { n_triangles } => {
            let key = if n_triangles == 0 {
                "ip-done-empty"
            } else {
                "ip-done"
            };
            let message = Message::new(key)
                .with("n", n_triangles)
                .with("vertices", before.input.len())
                .with("crossings", before.n_crossings);
            Caption::new(message)
        }
    }
}

fn fan_caption(before: &IntersectionPolygonState, triangle: &[SpaceVertex; 3]) -> Caption {
    let message = Message::new("ip-fan")
        .with("n", before.triangles.len() + 1)
        .with("total", before.input.len().saturating_sub(2));
    let corner = |v: &SpaceVertex| before.input.iter().position(|other| other == v);
    let symbols = triangle.iter().filter_map(corner).map(vertex_symbol);
    Caption::new(message.with("corners", names(symbols)))
}

/// The rules are those of the plane.
fn test_message(idx: [usize; 2], distances: [f64; 2], rule: Rule, cut: String) -> Message {
    let is_crossed = distances.iter().all(|&d| d != 0.0);
    let (key, rule_key) = match rule {
        Rule::InIn => ("sh-in-in", "rule-in-in"),
        Rule::InOut => ("ip-in-out", "rule-in-out"),
        Rule::OutIn => ("ip-out-in", "rule-out-in"),
        Rule::OutOut => ("sh-out-out", "rule-out-out"),
    };
    let (key, has_rule) = match (idx[1], rule.changes_side(), is_crossed) {
        (0, true, true) => ("ip-closing-cross", true),
        (0, ..) => ("sh-closing", true),
        (_, true, false) => ("ip-touch", true),
        (..) => (key, false),
    };
    let message = Message::new(key)
        .with("from", vertex(idx[0]))
        .with("to", vertex(idx[1]));
    let message = if rule.changes_side() && is_crossed {
        message.with("cut", name(cut))
    } else {
        message
    };
    if has_rule {
        message.with("rule", Value::Term(rule_key))
    } else {
        message
    }
}

/// The crossing, or the vertex of the list in that it is.
fn put_out(before: &IntersectionPolygonState, at: SpaceVertex) -> String {
    match (before.crossing, before.test) {
        (Some((crossing, _)), _) if crossing == at => {
            cut_symbol(before.crossings.len().saturating_sub(1))
        }
        (_, Some((idx, ..))) => vertex_symbol(idx[1]),
        (_, None) => vertex_symbol(0),
    }
}

fn pass_caption(before: &IntersectionPolygonState, input: &Input, n_vertices: usize) -> Caption {
    let sides = before.sides.iter().enumerate();
    let dropped = sides.filter(|(_, (_, inside))| !inside);
    let dropped: Vec<String> = dropped.map(|(i, _)| vertex_symbol(i)).collect();
    let cuts: Vec<String> = (0..before.crossings.len()).map(cut_symbol).collect();
    let key = match (n_vertices, dropped.is_empty(), cuts.is_empty()) {
        (0, ..) => "ip-pass-empty",
        (_, true, _) => "ip-pass-same",
        (_, false, true) => "ip-pass-drops",
        (_, false, false) => "ip-pass-cuts",
    };
    let message = on_plane(key, input, before.plane_idx)
        .with("dropped", names(dropped))
        .with("cuts", names(cuts))
        .with("before", before.input.len())
        .with("after", n_vertices);
    let caption = Caption::new(message);
    let parameters = before
        .crossings
        .iter()
        .enumerate()
        .filter_map(|(i, (idx, ..))| {
            let d = [before.sides.get(idx[0])?.0, before.sides.get(idx[1])?.0];
            Some(parameter(&format!("t({})", cut_symbol(i)), *idx, d))
        });
    parameters.fold(caption, Caption::so)
}

/// `T₁`
pub fn triangle_symbol(idx: usize) -> String {
    format!("T{}", subscript(idx + 1))
}

const fn triangle_key(n_inside: usize, n_on: usize) -> &'static str {
    match (n_inside, n_on) {
        (1 | 2, 1..) => "pat-on",
        (0, _) => "pat-none",
        (1, _) => "pat-one",
        (2, _) => "pat-two",
        (3.., _) => "pat-three",
    }
}

/// By the names of its corners: vertices of the triangle that was asked, and cuts.
fn piece_caption(before: &PlaneAtATimeState, triangle: &[SpaceVertex; 3]) -> Caption {
    let asked = before.asked.last();
    let corners = asked.and_then(|asked| before.list.get(asked.triangle_idx));
    let symbol = |v: &SpaceVertex| {
        let cut = before.crossings.iter().position(|(_, at, _)| at == v);
        let corner = || corners?.iter().position(|other| other == v);
        cut.map(cut_symbol).or_else(|| corner().map(vertex_symbol))
    };
    let message = Message::new("pat-piece")
        .with("n", before.next.len() + 1)
        .with("corners", names(triangle.iter().filter_map(symbol)));
    Caption::new(message)
}

pub fn one_by_one_caption(
    event: &PlaneAtATimeEvent,
    before: &PlaneAtATimeState,
    input: &Input,
) -> Caption {
    use PlaneAtATimeEvent as Event;
    let own = &input.own;
    match *event {
        Event::Plane {
            plane_idx,
            n_triangles,
        } => {
            let message = on_plane("pat-plane", input, Some(plane_idx));
            let caption = Caption::new(message.with("n", n_triangles));
            plane_formulas(caption, own.planes.get(plane_idx))
        }
        Event::Triangle {
            triangle_idx,
            distances,
            inside,
        } => {
            let n_inside = inside.iter().filter(|&&inside| inside).count();
            let n_on = (0..3).filter(|&i| inside[i] && distances[i] == 0.0).count();
            let message = on_plane(triangle_key(n_inside, n_on), input, before.plane_idx)
                .with("triangle", name(triangle_symbol(triangle_idx)))
                .with("inside", n_inside)
                .with("on", n_on);
            let formulas = distances.iter().enumerate().map(|(i, &d)| {
                Formula::default()
                    .sym(format!("d{}", subscript(i)))
                    .equals(d)
            });
            formulas.fold(Caption::new(message), Caption::so)
        }
        Event::Cross { idx, at, .. } => {
            let asked = before.asked.last();
            let d = asked.map_or([1.0, 0.0], |asked| idx.map(|i| asked.distances[i]));
            let on_plane = on_plane("ip-cross", input, before.plane_idx);
            cross_caption(on_plane, before.crossings.len(), (idx, d), at)
        }
        Event::Piece { triangle } => piece_caption(before, &triangle),
        Event::Pass { n_triangles, .. } => {
            let key = if n_triangles == 0 {
                "pat-pass-empty"
            } else {
                "pat-pass"
            };
            let message = on_plane(key, input, before.plane_idx)
                .with("before", before.list.len())
                .with("after", n_triangles);
            Caption::new(message)
        }
        Event::Done { n_triangles } => {
            let key = if n_triangles == 0 {
                "pat-done-empty"
            } else {
                "pat-done"
            };
            let message = Message::new(key)
                .with("n", n_triangles)
                .with("crossings", before.n_crossings);
            Caption::new(message)
        }
    }
}
