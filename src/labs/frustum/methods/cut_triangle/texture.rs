//! A checkered texture on triangles in space.

use crate::{
    algo::volume::{ClipVertex, HomogeneousTriangle, SpaceVertex},
    figure::{Mark3, Role, Shape3},
    geom::Camera,
    trace::silent,
};

use super::clip_space::on_screen;

/// Fields along a side of the texture.
const FIELDS: usize = 6;

/// The dark fields, and a light ground under them: of triangles whose corners have places in the texture.
pub fn checkered(triangles: &[[SpaceVertex; 3]], role: Role) -> Vec<Mark3> {
    let mut marks = Vec::new();
    for triangle in triangles {
        let Some(corners) = placed(triangle) else {
            continue;
        };
        let dark = (0..FIELDS * FIELDS).map(|i| [i % FIELDS, i / FIELDS]);
        for field in dark.filter(|[i, j]| (i + j) % 2 == 0) {
            let part = part_in(&corners, field);
            // Tint over tint: dark enough to be told from the ground at a glance.
            for _ in 0..4 {
                marks.extend((part.len() > 2).then(|| wash(role, part.clone())));
            }
        }
        marks.push(wash(role, corners.iter().map(|(at, _)| *at).collect()));
    }
    marks
}

/// The same as the camera sees it where (u, v) is mixed evenly over the screen: as if all corners were at one depth.
pub fn checkered_on_screen(
    triangles: &[[SpaceVertex; 3]],
    camera: &Camera,
    role: Role,
) -> Vec<Mark3> {
    let clip_from_world = camera.clip_from_world();
    let flat = triangles.iter().map(|triangle| {
        triangle.map(|SpaceVertex { at: [x, y, z], uv }| SpaceVertex {
            at: on_screen(camera, clip_from_world.times([x, y, z, 1.0])),
            uv,
        })
    });
    checkered(&flat.collect::<Vec<_>>(), role)
}

fn wash(role: Role, outline: Vec<[f64; 3]>) -> Mark3 {
    Mark3::new(role, Shape3::Wash(outline))
}

type Placed = ([f64; 3], [f64; 2]);

fn placed(triangle: &[SpaceVertex; 3]) -> Option<[Placed; 3]> {
    let [a, b, c] = triangle.map(|v| Some((v.at, v.uv?)));
    Some([a?, b?, c?])
}

/// The part of a triangle that shows one field: clipped on the texture, where the field is a square, as the renderer clips; what
/// travels along is the place in space.
fn part_in(corners: &[Placed; 3], field: [usize; 2]) -> Vec<[f64; 3]> {
    let on_field = corners.map(|(place, uv)| {
        let [x, y] = [0, 1].map(|i| 2.0 * (uv[i] * FIELDS as f64 - field[i] as f64) - 1.0);
        ClipVertex {
            at: [x, y, 0.0, 1.0],
            attributes: place,
        }
    });
    let part = silent::<HomogeneousTriangle<[f64; 3]>>(&on_field);
    part.vertices().iter().map(|v| v.attributes).collect()
}
