//! Triangle meshes with shared vertices.

use std::collections::HashMap;

use super::{AlignedBox, SpaceError};

/// Triangles that share their vertices. All numbers are finite, all indices name a vertex, and there is a triangle.
#[derive(Clone, PartialEq, Debug)]
pub struct Mesh {
    positions: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    faces: Vec<[u32; 3]>,
    edges: Vec<MeshEdge>,
}

/// An edge of a mesh, and the faces that it bounds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MeshEdge {
    /// Its ends, the lower index first; of vertices in one place, the first.
    pub ends: [u32; 2],
    /// One face, and the other where there is one. Of an edge that bounds more, the first two.
    pub faces: [Option<u32>; 2],
}

/// Why numbers make no mesh. People read the sentence of [`Diagnostic`](crate::text::Diagnostic).
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum MeshError {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// Of this vertex.
        vertex_idx: usize,
    },
    /// A face names a vertex that there is not.
    NoSuchVertex {
        /// The face.
        face_idx: usize,
    },
    /// Not one triangle.
    NoFaces,
    /// Not as many texture coordinates as vertices, nor none.
    UvLength {
        /// As many as there are.
        n_uvs: usize,
        /// As many as there are vertices.
        n_vertices: usize,
    },
}

impl MeshError {
    /// The stable code of `interfaces.md`.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "not-finite",
            Self::NoSuchVertex { .. } | Self::NoFaces => "degenerate",
            Self::UvLength { .. } => "wrong-length",
        }
    }
}

impl Mesh {
    /// Texture coordinates are none, or one for each vertex; faces run counter-clockwise as seen from outside.
    ///
    /// # Errors
    /// [`MeshError`]
    pub fn new(
        positions: Vec<[f32; 3]>,
        uvs: Vec<[f32; 2]>,
        faces: Vec<[u32; 3]>,
    ) -> Result<Self, MeshError> {
        let (n_vertices, n_uvs) = (positions.len(), uvs.len());
        if n_uvs != 0 && n_uvs != n_vertices {
            return Err(MeshError::UvLength { n_uvs, n_vertices });
        }
        let is_finite = |numbers: &[f32]| numbers.iter().all(|x| x.is_finite());
        let odd = positions.iter().position(|p| !is_finite(p));
        if let Some(vertex_idx) = odd.or_else(|| uvs.iter().position(|uv| !is_finite(uv))) {
            return Err(MeshError::NotFinite { vertex_idx });
        }
        let is_known = |face: &[u32; 3]| face.iter().all(|&i| (i as usize) < n_vertices);
        if let Some(face_idx) = faces.iter().position(|face| !is_known(face)) {
            return Err(MeshError::NoSuchVertex { face_idx });
        }
        if faces.is_empty() {
            return Err(MeshError::NoFaces);
        }
        let edges = edges(&positions, &faces);
        Ok(Self {
            positions,
            uvs,
            faces,
            edges,
        })
    }

    /// Around the origin, and as large as fits from −1 to 1 along every axis.
    #[must_use]
    pub fn fitted(mut self) -> Self {
        let Ok(bounds) = self.bounds() else {
            return self;
        };
        let (min, max) = (bounds.min(), bounds.max());
        let center: [f64; 3] = std::array::from_fn(|axis| min[axis].midpoint(max[axis]));
        let halves = (0..3).map(|axis| max[axis] - center[axis]);
        let half = halves.fold(0.0, f64::max);
        let scale = if half > 0.0 { half } else { 1.0 };
        for position in &mut self.positions {
            for (x, center) in position.iter_mut().zip(center) {
                *x = ((f64::from(*x) - center) / scale) as f32;
            }
        }
        self
    }

    /// Of the vertices.
    #[must_use]
    pub fn positions(&self) -> &[[f32; 3]] {
        &self.positions
    }

    /// Of the vertices; empty where there are none.
    #[must_use]
    pub fn uvs(&self) -> &[[f32; 2]] {
        &self.uvs
    }

    /// Three vertices each.
    #[must_use]
    pub fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// Each once, in the order in which faces first name them.
    #[must_use]
    pub fn edges(&self) -> &[MeshEdge] {
        &self.edges
    }

    /// Does every edge bound two faces: is there an inside?
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.edges.iter().all(|edge| edge.faces[1].is_some())
    }

    /// A face's corners.
    #[must_use]
    pub fn corners(&self, face: [u32; 3]) -> [[f64; 3]; 3] {
        face.map(|i| self.positions[i as usize].map(f64::from))
    }

    /// (V1 − V0) × (V2 − V0) of a face, pointing outside; not normalised.
    #[must_use]
    pub fn normal(&self, face: [u32; 3]) -> [f64; 3] {
        let [a, b, c] = self.corners(face).map(glam::DVec3::from);
        (b - a).cross(c - a).into()
    }

    /// The smallest box along the axes around it.
    ///
    /// # Errors
    /// Never: a mesh has vertices, and they are finite.
    pub fn bounds(&self) -> Result<AlignedBox, SpaceError> {
        AlignedBox::around(self.positions.iter().map(|p| p.map(f64::from)))
    }
}

/// The edges, vertices in one place taken for one: where a texture has a seam there is no gap.
fn edges(positions: &[[f32; 3]], faces: &[[u32; 3]]) -> Vec<MeshEdge> {
    let mut first_there: HashMap<[u32; 3], u32> = HashMap::with_capacity(positions.len());
    let place = |p: &[f32; 3]| p.map(|x| (x + 0.0).to_bits());
    let joined: Vec<u32> = (0..)
        .zip(positions)
        .map(|(i, p)| *first_there.entry(place(p)).or_insert(i))
        .collect();
    let mut known: HashMap<[u32; 2], usize> = HashMap::with_capacity(faces.len() * 3 / 2);
    let mut edges: Vec<MeshEdge> = Vec::with_capacity(faces.len() * 3 / 2);
    for (face_idx, face) in (0..).zip(faces) {
        let [a, b, c] = face.map(|i| joined[i as usize]);
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let ends = [from.min(to), from.max(to)];
            let idx = *known.entry(ends).or_insert_with(|| {
                let faces = [None; 2];
                edges.push(MeshEdge { ends, faces });
                edges.len() - 1
            });
            if let Some(free) = edges[idx].faces.iter_mut().find(|face| face.is_none()) {
                *free = Some(face_idx);
            }
        }
    }
    edges
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seam_of_the_texture_is_no_gap() {
        // A tetrahedron whose first vertex stands twice, with other texture coordinates.
        let positions = vec![
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [-0.0, 0.0, 0.0],
        ];
        let faces = vec![[0, 2, 1], [4, 1, 3], [0, 3, 2], [1, 2, 3]];
        let mesh = Mesh::new(positions.clone(), vec![[0.5, 0.5]; 5], faces.clone()).unwrap();
        assert!(mesh.is_closed());
        assert_eq!(mesh.edges().len(), 6);
        let open = Mesh::new(positions, Vec::new(), faces[..3].to_vec()).unwrap();
        assert!(!open.is_closed());
    }

    #[test]
    fn what_is_no_mesh_is_refused_where_it_is_wrong() {
        let square = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
        let mesh = |uvs, faces| Mesh::new(square.clone(), uvs, faces).err();
        let (n_uvs, n_vertices) = (1, 3);
        let cases = [
            (vec![], vec![], MeshError::NoFaces),
            (
                vec![],
                vec![[0, 1, 2], [0, 1, 3]],
                MeshError::NoSuchVertex { face_idx: 1 },
            ),
            (
                vec![[0.0; 2]],
                vec![[0, 1, 2]],
                MeshError::UvLength { n_uvs, n_vertices },
            ),
        ];
        for (uvs, faces, expected) in cases {
            assert_eq!(mesh(uvs, faces), Some(expected));
        }
        let positions = vec![[0.0; 3], [f32::NAN, 0.0, 0.0]];
        let odd = Mesh::new(positions, Vec::new(), vec![[0, 1, 1]]);
        assert_eq!(odd, Err(MeshError::NotFinite { vertex_idx: 1 }));
    }
}
