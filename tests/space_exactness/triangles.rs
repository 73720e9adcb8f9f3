//! Triangles in space against planes: by exact fractions, by each other, and by clipping before the divide.

use clipscope::{
    algo::volume::{
        ClipVertex, CutTriangles, HomogeneousTriangle, IntersectionPolygon, PlaneAtATime,
        SpaceVertex, TrianglePlanes, VolumeRules,
        faulty::{
            AllSides, DividesFirst, DropsOnPlane, EdgeByEdge, KeepsPlaceInTexture, MissesEdge,
        },
        weighted_sum,
    },
    geom::{Plane, ViewVolume},
    trace::{Method, laws, silent},
};
use proptest::prelude::*;

use super::whole::{cross, sum_of_four};

/// x, y, z, u, v, w in whole numbers, w > 0: the point (x, y, z)/w with (u, v)/w in the texture.
type Exact = [i128; 6];

fn planes(ints: &[[i64; 4]]) -> Vec<Plane> {
    let plane = |plane: &[i64; 4]| Plane::new(plane.map(|x| x as f64)).expect("a normal");
    ints.iter().map(plane).collect()
}

/// Of a texture that shows how much of the second and of the third corner is in a point.
fn triangle(corners: [[f64; 3]; 3]) -> [SpaceVertex; 3] {
    const UV: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    std::array::from_fn(|i| SpaceVertex {
        at: corners[i],
        uv: Some(UV[i]),
    })
}

fn exact(corners: [[i64; 3]; 3]) -> Vec<Exact> {
    let vertex = |i: usize| {
        let [x, y, z] = corners[i].map(i128::from);
        [x, y, z, i128::from(i == 1), i128::from(i == 2), 1]
    };
    (0..3).map(vertex).collect()
}

/// Clipped in fractions, each vertex against each plane.
fn clipped_exactly(mut ring: Vec<Exact>, planes: &[[i64; 4]]) -> Vec<Exact> {
    for &plane in planes {
        let plane = plane.map(i128::from);
        let distance = |v: &Exact| sum_of_four(plane, [v[0], v[1], v[2], v[5]]);
        let mut left: Vec<Exact> = Vec::new();
        for (i, s) in ring.iter().enumerate() {
            let p = &ring[(i + 1) % ring.len()];
            let [d1, d2] = [s, p].map(distance);
            if d1 >= 0 {
                left.push(*s);
            }
            if d1.signum() * d2.signum() < 0 {
                let cut = std::array::from_fn(|k| d1.abs() * p[k] + d2.abs() * s[k]);
                left.push(super::whole::shortened(cut));
            }
        }
        ring = left;
    }
    ring
}

fn number(a: i128, b: i128) -> f64 {
    a as f64 / b as f64
}

fn place(v: &Exact) -> [f64; 3] {
    [0, 1, 2].map(|i| number(v[i], v[5]))
}

/// Twice the area of a ring on the texture, which is that of the triangle over the whole of it.
fn share_of(ring: &[[f64; 2]]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter()
        .zip(next)
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum()
}

fn texture(ring: &[SpaceVertex]) -> Vec<[f64; 2]> {
    ring.iter().filter_map(|v| v.uv).collect()
}

fn shares(left: &CutTriangles) -> Vec<f64> {
    let share = |piece: &[SpaceVertex; 3]| share_of(&texture(piece));
    left.triangles.iter().map(share).collect()
}

/// In how many pieces a place of the texture lies; none where it is too near to an edge to tell.
fn n_pieces_at(left: &CutTriangles, p: [f64; 2]) -> Option<usize> {
    let mut n = 0;
    for piece in &left.triangles {
        let [a, b, c] = piece.map(|v| v.uv.expect("a place in the texture"));
        let turns = [
            share_of(&[a, b, p]),
            share_of(&[b, c, p]),
            share_of(&[c, a, p]),
        ];
        let least = turns.into_iter().fold(f64::INFINITY, f64::min);
        if least.abs() < 1e-9 {
            return None;
        }
        n += usize::from(least > 0.0);
    }
    Some(n)
}

fn any_planes() -> impl Strategy<Value = Vec<[i64; 4]>> {
    let plane = prop::array::uniform4(-6..7_i64);
    let plane = plane.prop_filter("a normal", |n| n[..3] != [0, 0, 0]);
    prop::collection::vec(plane, 1..7)
}

fn corners() -> impl Strategy<Value = [[i64; 3]; 3]> {
    prop::array::uniform3(prop::array::uniform3(-6..7_i64))
}

fn has_area([a, b, c]: [[i64; 3]; 3]) -> bool {
    let minus = super::whole::minus;
    cross(minus(b, a), minus(c, a)) != [0; 3]
}

fn input(corners: [[i64; 3]; 3], of: &[[i64; 4]]) -> TrianglePlanes {
    TrianglePlanes {
        planes: planes(of),
        triangle: triangle(corners.map(|at| at.map(|x| x as f64))),
    }
}

fn both(input: &TrianglePlanes) -> [CutTriangles; 2] {
    [
        silent::<PlaneAtATime>(input),
        silent::<IntersectionPolygon>(input),
    ]
}

proptest! {
    #[test]
    fn what_is_left_is_what_fractions_leave(corners in corners(), of in any_planes()) {
        let input = input(corners, &of);
        laws::check::<PlaneAtATime>(&input);
        laws::check::<IntersectionPolygon>(&input);
        let ring = if has_area(corners) { clipped_exactly(exact(corners), &of) } else { Vec::new() };
        let uv: Vec<[f64; 2]> = ring.iter().map(|v| [3, 4].map(|i| number(v[i], v[5]))).collect();
        for left in both(&input) {
            let shares = shares(&left);
            prop_assert!(shares.iter().all(|&share| share > -1e-12), "wound as before: {shares:?}");
            let whole: f64 = shares.iter().sum();
            prop_assert!((whole - share_of(&uv)).abs() < 1e-11, "{whole} of {ring:?}");
            for vertex in left.triangles.iter().flatten() {
                for plane in &input.planes {
                    prop_assert!(weighted_sum::<f64>(plane, vertex.at) >= 0.0, "{vertex:?}");
                }
                // Its place in the texture is that of its place in the triangle.
                let [u, v] = vertex.uv.expect("a place in the texture");
                for i in 0..3 {
                    let [a, b, c] = corners.map(|at| at[i] as f64);
                    let there = a + u * (b - a) + v * (c - a);
                    prop_assert!((there - vertex.at[i]).abs() < 1e-11, "{vertex:?}");
                }
            }
            for (i, v) in ring.iter().enumerate() {
                // One on the way between its neighbours needs no corner: the piece with it has no area.
                let [before, after] = [i + ring.len() - 1, i + 1].map(|i| uv[i % uv.len()]);
                if share_of(&[before, uv[i], after]).abs() < 1e-12 {
                    continue;
                }
                let near = |other: &SpaceVertex| (0..3).all(|i| (other.at[i] - place(v)[i]).abs() < 1e-11);
                let found = left.triangles.iter().flatten().any(near);
                prop_assert!(found || left.triangles.is_empty(), "{v:?} is a corner of what is left");
            }
        }
    }

    #[test]
    fn both_methods_cover_the_same_and_one_polygon_takes_no_more(
        corners in corners(),
        of in any_planes(),
        points in prop::collection::vec((0..40_i32, 0..40_i32), 12),
    ) {
        let input = input(corners, &of);
        let [one_by_one, polygon] = both(&input);
        for (i, j) in points {
            let p = [f64::from(i) / 40.0 + 0.003, f64::from(j) / 40.0 + 0.007];
            if let (Some(a), Some(b)) = (n_pieces_at(&one_by_one, p), n_pieces_at(&polygon, p)) {
                prop_assert_eq!(a, b);
                prop_assert!(a <= 1, "pieces lie side by side");
            }
        }
        prop_assert!(polygon.n_crossings <= one_by_one.n_crossings);
    }

    #[test]
    fn clipped_again_it_stays(corners in prop::array::uniform3(prop::array::uniform3(-3.0..3.0_f64)), of in any_planes()) {
        let input = TrianglePlanes { planes: planes(&of), triangle: triangle(corners) };
        for left in both(&input) {
            for &triangle in &left.triangles {
                let again = TrianglePlanes { triangle, ..input.clone() };
                let [a, b] = both(&again);
                prop_assert_eq!((a.n_crossings, b.n_crossings), (0, 0));
                if clipscope::algo::volume::has_area(&triangle) {
                    prop_assert_eq!(&a.triangles, &[triangle]);
                    prop_assert_eq!(&b.triangles, &[triangle]);
                }
            }
        }
    }

    /// Two triangles with a common edge, each walking it its own way.
    #[test]
    fn neighbours_share_their_cuts(
        corners in prop::array::uniform4(prop::array::uniform3(-3.0..3.0_f64)),
        of in any_planes(),
    ) {
        let [a, b, c, d] = corners;
        let of = planes(&of);
        let cut = |corners| TrianglePlanes { planes: of.clone(), triangle: triangle(corners) };
        let [one, other] = [both(&cut([a, b, c])), both(&cut([b, a, d]))];
        let cuts: Vec<Vec<[u64; 3]>> = one.iter().chain(&other).map(on_first_edge).collect();
        if cuts.iter().all(|cuts| cuts.len() > 1) {
            for other in &cuts[1..] {
                prop_assert_eq!(&cuts[0], other);
            }
        }
    }

    /// Every edge of a piece is some other piece's too, walked the other way, unless it lies on the border of what is left.
    #[test]
    fn pieces_of_one_triangle_meet_corner_on_corner(corners in corners(), of in any_planes()) {
        let input = input(corners, &of);
        let left = silent::<PlaneAtATime>(&input);
        let edges: Vec<[SpaceVertex; 2]> = left.triangles.iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .collect();
        for [a, b] in &edges {
            let has_twin = edges.iter().any(|[c, d]| c.at == b.at && d.at == a.at);
            let [[u1, v1], [u2, v2]] = [a, b].map(|v| v.uv.expect("a place in the texture"));
            let is_outer = u1.max(u2) < 1e-9 || v1.max(v2) < 1e-9 || (u1 + v1).min(u2 + v2) > 1.0 - 1e-9;
            let is_on = |plane: &Plane| [a, b].iter().all(|v| weighted_sum::<f64>(plane, v.at) < 1e-9);
            prop_assert!(has_twin || is_outer || input.planes.iter().any(is_on), "{a:?} {b:?}");
        }
    }

    #[test]
    fn no_number_is_too_odd(
        corners in prop::array::uniform3(prop::array::uniform3(odd_number())),
        of in prop::collection::vec(prop::array::uniform4(odd_number()), 1..4),
    ) {
        let planes: Vec<Plane> = of.iter().filter_map(|&plane| Plane::new(plane).ok()).collect();
        let input = TrianglePlanes { planes, triangle: triangle(corners) };
        laws::check::<PlaneAtATime>(&input);
        laws::check::<IntersectionPolygon>(&input);
        for left in both(&input) {
            for vertex in left.triangles.iter().flatten() {
                prop_assert!(vertex.at.iter().all(|x| x.is_finite()), "{vertex:?}");
            }
        }
    }

    /// Texture coordinates are linear in view space and in clip space: so both leave the same part of the texture.
    #[test]
    fn before_the_divide_the_same_is_left_as_in_view_space(
        corners in corners(),
        (fov, aspect) in (30.0..120.0_f64, 0.5..2.0_f64),
    ) {
        let volume = ViewVolume::perspective(fov, aspect, 1.0, 8.0).expect("a volume");
        let triangle = triangle(corners.map(|at| at.map(|x| x as f64)));
        let input = TrianglePlanes { planes: volume.planes().to_vec(), triangle };
        let in_view = silent::<IntersectionPolygon>(&input);
        let clip_from_view = volume.clip_from_view();
        let in_clip = triangle.map(|v| ClipVertex { at: clip_from_view.times([v.at[0], v.at[1], v.at[2], 1.0]), attributes: v.uv });
        let polygon = silent::<HomogeneousTriangle<Option<[f64; 2]>>>(&in_clip);
        let outline: Vec<[f64; 2]> = polygon.vertices().iter().filter_map(|v| v.attributes).collect();
        let whole: f64 = shares(&in_view).iter().sum();
        if has_area(corners) {
            prop_assert!((whole - share_of(&outline)).abs() < 1e-9, "{whole} of {outline:?}");
        }
    }

    #[test]
    fn mistakes_keep_the_laws(corners in corners(), of in any_planes()) {
        fn check<L: VolumeRules + std::fmt::Debug>(input: &TrianglePlanes) {
            laws::check::<PlaneAtATime<L>>(input);
            laws::check::<IntersectionPolygon<L>>(input);
        }
        let input = input(corners, &of);
        check::<MissesEdge>(&input);
        check::<DropsOnPlane>(&input);
        check::<KeepsPlaceInTexture>(&input);
        check::<EdgeByEdge>(&input);
        let in_clip = input.triangle.map(|v| ClipVertex { at: [v.at[0], v.at[1], v.at[2], v.at[0] - v.at[2]], attributes: v.uv });
        laws::check::<HomogeneousTriangle<Option<[f64; 2]>, AllSides>>(&in_clip);
        laws::check::<HomogeneousTriangle<Option<[f64; 2]>, DividesFirst>>(&in_clip);
        // Codes save work and change nothing.
        let [right, dear] = [
            silent::<HomogeneousTriangle<Option<[f64; 2]>>>(&in_clip),
            silent::<HomogeneousTriangle<Option<[f64; 2]>, AllSides>>(&in_clip),
        ];
        prop_assert_eq!(right.vertices(), dear.vertices());
    }
}

fn odd_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -3.0..3.0,
        Just(0.0),
        Just(-1.0),
        Just(5e-324),
        Just(-1e-300),
        Just(1e300),
        Just(f64::MAX),
        Just(f64::MIN),
    ]
}

/// What lies on the edge between the first two corners: of the third there is nothing in it.
fn on_first_edge(left: &CutTriangles) -> Vec<[u64; 3]> {
    let on_edge = left
        .triangles
        .iter()
        .flatten()
        .filter(|v| v.uv.is_some_and(|[_, v]| v == 0.0));
    let mut bits: Vec<[u64; 3]> = on_edge.map(|v| v.at.map(|x| (x + 0.0).to_bits())).collect();
    bits.sort_unstable();
    bits.dedup();
    bits
}

fn ring<A>(of: &[[i64; 4]], corners: [[f64; 3]; 3]) -> Vec<[[f64; 3]; 3]>
where
    A: Method<Input = TrianglePlanes, Output = CutTriangles>,
{
    let input = TrianglePlanes {
        planes: planes(of),
        triangle: corners.map(SpaceVertex::new),
    };
    let left = silent::<A>(&input).triangles;
    left.iter().map(|piece| piece.map(|v| v.at)).collect()
}

type Corners = [[f64; 3]; 3];

#[test]
fn three_two_one_and_no_vertices_inside() {
    let above = [[0, 1, 0, 0]];
    let cases: [(Corners, &[Corners]); 6] = [
        (
            [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
            &[[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]],
        ),
        // Two: a quadrilateral, split at its first vertex.
        (
            [[0.0, -2.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0]],
            &[
                [[1.0, 0.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0]],
                [[1.0, 0.0, 0.0], [-2.0, 2.0, 0.0], [-1.0, 0.0, 0.0]],
            ],
        ),
        (
            [[0.0, 2.0, 0.0], [-2.0, -2.0, 0.0], [2.0, -2.0, 0.0]],
            &[[[0.0, 2.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]],
        ),
        ([[0.0, -1.0, 0.0], [2.0, -1.0, 0.0], [0.0, -2.0, 0.0]], &[]),
        // Touching only.
        ([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, -2.0, 0.0]], &[]),
        // One on the plane, one inside, one outside: the case that E5 misses.
        (
            [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, -2.0, 0.0]],
            &[[[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, 0.0, 0.0]]],
        ),
    ];
    for (corners, expected) in cases {
        assert_eq!(ring::<PlaneAtATime>(&above, corners), expected);
        assert_eq!(ring::<IntersectionPolygon>(&above, corners), expected);
    }
}

#[test]
fn each_mistake_loses_or_keeps_what_it_is_known_for() {
    let on_plane = [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, -2.0, 0.0]];
    let above = [[0, 1, 0, 0]];
    assert_eq!(
        ring::<PlaneAtATime<MissesEdge>>(&above, on_plane),
        [on_plane],
        "E5: whole"
    );
    let inside = [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0]];
    assert_eq!(ring::<IntersectionPolygon>(&above, inside), [inside]);
    assert!(
        ring::<IntersectionPolygon<DropsOnPlane>>(&above, inside).is_empty(),
        "E6"
    );
    // The corner (0, 0) of two planes lies within the triangle, which has no edge there.
    let quarter = [[1, 0, 0, 0], [0, 1, 0, 0]];
    let around = [[-1.0, -1.0, 0.0], [3.0, -1.0, 0.0], [-1.0, 3.0, 0.0]];
    let right = ring::<IntersectionPolygon>(&quarter, around);
    let wrong = ring::<IntersectionPolygon<EdgeByEdge>>(&quarter, around);
    let has_corner = |left: &[[[f64; 3]; 3]]| left.iter().flatten().any(|at| at[..2] == [0.0, 0.0]);
    assert!(has_corner(&right), "{right:?}");
    assert!(
        wrong.is_empty(),
        "E16: the two points that are left of the slanted edge"
    );
}

#[test]
fn a_triangle_that_holds_the_whole_volume_is_cut_to_its_outline() {
    let square = [[1, 0, 0, 1], [-1, 0, 0, 1], [0, 1, 0, 1], [0, -1, 0, 1]];
    let around = [[-8.0, -8.0, 0.0], [8.0, -8.0, 0.0], [0.0, 9.0, 0.0]];
    let polygon = ring::<IntersectionPolygon>(&square, around);
    let one_by_one = ring::<PlaneAtATime>(&square, around);
    assert_eq!(polygon.len(), 2);
    assert!(one_by_one.len() > 2, "{one_by_one:?}");
}

#[test]
fn without_area_nothing_is_left_and_no_plane_is_asked() {
    let line = [[0.0, 0.0, 0.0], [0.1, 0.1, 0.1], [0.3, 0.3, 0.3]];
    let left = ring::<IntersectionPolygon>(&[[0, 0, 1, 5]], line);
    // 0.1 + 0.2 is not 0.3, but these three are on one line, bit for bit.
    assert!(left.is_empty());
    assert!(ring::<PlaneAtATime>(&[[0, 0, 1, 5]], line).is_empty());
}

#[test]
fn on_an_upright_plane_the_coordinate_is_assigned() {
    let planes = vec![Plane::new([0.0, 0.0, -1.0, -0.3]).expect("a plane")];
    let triangle = [[0.1, 0.7, 0.9], [1.3, 0.2, -1.7], [0.4, -1.1, -2.3]].map(SpaceVertex::new);
    let left = silent::<IntersectionPolygon>(&TrianglePlanes { planes, triangle });
    let on = left.triangles.iter().flatten().filter(|v| v.at[2] == -0.3);
    assert!(on.count() >= 2, "{left:?}");
}
