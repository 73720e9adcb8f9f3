//! Why a part of a segment or of a triangle was kept or lost, a cut lies where it does, and the smallest change that would turn it.

use crate::{
    algo::volume::{PartTurn, part_move_in, part_move_out},
    labs::frustum::prelude::*,
};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outcome {
    Kept,
    /// Some of it is left; this plane is the first that cuts it.
    Cut(usize),
    Lost(usize),
}

/// The step that decided a part's fate, from 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fate {
    pub step: usize,
    pub outcome: Outcome,
}

/// The six planes that bound what is kept, in the order of [`VolumeSide::ALL`].
pub fn region(scene: &Scene, subject: Subject) -> [Plane; 6] {
    match subject {
        Subject::BoxedSegment => VolumeSide::ALL.map(|side| {
            let mut plane = [0.0, 0.0, 0.0, 1.0];
            plane[side.axis()] = if side.is_high() { -1.0 } else { 1.0 };
            Plane::new(plane).expect("a normal of length 1")
        }),
        _ => scene.culler().planes_in_world(),
    }
}

/// What is told at a step, and the change that would turn it: of a run that is wrong on purpose no change is named.
pub fn told_at(
    step: usize,
    (scene, run): (&Scene, &dyn Run),
    told: Option<Message>,
    turn: Option<Message>,
) -> Verdict {
    let turn = turn.filter(|_| !scene.method.card().is_faulty);
    Verdict {
        why: run.caption(step),
        notes: told.into_iter().chain(turn).collect(),
        step: Some(step),
        offer: None,
    }
}

/// A message about a plane, after how far something has to be moved.
fn moved(key: &'static str, by: Option<f64>, plane_idx: usize) -> Message {
    let message = Message::new(key);
    let message = match by {
        Some(by) => message.with("move", by),
        None => message,
    };
    message.with("plane", side_name(VolumeSide::ALL[plane_idx]))
}

/// What is told of a part between these corners.
pub fn part_verdict(
    (part, corners): (Value, &[[f64; 3]]),
    Fate { step, outcome }: Fate,
    subject: Subject,
    (scene, run): (&Scene, &dyn Run),
) -> Verdict {
    let planes = region(scene, subject);
    let told = match outcome {
        Outcome::Kept => Message::new("verdict-part-kept"),
        Outcome::Cut(plane_idx) => moved("verdict-part-cut", None, plane_idx),
        Outcome::Lost(plane_idx) => moved("verdict-part-lost", None, plane_idx),
    };
    let turn = if let Outcome::Lost(plane_idx) = outcome {
        let by = part_move_in(&planes, corners, plane_idx);
        let key = match by {
            Some(by) if by >= 0.0 => "verdict-part-in",
            Some(_) => "verdict-part-back",
            None => "verdict-part-never",
        };
        Some(moved(key, Some(by.unwrap_or_default().abs()), plane_idx))
    } else {
        part_move_out(&planes, corners).map(|PartTurn { plane_idx, by }| {
            let is_out = by < 0.0;
            let key = if is_out {
                "verdict-part-out"
            } else {
                "verdict-part-touch"
            };
            moved(key, Some(by.abs()), plane_idx)
        })
    };
    told_at(step, (scene, run), Some(told.with("part", part)), turn)
}

pub fn segment_verdict(
    scene: &Scene,
    (subject, about): (Subject, Link),
    fate: impl Fn(Option<End>) -> Option<Fate>,
    run: &dyn Run,
) -> Option<Verdict> {
    let end = End::BOTH.into_iter().find(|&end| about == end_link(end));
    if end.is_none() && about != Link::to("segment") {
        return None;
    }
    let segment = scene.places().segment;
    let part = match end {
        Some(end) => (end_name(end), &segment[end.idx()..=end.idx()]),
        None => (Value::Term("part-segment"), &segment[..]),
    };
    Some(part_verdict(part, fate(end)?, subject, (scene, run)))
}

/// What is told of a crossing: its edge's ends lie on different sides of a plane, until that is moved.
pub fn crossing_verdict(
    step: usize,
    plane_idx: usize,
    distances: [f64; 2],
    run: (&Scene, &dyn Run),
) -> Verdict {
    let [inner, outer] = [f64::max, f64::min].map(|pick| pick(distances[0], distances[1]));
    let (key, by) = if -outer <= inner {
        ("verdict-crossing-out", -outer)
    } else {
        ("verdict-crossing-in", inner)
    };
    let turn = moved(key, None, plane_idx).with("inner", inner);
    let turn = turn.with("outer", outer).with("move", by);
    told_at(step, run, None, Some(turn))
}

#[cfg(test)]
mod tests {
    use super::super::first_scene;
    use crate::{
        figure::Link,
        labs::{Answers, Document, space::Scene},
    };

    fn scenes(id: &'static str) -> impl Iterator<Item = Scene> {
        (-4..=4).map(move |i| {
            let mut scene = first_scene();
            scene.set_method(id);
            let moved = |[x, y, z]: [f64; 3]| [x + 2.5 * f64::from(i), y, z];
            let mut places = scene.places();
            places.segment = places.segment.map(moved);
            places.triangle = places.triangle.map(moved);
            scene.set_places(places).expect("finite");
            scene
        })
    }

    #[test]
    fn every_end_corner_edge_and_cut_is_told_at_a_step_of_its_own() {
        let lines = [
            "cohen-sutherland-3d",
            "liang-barsky-3d",
            "plane-line",
            "homogeneous-line",
        ];
        let triangles = [
            "plane-at-a-time",
            "intersection-polygon",
            "homogeneous-triangle",
        ];
        let of_lines = ["p1", "p2", "segment"].map(Link::to).to_vec();
        let nth = |name: &'static str| (0..3).map(move |i| Link::nth(name, i));
        let of_triangles: Vec<Link> = nth("corner").chain(nth("edge")).collect();
        let of_triangles = triangles.map(|id| (id, &of_triangles));
        let mut n_cuts = 0;
        for (id, links) in lines
            .map(|id| (id, &of_lines))
            .into_iter()
            .chain(of_triangles)
        {
            let mut steps = std::collections::HashSet::new();
            for scene in scenes(id) {
                let runs = scene.record();
                let told = |about| scene.verdict(about, (&*runs[0], 0));
                for &about in links {
                    let verdict = told(about).unwrap_or_else(|| panic!("{id}: {about:?}"));
                    let step = verdict.step.expect("at a step");
                    assert!((1..=runs[0].n_steps()).contains(&step), "{id}: {about:?}");
                    assert_eq!(verdict.notes.len(), 2, "{id}: what, and what would turn it");
                    steps.insert(step);
                }
                for verdict in (0..9).map_while(|i| told(Link::nth("cut", i))) {
                    let step = verdict.step.expect("at a step");
                    assert_eq!(runs[0].event_json(step)["event"], "cross", "{id}");
                    n_cuts += 1;
                }
            }
            assert!(steps.len() > 3, "{id}: {steps:?}");
        }
        assert!(n_cuts > 30, "{n_cuts}");
    }
}
