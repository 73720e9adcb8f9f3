//! The change that a verdict names turns it, and a little less does not.

use clipscope::{
    algo::{
        cull::{
            BackFace, BackFaceInput, Containment, FaceTurn, SphereCull, SphereCullInput, Viewer,
            face_turn, sphere_verdict, triangle_move,
        },
        volume::{
            IntersectionPolygon, LineInput, PlaneLine, SideCode, SpaceVertex, TrianglePlanes,
            part_move_in, part_move_out, signed_distance,
        },
    },
    geom::{Camera, Plane, Sphere, ViewVolume},
    trace::silent,
};
use glam::{DQuat, DVec3};
use proptest::prelude::*;

fn moved(input: &SphereCullInput, plane_idx: usize, by: f64) -> bool {
    let plane = &input.planes[plane_idx];
    let [x, y, z] =
        std::array::from_fn(|i| input.sphere.center()[i] + by * plane.normal()[i] / plane.length());
    let sphere = Sphere::new([x, y, z, input.sphere.radius()]).expect("finite");
    let planes = input.planes.clone();
    silent::<SphereCull>(&SphereCullInput { planes, sphere }).class == Containment::Outside
}

proptest! {
    #[test]
    fn a_sphere_turns_where_it_is_said(
        center in prop::array::uniform3(-12.0..12.0_f64),
        radius in 0.1..3.0_f64,
        fov in 20.0..100.0_f64,
    ) {
        let volume = ViewVolume::perspective(fov, 1.5, 1.0, 12.0).expect("a volume");
        let camera = Camera::new([0.5, 1.0, 6.0], [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
        let [x, y, z] = center;
        let sphere = Sphere::new([x, y, z, radius]).expect("a sphere");
        let input = SphereCullInput { planes: camera.planes_in_world().to_vec(), sphere };
        let verdict = sphere_verdict(&input).expect("there are planes");
        let is_culled = verdict.class == Containment::Outside;
        if let Some(turn) = verdict.turn {
            prop_assert_eq!(moved(&input, verdict.plane_idx, turn + turn.signum() * 1e-6), !is_culled);
            prop_assert_eq!(moved(&input, verdict.plane_idx, 0.99 * turn), is_culled);
        } else {
            // No move along this normal: some are tried.
            for step in 0..200 {
                prop_assert!(moved(&input, verdict.plane_idx, f64::from(step) * 0.1));
            }
        }
    }
}

/// A triangle moved as a whole along a plane's normal: are all of its corners beyond one plane?
fn is_rejected(camera: &Camera, triangle: &[[f64; 3]; 3], plane_idx: usize, by: f64) -> bool {
    let normal = camera.planes_in_world()[plane_idx].unit_normal();
    let codes = triangle.map(|corner| {
        let [x, y, z] = std::array::from_fn(|i| corner[i] + by * normal[i]);
        SideCode::of(camera.clip_from_world().times([x, y, z, 1.0]))
    });
    !codes[0].and(codes[1]).and(codes[2]).is_inside()
}

/// A triangle turned about its first corner.
fn turned([v0, v1, v2]: [[f64; 3]; 3], axis: [f64; 3], degrees: f64) -> [[f64; 3]; 3] {
    let turn = DQuat::from_axis_angle(DVec3::from(axis), degrees.to_radians());
    let about = DVec3::from(v0);
    let place = |v: [f64; 3]| (about + turn * (DVec3::from(v) - about)).into();
    [v0, place(v1), place(v2)]
}

proptest! {
    #[test]
    fn a_triangle_s_corners_turn_where_it_is_said(
        corners in prop::array::uniform3(prop::array::uniform3(-12.0..12.0_f64)),
        fov in 20.0..100.0_f64,
    ) {
        let volume = ViewVolume::perspective(fov, 1.5, 1.0, 12.0).expect("a volume");
        let camera = Camera::new([0.5, 1.0, 6.0], [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
        let planes = camera.planes_in_world();
        for (plane_idx, plane) in planes.iter().enumerate() {
            if corners.iter().any(|&c| signed_distance::<f64>(plane, c) >= 0.0) {
                continue;
            }
            let is_rejected = |by| is_rejected(&camera, &corners, plane_idx, by);
            prop_assert!(is_rejected(0.0));
            if let Some(by) = triangle_move(&planes, &corners, plane_idx) {
                prop_assert!(!is_rejected(by + 1e-6));
                prop_assert!(is_rejected(0.99 * by));
            } else {
                for step in 0..200 {
                    prop_assert!(is_rejected(0.2 * f64::from(step)));
                }
            }
        }
    }

    #[test]
    fn a_face_turns_where_it_is_said(
        triangle in prop::array::uniform3(prop::array::uniform3(-3.0..3.0_f64)),
        eye in prop::array::uniform3(-9.0..9.0_f64),
        is_parallel in any::<bool>(),
    ) {
        let viewer = if is_parallel { Viewer::Direction(eye) } else { Viewer::Eye(eye) };
        let is_front = |triangle| silent::<BackFace>(&BackFaceInput { triangle, viewer }).front;
        let turn = face_turn(&BackFaceInput { triangle, viewer });
        prop_assume!(turn.is_some());
        let FaceTurn { axis, degrees } = turn.expect("it has a normal");
        let beyond = turned(triangle, axis, 1.01 * degrees + degrees.signum() * 1e-6);
        prop_assert_eq!(is_front(beyond), !is_front(triangle));
        prop_assert_eq!(is_front(turned(triangle, axis, 0.99 * degrees)), is_front(triangle));
    }
}

/// Is something of a point, a segment or a triangle inside all planes? Asked of the clippers.
fn is_met(planes: &[Plane], corners: &[[f64; 3]]) -> bool {
    match *corners {
        [a, b, c] => {
            let planes = planes.to_vec();
            let triangle = [a, b, c].map(SpaceVertex::new);
            let left = silent::<IntersectionPolygon>(&TrianglePlanes { planes, triangle });
            !left.triangles.is_empty()
        }
        [a, .., b] | [a @ b] => {
            let bounds = planes.to_vec();
            let ends = [a, b];
            silent::<PlaneLine>(&LineInput { bounds, ends }).is_some()
        }
        [] => false,
    }
}

proptest! {
    #[test]
    fn a_point_a_segment_and_a_triangle_turn_where_it_is_said(
        corners in prop::array::uniform3(prop::array::uniform3(-9.0..9.0_f64)),
        fov in 20.0..100.0_f64,
    ) {
        let volume = ViewVolume::perspective(fov, 1.5, 1.0, 12.0).expect("a volume");
        let camera = Camera::new([0.5, 1.0, 6.0], [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
        let planes = camera.planes_in_world();
        for corners in [&corners[..1], &corners[..2], &corners] {
            let met_after = |plane_idx: usize, by: f64| {
                let normal = planes[plane_idx].unit_normal();
                let moved = |at: &[f64; 3]| std::array::from_fn(|i| at[i] + by * normal[i]);
                let moved: Vec<[f64; 3]> = corners.iter().map(moved).collect();
                is_met(&planes, &moved)
            };
            let is_there = is_met(&planes, corners);
            let turns: Vec<(usize, Option<f64>)> = if is_there {
                let turn = part_move_out(&planes, corners).expect("a volume is bounded");
                prop_assert!(turn.by <= 0.0);
                vec![(turn.plane_idx, Some(turn.by))]
            } else {
                (0..6).map(|i| (i, part_move_in(&planes, corners, i))).collect()
            };
            for (plane_idx, by) in turns {
                if let Some(by) = by {
                    prop_assert_eq!(met_after(plane_idx, by + by.signum() * 1e-6), !is_there);
                    prop_assert_eq!(met_after(plane_idx, 0.99 * by), is_there);
                } else {
                    for step in -100..100 {
                        prop_assert!(!met_after(plane_idx, 0.2 * f64::from(step)));
                    }
                }
            }
        }
    }
}
