//! What it takes to find who is in front, counted: pairs that painter's algorithm asks, questions that rays ask, fragments of the
//! depth buffer. On streets of more and more triangles, in pieces that are short enough to be done between two frames.

use crate::{
    algo::ring::Right,
    algo::surface::{
        DepthBuffer, DepthBufferInput, FragmentTally, Painter, PainterAnswer, PainterEvent,
        PainterHeld, RayCasting, RayCastingInput, Surfaces,
    },
    geom::SpaceError,
    labs::space::{
        Opening, Scene, TaughtCamera,
        soup::{MOST_ASKED, surfaces_on_raster},
        street,
    },
    trace::{Listening, Method, Told, silent},
};

const SEED: u64 = 1;
/// So many pairs that are asked are a piece of work.
const PAIRS: u32 = 10_000;
/// About so many questions of rays are a piece of work.
const QUESTIONS: usize = 50_000;

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SurfaceCounts {
    pub n_triangles: usize,
    /// Asked by painter's algorithm; not known where there is no order.
    pub pairs: Option<u64>,
    /// Asked by rays: as many as pixels times triangles.
    pub questions: u64,
    pub tally: FragmentTally,
}

pub struct SurfaceCounting {
    surfaces: Surfaces,
    counts: SurfaceCounts,
    stage: Stage,
}

enum Stage {
    /// So far.
    Painter(Box<PainterHeld>),
    DepthBuffer,
    /// From this pixel on.
    Rays(usize),
    Done,
}

impl SurfaceCounting {
    /// A street of so many boxes on a scene's raster, before a camera that sees along it: of a valid scene there is always one.
    pub fn new(scene: &Scene, n_boxes: usize) -> Result<Self, SpaceError> {
        let mut scene = scene.clone();
        scene.camera = TaughtCamera::new(
            [[0.0, 3.0, 9.0], [0.0, 1.0, -20.0], [0.0, 1.0, 0.0]],
            Opening::FovY(60.0),
            scene.camera.aspect(),
            [1.0, 150.0],
        )?;
        // A street has from one box to as many as a scene may have.
        let is_there = scene.set_objects(street(n_boxes, SEED)).is_ok();
        debug_assert!(is_there, "streets are valid");
        let surfaces = surfaces_on_raster(&scene).first(MOST_ASKED);
        let counts = SurfaceCounts {
            n_triangles: surfaces.triangles().len(),
            ..SurfaceCounts::default()
        };
        Ok(Self {
            stage: Stage::Painter(Box::new(Painter::<Right>::begin(&surfaces))),
            surfaces,
            counts,
        })
    }

    /// Does a piece of the work; the counts, once nothing is left.
    pub fn work(&mut self) -> Option<SurfaceCounts> {
        self.stage = match std::mem::replace(&mut self.stage, Stage::Done) {
            Stage::Painter(held) => self.pairs(held),
            Stage::DepthBuffer => {
                let output = silent::<DepthBuffer>(&DepthBufferInput::new(self.surfaces.clone()));
                self.counts.tally = output.tally;
                Stage::Rays(0)
            }
            Stage::Rays(from) => self.rays(from),
            Stage::Done => Stage::Done,
        };
        matches!(self.stage, Stage::Done).then_some(self.counts)
    }

    fn pairs(&mut self, mut held: Box<PainterHeld>) -> Stage {
        let mut n_asked = 0;
        let mut asked = Listening(|_: &PainterHeld, event| {
            let may = matches!(event, PainterEvent::Pair { may: true, .. });
            n_asked += u32::from(may);
            if may && n_asked >= PAIRS {
                Told::Break(())
            } else {
                Told::Continue(())
            }
        });
        if Painter::<Right>::run::<f64, _>(&self.surfaces, &mut held, &mut asked).is_break() {
            return Stage::Painter(held);
        }
        let output = Painter::<Right>::output(*held);
        self.counts.pairs = match output.answer {
            PainterAnswer::Order { .. } => Some(output.tally.pairs),
            PainterAnswer::Cycle { .. } => None,
        };
        Stage::DepthBuffer
    }

    fn rays(&mut self, from: usize) -> Stage {
        let [width, _] = self.surfaces.size().map(|side| side as usize);
        let to = from + (QUESTIONS / self.counts.n_triangles.max(1)).max(1);
        let to = to.min(self.surfaces.n_pixels());
        for place in from..to {
            let output = silent::<RayCasting>(&RayCastingInput {
                surfaces: self.surfaces.clone(),
                pixel: Some([(place % width) as u32, (place / width) as u32]),
            });
            self.counts.questions += output.n_asked;
        }
        if to < self.surfaces.n_pixels() {
            Stage::Rays(to)
        } else {
            Stage::Done
        }
    }
}

/// The exponent that fits best where counts grow like a power: the slope of the line through their logarithms. None of fewer than two
/// different numbers.
pub fn fitted_slope(points: &[[f64; 2]]) -> Option<f64> {
    let logs: Vec<[f64; 2]> = points.iter().map(|point| point.map(libm::log)).collect();
    let n = logs.len() as f64;
    let mean = |i: usize| logs.iter().map(|log| log[i]).sum::<f64>() / n;
    let [mx, my] = [mean(0), mean(1)];
    let spread: f64 = logs.iter().map(|[x, _]| (x - mx).powi(2)).sum();
    let together: f64 = logs.iter().map(|[x, y]| (x - mx) * (y - my)).sum();
    (spread > 0.0).then(|| together / spread)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labs::surfaces::first_scene;

    #[test]
    fn rays_ask_every_triangle_and_pairs_are_no_more_than_all() {
        let scene = first_scene();
        let mut counting = SurfaceCounting::new(&scene, 10).unwrap();
        let mut n_pieces = 0;
        let counts = loop {
            n_pieces += 1;
            if let Some(counts) = counting.work() {
                break counts;
            }
        };
        assert!(n_pieces >= 3, "{n_pieces}");
        let n = counts.n_triangles as u64;
        assert_eq!(n, 120);
        let [columns, rows] = scene.raster.size(scene.camera.aspect()).map(u64::from);
        assert_eq!(counts.questions, columns * rows * n);
        let pairs = counts.pairs.expect("boxes beside a street have an order");
        assert!(pairs > n && pairs <= n * (n - 1), "{pairs}");
        let tally = counts.tally;
        assert!(tally.pixels <= columns * rows && tally.pixels > 0);
        assert!(tally.fragments >= tally.writes && tally.writes >= tally.pixels);
    }

    #[test]
    fn a_power_is_its_own_slope() {
        let points = [1.0, 3.0, 10.0, 70.0].map(|n: f64| [n, 4.0 * n * n]);
        assert!((fitted_slope(&points).unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(fitted_slope(&points[..1]), None);
        assert_eq!(fitted_slope(&[]), None);
    }
}
