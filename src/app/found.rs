//! What is found of a scene before its run can be shown: in a thread of its own where that takes long.

use web_time::Instant;

use crate::{
    figure::{Need, Prospect, Run, Tick},
    labs::{Difference, MethodCard, Scene},
    text::Notation,
    trace::Counts,
    widgets::wanted,
};

/// More phases than this are not marked on the timeline.
const MOST_PHASES: usize = 400;

/// What is found of a scene once.
pub struct Found {
    pub scene: Scene,
    /// One at least: the scene's method first.
    pub runs: Vec<Box<dyn Run>>,
    pub difference: Option<Difference>,
    pub phases: Vec<usize>,
    pub baseline: Option<(&'static MethodCard, Counts)>,
    pub wanted: Option<Wanted>,
    /// How long the runs took.
    pub secs: f64,
}

/// What the views of the runs want, of which these bounds of the plane are to be seen, and from where space is seen best.
pub struct Wanted {
    pub bounds: [[f64; 2]; 2],
    pub needs: Vec<Vec<Need>>,
    pub notation: Notation,
    pub prospect: Prospect,
}

impl Found {
    pub fn of(scene: &Scene) -> Self {
        let start = Instant::now();
        let runs = scene.document().record();
        let secs = start.elapsed().as_secs_f64();
        let all: Vec<&dyn Run> = runs.iter().map(|run| &**run).collect();
        let difference = Difference::between(&scene.document().methods(), &all);
        let (main, n_steps) = (&runs[0], runs[0].n_steps());
        let phases = (1..=n_steps).filter(|&step| main.tick(step) == Tick::Phase);
        Self {
            phases: phases.take(MOST_PHASES).collect(),
            baseline: scene.document().baseline(),
            wanted: None,
            scene: scene.clone(),
            runs,
            difference,
            secs,
        }
    }

    pub fn with_wanted(self, bounds: [[f64; 2]; 2]) -> Self {
        let mut prospect = Prospect::default();
        let runs = self.runs.iter().map(|run| &**run);
        let (needs, notation) = wanted(runs, bounds, Some(&mut prospect));
        let wanted = Some(Wanted {
            bounds,
            needs,
            notation,
            prospect,
        });
        Self { wanted, ..self }
    }
}
