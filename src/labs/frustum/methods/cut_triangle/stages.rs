//! What both methods hold after each plane: for the small drawings and the totals, which show the whole run at every step.

use std::convert::Infallible;

use crate::{
    algo::volume::{
        IntersectionPolygon, IntersectionPolygonEvent, IntersectionPolygonHeld, PlaneAtATime,
        PlaneAtATimeEvent, PlaneAtATimeHeld, SpaceVertex, TrianglePlanes, VolumeRules,
    },
    figure::{WatchRow, WatchSection},
    text::Value,
    trace::{Listening, Method, Told},
};

/// A plane's turn.
#[derive(Clone, PartialEq, Debug)]
pub struct Stage {
    /// The convex outlines that it took: one ring, or triangles.
    pub before: Vec<Vec<SpaceVertex>>,
    /// Those that it left.
    pub after: Vec<Vec<SpaceVertex>>,
    /// Where it cut.
    pub cuts: Vec<SpaceVertex>,
    /// Vertices of the ring, or triangles, before and after.
    pub counts: [usize; 2],
    /// Triangles, if there were no more planes.
    pub n_triangles: usize,
    /// Crossings with all planes so far.
    pub n_crossings: usize,
}

/// A method that cuts a triangle by planes.
pub trait ByPlanes: Method<Input = TrianglePlanes> {
    /// Where an event finds a crossing.
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
        if let IntersectionPolygonEvent::Cross { at, .. } = *event {
            Some(at)
        } else {
            None
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
        if let PlaneAtATimeEvent::Cross { at, .. } = *event {
            Some(at)
        } else {
            None
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

/// Triangles and crossings of both methods after so many planes, one polygon first.
pub fn tally(stages: [&[Stage]; 2], n_planes: usize) -> WatchSection {
    let names = ["tally-one-polygon", "tally-one-by-one"];
    let row = |(stages, name_key): (&[Stage], &'static str)| {
        let last = n_planes.min(stages.len()).checked_sub(1);
        let counts = match last {
            Some(last) => [stages[last].n_triangles, stages[last].n_crossings],
            None => [1, 0],
        };
        let cells = counts.map(|count| Some(Value::Count(count)));
        WatchRow::table(Value::Term(name_key), cells.into())
    };
    let header = ["tally-triangles", "tally-crossings"].map(Value::Term);
    let rows = stages.into_iter().zip(names).map(row);
    WatchSection::titled(header.into(), rows.collect())
}
