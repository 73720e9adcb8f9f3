//! Views that are pictures: several small ones or cards in a row, and one in large pixels.

use crate::text::{Message, Value};

use super::{
    mark::Mark,
    role::{Link, Role},
    space::Space,
};

/// How several drawings at one scale stand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Tiles {
    /// A low row of them, under the drawing; beside it in full rows where that makes the drawing larger.
    Strip,
    /// Beside the drawing, in full rows.
    Beside,
    /// As large as they can be: they are the drawing.
    Large,
}

/// Drawings at one scale.
#[derive(Clone, PartialEq, Debug)]
pub struct Multiples {
    pub drawings: Vec<SmallDrawing>,
    pub bounds: [[f64; 2]; 2],
    pub tiles: Tiles,
}

#[derive(Clone, PartialEq, Debug)]
pub struct SmallDrawing {
    pub title: Value,
    pub note: Option<(Role, Value)>,
    pub marks: Vec<Mark>,
    pub is_current: bool,
    /// Has the run not come here yet? Its words are pale, its marks have weights of their own.
    pub is_to_come: bool,
    /// So many of its marks, from the first on, show nothing that the run has not come to; `None` where all do.
    pub n_known: Option<usize>,
    pub link: Option<Link>,
}

impl SmallDrawing {
    pub const fn new(title: Value, note: Option<(Role, Value)>, marks: Vec<Mark>) -> Self {
        Self {
            title,
            note,
            marks,
            is_current: false,
            is_to_come: false,
            n_known: None,
            link: None,
        }
    }

    /// Without what the run has not come to.
    pub fn hide_answer(&mut self) {
        if let Some(n_known) = self.n_known {
            self.marks.truncate(n_known);
            self.note = None;
        }
    }
}

impl Multiples {
    /// Width over height of one drawing.
    pub fn aspect(&self) -> f64 {
        let [width, height] = [0, 1].map(|i| self.bounds[1][i] - self.bounds[0][i]);
        width / height.max(f64::MIN_POSITIVE)
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct SpaceRow {
    pub cells: Vec<SpaceCell>,
    pub arrows: Vec<Value>,
    pub at_work: Option<usize>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct SpaceCell {
    pub name: Value,
    pub space: Space,
    pub place: Option<Value>,
    pub stage: CellStage,
    pub link: Option<Link>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CellStage {
    Done,
    Current,
    ToCome,
}

/// A band from left to right, as high as there is left to do.
#[derive(Clone, PartialEq, Debug)]
pub struct Ribbon {
    pub stages: Vec<RibbonStage>,
    pub at_work: Option<usize>,
    /// The most that any stage of the whole run holds: the scale of all heights.
    pub most: usize,
}

#[derive(Clone, PartialEq, Debug)]
pub struct RibbonStage {
    pub title: Message,
    pub counts: Message,
    pub amount: usize,
    /// What the gate has taken away, or added: written at it, `−166`, once it is known.
    pub change: Option<i64>,
    pub is_to_come: bool,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Story {
    pub title: Value,
    pub cards: Vec<StoryCard>,
    pub opening: (f64, Value),
    pub held: Value,
    pub down: Value,
    pub is_reversed: bool,
}

#[derive(Clone, PartialEq, Debug)]
pub struct StoryCard {
    pub name: Value,
    pub tone: (Role, f64),
    pub new: (f64, Value),
    /// `< 0.7846`: how that compares to what stands there.
    pub against: Value,
    pub fate: StoryFate,
    pub word: Value,
    pub stage: CellStage,
    pub link: Option<Link>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StoryFate {
    Kept,
    Lost,
    Tie,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Raster {
    pub title: Value,
    /// What stands in its place where its numbers have no room.
    pub bare: Option<Value>,
    /// Columns and rows, each at least 1.
    pub size: [usize; 2],
    pub pixels: Vec<Pixel>,
    pub scale: Option<[Value; 2]>,
    /// What is written under the columns.
    pub under: Vec<Value>,
    /// The pixel that this step is about, by column and row.
    pub current: Option<[usize; 2]>,
    pub over: Vec<RasterMark>,
}

/// Places are counted in pixels from the top left corner: the middle of the first pixel is (½, ½).
#[derive(Clone, PartialEq, Debug)]
pub struct RasterMark {
    pub role: Role,
    pub shape: RasterShape,
}

impl RasterMark {
    pub const fn is_line(&self) -> bool {
        matches!(self.shape, RasterShape::Line(_) | RasterShape::Bar(_))
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RasterShape {
    Line([[f64; 2]; 2]),
    /// A length that is measured.
    Bar([[f64; 2]; 2]),
    Dot([f64; 2]),
    Ring([f64; 2]),
    /// What is not so: another surface is in front there, another pixel is taken.
    Cross([f64; 2]),
    /// Over the whole pixel: it is not agreed about.
    Hatch([f64; 2]),
}

#[derive(Clone, PartialEq, Debug)]
pub struct Pixel {
    pub role: Option<Role>,
    /// How dark, from 0 to 1: a depth, an order.
    pub shade: f64,
    pub value: Option<Value>,
}

impl Pixel {
    pub const EMPTY: Self = Self {
        role: None,
        shade: 0.0,
        value: None,
    };
}

impl Raster {
    /// Each pixel is about the one with its number under this name, row by row.
    pub const LINK: &'static str = "raster-pixel";

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
            bare: None,
            size: [3, 2],
            pixels: pixels.collect(),
            scale: None,
            under: Vec::new(),
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
