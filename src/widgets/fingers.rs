//! Fingers: what they reach, and two of them on a drawing.

use egui::{InputState, MultiTouchInfo};

use super::prelude::*;

/// The least side of what a finger presses, in points.
pub const TARGET: f32 = 44.0;

/// The side of something that is pressed, where the style is one for fingers; else this one.
pub fn target(ui: &Ui, natural: f32) -> f32 {
    if ui.spacing().interact_size.x < TARGET {
        natural
    } else {
        natural.max(TARGET)
    }
}

/// How near to a mark a press takes it, where fingers have been seen half of what one covers; else this near.
pub fn reach(ui: &Ui, natural: f32) -> f32 {
    if ui.input(InputState::has_touch_screen) {
        natural.max(0.5 * TARGET)
    } else {
        natural
    }
}

/// What two fingers do to a drawing; whatever one of them does there until the last is gone is neither a drag nor a click.
#[derive(Clone, Copy, Default)]
pub struct Pinch {
    pub is_on: bool,
    /// In this frame.
    pub by: Option<MultiTouchInfo>,
}

impl Pinch {
    pub fn now(ui: &Ui, canvas: Id, rect: Rect) -> Self {
        let id = canvas.with("pinch");
        let (touch, are_down) = ui.input(|input| (input.multi_touch(), input.any_touches()));
        let was_on = ui.data(|data| data.get_temp(id)).unwrap_or(false);
        let is_on = touch.is_some() || (was_on && are_down);
        ui.data_mut(|data| data.insert_temp(id, is_on));
        Self {
            is_on: is_on || was_on,
            by: touch.filter(|touch| rect.contains(touch.center_pos)),
        }
    }
}
