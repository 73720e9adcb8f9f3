//! Triangles to pixels, against rays in exact and in long arithmetic.

use clipscope::{
    algo::surface::{
        Cull, LANES, Lanes, MeshRef, ScreenTriangle, Viewport, assemble, draw_rows, shade_rows,
    },
    geom::{Camera, Matrix, ViewVolume},
};
use proptest::prelude::*;

const SIZE: [u32; 2] = [24, 16];

fn viewport(bits: u32) -> Viewport {
    Viewport::new(SIZE, bits).expect("a small picture")
}

/// Positions of f32 that are eighths, in −1.5 to 1.5.
fn eighths() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(-12..13_i8).prop_map(|p| p.map(|x| f32::from(x) / 8.0))
}

fn drawn(
    triangles: &[ScreenTriangle<0>],
    viewport: &Viewport,
    mut put: impl FnMut(usize, u32),
) -> Vec<f32> {
    let [width, height] = viewport.size();
    let mut depths = vec![f32::INFINITY; (width * height) as usize];
    draw_rows(
        triangles,
        viewport,
        0..height,
        &mut depths,
        |place, id, _| put(place, id),
    );
    depths
}

fn assembled(
    positions: &[[f32; 3]],
    faces: &[[u32; 3]],
    clip_from_model: &Matrix,
    viewport: &Viewport,
    cull: Cull,
) -> Vec<ScreenTriangle<0>> {
    let attributes = vec![[]; positions.len()];
    let mesh = MeshRef {
        positions,
        attributes: &attributes,
        faces,
        first_id: 0,
    };
    let mut triangles = Vec::new();
    assemble(&mesh, clip_from_model, viewport, cull, &mut triangles);
    triangles
}

proptest! {
    /// A fan all the way around a point covers each pixel of the outline once: none twice, none left out.
    #[test]
    fn neighbours_leave_no_gap_and_share_no_pixel(
        center in prop::array::uniform2(-6..7_i8),
        bits in prop::sample::select(vec![0, 4, 8, 16]),
    ) {
        let rim = [[-1.0, -1.0], [0.3, -1.0], [1.0, -0.9], [1.0, 1.0], [-0.7, 1.0], [-1.0, 0.2]];
        let [x, y] = center.map(|x| f32::from(x) / 8.0);
        let mut positions: Vec<[f32; 3]> = rim.iter().map(|&[x, y]| [x, y, 0.0]).collect();
        positions.push([x, y, 0.0]);
        let faces: Vec<[u32; 3]> = (0..6).map(|i| [i, (i + 1) % 6, 6]).collect();
        let viewport = viewport(bits);
        let mut times = vec![0; (SIZE[0] * SIZE[1]) as usize];
        for face in faces {
            let one = assembled(&positions, &[face], &Matrix::IDENTITY, &viewport, Cull::Nothing);
            drawn(&one, &viewport, |place, _| times[place] += 1);
        }
        // The rim leaves out two slim corners; everywhere else each middle belongs to one.
        prop_assert!(times.iter().all(|&n| n <= 1));
        let inner = |place: usize| {
            let [column, row] = [place as u32 % SIZE[0], place as u32 / SIZE[0]];
            (2..SIZE[0] - 2).contains(&column) && (2..SIZE[1] - 2).contains(&row)
        };
        prop_assert!((0..times.len()).filter(|&place| inner(place)).all(|place| times[place] == 1));
    }

    /// By the signs of three whole determinants at the pixel's middle.
    #[test]
    fn a_pixel_is_covered_where_its_middle_is_inside(corners in prop::array::uniform3(prop::array::uniform2(-32..33_i8))) {
        let positions = corners.map(|[x, y]| [f32::from(x) / 32.0, f32::from(y) / 32.0, 0.0]);
        let viewport = viewport(Viewport::ANSWER_BITS);
        let mut covered = vec![false; (SIZE[0] * SIZE[1]) as usize];
        let triangles = assembled(&positions, &[[0, 1, 2]], &Matrix::IDENTITY, &viewport, Cull::Nothing);
        drawn(&triangles, &viewport, |place, _| covered[place] = true);
        // In 64ths of a pixel: x·W/2 + W/2 is one, for W = 24 and 16 both.
        let on_screen = |[x, y]: [i8; 2]| {
            [(i64::from(x) + 32) * i64::from(SIZE[0]), (32 - i64::from(y)) * i64::from(SIZE[1])]
        };
        let [a, b, c] = corners.map(on_screen);
        let side = |[p, q]: [[i64; 2]; 2], m: [i64; 2]| {
            ((q[0] - p[0]) * (m[1] - p[1]) - (q[1] - p[1]) * (m[0] - p[0])).signum()
        };
        for (place, &covered) in covered.iter().enumerate() {
            let [column, row] = [place as i64 % i64::from(SIZE[0]), place as i64 / i64::from(SIZE[0])];
            let middle = [64 * column + 32, 64 * row + 32];
            let sides = [[a, b], [b, c], [c, a]].map(|edge| side(edge, middle));
            let area = side([a, b], c);
            let strictly_inside = area != 0 && sides.iter().all(|&s| s == area);
            let outside = area == 0 || sides.contains(&-area);
            if strictly_inside || outside {
                prop_assert_eq!(covered, strictly_inside, "{} {}", column, row);
            }
        }
    }

    /// The id at each pixel is that of the nearest triangle on the ray through its middle, but beside edges and where two are
    /// as near.
    #[test]
    fn ids_are_those_of_rays(corners in prop::collection::vec(prop::array::uniform3(eighths()), 1..5)) {
        let volume = ViewVolume::perspective(70.0, 1.5, 0.5, 6.0).expect("a volume");
        let camera = Camera::new([0.5, 0.25, 2.5], [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
        let positions: Vec<[f32; 3]> = corners.iter().flatten().copied().collect();
        let faces: Vec<[u32; 3]> = (0..corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let viewport = viewport(Viewport::ANSWER_BITS);
        let clip_from_world = camera.clip_from_world();
        let triangles = assembled(&positions, &faces, &clip_from_world, &viewport, Cull::Nothing);
        let mut ids = vec![None; (SIZE[0] * SIZE[1]) as usize];
        drawn(&triangles, &viewport, |place, id| ids[place] = Some(id));
        for (place, id) in ids.iter().enumerate() {
            if let Some(expected) = nearest(&camera, &corners, place) {
                prop_assert_eq!(*id, expected, "pixel {}", place);
            }
        }
    }

    #[test]
    fn rows_drawn_apart_are_the_picture(corners in prop::array::uniform3(eighths()), cut in 1..15_u32) {
        let viewport = viewport(Viewport::PICTURE_BITS);
        let triangles = assembled(&corners, &[[0, 1, 2], [1, 0, 2]], &Matrix::IDENTITY, &viewport, Cull::Nothing);
        let whole = drawn(&triangles, &viewport, |_, _| {});
        let width = SIZE[0] as usize;
        let mut bands = vec![f32::INFINITY; whole.len()];
        let (upper, lower) = bands.split_at_mut(cut as usize * width);
        draw_rows(&triangles, &viewport, 0..cut, upper, |_, _, _| {});
        draw_rows(&triangles, &viewport, cut..SIZE[1], lower, |_, _, _| {});
        prop_assert_eq!(bands, whole);
    }
}

/// As one number, which tells attributes that differ in any bit apart, but by chance.
fn hash(id: u32, attributes: [f32; 2]) -> u32 {
    let bits = attributes.map(f32::to_bits);
    bits.into_iter().fold(id + 1, |hash, bits| {
        (hash ^ bits).wrapping_mul(0x0100_0193).rotate_left(7)
    })
}

fn hashes(id: u32, [u, v]: &[Lanes<f32>; 2]) -> Lanes<u32> {
    let mut hashes = [0; LANES];
    for (lane, hash_of) in hashes.iter_mut().enumerate() {
        *hash_of = hash(id, [u[lane], v[lane]]);
    }
    hashes
}

/// Depths and hashes as [`shade_rows`] leaves them in whatever was there, and as [`draw_rows`] puts them out for some rows
/// after the other.
fn both_ways(
    triangles: &[ScreenTriangle<2>],
    viewport: &Viewport,
    n_at_once: u32,
) -> [(Vec<f32>, Vec<u32>); 2] {
    let [width, height] = viewport.size();
    let n = (width * height) as usize;
    let (mut depths, mut samples) = (vec![-1.0; n], vec![77; n]);
    let target = (&mut depths[..], &mut samples[..]);
    shade_rows(triangles, viewport, 0..height, target, 5, hashes);
    let (mut one_by_one, mut put) = (vec![f32::INFINITY; n], vec![5; n]);
    for start in (0..height).step_by(n_at_once as usize) {
        let end = (start + n_at_once).min(height);
        let [from, to] = [start, end].map(|row| (row * width) as usize);
        let (depths, put) = (&mut one_by_one[from..to], &mut put[from..to]);
        draw_rows(triangles, viewport, start..end, depths, |place, id, uv| {
            put[place] = hash(id, uv);
        });
    }
    [(depths, samples), (one_by_one, put)]
}

fn assembled_with_attributes(
    corners: &[[[f32; 3]; 3]],
    viewport: &Viewport,
) -> Vec<ScreenTriangle<2>> {
    let positions = corners.as_flattened();
    let attributes: Vec<[f32; 2]> = positions.iter().map(|&[x, y, z]| [x + z, y - z]).collect();
    let faces: Vec<[u32; 3]> = (0..corners.len() as u32)
        .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
        .collect();
    let mesh = MeshRef {
        positions,
        attributes: &attributes,
        faces: &faces,
        first_id: 0,
    };
    let aspect = f64::from(viewport.size()[0]) / f64::from(viewport.size()[1]);
    let volume = ViewVolume::perspective(70.0, aspect, 0.5, 6.0).expect("a volume");
    let camera = Camera::new([0.5, 0.25, 1.5], [0.0; 3], [0.0, 1.0, 0.0], volume);
    let clip_from_world = camera.expect("a camera").clip_from_world();
    let mut triangles = Vec::new();
    assemble(
        &mesh,
        &clip_from_world,
        viewport,
        Cull::Nothing,
        &mut triangles,
    );
    triangles
}

proptest! {
    #[test]
    fn what_is_shaded_is_what_is_put_out(
        corners in prop::collection::vec(prop::array::uniform3(eighths()), 1..8),
        width in 1..20_u32,
    ) {
        let viewport = Viewport::new([width, 11], Viewport::PICTURE_BITS).expect("a small picture");
        let triangles = assembled_with_attributes(&corners, &viewport);
        let [shaded, put] = both_ways(&triangles, &viewport, 3);
        prop_assert_eq!(shaded, put);
    }
}

#[test]
fn a_picture_that_is_too_large_to_be_drawn_at_once_is_the_same() {
    let viewport = Viewport::new([400, 500], Viewport::PICTURE_BITS).expect("a picture");
    let corners: [[[f32; 3]; 3]; 3] = [
        [[-1.5, -1.5, 0.0], [1.5, -1.5, -1.0], [0.25, 1.5, 0.5]],
        [[-1.5, 1.0, 0.5], [1.5, -1.5, 0.25], [1.5, 1.5, -1.5]],
        [[0.0, -1.5, 1.75], [0.5, 0.25, 1.0], [-1.0, 1.5, -1.0]],
    ];
    let triangles = assembled_with_attributes(&corners, &viewport);
    let [shaded, put] = both_ways(&triangles, &viewport, 97);
    let n_drawn = put.1.iter().filter(|&&sample| sample != 5).count();
    assert!(n_drawn > 100_000, "most of it is covered: {n_drawn}");
    assert_eq!(shaded, put);
}

/// The triangle that a ray through a pixel's middle meets first; none where it is too near to an edge, or to another, to
/// tell.
#[expect(clippy::option_option, reason = "unknown, nothing, a triangle")]
fn nearest(camera: &Camera, triangles: &[[[f32; 3]; 3]], place: usize) -> Option<Option<u32>> {
    let [width, height] = SIZE.map(f64::from);
    let column = f64::from(place as u32 % SIZE[0]) + 0.5;
    let row = f64::from(place as u32 / SIZE[0]) + 0.5;
    let volume = camera.volume();
    let [half_x, half_y] = volume.half_size();
    let through = [
        (2.0 * column / width - 1.0) * half_x,
        (1.0 - 2.0 * row / height) * half_y,
    ];
    let view_from_world = camera.view_from_world();
    let mut hits: Vec<(f64, u32)> = Vec::new();
    for (id, triangle) in (0..).zip(triangles) {
        let [a, b, c] = triangle.map(|p| view_from_world.point(p.map(f64::from)));
        // Solve a + s (b − a) + t (c − a) = d·(x, y, −1) for s, t and the depth d.
        let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
        let ray = [-through[0], -through[1], 1.0];
        let (p, q, o) = (minus(b, a), minus(c, a), a.map(|x| -x));
        let det = |u: [f64; 3], v: [f64; 3], w: [f64; 3]| {
            u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
                + u[2] * (v[0] * w[1] - v[1] * w[0])
        };
        let whole = det(p, q, ray);
        if whole.abs() < 1e-6 {
            return None;
        }
        let (s, t, depth) = (
            det(o, q, ray) / whole,
            det(p, o, ray) / whole,
            det(p, q, o) / whole,
        );
        let least = s.min(t).min(1.0 - s - t);
        let ends = (depth - volume.near())
            .abs()
            .min((depth - volume.far()).abs());
        // Snapping moves corners by 2⁻¹⁷ of a pixel: seen at a slant that is more of a triangle.
        let unsure = 2e-4 / whole.abs();
        if least.abs() < unsure || ends < 1e-3 {
            return None;
        }
        if least > 0.0 && depth > volume.near() && depth < volume.far() {
            hits.push((depth, id));
        }
    }
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    match hits[..] {
        [one, two, ..] if two.0 - one.0 < 1e-3 => None,
        [(_, id), ..] => Some(Some(id)),
        [] => Some(None),
    }
}

#[test]
fn attributes_are_right_in_perspective() {
    // A floor from near to far: what lies in the middle of the picture's height is not halfway along it.
    let volume = ViewVolume::perspective(90.0, 1.5, 1.0, 100.0).expect("a volume");
    let clip_from_view = volume.clip_from_view();
    let positions = [
        [-9.0, -1.0, -1.0],
        [9.0, -1.0, -1.0],
        [9.0, -1.0, -9.0],
        [-9.0, -1.0, -9.0],
    ];
    let along = positions.map(|[_, _, z]: [f32; 3]| [-z]);
    let mesh = MeshRef {
        positions: &positions,
        attributes: &along,
        faces: &[[0, 1, 2], [0, 2, 3]],
        first_id: 0,
    };
    let viewport = viewport(Viewport::ANSWER_BITS);
    let mut triangles = Vec::new();
    assemble(
        &mesh,
        &clip_from_view,
        &viewport,
        Cull::Clockwise,
        &mut triangles,
    );
    let mut depths = vec![1.0; (SIZE[0] * SIZE[1]) as usize];
    let mut n = 0;
    draw_rows(
        &triangles,
        &viewport,
        0..SIZE[1],
        &mut depths,
        |place, _, [distance]| {
            let row = f64::from(place as u32 / SIZE[0]) + 0.5;
            // y/−z = 1 − 2 row/height on the floor y = −1.
            let expected = 1.0 / (2.0 * row / f64::from(SIZE[1]) - 1.0);
            assert!(
                (f64::from(distance) - expected).abs() < 1e-3 * expected,
                "{row}: {distance}"
            );
            n += 1;
        },
    );
    assert!(n > 100, "the floor is there: {n}");
    let mut none = Vec::new();
    assemble(
        &mesh,
        &clip_from_view,
        &viewport,
        Cull::CounterClockwise,
        &mut none,
    );
    assert!(none.is_empty(), "from above it shows its front");
}
