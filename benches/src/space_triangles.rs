//! Clipping triangles before the divide, against a crate that does the same.

use std::hint::black_box;

use clipscope::{
    algo::volume::{ClipVertex, SideCode, clip_triangles},
};
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
/// Vertices are transformed mesh by mesh.
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

pub fn run() {
    let given = triangles();
    let mut ours: Vec<[ClipVertex<[f32; 3]>; 3]> = Vec::with_capacity(2 * N_TRIANGLES);
    let mut corners: Vec<[ClipVertex<[f32; 3]>; 3]> = Vec::with_capacity(MESH);
    let mut clip = || {
        ours.clear();
        for mesh in black_box(&given).chunks(MESH) {
            corners.clear();
            corners.extend(mesh.iter().map(|triangle| {
                triangle.map(|(at, attributes)| ClipVertex {
                    at: at.map(f64::from),
                    attributes,
                })
            }));
            clip_triangles(&corners, &mut ours);
        }
        ours.len()
    };
    let n_ours = clip();
    let mut theirs: Vec<Tri<ClipVert<Color3f>>> = Vec::with_capacity(2 * N_TRIANGLES);
    let mut coded: Vec<Tri<ClipVert<Color3f>>> = Vec::with_capacity(N_TRIANGLES);
    let mut their_clip = || {
        theirs.clear();
        coded.clear();
        // A vertex is given its outcode where it is made.
        coded.extend(black_box(&given).iter().map(|triangle| {
            Tri(triangle.map(|(at, [r, g, b])| {
                ClipVert::new(vertex(ProjVec3::new(at), rgb(r, g, b)))
            }))
        }));
        view_frustum::clip(&coded[..], &mut theirs);
        theirs.len()
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
