//! Polygons to start from, and regions to clip against.
//!
//! They are drawn for a window from (−1, −1) to (1, 1) and placed about whatever clips in the scene, so that
//! what touches its border touches it there too, to the last bit.

use crate::geom::{GeomError, Polygon, Window, extent};

use super::Scene;

type Box2 = [[f64; 2]; 2];

pub struct Preset {
    pub name_key: &'static str,
    /// x and y of one vertex after the other.
    outline: &'static [f64],
    holes: &'static [&'static [f64]],
}

impl Preset {
    const fn new(name_key: &'static str, outline: &'static [f64]) -> Self {
        Self {
            name_key,
            outline,
            holes: &[],
        }
    }

    /// Its outline and its holes about a box: −1 becomes the box's least coordinate and 1 its greatest, exactly. Where the box is
    /// very large they may leave the numbers.
    pub fn about(&self, [min, max]: Box2) -> Result<(Polygon, Vec<Polygon>), GeomError> {
        let at = |i: usize, c: f64| min[i] * (0.5 - 0.5 * c) + max[i] * (0.5 + 0.5 * c);
        let placed = |numbers: &[f64]| {
            let points = numbers.as_chunks().0.iter();
            let points: Vec<[f64; 2]> = points.map(|&[x, y]| [at(0, x), at(1, y)]).collect();
            Polygon::new(&points)
        };
        let holes = self.holes.iter().map(|hole| placed(hole));
        Ok((placed(self.outline)?, holes.collect::<Result<_, _>>()?))
    }
}

impl Scene {
    pub fn clip_box(&self) -> Box2 {
        let window = [self.window.min().to_array(), self.window.max().to_array()];
        self.clip_in_use()
            .map_or(window, |clip| extent(clip.vertices().iter().copied()))
    }

    /// That box as a window; the scene's own where the clip polygon has no area.
    pub fn clip_window(&self) -> Window {
        let [[xmin, ymin], [xmax, ymax]] = self.clip_box();
        Window::new(xmin, ymin, xmax, ymax).unwrap_or(self.window)
    }
}

/// Polygons to clip, in the order of the menu; outlines counter-clockwise, holes clockwise.
pub static PRESETS: [Preset; 13] = [
    Preset::new(
        "preset-convex",
        &[
            -1.5, -0.5, -0.25, -1.5, 1.25, -0.75, 1.5, 0.5, 0.25, 1.25, -1.0, 1.0,
        ],
    ),
    Preset::new("preset-triangle", &[-1.5, -1.25, 1.75, -0.25, 0.0, 1.75]),
    Preset::new(
        "preset-arrow",
        &[-1.75, -1.25, 1.5, 0.0, -1.75, 1.25, -0.75, 0.0],
    ),
    Preset::new("preset-comb", &COMB),
    Preset::new("preset-corner", &CORNER),
    Preset::new("preset-spiral", &SPIRAL),
    Preset::new("preset-star", &STAR),
    Preset {
        name_key: "preset-hole",
        outline: &[
            -1.5, -0.75, 0.0, -1.5, 1.75, -0.75, 1.75, 0.75, 0.0, 1.5, -1.5, 0.75,
        ],
        holes: &[&[0.25, -0.5, 0.25, 0.5, 1.25, 0.5, 1.25, -0.5]],
    },
    Preset::new(
        "preset-around",
        &[-2.0, -1.75, 2.0, -1.5, 1.75, 1.75, -1.75, 1.5],
    ),
    Preset::new(
        "preset-inside",
        &[-0.75, -0.25, 0.25, -0.75, 0.75, 0.25, -0.25, 0.75],
    ),
    Preset::new("preset-touch", &[1.0, 0.0, 2.0, -0.75, 2.0, 0.75]),
    Preset::new(
        "preset-along",
        &[-1.0, -0.5, 0.5, -0.75, 1.5, 0.25, 0.0, 0.75, -1.0, 0.5],
    ),
    Preset::new(
        "preset-bow-tie",
        &[-1.5, -0.75, 1.5, 0.75, 1.5, -0.75, -1.5, 0.75],
    ),
];

/// Three teeth through the top border; the back stays outside.
const COMB: [f64; 24] = [
    -0.75, -0.5, -0.5, -0.5, -0.5, 1.25, -0.25, 1.25, -0.25, -0.75, 0.25, -0.75, 0.25, 1.25, 0.5,
    1.25, 0.5, -0.5, 0.75, -0.5, 0.75, 1.75, -0.75, 1.75,
];

/// Reaches round the upper right corner: one arm through the top, one through the right.
const CORNER: [f64; 20] = [
    0.25, -0.5, 1.75, -0.5, 1.75, 1.75, -0.5, 1.75, -0.5, 0.25, 0.0, 0.25, 0.0, 1.25, 1.25, 1.25,
    1.25, 0.0, 0.25, 0.0,
];

/// Its outer turn goes along outside the window and within it.
const SPIRAL: [f64; 32] = [
    -1.75, -1.25, 1.25, -1.25, 1.25, 1.25, -1.25, 1.25, -1.25, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5,
    0.5, -0.5, 0.25, 0.25, 0.25, 0.25, -0.25, -0.75, -0.25, -0.75, 0.75, 0.75, 0.75, 0.75, -0.75,
    -1.75, -0.75,
];

const STAR: [f64; 20] = [
    0.0, 1.6, -0.4, 0.5, -1.6, 0.5, -0.65, -0.2, -1.0, -1.35, 0.0, -0.65, 1.0, -1.35, 0.65, -0.2,
    1.6, 0.5, 0.4, 0.5,
];

/// Regions to clip against, in the order of the menu: each fills the box from (−1, −1) to (1, 1).
pub static REGIONS: [Preset; 5] = [
    Preset::new(
        "region-corners",
        &[-1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0],
    ),
    Preset::new("region-triangle", &[-1.0, -1.0, 1.0, -1.0, 0.0, 1.0]),
    Preset::new(
        "region-diamond",
        &[0.0, -1.0, 1.0, 0.0, 0.0, 1.0, -1.0, 0.0],
    ),
    Preset::new(
        "region-octagon",
        &[
            -0.5, -1.0, 0.5, -1.0, 1.0, -0.5, 1.0, 0.5, 0.5, 1.0, -0.5, 1.0, -1.0, 0.5, -1.0, -0.5,
        ],
    ),
    Preset::new(
        "region-bracket",
        &[
            -1.0, -1.0, 1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -1.0, 1.0,
        ],
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::ConvexPolygon;

    fn doubled_area(polygon: &Polygon) -> f64 {
        let edges = polygon.edges();
        edges
            .map(|edge| edge.p1.x() * edge.p2.y() - edge.p2.x() * edge.p1.y())
            .sum()
    }

    #[test]
    fn outlines_turn_left_and_holes_right() {
        for preset in PRESETS.iter().chain(&REGIONS) {
            let (outline, holes) = preset.about([[-1.0; 2], [1.0; 2]]).unwrap();
            let area = doubled_area(&outline);
            let is_bow_tie = preset.name_key == "preset-bow-tie";
            assert!(area > 0.0 || is_bow_tie, "{}: {area}", preset.name_key);
            for hole in holes {
                assert!(doubled_area(&hole) < 0.0, "{}", preset.name_key);
            }
        }
    }

    #[test]
    fn what_touches_a_border_touches_it_about_any_box() {
        let (min, max) = ([0.1, -0.3], [0.7, 1e9]);
        let mut presets = PRESETS.iter();
        let touch = presets.find(|preset| preset.name_key == "preset-touch");
        let (outline, _) = touch.unwrap().about([min, max]).unwrap();
        assert_eq!(outline.vertices()[0].x().to_bits(), max[0].to_bits());
        let (corners, _) = REGIONS[0].about([min, max]).unwrap();
        let expected = [min, [max[0], min[1]], max, [min[0], max[1]]];
        let got: Vec<[f64; 2]> = corners.vertices().iter().map(|p| p.to_array()).collect();
        assert_eq!(got, expected);
    }

    #[test]
    fn all_regions_but_the_last_are_convex() {
        for (i, region) in REGIONS.iter().enumerate() {
            let is_convex = ConvexPolygon::new(region.outline.as_chunks().0).is_ok();
            assert_eq!(is_convex, i + 1 < REGIONS.len(), "{}", region.name_key);
        }
    }
}
