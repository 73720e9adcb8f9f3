//! Two triangles in clip space that share an edge, out of bytes: any w, also 0, negative, huge and tiny; and what must hold
//! of what is left of them.
//!
//! Bytes: how numbers are read, then the coordinates of four vertices.
#![no_main]

use clipscope::{
    algo::volume::{ClipPolygon, ClipVertex, HomogeneousTriangle, SideCode},
    trace::{laws, silent},
};
use libfuzzer_sys::fuzz_target;

type Algorithm = HomogeneousTriangle<[f64; 3]>;
type Vertex = ClipVertex<[f64; 3]>;

fuzz_target!(|bytes: &[u8]| {
    let Some((&how, mut rest)) = bytes.split_first() else {
        return;
    };
    let mut vertex = || -> Option<[f64; 4]> {
        let mut at = [0.0; 4];
        for x in &mut at {
            *x = number(how, &mut rest)?;
        }
        Some(at)
    };
    let (Some(a), Some(b), Some(c), Some(d)) = (vertex(), vertex(), vertex(), vertex()) else {
        return;
    };
    let [one, other] = [[a, b, c], [b, a, d]].map(|corners| {
        let triangle = weighted(corners);
        laws::check::<Algorithm>(&triangle);
        let polygon = silent::<Algorithm>(&triangle);
        check(&polygon);
        polygon
    });
    // On whole numbers nothing is as thin as rounding, and the common edge has the same cuts, bit for bit.
    if how % 3 == 0 {
        let cuts = [one, other].map(|polygon| on_first_edge(polygon.vertices()));
        if cuts.iter().all(|cuts| cuts.len() > 1) {
            assert_eq!(cuts[0], cuts[1], "{a:?} {b:?} {c:?} {d:?}");
        }
    }
});

/// A small whole number, one of the odd ones, or any that is finite.
fn number(how: u8, rest: &mut &[u8]) -> Option<f64> {
    const ODD: [f64; 16] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        5e-324,
        -5e-324,
        1e-300,
        -1e-300,
        1e300,
        -1e300,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        1.0 + f64::EPSILON,
        1.0 - 0.5 * f64::EPSILON,
        0.1,
    ];
    if how % 3 == 2 {
        let (bytes, after) = rest.split_first_chunk::<8>()?;
        *rest = after;
        let x = f64::from_le_bytes(*bytes);
        return x.is_finite().then_some(x);
    }
    let (&byte, after) = rest.split_first()?;
    *rest = after;
    Some(if how % 3 == 0 {
        f64::from(byte % 15) - 7.0
    } else {
        ODD[usize::from(byte) % ODD.len()]
    })
}

/// Each vertex's attributes say how much of each corner is in it.
fn weighted(corners: [[f64; 4]; 3]) -> [Vertex; 3] {
    std::array::from_fn(|i| {
        let mut attributes = [0.0; 3];
        attributes[i] = 1.0;
        ClipVertex {
            at: corners[i],
            attributes,
        }
    })
}

fn check(polygon: &ClipPolygon<[f64; 3]>) {
    for vertex in polygon.vertices() {
        assert!(vertex.at.iter().all(|x| x.is_finite()), "{polygon:?}");
        assert!(SideCode::of(vertex.at).is_inside(), "{polygon:?}");
        assert!(
            vertex.at[3] >= 0.0,
            "inside, nothing is behind the eye: {polygon:?}"
        );
        let shares = vertex.attributes;
        assert!(
            shares.iter().all(|x| (0.0..=1.0).contains(x)),
            "{polygon:?}"
        );
    }
}

/// The cuts of the edge between the first two corners: of the third there is nothing in them.
fn on_first_edge(polygon: &[Vertex]) -> Vec<[u64; 4]> {
    let on_edge = polygon.iter().filter(|v| v.attributes[2] == 0.0);
    // −0 and 0 are the same coordinate.
    let mut bits: Vec<[u64; 4]> = on_edge.map(|v| v.at.map(|x| (x + 0.0).to_bits())).collect();
    bits.sort_unstable();
    bits.dedup();
    bits
}
