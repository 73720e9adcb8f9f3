//! A picture in large pixels: what is stored at each of them, never a colour.

use crate::text::Value;

use super::role::Role;

/// Pixels row by row from the top left.
#[derive(Clone, PartialEq, Debug)]
pub struct Raster {
    /// Over it: "depth buffer".
    pub title: Value,
    /// Columns and rows, each at least 1.
    pub size: [usize; 2],
    /// One for each pixel.
    pub pixels: Vec<Pixel>,
    /// What the darkest and the palest shade stand for, where that is to be read off.
    pub scale: Option<[Value; 2]>,
    /// The pixel that this step is about, by column and row.
    pub current: Option<[usize; 2]>,
    /// What is drawn over the pixels.
    pub over: Vec<RasterMark>,
}

/// Something drawn over the pixels of a [`Raster`], at places counted in pixels from its top left corner: the middle of the
/// first pixel is (½, ½).
#[derive(Clone, PartialEq, Debug)]
pub struct RasterMark {
    /// Its meaning.
    pub role: Role,
    /// Where and what.
    pub shape: RasterShape,
}

impl RasterMark {
    /// A line stands under what is stored, so that both can be read.
    pub const fn is_line(&self) -> bool {
        matches!(self.shape, RasterShape::Line(_))
    }
}

/// What is drawn over pixels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RasterShape {
    /// From place to place.
    Line([[f64; 2]; 2]),
    /// A point.
    Dot([f64; 2]),
    /// A place that is asked about.
    Cross([f64; 2]),
}

/// What is stored at a pixel.
#[derive(Clone, PartialEq, Debug)]
pub struct Pixel {
    /// Whose it is; none where nothing has been drawn yet.
    pub role: Option<Role>,
    /// How dark, from 0 to 1: a depth, an order.
    pub shade: f64,
    /// What it says, where pixels are large enough to be read.
    pub value: Option<Value>,
}

impl Pixel {
    /// Nothing has been drawn here yet.
    pub const EMPTY: Self = Self {
        role: None,
        shade: 0.0,
        value: None,
    };
}

impl Raster {
    /// Each pixel is about the one with its number under this name, row by row.
    pub const LINK: &'static str = "raster-pixel";

    /// The pixel in this column and row.
    pub fn at(&self, [column, row]: [usize; 2]) -> Option<&Pixel> {
        let is_within = column < self.size[0] && row < self.size[1];
        self.pixels
            .get(row * self.size[0] + column)
            .filter(|_| is_within)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_counted_from_the_top_left_row_by_row() {
        let pixels = (0..6).map(|i| Pixel {
            shade: f64::from(i),
            ..Pixel::EMPTY
        });
        let raster = Raster {
            title: Value::Count(6),
            size: [3, 2],
            pixels: pixels.collect(),
            scale: None,
            current: None,
            over: Vec::new(),
        };
        let shade = |at| raster.at(at).map(|pixel| pixel.shade);
        assert_eq!(shade([2, 0]), Some(2.0));
        assert_eq!(shade([0, 1]), Some(3.0));
        assert_eq!(shade([3, 0]), None, "no column wraps into the next row");
        assert_eq!(shade([0, 2]), None);
    }
}
