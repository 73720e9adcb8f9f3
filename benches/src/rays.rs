//! Ray casting with boxes around boxes, without, and by a crate that does nothing else.

use std::{
    hint::black_box,
    path::Path,
    time::{Duration, Instant},
};

use clipscope::{
    algo::surface::{
        Hierarchy, Ray, RayCasting, RayCastingInput, RayCastingOutput, Rays, Surfaces,
    },
    geom::{Camera, ViewVolume},
    lesson::read_obj,
    trace::silent,
};
use obvhs::{
    BvhBuildParams,
    bvh2::{Bvh2, builder::build_bvh2_from_tris},
    cwbvh::{CwBvh, builder::build_cwbvh_from_tris},
    ray::{Ray as TheirRay, RayHit as TheirHit},
    rt_triangle::RtTriangle,
    triangle::Triangle,
};

use crate::{
    harness::{Contender, Target, median, race},
    plot,
    space::{table, waves},
};

const SIZE: [u32; 2] = [640, 480];
/// Of the rays that ask every triangle, where there are many triangles.
const FEW: [u32; 2] = [32, 24];
/// Of more triangles not every one is asked.
const MOST_ASKED: usize = 30_000;
const N_ROUNDS: usize = 9;
const GROWTH: [usize; 6] = [1_000, 3_000, 10_000, 30_000, 100_000, 300_000];

/// A mesh in front of the camera.
fn surfaces(size: [u32; 2], position: [f64; 3], triangles: &[[[f64; 3]; 3]]) -> Surfaces {
    let volume = ViewVolume::perspective(40.0, 4.0 / 3.0, 0.5, 20.0).expect("a volume");
    let camera = Camera::new(position, [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
    let view_from_world = camera.view_from_world();
    let seen = |triangle: &[[f64; 3]; 3]| triangle.map(|at| view_from_world.point(at));
    let triangles: Vec<_> = triangles.iter().map(seen).collect();
    Surfaces::new(size, volume, triangles, false).expect("numbers")
}

/// obvhs' trees over the same triangles.
struct Peer {
    two: Bvh2,
    two_triangles: Vec<RtTriangle>,
    wide: CwBvh,
    wide_triangles: Vec<RtTriangle>,
}

impl Peer {
    fn new(surfaces: &Surfaces) -> Self {
        let given: Vec<Triangle> = surfaces
            .triangles()
            .iter()
            .map(|triangle| {
                let [v0, v1, v2] = triangle.map(|at| at.map(|x| x as f32).into());
                Triangle { v0, v1, v2 }
            })
            .collect();
        let (params, mut took) = (BvhBuildParams::medium_build(), Duration::default());
        let two = build_bvh2_from_tris(&given, params, &mut took);
        let wide = build_cwbvh_from_tris(&given, params, &mut took);
        // In the order of the leaves, as the crate's examples have them.
        let sorted = |ids: &[u32]| ids.iter().map(|&i| (&given[i as usize]).into()).collect();
        Self {
            two_triangles: sorted(&two.primitive_indices),
            wide_triangles: sorted(&wide.primitive_indices),
            two,
            wide,
        }
    }

    fn two(&self, rays: &[TheirRay]) -> usize {
        let hits = rays.iter().filter(|ray| {
            let ray = TheirRay::new_inf(ray.origin, ray.direction);
            let mut hit = TheirHit::none();
            self.two
                .ray_traverse(ray, &mut hit, |ray, i| self.two_triangles[i].intersect(ray))
        });
        hits.count()
    }

    fn wide(&self, rays: &[TheirRay]) -> usize {
        let hits = rays.iter().filter(|ray| {
            let ray = TheirRay::new_inf(ray.origin, ray.direction);
            let mut hit = TheirHit::none();
            self.wide.ray_traverse(ray, &mut hit, |ray, i| {
                self.wide_triangles[i].intersect(ray)
            })
        });
        hits.count()
    }
}

/// The rays of every pixel, here and there.
fn all_rays(surfaces: &Surfaces) -> (Rays, Vec<Ray>, Vec<TheirRay>) {
    let rays = Rays::of(surfaces);
    let [width, height] = surfaces.size();
    let pixels = (0..height).flat_map(|row| (0..width).map(move |column| [column, row]));
    let ours: Vec<Ray> = pixels.map(|pixel| rays.through(pixel)).collect();
    let theirs = ours.iter().map(|ray| {
        let [origin, direction] = [ray.origin, ray.direction].map(|v| v.map(|x| x as f32).into());
        TheirRay::new_inf(origin, direction)
    });
    let theirs = theirs.collect();
    (rays, ours, theirs)
}

fn n_hits(hierarchy: &Hierarchy, surfaces: &Surfaces, rays: &Rays, ours: &[Ray]) -> usize {
    let hits = ours
        .iter()
        .filter(|ray| hierarchy.cast(surfaces, rays, ray).0.is_some());
    hits.count()
}

fn whole(surfaces: &Surfaces) -> RayCastingOutput {
    silent::<RayCasting>(&RayCastingInput {
        surfaces: surfaces.clone(),
        pixel: None,
    })
}

/// Spot: every triangle asked, boxes around boxes, and the peer.
pub fn spot() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/meshes/spot/spot.obj");
    let bytes = std::fs::read(path).expect("the mesh is in the repository");
    let mesh = read_obj("spot.obj", &bytes).expect("a mesh").mesh.fitted();
    let triangles: Vec<_> = mesh
        .faces()
        .iter()
        .map(|&face| mesh.corners(face))
        .collect();
    let surfaces = surfaces(SIZE, [1.5, 1.0, -2.5], &triangles);
    let (rays, ours, theirs) = all_rays(&surfaces);
    let hierarchy = Hierarchy::new(&surfaces);
    let start = Instant::now();
    let without = whole(&surfaces);
    let secs_without = start.elapsed().as_secs_f64();
    let with = hierarchy.picture(&surfaces);
    assert!(
        with.picture == without.picture && with.depth == without.depth,
        "the same picture"
    );
    let peer = Peer::new(&surfaces);
    let found = [
        n_hits(&hierarchy, &surfaces, &rays, &ours),
        peer.two(&theirs),
        peer.wide(&theirs),
    ];
    let results = race(
        N_ROUNDS,
        vec![
            Contender::new("the picture with `Hierarchy`", || {
                black_box(hierarchy.picture(&surfaces));
            }),
            Contender::new("`Hierarchy::cast`", || {
                black_box(n_hits(&hierarchy, &surfaces, &rays, &ours));
            }),
            Contender::new("obvhs 0.4, two by two", || {
                black_box(peer.two(&theirs));
            }),
            Contender::new("obvhs 0.4, eight wide", || {
                black_box(peer.wide(&theirs));
            }),
        ],
    );
    let secs_with = results.secs("the picture with `Hierarchy`");
    let times = secs_without / secs_with;
    println!(
        "## Rays\n\nSpot, {} triangles, {} × {} rays, one thread. Every triangle asked: {secs_without:.2} s, {} questions; with boxes around boxes {secs_with:.3} s, {} questions, the same picture and depths: {times:.0} times as fast (at least 20 wanted: {}). The same rays by obvhs; hits {found:?}. There in f32, here in f64 with exact edges.\n",
        triangles.len(),
        SIZE[0],
        SIZE[1],
        without.n_asked,
        with.n_asked,
        if times >= 20.0 { "met" } else { "missed" },
    );
    table(
        &results,
        &[
            "the picture with `Hierarchy`",
            "`Hierarchy::cast`",
            "obvhs 0.4, two by two",
            "obvhs 0.4, eight wide",
        ],
        "obvhs 0.4, two by two",
        &[("`Hierarchy::cast`", Target::AtMost(1.05))],
    );
}

/// What a ray takes, by the number of triangles.
pub fn growth() {
    println!(
        "## Rays by the number of triangles\n\nA sphere with waves, {} × {} rays; every triangle asked at {} × {}.\n",
        SIZE[0], SIZE[1], FEW[0], FEW[1]
    );
    println!(
        "| triangles | boxes built, ms | questions a ray | ns a ray | obvhs, two by two | every triangle asked |\n|--:|--:|--:|--:|--:|--:|"
    );
    let mut curves = [Vec::new(), Vec::new(), Vec::new()];
    let mut sizes = Vec::new();
    for n in GROWTH {
        let (positions, _, faces) = waves(n);
        let corner = |i: u32| positions[i as usize].map(f64::from);
        let triangles: Vec<_> = faces.iter().map(|face| face.map(corner)).collect();
        let position = [0.3, 0.4, 3.4];
        let all = surfaces(SIZE, position, &triangles);
        let (rays, ours, theirs) = all_rays(&all);
        let start = Instant::now();
        let hierarchy = Hierarchy::new(&all);
        let build = 1e3 * start.elapsed().as_secs_f64();
        let peer = Peer::new(&all);
        let nanos = |work: &mut dyn FnMut() -> usize| {
            let secs = (0..5).map(|_| {
                let start = Instant::now();
                black_box(work());
                start.elapsed().as_secs_f64()
            });
            1e9 * median(secs.collect::<Vec<_>>()) / ours.len() as f64
        };
        let own = nanos(&mut || n_hits(&hierarchy, &all, &rays, &ours));
        let other = nanos(&mut || peer.two(&theirs));
        let n_asked = hierarchy.picture(&all).n_asked as f64 / ours.len() as f64;
        let every = (n <= MOST_ASKED).then(|| {
            let few = surfaces(FEW, position, &triangles);
            let start = Instant::now();
            black_box(whole(&few));
            1e9 * start.elapsed().as_secs_f64() / few.n_pixels() as f64
        });
        sizes.push(triangles.len() as f64);
        for (curve, nanos) in curves.iter_mut().zip([every, Some(own), Some(other)]) {
            curve.extend(nanos.map(|nanos| nanos / 1e3));
        }
        let every = every.map_or(String::new(), |nanos| format!("{nanos:.0}"));
        println!(
            "| {} | {build:.1} | {n_asked:.1} | {own:.0} | {other:.0} | {every} |",
            triangles.len()
        );
    }
    let names = [
        "every triangle asked",
        "boxes around boxes",
        "obvhs, two by two",
    ];
    let panel = plot::Panel {
        title: "A ray",
        of: "triangles",
        curves: names.into_iter().zip(curves).collect(),
    };
    plot::save("rays.svg", &sizes, &[panel]);
}
