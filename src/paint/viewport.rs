//! From world coordinates to points on the screen and back.

use egui::{Pos2, Rect, vec2};
use glam::DVec2;

/// What part of the world a stage shows: y is up in the world and down on the screen.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Viewport {
    pub rect: Rect,
    pub centre: [f64; 2],
    pub scale: f64,
}

/// Room left around what is fitted: a label stands there. Of a small drawing it is less.
const MARGIN_PTS: f64 = 26.0;

#[cfg(test)]
impl Viewport {
    /// A stage of 200 points a side, with 20 units of the world on it.
    pub const SQUARE: Self = Self {
        rect: Rect::from_min_max(Pos2::ZERO, Pos2::new(200.0, 200.0)),
        centre: [0.0; 2],
        scale: 10.0,
    };
}

impl Viewport {
    pub fn fit(rect: Rect, [min, max]: [[f64; 2]; 2]) -> Self {
        let available = [f64::from(rect.width()), f64::from(rect.height())].map(|s| s.max(1.0));
        let shorter = available[0].min(available[1]);
        let margin = MARGIN_PTS.min(0.15 * shorter);
        let fits = |i: usize| {
            // Bounds of any finite size: halves cannot overflow.
            let half = 0.5 * max[i] - 0.5 * min[i];
            0.5 * (available[i] - 2.0 * margin) / half.max(f64::MIN_POSITIVE)
        };
        Self {
            rect,
            centre: [min[0].midpoint(max[0]), min[1].midpoint(max[1])],
            scale: fits(0).min(fits(1)).clamp(f64::MIN_POSITIVE, 1e12),
        }
    }

    /// What is far outside is moved to where f32 can hold it, in its direction from the centre: lines keep their slope.
    pub fn to_screen(&self, at: [f64; 2]) -> Pos2 {
        const FAR: f64 = 1e6;
        let from_centre = DVec2::from(at) - DVec2::from(self.centre);
        let mut offset = from_centre * DVec2::new(self.scale, -self.scale);
        let largest = offset.abs().max_element();
        if largest > FAR && largest.is_finite() {
            offset *= FAR / largest;
        }
        let offset = offset.clamp(DVec2::splat(-FAR), DVec2::splat(FAR));
        self.rect.center() + vec2(offset.x as f32, offset.y as f32)
    }

    pub fn all_to_screen(&self, points: &[[f64; 2]]) -> Vec<Pos2> {
        points.iter().map(|&p| self.to_screen(p)).collect()
    }

    pub fn to_world(&self, at: Pos2) -> [f64; 2] {
        let offset = at - self.rect.center();
        let offset = DVec2::new(f64::from(offset.x), -f64::from(offset.y));
        (DVec2::from(self.centre) + offset / self.scale).to_array()
    }

    /// Distance of grid lines in world units: 1, 2 or 5 times a power of ten, at least `min_pts` apart.
    pub fn grid_step(&self, min_pts: f64) -> f64 {
        round_step(min_pts / self.scale)
    }
}

/// The least of 1, 2 or 5 times a power of ten that is as large as this.
pub fn round_step(least: f64) -> f64 {
    let power = libm::pow(10.0, libm::log10(least).floor());
    [1.0, 2.0, 5.0, 10.0]
        .map(|m| m * power)
        .into_iter()
        .find(|&step| step >= least)
        .unwrap_or(10.0 * power)
}
