//! Spheres, boxes and faces.

use std::cmp::Ordering;

use clipscope::{
    algo::cull::{
        BackFace, BackFaceInput, BoxCull, BoxCullInput, Containment, PointPlanes, PointPlanesInput,
        SphereCull, SphereCullInput, Viewer,
    },
    geom::{AlignedBox, Plane, Sphere},
    trace::{laws, silent},
};
use proptest::prelude::*;

use super::whole::{det, have_a_common_point, minus, sum};

fn numbers<const N: usize>(ints: [i64; N]) -> [f64; N] {
    ints.map(|x| x as f64)
}

fn planes(ints: &[[i64; 4]]) -> Vec<Plane> {
    let plane = |&plane: &[i64; 4]| Plane::new(numbers(plane)).expect("a normal");
    ints.iter().map(plane).collect()
}

fn any_planes() -> impl Strategy<Value = Vec<[i64; 4]>> {
    let plane = prop::array::uniform4(-6..7_i64);
    let plane = plane.prop_filter("a normal", |n| n[..3] != [0, 0, 0]);
    prop::collection::vec(plane, 1..7)
}

/// What all planes say, where each says it by `of`.
fn all(planes: &[[i64; 4]], of: impl Fn([i64; 4]) -> Containment) -> Containment {
    let said: Vec<Containment> = planes.iter().map(|&plane| of(plane)).collect();
    [Containment::Outside, Containment::Straddles]
        .into_iter()
        .find(|class| said.contains(class))
        .unwrap_or(Containment::Inside)
}

/// How n·c + d compares with r·|n|, by squares.
fn compare_with_radius(sum: i128, radius: i64, plane: [i64; 4]) -> Ordering {
    let squared_normal: i128 = plane[..3].iter().map(|&n| i128::from(n * n)).sum();
    let other = i128::from(radius * radius) * squared_normal;
    if sum < 0 {
        Ordering::Less
    } else {
        (sum * sum).cmp(&other)
    }
}

/// Sums beyond all numbers tell nothing, and what tells nothing must neither cull nor call it inside.
#[test]
fn a_sphere_too_far_out_to_be_measured_straddles() {
    let plane = Plane::new([1.0, -1.0, 0.0, 0.0]).expect("a plane");
    let sphere = Sphere::new([1e308, 1e308, 0.0, 1.0]).expect("a sphere");
    let far = Plane::new([1e300, -1e300, 0.0, 0.0]).expect("a plane");
    for (planes, expected) in [
        (vec![plane], Containment::Straddles),
        (vec![far], Containment::Straddles),
    ] {
        let input = SphereCullInput { planes, sphere };
        assert_eq!(silent::<SphereCull>(&input).class, expected);
    }
}

proptest! {
    #[test]
    fn spheres(planes_in in any_planes(), center in prop::array::uniform3(-9..10_i64), radius in 0..9_i64) {
        let [x, y, z] = center;
        let sphere = Sphere::new(numbers([x, y, z, radius])).expect("a sphere");
        let input = SphereCullInput { planes: planes(&planes_in), sphere };
        let output = silent::<SphereCull>(&input);
        let expected = all(&planes_in, |plane| {
            let distance = sum(plane, center);
            if distance < 0 && compare_with_radius(-distance, radius, plane).is_gt() {
                Containment::Outside
            } else if compare_with_radius(distance, radius, plane).is_lt() {
                Containment::Straddles
            } else {
                Containment::Inside
            }
        });
        prop_assert_eq!(output.class, expected);
        let asked_all = output.distances.len() == planes_in.len();
        prop_assert!(asked_all || output.class == Containment::Outside);
        laws::check::<SphereCull>(&input);
        let point = PointPlanesInput { planes: input.planes.clone(), point: sphere.center() };
        laws::check::<PointPlanes>(&point);
        let answer = silent::<PointPlanes>(&point);
        prop_assert_eq!(answer.inside, planes_in.iter().all(|&plane| sum(plane, center) >= 0));
    }

    #[test]
    fn boxes(
        planes_in in any_planes(),
        low in prop::array::uniform3(-5..5_i64),
        size in prop::array::uniform3(0..5_i64),
    ) {
        let high: [i64; 3] = std::array::from_fn(|i| low[i] + size[i]);
        let bounds = [low[0], low[1], low[2], high[0], high[1], high[2]];
        let input = BoxCullInput {
            planes: planes(&planes_in),
            bounds: AlignedBox::new(numbers(bounds)).expect("a box"),
        };
        let output = silent::<BoxCull>(&input);
        let corners: Vec<[i64; 3]> = (0..8)
            .map(|i| std::array::from_fn(|axis| if i >> axis & 1 == 1 { high[axis] } else { low[axis] }))
            .collect();
        let expected = all(&planes_in, |plane| match corners.iter().filter(|&&p| sum(plane, p) < 0).count() {
            0 => Containment::Inside,
            8 => Containment::Outside,
            _ => Containment::Straddles,
        });
        prop_assert_eq!(output.class, expected);
        let mut rows: Vec<[i128; 4]> = planes_in.iter().map(|plane| plane.map(i128::from)).collect();
        for axis in 0..3 {
            for (sign, border) in [(1, low[axis]), (-1, high[axis])] {
                let mut row = [0, 0, 0, i128::from(-sign * border)];
                row[axis] = i128::from(sign);
                rows.push(row);
            }
        }
        let meets = have_a_common_point(rows);
        prop_assert_eq!(output.false_positive, output.class != Containment::Outside && !meets);
        laws::check::<BoxCull>(&input);
    }

    #[test]
    fn faces(
        corners in prop::array::uniform3(prop::array::uniform3(-6..7_i64)),
        eye in prop::array::uniform3(-6..7_i64),
        scale in prop::sample::select(vec![1.0, 0.1, 1e-9]),
    ) {
        let [v0, v1, v2] = corners;
        let edges = [minus(v1, v0), minus(v2, v0)];
        let scaled = |p: [i64; 3]| numbers(p).map(|x| x * scale);
        let triangle = corners.map(scaled);
        let input = BackFaceInput { triangle, viewer: Viewer::Eye(scaled(eye)) };
        laws::check::<BackFace>(&input);
        let away = eye.map(|x| -x);
        let looking = BackFaceInput { triangle, viewer: Viewer::Direction(scaled(away)) };
        if scale == 1.0 {
            let volume = det([minus(eye, v0), edges[0], edges[1]]);
            let output = silent::<BackFace>(&input);
            prop_assert_eq!((output.front, output.dot, output.det), (volume > 0, volume as f64, volume as f64));
            let volume = det([eye.map(i128::from), edges[0], edges[1]]);
            let output = silent::<BackFace>(&looking);
            prop_assert_eq!((output.front, output.dot), (volume > 0, volume as f64));
        }
        // Turned round it shows its other side, or still none.
        let output = silent::<BackFace>(&input);
        let turned = BackFaceInput { triangle: [triangle[0], triangle[2], triangle[1]], ..input };
        prop_assert!(!(output.front && silent::<BackFace>(&turned).front));
    }
}

#[test]
fn the_worked_example_of_s2() {
    // N1 = (2, 1, 2), seen along V = (0, 0, −5): the slides have V·N = −10, visible; here e = −V.
    let of = |triangle: [[f64; 3]; 3]| {
        let viewer = Viewer::Direction([0.0, 0.0, -5.0]);
        let output = silent::<BackFace>(&BackFaceInput { triangle, viewer });
        (output.front, output.dot)
    };
    let n1 = [[0.0, 0.0, 0.0], [-1.0, 2.0, 0.0], [-1.0, 1.0, 0.5]];
    let n2 = [[0.0, 0.0, 0.0], [1.0, 3.0, 0.0], [0.0, 2.0, 1.0]];
    let normal = |[_, a, b]: [[f64; 3]; 3]| {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    };
    assert_eq!(normal(n1), [1.0, 0.5, 1.0], "half of (2, 1, 2)");
    assert_eq!(of(n1), (true, 5.0));
    assert_eq!(normal(n2), [3.0, -1.0, 2.0], "(−3, 1, −2), turned");
    let [a, b, c] = n2;
    assert_eq!(of([a, c, b]), (false, -10.0));
}

#[test]
fn an_eye_in_the_plane_sees_no_front_whatever_rounding_does() {
    let triangle = [[0.1, 0.2, 0.3], [0.7, 0.2, 0.3], [0.1, 0.9, 0.3]];
    for (z, front) in [
        (0.3, false),
        (f64::next_up(0.3), true),
        (f64::next_down(0.3), false),
    ] {
        let viewer = Viewer::Eye([1e9, 7.0, z]);
        assert_eq!(
            silent::<BackFace>(&BackFaceInput { triangle, viewer }).front,
            front
        );
    }
}
