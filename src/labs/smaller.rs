//! A scene made smaller, as long as the same holds of it: fewer vertices, rounder numbers.

use super::{Edit, Handle, Motion, Scene};

/// A scene is tried in so many ways at most: 20 vertices take some 600.
const MOST_TRIALS: usize = 3_000;
/// What a coordinate is rounded to, the roundest first.
const ROUND: [f64; 3] = [1.0, 0.5, 0.25];

/// The smallest that is found by leaving out vertices and rounding coordinates of free handles, one after the other; `None` where
/// none is.
pub fn smaller(
    scene: &Scene,
    is_free: &dyn Fn(Handle) -> bool,
    holds: &mut dyn FnMut(&Scene) -> bool,
) -> Option<Scene> {
    let mut search = Search {
        scene: scene.clone(),
        is_free,
        holds,
        trials: MOST_TRIALS,
    };
    let mut is_smaller = false;
    // Each round takes a vertex away or makes a coordinate rounder, and trials are bounded.
    while search.without_a_vertex() || search.with_rounder_numbers() {
        is_smaller = true;
    }
    is_smaller.then_some(search.scene)
}

struct Search<'a> {
    scene: Scene,
    is_free: &'a dyn Fn(Handle) -> bool,
    holds: &'a mut dyn FnMut(&Scene) -> bool,
    trials: usize,
}

impl Search<'_> {
    /// Takes the edited scene in place of this one, where it is another, it `may` be taken, and the same holds of it.
    fn takes(&mut self, edit: Edit, may: impl Fn(&Scene) -> bool) -> bool {
        let mut there = self.scene.clone();
        if self.trials == 0 || edit.apply(&mut there).is_err() || there == self.scene {
            return false;
        }
        if !may(&there) {
            return false;
        }
        self.trials -= 1;
        let is_taken = (self.holds)(&there);
        if is_taken {
            self.scene = there;
        }
        is_taken
    }

    fn handles(&self, is_wanted: fn(&Handle) -> bool) -> Vec<Handle> {
        let handles = self.scene.document().handles().into_iter();
        let free = handles.filter(|handle| (self.is_free)(*handle));
        free.filter(is_wanted).collect()
    }

    fn without_a_vertex(&mut self) -> bool {
        let vertices = self.handles(|handle| handle.kind().is_vertex);
        let mut vertices = vertices.into_iter().rev();
        vertices.any(|vertex| self.takes(Edit::Remove(Some(vertex)), |_| true))
    }

    fn with_rounder_numbers(&mut self) -> bool {
        let mut is_rounder = false;
        for handle in self.handles(has_place) {
            let Some(at) = self.scene.document().position(handle) else {
                continue;
            };
            let rounded = ROUND.map(|unit| at.map(|x| (x / unit).round() * unit));
            for to in rounded.into_iter().take_while(|to| *to != at) {
                let rough = roughness(&self.scene);
                if self.takes(Edit::Drag(handle, to), |there| roughness(there) < rough) {
                    is_rounder = true;
                    break;
                }
            }
        }
        is_rounder
    }
}

/// Is it a place that the scene is written with? A window is taken hold of as a whole, or by a side, where none of these is.
fn has_place(handle: &Handle) -> bool {
    handle.is_part() && !matches!(handle.kind().motion, Motion::Axis(_))
}

/// How many coordinates are not round, those that are the least so more often.
fn roughness(scene: &Scene) -> usize {
    let handles = scene.document().handles().into_iter();
    let places = handles
        .filter(has_place)
        .filter_map(|handle| scene.document().position(handle));
    let rough = |x: f64| {
        ROUND
            .iter()
            .position(|unit| (x / unit).fract() == 0.0)
            .unwrap_or(ROUND.len())
    };
    places.flatten().map(rough).sum()
}
