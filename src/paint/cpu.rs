//! Draws egui's triangles on the CPU, with no display and no GPU. Coordinates, weights, texture filtering and blending
//! are integers: a picture has the same bytes on every machine. Paint callbacks are ignored.

use std::collections::HashMap;

use egui::epaint::{ClippedPrimitive, ImageData, Primitive, Vertex};
use egui::{Color32, Rect, TextureId, TexturesDelta};

use crate::lesson::with_link;

use super::texture::{CpuTexture, Rgba, Surroundings};
use super::triangle::{PixelRect, PixelRun, RasterTriangle, mix};

#[derive(Clone, Debug, Default)]
pub struct CpuPainter {
    textures: HashMap<TextureId, CpuTexture>,
    to_free: Vec<TextureId>,
}

impl CpuPainter {
    /// Leaves `delta` empty. What egui freed with this frame is kept until the next call: the frame may still show it.
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

    /// Over a `background`, opaque or not. What cannot be drawn (unknown textures, bad indices, corners not finite) is left out.
    pub fn paint(
        &self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        size_px: [usize; 2],
        background: Color32,
    ) -> Image {
        let mut canvas = Painting {
            width: size_px[0],
            pixels: [background.to_array()].repeat(size_px[0] * size_px[1]),
        };
        for it in primitives {
            if let Primitive::Mesh(mesh) = &it.primitive
                && let Some(texture) = self.textures.get(&mesh.texture_id)
            {
                let clip = clip_in_pixels(it.clip_rect, pixels_per_point, size_px);
                for corners in mesh.indices.as_chunks::<3>().0 {
                    let corners = corners.map(|i| mesh.vertices.get(i as usize));
                    if let [Some(a), Some(b), Some(c)] = corners {
                        canvas.fill_triangle([a, b, c], texture, pixels_per_point, clip);
                    }
                }
            }
        }
        Image {
            size: size_px,
            rgba: canvas.pixels.into_flattened(),
        }
    }
}

fn surroundings(id: TextureId) -> Surroundings {
    if id == TextureId::default() {
        Surroundings::Empty
    } else {
        Surroundings::Wrapped
    }
}

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

struct Painting {
    width: usize,
    pixels: Vec<Rgba>,
}

impl Painting {
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
            (true, false) => self.fill_textured(&triangle, texture, &at, colors[0]),
            (false, false) => {
                self.fill_shaded(&triangle, |w| {
                    tinted(texture.sample(at.at(w)), color.rgba(w))
                });
            }
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

    fn fill_shaded(&mut self, triangle: &RasterTriangle, shade: impl Fn([i64; 2]) -> Rgba) {
        for span in triangle.rows().filter_map(|y| triangle.span(y)) {
            let weights = triangle.weights(&span);
            for (pixel, weights) in self.span_mut(&span).iter_mut().zip(weights) {
                *pixel = blended(shade(weights), *pixel);
            }
        }
    }

    /// Most pictures and letters lie on pixels: their rows are copied.
    fn fill_textured(
        &mut self,
        triangle: &RasterTriangle,
        texture: &CpuTexture,
        at: &Varying<2>,
        tint: Rgba,
    ) {
        for span in triangle.rows().filter_map(|y| triangle.span(y)) {
            let ends = triangle
                .weights_at_ends(&span)
                .map(|weights| at.at(weights));
            let texels = texture.texels_on(ends, span.right - span.left);
            let pixels = self.span_mut(&span).iter_mut();
            if let Some(texels) = texels {
                for (pixel, texel) in pixels.zip(texels) {
                    *pixel = blended(tinted(*texel, tint), *pixel);
                }
            } else {
                for (pixel, weights) in pixels.zip(triangle.weights(&span)) {
                    *pixel = blended(tinted(texture.sample(at.at(weights)), tint), *pixel);
                }
            }
        }
    }

    fn span_mut(&mut self, span: &PixelRun) -> &mut [Rgba] {
        let row = span.y * self.width;
        &mut self.pixels[row + span.left..row + span.right]
    }
}

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

fn tinted(texel: Rgba, color: Rgba) -> Rgba {
    if texel == [255; 4] {
        return color;
    }
    std::array::from_fn(|i| scaled(texel[i], color[i]))
}

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

/// A picture: rows from the top, four bytes a pixel (R, G, B, A), in sRGB, multiplied by alpha, which is 255 but on glass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    pub size: [usize; 2],
    pub rgba: Vec<u8>,
}

impl Image {
    pub fn pixels(&self) -> &[[u8; 4]] {
        self.rgba.as_chunks::<4>().0
    }

    /// # Panics
    /// If `rgba` does not hold four bytes for every pixel of `size`, or there is no pixel.
    pub fn to_png(&self) -> Vec<u8> {
        self.to_linked_png(None)
    }

    /// The same; the file carries the link to what it shows.
    ///
    /// # Panics
    /// As [`Image::to_png`].
    pub fn to_linked_png(&self, link: Option<&str>) -> Vec<u8> {
        let rgb: Vec<u8> = (self.pixels().iter())
            .flat_map(|&[r, g, b, _]| [r, g, b])
            .collect();
        let mut bytes = Vec::new();
        encode(&mut bytes, self.size, (png::ColorType::Rgb, &rgb), link)
            .expect("an image with all its pixels, and memory takes every write");
        bytes
    }

    /// One on glass, with its alpha where it has any.
    ///
    /// # Panics
    /// As [`Image::to_png`].
    pub fn to_glass_png(&self) -> Vec<u8> {
        if self.pixels().iter().all(|[.., a]| *a == 255) {
            return self.to_png();
        }
        let mut rgba = self.rgba.clone();
        for pixel in rgba.as_chunks_mut::<4>().0 {
            let [r, g, b, a] = *pixel;
            if a != 0 && a != 255 {
                *pixel = Color32::from_rgba_premultiplied(r, g, b, a).to_srgba_unmultiplied();
            }
        }
        let mut bytes = Vec::new();
        encode(&mut bytes, self.size, (png::ColorType::Rgba, &rgba), None)
            .expect("an image with all its pixels, and memory takes every write");
        bytes
    }
}

fn encode(
    bytes: &mut Vec<u8>,
    [width, height]: [usize; 2],
    (colour, pixels): (png::ColorType, &[u8]),
    link: Option<&str>,
) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(bytes, width as u32, height as u32);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    // Measured on a page of interface at 1800 × 1040: 2 ms and 243 kB, where the best filter at
    // `Balanced` takes 17 ms for 136 kB. A course is exported by the hundred.
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Paeth);
    if let Some(link) = link {
        with_link(&mut encoder, link)?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()
}

#[cfg(test)]
mod tests;
