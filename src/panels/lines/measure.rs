//! The lab's methods measured on this machine: all clip the same random batch.

use std::hint::black_box;

use crate::{
    algo::line::batch::{ClippedSegments, Segments, clip_all},
    geom::Segment,
    labs::lines::{Method, Pass, Scene, random_segments},
    panels::bench::Measuring,
    trace::Counts,
};

/// Segments in the batch: more than a cache line's worth of luck, less than a second of waiting.
const N_SEGMENTS: usize = 20_000;
/// Segments whose operations are counted: counting runs are slow, and averages settle early.
const N_COUNTED: usize = 500;
const N_PASSES: usize = 5;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Subject {
    Method(Method),
    Batch,
}

impl Subject {
    pub fn all() -> impl Iterator<Item = Self> {
        Method::all_right().map(Self::Method).chain([Self::Batch])
    }

    pub fn name_key(self) -> &'static str {
        match self {
            Self::Method(method) => method.card().name_key,
            Self::Batch => "measure-batch",
        }
    }

    fn pass(self, scene: &Scene, segments: &[Segment]) -> Pass {
        match self {
            Self::Method(method) => (method.info().pass)(scene, segments),
            Self::Batch => {
                let window = scene.window;
                let segments: Segments = segments.iter().copied().collect();
                let mut clipped = ClippedSegments::default();
                Box::new(move || {
                    clip_all(&window, &segments, &mut clipped);
                    // Counting all that is visible would take longer than clipping it.
                    usize::from(clipped.get(0).is_some())
                })
            }
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MeasuredCost {
    pub subject: Subject,
    /// Nanoseconds.
    pub nanos: f64,
    pub operations: Option<f64>,
}

pub struct Measure {
    scene: Scene,
    pub batch: Vec<Segment>,
    /// What has been measured so far, in the order of [`Subject::all`].
    pub costs: Vec<MeasuredCost>,
    waiting: Vec<Subject>,
    current: Option<Current>,
}

struct Current {
    subject: Subject,
    pass: Pass,
    best_secs: f64,
    n_done: usize,
    counted: Counts,
    n_counted: usize,
}

impl Measure {
    pub fn new(scene: &Scene, seed: u64) -> Self {
        let mut waiting: Vec<Subject> = Subject::all().collect();
        waiting.reverse();
        Self {
            scene: scene.clone(),
            batch: random_segments(&scene.window, N_SEGMENTS, seed),
            costs: Vec::new(),
            waiting,
            current: None,
        }
    }
}

impl Measuring for Measure {
    fn progress(&self) -> f32 {
        let current = self.current.as_ref().map_or(0.0, |current| {
            0.5 * current.n_done as f32 / N_PASSES as f32
                + 0.5 * current.n_counted as f32 / N_COUNTED as f32
        });
        let all = self.costs.len() + self.waiting.len() + usize::from(self.current.is_some());
        (self.costs.len() as f32 + current) / all.max(1) as f32
    }

    fn is_done(&self) -> bool {
        self.current.is_none() && self.waiting.is_empty()
    }

    fn one(&mut self, clock: &dyn Fn() -> f64) {
        let Some(current) = &mut self.current else {
            self.current = self.waiting.pop().map(|subject| Current {
                subject,
                pass: subject.pass(&self.scene, &self.batch),
                best_secs: f64::INFINITY,
                n_done: 0,
                counted: Counts::default(),
                n_counted: 0,
            });
            return;
        };
        if current.n_done < N_PASSES {
            let start = clock();
            black_box((current.pass)());
            current.best_secs = current.best_secs.min(clock() - start);
            current.n_done += 1;
        } else if let Subject::Method(method) = current.subject
            && current.n_counted < N_COUNTED.min(self.batch.len())
        {
            let segment = self.batch[current.n_counted];
            let counts = (method.info().cost)(&self.scene, segment);
            current.counted = current.counted + counts;
            current.n_counted += 1;
        } else {
            let Counts { add, mul, div, cmp } = current.counted;
            let all = (add + mul + div + cmp) as f64;
            self.costs.push(MeasuredCost {
                subject: current.subject,
                nanos: current.best_secs * 1e9 / self.batch.len().max(1) as f64,
                operations: (current.n_counted > 0).then(|| all / current.n_counted as f64),
            });
            self.current = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        geom::Window,
        panels::bench::{ticking, work_on},
    };

    #[test]
    fn every_method_is_measured_and_then_it_rests() {
        let window = Window::new(-1.0, -1.0, 1.0, 1.0).expect("ordered");
        let segments = random_segments(&window, 1, 1);
        let method = Method::all().next().expect("there are methods");
        let scene = Scene::new(method, window, segments).expect("one segment");
        let mut measure = Measure::new(&scene, 1);
        measure.batch.truncate(50);
        while work_on(Some(&mut measure), &ticking(1e-6)) {}
        assert_eq!(measure.costs.len(), Subject::all().count());
        for cost in &measure.costs {
            assert!(cost.nanos > 0.0, "{:?} takes time", cost.subject);
            let is_counted = cost.operations.is_some_and(|all| all > 0.0);
            assert_eq!(is_counted, cost.subject != Subject::Batch);
        }
    }
}
