//! What culling spares, and what it takes: a scene drawn after all, some or none of its objects were left out.
//!
//! S0's question is whether a rough test pays: it is cheaper than an exact one, and leaves more to draw. So each way is a
//! piece of work that a stopwatch can be held to; all of them come to the same picture.

use crate::{
    algo::{
        cull::SphereBatch,
        surface::{Cull, MeshRef, ScreenTriangle, Viewport, assemble, draw_rows},
    },
    geom::Matrix,
    labs::{frustum::prelude::*, space::Object},
};

const SIZE: [u32; 2] = [320, 200];

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Culling {
    Nothing,
    Rough,
    /// Each by all of its triangles, until one is found that has a part inside.
    Exact,
}

impl Culling {
    pub const ALL: [Self; 3] = [Self::Nothing, Self::Rough, Self::Exact];

    pub const fn name_key(self) -> &'static str {
        match self {
            Self::Nothing => "culling-nothing",
            Self::Rough => "culling-rough",
            Self::Exact => "culling-exact",
        }
    }
}

pub struct CullingTask {
    planes: [Plane; 6],
    clip_from_world: Matrix,
    spheres: SphereBatch,
    meshes: Vec<PlacedMesh>,
    viewport: Viewport,
    kept: Vec<bool>,
    triangles: Vec<ScreenTriangle<0>>,
    depths: Vec<f32>,
    ids: Vec<u32>,
}

struct PlacedMesh {
    positions: Vec<[f32; 3]>,
    faces: Vec<[u32; 3]>,
    first_id: u32,
}

impl CullingTask {
    /// # Panics
    /// Never: the picture has a valid size.
    pub fn new(scene: &Scene) -> Self {
        let camera = scene.culler();
        let mut spheres = SphereBatch::default();
        let mut first_id = 0;
        let mut meshes = Vec::with_capacity(scene.objects().len());
        for object in scene.objects() {
            spheres.push(&object.in_funnel().sphere);
            let mesh = PlacedMesh::new(object, first_id);
            first_id += mesh.faces.len() as u32;
            meshes.push(mesh);
        }
        let n_pixels = (SIZE[0] * SIZE[1]) as usize;
        Self {
            planes: camera.planes_in_world(),
            clip_from_world: camera.clip_from_world(),
            spheres,
            meshes,
            viewport: Viewport::new(SIZE, Viewport::PICTURE_BITS).expect("a valid size"),
            kept: Vec::new(),
            triangles: Vec::new(),
            depths: vec![1.0; n_pixels],
            ids: vec![u32::MAX; n_pixels],
        }
    }

    /// Asks every object in this way; how many are left.
    pub fn cull(&mut self, culling: Culling) -> usize {
        match culling {
            Culling::Nothing => {
                self.kept.clear();
                self.kept.resize(self.meshes.len(), true);
            }
            Culling::Rough => self.spheres.keep(&self.planes, &mut self.kept),
            Culling::Exact => {
                let shows = |mesh: &PlacedMesh| mesh.shows(&self.clip_from_world);
                self.kept.clear();
                self.kept.extend(self.meshes.iter().map(shows));
            }
        }
        self.kept.iter().filter(|&&is_kept| is_kept).count()
    }

    /// Draws what the last culling left; how many triangles that were, before any of them was clipped.
    pub fn draw(&mut self) -> usize {
        self.triangles.clear();
        let mut n_triangles = 0;
        let kept = self.meshes.iter().zip(&self.kept);
        for (mesh, _) in kept.filter(|&(_, &is_kept)| is_kept) {
            n_triangles += mesh.faces.len();
            let mesh_ref = MeshRef {
                positions: &mesh.positions,
                attributes: &vec![[]; mesh.positions.len()],
                faces: &mesh.faces,
                first_id: mesh.first_id,
            };
            assemble(
                &mesh_ref,
                &self.clip_from_world,
                &self.viewport,
                Cull::Clockwise,
                &mut self.triangles,
            );
        }
        self.depths.fill(1.0);
        self.ids.fill(u32::MAX);
        let (ids, depths) = (&mut self.ids, &mut self.depths);
        draw_rows(
            &self.triangles,
            &self.viewport,
            0..SIZE[1],
            depths,
            |at, id, []| ids[at] = id,
        );
        n_triangles
    }

    pub fn ids(&self) -> &[u32] {
        &self.ids
    }
}

impl PlacedMesh {
    fn new(object: &Object, first_id: u32) -> Self {
        Self {
            positions: object.points().map(|p| p.map(|x| x as f32)).collect(),
            faces: object.model().mesh().faces().to_vec(),
            first_id,
        }
    }

    fn shows(&self, clip_from_world: &Matrix) -> bool {
        let corner = |i: u32| {
            let [x, y, z] = self.positions[i as usize].map(f64::from);
            let at = clip_from_world.times([x, y, z, 1.0]);
            ClipVertex { at, attributes: [] }
        };
        self.faces.iter().any(|face| {
            let corners = face.map(corner);
            let part = silent::<HomogeneousTriangle<[f32; 0]>>(&corners);
            !part.vertices().is_empty()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labs::{frustum::first_scene, space::street};

    #[test]
    fn whatever_is_culled_the_picture_is_the_same() {
        for (count, seed) in [(1, 1), (30, 2), (300, 3)] {
            let mut scene = first_scene();
            scene.set_objects(street(count, seed)).unwrap();
            let mut task = CullingTask::new(&scene);
            let mut pictures = Vec::new();
            let mut left = Vec::new();
            for culling in Culling::ALL {
                let n_kept = task.cull(culling);
                left.push((n_kept, task.draw()));
                pictures.push(task.ids().to_vec());
            }
            assert!(pictures.iter().all(|picture| *picture == pictures[0]));
            assert!(left.is_sorted_by(|a, b| a >= b), "{left:?}");
            assert_eq!(left[0], (count, 12 * count));
        }
    }
}
