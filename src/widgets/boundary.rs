//! The boundary between a drawing and what stands beside it or under it: it can be dragged, and moved with arrows.

use egui::{EventFilter, Key, Modifiers, PointerButton, Role};

use crate::figure::Boundary;

use super::{composed::rect_of, prelude::*};

const GRIP_PTS: f32 = 12.0;
/// What an arrow does.
const STEP_PTS: f32 = 16.0;

/// By how much what lies beyond it grows, if it is moved; a double click asks for its first size.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum BoundaryMoved {
    Times(f32),
    Home,
}

pub fn boundary(ui: &Ui, look: Look<'_>, id: Id, boundary: &Boundary) -> Option<BoundaryMoved> {
    let gap = rect_of(boundary.gap);
    let size = if boundary.is_upright {
        vec2(GRIP_PTS, gap.height())
    } else {
        vec2(gap.width(), GRIP_PTS)
    };
    let response = ui.interact(
        Rect::from_center_size(gap.center(), size),
        id,
        Sense::click_and_drag(),
    );
    response.widget_info(|| WidgetInfo::labeled(Role::Splitter, true, look.say("stage-boundary")));
    let response = response.on_hover_and_drag_cursor(if boundary.is_upright {
        CursorIcon::ResizeHorizontal
    } else {
        CursorIcon::ResizeVertical
    });
    if response.hovered() || response.dragged() || response.has_focus() {
        let stroke = look.theme.stroke(2.0, look.theme.accent);
        if boundary.is_upright {
            ui.painter().vline(gap.center().x, gap.y_range(), stroke);
        } else {
            ui.painter().hline(gap.x_range(), gap.center().y, stroke);
        }
    }
    if response.double_clicked() {
        return Some(BoundaryMoved::Home);
    }
    let moved = if response.dragged_by(PointerButton::Primary) {
        response.drag_delta()
    } else {
        Vec2::ZERO
    };
    let moved = if boundary.is_upright {
        moved.x
    } else {
        moved.y
    };
    let moved = moved + STEP_PTS * arrows(ui, &response);
    let grown = (boundary.size - moved).max(1.0) / boundary.size.max(1.0);
    (moved != 0.0).then_some(BoundaryMoved::Times(grown))
}

/// Presses to the right and down, less those to the left and up.
fn arrows(ui: &Ui, response: &Response) -> f32 {
    if !response.has_focus() {
        return 0.0;
    }
    let filter = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let pressed = |key| ui.input_mut(|input| input.count_and_consume_key(Modifiers::NONE, key));
    let [right, down, left, up] = [
        Key::ArrowRight,
        Key::ArrowDown,
        Key::ArrowLeft,
        Key::ArrowUp,
    ]
    .map(pressed);
    (right + down) as f32 - (left + up) as f32
}
