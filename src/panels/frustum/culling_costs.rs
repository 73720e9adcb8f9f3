//! What culling costs on this machine: the scene, or streets of more and more boxes, culled and drawn in each way, a slice
//! of the work in each frame.

use std::hint::black_box;

use crate::{
    labs::{
        frustum::{Culling, CullingTask},
        space::{Scene, street},
    },
    panels::{prelude::*, space::StreetCosts},
};

/// Streets of so many boxes are measured, to see where the best choice changes.
pub const SWEEP: [usize; 9] = [1, 3, 10, 30, 100, 300, 1000, 3000, 10_000];
const SEED: u64 = 1;
/// Times that each way is taken, of which the fastest counts: what disturbs a measurement only makes it slower.
const N_PASSES: usize = 5;
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CullingCost {
    pub culling: Culling,
    pub cull_secs: f64,
    pub draw_secs: f64,
    pub n_kept: usize,
    pub n_triangles: usize,
}

impl CullingCost {
    pub fn secs(&self) -> f64 {
        self.cull_secs + self.draw_secs
    }
}

/// The costs of so many objects, in the order of [`Culling::ALL`].
pub type Costs = [CullingCost; 3];

pub struct CullingCosts {
    scene: Scene,
    /// Of so many boxes; none for the scene's own objects.
    pub street: Option<usize>,
    /// Of the objects that were asked for, once they are known.
    pub here: Option<Costs>,
    /// Of the first streets of [`SWEEP`].
    pub sweep: Vec<Costs>,
    current: Option<Current>,
}

struct Current {
    task: CullingTask,
    costs: Costs,
    n_done: usize,
    is_here: bool,
}

impl CullingCosts {
    pub fn n_objects(&self) -> usize {
        self.street.unwrap_or(self.scene.objects().len())
    }

    pub fn measure(&mut self, street: Option<usize>) {
        (self.street, self.here) = (street, None);
        self.current = self.current.take().filter(|current| !current.is_here);
    }

    fn next(&self) -> Option<Current> {
        let is_here = self.here.is_none();
        let street_of = |count| street(count, SEED);
        let objects = if is_here {
            self.street.map(street_of)
        } else {
            Some(street_of(*SWEEP.get(self.sweep.len())?))
        };
        let mut scene = self.scene.clone();
        if let Some(objects) = objects {
            scene.set_objects(objects).ok()?;
        }
        let costs = Culling::ALL.map(|culling| CullingCost {
            culling,
            cull_secs: f64::INFINITY,
            draw_secs: f64::INFINITY,
            n_kept: 0,
            n_triangles: 0,
        });
        Some(Current {
            task: CullingTask::new(&scene),
            costs,
            n_done: 0,
            is_here,
        })
    }
}

impl StreetCosts for CullingCosts {
    const TITLE_KEY: &'static str = "culling-title";
    const NOTE_KEY: &'static str = "culling-note";

    fn new(scene: &Scene) -> Self {
        Self {
            scene: scene.clone(),
            street: None,
            here: None,
            sweep: Vec::new(),
            current: None,
        }
    }

    fn are_of(&self, scene: &Scene) -> bool {
        self.scene.objects() == scene.objects() && self.scene.culler() == scene.culler()
    }

    fn about(&self) -> Message {
        Message::new("culling-about")
    }
}

impl Measuring for CullingCosts {
    fn is_done(&self) -> bool {
        self.here.is_some() && self.sweep.len() == SWEEP.len()
    }

    fn progress(&self) -> f32 {
        self.sweep.len() as f32 / SWEEP.len() as f32
    }

    fn one(&mut self, clock: &dyn Fn() -> f64) {
        let Some(mut current) = self.current.take() else {
            self.current = self.next();
            return;
        };
        let idx = current.n_done % Culling::ALL.len();
        let cost = &mut current.costs[idx];
        let start = clock();
        cost.n_kept = black_box(current.task.cull(cost.culling));
        let culled = clock();
        cost.n_triangles = black_box(current.task.draw());
        let drawn = clock();
        cost.cull_secs = cost.cull_secs.min(culled - start);
        cost.draw_secs = cost.draw_secs.min(drawn - culled);
        current.n_done += 1;
        if current.n_done < N_PASSES * Culling::ALL.len() {
            self.current = Some(current);
        } else if current.is_here {
            self.here = Some(current.costs);
        } else {
            self.sweep.push(current.costs);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        labs::frustum::first_scene,
        panels::bench::{ticking, work_on},
    };

    #[test]
    fn every_way_is_measured_and_then_it_rests() {
        let scene = first_scene();
        let mut costs = CullingCosts::new(&scene);
        let clock = ticking(1e-6);
        while costs.here.is_none() {
            work_on(Some(&mut costs), &clock);
        }
        let own = costs.here.unwrap();
        assert_eq!(own[0].n_kept, scene.objects().len());
        assert!(own[1].n_kept >= own[2].n_kept && own[2].n_kept > 0);
        costs.measure(Some(40));
        while costs.here.is_none() || costs.sweep.len() < 4 {
            work_on(Some(&mut costs), &clock);
        }
        assert_eq!(costs.here.unwrap()[0].n_kept, 40);
        assert_eq!(costs.sweep[3][0].n_kept, SWEEP[3]);
        assert!(costs.sweep.iter().flatten().all(|cost| cost.secs() > 0.0));
        assert!(costs.are_of(&scene));
    }
}
