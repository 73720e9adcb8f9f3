//! What each way to find who is in front costs, counted on streets of more and more triangles, a slice of the work in each frame.

use crate::{
    labs::{
        space::Scene,
        surfaces::{SurfaceCounting, SurfaceCounts},
    },
    panels::{prelude::*, space::StreetCosts},
};

/// Streets of so many boxes are counted: of 12 triangles each, from about 10 to about 10,000.
pub const SWEEP: [usize; 7] = [1, 3, 8, 25, 83, 250, 833];
pub struct SurfaceCosts {
    scene: Scene,
    /// Of the first streets of [`SWEEP`].
    pub sweep: Vec<SurfaceCounts>,
    current: Option<SurfaceCounting>,
}

/// Columns and rows.
fn size(scene: &Scene) -> [u32; 2] {
    scene.raster.size(scene.camera.aspect())
}

impl StreetCosts for SurfaceCosts {
    const TITLE_KEY: &'static str = "surface-costs-title";
    const NOTE_KEY: &'static str = "surface-costs-note";

    fn new(scene: &Scene) -> Self {
        Self {
            scene: scene.clone(),
            sweep: Vec::new(),
            current: None,
        }
    }

    /// Of this scene's raster, whatever is in it.
    fn are_of(&self, scene: &Scene) -> bool {
        let raster = |scene: &Scene| (size(scene), scene.raster.culls_backs);
        raster(&self.scene) == raster(scene)
    }

    fn about(&self) -> Message {
        let [columns, rows] = size(&self.scene).map(|side| side as usize);
        Message::new("surface-costs-about")
            .with("columns", columns)
            .with("rows", rows)
    }
}

impl Measuring for SurfaceCosts {
    fn is_done(&self) -> bool {
        self.sweep.len() == SWEEP.len()
    }

    fn progress(&self) -> f32 {
        self.sweep.len() as f32 / SWEEP.len() as f32
    }

    fn one(&mut self, _: &dyn Fn() -> f64) {
        let n_boxes = SWEEP[self.sweep.len()];
        let Some(current) = &mut self.current else {
            self.current = SurfaceCounting::new(&self.scene, n_boxes).ok();
            return;
        };
        if let Some(counts) = current.work() {
            self.sweep.push(counts);
            self.current = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        labs::surfaces::first_scene,
        panels::bench::{ticking, work_on},
    };

    #[test]
    fn every_street_is_counted_and_then_it_rests() {
        let mut scene = first_scene();
        scene.raster = scene.raster.with_rows(4);
        let mut costs = SurfaceCosts::new(&scene);
        let clock = ticking(1e-3);
        let mut n_frames = 0;
        while work_on(Some(&mut costs), &clock) {
            n_frames += 1;
        }
        assert!(n_frames > 1, "spread over frames: {n_frames}");
        let counted: Vec<usize> = costs.sweep.iter().map(|it| it.n_triangles).collect();
        assert_eq!(counted, SWEEP.map(|n| 12 * n));
        let is_sorted = |it: &SurfaceCounts| it.pairs.is_some();
        assert!(costs.sweep.iter().all(is_sorted));
        assert!(costs.are_of(&scene));
        scene.raster = scene.raster.with_rows(5);
        assert!(!costs.are_of(&scene));
    }
}
