//! Clipping triangles before the divide, against a crate that does the same.

use std::hint::black_box;

use clipscope::algo::volume::{ClipVertex, SideCode, clip_triangles};
use retrofire_core::{
    geom::{Tri, vertex},
    math::{Color3f, ProjVec3, rgb},
    render::clip::{ClipVert, view_frustum},
};

use crate::{
    harness::{Contender, Target, race},
    space::{Lot, table},
};

const N_TRIANGLES: usize = 100_000;
const N_ROUNDS: usize = 15;
/// Triangles of a mesh.
const MESH: usize = 500;

/// Corners and colours.
type Given = [([f32; 4], [f32; 3]); 3];

/// What the corners' codes say.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Inside,
    Outside,
    Cut,
}

fn kind(triangle: &Given) -> Kind {
    let [a, b, c] = triangle.map(|(at, _)| SideCode::of(at.map(f64::from)));
    match (a.and(b).and(c).is_inside(), a.or(b).or(c).is_inside()) {
        (false, _) => Kind::Outside,
        (true, true) => Kind::Inside,
        (true, false) => Kind::Cut,
    }
}

/// 30 % inside, 30 % outside, 40 % to be cut, in a mixed order.
fn triangles() -> Vec<Given> {
    let mut lot = Lot(2);
    let mut corner = |middle: [f32; 4]| {
        let at = middle.map(|x| x + 0.6 * (2.0 * lot.next() as f32 - 1.0));
        (at, [0.0; 3].map(|_: f32| lot.next() as f32))
    };
    let mut places = Lot(3);
    (0..N_TRIANGLES)
        .map(|i| {
            let wanted = match i % 10 {
                0 | 3 | 6 => Kind::Inside,
                1 | 4 | 7 => Kind::Outside,
                _ => Kind::Cut,
            };
            loop {
                let [x, y, z] = [0; 3].map(|_| 5.0 * (2.0 * places.next() as f32 - 1.0));
                let middle = [x, y, z, 3.0];
                let triangle = [0; 3].map(|_| corner(middle));
                if kind(&triangle) == wanted {
                    return triangle;
                }
            }
        })
        .collect()
}

fn wide(([x, y, z, w], attributes): ([f32; 4], [f32; 3])) -> ClipVertex<[f32; 3]> {
    let at = [x.into(), y.into(), z.into(), w.into()];
    ClipVertex { at, attributes }
}

/// With its outcode, which is found where a vertex is made.
fn coded_vertex((at, [r, g, b]): ([f32; 4], [f32; 3])) -> ClipVert<Color3f> {
    ClipVert::new(vertex(ProjVec3::new(at), rgb(r, g, b)))
}

pub fn run() {
    let given = triangles();
    // On both sides a mesh is made into vertices and clipped before the next, as it would be drawn.
    let mut corners: Vec<[ClipVertex<[f32; 3]>; 3]> = Vec::with_capacity(MESH);
    let mut ours: Vec<[ClipVertex<[f32; 3]>; 3]> = Vec::with_capacity(2 * MESH);
    let mut clip = || {
        let meshes = black_box(&given).chunks(MESH).map(|mesh| {
            corners.clear();
            corners.extend(mesh.iter().map(|&[a, b, c]| [wide(a), wide(b), wide(c)]));
            ours.clear();
            clip_triangles(&corners, &mut ours);
            black_box(&ours).len()
        });
        meshes.sum::<usize>()
    };
    let n_ours = clip();
    let mut coded: Vec<Tri<ClipVert<Color3f>>> = Vec::with_capacity(MESH);
    let mut theirs: Vec<Tri<ClipVert<Color3f>>> = Vec::with_capacity(2 * MESH);
    let mut their_clip = || {
        let meshes = black_box(&given).chunks(MESH).map(|mesh| {
            coded.clear();
            coded.extend(
                mesh.iter()
                    .map(|&[a, b, c]| Tri([coded_vertex(a), coded_vertex(b), coded_vertex(c)])),
            );
            theirs.clear();
            view_frustum::clip(&coded[..], &mut theirs);
            black_box(&theirs).len()
        });
        meshes.sum::<usize>()
    };
    let n_theirs = their_clip();
    println!(
        "## Triangles in clip space\n\n{N_TRIANGLES} triangles with three attributes against six planes, outcodes included: 30 % inside, 30 % outside, 40 % cut. Left: {n_ours}, by retrofire-core {n_theirs}. Here in f64, with cuts that neighbours share bit for bit; there in f32.\n"
    );
    let results = race(
        N_ROUNDS,
        vec![
            Contender::new("clipscope", || {
                black_box(clip());
            }),
            Contender::new("retrofire-core", || {
                black_box(their_clip());
            }),
        ],
    );
    table(
        &results,
        &["clipscope", "retrofire-core"],
        "retrofire-core",
        &[("clipscope", Target::AtMost(0.6))],
    );
}
