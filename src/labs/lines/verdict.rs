//! Why the segment in focus is visible or not: the test that decided it, and the least move that would turn it.

use std::ops::ControlFlow;

use crate::{
    algo::line::{least_move_in, least_move_out},
    figure::Decides,
    geom::{Edge, HalfPlane, Segment, distance_to_segment},
    labs::{
        Answers, Click,
        prelude::*,
        words::{edge_link, edge_name, polygon_edge_link, polygon_edge_name},
    },
};

use super::{LineTelling, Scene, scene::Decided};

pub fn decided<M: LineTelling>(scene: &Scene, segment: Segment) -> Decided {
    let recording = Recording::<M>::new(M::input(scene, segment));
    let borders = borders::<M>(scene);
    let (mut step, mut rejected_by, mut between) = (0, None, None);
    recording.walk::<()>([1, recording.events().len()], |nth, &now| {
        let at = At {
            step: now,
            scenery: None,
        };
        if let Some((decides, about)) = at.decision()
            && about == Link::to("segment")
        {
            let is_dropped = decides == Decides::Drops;
            let border = M::named(&at, "rejects").and_then(|it: Named| it.link);
            let border = border.filter(|_| is_dropped);
            step = nth;
            rejected_by = borders.iter().position(|(.., link)| border == Some(*link));
            between = at.value("enters").zip(at.value("leaves"));
        }
        ControlFlow::Continue(())
    });
    Decided {
        step,
        rejected_by,
        between: rejected_by.and(between).map(Into::into),
        borders: borders.into_iter().map(|it| (it.0, it.1)).collect(),
    }
}

/// In the order in which the method numbers them.
fn borders<M: LineTelling>(scene: &Scene) -> Vec<(HalfPlane, Value, Link)> {
    if M::TAKES_POLYGON {
        let polygon = scene.clip_polygon();
        let planes = polygon.half_planes().enumerate();
        planes
            .map(|(i, plane)| (plane, polygon_edge_name(i), polygon_edge_link(i)))
            .collect()
    } else {
        let plane = |edge| scene.window.half_plane(edge);
        let side = |edge| (plane(edge), edge_name(edge), edge_link(edge));
        Edge::ALL.map(side).to_vec()
    }
}

impl Answers for Scene {
    fn asked(&self, click: &Click<'_>) -> Option<Link> {
        under(self, click).map(segment_link)
    }

    fn verdict(&self, about: Link, (run, _): AtStep<'_>) -> Option<Verdict> {
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
                let keys = ["verdict-line-touch", "verdict-line-out"];
                let key = keys[usize::from(turn.by < 0.0)];
                let message = Message::new(key).with("move", turn.by.abs());
                message.with("edge", names.get(turn.border_idx)?.clone())
            }
        };
        Some(Verdict {
            why: run.caption(decided.step),
            notes: between.into_iter().chain([turn]).collect(),
            step: Some(decided.step),
            offer: None,
        })
    }
}

pub const fn segment_link(segment_idx: usize) -> Link {
    Link::nth("segment", segment_idx)
}

/// The nearest segment within reach of a click.
pub fn under(scene: &Scene, click: &Click<'_>) -> Option<usize> {
    let [x, y, _] = click.at;
    let segments = scene.segments().iter().enumerate();
    let near = segments.filter_map(|(i, segment)| {
        let ends = [segment.p1.to_array(), segment.p2.to_array()];
        let distance = distance_to_segment([x, y], ends);
        (distance <= click.reach).then_some((distance, i))
    });
    let (_, nearest) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(nearest)
}
