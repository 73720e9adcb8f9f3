//! Pan and zoom: what part of the world a drawing shows, kept by its owner.

use egui::{Pos2, Rect};

use crate::paint::Viewport;

/// The largest and the smallest scale, as factors of a view that fits the world's size.
const SCALES: [f64; 2] = [1e-9, 1e9];

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
    #[must_use]
    pub const fn of(viewport: &Viewport) -> Self {
        Self {
            centre: viewport.centre,
            scale: viewport.scale,
        }
    }

    /// This view in a rectangle on the screen.
    #[must_use]
    pub const fn on(self, rect: Rect) -> Viewport {
        Viewport {
            rect,
            centre: self.centre,
            scale: self.scale,
        }
    }

    /// Moved with the pointer, by points on the screen.
    #[must_use]
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
    #[must_use]
    pub fn zoomed(self, rect: Rect, factor: f64, around: Pos2) -> Self {
        let fixed = self.on(rect).to_world(around);
        let scale = (self.scale * factor).clamp(SCALES[0], SCALES[1]);
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
