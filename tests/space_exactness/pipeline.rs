//! The way from a vertex to the screen, against whole numbers and against matrices written by hand.

use clipscope::{
    algo::{
        pipeline::{PipelineSpace, ViewingPipeline, ViewingPipelineInput, ViewingPipelineOutput},
        surface::Viewport,
    },
    geom::{Camera, Matrix, ViewVolume},
    trace::{laws, silent},
};
use proptest::prelude::*;

/// Exact numbers are counted in this part of 1.
const PART: f64 = 1.0 / 4096.0;

fn viewport(size: [u32; 2]) -> Viewport {
    Viewport::new(size, Viewport::ANSWER_BITS).expect("a picture")
}

fn through(input: &ViewingPipelineInput) -> ViewingPipelineOutput {
    laws::check::<ViewingPipeline>(input);
    silent::<ViewingPipeline>(input)
}

/// Exactly this number, in parts.
fn parts(x: f64) -> i128 {
    let parts = x / PART;
    assert_eq!(parts.fract(), 0.0, "{x} is a whole number of parts");
    parts as i128
}

/// One of the 24 ways to stand square on: where back and up point to, as axis and sign.
fn square_on() -> impl Strategy<Value = [(usize, i64); 2]> {
    let sign = prop::sample::select(vec![-1_i64, 1]);
    (0..3_usize, 1..3_usize, sign.clone(), sign)
        .prop_map(|(back, other, a, b)| [(back, a), ((back + other) % 3, b)])
}

fn unit((axis, sign): (usize, i64)) -> [i64; 3] {
    std::array::from_fn(|i| if i == axis { sign } else { 0 })
}

fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

fn dot(a: [i64; 3], b: [i128; 3]) -> i128 {
    (0..3).map(|i| i128::from(a[i]) * b[i]).sum()
}

proptest! {
    /// Halves and quarters, a camera square on, 90°: every number on the way is exact, and must be that very number.
    #[test]
    fn dyadic_vertices_are_exact(
        point in prop::array::uniform3(-40..41_i64),
        model in prop::array::uniform3(prop::array::uniform4(-12..13_i64)),
        position in prop::array::uniform3(-20..21_i64),
        [back, up] in square_on(),
        distance in prop::sample::select(vec![1_i64, 2, 4, 8]),
        aspect in prop::sample::select(vec![0.5, 1.0, 2.0]),
        // (far + near) / (far − near) and 2·far·near / (far − near), in quarters.
        (depths, by_hand) in prop::sample::select(vec![
            ([1.0, 2.0], [12_i128, 16]),
            ([1.0, 3.0], [8, 12]),
            ([1.0, 5.0], [6, 10]),
            ([2.0, 6.0], [8, 24]),
        ]),
        size in prop::array::uniform2(1..4097_u32),
    ) {
        let rows = model.map(|row| row.map(|x| x as f64 / 4.0));
        let rows = [rows[0], rows[1], rows[2], [0.0, 0.0, 0.0, 1.0]];
        let target: [i64; 3] = std::array::from_fn(|i| position[i] - distance * unit(back)[i]);
        let volume = ViewVolume::perspective(90.0, aspect, depths[0], depths[1]).expect("a volume");
        let [from, to, upwards] = [position, target, unit(up)].map(|at| at.map(|x| x as f64));
        let input = ViewingPipelineInput {
            point: point.map(|x| x as f64 / 8.0),
            world_from_model: Matrix::affine(rows).expect("affine"),
            camera: Camera::new(from, to, upwards, volume).expect("a camera"),
            viewport: viewport(size),
        };
        let output = through(&input);

        // In parts of 1/4096: a product of quarters and eighths is 128 of them.
        let world: [i128; 3] = std::array::from_fn(|i| {
            let products: i64 = (0..3).map(|j| model[i][j] * point[j]).sum();
            i128::from(products) * 128 + i128::from(model[i][3]) * 1024
        });
        prop_assert_eq!(output.world.map(parts), world);
        let beside: [i128; 3] = std::array::from_fn(|i| world[i] - i128::from(position[i]) * 4096);
        let axes = [cross(unit(up), unit(back)), unit(up), unit(back)];
        let view = axes.map(|axis| dot(axis, beside));
        prop_assert_eq!(output.view.map(parts), view);
        let wide = if aspect > 1.0 { [1, 2] } else { [(1.0 / aspect) as i128, 1] };
        let clip = [
            view[0] * wide[0] / wide[1],
            view[1],
            -(view[2] * by_hand[0]) / 4 - by_hand[1] * 1024,
            -view[2],
        ];
        prop_assert_eq!(view[0] * wide[0] % wide[1], 0);
        prop_assert_eq!(output.clip.map(parts), clip);
        let [x, y, z, w] = clip;
        prop_assert_eq!(output.inside, [x, y, z].iter().all(|c| c.abs() <= w));
        prop_assert_eq!(output.ndc, (w > 0).then(|| [x, y, z].map(|c| c as f64 / w as f64)));
        prop_assert_eq!(output.screen.is_some(), w > 0);
        if let (Some([column, row]), true) = (output.screen, w > 0) {
            let [width, height] = size.map(f64::from);
            let column_by_hand = (x + w) as f64 * width / (2 * w) as f64;
            let row_by_hand = (w - y) as f64 * height / (2 * w) as f64;
            prop_assert!((column - column_by_hand).abs() <= 1e-12 * width * (1.0 + (x as f64 / w as f64).abs()));
            prop_assert!((row - row_by_hand).abs() <= 1e-12 * height * (1.0 + (y as f64 / w as f64).abs()));
        }
    }

    /// All planes and cameras: what is inside lies on the picture, and the laws hold.
    #[test]
    fn what_is_inside_is_on_the_picture(
        point in prop::array::uniform3(-6.0..6.0_f64),
        position in prop::array::uniform3(-9.0..9.0_f64),
        fov in 1.0..179.0_f64,
        is_parallel in any::<bool>(),
    ) {
        let volume = if is_parallel {
            ViewVolume::parallel(fov / 10.0, 1.5, -1.0, 30.0)
        } else {
            ViewVolume::perspective(fov, 1.5, 0.5, 30.0)
        };
        let Ok(camera) = Camera::new(position, [0.0; 3], [0.0, 1.0, 0.0], volume.expect("a volume")) else {
            return Ok(());
        };
        let viewport = viewport([640, 480]);
        let output = through(&ViewingPipelineInput {
            point,
            world_from_model: Matrix::IDENTITY,
            camera,
            viewport,
        });
        prop_assert_eq!(output.world, point);
        prop_assert_eq!(output.view, camera.view_from_world().point(point), "the same matrices, bit for bit");
        prop_assert_eq!(output.screen.is_some(), output.clip[3] > 0.0);
        if output.inside {
            let [x, y] = output.screen.expect("before the eye");
            prop_assert!((0.0..=640.0).contains(&x) && (0.0..=480.0).contains(&y), "{:?}", output.screen);
        }
        if is_parallel {
            prop_assert_eq!(output.clip[3], 1.0);
        }
    }
}

/// A camera that looks slantwise, with every matrix written down from its definition.
#[test]
fn matrices_written_by_hand() {
    let volume = ViewVolume::perspective(60.0, 1.5, 1.0, 9.0).expect("a volume");
    let camera = Camera::new([3.0, 4.0, 12.0], [0.0; 3], [0.0, 1.0, 0.0], volume);
    let (sin, cos) = (0.6, 0.8);
    let turned = [
        [2.0 * cos, 0.0, 2.0 * sin, 1.0],
        [0.0, 2.0, 0.0, -1.0],
        [-2.0 * sin, 0.0, 2.0 * cos, 0.5],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let input = ViewingPipelineInput {
        point: [1.0, 0.5, -1.0],
        world_from_model: Matrix::affine(turned).expect("affine"),
        camera: camera.expect("a camera"),
        viewport: viewport([300, 200]),
    };
    // |(3, 4, 12)| = 13; to the right is (12, 0, −3) / √153, upwards what is left.
    let root = f64::sqrt(153.0);
    let by_hand = [
        [12.0 / root, 0.0, -3.0 / root, 0.0],
        [
            -12.0 / (13.0 * root),
            153.0 / (13.0 * root),
            -48.0 / (13.0 * root),
            0.0,
        ],
        [3.0 / 13.0, 4.0 / 13.0, 12.0 / 13.0, -13.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    close(
        input.matrix(PipelineSpace::View).rows().as_flattened(),
        by_hand.as_flattened(),
    );
    let root = f64::sqrt(3.0);
    let by_hand = [
        [root / 1.5, 0.0, 0.0, 0.0],
        [0.0, root, 0.0, 0.0],
        [0.0, 0.0, -1.25, -2.25],
        [0.0, 0.0, -1.0, 0.0],
    ];
    close(
        input.matrix(PipelineSpace::Clip).rows().as_flattened(),
        by_hand.as_flattened(),
    );
    let output = through(&input);
    // 1.6 − 1.2 + 1, 1 − 1, −1.2 − 1.6 + 0.5.
    close(&output.world, &[1.4, 0.0, -2.3]);
    let z = (3.0 * 1.4 - 12.0 * 2.3) / 13.0 - 13.0;
    assert!((output.clip[3] + z).abs() < 1e-12);
    close(
        &output.ndc.expect("before the eye")[2..],
        &[(-1.25 * z - 2.25) / -z],
    );
}

/// What has no size any more has still a place.
#[test]
fn a_singular_model_puts_every_vertex_in_one_place() {
    let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 3.0).expect("a volume");
    let camera = Camera::new([0.0, 0.0, 2.0], [0.0; 3], [0.0, 1.0, 0.0], volume);
    let mut rows = [[0.0; 4]; 4];
    rows[3][3] = 1.0;
    for point in [[0.0; 3], [7.0, -2.0, 1e300]] {
        let output = through(&ViewingPipelineInput {
            point,
            world_from_model: Matrix::affine(rows).expect("affine"),
            camera: camera.expect("a camera"),
            viewport: viewport([8, 4]),
        });
        assert_eq!((output.world, output.screen), ([0.0; 3], Some([4.0, 2.0])));
    }
}

fn close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-12, "{found:?}, expected {expected:?}");
    }
}
