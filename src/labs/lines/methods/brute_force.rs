//! Brute force, shown.

use std::cmp::Ordering;

use crate::{
    algo::line::{BruteForce, BruteForceEvent as Event},
    labs::segments::{ENDS, end_named, left_in},
};

use super::{
    crossings::{Fate, Shown, axis, crossing_table, crossing_values, current_edge, tests_table},
    prelude::*,
    shared::{
        border, border_mark, crossing_mark, end_now, ends, inside_mark, outside_marks,
        parallel_formula, segment_marks, side,
    },
};

const CROSSINGS_VIEW: &str = "crossings";

impl LineTelling for BruteForce {
    fn input(scene: &Scene, segment: Segment) -> WindowInput {
        scene.with(segment)
    }

    fn cuts(event: &Event, segment: &Segment) -> Option<(End, f64)> {
        if let Event::Cut { end, to, .. } = *event {
            Some((end, nearest_along(segment, to.to_array())))
        } else {
            None
        }
    }
}

pseudocode! {
    EACH: 0, "code-bf-each", "words-bf-each";
    INTERSECT: 1, "code-bf-intersect", "words-bf-intersect";
    REJECT: 1, "code-bf-reject", "words-bf-reject";
    CUT: 1, "code-bf-cut", "words-bf-cut";
    ACCEPT: 0, "code-bf-accept", "words-bf-accept";
}

const BOTH: &[&str] = &["{x₁, x₂}"];

impl Telling for BruteForce {
    type Scenery = ();

    const ID: &'static str = "brute-force";
    const NAME_KEY: &'static str = "alg-brute-force";
    const SOURCE: &'static str = "Rogers, 1998, §3-1";
    const CODE: &'static [CodeLine] = &LINES;
    const WATCH: &'static [Watched] = &[Watched::Names(&["P₁", "P₂", "crossings", "used"])];
    const OPENING: Row = Row::new(Phase, EACH, "line-opening").so(ENDS);

    table! { |event, step|
        intersect: Event::Intersect { .. } =>
            Row::new(Phase, INTERSECT, "bf-intersect").so(&["{1st}", "{2nd}", "{3rd}"])
                .about("edge").answers("crossing");
        parallel: Event::Parallel { .. } =>
            Row::new(Test, EACH, "line-parallel").so(&["{x₁ = x₂}"]).about("edge").answers("crossing");
        keep_parallel: Event::Keep { .. } if matches!(step.past, [.., Event::Parallel { .. }, _]) =>
            Row::new(Test, CUT, "bf-keep-parallel").so(BOTH)
                .about("edge").answers_as("beyond", "bf-option-none");
        keep: Event::Keep { .. } =>
            Row::new(Test, CUT, "bf-keep").so(BOTH)
                .about("edge").answers_as("beyond", "bf-option-none");
        cut: Event::Cut { .. } =>
            Row::new(Cut, CUT, "bf-cut").so(BOTH).cuts("end").answers_as("beyond", "bf-option-one");
        point: Event::Accept { .. } if step.input.segment.is_point() =>
            Row::new(Accept, ACCEPT, "line-point").keeps("segment");
        touch: Event::Accept { segment } if segment.is_point() =>
            Row::new(Accept, ACCEPT, "line-touch").keeps("segment");
        accept: Event::Accept { .. } => Row::new(Accept, ACCEPT, "line-accept").keeps("segment");
        reject: Event::Reject { .. } =>
            Row::new(Reject, REJECT, "line-reject-edge").so(BOTH)
                .drops("segment").answers_as("beyond", "bf-option-both");
    }

    fn named(At { step, .. }: &At<'_, Self>, of: &str) -> Option<Named> {
        let (WindowInput { window, segment }, event) = (step.input, step.event());
        let edge = || current_edge(event);
        let worked_out = |nth| match event {
            Some(Event::Intersect { edge, at, .. }) => {
                let formulas = upright(segment, edge.axis(), window.border(edge), at);
                formulas.into_iter().nth(nth)
            }
            _ => None,
        };
        Some(match of {
            "P₁" => end_now(End::P1, step.held.ends[0]),
            "P₂" => end_now(End::P2, step.held.ends[1]),
            "crossings" => {
                let n = Shown::of(step).crossings.iter().flatten().count();
                Named::from(n).labelled(Value::Term("watch-crossings"))
            }
            "used" => {
                let is_used = |fate: &&Option<Fate>| matches!(fate, Some(Fate::Replaces(_)));
                let n = Shown::of(step).fates.iter().filter(is_used).count();
                Named::from(n).labelled(Value::Term("watch-crossings-used"))
            }
            "edge" | "rejects" => side(edge()?),
            "border" => border_equation(window, edge()?).into(),
            "1st" => worked_out(0)?.into(),
            "2nd" => worked_out(1)?.into(),
            "3rd" => worked_out(2)?.into(),
            "x₁ = x₂" => parallel_formula(segment, edge()?).into(),
            "x₁, x₂" => both_sides(ends_before(step), step.input, edge()?).into(),
            _ => match (of, event) {
                ("end", Some(Event::Cut { end, .. })) => end_named(end),
                ("to", Some(Event::Cut { to, .. })) => to.to_array().into(),
                _ => return left_in(step.held.visible.map(ends), of),
            },
        })
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let shown = Shown::of(&at.step);
        let of_edge = |edge| {
            let cells = crossing_values(&shown, edge).to_vec();
            WatchRow::table(edge_name(edge), cells).linked(edge_link(edge))
        };
        let table = WatchSection::table(vec!["t", "P(t)"], Edge::ALL.map(of_edge).to_vec());
        let names = Self::WATCH.iter().map(|watched| at.section(watched));
        names.chain([table.seen_in(CROSSINGS_VIEW)]).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let table = if at.step.past.is_empty() {
            tests_table(at.step.input)
        } else {
            crossing_table(&at.step)
        };
        vec![
            View::plane(marks(&at.step)),
            View::new(CROSSINGS_VIEW, Body::Table(table)),
            View::new("t-axis", Body::NumberLine(axis(&at.step))),
        ]
    }
}

fn ends_before(step: &Step<'_, BruteForce>) -> [Point; 2] {
    let mut ends = step.held.ends;
    if let Some(Event::Cut { end, from, .. }) = step.event() {
        ends[end.idx()] = from;
    }
    ends
}

fn marks(step: &Step<'_, BruteForce>) -> Vec<Mark> {
    let WindowInput { window, segment } = step.input;
    let (shown, event) = (Shown::of(step), step.event());
    let current = current_edge(event);
    let others = Edge::ALL.into_iter().filter(|&edge| Some(edge) != current);
    let border_of = |edge: Edge| {
        // Before the first crossing, the four tests that make a window.
        if event.is_none() {
            return inside_mark(window, edge);
        }
        Mark::new(Role::Faint, border(window, edge)).linked(edge_link(edge))
    };
    let mut marks: Vec<Mark> = others.map(border_of).collect();
    marks.push(Mark::new(Role::Faint, Shape::Line(ends(*segment))));
    match event {
        Some(Event::Intersect { edge, .. } | Event::Parallel { edge }) => {
            marks.push(border_mark(window, edge));
        }
        Some(Event::Keep { edge } | Event::Cut { edge, .. } | Event::Reject { edge }) => {
            marks.extend(outside_marks(window, edge));
        }
        Some(Event::Accept { .. }) | None => {}
    }
    marks.extend(segment_marks(segment, step.held.ends, shown.is_visible));
    for edge in Edge::ALL {
        let Some((at, u)) = shown.crossings[edge as usize] else {
            continue;
        };
        let used = step.held.ends.contains(&at);
        if used && shown.is_visible.is_some() {
            continue;
        }
        let mark = if Some(edge) == current && shown.is_visible.is_none() {
            crossing_mark(at, "t", u)
        } else if used {
            Mark::new(Role::Accent, Shape::Dot(at.to_array()))
        } else {
            let cross = Mark::new(Role::Discarded, Shape::Cross(at.to_array()));
            cross.labelled(sym("t = ").ratio(u.num, u.den))
        };
        marks.push(mark.linked(edge_link(edge)));
    }
    marks
}

/// `x₁′ = −1 < 1,  x₂ = 2 > 1`: both ends of what is left beside the border that they are compared with.
fn both_sides(before: [Point; 2], input: &WindowInput, edge: Edge) -> Formula {
    let (axis, c) = (edge.axis(), input.window.border(edge));
    let side = |formula: Formula, end: End| {
        let at = before[end.idx()];
        let [a, _] = along(at, axis);
        let relation = match a.partial_cmp(&c) {
            Some(Ordering::Less) => " < ",
            Some(Ordering::Greater) => " > ",
            Some(Ordering::Equal) | None => " = ",
        };
        let subscript = ["₁", "₂"][end.idx()];
        let is_given = at == end.of(&input.segment);
        let prime = if is_given { "" } else { "′" };
        let gap = if end == End::P2 { ",  " } else { "" };
        let symbol = format!("{gap}{}{subscript}{prime} = ", axis_symbol(axis));
        formula.sym(symbol).num(a).sym(relation).num(c)
    };
    End::BOTH.into_iter().fold(Formula::default(), side)
}
