//! Which pixels, and exactly which colour.

use egui::epaint::{ColorImage, ImageDelta, Mesh, textures::TextureOptions};
use egui::{Pos2, pos2};

use super::*;

const SIZE: [usize; 2] = [32, 24];
/// Not 0, which is egui's font atlas.
const TEXTURE: TextureId = TextureId::Managed(1);
const LINEAR: TextureOptions = TextureOptions::LINEAR;
const NEAREST: TextureOptions = TextureOptions::NEAREST;
const EVERYWHERE: [Pos2; 3] = [pos2(-99., -99.), pos2(300., -99.), pos2(-99., 300.)];
/// Adds 1 to red and hides nothing.
const ONE: Color32 = Color32::from_rgba_premultiplied(1, 0, 0, 0);

fn painter_with(id: TextureId, image: ColorImage, options: TextureOptions) -> CpuPainter {
    let mut painter = CpuPainter::default();
    let mut delta = TexturesDelta::default();
    delta.push(id, ImageDelta::full(image, options));
    painter.apply(&mut delta);
    assert!(delta.is_empty());
    painter
}

fn white_painter() -> CpuPainter {
    let texel = ColorImage::filled([1, 1], Color32::WHITE);
    painter_with(TEXTURE, texel, LINEAR)
}

fn vertex(pos: Pos2, uv: Pos2, color: Color32) -> Vertex {
    Vertex { pos, uv, color }
}

fn mesh(corners: &[Pos2], indices: &[u32], color: Color32) -> Mesh {
    let mut mesh = Mesh::with_texture(TEXTURE);
    let vertices = corners.iter().map(|&at| vertex(at, Pos2::ZERO, color));
    mesh.vertices = vertices.collect();
    mesh.indices = indices.to_vec();
    mesh
}

fn rect(left: f32, top: f32, right: f32, bottom: f32) -> Rect {
    Rect::from_min_max(pos2(left, top), pos2(right, bottom))
}

fn textured(rect: Rect) -> Mesh {
    let mut mesh = Mesh::with_texture(TEXTURE);
    let uv = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
    mesh.add_rect_with_uv(rect, uv, Color32::WHITE);
    mesh
}

fn paint_clipped(painter: &CpuPainter, mesh: Mesh, clip_rect: Rect, ground: Color32) -> Image {
    let primitive = ClippedPrimitive {
        clip_rect,
        primitive: Primitive::Mesh(mesh),
    };
    painter.paint(&[primitive], 1.0, SIZE, ground)
}

fn paint(painter: &CpuPainter, mesh: Mesh, ground: Color32) -> Image {
    paint_clipped(painter, mesh, Rect::EVERYTHING, ground)
}

fn pixel(image: &Image, x: usize, y: usize) -> [u8; 4] {
    let at = 4 * (y * image.size[0] + x);
    image.rgba[at..at + 4].try_into().expect("four bytes")
}

fn pixels() -> impl Iterator<Item = (usize, usize)> {
    (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)))
}

/// How much light additive paint left on black: once per triangle that covers the pixel.
fn coverage(corners: &[Pos2], indices: &[u32]) -> Vec<u8> {
    let painted = mesh(corners, indices, ONE);
    let image = paint(&white_painter(), painted, Color32::BLACK);
    pixels().map(|(x, y)| pixel(&image, x, y)[0]).collect()
}

/// A small deterministic generator, so that a failure can be repeated.
fn noise(seed: &mut u64) -> f32 {
    *seed = seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 40) as f32 / (1 << 24) as f32
}

#[test]
fn triangles_around_a_point_cover_each_pixel_once() {
    let mut seed = 7;
    for _ in 0..200 {
        // A fan from an arbitrary point to a frame far outside: it tiles the whole picture.
        let hub = pos2(32.0 * noise(&mut seed), 24.0 * noise(&mut seed));
        let rim = [
            pos2(-50.0, -40.0 * noise(&mut seed) - 10.0),
            pos2(90.0 * noise(&mut seed), -60.0),
            pos2(99.0, -50.0),
            pos2(120.0, 24.0 * noise(&mut seed)),
            pos2(99.0, 80.0),
            pos2(-60.0, 70.0),
        ];
        let corners: Vec<Pos2> = std::iter::once(hub).chain(rim).collect();
        let mut indices = vec![];
        for i in 1..=6 {
            let next = i % 6 + 1;
            // Both windings.
            let (a, b) = if i % 2 == 0 { (i, next) } else { (next, i) };
            indices.extend([0, a, b]);
        }
        let is_tiled = coverage(&corners, &indices).iter().all(|&n| n == 1);
        assert!(is_tiled, "hub {hub:?}: a gap or an overlap");
    }
}

#[test]
fn an_edge_through_pixel_centres_belongs_to_one_side() {
    let corners = [[0.5, 0.5], [10.5, 0.5], [10.5, 10.5], [0.5, 10.5]].map(Pos2::from);
    let covered = coverage(&corners, &[0, 1, 2, 2, 3, 0]);
    for ((x, y), n) in pixels().zip(covered) {
        // Top and left edges are inside, bottom and right ones are not.
        assert_eq!(n, u8::from(x < 10 && y < 10), "pixel {x}, {y}");
    }
}

#[test]
fn blending_rounds_to_nearest() {
    for alpha in [0_u8, 1, 64, 127, 128, 200, 254, 255] {
        for under in [0_u8, 1, 50, 128, 254, 255] {
            let over = Color32::from_rgba_premultiplied(alpha / 2, 0, alpha, alpha);
            let painted = mesh(&EVERYWHERE, &[0, 1, 2], over);
            let image = paint(&white_painter(), painted, Color32::from_gray(under));
            let kept = |channel: u8| {
                let part = f64::from(under) * f64::from(255 - alpha) / 255.0;
                (f64::from(channel) + part.round()) as u8
            };
            let expected = [kept(alpha / 2), kept(0), kept(alpha), 255];
            assert_eq!(pixel(&image, 5, 5), expected, "{over:?} over {under}");
        }
    }
}

#[test]
fn a_product_of_bytes_is_exact() {
    for a in 0..=255_u8 {
        for b in 0..=255_u8 {
            let exact = (f64::from(a) * f64::from(b) / 255.0).round();
            assert_eq!(f64::from(scaled(a, b)), exact, "{a} · {b}");
        }
    }
}

#[test]
fn nothing_is_painted_outside_the_clip_rectangle() {
    let white = mesh(&EVERYWHERE, &[0, 1, 2], Color32::WHITE);
    let clip = rect(3.4, 5.0, 8.6, 7.0);
    let image = paint_clipped(&white_painter(), white, clip, Color32::BLACK);
    for (x, y) in pixels() {
        // The clip's corners are rounded to pixels: 3 and 9.
        let is_inside = (3..9).contains(&x) && (5..7).contains(&y);
        assert_eq!(pixel(&image, x, y)[0] == 255, is_inside, "pixel {x}, {y}");
    }
}

#[test]
fn a_texture_at_its_own_size_is_copied() {
    let texels = (0..8 * 8).map(|i| Color32::from_rgb(i * 3, 255 - i, i));
    let source = ColorImage::new([8, 8], texels.collect());
    for options in [LINEAR, NEAREST] {
        let painter = painter_with(TEXTURE, source.clone(), options);
        let copied = textured(rect(2.0, 3.0, 10.0, 11.0));
        let image = paint(&painter, copied, Color32::BLACK);
        for y in 0..8 {
            for x in 0..8 {
                let texel = source[(x, y)].to_array();
                assert_eq!(pixel(&image, x + 2, y + 3), texel, "texel {x}, {y}");
            }
        }
    }
}

#[test]
fn enlarging_mixes_or_repeats_texels() {
    let source = ColorImage::new([2, 1], vec![Color32::BLACK, Color32::WHITE]);
    for (options, expected) in [
        (NEAREST, [0, 0, 0, 0, 255, 255, 255, 255]),
        (LINEAR, [0, 0, 32, 96, 159, 223, 255, 255]),
    ] {
        let painter = painter_with(TEXTURE, source.clone(), options);
        let image = paint(&painter, textured(rect(0.0, 0.0, 8.0, 4.0)), Color32::RED);
        let row = std::array::from_fn::<u8, 8, _>(|x| pixel(&image, x, 1)[0]);
        assert_eq!(row, expected);
    }
}

#[test]
fn a_part_of_a_texture_can_be_replaced() {
    let white = ColorImage::filled([4, 4], Color32::WHITE);
    let mut painter = painter_with(TEXTURE, white, NEAREST);
    let mut delta = TexturesDelta::default();
    let patch = ColorImage::filled([2, 2], Color32::RED);
    // The second reaches over the edge, the third lies wholly outside: what does not fit is dropped.
    for corner in [[1, 2], [3, 3], [9, 9]] {
        let part = ImageDelta::partial(corner, patch.clone(), NEAREST);
        delta.push(TEXTURE, part);
    }
    painter.apply(&mut delta);

    let image = paint(&painter, textured(rect(0.0, 0.0, 4.0, 4.0)), Color32::BLACK);
    let red = [(1, 2), (2, 2), (1, 3), (2, 3), (3, 3)];
    for y in 0..4 {
        for x in 0..4 {
            let is_red = pixel(&image, x, y) == [255, 0, 0, 255];
            assert_eq!(is_red, red.contains(&(x, y)), "texel {x}, {y}");
        }
    }
}

#[test]
fn a_freed_texture_lasts_to_the_end_of_its_frame() {
    let mut painter = white_painter();
    let white = mesh(&EVERYWHERE, &[0, 1, 2], Color32::WHITE);
    let mut delta = TexturesDelta::default();
    delta.free(TEXTURE);
    // What was freed is in `delta` the first time only.
    for expected in [255, 0] {
        painter.apply(&mut delta);
        let image = paint(&painter, white.clone(), Color32::BLACK);
        assert_eq!(pixel(&image, 1, 1)[0], expected);
    }
}

#[test]
fn what_cannot_be_drawn_is_left_out() {
    let painter = white_painter();
    let blank = paint(&painter, Mesh::default(), Color32::BLACK);
    let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0];
    for x in odd {
        for y in odd {
            let corners = [[x, y], [20.0, 0.0], [0.0, 20.0], [20.0, 0.0]].map(Pos2::from);
            // Not finite or without area, an index out of range, a triangle cut short.
            let indices = [0, 1, 3, 0, 1, 77, 3, 3, 3, 2, 1];
            let white = mesh(&corners, &indices, Color32::WHITE);
            let image = paint(&painter, white, Color32::BLACK);
            assert!(image == blank, "corner {x}, {y}");
        }
    }
    let mut unknown = mesh(&EVERYWHERE, &[0, 1, 2], ONE);
    unknown.texture_id = TextureId::User(5);
    assert!(paint(&painter, unknown, Color32::BLACK) == blank);
}

#[test]
fn huge_triangles_and_wild_coordinates_are_survived() {
    let grey = ColorImage::filled([3, 5], Color32::GRAY);
    let painter = painter_with(TEXTURE, grey, TextureOptions::LINEAR_MIRRORED_REPEAT);
    let mut seed = 3;
    for power in 0..38 {
        let reach = 10_f32.powi(power);
        let mut wild = Mesh::with_texture(TEXTURE);
        for i in 0..3 {
            let mut at = || (noise(&mut seed) - 0.5) * reach;
            let u = if i == 2 { f32::NAN } else { at() };
            let uv = pos2(u, at());
            let corner = vertex(pos2(at(), at()), uv, Color32::from_gray(80 * i));
            wild.vertices.push(corner);
        }
        wild.indices = vec![0, 1, 2];
        let clip = rect(-reach, f32::NAN, reach, f32::INFINITY);
        let _drawn = paint_clipped(&painter, wild, clip, Color32::BLACK);
    }
    // One that covers everything still does.
    let far = [pos2(-9e5, -9e5), pos2(9e5, -9e5), pos2(0.0, 9e5)];
    assert!(coverage(&far, &[0, 1, 2]).iter().all(|&n| n == 1));
}

#[test]
fn colours_change_evenly_between_corners() {
    let mut ramp = Mesh::with_texture(TEXTURE);
    for (x, y, gray) in [(0., 0., 0), (32., 0., 255), (32., 24., 255), (0., 24., 0)] {
        let corner = vertex(pos2(x, y), Pos2::ZERO, Color32::from_gray(gray));
        ramp.vertices.push(corner);
    }
    ramp.indices = vec![0, 1, 2, 0, 2, 3];
    let image = paint(&white_painter(), ramp, Color32::RED);
    for (x, y) in pixels() {
        let exact = (x as f64 + 0.5) / 32.0 * 255.0;
        let off = f64::from(pixel(&image, x, y)[0]) - exact;
        assert!(off.abs() <= 0.51, "pixel {x}, {y}: {off} off {exact}");
    }
}

#[test]
fn a_glyph_at_the_rim_of_the_atlas_fades_out_like_any_other() {
    // A white texel in the corner, and the same glyph at the left rim and inside.
    let mut atlas = ColorImage::filled([8, 8], Color32::TRANSPARENT);
    for at in [(0, 0), (0, 4), (1, 4), (3, 4), (4, 4)] {
        atlas[at] = Color32::WHITE;
    }
    let painter = painter_with(TextureId::default(), atlas, LINEAR);
    let draw = |x: f32| {
        let mut glyph = Mesh::with_texture(TextureId::default());
        let uv = rect(x / 8.0, 0.5, (x + 2.0) / 8.0, 0.625);
        glyph.add_rect_with_uv(rect(3.3, 4.4, 9.9, 8.8), uv, Color32::WHITE);
        glyph.add_colored_rect(rect(20., 9., 22., 11.), Color32::RED);
        paint(&painter, glyph, Color32::BLACK)
    };
    assert!(draw(0.0) == draw(3.0));
    assert_eq!(pixel(&draw(0.0), 21, 10), [255, 0, 0, 255]);
}

/// With rows copied, and texel by texel.
fn both_ways(texture: &CpuTexture, quad: Rect, tint: Rgba) -> [Vec<Rgba>; 2] {
    let mesh = textured(quad);
    let clip = clip_in_pixels(rect(1.0, 2.0, 30.0, 21.0), 1.0, SIZE);
    let ground = Painting {
        width: SIZE[0],
        pixels: vec![[9, 8, 7, 255]; SIZE[0] * SIZE[1]],
    };
    let mut canvases = [ground.pixels.clone(), ground.pixels].map(|pixels| Painting {
        width: SIZE[0],
        pixels,
    });
    for corners in mesh.indices.as_chunks::<3>().0 {
        let mut corners = corners.map(|i| &mesh.vertices[i as usize]);
        let corners_px = corners.map(|it| [it.pos.x, it.pos.y].map(f64::from));
        let triangle = RasterTriangle::new(corners_px, clip).expect("in sight");
        if triangle.is_flipped {
            corners.swap(1, 2);
        }
        let at = Varying::new(corners.map(|it| texture.texel_position(it.uv)));
        canvases[0].fill_textured(&triangle, texture, &at, tint);
        canvases[1].fill_shaded(&triangle, |w| tinted(texture.sample(at.at(w)), tint));
    }
    canvases.map(|canvas| canvas.pixels)
}

#[test]
fn rows_of_texels_on_pixels_are_copied_to_the_bit() {
    let texel = |i: usize| {
        let [r, g, b, a] = [3, 5, 7, 11].map(|by| (by * i % 256) as u8);
        Color32::from_rgba_premultiplied(r.min(a), g.min(a), b.min(a), a)
    };
    let image = ColorImage::new([17, 11], (0..17 * 11).map(texel).collect());
    let offsets = [0.0, 1.0 / 1024.0, 1.0 / 256.0, 1.0 / 128.0, 0.3, 0.5];
    let sizes = [
        [17.0, 11.0],
        [17.01, 11.0],
        [17.0, 11.03],
        [16.0, 11.0],
        [34.0, 22.0],
    ];
    for options in [LINEAR, NEAREST] {
        let texture = CpuTexture::new(&image, options, Surroundings::Wrapped).expect("a texture");
        for (offset, [width, height]) in offsets.into_iter().flat_map(|o| sizes.map(|s| (o, s))) {
            for [left, top] in [[3.0, 4.0], [-5.0, -3.0], [22.0, 17.0]] {
                let [left, top] = [left + offset, top + offset];
                let quad = rect(left, top, left + width, top + height);
                for tint in [[255; 4], [200, 100, 50, 250]] {
                    let [copied, sampled] = both_ways(&texture, quad, tint);
                    assert!(copied == sampled, "{quad} {tint:?} {options:?}");
                }
            }
        }
        let middles = |x: i64, y: i64| [x, y].map(|at| (at << 16) + (1 << 15));
        let row = texture.texels_on([middles(2, 3), middles(8, 3)], 7);
        assert_eq!(row.expect("on pixels").len(), 7);
        for ends in [
            [middles(2, 3), middles(9, 3)],
            [middles(2, 3), middles(8, 4)],
            [middles(11, 3), middles(17, 3)],
        ] {
            assert!(texture.texels_on(ends, 7).is_none(), "{ends:?}");
        }
    }
}
