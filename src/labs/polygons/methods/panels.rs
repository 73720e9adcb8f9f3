//! Small drawings beside the lists, of all that a step is one of: the four rules, the passes, or how many vertices of a triangle
//! are inside. They come from a run to the end.

use crate::{
    algo::{
        polygon::{
            SutherlandHodgman, SutherlandHodgmanEvent as Event, SutherlandHodgmanInput as Input,
        },
        ring::{EdgeTest, Rule},
    },
    figure::{Multiples, SmallDrawing},
    geom::extent,
    labs::{polygons::Panels, rings::rule_term},
};

use super::{
    clip_edge::ClipEdge,
    lists::{NAMED, outline},
    prelude::*,
    skin::LabVertex,
    variant::Variant,
};

const PANELS: &str = "panels";

struct Pass<V> {
    edge_idx: usize,
    before: Vec<V>,
    after: Vec<V>,
    walks: Vec<Walk<V>>,
}

/// An edge of the polygon, and what of the list after it was there before it, and with it.
struct Walk<V> {
    test: EdgeTest<V>,
    n_before: usize,
    n_after: usize,
}

/// None of a long list.
pub fn view<V: LabVertex, L: Variant>(
    step: &Step<'_, SutherlandHodgman<V, L>>,
    panels: Panels,
) -> Option<View> {
    if step.input.vertices.len() > NAMED {
        return None;
    }
    let row = match panels {
        Panels::None => return None,
        Panels::Rules => rules(step)?,
        Panels::Passes => all_passes(step),
        Panels::Vertices => places(step)?,
    };
    Some(View::new(PANELS, Body::Multiples(row)))
}

fn passes<V: LabVertex, L: Variant>(input: &Input<V>) -> Vec<Pass<V>> {
    let mut passes = Vec::new();
    Recording::<SutherlandHodgman<V, L>>::looking(input.clone(), |now| {
        if let Some(Event::Pass { edge_idx, .. }) = now.event() {
            let lists = &now.held.lists;
            passes.push(Pass {
                edge_idx,
                before: lists.other().clone(),
                after: lists.list().clone(),
                walks: walks(now.past),
            });
        }
    });
    passes
}

/// The edges that have been walked since the last clip edge's turn.
fn walks<V: LabVertex>(past: &[Event<V>]) -> Vec<Walk<V>> {
    let is_turn = |event: &Event<V>| matches!(event, Event::Edge { .. });
    let start = past.iter().rposition(is_turn).unwrap_or_default();
    let (mut walks, mut n_out) = (Vec::<Walk<V>>::new(), 0);
    for event in &past[start..] {
        match *event {
            Event::Test(test) => walks.push(Walk {
                test,
                n_before: n_out,
                n_after: n_out,
            }),
            Event::Output { .. } => {
                n_out += 1;
                if let Some(walk) = walks.last_mut() {
                    walk.n_after = n_out;
                }
            }
            _ => {}
        }
    }
    walks
}

/// Each rule with the edge at work, else with the last that has come under it, else with the first that will.
fn rules<V: LabVertex, L: Variant>(step: &Step<'_, SutherlandHodgman<V, L>>) -> Option<Multiples> {
    let passes = passes::<V, L>(step.input);
    let pass = passes.get(nth_pass(step))?;
    let asked = Asked::of(step.past).test;
    let n_walked = match (asked, step.event()) {
        (Some(test), _) => pass.walks.iter().position(|it| it.test.idx == test.idx),
        (None, Some(Event::Pass { .. } | Event::Done { .. })) => Some(pass.walks.len()),
        (None, _) => None,
    };
    let edge = ClipEdge::new::<L>(&step.input.region, pass.edge_idx);
    let drawing = |rule: Rule| {
        let of_rule = pass.walks.iter().enumerate();
        let mut of_rule = of_rule.filter(|(_, walk)| walk.test.rule == rule);
        let has_come = |(i, _): &(usize, _)| n_walked.is_some_and(|n| *i <= n);
        let walk = of_rule.clone().rfind(has_come).or_else(|| of_rule.next());
        let is_current = walk.is_some_and(|(i, _)| Some(i) == n_walked);
        let mut marks = vec![wash(&edge, is_current)];
        marks.push(Mark::new(Role::Soft, Shape::Outline(outline(&pass.before))));
        marks.extend(
            walk.iter()
                .flat_map(|(_, walk)| walk_marks(pass, walk, is_current)),
        );
        SmallDrawing {
            title: Value::Term(rule_term(rule)),
            note: walk.map(|(_, walk)| name(format!("+{}", walk.n_after - walk.n_before))),
            marks,
            is_current,
            is_to_come: !walk.as_ref().is_some_and(has_come),
            link: None,
        }
    };
    Some(Multiples {
        drawings: Rule::ALL.map(drawing).to_vec(),
        bounds: extent(pass.before.iter().map(Vertex::at)),
        is_beside: true,
    })
}

/// From S to P, over what was put out before, and under what is put out now, by name.
fn walk_marks<V: LabVertex>(pass: &Pass<V>, walk: &Walk<V>, is_current: bool) -> Vec<Mark> {
    let EdgeTest { idx, ends, .. } = walk.test;
    let role = if is_current { Role::Signal } else { Role::Ink };
    let mut marks = Vec::new();
    if walk.n_before > 1 {
        let path = Shape::Path(outline(&pass.after[..walk.n_before]));
        marks.push(Mark::new(Role::Accent, path));
    }
    let places = ends.map(|end| end.at().to_array());
    marks.push(Mark::new(role, Shape::Arrow(places)));
    let ends = places.into_iter().zip(walk.test.inside());
    marks.extend(ends.map(|(at, is_inside)| Mark::new(role, Shape::dot_or_ring(is_inside, at))));
    let put_out = pass.after[walk.n_before..walk.n_after].iter();
    marks.extend(put_out.map(|vertex| {
        let is_end = *vertex == walk.test.ends[1];
        let label = if is_end {
            vertex_symbol(idx[1])
        } else {
            "I".to_owned()
        };
        let dot = Shape::Dot(vertex.at().to_array());
        Mark::new(Role::Accent, dot).labelled(name(label)).strong()
    }));
    marks
}

fn all_passes<V: LabVertex, L: Variant>(step: &Step<'_, SutherlandHodgman<V, L>>) -> Multiples {
    let region = &step.input.region;
    let passes = passes::<V, L>(step.input);
    let has_begun = !step.past.is_empty();
    let is_done = matches!(step.event(), Some(Event::Done { .. }));
    let now = nth_pass(step);
    let corners: Vec<Point> = match region {
        ClipRegion::Window(window) => window.corners().to_vec(),
        ClipRegion::Convex(polygon) => polygon.vertices().to_vec(),
    };
    let drawing = |nth: usize| {
        let pass = passes.get(nth).filter(|_| has_begun);
        let edge = ClipEdge::new::<L>(region, pass.map_or(nth, |pass| pass.edge_idx));
        let is_current = has_begun && !is_done && nth == now;
        let mut marks = vec![
            wash(&edge, is_current),
            Mark::new(Role::Soft, Shape::Outline(outline(&corners))),
        ];
        marks.extend(pass.iter().flat_map(|pass| pass_marks(pass, is_current)));
        SmallDrawing {
            title: edge.border(),
            note: pass.map(Pass::lengths),
            marks,
            is_current,
            is_to_come: !is_done && nth > now,
            link: Some(edge.link()),
        }
    };
    let given = step.input.vertices.iter().map(Vertex::at);
    Multiples {
        drawings: (0..region.n_edges()).map(drawing).collect(),
        bounds: extent(given.chain(corners.iter().copied())),
        is_beside: true,
    }
}

/// The pass at work, or the one that was done with last.
fn nth_pass<V: LabVertex, L: Variant>(step: &Step<'_, SutherlandHodgman<V, L>>) -> usize {
    let is_over = matches!(step.event(), Some(Event::Pass { .. } | Event::Done { .. }));
    step.held.lists.n_passed().saturating_sub(is_over.into())
}

fn wash(edge: &ClipEdge<'_>, is_current: bool) -> Mark {
    let role = if is_current { Role::Signal } else { Role::Soft };
    Mark {
        label: None,
        ..edge.mark(role)
    }
}

impl<V: LabVertex> Pass<V> {
    /// `4 → 5`
    fn lengths(&self) -> Value {
        name(format!("{} → {}", self.before.len(), self.after.len()))
    }
}

/// What went in, dashed; what is left, and where it was cut.
fn pass_marks<V: LabVertex>(pass: &Pass<V>, is_current: bool) -> Vec<Mark> {
    let given = Mark::new(Role::Discarded, Shape::Outline(outline(&pass.before)));
    let left = Mark::new(Role::Accent, Shape::Area(vec![outline(&pass.after)]));
    let role = if is_current {
        Role::Signal
    } else {
        Role::Accent
    };
    let cuts = pass
        .after
        .iter()
        .filter(|vertex| !pass.before.contains(vertex));
    let cuts = cuts.map(|vertex| Mark::new(role, Shape::Vertex(vertex.at().to_array())));
    [given, left].into_iter().chain(cuts).collect()
}

/// A triangle, and the first clip edge wherever it may lie: with none of the vertices inside, one, two, and all.
fn places<V: LabVertex, L: Variant>(step: &Step<'_, SutherlandHodgman<V, L>>) -> Option<Multiples> {
    let own = passes::<V, L>(step.input).into_iter().next()?;
    let distances = own.walks.iter().map(|walk| walk.test.distances[0]);
    let mut distances: Vec<f64> = distances.collect();
    distances.sort_by(f64::total_cmp);
    let [least, middle, most] = distances[..] else {
        return None;
    };
    let n_inside = own
        .walks
        .iter()
        .filter(|walk| walk.test.inside()[0])
        .count();
    let beyond = (most - least) / 4.0;
    let between = [
        most + beyond,
        middle.midpoint(most),
        least.midpoint(middle),
        least - beyond,
    ];
    let edge = ClipEdge::new::<L>(&step.input.region, own.edge_idx);
    let normal = step.input.region.half_planes()[own.edge_idx].normal();
    let square: f64 = normal.iter().map(|side| side * side).sum();
    let drawing = |n: usize| {
        let is_current = n == n_inside;
        let by = if is_current { 0.0 } else { -between[n] };
        let [there, back] = [by, -by].map(|by| normal.map(|side| by * side / square));
        let moved = Input {
            vertices: shifted(&step.input.vertices, there),
            region: step.input.region.clone(),
        };
        let pass = passes::<V, L>(&moved).into_iter().next()?;
        let pass = Pass {
            before: shifted(&pass.before, back),
            after: shifted(&pass.after, back),
            ..pass
        };
        let mut marks = vec![wash(&edge, is_current)];
        if let Shape::HalfPlane(ends) = &mut marks[0].shape {
            *ends = ends.map(|at| [0, 1].map(|i| at[i] + back[i]));
        }
        marks.extend(pass_marks(&pass, is_current));
        if let [a, _, c, _] = &pass.after[..] {
            let diagonal = Shape::Segment([a, c].map(|v| v.at().to_array()));
            marks.push(Mark::new(Role::Accent, diagonal).dashed());
        }
        Some(SmallDrawing {
            title: Message::new("sh-n-inside").with("n", n).into(),
            note: Some(pass.lengths()),
            marks,
            is_current,
            is_to_come: false,
            link: None,
        })
    };
    Some(Multiples {
        drawings: (0..=3).filter_map(drawing).collect(),
        bounds: extent(step.input.vertices.iter().map(Vertex::at)),
        is_beside: true,
    })
}

fn shifted<V: LabVertex>(list: &[V], by: [f64; 2]) -> Vec<V> {
    let shifted = |vertex: &V| {
        let [x, y] = [vertex.at().x() + by[0], vertex.at().y() + by[1]];
        V::with_uv(
            Point::new(x, y).unwrap_or_default(),
            vertex.uv().unwrap_or_default(),
        )
    };
    list.iter().map(shifted).collect()
}
