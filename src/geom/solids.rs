//! Solids that scenes are made of, about the origin and about 1 from it.

use std::f64::consts::{PI, TAU};

use super::Mesh;

/// A kind of generated solid.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Solid {
    /// From −1 to 1 along every axis.
    Cube,
    /// Four corners of that cube.
    Tetrahedron,
    /// Six corners on the axes.
    Octahedron,
    /// A ball of twenty faces, each cut into sixteen.
    Sphere,
    /// A ring around the y axis.
    Torus,
    /// An L, as deep as it is wide: concave.
    Angle,
}

impl Solid {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Cube,
        Self::Tetrahedron,
        Self::Octahedron,
        Self::Sphere,
        Self::Torus,
        Self::Angle,
    ];

    /// As files spell it.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Cube => "cube",
            Self::Tetrahedron => "tetrahedron",
            Self::Octahedron => "octahedron",
            Self::Sphere => "sphere",
            Self::Torus => "torus",
            Self::Angle => "angle",
        }
    }

    /// Its surface: closed, each face counter-clockwise as seen from outside.
    ///
    /// # Panics
    /// Never: what is generated is a mesh.
    #[must_use]
    pub fn mesh(self) -> Mesh {
        let (positions, faces) = match self {
            Self::Cube => prism(
                &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]],
                &[[0, 1, 2], [0, 2, 3]],
            ),
            Self::Tetrahedron => (
                vec![
                    [1.0, 1.0, 1.0],
                    [-1.0, -1.0, 1.0],
                    [-1.0, 1.0, -1.0],
                    [1.0, -1.0, -1.0],
                ],
                vec![[0, 1, 3], [0, 2, 1], [0, 3, 2], [1, 2, 3]],
            ),
            Self::Octahedron => octahedron(),
            Self::Sphere => sphere(2),
            Self::Torus => torus(16, 10),
            Self::Angle => prism(
                &[
                    [-1.0, -1.0],
                    [1.0, -1.0],
                    [1.0, 0.0],
                    [0.0, 0.0],
                    [0.0, 1.0],
                    [-1.0, 1.0],
                ],
                &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]],
            ),
        };
        let positions = positions.into_iter().map(|p| p.map(|x| x as f32)).collect();
        Mesh::new(positions, Vec::new(), faces).expect("a closed surface")
    }
}

type Surface = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// An outline in x and y, counter-clockwise, and the triangles of its inside, from z = −1 to 1.
fn prism(outline: &[[f64; 2]], inside: &[[u32; 3]]) -> Surface {
    let n = outline.len() as u32;
    let at = |z: f64| outline.iter().map(move |&[x, y]| [x, y, z]);
    let positions = at(1.0).chain(at(-1.0)).collect();
    let back = |&[a, b, c]: &[u32; 3]| [n + a, n + c, n + b];
    let mut faces: Vec<[u32; 3]> = inside.to_vec();
    faces.extend(inside.iter().map(back));
    for i in 0..n {
        let j = (i + 1) % n;
        faces.push([i, n + i, n + j]);
        faces.push([i, n + j, j]);
    }
    (positions, faces)
}

fn octahedron() -> Surface {
    let positions = (0..3).flat_map(|axis| {
        [1.0, -1.0].map(|side| {
            let mut at = [0.0; 3];
            at[axis] = side;
            at
        })
    });
    // Vertex 2·axis is on the positive side, the next on the negative; each flip turns a face round.
    let mut faces = Vec::new();
    for signs in 0..8_u32 {
        let [x, y, z] = [0, 1, 2].map(|axis| 2 * axis + (signs >> axis & 1));
        let is_even = signs.count_ones() % 2 == 0;
        faces.push(if is_even { [x, y, z] } else { [x, z, y] });
    }
    (positions.collect(), faces)
}

/// An icosahedron whose faces are cut in four, `times` over.
fn sphere(times: usize) -> Surface {
    let golden = 0.5 * (1.0 + 5f64.sqrt());
    let mut positions: Vec<[f64; 3]> = Vec::new();
    for axis in 0..3 {
        for b in [golden, -golden] {
            for a in [1.0, -1.0] {
                let mut at = [0.0; 3];
                at[axis] = a;
                at[(axis + 1) % 3] = b;
                positions.push(unit(at));
            }
        }
    }
    // Three corners that are all a shortest edge apart are a face.
    let near = |i: usize, j: usize| distance(positions[i], positions[j]) < 1.1;
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if near(i, j) && near(j, k) && near(k, i) {
                    let face = [i, j, k].map(|i| i as u32);
                    faces.push(outward(&positions, face));
                }
            }
        }
    }
    for _ in 0..times {
        faces = quartered(&mut positions, &faces);
    }
    (positions, faces)
}

fn quartered(positions: &mut Vec<[f64; 3]>, faces: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut middles = std::collections::HashMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            let [p, q] = [a, b].map(|i| positions[i as usize]);
            positions.push(unit([0, 1, 2].map(|i| p[i] + q[i])));
            positions.len() as u32 - 1
        })
    };
    let mut all = Vec::with_capacity(4 * faces.len());
    for &[a, b, c] in faces {
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        all.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    all
}

/// A tube of `n_around` corners, bent into a ring of `n_along` pieces.
fn torus(n_along: u32, n_around: u32) -> Surface {
    let [large, small] = [0.7, 0.3];
    let mut positions = Vec::new();
    let mut faces = Vec::new();
    for i in 0..n_along {
        let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(n_along));
        for j in 0..n_around {
            let (up, out) = libm::sincos(PI + TAU * f64::from(j) / f64::from(n_around));
            let radius = large + small * out;
            positions.push([radius * cos, small * up, -radius * sin]);
            let at = |i: u32, j: u32| (i % n_along) * n_around + j % n_around;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    (positions, faces)
}

fn unit(p: [f64; 3]) -> [f64; 3] {
    let length = distance(p, [0.0; 3]);
    p.map(|x| x / length)
}

fn distance(p: [f64; 3], q: [f64; 3]) -> f64 {
    let squares = (0..3).map(|i| (p[i] - q[i]) * (p[i] - q[i]));
    squares.sum::<f64>().sqrt()
}

/// The face turned so that it is seen from outside, of a solid around the origin.
fn outward(positions: &[[f64; 3]], face: [u32; 3]) -> [u32; 3] {
    let [a, b, c] = face.map(|i| glam::DVec3::from(positions[i as usize]));
    let [i, j, k] = face;
    let is_outward = a.cross(b).dot(c) > 0.0;
    if is_outward { face } else { [i, k, j] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six times the volume that a closed surface encloses, positive where its faces show outside.
    fn volume(mesh: &Mesh) -> f64 {
        let six_times = |&face: &[u32; 3]| {
            let [a, b, c] = mesh.corners(face).map(glam::DVec3::from);
            a.cross(b).dot(c)
        };
        mesh.faces().iter().map(six_times).sum()
    }

    #[test]
    fn every_solid_is_closed_and_shows_its_outside() {
        let volumes = [
            (Solid::Cube, 48.0, 1e-9),
            (Solid::Tetrahedron, 16.0, 1e-9),
            (Solid::Octahedron, 8.0, 1e-6),
            // Of a ball 8π, of a ring 6·2π²·0.7·0.09; their faces lie within.
            (Solid::Sphere, 25.1, 1.2),
            (Solid::Torus, 7.46, 0.9),
            (Solid::Angle, 36.0, 1e-9),
        ];
        for (solid, expected, within) in volumes {
            let mesh = solid.mesh();
            assert!(mesh.is_closed(), "{solid:?}");
            let found = volume(&mesh);
            assert!((found - expected).abs() <= within, "{solid:?}: {found}");
            // Euler: a ring has a hole.
            let euler = mesh.positions().len() + mesh.faces().len() - mesh.edges().len();
            let expected = if solid == Solid::Torus { 0 } else { 2 };
            assert_eq!(euler, expected, "{solid:?}");
            // Each edge is walked once either way.
            for edge in mesh.edges() {
                let [Some(one), Some(other)] = edge.faces else {
                    panic!("{solid:?}: {edge:?}")
                };
                let runs = |face: u32| {
                    let [a, b, c] = mesh.faces()[face as usize];
                    [[a, b], [b, c], [c, a]].contains(&edge.ends)
                };
                assert_ne!(runs(one), runs(other), "{solid:?}: {edge:?}");
            }
        }
    }
}
