//! Which pixels, and exactly which colour.

use egui::epaint::textures::TextureOptions;
use egui::epaint::{ColorImage, ImageDelta};
use egui::{Pos2, pos2};

use super::*;

const SIZE: [usize; 2] = [32, 24];
/// Not 0, which is egui's font atlas.
const TEXTURE: TextureId = TextureId::Managed(1);

/// A painter with one texture.
fn painter_with(image: ColorImage, options: TextureOptions) -> CpuPainter {
    let mut painter = CpuPainter::new();
    let mut delta = TexturesDelta::default();
    delta.push(TEXTURE, ImageDelta::full(image, options));
    painter.apply(&mut delta);
    assert!(delta.is_empty());
    painter
}

fn white_painter() -> CpuPainter {
    painter_with(
        ColorImage::filled([1, 1], Color32::WHITE),
        TextureOptions::LINEAR,
    )
}

fn vertex(pos: Pos2, uv: Pos2, color: Color32) -> Vertex {
    Vertex { pos, uv, color }
}

fn mesh(corners: &[Pos2], indices: &[u32], color: Color32) -> Mesh {
    let mut mesh = Mesh::with_texture(TEXTURE);
    mesh.vertices = corners
        .iter()
        .map(|&corner| vertex(corner, Pos2::ZERO, color))
        .collect();
    mesh.indices = indices.to_vec();
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

/// How much light additive paint left on black: once per triangle that covers the pixel.
fn coverage(image: &Image) -> Vec<u8> {
    image.rgba.as_chunks::<4>().0.iter().map(|p| p[0]).collect()
}

/// Adds 1 to red and hides nothing.
const ONE: Color32 = Color32::from_rgba_premultiplied(1, 0, 0, 0);

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
        let image = paint(
            &white_painter(),
            mesh(&corners, &indices, ONE),
            Color32::BLACK,
        );
        assert!(
            coverage(&image).iter().all(|&n| n == 1),
            "hub {hub:?}: a gap or an overlap"
        );
    }
}

#[test]
fn an_edge_through_pixel_centres_belongs_to_one_side() {
    let corners = [
        pos2(0.5, 0.5),
        pos2(10.5, 0.5),
        pos2(10.5, 10.5),
        pos2(0.5, 10.5),
    ];
    let image = paint(
        &white_painter(),
        mesh(&corners, &[0, 1, 2, 2, 3, 0], ONE),
        Color32::BLACK,
    );
    for (i, n) in coverage(&image).into_iter().enumerate() {
        let (x, y) = (i % SIZE[0], i / SIZE[0]);
        // Top and left edges are inside, bottom and right ones are not.
        let expected = u8::from(x < 10 && y < 10);
        assert_eq!(n, expected, "pixel {x}, {y}");
    }
}

#[test]
fn blending_rounds_to_nearest() {
    for alpha in [0_u8, 1, 64, 127, 128, 200, 254, 255] {
        for under in [0_u8, 1, 50, 128, 254, 255] {
            let over = Color32::from_rgba_premultiplied(alpha / 2, 0, alpha, alpha);
            let image = paint(
                &white_painter(),
                mesh(
                    &[pos2(-9., -9.), pos2(99., -9.), pos2(-9., 99.)],
                    &[0, 1, 2],
                    over,
                ),
                Color32::from_gray(under),
            );
            let kept = |channel: u8| {
                let part = f64::from(under) * f64::from(255 - alpha) / 255.0;
                (f64::from(channel) + part.round()) as u8
            };
            assert_eq!(
                pixel(&image, 5, 5),
                [kept(alpha / 2), kept(0), kept(alpha), 255],
                "{over:?} over {under}"
            );
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
    let everywhere = [pos2(-99., -99.), pos2(300., -99.), pos2(-99., 300.)];
    let clip = Rect::from_min_max(pos2(3.4, 5.0), pos2(8.6, 7.0));
    let image = paint_clipped(
        &white_painter(),
        mesh(&everywhere, &[0, 1, 2], Color32::WHITE),
        clip,
        Color32::BLACK,
    );
    for y in 0..SIZE[1] {
        for x in 0..SIZE[0] {
            // The clip's corners are rounded to pixels: 3 and 9.
            let is_inside = (3..9).contains(&x) && (5..7).contains(&y);
            assert_eq!(pixel(&image, x, y)[0] == 255, is_inside, "pixel {x}, {y}");
        }
    }
}

/// A rectangle that shows the whole texture.
fn textured(rect: Rect) -> Mesh {
    let mut mesh = Mesh::with_texture(TEXTURE);
    let uv = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
    mesh.add_rect_with_uv(rect, uv, Color32::WHITE);
    mesh
}

#[test]
fn a_texture_at_its_own_size_is_copied() {
    let pixels = (0..8 * 8)
        .map(|i| Color32::from_rgb(i * 3, 255 - i, i))
        .collect();
    let source = ColorImage::new([8, 8], pixels);
    for options in [TextureOptions::LINEAR, TextureOptions::NEAREST] {
        let painter = painter_with(source.clone(), options);
        let rect = Rect::from_min_max(pos2(2.0, 3.0), pos2(10.0, 11.0));
        let image = paint(&painter, textured(rect), Color32::BLACK);
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
    let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(8.0, 4.0));
    let row = |options| {
        let image = paint(
            &painter_with(source.clone(), options),
            textured(rect),
            Color32::RED,
        );
        std::array::from_fn::<u8, 8, _>(|x| pixel(&image, x, 1)[0])
    };
    assert_eq!(
        row(TextureOptions::NEAREST),
        [0, 0, 0, 0, 255, 255, 255, 255]
    );
    assert_eq!(
        row(TextureOptions::LINEAR),
        [0, 0, 32, 96, 159, 223, 255, 255]
    );
}

#[test]
fn a_part_of_a_texture_can_be_replaced() {
    let mut painter = painter_with(
        ColorImage::filled([4, 4], Color32::WHITE),
        TextureOptions::NEAREST,
    );
    let mut delta = TexturesDelta::default();
    let patch = ColorImage::filled([2, 2], Color32::RED);
    delta.push(
        TEXTURE,
        ImageDelta::partial([1, 2], patch.clone(), TextureOptions::NEAREST),
    );
    // Reaches over the edge, and lies wholly outside: what does not fit is dropped.
    delta.push(
        TEXTURE,
        ImageDelta::partial([3, 3], patch.clone(), TextureOptions::NEAREST),
    );
    delta.push(
        TEXTURE,
        ImageDelta::partial([9, 9], patch, TextureOptions::NEAREST),
    );
    painter.apply(&mut delta);

    let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(4.0, 4.0));
    let image = paint(&painter, textured(rect), Color32::BLACK);
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
    let everywhere = [pos2(-99., -99.), pos2(300., -99.), pos2(-99., 300.)];
    let white = mesh(&everywhere, &[0, 1, 2], Color32::WHITE);

    let mut delta = TexturesDelta::default();
    delta.free(TEXTURE);
    painter.apply(&mut delta);
    let last = paint(&painter, white.clone(), Color32::BLACK);
    assert_eq!(pixel(&last, 1, 1)[0], 255);

    painter.apply(&mut TexturesDelta::default());
    let after = paint(&painter, white, Color32::BLACK);
    assert_eq!(pixel(&after, 1, 1)[0], 0);
}

#[test]
fn what_cannot_be_drawn_is_left_out() {
    let painter = white_painter();
    let blank = paint(&painter, Mesh::default(), Color32::BLACK);
    let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0];
    for x in odd {
        for y in odd {
            let corners = [
                pos2(x, y),
                pos2(20.0, 0.0),
                pos2(0.0, 20.0),
                pos2(20.0, 0.0),
            ];
            // Not finite or without area, an index out of range, a triangle cut short.
            let indices = [0, 1, 3, 0, 1, 77, 3, 3, 3, 2, 1];
            let image = paint(
                &painter,
                mesh(&corners, &indices, Color32::WHITE),
                Color32::BLACK,
            );
            assert!(image == blank, "corner {x}, {y}");
        }
    }
    let mut unknown = mesh(&[pos2(0., 0.), pos2(9., 0.), pos2(0., 9.)], &[0, 1, 2], ONE);
    unknown.texture_id = TextureId::User(5);
    assert!(paint(&painter, unknown, Color32::BLACK) == blank);
}

#[test]
fn huge_triangles_and_wild_coordinates_are_survived() {
    let painter = painter_with(
        ColorImage::filled([3, 5], Color32::GRAY),
        TextureOptions::LINEAR_MIRRORED_REPEAT,
    );
    let mut seed = 3;
    for power in 0..38 {
        let reach = 10_f32.powi(power);
        let mut wild = Mesh::with_texture(TEXTURE);
        for i in 0..3 {
            let mut at = || (noise(&mut seed) - 0.5) * reach;
            let uv = if i == 2 {
                pos2(f32::NAN, at())
            } else {
                pos2(at(), at())
            };
            wild.vertices
                .push(vertex(pos2(at(), at()), uv, Color32::from_gray(80 * i)));
        }
        wild.indices = vec![0, 1, 2];
        let clip = Rect::from_min_max(pos2(-reach, f32::NAN), pos2(reach, f32::INFINITY));
        let _drawn = paint_clipped(&painter, wild, clip, Color32::BLACK);
    }
    // One that covers everything still does.
    let far = [pos2(-9e5, -9e5), pos2(9e5, -9e5), pos2(0.0, 9e5)];
    let image = paint(
        &white_painter(),
        mesh(&far, &[0, 1, 2], ONE),
        Color32::BLACK,
    );
    assert!(coverage(&image).iter().all(|&n| n == 1));
}

#[test]
fn colours_change_evenly_between_corners() {
    let mut ramp = Mesh::with_texture(TEXTURE);
    for (x, y, gray) in [(0., 0., 0), (32., 0., 255), (32., 24., 255), (0., 24., 0)] {
        ramp.vertices
            .push(vertex(pos2(x, y), Pos2::ZERO, Color32::from_gray(gray)));
    }
    ramp.indices = vec![0, 1, 2, 0, 2, 3];
    let image = paint(&white_painter(), ramp, Color32::RED);
    for x in 0..32 {
        let exact = (x as f64 + 0.5) / 32.0 * 255.0;
        for y in 0..24 {
            let gray = f64::from(pixel(&image, x, y)[0]);
            assert!(
                (gray - exact).abs() <= 0.51,
                "pixel {x}, {y}: {gray}, not {exact}"
            );
        }
    }
}

#[test]
fn a_glyph_at_the_rim_of_the_atlas_fades_out_like_any_other() {
    // A white texel in the corner, and the same glyph at the left rim and inside.
    let mut atlas = ColorImage::filled([8, 8], Color32::TRANSPARENT);
    for at in [(0, 0), (0, 4), (1, 4), (3, 4), (4, 4)] {
        atlas[at] = Color32::WHITE;
    }
    let mut painter = CpuPainter::new();
    let mut delta = TexturesDelta::default();
    delta.push(
        TextureId::default(),
        ImageDelta::full(atlas, TextureOptions::LINEAR),
    );
    painter.apply(&mut delta);
    let draw = |x: f32| {
        let mut glyph = Mesh::with_texture(TextureId::default());
        let uv = Rect::from_min_max(pos2(x / 8.0, 0.5), pos2((x + 2.0) / 8.0, 0.625));
        let rect = Rect::from_min_max(pos2(3.3, 4.4), pos2(9.9, 8.8));
        glyph.add_rect_with_uv(rect, uv, Color32::WHITE);
        glyph.add_colored_rect(
            Rect::from_min_max(pos2(20., 9.), pos2(22., 11.)),
            Color32::RED,
        );
        paint(&painter, glyph, Color32::BLACK)
    };
    assert!(draw(0.0) == draw(3.0));
    assert_eq!(pixel(&draw(0.0), 21, 10), [255, 0, 0, 255]);
}
