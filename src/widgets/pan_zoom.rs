//! Pan and zoom: what part of the world a drawing shows, kept by its owner.

use egui::{Pos2, Rect};

use crate::paint::Viewport;

/// The smallest and the largest scale, as multiples of the one that shows the whole scene.
const SCALES: [f64; 2] = [0.05, 1e6];
/// From the middle of the view to that of the scene, as a part of the view's size, at most.
const IN_VIEW: f64 = 0.45;

/// What part of the world a canvas shows, kept by its owner.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PanZoom {
    /// The world point in the middle.
    pub centre: [f64; 2],
    /// Points on the screen for one unit of the world.
    pub scale: f64,
}

impl PanZoom {
    /// The view of a viewport.
    pub const fn of(viewport: &Viewport) -> Self {
        Self {
            centre: viewport.centre,
            scale: viewport.scale,
        }
    }

    /// This view in a rectangle on the screen.
    pub const fn on(self, rect: Rect) -> Viewport {
        Viewport {
            rect,
            centre: self.centre,
            scale: self.scale,
        }
    }

    /// As near to this as the whole scene stays to be found again.
    pub fn bounded(self, whole: &Viewport) -> Self {
        let scale = self
            .scale
            .clamp(whole.scale * SCALES[0], whole.scale * SCALES[1]);
        let size = [whole.rect.width(), whole.rect.height()].map(f64::from);
        let centre = std::array::from_fn(|i| {
            // Near, the middle of the view goes all over the scene; from afar, the scene stays in the view.
            let reach = size[i] * (0.5 / whole.scale).max(IN_VIEW / scale);
            self.centre[i].clamp(whole.centre[i] - reach, whole.centre[i] + reach)
        });
        Self { centre, scale }
    }

    /// Moved with the pointer, by points on the screen.
    pub fn panned(self, by: egui::Vec2) -> Self {
        Self {
            centre: [
                self.centre[0] - f64::from(by.x) / self.scale,
                self.centre[1] + f64::from(by.y) / self.scale,
            ],
            ..self
        }
    }

    /// Zoomed by a factor; the world point under `around` stays there.
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

    #[test]
    fn zooming_keeps_the_point_under_the_pointer() {
        let view = PanZoom {
            centre: [1.0, 2.0],
            scale: 10.0,
        };
        let pointer = pos2(350.0, 40.0);
        let before = view.on(RECT).to_world(pointer);
        let after = view.zoomed(RECT, 1.5, pointer).on(RECT).to_world(pointer);
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
        let view = PanZoom {
            centre: [0.0; 2],
            scale: 10.0,
        };
        let moved = view.panned(vec2(20.0, 10.0));
        assert_eq!(
            moved.on(RECT).to_screen([0.0; 2]),
            RECT.center() + vec2(20.0, 10.0)
        );
    }
}
