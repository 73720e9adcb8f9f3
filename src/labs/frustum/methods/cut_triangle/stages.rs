//! What both methods hold after each plane, from runs of their own: for the small drawings and the totals, which show the whole run
//! at every step.

use crate::{
    algo::volume::{
        IntersectionPolygon, IntersectionPolygonEvent, PlaneAtATime, PlaneAtATimeEvent,
        SpaceVertex, TrianglePlanes, VolumeRules,
    },
    trace::Algorithm,
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

/// Of one polygon: a stage for each plane that there was something left for.
pub fn of_polygon<L: VolumeRules>(input: &TrianglePlanes) -> Vec<Stage> {
    let mut stages = Vec::new();
    let mut state = IntersectionPolygon::<L>::start(input);
    IntersectionPolygon::<L>::run::<f64>(input, |event| {
        IntersectionPolygon::<L>::apply(&mut state, event);
        if let IntersectionPolygonEvent::Pass { .. } = event {
            let [before, after] = [&state.passed, &state.input];
            stages.push(Stage {
                before: vec![before.clone()],
                after: vec![after.clone()],
                cuts: state.crossings.iter().map(|(_, at, _)| *at).collect(),
                counts: [before.len(), after.len()],
                n_triangles: after.len().saturating_sub(2),
                n_crossings: state.n_crossings,
            });
        }
    });
    stages
}

/// Of triangle by triangle.
pub fn of_triangles<L: VolumeRules>(input: &TrianglePlanes) -> Vec<Stage> {
    let (mut stages, mut cuts) = (Vec::new(), Vec::new());
    let mut state = PlaneAtATime::<L>::start(input);
    PlaneAtATime::<L>::run::<f64>(input, |event| {
        PlaneAtATime::<L>::apply(&mut state, event);
        if let PlaneAtATimeEvent::Cross { at, .. } = event {
            cuts.push(at);
        }
        if let PlaneAtATimeEvent::Pass { .. } = event {
            let rings = |list: &[[SpaceVertex; 3]]| list.iter().map(|t| t.to_vec()).collect();
            stages.push(Stage {
                before: rings(&state.passed),
                after: rings(&state.list),
                cuts: std::mem::take(&mut cuts),
                counts: [state.passed.len(), state.list.len()],
                n_triangles: state.list.len(),
                n_crossings: state.n_crossings,
            });
        }
    });
    stages
}
