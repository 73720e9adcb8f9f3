//! A picture that a surface is painted with.

use std::sync::Arc;

/// Texels, row by row from the top. Cheap to copy: copies share them.
#[derive(Clone, Debug)]
pub struct Texture {
    size: [usize; 2],
    /// `size` again.
    ends: [f32; 2],
    /// Where columns and rows are powers of 2: one less than each, and the power of the columns.
    masks: Option<([u32; 2], u32)>,
    /// 0x00rrggbb
    texels: Arc<[u32]>,
}

impl PartialEq for Texture {
    fn eq(&self, other: &Self) -> bool {
        self.size == other.size
            && (Arc::ptr_eq(&self.texels, &other.texels) || self.texels == other.texels)
    }
}

impl Texture {
    /// As wide, and as high, as a texture may be: one of more would fill the memory.
    pub const MAX_SIDE: usize = 8192;

    /// Columns and rows, and their red, green and blue. `None` of no texels, too many or too few.
    #[must_use]
    pub fn new(size: [usize; 2], texels: impl AsRef<[[u8; 3]]>) -> Option<Self> {
        let texels = texels.as_ref();
        let is_usable = size.iter().all(|side| (1..=Self::MAX_SIDE).contains(side))
            && size[0] * size[1] == texels.len();
        let has_masks = size.iter().all(|n| n.is_power_of_two());
        let packed = |&[r, g, b]: &[u8; 3]| u32::from_be_bytes([0, r, g, b]);
        is_usable.then(|| Self {
            size,
            ends: size.map(|n| n as f32),
            masks: has_masks.then(|| (size.map(|n| n as u32 - 1), size[0].trailing_zeros())),
            texels: texels.iter().map(packed).collect(),
        })
    }

    /// Columns and rows.
    #[must_use]
    pub const fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The texel at (u, v): u from left to right, v from bottom to top, both from 0 to 1 and from there on again.
    ///
    /// ```
    /// use clipscope::geom::Texture;
    ///
    /// let texture = Texture::new([2, 1], [[1; 3], [2; 3]]).expect("two texels");
    /// assert_eq!(texture.at([0.2, 0.5]), [1; 3]);
    /// assert_eq!(texture.at([-0.2, 7.5]), [2; 3]);
    /// ```
    #[inline]
    #[must_use]
    pub fn at(&self, [u, v]: [f32; 2]) -> [u8; 3] {
        let [texel] = self.at_each(&[[u], [v]]);
        let [_, r, g, b] = texel.to_be_bytes();
        [r, g, b]
    }

    /// The same for some at once, as 0x00rrggbb. Any texel where u or v is no number, or so large that f32 has no fractions.
    #[inline]
    #[must_use]
    pub fn at_each<const N: usize>(&self, uv: &[[f32; N]; 2]) -> [u32; N] {
        self.indices(uv).map(|i| self.texels[i as usize])
    }

    #[expect(
        clippy::inline_always,
        reason = "a call takes longer than what it does: a tenth of all filling"
    )]
    #[inline(always)]
    fn indices<const N: usize>(&self, [u, v]: &[[f32; N]; 2]) -> [u32; N] {
        let [n_columns, n_rows] = self.ends;
        if let Some(([last_column, last_row], bits)) = self.masks {
            let right = masked_places(u, n_columns, last_column);
            let up = masked_places(v, n_rows, last_row);
            return std::array::from_fn(|i| (last_row - up[i]) << bits | right[i]);
        }
        let [columns, rows] = self.size.map(|n| n as u32);
        let (right, up) = (places(u, n_columns), places(v, n_rows));
        std::array::from_fn(|i| (rows - 1 - up[i]) * columns + right[i])
    }
}

/// Floats from 2²³ on hold whole numbers in their last bits: nothing is cast, which the processor would do one by one.
const WHOLE: f32 = 8_388_608.0;
const WHOLE_OF_ANY_SIGN: f32 = 1.5 * WHOLE;

/// Which of `n` texels beside each other, from 0 to 1 and from there on again, `n` being a power of 2 and `last` one less: what
/// is added by going on again is a multiple of `n`.
#[inline]
fn masked_places<const N: usize>(along: &[f32; N], n: f32, last: u32) -> [u32; N] {
    std::array::from_fn(|i| {
        let part = along[i] - ((along[i] + WHOLE_OF_ANY_SIGN) - WHOLE_OF_ANY_SIGN);
        let place = part * n;
        let nearest = place + WHOLE_OF_ANY_SIGN;
        let is_above = nearest - WHOLE_OF_ANY_SIGN > place;
        nearest.to_bits().wrapping_sub(u32::from(is_above)) & last
    })
}

/// Which of `n` texels beside each other, from 0 to 1 and from there on again.
#[inline]
fn places<const N: usize>(along: &[f32; N], n: f32) -> [u32; N] {
    let last = n - 1.0;
    let places: [f32; N] = std::array::from_fn(|i| {
        let part = along[i] - ((along[i] + WHOLE_OF_ANY_SIGN) - WHOLE_OF_ANY_SIGN);
        let place = (part + if part < 0.0 { 1.0 } else { 0.0 }) * n;
        let place = if place < last { place } else { last };
        if place > 0.0 { place } else { 0.0 }
    });
    std::array::from_fn(|i| {
        let nearest = places[i] + WHOLE;
        let is_above = nearest - WHOLE > places[i];
        (nearest.to_bits() - u32::from(is_above)).wrapping_sub(WHOLE.to_bits())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By `floor` and a cast.
    fn place(along: f32, n: usize) -> u32 {
        let place = (along - along.floor()) * n as f32;
        (place as u32).min(n as u32 - 1)
    }

    /// The same without rounding, but for what is nearest to 0.
    fn exact_place(along: f32, n: usize) -> u32 {
        let along = f64::from(along);
        let place = (along - along.floor()) * n as f64;
        // Just below 0 even f64 rounds up to 1.
        (place as u32).min(n as u32 - 1)
    }

    #[test]
    fn where_sides_are_powers_of_two_places_are_exact() {
        for bits in [0, 1, 3, 10, 13] {
            let n = 1_usize << bits;
            let masked = |along: &[f32; 4]| masked_places(along, n as f32, n as u32 - 1);
            let mut along = -8.0_f32;
            while along < 8.0 {
                let beside = [along.next_down(), along, along.next_up(), along / 3.0];
                let exact = beside.map(|x| exact_place(x, n));
                assert_eq!(masked(&beside), exact, "{beside:?}");
                along += 1.0 / 256.0;
            }
            let small = [0.0, -0.0, f32::MIN_POSITIVE, -1e-6];
            assert_eq!(masked(&small), small.map(|x| exact_place(x, n)));
            let large = [4096.125, -70_000.375, 1e6, -0.1];
            assert_eq!(masked(&large), large.map(|x| exact_place(x, n)));
        }
    }

    #[test]
    fn places_are_those_of_the_floor() {
        for n in [1, 2, 3, 7, 1000, 1024, Texture::MAX_SIDE] {
            let mut along = -8.0_f32;
            while along < 8.0 {
                let (exact, thirds) = (along * 1.25, along / 3.0);
                let beside = [exact.next_down(), exact, exact.next_up(), thirds];
                let expected = beside.map(|x| place(x, n));
                assert_eq!(places(&beside, n as f32), expected, "{beside:?}");
                along += 1.0 / 256.0;
            }
            let small = [0.0, -0.0, f32::MIN_POSITIVE, -1e-9, 1e-9, -1e-30];
            assert_eq!(places(&small, n as f32), small.map(|x| place(x, n)));
        }
    }

    #[test]
    fn there_is_a_texel_wherever_one_is_asked_for() {
        let odd = Texture::new([3, 2], [[9; 3]; 6]).expect("six texels");
        let even = Texture::new([4, 2], [[9; 3]; 8]).expect("eight texels");
        let mut wild = vec![f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
        for power in 0..128 {
            let large = f32::from_bits((127 + power) << 23);
            let [below, above] = [large.next_down(), large.next_up()];
            wild.extend([large, below, above, -large, -below]);
        }
        for &u in &wild {
            for texture in [&odd, &even] {
                assert_eq!(texture.at([u, 0.5]), [9; 3]);
                assert_eq!(texture.at([0.5, u]), [9; 3]);
            }
        }
    }

    #[test]
    fn a_texture_has_texels_and_not_too_many_beside_each_other() {
        assert_eq!(Texture::new([0, 1], []), None);
        assert_eq!(Texture::new([2, 2], [[0; 3]; 3]), None);
        let line = vec![[0; 3]; Texture::MAX_SIDE + 1];
        assert_eq!(Texture::new([line.len(), 1], &line), None);
        assert!(Texture::new([1, line.len() - 1], &line[1..]).is_some());
    }
}
