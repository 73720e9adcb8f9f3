//! Draws egui's triangles on the CPU, with the same bytes on every machine.
//!
//! egui tessellates everything, text included, to textured triangles in premultiplied sRGB.
//! Filling them here needs no display and no GPU. Coordinates, weights, texture filtering and
//! blending are integers, so a picture is a pure function of the triangles: figures can be
//! compared byte for byte, and exported where there is no screen.
//!
//! Paint callbacks (someone's own GPU code) are ignored.

use std::collections::HashMap;

use egui::epaint::{ClippedPrimitive, ImageData, Mesh, Primitive, Vertex};
use egui::{Color32, Rect, TextureId, TexturesDelta};

use super::image::Image;
use super::texture::{CpuTexture, Rgba, Surroundings};
use super::triangle::{PixelRect, PixelRun, RasterTriangle, mix};

/// Paints tessellated egui output into an [`Image`].
#[derive(Clone, Debug, Default)]
pub struct CpuPainter {
    textures: HashMap<TextureId, CpuTexture>,
    /// Freed by egui, but perhaps still used by the frame they came with.
    to_free: Vec<TextureId>,
}

impl CpuPainter {
    /// A painter that knows no textures yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes over egui's new and changed textures, leaving `delta` empty.
    ///
    /// Call it once for every frame's output, before [`paint`](Self::paint). Textures that egui
    /// freed with this frame are kept until the next call, as the frame may still show them.
    pub fn apply(&mut self, delta: &mut TexturesDelta) {
        for id in self.to_free.drain(..) {
            self.textures.remove(&id);
        }
        for (id, changes) in delta.set.drain() {
            for change in changes {
                let ImageData::Color(image) = &change.image;
                if let Some(corner) = change.pos {
                    if let Some(texture) = self.textures.get_mut(&id) {
                        texture.update(corner, image, change.options);
                    }
                } else if let Some(texture) =
                    CpuTexture::new(image, change.options, surroundings(id))
                {
                    self.textures.insert(id, texture);
                } else {
                    self.textures.remove(&id);
                }
            }
        }
        self.to_free.extend(delta.free.drain());
    }

    /// Paints triangles over an opaque `background`.
    ///
    /// Triangles of unknown textures, with indices out of range or corners that are not finite,
    /// are left out; nothing that egui or a widget can send makes it panic.
    pub fn paint(
        &self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        size_px: [usize; 2],
        background: Color32,
    ) -> Image {
        let [r, g, b, _] = background.to_array();
        let mut canvas = Painting {
            width: size_px[0],
            pixels: vec![[r, g, b, 255]; size_px[0] * size_px[1]],
        };
        for ClippedPrimitive {
            clip_rect,
            primitive,
        } in primitives
        {
            if let Primitive::Mesh(mesh) = primitive
                && let Some(texture) = self.textures.get(&mesh.texture_id)
            {
                let clip = clip_in_pixels(*clip_rect, pixels_per_point, size_px);
                canvas.fill_mesh(mesh, texture, pixels_per_point, clip);
            }
        }
        Image {
            size: size_px,
            rgba: canvas.pixels.into_flattened(),
        }
    }
}

/// The first texture of a context is its font atlas, always.
fn surroundings(id: TextureId) -> Surroundings {
    if id == TextureId::default() {
        Surroundings::Empty
    } else {
        Surroundings::Wrapped
    }
}

/// The pixels inside a clip rectangle, rounded as egui's GPU painters round it.
fn clip_in_pixels(clip: Rect, pixels_per_point: f32, [width, height]: [usize; 2]) -> PixelRect {
    // Casting saturates, and makes 0 of what is not a number.
    let pixel =
        |at: f32, size: usize| ((at * pixels_per_point).round() as i64).clamp(0, size as i64);
    PixelRect {
        left: pixel(clip.min.x, width),
        top: pixel(clip.min.y, height),
        right: pixel(clip.max.x, width),
        bottom: pixel(clip.max.y, height),
    }
}

/// The picture while it is painted.
struct Painting {
    width: usize,
    pixels: Vec<Rgba>,
}

impl Painting {
    fn fill_mesh(
        &mut self,
        mesh: &Mesh,
        texture: &CpuTexture,
        pixels_per_point: f32,
        clip: PixelRect,
    ) {
        for corners in mesh.indices.as_chunks::<3>().0 {
            let [Some(a), Some(b), Some(c)] = corners.map(|i| mesh.vertices.get(i as usize)) else {
                continue;
            };
            self.fill_triangle([a, b, c], texture, pixels_per_point, clip);
        }
    }

    fn fill_triangle(
        &mut self,
        mut corners: [&Vertex; 3],
        texture: &CpuTexture,
        pixels_per_point: f32,
        clip: PixelRect,
    ) {
        let scale = f64::from(pixels_per_point);
        let corners_px = corners.map(|c| [c.pos.x, c.pos.y].map(|at| f64::from(at) * scale));
        let Some(triangle) = RasterTriangle::new(corners_px, clip) else {
            return;
        };
        if triangle.is_flipped {
            corners.swap(1, 2);
        }
        let colors = corners.map(|c| c.color.to_array());
        let is_one_color = colors[0] == colors[1] && colors[1] == colors[2];
        let uv = corners.map(|c| texture.texel_position(c.uv));
        let is_one_texel = uv[0] == uv[1] && uv[1] == uv[2];

        let color = Varying::new(colors.map(|c| c.map(i64::from)));
        let at = Varying::new(uv);
        let texel = texture.sample_point(uv[0]);
        match (is_one_color, is_one_texel) {
            (true, true) => self.fill_flat(&triangle, tinted(texel, colors[0])),
            (false, true) => self.fill_shaded(&triangle, |w| tinted(texel, color.rgba(w))),
            (true, false) => {
                self.fill_shaded(&triangle, |w| tinted(texture.sample(at.at(w)), colors[0]));
            }
            (false, false) => self.fill_shaded(&triangle, |w| {
                tinted(texture.sample(at.at(w)), color.rgba(w))
            }),
        }
    }

    /// Fills with one colour: most of any interface.
    fn fill_flat(&mut self, triangle: &RasterTriangle, color: Rgba) {
        if color == [0; 4] {
            return;
        }
        for span in triangle.rows().filter_map(|y| triangle.span(y)) {
            let pixels = self.span_mut(&span);
            if color[3] == 255 {
                pixels.fill(color);
            } else {
                for pixel in pixels {
                    *pixel = blended(color, *pixel);
                }
            }
        }
    }

    /// Fills with a colour of the corner weights.
    fn fill_shaded(&mut self, triangle: &RasterTriangle, shade: impl Fn([i64; 2]) -> Rgba) {
        for span in triangle.rows().filter_map(|y| triangle.span(y)) {
            let weights = triangle.weights(&span);
            for (pixel, weights) in self.span_mut(&span).iter_mut().zip(weights) {
                *pixel = blended(shade(weights), *pixel);
            }
        }
    }

    fn span_mut(&mut self, span: &PixelRun) -> &mut [Rgba] {
        let row = span.y * self.width;
        &mut self.pixels[row + span.left..row + span.right]
    }
}

/// An attribute with `N` components that changes linearly over a triangle.
struct Varying<const N: usize> {
    start: [i64; N],
    deltas: [[i64; 2]; N],
}

impl<const N: usize> Varying<N> {
    fn new(corners: [[i64; N]; 3]) -> Self {
        let [a, b, c] = corners;
        Self {
            start: a,
            deltas: std::array::from_fn(|i| [b[i] - a[i], c[i] - a[i]]),
        }
    }

    fn at(&self, weights: [i64; 2]) -> [i64; N] {
        std::array::from_fn(|i| mix(self.start[i], self.deltas[i], weights))
    }
}

impl Varying<4> {
    fn rgba(&self, weights: [i64; 2]) -> Rgba {
        self.at(weights).map(|channel| channel.clamp(0, 255) as u8)
    }
}

/// `a · b / 255`, rounded to nearest; exact for all bytes.
fn scaled(a: u8, b: u8) -> u8 {
    let product = u32::from(a) * u32::from(b) + 128;
    ((product + (product >> 8)) >> 8) as u8
}

/// A texel times a vertex colour.
fn tinted(texel: Rgba, color: Rgba) -> Rgba {
    if texel == [255; 4] {
        return color;
    }
    std::array::from_fn(|i| scaled(texel[i], color[i]))
}

/// A premultiplied colour over another one.
fn blended(over: Rgba, under: Rgba) -> Rgba {
    // Opaque and empty are what images and glyphs mostly are.
    if over[3] == 255 {
        return over;
    }
    if over == [0; 4] {
        return under;
    }
    let keep = 255 - over[3];
    // Saturating: egui's additive colours have less alpha than light.
    std::array::from_fn(|i| over[i].saturating_add(scaled(under[i], keep)))
}

#[cfg(test)]
mod tests;
