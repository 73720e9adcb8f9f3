//! What a pipeline holds: its clippers in a row with what flows between them, and what goes in beside what has come out.

use crate::{
    algo::polygon::{
        Pipeline, PipelineEvent as Event, PipelineHeld as Held, PipelineStage,
        SutherlandHodgmanInput as Input,
    },
    figure::{ClipperBox, ClipperRow, Fate, Traveller},
};

use super::{
    clip_edge::ClipEdge,
    lists::{output_symbol, vertex_link},
    prelude::*,
};

pub const CLIPPERS: &str = "clippers";

pub struct Now {
    pub stage_idx: Option<usize>,
    /// The vertex that entered it, or left the last one; none while it closes.
    pub moving: Option<Point>,
    pub asked: Asked<Point>,
}

impl Now {
    pub fn of(past: &[Event<Point>]) -> Self {
        let moves = past.iter().rev().find(|event| event.happening().is_none());
        let (stage_idx, moving) = match moves {
            Some(&Event::Enter { stage_idx, at, .. }) => (Some(stage_idx), Some(at)),
            Some(&Event::Output { at }) => (None, Some(at)),
            Some(&Event::Close { stage_idx }) => (Some(stage_idx), None),
            Some(
                Event::First { .. } | Event::Test { .. } | Event::Cross { .. } | Event::Done { .. },
            )
            | None => (None, None),
        };
        Self {
            stage_idx,
            moving,
            asked: Asked::of(past),
        }
    }
}

pub fn edge(input: &Input, stage_idx: usize) -> ClipEdge<'_> {
    ClipEdge::new::<Right>(&input.region, stage_idx)
}

pub fn row(step: &Step<'_, Pipeline>) -> ClipperRow {
    let Step { input, held, past } = *step;
    let now = Now::of(past);
    let clipper = |(idx, stage): (usize, &PipelineStage<Point>)| {
        let edge = edge(input, idx);
        ClipperBox {
            name: edge.border(),
            first: stage.first().map(Point::to_array),
            previous: stage.previous().map(Point::to_array),
            is_closed: stage.is_closed,
            link: Some(edge.link()),
        }
    };
    let event = step.event();
    ClipperRow {
        clippers: held.stages.iter().enumerate().map(clipper).collect(),
        at_work: now.stage_idx,
        travellers: event.map_or_else(Vec::new, |event| travellers(&event, held, &now)),
        output: name("V′"),
        n_out: held.output.len(),
    }
}

fn travellers(event: &Event<Point>, held: &Held<Point>, now: &Now) -> Vec<Traveller> {
    let on = |arrow: usize, symbol: String, fate: Fate| Traveller {
        name: name(symbol),
        arrow,
        fate,
    };
    let p = |stage_idx: usize, is_inside: bool| {
        let fate = if is_inside {
            Fate::GoesOn
        } else {
            Fate::Dropped
        };
        on(stage_idx + 1, "P".to_owned(), fate)
    };
    match *event {
        Event::Enter {
            stage_idx,
            vertex_idx,
            ..
        } => {
            let symbol = vertex_idx.map_or_else(|| "P".to_owned(), vertex_symbol);
            vec![on(stage_idx, symbol, Fate::GoesOn)]
        }
        Event::First {
            stage_idx, inside, ..
        } => vec![p(stage_idx, inside)],
        Event::Test { stage_idx, .. } | Event::Cross { stage_idx, .. } => {
            let Some(test) = now.asked.test else {
                return Vec::new();
            };
            let fate = match now.asked.crossing {
                Some(_) => Fate::GoesOn,
                None => Fate::Due,
            };
            let crossing = test.rule.changes_side() && is_crossed(test.distances);
            let crossing = crossing.then(|| on(stage_idx + 1, "I".to_owned(), fate));
            // Nothing follows it when the ring is closed: F has long gone on.
            let end = now.moving.map(|_| p(stage_idx, test.rule.ends_inside()));
            crossing.into_iter().chain(end).collect()
        }
        Event::Output { .. } => {
            let symbol = output_symbol(held.output.len().saturating_sub(1));
            vec![on(held.stages.len(), symbol, Fate::GoesOn)]
        }
        Event::Close { .. } | Event::Done { .. } => Vec::new(),
    }
}

/// The view of both lists.
pub const IN_AND_OUT: &str = "in-and-out";

/// The polygon as far as it has been read, and the ring as far as it has come out.
pub fn in_and_out(step: &Step<'_, Pipeline>) -> Lists {
    let lists = [list_in(step), list_out(step)];
    Lists {
        links: links(step, &lists),
        lists: lists.into(),
        legend: Vec::new(),
    }
}

fn list_in(step: &Step<'_, Pipeline>) -> ListColumn {
    let given = &step.input.vertices;
    let entered = |event: &Event<Point>| match *event {
        Event::Enter { vertex_idx, .. } => vertex_idx,
        _ => None,
    };
    let read = step.past.iter().rev().find_map(entered);
    let entering = step.event().and_then(|event| entered(&event));
    let entry = |i: usize| ListRow {
        role: match read {
            _ if entering == Some(i) => Role::Signal,
            Some(read) if i <= read => Role::Ink,
            Some(_) | None => Role::Faint,
        },
        details: vec![Some(Value::Point(given[i].to_array()))],
        link: Some(vertex_link(i)),
        ..ListRow::new(vertex_name(i))
    };
    ListColumn {
        columns: vec![name("(x, y)")],
        is_ring: true,
        ..ListColumn::about(Value::Term("sh-list-given"), given.len(), read, entry)
    }
}

fn list_out(step: &Step<'_, Pipeline>) -> ListColumn {
    let (ring, n) = (&step.held.output, step.held.output.len());
    let is_done = matches!(step.event(), Some(Event::Done { .. }));
    let entry = |i: usize| ListRow {
        role: if is_done {
            Role::Accepted
        } else {
            Role::Accent
        },
        marker: Some(ItemMarker::Dot),
        details: vec![Some(Value::Point(ring[i].to_array()))],
        ..ListRow::new(name(output_symbol(i)))
    };
    ListColumn {
        columns: vec![name("(x, y)")],
        is_ring: is_done,
        ..ListColumn::about(Value::Term("pipe-list-ring"), n, n.checked_sub(1), entry)
    }
}

/// From the vertices that have come through to what they are in the ring.
fn links(step: &Step<'_, Pipeline>, [polygon, ring]: &[ListColumn; 2]) -> Vec<ListLink> {
    let given = step.input.vertices.iter().skip(polygon.n_before);
    let given: Vec<_> = given.take(polygon.entries.len()).collect();
    let out = step.held.output.iter().skip(ring.n_before).enumerate();
    let last = ring.entries.len().saturating_sub(1);
    let link = |(to, vertex)| {
        let from = given.iter().position(|&other| other == vertex)?;
        let is_now = to == last && matches!(step.event(), Some(Event::Output { .. }));
        let role = if is_now { Role::Signal } else { Role::Soft };
        Some(ListLink::between(from, to, role))
    };
    out.filter_map(link).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::{ConvexPolygon, Polygon, Window};

    fn run(region: impl Into<ClipRegion>) -> Box<dyn Run> {
        let polygon = Polygon::new(&[[-2.0, -1.0], [6.0, 1.0], [-2.0, 5.0]]).unwrap();
        let input = Input::new(region.into(), &polygon);
        Box::new(Recorded::<Pipeline>::new(input, None))
    }

    fn row(run: &dyn Run, step: usize) -> ClipperRow {
        match run.frame(step).views.pop().map(|view| view.body) {
            Some(Body::Clippers(row)) => row,
            other => panic!("no row of clippers: {other:?}"),
        }
    }

    #[test]
    fn a_crossing_takes_the_place_of_a_vertex_outside() {
        let run = run(Window::new(-4.0, -3.0, 4.0, 3.0).unwrap());
        let is_cross = |&step: &usize| run.event_json(step)["event"] == "cross";
        let step = (1..=run.n_steps()).find(is_cross).unwrap_or_default();
        let at = |symbol: &str, fate| Traveller {
            name: name(symbol),
            arrow: 2,
            fate,
        };
        let p = at("P", Fate::Dropped);
        let before = row(&*run, step - 1);
        assert_eq!(before.travellers, [at("I", Fate::Due), p.clone()]);
        let row = row(&*run, step);
        assert_eq!(row.travellers, [at("I", Fate::GoesOn), p]);
        assert_eq!((row.at_work, row.n_out), (Some(1), 1), "right; V₁ is out");
        let right = &row.clippers[1];
        let v1 = Some([-2.0, -1.0]);
        assert_eq!((right.first, right.previous), (v1, v1), "as S → P has it");
        assert_eq!(row.clippers[0].previous, Some([6.0, 1.0]), "V₂ has passed");
    }

    #[test]
    fn what_flows_is_on_one_arrow_and_in_the_end_nothing_flows() {
        let right = [[2.0, -5.0], [5.0, -2.0], [5.0, 2.0], [2.0, 5.0]];
        let left = right.map(|[x, y]: [f64; 2]| [-x, -y]);
        let run = run(ConvexPolygon::new(&[right, left].concat()).unwrap());
        for step in 0..=run.n_steps() {
            let row = row(&*run, step);
            let arrows: Vec<usize> = row.travellers.iter().map(|t| t.arrow).collect();
            let is_one = arrows.iter().all(|&a| a == arrows[0] && a <= 8);
            assert!(is_one, "step {step}: {arrows:?}");
        }
        let end = row(&*run, run.n_steps());
        assert!(end.travellers.is_empty() && end.clippers.iter().all(|c| c.is_closed));
    }
}
