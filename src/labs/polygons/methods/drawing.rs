//! The drawing of a step of Sutherland–Hodgman: the clip edge, both lists as outlines, and what happens now.

use crate::algo::polygon::{
    SutherlandHodgman, SutherlandHodgmanEvent as Event, SutherlandHodgmanInput as Input,
};

use super::{
    clip_edge::ClipEdge,
    lists::{names, outline, output_symbol, vertex_link, with_texel},
    prelude::*,
    result::{bridges, result},
    skin::{LabVertex, skin},
    variant::Variant,
};

/// What the views of a step show.
pub struct Picture<'a, V> {
    pub input: &'a Input<V>,
    pub rings: RingStep<'a, V>,
    edge: Option<ClipEdge<'a>>,
    pub event: Option<Event<V>>,
    pub n_passed: usize,
}

impl<'a, V: LabVertex> Picture<'a, V> {
    pub fn of<L: Variant>(step: &Step<'a, SutherlandHodgman<V, L>>) -> Self {
        let is_turn = |event: &Event<V>| matches!(event, Event::Edge { .. });
        Self {
            input: step.input,
            rings: RingStep::of(&step.held.lists, step.past, is_turn),
            edge: edge(step),
            event: step.event(),
            n_passed: step.held.lists.n_passed(),
        }
    }
}

/// The clip edge whose turn it is.
pub fn edge<'a, V: LabVertex, L: Variant>(
    step: &Step<'a, SutherlandHodgman<V, L>>,
) -> Option<ClipEdge<'a>> {
    let region = &step.input.region;
    let nth = step.held.lists.n_passed();
    let idx = match step.event()? {
        Event::Edge { edge_idx, .. } | Event::Pass { edge_idx, .. } => edge_idx,
        Event::Done { .. } => return None,
        Event::First { .. } | Event::Test { .. } | Event::Cross { .. } | Event::Output { .. } => {
            if L::CLOCKWISE {
                region.n_edges() - 1 - nth
            } else {
                nth
            }
        }
    };
    Some(ClipEdge::new::<L>(region, idx))
}

pub fn marks<V: LabVertex>(now: &Picture<'_, V>) -> Vec<Mark> {
    let (list, sides) = (now.rings.list, &now.rings.turn.sides);
    let mut marks = Vec::from_iter(skin(list));
    if let Some(Event::Done { outcome }) = now.event {
        marks.extend(end(now.input, list, outcome));
        return marks;
    }
    let is_quiet = matches!(now.event, Some(Event::Output { .. } | Event::Pass { .. }));
    let role = if is_quiet { Role::Soft } else { Role::Signal };
    marks.extend(now.edge.map(|edge| edge.mark(role)));
    if let Some(Event::Pass { .. }) = now.event {
        let left = Mark::new(Role::Accent, Shape::Outline(outline(list)));
        marks.push(left.linked("input"));
        marks.extend(names(list, output_symbol, Role::Accent, &[], &[]));
        if list.is_empty() {
            let passed = names(now.rings.passed, vertex_symbol, Role::Discarded, sides, &[]);
            marks.extend(passed);
        }
        marks.extend(bridges(list, &now.input.region, "sh-bridge"));
        return marks;
    }
    marks.push(Mark::new(Role::Ink, Shape::Outline(outline(list))).linked("input"));
    marks.push(Mark::new(Role::Accent, Shape::Path(outline(now.rings.output))).linked("output"));
    let shown = now.rings.current();
    marks.extend(names(list, vertex_symbol, Role::Soft, sides, &shown));
    let begins = matches!(now.event, Some(Event::Edge { .. } | Event::First { .. }));
    marks.extend(now.edge.iter().flat_map(|edge| edge.others(begins)));
    marks.extend(moment(now));
    marks
}

/// The result, over what the right rules leave where that is something else: then it is not accepted.
fn end<V: LabVertex>(input: &Input<V>, ring: &[V], outcome: RingOutcome) -> Vec<Mark> {
    let right = right_result(input, ring);
    let role = result_role(right.is_some());
    let right = right.map(|right| {
        let shape = Shape::Outline(outline(&right));
        let said = Message::new("result-right").with("n", right.len());
        let mark = Mark::new(Role::Accent, shape).labelled(said);
        mark.linked("right")
    });
    let given = &input.vertices;
    let mut result = result(ring, (outcome, role), &input.region, given);
    if right.is_some() && outcome != RingOutcome::Empty {
        let said = Message::new("result-wrong").with("n", ring.len());
        result[0] = result[0].clone().labelled(said);
    }
    let names = match outcome {
        RingOutcome::Empty => names(given, vertex_symbol, Role::Discarded, &[], &[]),
        RingOutcome::Degenerate | RingOutcome::Whole | RingOutcome::Cut => {
            names(ring, output_symbol, role, &[], &[])
        }
    };
    right
        .into_iter()
        .chain(result)
        .chain(names)
        .chain(slipped(given, ring))
        .collect()
}

/// What the right rules leave, where these leave something else.
pub fn right_result<V: LabVertex>(input: &Input<V>, ring: &[V]) -> Option<Vec<V>> {
    let right = silent::<SutherlandHodgman<V>>(input).vertices;
    (right != ring).then_some(right)
}

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
        let label = Formula::default().point(uv);
        let ring = Mark::new(Role::Ink, Shape::Ring(home)).labelled(label);
        [arrow, ring]
    });
    marks.collect()
}

fn moment<V: LabVertex>(now: &Picture<'_, V>) -> Vec<Mark> {
    let mut marks = Vec::new();
    let vertex = |i: usize, is_inside: bool| {
        let at = now.rings.list[i].at().to_array();
        Mark::new(Role::Signal, Shape::dot_or_ring(is_inside, at))
            .labelled(with_texel(vertex_symbol(i), &now.rings.list[i]))
            .strong()
            .linked(vertex_link(i))
    };
    match (now.rings.asked.test, now.rings.turn.sides.first()) {
        (Some(test), _) => {
            let ends = test.ends.map(|v| v.at().to_array());
            marks.push(Mark::new(Role::Signal, Shape::Arrow(ends)));
            marks.extend((0..2).map(|i| vertex(test.idx[i], test.inside()[i])));
        }
        (None, Some(&(_, is_inside))) => marks.push(vertex(0, is_inside)),
        (None, None) => {}
    }
    if let Some(Crossing { at: crossing, t }) = now.rings.asked.crossing {
        let label = Formula::default().sym("I: t = ").ratio(t.num, t.den);
        let label = match crossing.uv() {
            Some(uv) => label.sym(", ").point(uv),
            None => label,
        };
        let dot = Shape::Dot(crossing.at().to_array());
        marks.push(Mark::new(Role::Signal, dot).labelled(label).strong());
    }
    if let Some(Event::Output { at }) = now.event {
        let last = output_symbol(now.rings.output.len().saturating_sub(1));
        let dot = Shape::Dot(at.at().to_array());
        marks.push(Mark::new(Role::Accent, dot).labelled(name(last)).strong());
    }
    marks
}
