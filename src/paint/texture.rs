//! Textures as the CPU painter samples them: integer bilinear or nearest.

use egui::epaint::textures::{TextureFilter, TextureOptions, TextureWrapMode};
use egui::{ColorImage, Pos2};

/// A premultiplied colour in a register's width: channels in the order R, G, B, A.
pub(super) type Rgba = [u8; 4];

const TEXEL_BITS: u32 = 16;
const TEXEL: i64 = 1 << TEXEL_BITS;
/// What stands less than 1/512 of a texel off its middle is that texel. Half of it is left for how positions between are rounded.
const ASTRAY: i64 = TEXEL >> 10;
/// Texel coordinates are kept within ±2^15, so that interpolating them fits an `i64`.
const FARTHEST_TEXEL: f64 = 32_768.0;

#[derive(Clone, Debug)]
pub(super) struct CpuTexture {
    size: [usize; 2],
    texels: Vec<Rgba>,
    options: TextureOptions,
    surroundings: Surroundings,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Surroundings {
    Wrapped,
    /// Nothing: the image is egui's font atlas. All its glyphs have empty texels around them,
    /// but those at the atlas' rim; with these there, too, the pixels of turned text do not
    /// depend on where in the atlas a glyph has found its place.
    Empty,
}

impl CpuTexture {
    pub fn new(
        image: &ColorImage,
        options: TextureOptions,
        surroundings: Surroundings,
    ) -> Option<Self> {
        let [width, height] = image.size;
        let n_texels = width.checked_mul(height)?;
        if n_texels == 0 || image.pixels.len() < n_texels {
            return None;
        }
        let texels = image.pixels[..n_texels].iter().map(egui::Color32::to_array);
        Some(Self {
            size: image.size,
            texels: texels.collect(),
            options,
            surroundings,
        })
    }

    pub fn update(&mut self, [x, y]: [usize; 2], image: &ColorImage, options: TextureOptions) {
        self.options = options;
        let [width, height] = self.size;
        let n_columns = image.size[0].min(width.saturating_sub(x));
        if n_columns == 0 {
            return;
        }
        let rows = image.pixels.chunks_exact(image.size[0]);
        for (row, source) in rows.enumerate().take(height.saturating_sub(y)) {
            let start = (y + row) * width + x;
            let target = &mut self.texels[start..start + n_columns];
            for (texel, color) in target.iter_mut().zip(source) {
                *texel = color.to_array();
            }
        }
    }

    pub fn texel_position(&self, uv: Pos2) -> [i64; 2] {
        let fixed = |at: f32, size: usize| {
            let texels = f64::from(at) * size as f64;
            // A coordinate that is not a number becomes 0 in the cast.
            (texels.clamp(-FARTHEST_TEXEL, FARTHEST_TEXEL) * TEXEL as f64).round() as i64
        };
        [fixed(uv.x, self.size[0]), fixed(uv.y, self.size[1])]
    }

    pub fn sample_point(&self, at: [i64; 2]) -> Rgba {
        match self.surroundings {
            Surroundings::Wrapped => self.sample(at),
            // It means the white texel in the corner, by the corner of that texel.
            Surroundings::Empty => self.texel(at[0] >> TEXEL_BITS, at[1] >> TEXEL_BITS),
        }
    }

    pub fn sample(&self, [u, v]: [i64; 2]) -> Rgba {
        if self.options.magnification == TextureFilter::Nearest {
            return self.texel(u >> TEXEL_BITS, v >> TEXEL_BITS);
        }
        // Texel centres are at halves; fractions are rounded to 1/256, so that text, whose
        // texels lie on pixels, is copied exactly.
        let eighth = |at: i64| (at - TEXEL / 2 + (1 << (TEXEL_BITS - 9))) >> (TEXEL_BITS - 8);
        let (u, v) = (eighth(u), eighth(v));
        let (x, y) = (u >> 8, v >> 8);
        let (a, b) = ((u & 255) as u32, (v & 255) as u32);
        if a == 0 && b == 0 {
            return self.texel(x, y);
        }
        let top = [self.texel(x, y), self.texel(x + 1, y)];
        let bottom = [self.texel(x, y + 1), self.texel(x + 1, y + 1)];
        std::array::from_fn(|i| {
            let mix = |row: [Rgba; 2]| u32::from(row[0][i]) * (256 - a) + u32::from(row[1][i]) * a;
            ((mix(top) * (256 - b) + mix(bottom) * b + (1 << 15)) >> 16) as u8
        })
    }

    /// The texels on a row of pixels, from the position at the first to that at the last, where each is seen in the middle of a
    /// pixel: [`Self::sample`] gives them back one by one.
    pub fn texels_on(&self, [first, last]: [[i64; 2]; 2], n_pixels: usize) -> Option<&[Rgba]> {
        let whole = |at: i64| {
            let at = at - TEXEL / 2 + ASTRAY;
            (at >> TEXEL_BITS, at & (TEXEL - 1))
        };
        let [(x, u), (y, v)] = first.map(whole);
        let [(last_x, last_u), (last_y, last_v)] = last.map(whole);
        let is_near = [u, v, last_u, last_v].iter().all(|off| *off <= 2 * ASTRAY);
        let is_beside = last_x - x + 1 == n_pixels as i64 && last_y == y;
        let [width, height] = self.size.map(|side| side as i64);
        let is_inside = x >= 0 && last_x < width && (0..height).contains(&y);
        if !(is_near && is_beside && is_inside) {
            return None;
        }
        let start = y as usize * self.size[0] + x as usize;
        Some(&self.texels[start..start + n_pixels])
    }

    fn texel(&self, x: i64, y: i64) -> Rgba {
        let [width, height] = self.size;
        let is_inside = (0..width as i64).contains(&x) && (0..height as i64).contains(&y);
        if is_inside {
            return self.texels[y as usize * width + x as usize];
        }
        if self.surroundings == Surroundings::Empty {
            return [0; 4];
        }
        let mode = self.options.wrap_mode;
        self.texels[wrap(y, height, mode) * width + wrap(x, width, mode)]
    }
}

fn wrap(at: i64, size: usize, mode: TextureWrapMode) -> usize {
    let size = size as i64;
    let wrapped = match mode {
        TextureWrapMode::ClampToEdge => at.clamp(0, size - 1),
        TextureWrapMode::Repeat => at.rem_euclid(size),
        TextureWrapMode::MirroredRepeat => {
            let folded = at.rem_euclid(2 * size);
            folded.min(2 * size - 1 - folded)
        }
    };
    wrapped as usize
}
