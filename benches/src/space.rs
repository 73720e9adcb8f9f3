//! Culling spheres and filling triangles, against crates that do the same.

use std::hint::black_box;

use clipscope::{
    algo::{
        cull::SphereBatch,
        surface::{Cull, MeshRef, Viewport, assemble, shade_rows},
    },
    geom::{Camera, Matrix, Sphere, ViewVolume},
};
use treeculler::{BVol, BoundingSphere, Frustum};

use crate::harness::{Contender, Target, race};

const N_SPHERES: usize = 1_000_000;
const N_ROUNDS: usize = 15;

/// The same numbers at every run.
pub struct Lot(pub u64);

impl Lot {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (self.0 >> 40) as f64 / f64::from(1 << 24)
    }
}

pub fn run() {
    spheres();
    meshes();
}

fn spheres() {
    let volume = ViewVolume::perspective(60.0, 16.0 / 9.0, 0.1, 100.0).expect("a volume");
    let camera =
        Camera::new([0.0, 2.0, 10.0], [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
    let mut lot = Lot(1);
    let (mut batch, mut theirs) = (SphereBatch::default(), Vec::with_capacity(N_SPHERES));
    for _ in 0..N_SPHERES {
        let at = [lot.next(), lot.next(), lot.next()].map(|x| 200.0 * x - 100.0);
        let radius = 0.1 + 2.0 * lot.next();
        batch.push(&Sphere::new([at[0], at[1], at[2], radius]).expect("a sphere"));
        theirs.push(BoundingSphere::new(at.map(|x| x as f32), radius as f32));
    }
    let planes = camera.planes_in_world();
    let rows = camera.clip_from_world().rows();
    // Column by column.
    let columns = std::array::from_fn(|j| std::array::from_fn(|i| rows[i][j] as f32));
    let frustum = Frustum::from_modelview_projection(columns);
    let mut kept = Vec::with_capacity(N_SPHERES);
    batch.keep(&planes, &mut kept);
    let n_kept = kept.iter().filter(|&&kept| kept).count();
    let n_theirs = theirs
        .iter()
        .filter(|sphere| sphere.test_against_frustum(&frustum, 0) != u8::MAX)
        .count();
    println!(
        "## Spheres\n\n{N_SPHERES} bounding spheres against six planes; kept: {n_kept}, by treeculler, which asks the frustum's corners too, {n_theirs}.\n"
    );
    let mut seen = vec![false; N_SPHERES];
    let results = race(
        N_ROUNDS,
        vec![
            Contender::new("clipscope", || batch.keep(black_box(&planes), &mut kept)),
            Contender::new("treeculler", || {
                for (seen, sphere) in seen.iter_mut().zip(&theirs) {
                    *seen = sphere.test_against_frustum(black_box(&frustum), 0) != u8::MAX;
                }
            }),
        ],
    );
    table(
        &results,
        &["clipscope", "treeculler"],
        "treeculler",
        &[("clipscope", Target::AtMost(0.12))],
    );
}

pub fn table(
    results: &crate::harness::Results,
    names: &[&str],
    base: &str,
    targets: &[(&str, Target)],
) {
    println!("| | ms | over {base} | target | |\n|---|---|---|---|---|");
    for name in names {
        let ratio = results.ratio(name, base);
        let target = targets.iter().find(|(wanted, _)| wanted == name);
        let target = target.map_or(Target::None, |&(_, target)| target);
        println!(
            "| {name} | {:.3} | {ratio:.3} | {} |",
            1e3 * results.secs(name),
            target.cells(ratio)
        );
    }
    println!();
}

/// Positions, colours, faces.
pub type Waves = (Vec<[f32; 3]>, Vec<[f32; 3]>, Vec<[u32; 3]>);

/// A sphere of triangles with waves on it, in view; about as many triangles as asked for.
pub fn waves(n_triangles: usize) -> Waves {
    let rows = ((n_triangles as f64 / 4.0).sqrt()) as u32;
    let columns = 2 * rows;
    let (mut positions, mut colours, mut faces) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..=rows {
        for j in 0..columns {
            let (theta, phi) = (
                std::f32::consts::PI * i as f32 / rows as f32,
                std::f32::consts::TAU * j as f32 / columns as f32,
            );
            let r = 1.0 + 0.1 * (6.0 * theta).sin() * (5.0 * phi).cos();
            let at = [
                r * theta.sin() * phi.cos(),
                r * theta.cos(),
                r * theta.sin() * phi.sin(),
            ];
            positions.push(at);
            colours.push(at.map(|x| 0.5 + 0.4 * x));
            if i < rows {
                let (a, b) = (i * columns + j, i * columns + (j + 1) % columns);
                let (c, d) = (a + columns, b + columns);
                faces.push([a, b, d]);
                faces.push([a, d, c]);
            }
        }
    }
    (positions, colours, faces)
}

const SIZE: [u32; 2] = [1280, 720];

fn meshes() {
    for n in [15_500, 100_000] {
        let (positions, colours, faces) = waves(n);
        fill(&positions, &colours, &faces);
    }
}

fn fill(positions: &[[f32; 3]], colours: &[[f32; 3]], faces: &[[u32; 3]]) {
    let volume = ViewVolume::perspective(60.0, 16.0 / 9.0, 0.1, 100.0).expect("a volume");
    let camera = Camera::new([0.3, 0.4, 2.4], [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
    let clip_from_world = camera.clip_from_world();
    let viewport = Viewport::new(SIZE, Viewport::PICTURE_BITS).expect("a picture");
    let n_pixels = (SIZE[0] * SIZE[1]) as usize;

    let (mut depths, mut pixels) = (vec![0.0_f32; n_pixels], vec![0_u32; n_pixels]);
    let mut triangles = Vec::new();
    let mut n_drawn = 0;
    let mut ours = || {
        triangles.clear();
        let mesh = MeshRef {
            positions,
            attributes: colours,
            faces,
            first_id: 0,
        };
        assemble(
            &mesh,
            black_box(&clip_from_world),
            &viewport,
            Cull::Clockwise,
            &mut triangles,
        );
        shade_rows(
            &triangles,
            &viewport,
            0..SIZE[1],
            (&mut depths, &mut pixels),
            0,
            |_, &[r, g, b]| std::array::from_fn(|i| packed([r[i], g[i], b[i]])),
        );
        n_drawn = pixels.iter().filter(|&&pixel| pixel != 0).count();
    };
    ours();
    let mut theirs = retrofire::Peer::new(positions, colours, faces, &clip_from_world);
    theirs.draw();
    let n_theirs = theirs.n_drawn();
    let mut euc = euc_peer::Peer::new(positions, colours, faces, &clip_from_world);
    euc.draw();
    let n_euc = euc.n_drawn();
    let results = race(
        N_ROUNDS,
        vec![
            Contender::new("clipscope", ours),
            Contender::new("retrofire-core", || theirs.draw()),
            Contender::new("euc", || euc.draw()),
        ],
    );
    println!(
        "## Depth buffer\n\n{} vertices, {} triangles, three attributes, 1280×720, back faces culled, one thread. Pixels: {n_drawn}, retrofire-core {n_theirs}, euc {n_euc}.\n",
        positions.len(),
        faces.len()
    );
    let names = ["clipscope", "retrofire-core", "euc"];
    table(
        &results,
        &names,
        "retrofire-core",
        &[("clipscope", Target::AtMost(0.6))],
    );
    table(
        &results,
        &names,
        "euc",
        &[("clipscope", Target::AtMost(0.28))],
    );
}

/// Floats from 2²³ on hold whole numbers in their last bits: the nearest is packed, and nothing cast.
fn packed(colour: [f32; 3]) -> u32 {
    let [r, g, b] = colour.map(|x| (255.0 * x + 8_388_608.0).to_bits() & 0xff);
    0xff00_0000 | r << 16 | g << 8 | b
}

/// One row of a matrix after the other, as f32.
pub fn narrow(matrix: &Matrix) -> [[f32; 4]; 4] {
    matrix.rows().map(|row| row.map(|x| x as f32))
}

mod retrofire {
    use clipscope::geom::Matrix;
    use retrofire_core::{
        geom::{Tri, Vertex3, vertex},
        math::{Color3f, ProjMat3, pt2, pt3, rgb, viewport},
        render::{Colorbuf, Context, Frag, Framebuf, Model, render, shader},
        util::{Buf2, Dims, pixfmt::Argb8888},
    };

    use super::{SIZE, narrow};

    pub struct Peer {
        vertices: Vec<Vertex3<Color3f>>,
        faces: Vec<Tri<usize>>,
        clip_from_world: ProjMat3<Model>,
        pixels: Buf2<u32>,
        depths: Buf2<f32>,
    }

    impl Peer {
        pub fn new(
            positions: &[[f32; 3]],
            colours: &[[f32; 3]],
            faces: &[[u32; 3]],
            clip_from_world: &Matrix,
        ) -> Self {
            let vertices = positions.iter().zip(colours);
            let dims = Dims(SIZE[0], SIZE[1]);
            Self {
                vertices: vertices
                    .map(|(&[x, y, z], &[r, g, b])| vertex(pt3(x, y, z), rgb(r, g, b)))
                    .collect(),
                faces: faces
                    .iter()
                    .map(|face| Tri(face.map(|i| i as usize)))
                    .collect(),
                clip_from_world: ProjMat3::new(narrow(clip_from_world)),
                pixels: Buf2::new(dims),
                depths: Buf2::new(dims),
            }
        }

        pub fn draw(&mut self) {
            self.pixels.fill(0);
            // It keeps 1/w: the larger, the nearer.
            self.depths.fill(0.0);
            let shader = shader::new(
                |v: Vertex3<Color3f>, clip_from_world: &ProjMat3<Model>| {
                    vertex(clip_from_world.apply(&v.pos), v.attrib)
                },
                |frag: Frag<Color3f<_>>, _: &ProjMat3<Model>| frag.var.to_color4(),
            );
            let mut target = Framebuf {
                color_buf: Colorbuf::<_, Argb8888>::new(&mut self.pixels),
                depth_buf: &mut self.depths,
            };
            render(
                &self.faces,
                &self.vertices,
                &shader,
                &self.clip_from_world,
                viewport(pt2(0, 0)..pt2(SIZE[0], SIZE[1])),
                &mut target,
                &Context::default(),
            );
        }

        pub fn n_drawn(&self) -> usize {
            self.pixels
                .data()
                .iter()
                .filter(|&&pixel| pixel != 0)
                .count()
        }
    }
}

mod euc_peer {
    use clipscope::geom::Matrix;
    use euc::{Pipeline, buffer::Buffer2d, rasterizer::Triangles};
    use vek::{Mat4, Vec3, Vec4};

    use super::{SIZE, narrow, packed};

    struct Painting<'a> {
        clip_from_world: Mat4<f32>,
        positions: &'a [[f32; 3]],
        colours: &'a [[f32; 3]],
    }

    impl Pipeline for Painting<'_> {
        type Vertex = u32;
        type VsOut = Vec3<f32>;
        type Pixel = u32;

        fn vert(&self, i: &u32) -> ([f32; 4], Vec3<f32>) {
            let i = *i as usize;
            let [x, y, z] = self.positions[i];
            let clip = self.clip_from_world * Vec4::new(x, y, z, 1.0);
            (clip.into_array(), self.colours[i].into())
        }

        fn frag(&self, colour: &Vec3<f32>) -> u32 {
            packed(colour.into_array())
        }
    }

    pub struct Peer<'a> {
        pipeline: Painting<'a>,
        corners: Vec<u32>,
        pixels: Buffer2d<u32>,
        depths: Buffer2d<f32>,
    }

    impl<'a> Peer<'a> {
        pub fn new(
            positions: &'a [[f32; 3]],
            colours: &'a [[f32; 3]],
            faces: &[[u32; 3]],
            clip_from_world: &Matrix,
        ) -> Self {
            let size = SIZE.map(|side| side as usize);
            Self {
                pipeline: Painting {
                    clip_from_world: Mat4::from_row_arrays(narrow(clip_from_world)),
                    positions,
                    colours,
                },
                corners: faces.as_flattened().to_vec(),
                pixels: Buffer2d::new(size, 0),
                depths: Buffer2d::new(size, 1.0),
            }
        }

        pub fn draw(&mut self) {
            use euc::Target;
            self.pixels.clear(0);
            self.depths.clear(1.0);
            let depths = Some(&mut self.depths);
            self.pipeline
                .draw::<Triangles<_>, _>(&self.corners, &mut self.pixels, depths);
        }

        pub fn n_drawn(&self) -> usize {
            self.pixels
                .as_ref()
                .iter()
                .filter(|&&pixel| pixel != 0)
                .count()
        }
    }
}
