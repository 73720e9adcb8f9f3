//! A pipeline's clippers in a row, and what flows between them.

use crate::{
    algo::{
        polygon::{
            Pipeline, PipelineEvent as Event, PipelineHeld as Held, PipelineStage,
            SutherlandHodgmanInput as Input,
        },
        ring::RingEvent,
    },
    figure::{ClipperBox, ClipperRow, Fate, Traveller},
    geom::Point,
    labs::{
        rings::{Asked, is_crossed},
        words::{name, vertex_symbol},
    },
    trace::Step,
};

use super::{
    clip_edge::{ClipEdge, EdgeLook},
    lists::output_symbol,
};

/// The view of the clippers.
pub const CLIPPERS: &str = "clippers";

/// What moves at a step, and what the clipper at work has been told of it.
pub struct Now {
    /// The clipper at work.
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

/// The clip edge of a clipper.
pub fn edge(input: &Input, stage_idx: usize) -> ClipEdge<'_> {
    ClipEdge::new(&input.region, stage_idx, EdgeLook::RIGHT)
}

/// The clippers at one step.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        algo::polygon::SutherlandHodgmanInput,
        figure::{Body, Frame, Run},
        geom::{ConvexPolygon, GeomError, Polygon, Window},
        labs::recorded::Recorded,
    };

    fn run(region: impl Into<crate::algo::polygon::ClipRegion>) -> Result<Box<dyn Run>, GeomError> {
        let polygon = Polygon::new(&[[-2.0, -1.0], [6.0, 1.0], [-2.0, 5.0]])?;
        let input = SutherlandHodgmanInput::new(region.into(), &polygon);
        Ok(Box::new(Recorded::<Pipeline>::new(input, None)))
    }

    fn row(frame: Frame) -> ClipperRow {
        let bodies = frame.views.into_iter().map(|view| view.body);
        let mut rows = bodies.filter_map(|body| match body {
            Body::Clippers(row) => Some(row),
            _ => None,
        });
        rows.next_back().expect("a row of clippers")
    }

    #[test]
    fn a_crossing_takes_the_place_of_a_vertex_outside() -> Result<(), GeomError> {
        let run = run(Window::new(-4.0, -3.0, 4.0, 3.0)?)?;
        let is_cross = |&step: &usize| run.event_json(step)["event"] == "cross";
        let step = (1..=run.n_steps()).find(is_cross).unwrap_or_default();
        let at = |symbol: &str, fate| Traveller {
            name: name(symbol),
            arrow: 2,
            fate,
        };
        let before = row(run.frame(step - 1));
        assert_eq!(
            before.travellers,
            [at("I", Fate::Due), at("P", Fate::Dropped)]
        );
        let row = row(run.frame(step));
        assert_eq!(
            row.travellers,
            [at("I", Fate::GoesOn), at("P", Fate::Dropped)]
        );
        assert_eq!((row.at_work, row.n_out), (Some(1), 1), "right; V₁ is out");
        let right = &row.clippers[1];
        let v1 = Some([-2.0, -1.0]);
        assert_eq!((right.first, right.previous), (v1, v1), "as S → P has it");
        assert_eq!(row.clippers[0].previous, Some([6.0, 1.0]), "V₂ has passed");
        Ok(())
    }

    #[test]
    fn what_flows_is_on_one_arrow_and_in_the_end_nothing_flows() -> Result<(), GeomError> {
        let octagon = [
            [2.0, -5.0],
            [5.0, -2.0],
            [5.0, 2.0],
            [2.0, 5.0],
            [-2.0, 5.0],
            [-5.0, 2.0],
            [-5.0, -2.0],
            [-2.0, -5.0],
        ];
        let run = run(ConvexPolygon::new(&octagon)?)?;
        for step in 0..=run.n_steps() {
            let row = row(run.frame(step));
            let arrows: Vec<usize> = row.travellers.iter().map(|t| t.arrow).collect();
            assert!(
                arrows.iter().all(|&a| a == arrows[0] && a <= 8),
                "step {step}: {arrows:?}"
            );
        }
        let end = row(run.frame(run.n_steps()));
        assert!(end.travellers.is_empty() && end.clippers.iter().all(|c| c.is_closed));
        Ok(())
    }
}
