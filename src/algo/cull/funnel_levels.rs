//! How much of a scene is left after each test.

use serde::Serialize;

use super::Containment;

/// How much is left.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Level {
    /// Objects of which something is left.
    pub objects: usize,
    /// Triangles.
    pub triangles: usize,
}

/// How much is left after each test.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct FunnelLevels {
    /// Everything.
    pub scene: Level,
    /// After the spheres.
    pub spheres: Level,
    /// After the vertices' codes.
    pub vertices: Level,
    /// After the cuts.
    pub cuts: Level,
    /// Showing their front.
    pub facing: Level,
}

impl FunnelLevels {
    /// Of an object that is inside nothing is asked but its faces.
    pub(super) fn spheres_done(&mut self, class: Containment, n_triangles: usize) {
        match class {
            Containment::Outside => {}
            Containment::Straddles => self.spheres.add(1, n_triangles),
            Containment::Inside => {
                for level in [&mut self.spheres, &mut self.vertices, &mut self.cuts] {
                    level.add(1, n_triangles);
                }
            }
        }
    }
}

impl Level {
    /// More triangles of an object of which there was `before` as much.
    pub(super) const fn gain(&mut self, n_triangles: usize, before: Self) {
        self.triangles += n_triangles;
        self.objects = before.objects + 1;
    }

    pub(super) const fn add(&mut self, objects: usize, triangles: usize) {
        self.objects += objects;
        self.triangles += triangles;
    }
}
