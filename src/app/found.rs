//! What is found of a scene before its run can be shown: in a thread of its own where that takes long.

use web_time::Instant;

use crate::{
    figure::{
        Body, Caption, CodeLinks, Eyes, Lens, Need, Projected, Prospect, Run, Tick, View, Watch,
        sentences, watches,
    },
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
    /// Of each run; empty where it is not found ahead.
    pub told: Vec<Told>,
    /// What is seen of its spaces.
    pub ahead: Vec<Projected>,
    /// How long the runs took.
    pub secs: f64,
}

/// What a run tells at its steps, as far as all of them need room for it.
pub struct Told {
    pub sentences: Vec<Caption>,
    pub watches: Vec<Watch>,
    pub code_links: CodeLinks,
}

impl Told {
    pub fn of(run: &dyn Run) -> Self {
        Self {
            sentences: sentences(run),
            watches: watches(run),
            code_links: CodeLinks::of(run),
        }
    }
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
            told: Vec::new(),
            ahead: Vec::new(),
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
        let told = self.runs.iter().map(|run| Told::of(&**run)).collect();
        let wanted = Some(Wanted {
            bounds,
            needs,
            notation,
            prospect,
        });
        Self {
            wanted,
            told,
            ..self
        }
    }

    /// With what takes longest of two pictures, of the step that comes first, out of so many, and of the end: their solids, as
    /// these eyes see them, or those that are found for the first.
    pub fn with_pictures(self, first: impl Fn(usize) -> usize, mut eyes: Option<Eyes>) -> Self {
        let n_steps = self.runs[0].n_steps();
        let mut ahead = Vec::new();
        for step in [first(n_steps).min(n_steps), n_steps] {
            let views = |run: &dyn Run| run.frame(run.beside(&*self.runs[0], step)).views;
            let mut columns: Vec<Vec<View>> = self.runs.iter().map(|run| views(&**run)).collect();
            let eyes = eyes.get_or_insert_with(|| self.eyes(&columns));
            for views in &mut columns {
                eyes.turn(views);
            }
            look_ahead(&mut ahead, &columns.concat());
        }
        Self { ahead, ..self }
    }

    fn eyes(&self, columns: &[Vec<View>]) -> Eyes {
        let shown: Vec<&[View]> = columns.iter().map(|views| &views[..]).collect();
        let wanted = self.wanted.as_ref();
        wanted.map_or_else(Eyes::default, |wanted| {
            wanted.prospect.eyes(&shown, shown.len(), None)
        })
    }
}

fn look_ahead(ahead: &mut Vec<Projected>, views: &[View]) {
    for view in views {
        let Body::Space(space) = &view.body else {
            continue;
        };
        let lens = Lens::from(space.seer);
        if !ahead.iter().any(|known| known.is_of(space, &lens)) {
            space.facets.mesh();
            ahead.push(Projected::new(space, &lens));
        }
    }
}
