//! Why the segment in focus is visible or not: the test that decided it, and the least move that would turn it.

use crate::{
    algo::line::{least_move_in, least_move_out},
    figure::{Link, Run},
    geom::{Edge, HalfPlane, Segment},
    labs::{Answers, Click, Verdict, words::edge_name},
    text::{Message, Value},
};

use super::{
    LineDemo, Scene, change::under, demo::Settles, methods::polygon_edge_name, scene::Decided,
};

/// Runs a method on a segment, and sees which test decides.
pub fn decided<A: LineDemo>(scene: &Scene, segment: Segment) -> Decided {
    let input = A::input(scene, segment);
    let mut state = A::start(&input);
    let mut decided = Decided {
        step: 0,
        rejected_by: None,
        between: None,
        borders: borders::<A>(scene),
    };
    let mut step = 0;
    A::run::<f64>(&input, |event| {
        step += 1;
        let settles = A::settles(&event, &input);
        A::apply(&mut state, event);
        match settles {
            Settles::Nothing => {}
            Settles::Asked => decided.step = step,
            Settles::Rejects(border_idx) => {
                (decided.step, decided.rejected_by) = (step, Some(border_idx));
            }
            Settles::Rejected(border_idx) => decided.rejected_by = Some(border_idx),
        }
    });
    decided.between = decided.rejected_by.and_then(|_| A::between(&state));
    decided
}

/// In the order in which the method numbers them.
fn borders<A: LineDemo>(scene: &Scene) -> Vec<(HalfPlane, Value)> {
    if A::TAKES_POLYGON {
        let polygon = scene.clip_polygon();
        let planes = polygon.half_planes().enumerate();
        planes.map(|(i, p)| (p, polygon_edge_name(i))).collect()
    } else {
        let sides = Edge::ALL.map(|edge| (scene.window.half_plane(edge), edge_name(edge)));
        sides.to_vec()
    }
}

impl Answers for Scene {
    fn asked(&self, click: &Click<'_>) -> Option<Link> {
        under(self, click).map(segment_link)
    }

    /// The verdict on the segment in focus, by the method that is stepped.
    fn verdict(&self, about: Link, run: &dyn Run) -> Option<Verdict> {
        let segment = self.focused();
        if about != segment_link(self.focus()) {
            return None;
        }
        let decided = (self.method.info().decided)(self, segment);
        let (planes, names): (Vec<HalfPlane>, Vec<Value>) = decided.borders.into_iter().unzip();
        let corners = self.region(self.method);
        let corners = corners.vertices();
        let between = decided.between.map(|[enters, leaves]| {
            let message = Message::new("verdict-line-between").with("enters", enters);
            message.with("leaves", leaves)
        });
        let turn = match decided.rejected_by {
            Some(border_idx) => {
                let by = least_move_in(&planes, corners, &segment, border_idx);
                let message = Message::new(match by {
                    Some(by) if by >= 0.0 => "verdict-line-in",
                    Some(_) => "verdict-line-back",
                    None => "verdict-line-never",
                });
                let message = message.with("move", by.unwrap_or_default().abs());
                message.with("edge", names.get(border_idx)?.clone())
            }
            None => {
                let turn = least_move_out(&planes, corners, &segment)?;
                let key = if turn.by < 0.0 {
                    "verdict-line-out"
                } else {
                    "verdict-line-touch"
                };
                let message = Message::new(key).with("move", turn.by.abs());
                message.with("edge", names.get(turn.border_idx)?.clone())
            }
        };
        Some(Verdict {
            why: run.caption(decided.step),
            notes: between.into_iter().chain([turn]).collect(),
            step: Some(decided.step),
        })
    }
}

/// What is asked about where a segment is clicked.
pub const fn segment_link(segment_idx: usize) -> Link {
    Link::nth("segment", segment_idx)
}
