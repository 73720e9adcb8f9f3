//! Why a part of a segment or of a triangle was kept or lost, a cut lies where it does, and the smallest change that would turn it.

use crate::{
    algo::{
        parameter::End,
        volume::{PartTurn, part_move_in, part_move_out},
    },
    figure::{Link, Run},
    geom::{Plane, VolumeSide},
    labs::{
        Verdict,
        words::{end_link, end_name},
    },
    text::{Message, Value},
};

use super::{Scene, Subject, stage::side_name};

/// What becomes of a part.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outcome {
    /// All of it is left.
    Kept,
    /// Some of it is left; this plane is the first that cuts it.
    Cut(usize),
    /// Nothing of it is left, by this plane.
    Lost(usize),
}

/// The step that decided a part's fate, from 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fate {
    /// Where in the run.
    pub step: usize,
    /// What was decided.
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
        Subject::Object
        | Subject::Face
        | Subject::Vertex
        | Subject::Point
        | Subject::Segment
        | Subject::Triangle
        | Subject::Surfaces => scene.culler().planes_in_world(),
    }
}

fn plane_name(plane_idx: usize) -> Value {
    side_name(VolumeSide::ALL[plane_idx])
}

/// What is told of a part between these corners. Of a run that is wrong on purpose no change is named.
pub fn part_verdict(
    part: Value,
    corners: &[[f64; 3]],
    fate: Fate,
    planes: &[Plane; 6],
    (run, is_faulty): (&dyn Run, bool),
) -> Verdict {
    let told = match fate.outcome {
        Outcome::Kept => Message::new("verdict-part-kept"),
        Outcome::Cut(plane) => Message::new("verdict-part-cut").with("plane", plane_name(plane)),
        Outcome::Lost(plane) => Message::new("verdict-part-lost").with("plane", plane_name(plane)),
    };
    let turn = match fate.outcome {
        Outcome::Lost(plane_idx) => Some(move_in(planes, corners, plane_idx)),
        Outcome::Kept | Outcome::Cut(_) => part_move_out(planes, corners).map(move_out),
    };
    Verdict {
        why: run.caption(fate.step),
        notes: [told.with("part", part)]
            .into_iter()
            .chain(turn.filter(|_| !is_faulty))
            .collect(),
        step: Some(fate.step),
    }
}

/// What is told of the scene's segment or one of its ends, by what became of it.
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
    let segment = scene.places.segment();
    let (part, corners) = match end {
        Some(end) => (end_name(end), &segment[end.idx()..=end.idx()]),
        None => (Value::Term("part-segment"), &segment[..]),
    };
    let told = (run, scene.method.card().is_faulty);
    Some(part_verdict(
        part,
        corners,
        fate(end)?,
        &region(scene, subject),
        told,
    ))
}

fn move_in(planes: &[Plane; 6], corners: &[[f64; 3]], plane_idx: usize) -> Message {
    let by = part_move_in(planes, corners, plane_idx);
    let message = Message::new(match by {
        Some(by) if by >= 0.0 => "verdict-part-in",
        Some(_) => "verdict-part-back",
        None => "verdict-part-never",
    });
    let message = message.with("move", by.unwrap_or_default().abs());
    message.with("plane", plane_name(plane_idx))
}

fn move_out(PartTurn { plane_idx, by }: PartTurn) -> Message {
    let key = if by < 0.0 {
        "verdict-part-out"
    } else {
        "verdict-part-touch"
    };
    let message = Message::new(key).with("move", by.abs());
    message.with("plane", plane_name(plane_idx))
}

/// What is told of a crossing: its edge's ends lie on different sides of a plane, until that is moved.
pub fn crossing_verdict(
    step: usize,
    plane_idx: usize,
    distances: [f64; 2],
    (run, is_faulty): (&dyn Run, bool),
) -> Verdict {
    let [inner, outer] = [f64::max, f64::min].map(|pick| pick(distances[0], distances[1]));
    let (key, by) = if -outer <= inner {
        ("verdict-crossing-out", -outer)
    } else {
        ("verdict-crossing-in", inner)
    };
    let turn = Message::new(key)
        .with("plane", plane_name(plane_idx))
        .with("inner", inner)
        .with("outer", outer)
        .with("move", by);
    Verdict {
        why: run.caption(step),
        notes: (!is_faulty).then_some(turn).into_iter().collect(),
        step: Some(step),
    }
}

#[cfg(test)]
mod tests {
    use super::super::first_scene;
    use crate::{
        figure::Link,
        labs::{Answers, Document, space::Scene},
    };

    /// Moves its segment and triangle aside, so that other planes decide.
    fn scenes(id: &'static str) -> impl Iterator<Item = Scene> {
        (-4..=4).map(move |i| {
            let mut scene = first_scene();
            scene.set_method(id);
            let moved = |[x, y, z]: [f64; 3]| [x + 2.5 * f64::from(i), y, z];
            let (segment, triangle) = (scene.places.segment(), scene.places.triangle());
            let places = scene.places.with_segment(segment.map(moved));
            let places = places.and_then(|places| places.with_triangle(triangle.map(moved)));
            scene.places = places.expect("finite");
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
                let told = |about| scene.verdict(about, &*runs[0]);
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
