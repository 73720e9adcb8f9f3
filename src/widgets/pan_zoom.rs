//! Pan and zoom: what part of the world a drawing shows, kept by its owner.

use egui::{Pos2, Rect};

use crate::paint::Viewport;

/// The smallest and the largest scale, as multiples of the one that shows the whole scene.
const SCALES: [f64; 2] = [0.05, 1e6];
/// From the middle of the view to that of the scene, as a part of the view's size, at most.
const IN_VIEW: f64 = 0.45;

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PanZoom {
    pub centre: [f64; 2],
    pub scale: f64,
}

impl PanZoom {
    pub const fn of(viewport: &Viewport) -> Self {
        Self {
            centre: viewport.centre,
            scale: viewport.scale,
        }
    }

    pub const fn on(self, rect: Rect) -> Viewport {
        Viewport {
            rect,
            centre: self.centre,
            scale: self.scale,
        }
    }

    pub fn bounded(self, whole: &Viewport) -> Self {
        let [least, most] = SCALES.map(|by| whole.scale * by);
        let scale = self.scale.clamp(least, most);
        let size = [whole.rect.width(), whole.rect.height()].map(f64::from);
        let centre = std::array::from_fn(|i| {
            // Near, the middle of the view goes all over the scene; from afar, the scene stays in the view.
            let reach = size[i] * (0.5 / whole.scale).max(IN_VIEW / scale);
            self.centre[i].clamp(whole.centre[i] - reach, whole.centre[i] + reach)
        });
        Self { centre, scale }
    }

    pub fn panned(self, by: egui::Vec2) -> Self {
        let [x, y] = [by.x, by.y].map(|by| f64::from(by) / self.scale);
        let centre = [self.centre[0] - x, self.centre[1] + y];
        Self { centre, ..self }
    }

    pub fn zoomed(self, rect: Rect, factor: f64, around: Pos2) -> Self {
        let fixed = self.on(rect).to_world(around);
        let scale = self.scale * factor;
        let kept = self.scale / scale;
        Self {
            centre: std::array::from_fn(|i| fixed[i] + (self.centre[i] - fixed[i]) * kept),
            scale,
        }
    }
}

#[cfg(test)]
mod tests {
    use egui::{pos2, vec2};

    use super::*;

    const RECT: Rect = Rect::from_min_max(Pos2::ZERO, pos2(400.0, 300.0));
    const VIEW: PanZoom = PanZoom {
        centre: [1.0, 2.0],
        scale: 10.0,
    };

    #[test]
    fn zooming_keeps_the_point_under_the_pointer() {
        let pointer = pos2(350.0, 40.0);
        let before = VIEW.on(RECT).to_world(pointer);
        let after = VIEW.zoomed(RECT, 1.5, pointer).on(RECT).to_world(pointer);
        assert!((before[0] - after[0]).abs() < 1e-9 && (before[1] - after[1]).abs() < 1e-9);
    }

    #[test]
    fn what_is_looked_at_stays_in_reach_of_the_scene() {
        let whole = Viewport::fit(RECT, [[-1.0; 2], [1.0; 2]]);
        let lost = PanZoom {
            centre: [1e12, 0.0],
            scale: 1e-12,
        };
        let bounded = lost.bounded(&whole);
        let seen = bounded.on(RECT);
        assert!(seen.rect.contains(seen.to_screen([0.0; 2])), "{bounded:?}");
        assert!(bounded.scale >= whole.scale * SCALES[0]);
        let near = PanZoom::of(&whole).zoomed(RECT, 4.0, RECT.center());
        assert_eq!(near.bounded(&whole), near);
    }

    #[test]
    fn panning_moves_the_world_with_the_pointer() {
        let moved = VIEW.panned(vec2(20.0, 10.0));
        let found = moved.on(RECT).to_screen(VIEW.centre);
        assert_eq!(found, RECT.center() + vec2(20.0, 10.0));
    }
}
