//! A picture that a surface is painted with.

use std::sync::Arc;

/// Texels, row by row from the top. Cheap to copy: copies share them.
#[derive(Clone, Debug)]
pub struct Texture {
    size: [usize; 2],
    texels: Arc<[[u8; 3]]>,
}

impl PartialEq for Texture {
    /// Copies need not be looked through.
    fn eq(&self, other: &Self) -> bool {
        self.size == other.size
            && (Arc::ptr_eq(&self.texels, &other.texels) || self.texels == other.texels)
    }
}

impl Texture {
    /// Columns and rows, and their red, green and blue. `None` where there is no texel, or not one for each place.
    #[must_use]
    pub fn new(size: [usize; 2], texels: impl Into<Arc<[[u8; 3]]>>) -> Option<Self> {
        let texels = texels.into();
        let n_texels = size[0].checked_mul(size[1])?;
        (n_texels > 0 && n_texels == texels.len()).then_some(Self { size, texels })
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
        let place = |along: f32, n: usize| {
            // Cheaper than `floor`, for which the base set of x86-64 has no instruction.
            let part = along - along as i32 as f32;
            let part = if part < 0.0 { part + 1.0 } else { part };
            ((part * n as f32) as usize).min(n - 1)
        };
        let [columns, rows] = self.size;
        let row = rows - 1 - place(v, rows);
        self.texels[row * columns + place(u, columns)]
    }
}
