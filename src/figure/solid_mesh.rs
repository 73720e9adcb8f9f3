//! What is drawn of solids, wherever they are seen from.

use std::{panic::resume_unwind, thread};

use rustc_hash::FxHashMap;

use crate::{
    algo::surface::{Cull, MeshRef, ScreenTriangle, Viewport, assemble},
    geom::{Matrix, Texture},
};

use super::facet::{Edging, Facet};

/// Fewer triangles are put on the screen sooner by one thread.
const FEW: usize = 20_000;
/// More threads have too little to do.
const MOST_THREADS: usize = 4;

#[derive(Clone, PartialEq, Debug)]
pub struct SolidMesh {
    pub(super) positions: Vec<[f32; 3]>,
    /// Of each vertex, where any facet has a texture.
    pub(super) uvs: Vec<[f32; 2]>,
    triangles: Vec<[u32; 3]>,
    pub(super) facets: Vec<u32>,
    /// Of each facet, of length 1.
    pub normals: Vec<[f32; 3]>,
    pub(super) textures: Vec<Option<Texture>>,
    /// Of each facet; empty where all hide what is behind them.
    pub(super) opacities: Vec<f32>,
}

impl SolidMesh {
    pub fn of(facets: &[Facet]) -> Self {
        let n_corners = facets.iter().map(|facet| facet.corners.len()).sum();
        let mut mesh = Self {
            positions: Vec::new(),
            uvs: Vec::new(),
            textures: Vec::new(),
            opacities: opacities(facets),
            normals: facets.iter().map(normal).collect(),
            triangles: Vec::with_capacity(n_corners),
            facets: Vec::with_capacity(n_corners),
        };
        let mut vertices: FxHashMap<[u32; 5], u32> = FxHashMap::default();
        vertices.reserve(facets.len());
        let has_skin = facets.iter().any(|facet| facet.skin.is_some());
        if has_skin {
            let texture = |facet: &Facet| Some(facet.skin.as_ref()?.texture.clone());
            mesh.textures = facets.iter().map(texture).collect();
        }
        let mut corners = Vec::new();
        for (idx, facet) in (0..).zip(facets) {
            corners.clear();
            for &at in &facet.corners {
                let uv = facet.uv_at(at);
                let [x, y, z] = at.map(|x| x as f32 + 0.0);
                let key = [x, y, z, uv[0], uv[1]].map(f32::to_bits);
                let next = mesh.positions.len() as u32;
                let vertex = *vertices.entry(key).or_insert(next);
                if vertex == next {
                    mesh.positions.push([x, y, z]);
                    if has_skin {
                        mesh.uvs.push(uv);
                    }
                }
                corners.push(vertex);
            }
            for pair in corners.windows(2).skip(1) {
                mesh.triangles.push([corners[0], pair[0], pair[1]]);
                mesh.facets.push(idx);
            }
        }
        mesh
    }

    /// What is cut open shows its inner side.
    pub(super) fn on_screen<const N: usize>(
        &self,
        attributes: &[[f32; N]],
        clip_from_world: &Matrix,
        viewport: &Viewport,
    ) -> Vec<ScreenTriangle<N>> {
        let part = |(faces, first_id): (&[[u32; 3]], u32)| {
            let mesh = MeshRef {
                positions: &self.positions,
                attributes,
                faces,
                first_id,
            };
            let mut seen = Vec::with_capacity(faces.len());
            assemble(&mesh, clip_from_world, viewport, Cull::Nothing, &mut seen);
            seen
        };
        let n_at_once = self.triangles.len().div_ceil(self.n_threads()).max(1);
        let mut parts = self
            .triangles
            .chunks(n_at_once)
            .zip((0..).step_by(n_at_once));
        thread::scope(|scope| {
            let first = parts.next();
            let part = &part;
            let others = parts.map(|faces| scope.spawn(move || part(faces)));
            let others: Vec<_> = others.collect();
            let mut seen = first.map(part).unwrap_or_default();
            for other in others {
                seen.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
            }
            seen
        })
    }

    fn n_threads(&self) -> usize {
        let n_threads = if self.triangles.len() < FEW {
            1
        } else {
            MOST_THREADS
        };
        n_threads.min(thread::available_parallelism().map_or(1, usize::from))
    }
}

fn normal(facet: &Facet) -> [f32; 3] {
    facet.normal().as_vec3().to_array()
}

/// Where outlines are found between the samples, nothing can be seen through: they would be found within a face.
fn opacities(facets: &[Facet]) -> Vec<f32> {
    let opacity = |facet: &Facet| match facet.edging {
        Edging::Lines => facet.opacity,
        Edging::Samples { .. } => 1.0,
    };
    if facets.iter().all(|facet| opacity(facet) == 1.0) {
        return Vec::new();
    }
    facets.iter().map(opacity).collect()
}
