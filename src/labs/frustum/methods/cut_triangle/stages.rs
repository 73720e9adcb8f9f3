//! What both methods hold after each plane, which the small drawings and the totals show of the whole run at every step.

use std::convert::Infallible;

use crate::{
    algo::volume::{
        IntersectionPolygonEvent, IntersectionPolygonHeld, PlaneAtATimeEvent, PlaneAtATimeHeld,
    },
    figure::{Multiples, SmallDrawing, Weight},
    labs::frustum::prelude::*,
    trace::{Listening, Method, Told},
};

use super::super::asked::{plane_link, plane_name};
use super::PLANES_VIEW;

#[derive(Clone, PartialEq, Debug)]
pub struct Stage {
    /// The convex outlines that it took: one ring, or triangles.
    pub before: Vec<Vec<SpaceVertex>>,
    pub after: Vec<Vec<SpaceVertex>>,
    pub cuts: Vec<SpaceVertex>,
    pub counts: [usize; 2],
    /// Triangles, if there were no more planes.
    pub n_triangles: usize,
    /// Crossings with all planes so far.
    pub n_crossings: usize,
}

pub trait ByPlanes: Method<Input = TrianglePlanes> {
    fn cut(event: &Self::Event) -> Option<SpaceVertex>;

    /// The stage that an event ends, but for its cuts; `held` is what the method holds after it.
    fn stage(event: &Self::Event, held: &Self::Held) -> Option<Stage>;
}

/// A stage for each plane that there was something left for.
pub fn stages<M: ByPlanes>(input: &TrianglePlanes) -> Vec<Stage> {
    let (mut stages, mut cuts) = (Vec::new(), Vec::new());
    let mut listening = Listening(|held: &M::Held, event| {
        cuts.extend(M::cut(&event));
        if let Some(stage) = M::stage(&event, held) {
            let cuts = std::mem::take(&mut cuts);
            stages.push(Stage { cuts, ..stage });
        }
        Told::<Infallible>::Continue(())
    });
    let Told::Continue(()) = M::run::<f64, _>(input, &mut M::begin(input), &mut listening);
    stages
}

impl<L: VolumeRules> ByPlanes for IntersectionPolygon<L> {
    fn cut(event: &IntersectionPolygonEvent) -> Option<SpaceVertex> {
        match *event {
            IntersectionPolygonEvent::Cross(Crossing { at, .. }) => Some(at),
            _ => None,
        }
    }

    fn stage(event: &IntersectionPolygonEvent, held: &IntersectionPolygonHeld) -> Option<Stage> {
        let [before, after] = [held.lists.other(), held.lists.list()];
        let is_over = matches!(event, IntersectionPolygonEvent::Pass { .. });
        is_over.then(|| Stage {
            before: vec![before.clone()],
            after: vec![after.clone()],
            cuts: Vec::new(),
            counts: [before.len(), after.len()],
            n_triangles: after.len().saturating_sub(2),
            n_crossings: held.left.n_crossings,
        })
    }
}

impl<L: VolumeRules> ByPlanes for PlaneAtATime<L> {
    fn cut(event: &PlaneAtATimeEvent) -> Option<SpaceVertex> {
        match *event {
            PlaneAtATimeEvent::Cross { at, .. } => Some(at),
            _ => None,
        }
    }

    fn stage(event: &PlaneAtATimeEvent, held: &PlaneAtATimeHeld) -> Option<Stage> {
        let [before, after] = [&held.next, &held.left.triangles];
        let rings = |list: &[[SpaceVertex; 3]]| list.iter().map(|t| t.to_vec()).collect();
        let is_over = matches!(event, PlaneAtATimeEvent::Pass { .. });
        is_over.then(|| Stage {
            before: rings(before),
            after: rings(after),
            cuts: Vec::new(),
            counts: [before.len(), after.len()],
            n_triangles: after.len(),
            n_crossings: held.left.n_crossings,
        })
    }
}

/// What both methods have come to after so many planes, each by rules of its own.
pub fn tally<Polygon: ByPlanes, Triangles: ByPlanes>(
    own: &TrianglePlanes,
    n_planes: usize,
) -> WatchSection {
    let row = |name_key: &'static str, stages: &[Stage]| {
        let last = n_planes.min(stages.len()).checked_sub(1);
        let counts = match last {
            Some(last) => [stages[last].n_triangles, stages[last].n_crossings],
            None => [1, 0],
        };
        let cells = counts.map(|count| Some(Value::Count(count)));
        WatchRow::table(Value::Term(name_key), cells.into())
    };
    let header = ["tally-triangles", "tally-crossings"].map(Value::Term);
    let rows = vec![
        row("tally-one-polygon", &stages::<Polygon>(own)),
        row("tally-one-by-one", &stages::<Triangles>(own)),
    ];
    WatchSection::titled(header.into(), rows)
}

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
        let at = DVec3::from(at) - self.origin;
        self.axes.map(|axis| axis.dot(at))
    }

    fn ring(&self, ring: &[SpaceVertex]) -> Vec<[f64; 2]> {
        ring.iter().map(|v| self.place(v.at)).collect()
    }
}

#[derive(Clone, Copy, PartialEq)]
pub struct Progress {
    pub plane_idx: Option<usize>,
    pub n_done: usize,
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
pub fn small_view<M: ByPlanes>(
    own: &TrianglePlanes,
    progress: Progress,
    scenery: &Scenery,
) -> View {
    let (TrianglePlanes { planes, triangle }, stages) = (own, stages::<M>(own));
    let sheet = Sheet::of(triangle, scenery);
    let given = sheet.ring(triangle);
    let has_begun = progress.plane_idx.is_some() || progress.n_done > 0;
    let drawing = |idx: usize| {
        let is_current = progress.plane_idx == Some(idx);
        let is_to_come = !is_current && idx >= progress.n_done;
        let stage = stages.get(idx).filter(|_| has_begun);
        let strength = if is_to_come { TO_COME } else { 1.0 };
        let points = 1.0;
        let outline = Mark::new(Role::Discarded, Shape::Outline(given.clone()));
        let mut marks = vec![outline.weighing(Weight { points, strength }).dashed()];
        marks.extend(stage.into_iter().flat_map(|stage| {
            let has_fan = idx + 1 == planes.len() && (progress.is_done || is_to_come);
            stage_marks(&sheet, stage, (is_current, strength, has_fan))
        }));
        SmallDrawing {
            title: plane_name(Some(scenery), idx),
            note: stage.map(|stage| {
                let [before, after] = stage.counts.map(|n| n.to_string());
                (Role::Ink, Value::Formula(sym(before).sym(" → ").sym(after)))
            }),
            marks,
            is_current,
            is_to_come,
            n_known: (idx >= progress.n_done).then_some(1),
            link: Some(plane_link(idx)),
        }
    };
    let bound = |least: f64, pick: fn(f64, f64) -> f64| {
        [0, 1].map(|i| given.iter().map(|p| p[i]).fold(least, pick))
    };
    let row = Multiples {
        drawings: (0..planes.len()).map(drawing).collect(),
        bounds: [
            bound(f64::INFINITY, f64::min),
            bound(-f64::INFINITY, f64::max),
        ],
        tiles: Tiles::Strip,
    };
    View::new(PLANES_VIEW, Body::Multiples(row))
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
            marks.extend(ring[2..ring.len() - 1].iter().map(|&to| {
                let diagonal = Mark::new(Role::Accent, Shape::Segment([ring[0], to]));
                diagonal.weighing(line(1.0)).dashed()
            }));
        }
        let vertex = |&at| Mark::new(Role::Accent, Shape::Vertex(at)).weighing(line(2.2));
        marks.extend(ring.iter().filter(|at| !cuts.contains(at)).map(vertex));
    }
    let role = if is_current { Role::Signal } else { Role::Ink };
    if let Some(ends) = farthest(&cuts) {
        let width = if is_current { 2.5 } else { 1.5 };
        marks.push(Mark::new(role, Shape::Segment(beyond(ends))).weighing(line(width)));
    }
    let cut = |at| Mark::new(role, Shape::Vertex(at)).weighing(line(2.8));
    marks.extend(cuts.into_iter().map(cut));
    marks
}

/// The two points that are farthest apart: of points on one line its ends.
fn farthest(points: &[[f64; 2]]) -> Option<[[f64; 2]; 2]> {
    let distance = |[a, b]: [[f64; 2]; 2]| libm::hypot(b[0] - a[0], b[1] - a[1]);
    let after = |(i, &a): (usize, &[f64; 2])| points[i + 1..].iter().map(move |&b| [a, b]);
    let pairs = points.iter().enumerate().flat_map(after);
    pairs.max_by(|a, b| distance(*a).total_cmp(&distance(*b)))
}

fn beyond([a, b]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    const PART: f64 = 0.13;
    let at = |t: f64| [0, 1].map(|i| a[i] + t * (b[i] - a[i]));
    [at(-PART), at(1.0 + PART)]
}
