//! Why the segment in focus is visible or not: the test that decided it, and the least move that would turn it.

use std::ops::ControlFlow;

use glam::DVec2;

use crate::{
    algo::line::{End, least_move_in, least_move_out},
    figure::Decides,
    geom::{Edge, HalfPlane, Segment, distance_to_segment},
    labs::{
        Answers, Click,
        prelude::*,
        words::{edge_link, edge_name, polygon_edge_link, polygon_edge_name},
    },
};

use super::{
    LineTelling, Scene,
    scene::{Decided, Dropped, nearest_along},
};

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

/// What each step cuts away, in their order.
pub fn dropped<M: LineTelling>(scene: &Scene, segment: Segment) -> Vec<Dropped> {
    let recording = Recording::<M>::new(M::input(scene, segment));
    let mut left = [0.0, 1.0];
    let mut all = Vec::new();
    for (step, event) in (1..).zip(recording.events()) {
        let Some((end, to)) = M::cuts(event, &segment) else {
            continue;
        };
        let [low, high] = left;
        let to = to.clamp(low, high);
        let from_to = match end {
            End::P1 => [low, to],
            End::P2 => [to, high],
        };
        left[end.idx()] = to;
        if from_to[0] < from_to[1] {
            all.push(Dropped { step, from_to });
        }
    }
    all
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
        let segment_idx = under(self, click)?;
        let [x, y, _] = click.at;
        let u = nearest_along(&self.focused(), [x, y]);
        let is_there = |it: &Dropped| it.from_to[0] <= u && u <= it.from_to[1];
        let dropped = || (self.method.info().dropped)(self, self.focused());
        let part = (segment_idx == self.focus()).then(dropped);
        let part = part.and_then(|parts| parts.into_iter().find(is_there));
        Some(part.map_or(segment_link(segment_idx), |part| part_link(part.step)))
    }

    fn verdict(&self, about: Link, (run, _): AtStep<'_>) -> Option<Verdict> {
        // A proof decides nothing: what is known of the segment stands in another run.
        if self.method.card().is_proof {
            return None;
        }
        let segment = self.focused();
        if about != segment_link(self.focus()) {
            let mut parts = (self.method.info().dropped)(self, segment).into_iter();
            let part = parts.find(|part| about == part_link(part.step))?;
            let ends = [segment.p1, segment.p2].map(|end| DVec2::from(end.to_array()));
            let place = |u: f64| Value::Point(ends[0].lerp(ends[1], u).to_array());
            let [from, to] = part.from_to.map(place);
            let message = Message::new("verdict-part-dropped").with("from", from);
            return Some(Verdict {
                why: run.caption(part.step),
                notes: vec![message.with("to", to)],
                step: Some(part.step),
                offer: None,
            });
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

/// The part of the segment in focus that a step has cut away.
const fn part_link(step: usize) -> Link {
    Link::nth("cut away", step)
}

/// The nearest segment within reach of a click. At an end of the one in focus, where others may begin, it is that one.
pub fn under(scene: &Scene, click: &Click<'_>) -> Option<usize> {
    let [x, y, _] = click.at;
    let focus = scene.focus();
    let in_focus = scene.segments().get(focus)?;
    let ends = [in_focus.p1, in_focus.p2].map(|end| DVec2::from(end.to_array()));
    if ends
        .iter()
        .any(|end| end.distance(DVec2::new(x, y)) <= click.reach)
    {
        return Some(focus);
    }
    let segments = scene.segments().iter().enumerate();
    let near = segments.filter_map(|(i, segment)| {
        let ends = [segment.p1.to_array(), segment.p2.to_array()];
        let distance = distance_to_segment([x, y], ends);
        (distance <= click.reach).then_some((distance, i))
    });
    let (_, nearest) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(nearest)
}

#[cfg(test)]
mod tests {
    use super::{
        super::{Method, random_segments},
        *,
    };
    use crate::{algo::line::LiangBarsky, labs::Document, trace::silent};

    #[test]
    fn at_a_shared_end_the_segment_in_focus_is_meant() {
        let mut scene = Scene::first();
        let [first, second] = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
            .map(|ends| Segment::try_from(ends).expect("finite"));
        scene.set_segment(0, first);
        scene.add_segment(second).expect("a second one");
        for focus in [0, 1] {
            scene.set_focus(focus);
            let click = |x, y| Click {
                at: [x, y, 0.0],
                place: [x, y, 0.0],
                reach: 0.1,
                inserts: false,
                picture: None,
                link: None,
                locks: &[],
            };
            assert_eq!(under(&scene, &click(0.05, 0.0)), Some(focus));
            assert_eq!(under(&scene, &click(0.5, 0.0)), Some(0));
            assert_eq!(under(&scene, &click(0.0, 0.5)), Some(1));
        }
    }

    #[test]
    fn what_is_dropped_and_what_is_visible_are_all_of_a_segment() {
        let mut scene = Scene::first();
        let mut n_parts = 0;
        for segment in random_segments(&scene.window, 60, 3) {
            let Some(visible) = silent::<LiangBarsky>(&scene.with(segment)) else {
                continue;
            };
            scene.set_segment(0, segment);
            let ends = [visible.p1, visible.p2].map(|end| nearest_along(&segment, end.to_array()));
            for method in Method::all_right() {
                scene.method = method;
                let parts = (method.info().dropped)(&scene, segment);
                let dropped: f64 = parts.iter().map(|it| it.from_to[1] - it.from_to[0]).sum();
                let all = dropped + ends[1] - ends[0];
                assert!((all - 1.0).abs() < 1e-9, "{method:?}: {parts:?} {ends:?}");
                let run = scene.record().swap_remove(0);
                for part in &parts {
                    let about = part_link(part.step);
                    let told = scene.verdict(about, (&*run, 0)).expect("it is told");
                    assert_eq!(told.step, Some(part.step));
                    n_parts += 1;
                }
            }
        }
        assert!(n_parts > 50, "{n_parts}");
    }
}
