//! What is left after each plane, as small drawings in the triangle's own plane.

use glam::DVec3;

use crate::{
    algo::volume::SpaceVertex,
    figure::{Mark, Multiples, Role, Shape, SmallDrawing, Weight},
    geom::Plane,
    text::{Formula, Value},
};

use super::{
    super::{
        super::stage::Scenery,
        planes::{plane_link, plane_name},
    },
    stages::Stage,
};

/// How pale what is still to come is.
const TO_COME: f32 = 0.42;

/// Axes in the triangle's plane, turned as the observer sees it.
struct Sheet {
    origin: DVec3,
    axes: [DVec3; 2],
}

impl Sheet {
    fn of(triangle: &[SpaceVertex; 3], scenery: &Scenery) -> Self {
        let [a, b, c] = triangle.map(|v| DVec3::from(v.at));
        let eye = scenery.scene().eye;
        let [right, up, _] = eye.axes().map(DVec3::from);
        let mut normal = (b - a).cross(c - a).normalize_or(right.cross(up));
        if normal.dot(DVec3::from(eye.position()) - a) < 0.0 {
            normal = -normal;
        }
        let up = (up - normal * up.dot(normal)).normalize_or(normal.any_orthonormal_vector());
        Self {
            origin: a,
            axes: [up.cross(normal), up],
        }
    }

    fn place(&self, at: [f64; 3]) -> [f64; 2] {
        self.axes
            .map(|axis| axis.dot(DVec3::from(at) - self.origin))
    }

    fn ring(&self, ring: &[SpaceVertex]) -> Vec<[f64; 2]> {
        ring.iter().map(|v| self.place(v.at)).collect()
    }
}

/// Where the run is.
#[derive(Clone, Copy, PartialEq)]
pub struct Progress {
    /// The plane at work.
    pub plane_idx: Option<usize>,
    /// How many planes are done with.
    pub n_done: usize,
    /// Is the fan drawn?
    pub is_done: bool,
}

impl Progress {
    /// At a plane, which it may have done with; without one it is before the first, or over.
    pub fn at(plane_idx: Option<usize>, has_passed: bool, is_done: bool, n_planes: usize) -> Self {
        let n_done = match plane_idx {
            Some(idx) => idx + usize::from(has_passed),
            None if is_done => n_planes,
            None => 0,
        };
        Self {
            plane_idx,
            n_done,
            is_done,
        }
    }
}

/// One drawing a plane. What is still to come is pale; before the first step nothing is told of it.
pub fn small(
    triangle: &[SpaceVertex; 3],
    planes: &[Plane],
    stages: &[Stage],
    progress: Progress,
    scenery: &Scenery,
) -> Multiples {
    let sheet = Sheet::of(triangle, scenery);
    let given = sheet.ring(triangle);
    let has_begun = progress.plane_idx.is_some() || progress.n_done > 0;
    let drawing = |idx: usize| {
        let is_current = progress.plane_idx == Some(idx);
        let is_to_come = !is_current && idx >= progress.n_done;
        let stage = stages.get(idx).filter(|_| has_begun);
        let strength = if is_to_come { TO_COME } else { 1.0 };
        let mut marks = vec![
            Mark::new(Role::Discarded, Shape::Outline(given.clone()))
                .weighing(Weight {
                    points: 1.0,
                    strength,
                })
                .dashed(),
        ];
        marks.extend(stage.into_iter().flat_map(|stage| {
            let has_fan = idx + 1 == planes.len() && (progress.is_done || is_to_come);
            stage_marks(&sheet, stage, (is_current, strength, has_fan))
        }));
        SmallDrawing {
            title: plane_name(Some(scenery), idx),
            note: stage.map(|stage| {
                let [before, after] = stage.counts.map(|n| n.to_string());
                Value::Formula(Formula::default().sym(before).sym(" → ").sym(after))
            }),
            marks,
            is_current,
            is_to_come,
            link: Some(plane_link(idx)),
        }
    };
    let bound = |least: f64, pick: fn(f64, f64) -> f64| {
        [0, 1].map(|i| given.iter().map(|p| p[i]).fold(least, pick))
    };
    Multiples {
        drawings: (0..planes.len()).map(drawing).collect(),
        bounds: [
            bound(f64::INFINITY, f64::min),
            bound(f64::NEG_INFINITY, f64::max),
        ],
    }
}

fn stage_marks(
    sheet: &Sheet,
    stage: &Stage,
    (is_current, strength, has_fan): (bool, f32, bool),
) -> Vec<Mark> {
    let line = |points| Weight { points, strength };
    let mut marks = Vec::new();
    let cuts: Vec<[f64; 2]> = stage.cuts.iter().map(|v| sheet.place(v.at)).collect();
    if !cuts.is_empty() {
        let lost = stage.before.iter().map(|ring| sheet.ring(ring)).collect();
        marks.push(Mark::new(Role::Discarded, Shape::Fill(lost)).weighing(line(1.0)));
    }
    for ring in &stage.after {
        let ring = sheet.ring(ring);
        marks.push(Mark::new(Role::Accent, Shape::Area(vec![ring.clone()])).weighing(line(1.5)));
        if has_fan && ring.len() > 3 {
            let diagonals = ring[2..ring.len() - 1].iter().map(|&to| {
                Mark::new(Role::Accent, Shape::Segment([ring[0], to]))
                    .weighing(line(1.0))
                    .dashed()
            });
            marks.extend(diagonals);
        }
        let vertices = ring.iter().filter(|at| !cuts.contains(at));
        marks.extend(
            vertices.map(|&at| Mark::new(Role::Accent, Shape::Vertex(at)).weighing(line(2.2))),
        );
    }
    let role = if is_current { Role::Signal } else { Role::Ink };
    if let Some(ends) = farthest(&cuts) {
        let width = if is_current { 2.5 } else { 1.5 };
        marks.push(Mark::new(role, Shape::Segment(beyond(ends))).weighing(line(width)));
    }
    marks.extend(
        cuts.iter()
            .map(|&at| Mark::new(role, Shape::Vertex(at)).weighing(line(2.8))),
    );
    marks
}

/// The two points that are farthest apart: of points on one line its ends.
fn farthest(points: &[[f64; 2]]) -> Option<[[f64; 2]; 2]> {
    let distance = |[a, b]: [[f64; 2]; 2]| libm::hypot(b[0] - a[0], b[1] - a[1]);
    let pairs = points
        .iter()
        .enumerate()
        .flat_map(|(i, &a)| points[i + 1..].iter().map(move |&b| [a, b]));
    pairs.max_by(|a, b| distance(*a).total_cmp(&distance(*b)))
}

/// The plane's own line reaches a little beyond what it cuts.
fn beyond([a, b]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    const PART: f64 = 0.13;
    let at = |t: f64| [0, 1].map(|i| a[i] + t * (b[i] - a[i]));
    [at(-PART), at(1.0 + PART)]
}
