//! How the surfaces of a scene are drawn pixel by pixel.

use crate::algo::surface::{DepthFormat, DepthSteps};

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RasterPlan {
    rows: u32,
    pub format: DepthFormat,
    pub steps: DepthSteps,
    /// Are faces that show their back left out?
    pub culls_backs: bool,
    /// Triangles come in an order that this number shuffles them into, or in that of the scene.
    pub shuffle: Option<u64>,
    /// The pixel that is looked at, by column and row; one that the raster has not is none.
    pub pixel: Option<[u32; 2]>,
    pub tones: Tones,
    /// Where the near plane was before it moved: depths over distances are drawn of both.
    pub near_before: Option<f64>,
}

/// What the pixels of a depth buffer tell, by tone and in writing.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Tones {
    /// The depth as it is stored.
    #[default]
    Depth,
    /// The distance that it stands for.
    Distance,
    /// Whose they are.
    Triangles,
    /// How often each has been computed.
    Counts,
    /// How bright each is, where surfaces let light through.
    Brightness,
}

impl Default for RasterPlan {
    fn default() -> Self {
        Self {
            rows: 12,
            format: DepthFormat::default(),
            steps: DepthSteps::default(),
            culls_backs: false,
            shuffle: None,
            pixel: None,
            tones: Tones::default(),
            near_before: None,
        }
    }
}

impl RasterPlan {
    pub const ROWS: std::ops::RangeInclusive<u32> = 4..=120;
    /// As many has a whole picture, where its pixels are asked about.
    pub const PICTURE_ROWS: u32 = 480;
    const MOST_COLUMNS: f64 = 160.0;

    /// Of so many rows, as far as a raster may have them.
    pub fn with_rows(self, rows: u32) -> Self {
        let rows = rows.clamp(*Self::ROWS.start(), *Self::ROWS.end());
        Self { rows, ..self }
    }

    /// Rows as they were asked for.
    pub const fn rows(&self) -> u32 {
        self.rows
    }

    /// Have pixels no room for numbers, so that tones alone tell how deep they are?
    pub fn is_toned_alone(&self) -> bool {
        const MOST_NUMBERED: u32 = 24;
        self.rows > MOST_NUMBERED && matches!(self.tones, Tones::Depth | Tones::Distance)
    }

    /// Columns and rows for a camera of this shape: pixels are square, unless it is very wide or very narrow.
    pub fn size(&self, aspect: f64) -> [u32; 2] {
        let rows = f64::from(self.rows)
            .min(Self::MOST_COLUMNS / aspect)
            .max(1.0);
        let columns = (aspect * rows.floor())
            .round()
            .clamp(1.0, Self::MOST_COLUMNS);
        [columns as u32, rows as u32]
    }
}
