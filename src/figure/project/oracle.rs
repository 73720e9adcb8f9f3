//! Hidden lines against rays, outlines of balls against tangents, and the faces that are pointed at against the raster.

use glam::DVec3;

use super::{tests::space_of, *};
use crate::geom::{Camera, Matrix, Orbit, Solid, ViewVolume};

use super::super::{
    facet::{Edging, Facet},
    mark::Shape,
    role::{Link, Role},
    solid_mesh::SolidMesh,
    solids::{SolidPicture, SolidScreen, Solids},
    space::{Mark3, Shape3},
};

fn facets() -> Vec<Facet> {
    let parts = [
        (Solid::Cube, [0.0, 0.0, 0.0], [0.3, 0.5, 0.0]),
        (Solid::Octahedron, [0.9, 0.4, 0.3], [0.1, 0.2, 0.7]),
        (Solid::Torus, [-1.5, 0.2, -1.5], [1.2, 0.0, 0.4]),
    ];
    let mut facets = Vec::new();
    for (solid, at, angles) in parts {
        let place = Matrix::translation(at).after(&Matrix::rotation(angles));
        let mesh = solid.mesh();
        for &face in mesh.faces() {
            facets.push(Facet {
                corners: mesh.corners(face).map(|at| place.point(at)).to_vec(),
                role: Role::Accent,
                link: Some(Link::nth("face", facets.len())),
                skin: None,
                edging: Edging::Lines,
                opacity: 1.0,
            });
        }
    }
    facets
}

fn lenses() -> [Lens; 4] {
    let camera = |volume| {
        let camera = Camera::new([3.0, 2.5, 6.0], [0.2, 0.1, 0.0], [0.0, 1.0, 0.0], volume);
        Lens::Camera(camera.unwrap())
    };
    [
        Lens::Eye(Orbit::new([0.0; 3], [25.0, 18.0], 9.0, 30.0)),
        Lens::Eye(Orbit::new([0.0, 0.5, 0.0], [-140.0, -40.0], 6.0, 60.0)),
        camera(ViewVolume::perspective(45.0, 1.5, 0.5, 30.0).unwrap()),
        camera(ViewVolume::parallel(5.0, 1.5, -1.0, 30.0).unwrap()),
    ]
}

fn drawn(mark: Mark3, lens: &Lens) -> Vec<Mark> {
    project(&space_of(facets(), vec![mark], lens), lens)
}

fn ray(lens: &Lens, at: DVec3) -> (DVec3, f64) {
    match lens {
        Lens::Plane => panic!("no lens of space"),
        Lens::Eye(eye) => {
            let to_eye = DVec3::from(eye.position()) - at;
            (to_eye.normalize(), to_eye.length() - eye.near())
        }
        Lens::Camera(camera) => {
            let near = camera.volume().near();
            let back = DVec3::from(camera.axes()[2]);
            let to_eye = DVec3::from(camera.position()) - at;
            if Optics::of(lens).unwrap().is_parallel() {
                (back, back.dot(to_eye) - near)
            } else {
                let along = to_eye.normalize();
                (along, to_eye.length() - near / along.dot(back))
            }
        }
    }
}

/// Does a ray meet a triangle closer than that? T. Möller and B. Trumbore, 1997.
fn meets((from, along): (DVec3, DVec3), most: f64, [a, b, c]: [DVec3; 3]) -> bool {
    let (u_axis, v_axis) = (b - a, c - a);
    let across = along.cross(v_axis);
    let scale = 1.0 / u_axis.dot(across);
    let u = scale * (from - a).dot(across);
    let v = scale * along.dot((from - a).cross(u_axis));
    let t = scale * v_axis.dot((from - a).cross(u_axis));
    u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-5 && t < most
}

#[test]
fn what_is_dashed_is_what_no_ray_reaches_at_a_hundred_points_a_line() {
    const NEAR_AN_END: f64 = 1e-4;
    let corner = |i: usize| {
        let at = |n: usize| ((i * n) % 17) as f64 / 8.0 - 1.0;
        [2.4 * at(3), 1.6 * at(5), 2.4 * at(7)]
    };
    let facets = facets();
    let triangles = facets
        .iter()
        .map(|facet| [0, 1, 2].map(|i| DVec3::from(facet.corners[i])));
    let triangles: Vec<[DVec3; 3]> = triangles.collect();
    let (mut n_hidden, mut n_visible) = (0, 0);
    for lens in lenses() {
        for i in 0..40 {
            let ends = [corner(i), corner(i + 23)];
            let line = Mark3::new(Role::Signal, Shape3::Segment(ends));
            let drawn = drawn(line, &lens);
            let parts = drawn.iter().filter(|mark| mark.role == Role::Signal);
            let parts = parts.map(|mark| match &mark.shape {
                Shape::Segment(ends) => (false, *ends),
                Shape::Path(points) => (true, [points[0], points[1]]),
                other => panic!("{other:?}"),
            });
            let parts: Vec<(bool, [[f64; 2]; 2])> = parts.collect();
            let [from, to] = ends.map(DVec3::from);
            for k in 0..100 {
                let at = from.lerp(to, (f64::from(k) + 0.5) / 100.0);
                let Some(place) = lens.drawing_from_world(at.into()) else {
                    continue;
                };
                let (along, most) = ray(&lens, at);
                if most <= 0.0 {
                    continue;
                }
                let is_hidden = triangles.iter().any(|&it| meets((at, along), most, it));
                let of = |&(is_dashed, [a, b]): &(bool, [[f64; 2]; 2])| {
                    let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
                    let along = ((place[0] - a[0]) * (b[0] - a[0])
                        + (place[1] - a[1]) * (b[1] - a[1]))
                        / length;
                    let within = NEAR_AN_END..=length - NEAR_AN_END;
                    within.contains(&along).then_some(is_dashed)
                };
                let Some(is_dashed) = parts.iter().find_map(of) else {
                    continue;
                };
                assert_eq!(is_dashed, is_hidden, "{lens:?} {ends:?} {k}");
                n_hidden += usize::from(is_hidden);
                n_visible += usize::from(!is_hidden);
            }
        }
    }
    assert!(n_hidden.min(n_visible) > 2_000, "{n_hidden} {n_visible}");
}

#[test]
fn every_sight_line_of_a_balls_outline_touches_the_ball() {
    for lens in lenses() {
        for (centre, radius) in [
            ([0.0; 3], 1.0),
            ([1.5, -0.5, 0.7], 0.4),
            ([-1.0, 1.0, 0.0], 1.7),
        ] {
            let ball = Mark3::new(Role::Ink, Shape3::Ball(centre, radius));
            let drawn = drawn(ball, &lens);
            let outline = drawn.iter().find_map(|mark| match &mark.shape {
                Shape::Outline(outline) => Some(outline),
                _ => None,
            });
            let centre_at = DVec3::from(centre);
            for &place in outline.expect("seen from outside") {
                // Two places on the sight line: as far away as the middle, and farther.
                let nearer = centre_at + ray(&lens, centre_at).0;
                let behind = centre_at + (centre_at - nearer);
                let [a, b] = [centre, behind.into()]
                    .map(|beside| DVec3::from(lens.world_from_drawing(place, beside)));
                let along = (b - a).normalize();
                let off = (centre_at - a).cross(along).length();
                assert!((off - radius).abs() < 1e-9, "{lens:?}: {off}, not {radius}");
            }
        }
    }
}

#[test]
fn a_face_is_pointed_at_where_the_raster_shows_it() {
    const SIZE: [u32; 2] = [160, 100];
    let facets = facets();
    let mesh = SolidMesh::of(&facets);
    for lens in lenses() {
        let solids = Solids {
            facets: facets.clone().into(),
            lens,
        };
        let part = [[-1.6, -1.0], [1.6, 1.0]];
        let screen = SolidScreen::new(&mesh, &lens, part, SIZE).expect("something is seen");
        let picture = SolidPicture::new(&mesh, &screen);
        let [width, height] = SIZE.map(|side| side as usize);
        let mut depths = vec![1.0; width * height];
        let mut seen = vec![u32::MAX; width * height];
        picture.draw_rows(0..SIZE[1], &mut depths, &mut seen, &mut []);
        let mut n_compared = 0;
        for row in 1..height - 1 {
            for column in 1..width - 1 {
                let at = row * width + column;
                let around = [at - 1, at + 1, at - width, at + width];
                if around.iter().any(|&i| seen[i] != seen[at]) {
                    continue;
                }
                let place = [
                    1.6 * (2.0 * (column as f64 + 0.5) / width as f64 - 1.0),
                    1.0 - 2.0 * (row as f64 + 0.5) / height as f64,
                ];
                let expected = facets.get(seen[at] as usize).and_then(|facet| facet.link);
                assert_eq!(solids.link_at(place), expected, "{lens:?} {place:?}");
                n_compared += usize::from(expected.is_some());
            }
        }
        assert!(n_compared > 500, "{n_compared}");
    }
}
