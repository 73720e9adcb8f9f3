//! Small drawings beside the lists, of all that a step is one of: the four rules, the passes, or how many vertices of a triangle
//! are inside. They come from a run to the end.

use std::ops::Range;

use crate::{
    algo::{
        polygon::{
            Rules, SutherlandHodgman, SutherlandHodgmanEvent as Event,
            SutherlandHodgmanInput as Input, faulty::CutsOnBorder,
        },
        ring::{EdgeTest, Rule},
    },
    figure::{Multiples, SmallDrawing},
    geom::extent,
    labs::{polygons::Panels, rings::rule_term},
};

use super::{
    clip_edge::ClipEdge,
    lists::{NAMED, outline, output_symbol},
    prelude::*,
    skin::LabVertex,
    variant::Variant,
};

struct Pass<V> {
    edge_idx: usize,
    before: Vec<V>,
    after: Vec<V>,
    /// The edges of the polygon, each with its part of the list after the pass.
    walks: Vec<(EdgeTest<V>, Range<usize>)>,
}

type Now<'a, V, L> = Step<'a, SutherlandHodgman<V, L>>;

/// None of a long list.
pub fn view<V: LabVertex, L: Variant>(step: &Now<'_, V, L>, panels: Panels) -> Option<View> {
    if step.input.vertices.len() > NAMED {
        return None;
    }
    let row = match panels {
        Panels::None => return None,
        Panels::Rules => rules(step)?,
        Panels::Passes => all_passes(step),
        Panels::Vertices => places(step)?,
    };
    Some(View::new("panels", Body::Multiples(row)))
}

fn passes<V: LabVertex, L: Rules>(input: &Input<V>) -> Vec<Pass<V>> {
    let mut passes = Vec::new();
    Recording::<SutherlandHodgman<V, L>>::looking(input.clone(), |now| {
        if let Some(Event::Pass { edge_idx, .. }) = now.event() {
            passes.push(Pass {
                edge_idx,
                before: now.held.lists.other().clone(),
                after: now.held.lists.list().clone(),
                walks: walks(now.past),
            });
        }
    });
    passes
}

fn walks<V: LabVertex>(past: &[Event<V>]) -> Vec<(EdgeTest<V>, Range<usize>)> {
    let is_turn = |event: &Event<V>| matches!(event, Event::Edge { .. });
    let start = past.iter().rposition(is_turn).unwrap_or_default();
    let (mut walks, mut n_out) = (Vec::new(), 0);
    for event in &past[start..] {
        if let Event::Test(test) = *event {
            walks.push((test, n_out..n_out));
        }
        n_out += usize::from(matches!(event, Event::Output { .. }));
        if let Some((_, put_out)) = walks.last_mut() {
            put_out.end = n_out;
        }
    }
    walks
}

/// The pass at work, or the one that was done with last.
fn nth_pass<V: LabVertex, L: Variant>(step: &Now<'_, V, L>) -> usize {
    let is_over = matches!(step.event(), Some(Event::Pass { .. } | Event::Done { .. }));
    step.held.lists.n_passed().saturating_sub(is_over.into())
}

fn row<V: Vertex>(drawings: Vec<SmallDrawing>, around: &[V]) -> Multiples {
    Multiples {
        drawings,
        bounds: extent(around.iter().map(Vertex::at)),
        tiles: Tiles::Beside,
    }
}

/// Each rule with the edge at work, else with the last that has come under it, else with the first that will.
fn rules<V: LabVertex, L: Variant>(step: &Now<'_, V, L>) -> Option<Multiples> {
    let passes = passes::<V, L>(step.input);
    let pass = passes.get(nth_pass(step))?;
    let n_walked = match (Asked::of(step.past).test, step.event()) {
        (Some(now), _) => pass.walks.iter().position(|(test, _)| test.idx == now.idx),
        (None, Some(Event::Pass { .. } | Event::Done { .. })) => Some(pass.walks.len()),
        (None, _) => None,
    };
    let edge = ClipEdge::new::<L>(&step.input.region, pass.edge_idx);
    let drawing = |rule: Rule| {
        let mut of_rule = (0..pass.walks.len()).filter(|&i| pass.walks[i].0.rule == rule);
        let has_come = |i: &usize| n_walked.is_some_and(|n| *i <= n);
        let nth = of_rule.clone().rfind(has_come).or_else(|| of_rule.next());
        let is_current = nth.is_some() && nth == n_walked;
        let given = Mark::new(Role::Soft, Shape::Outline(outline(&pass.before)));
        let mut marks = vec![wash(&edge, is_current), given];
        let n_given = marks.len();
        marks.extend(
            nth.iter()
                .flat_map(|&nth| walk_marks(pass, nth, is_current)),
        );
        let n_out = nth.map(|nth| pass.walks[nth].1.len());
        let note = n_out.map(|n| (Role::Ink, name(format!("+{n}"))));
        let is_to_come = !nth.as_ref().is_some_and(has_come);
        SmallDrawing {
            is_current,
            is_to_come,
            n_known: is_to_come.then_some(n_given),
            ..SmallDrawing::new(Value::Term(rule_term(rule)), note, marks)
        }
    };
    let in_order = [Rule::InIn, Rule::InOut, Rule::OutOut, Rule::OutIn];
    Some(row(in_order.map(drawing).to_vec(), &pass.before))
}

/// From S to P, over what was put out before, and under what is put out now, by name.
fn walk_marks<V: LabVertex>(pass: &Pass<V>, nth: usize, is_current: bool) -> Vec<Mark> {
    let (EdgeTest { idx, ends, .. }, put_out) = &pass.walks[nth];
    let role = if is_current { Role::Signal } else { Role::Ink };
    let mut marks = Vec::new();
    if put_out.start > 1 {
        let path = Shape::Path(outline(&pass.after[..put_out.start]));
        marks.push(Mark::new(Role::Accent, path));
    }
    let arrow = Shape::Arrow(ends.map(|end| end.at().to_array()));
    marks.push(Mark::new(role, arrow));
    marks.extend(pass.after[put_out.clone()].iter().map(|vertex| {
        let is_end = *vertex == ends[1];
        let symbol = if is_end {
            vertex_symbol(idx[1])
        } else {
            "I".to_owned()
        };
        let dot = Shape::Vertex(vertex.at().to_array());
        Mark::new(Role::Accent, dot).labelled(name(symbol)).strong()
    }));
    marks
}

fn all_passes<V: LabVertex, L: Variant>(step: &Now<'_, V, L>) -> Multiples {
    let region = &step.input.region;
    let passes = passes::<V, L>(step.input);
    let (has_begun, now) = (!step.past.is_empty(), nth_pass(step));
    let n_passed = step.held.lists.n_passed();
    let is_done = matches!(step.event(), Some(Event::Done { .. }));
    let mut corners: Vec<Point> = match region {
        ClipRegion::Window(window) => window.corners().to_vec(),
        ClipRegion::Convex(polygon) => polygon.vertices().to_vec(),
    };
    let drawing = |nth: usize| {
        let pass = passes.get(nth).filter(|_| has_begun);
        let edge = ClipEdge::new::<L>(region, pass.map_or(nth, |pass| pass.edge_idx));
        let is_current = has_begun && !is_done && nth == now;
        let around = Mark::new(Role::Soft, Shape::Outline(outline(&corners)));
        let mut marks = vec![wash(&edge, is_current), around];
        // Of the pass at work what goes in is known, too.
        let n_known = (nth >= n_passed).then(|| marks.len() + usize::from(nth == n_passed));
        marks.extend(pass.iter().flat_map(|pass| pass_marks(pass, is_current)));
        SmallDrawing {
            is_current,
            is_to_come: !is_done && nth > now,
            n_known,
            link: Some(edge.link()),
            ..SmallDrawing::new(edge.border(), pass.map(lengths), marks)
        }
    };
    let drawings = (0..region.n_edges()).map(drawing).collect();
    corners.extend(step.input.vertices.iter().map(Vertex::at));
    row(drawings, &corners)
}

fn wash(edge: &ClipEdge<'_>, is_current: bool) -> Mark {
    let role = if is_current { Role::Signal } else { Role::Soft };
    Mark {
        label: None,
        ..edge.mark(role)
    }
}

/// `4 → 5`
fn lengths<V>(pass: &Pass<V>) -> (Role, Value) {
    let lengths = format!("{} → {}", pass.before.len(), pass.after.len());
    (Role::Ink, name(lengths))
}

/// What went in, dashed; what is left, and where it was cut. A quad is two triangles; what stands twice is crossed out.
fn pass_marks<V: LabVertex>(pass: &Pass<V>, is_current: bool) -> Vec<Mark> {
    let role = if is_current {
        Role::Signal
    } else {
        Role::Accent
    };
    let place = |vertex: &V| vertex.at().to_array();
    let given = Mark::new(Role::Discarded, Shape::Outline(outline(&pass.before)));
    let left = Mark::new(Role::Accent, Shape::Area(vec![outline(&pass.after)]));
    let mut marks = vec![given, left];
    if let ([_, _, _], [a, _, c, _]) = (&pass.before[..], &pass.after[..]) {
        let diagonal = Shape::Segment([place(a), place(c)]);
        marks.push(Mark::new(Role::Accent, diagonal).dashed());
    }
    let cuts = pass
        .after
        .iter()
        .filter(|vertex| !pass.before.contains(vertex));
    marks.extend(cuts.map(|vertex| Mark::new(role, Shape::Vertex(place(vertex)))));
    let twice = (1..pass.after.len()).filter(|&i| pass.after[i - 1] == pass.after[i]);
    marks.extend(twice.map(|i| {
        let both = [i - 1, i].map(output_symbol).join(" = ");
        let cross = Mark::new(Role::Signal, Shape::Cross(place(&pass.after[i])));
        cross.labelled(name(both)).strong()
    }));
    marks
}

/// A triangle, and the first clip edge wherever it may lie: with none of the vertices inside, one, two, and all. Where one lies on it:
/// what a program makes of that which cuts there, too, and what is right.
fn places<V: LabVertex, L: Variant>(step: &Now<'_, V, L>) -> Option<Multiples> {
    let input = step.input;
    let first = |input: &Input<V>| passes::<V, L>(input).into_iter().next();
    let own = first(input)?;
    let edge = ClipEdge::new::<L>(&input.region, own.edge_idx);
    let tests = own.walks.iter().map(|(test, _)| test);
    let mut distances: Vec<f64> = tests.clone().map(|test| test.distances[0]).collect();
    distances.sort_by(f64::total_cmp);
    let [least, middle, most] = distances[..] else {
        return None;
    };
    let drawing = |title: Value, pass: &Pass<V>, is_current, edge| {
        let mut marks = vec![edge];
        marks.extend(pass_marks(pass, is_current));
        SmallDrawing {
            is_current,
            ..SmallDrawing::new(title, Some(lengths(pass)), marks)
        }
    };
    if distances.contains(&0.0) {
        let wrong = passes::<V, CutsOnBorder>(input).into_iter().next()?;
        let both = [("sh-list-wrong", &wrong), ("sh-list-next", &own)];
        let both =
            both.map(|(title, pass)| drawing(Value::Term(title), pass, false, wash(&edge, false)));
        return Some(row(both.to_vec(), &input.vertices));
    }
    let beyond = (most - least) / 4.0;
    let between = [
        most + beyond,
        middle.midpoint(most),
        least.midpoint(middle),
        least - beyond,
    ];
    let n_inside = tests.filter(|test| test.inside()[0]).count();
    let normal = input.region.half_planes()[own.edge_idx].normal();
    let square: f64 = normal.iter().map(|side| side * side).sum();
    let of_count = |n: usize| {
        let is_current = n == n_inside;
        let by = if is_current { 0.0 } else { -between[n] };
        let [there, back] = [by, -by].map(|by| normal.map(|side| by * side / square));
        let moved = first(&Input {
            vertices: shifted(&input.vertices, there),
            region: input.region.clone(),
        })?;
        let pass = Pass {
            before: shifted(&moved.before, back),
            after: shifted(&moved.after, back),
            ..moved
        };
        let mut border = wash(&edge, is_current);
        if let Shape::HalfPlane(ends) = &mut border.shape {
            *ends = ends.map(|at| [at[0] + back[0], at[1] + back[1]]);
        }
        let title = Message::new("sh-n-inside").with("n", n);
        Some(drawing(title.into(), &pass, is_current, border))
    };
    Some(row((0..=3).filter_map(of_count).collect(), &input.vertices))
}

fn shifted<V: LabVertex>(list: &[V], by: [f64; 2]) -> Vec<V> {
    let shifted = |vertex: &V| {
        let [x, y] = vertex.at().to_array();
        let at = Point::new(x + by[0], y + by[1]).unwrap_or_default();
        V::with_uv(at, vertex.uv().unwrap_or_default())
    };
    list.iter().map(shifted).collect()
}
