//! Filling triangles with a texture, and S3's case whole.

use std::hint::black_box;

use clipscope::{
    algo::surface::{Cull, MeshRef, Viewport, assemble, shade_rows},
    geom::{Camera, Matrix, Texture, ViewVolume},
};

use crate::{
    harness::{Contender, Target, race},
    space::{narrow, table, waves},
};

const N_ROUNDS: usize = 15;
/// Frames a second of the tutorial's mesh of 7,750 vertices, with its clipping.
const TUTORIAL_FPS: f64 = 25.0;

/// A mesh with texture coordinates, and what it is seen through.
struct Painted {
    positions: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    faces: Vec<[u32; 3]>,
    texture: Texture,
    clip_from_world: Matrix,
    size: [u32; 2],
}

impl Painted {
    fn new(n_triangles: usize, size: [u32; 2], position: [f64; 3]) -> Self {
        let (positions, _, faces) = waves(n_triangles);
        let aspect = f64::from(size[0]) / f64::from(size[1]);
        let volume = ViewVolume::perspective(60.0, aspect, 0.1, 100.0).expect("a volume");
        let camera = Camera::new(position, [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
        let uv = |&[x, y, z]: &[f32; 3]| [0.5 + 0.49 * x.atan2(z) / 3.2, 0.5 + 0.4 * y];
        let texel = |i: usize| {
            let is_dark = (i / 16 + i / SIDE / 16).is_multiple_of(2);
            if is_dark {
                [60, 90, 120]
            } else {
                [230, 220, 200]
            }
        };
        let texels: Vec<[u8; 3]> = (0..SIDE * SIDE).map(texel).collect();
        Self {
            uvs: positions.iter().map(uv).collect(),
            positions,
            faces,
            texture: Texture::new([SIDE; 2], texels).expect("as many as there are places"),
            clip_from_world: camera.clip_from_world(),
            size,
        }
    }

    /// Draws it into these pixels, again and again.
    fn ours(&self, pixels: &mut [u32]) -> impl FnMut() {
        let viewport = Viewport::new(self.size, Viewport::PICTURE_BITS).expect("a picture");
        let mut depths = vec![0.0_f32; pixels.len()];
        let mut triangles = Vec::new();
        move || {
            triangles.clear();
            let mesh = MeshRef {
                positions: &self.positions,
                attributes: &self.uvs,
                faces: &self.faces,
                first_id: 0,
            };
            let matrix = black_box(&self.clip_from_world);
            assemble(&mesh, matrix, &viewport, Cull::Clockwise, &mut triangles);
            let rows = 0..self.size[1];
            let target = (&mut depths[..], &mut *pixels);
            shade_rows(&triangles, &viewport, rows, target, 0, |_, uv| {
                self.texture.at_each(uv).map(|texel| 0xff00_0000 | texel)
            });
            black_box(&*pixels);
        }
    }

    /// A clear picture of its size.
    fn clear(&self) -> Vec<u32> {
        vec![0; (self.size[0] * self.size[1]) as usize]
    }
}

fn n_drawn(pixels: &[u32]) -> usize {
    pixels.iter().filter(|&&pixel| pixel != 0).count()
}

/// Texels in a row, and rows.
const SIDE: usize = 1024;

pub fn run() {
    for (n, target) in [(15_500, 0.45), (100_000, 0.35)] {
        against_retrofire(n, target);
    }
    tutorial();
}

fn against_retrofire(n_triangles: usize, target: f64) {
    let painted = Painted::new(n_triangles, [1280, 720], [0.3, 0.4, 2.4]);
    let mut theirs = retrofire::Peer::new(&painted);
    let mut pixels = painted.clear();
    painted.ours(&mut pixels)();
    theirs.draw();
    let (n_ours, n_theirs) = (n_drawn(&pixels), n_drawn(theirs.pixels.data()));
    println!(
        "## Textured\n\n{} vertices, {} triangles, a texture of {SIDE} × {SIDE}, nearest texel, 1280×720, back faces culled, one thread. Pixels: {n_ours}, retrofire-core {n_theirs}.\n",
        painted.positions.len(),
        painted.faces.len()
    );
    let results = race(
        N_ROUNDS,
        vec![
            Contender::new("clipscope", painted.ours(&mut pixels)),
            Contender::new("retrofire-core", || {
                theirs.draw();
                black_box(theirs.pixels.data());
            }),
        ],
    );
    table(
        &results,
        &["clipscope", "retrofire-core"],
        "retrofire-core",
        &[("clipscope", Target::AtMost(target))],
    );
}

/// 965×655, 7,750 vertices: transformed, culled, clipped (the camera stands so near that the picture's border cuts), textured.
fn tutorial() {
    let painted = Painted::new(15_500, [965, 655], [0.2, 0.3, 1.5]);
    let mut pixels = painted.clear();
    painted.ours(&mut pixels)();
    let n_pixels = n_drawn(&pixels);
    let ours = painted.ours(&mut pixels);
    let results = race(N_ROUNDS, vec![Contender::new("clipscope", ours)]);
    let fps = 1.0 / results.secs("clipscope");
    println!(
        "## S3's case\n\n{} vertices, {} triangles, 965×655, transform, cull, clip, texture, one thread; {n_pixels} pixels. {fps:.0} frames a second, {:.1} times the tutorial's {TUTORIAL_FPS} (at least 10 wanted).\n",
        painted.positions.len(),
        painted.faces.len(),
        fps / TUTORIAL_FPS
    );
}

mod retrofire {
    use retrofire_core::{
        geom::{Tri, Vertex3, vertex},
        math::{Color3, ProjMat3, pt2, pt3, rgb, viewport},
        render::{
            Colorbuf, Context, Frag, Framebuf, Model, render, shader,
            tex::{SamplerRepeatPot, TexCoord, Texture, uv},
        },
        util::{Buf2, Dims, pixfmt::Argb8888},
    };

    use super::{Painted, SIDE, narrow};

    pub struct Peer {
        vertices: Vec<Vertex3<TexCoord>>,
        faces: Vec<Tri<usize>>,
        clip_from_world: ProjMat3<Model>,
        texture: Texture<Buf2<Color3>>,
        pub pixels: Buf2<u32>,
        depths: Buf2<f32>,
        size: [u32; 2],
    }

    impl Peer {
        pub fn new(painted: &Painted) -> Self {
            let vertices = painted.positions.iter().zip(&painted.uvs);
            let vertices =
                vertices.map(|(&[x, y, z], &[u, v])| vertex(pt3(x, y, z), uv(u, 1.0 - v)));
            let dims = Dims(painted.size[0], painted.size[1]);
            let middle = |i: u32| (i as f32 + 0.5) / SIDE as f32;
            let texel = |column: u32, row: u32| {
                let [r, g, b] = painted.texture.at([middle(column), 1.0 - middle(row)]);
                rgb(r, g, b)
            };
            let side = SIDE as u32;
            Self {
                vertices: vertices.collect(),
                faces: painted
                    .faces
                    .iter()
                    .map(|face| Tri(face.map(|i| i as usize)))
                    .collect(),
                clip_from_world: ProjMat3::new(narrow(&painted.clip_from_world)),
                texture: Buf2::new_with(Dims(side, side), texel).into(),
                pixels: Buf2::new(dims),
                depths: Buf2::new(dims),
                size: painted.size,
            }
        }

        pub fn draw(&mut self) {
            self.pixels.fill(0);
            self.depths.fill(0.0);
            let (texture, sampler) = (&self.texture, SamplerRepeatPot::new(&self.texture));
            let shader = shader::new(
                |v: Vertex3<TexCoord>, clip_from_world: &ProjMat3<Model>| {
                    vertex(clip_from_world.apply(&v.pos), v.attrib)
                },
                |frag: Frag<TexCoord>, _: &ProjMat3<Model>| {
                    sampler.sample(texture, frag.var).to_rgba()
                },
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
                viewport(pt2(0, 0)..pt2(self.size[0], self.size[1])),
                &mut target,
                &Context::default(),
            );
        }
    }
}
