//! The drawing of a step of Sutherland–Hodgman: the clip edge, both lists as outlines, and what happens now.

use crate::{
    algo::polygon::{
        EdgeTest, RingOutcome, SutherlandHodgman, SutherlandHodgmanEvent as Event,
        SutherlandHodgmanInput as Input, SutherlandHodgmanState as State,
    },
    figure::{Mark, Role, Shape},
    labs::words::{name, vertex_symbol},
    text::Formula,
    trace::silent,
};

use super::{
    clip_edge::{ClipEdge, EdgeLook},
    lists::{names, outline, output_symbol, vertex_link, with_texel},
    result::{bridges, result},
    rules::starts_inside,
    skin::{LabVertex, skin},
};

/// All of it; `look` is how the variant looks at its clip edges.
pub fn marks<V: LabVertex>(
    input: &Input<V>,
    state: &State<V>,
    event: Option<Event<V>>,
    look: EdgeLook,
) -> Vec<Mark> {
    let mut marks = Vec::from_iter(skin(&state.input));
    if let Some(outcome) = state.outcome {
        marks.extend(end(input, &state.input, outcome));
        return marks;
    }
    if let Some(edge_idx) = state.edge_idx {
        marks.push(
            ClipEdge::new(&input.region, edge_idx, look).mark(match event {
                Some(
                    Event::Edge { .. }
                    | Event::First { .. }
                    | Event::Test { .. }
                    | Event::Cross { .. },
                ) => Role::Signal,
                Some(Event::Output { .. } | Event::Pass { .. } | Event::Done { .. }) | None => {
                    Role::Soft
                }
            }),
        );
    }
    if let Some(Event::Pass { .. }) = event {
        let left = Mark::new(Role::Accent, Shape::Outline(outline(&state.input)));
        marks.push(left.linked("input"));
        marks.extend(names(&state.input, output_symbol, Role::Accent, &[], &[]));
        if state.input.is_empty() {
            let (passed, sides) = (&state.passed, &state.sides);
            marks.extend(names(passed, vertex_symbol, Role::Discarded, sides, &[]));
        }
        marks.extend(bridges(&state.input, &input.region));
        return marks;
    }
    marks.push(Mark::new(Role::Ink, Shape::Outline(outline(&state.input))).linked("input"));
    marks.push(Mark::new(Role::Accent, Shape::Path(outline(&state.output))).linked("output"));
    let shown = match state.test {
        Some(test) => test.idx.to_vec(),
        None => Vec::from_iter((!state.sides.is_empty()).then_some(0)),
    };
    let sides = &state.sides;
    marks.extend(names(
        &state.input,
        vertex_symbol,
        Role::Soft,
        sides,
        &shown,
    ));
    marks.extend(moment(state, event));
    marks
}

/// The result, over what the right rules leave where that is something else: then it is not accepted.
fn end<V: LabVertex>(input: &Input<V>, ring: &[V], outcome: RingOutcome) -> Vec<Mark> {
    let right = right_result(input, ring);
    let role = result_role(right.is_some());
    let right = right.map(|right| {
        let shape = Shape::Outline(outline(&right));
        Mark::new(Role::Ink, shape).dashed().linked("right")
    });
    let given = &input.vertices;
    let names = match outcome {
        RingOutcome::Empty => names(given, vertex_symbol, Role::Discarded, &[], &[]),
        RingOutcome::Degenerate | RingOutcome::Whole | RingOutcome::Cut => {
            names(ring, output_symbol, role, &[], &[])
        }
    };
    right
        .into_iter()
        .chain(result(ring, (outcome, role), &input.region, given))
        .chain(names)
        .chain(slipped(given, ring))
        .collect()
}

/// What the right rules leave, where these leave something else.
pub fn right_result<V: LabVertex>(input: &Input<V>, ring: &[V]) -> Option<Vec<V>> {
    let right = silent::<SutherlandHodgman<V>>(input).vertices;
    (right != ring).then_some(right)
}

/// Of a result: a wrong one is not accepted.
pub const fn result_role(is_wrong: bool) -> Role {
    if is_wrong {
        Role::Signal
    } else {
        Role::Accepted
    }
}

/// From where a vertex's place in the texture was given to where it is now: with the right rules it stays.
fn slipped<V: LabVertex>(given: &[V], ring: &[V]) -> Vec<Mark> {
    let place = |v: &V| v.uv().map(|uv| (uv, v.at()));
    let given: Vec<_> = given.iter().filter_map(place).collect();
    let moved = ring.iter().filter_map(place).filter_map(|(uv, now)| {
        let home = given.iter().find(|(other, _)| *other == uv)?.1;
        (home != now).then(|| (uv, home.to_array(), now.to_array()))
    });
    let marks = moved.flat_map(|(uv, home, now)| {
        let arrow = Mark::new(Role::Ink, Shape::Arrow([home, now])).dashed();
        let label = Formula::default().sym("uv = ").point(uv);
        let ring = Mark::new(Role::Ink, Shape::Ring(home)).labelled(label);
        [arrow, ring]
    });
    marks.collect()
}

/// What happens at this step: the edge, its ends, its crossing, the vertex put out.
fn moment<V: LabVertex>(state: &State<V>, event: Option<Event<V>>) -> Vec<Mark> {
    let mut marks = Vec::new();
    let vertex = |i: usize, is_inside: bool| {
        let at = state.input[i].at().to_array();
        let shape = if is_inside {
            Shape::Dot(at)
        } else {
            Shape::Ring(at)
        };
        Mark::new(Role::Signal, shape)
            .labelled(with_texel(vertex_symbol(i), &state.input[i]))
            .strong()
            .linked(vertex_link(i))
    };
    match (state.test, state.sides.first()) {
        (Some(EdgeTest { idx, rule, .. }), _) => {
            let ends = idx.map(|i| state.input[i].at().to_array());
            marks.push(Mark::new(Role::Signal, Shape::Arrow(ends)));
            marks.push(vertex(idx[0], starts_inside(rule)));
            marks.push(vertex(idx[1], rule.ends_inside()));
        }
        (None, Some(&(_, is_inside))) => marks.push(vertex(0, is_inside)),
        (None, None) => {}
    }
    if let Some((crossing, t)) = state.crossing {
        let label = Formula::default().sym("I: t = ").ratio(t.num, t.den);
        let label = match crossing.uv() {
            Some(uv) => label.sym(", uv = ").point(uv),
            None => label,
        };
        let dot = Shape::Dot(crossing.at().to_array());
        marks.push(Mark::new(Role::Signal, dot).labelled(label).strong());
    }
    if let Some(Event::Output { at }) = event {
        let last = output_symbol(state.output.len().saturating_sub(1));
        let dot = Shape::Dot(at.at().to_array());
        marks.push(Mark::new(Role::Accent, dot).labelled(name(last)).strong());
    }
    marks
}
