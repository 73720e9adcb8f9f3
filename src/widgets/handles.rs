//! Handles: the places on a stage that a person takes hold of, with the pointer or with the keyboard.

use egui::{
    CursorIcon, Event, EventFilter, Id, Key, Painter, Pos2, Rect, Response, Role, Sense,
    StrokeKind, Ui, Vec2, WidgetInfo,
};

use crate::{paint::Viewport, text::Message};

use super::Look;

/// A finger or a shaky hand finds a handle within this distance, in points.
const REACH: f32 = 14.0;
/// Shift makes a nudge this many grid steps long.
const LEAP: f64 = 10.0;
/// Alt makes a nudge this part of a grid step long.
const FINE: f64 = 0.1;

/// How a handle keeps to the grid.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Snap {
    /// It comes to lie on the grid: a point.
    Place,
    /// It moves by whole grid steps: a figure as a whole, whose own points keep their offsets.
    Offset,
}

/// A handle, as a canvas needs to know it.
#[derive(Clone, PartialEq, Debug)]
pub struct Spot {
    /// Which of its owner's handles it is: a canvas need not know them all.
    pub index: usize,
    /// In the world.
    pub at: [f64; 2],
    /// What it moves, in the reader's language.
    pub name: String,
    /// A lesson holds it in place.
    pub locked: bool,
    /// How it keeps to the grid.
    pub snap: Snap,
    /// Has a mark of its own on the stage: nothing is drawn for it until it is touched.
    pub marked: bool,
    /// It was taken hold of last: keys are about it.
    pub selected: bool,
}

/// What moved a handle: moves of one gesture are undone together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Gesture {
    /// A drag that has just begun, or goes on.
    Drag,
    /// A key.
    Nudge,
}

/// A handle was moved.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Moved {
    /// The [`Spot::index`] of the handle.
    pub spot: usize,
    /// In the world.
    pub to: [f64; 2],
    /// By what.
    pub by: Gesture,
}

/// Where a drag began: lives as long as the button is held.
#[derive(Clone, Copy, Default)]
struct Grip {
    /// The [`Spot::index`] of the handle.
    spot: usize,
    spot_at: [f64; 2],
    pointer_at: [f64; 2],
}

/// The handles of one canvas.
pub(super) struct Handles<'a> {
    pub id: Id,
    pub spots: &'a [Spot],
    pub viewport: &'a Viewport,
    /// Distance of the grid's lines; `None` while snapping is off.
    pub grid: f64,
    pub snap: bool,
    pub look: Look<'a>,
}

impl Handles<'_> {
    /// The index of the nearest handle within reach of a place on the screen.
    pub fn near(&self, at: Pos2) -> Option<usize> {
        let distance = |spot: &Spot| self.viewport.to_screen(spot.at).distance(at);
        (0..self.spots.len())
            .map(|i| (i, distance(&self.spots[i])))
            .filter(|&(_, d)| d <= REACH)
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(i, _)| self.spots[i].index)
    }

    /// The handle that is being dragged.
    pub fn gripped(&self, ui: &Ui) -> Option<usize> {
        gripped(ui, self.id)
    }

    fn spot(&self, index: usize) -> Option<&Spot> {
        self.spots.iter().find(|spot| spot.index == index)
    }

    fn grip(&self, ui: &Ui) -> Option<Grip> {
        grip(ui, self.id)
    }

    /// Drags and key presses since the last frame.
    pub fn interact(&self, ui: &mut Ui, canvas: &Response) -> Option<Moved> {
        self.begin_or_end(ui, canvas);
        let dragged = self.drag(ui, canvas);
        let nudged = self.focus(ui);
        dragged.or(nudged)
    }

    fn begin_or_end(&self, ui: &Ui, canvas: &Response) {
        if canvas.drag_started_by(egui::PointerButton::Primary)
            && let Some(origin) = ui.input(|i| i.pointer.press_origin())
            && let Some(spot) = self.near(origin).and_then(|i| self.spot(i))
        {
            let grip = Grip {
                spot: spot.index,
                spot_at: spot.at,
                pointer_at: self.viewport.to_world(origin),
            };
            ui.data_mut(|data| data.insert_temp(self.id, grip));
        }
        if !canvas.dragged() && !canvas.drag_stopped() {
            ui.data_mut(|data| data.remove_temp::<Grip>(self.id));
        }
    }

    fn drag(&self, ui: &Ui, canvas: &Response) -> Option<Moved> {
        let grip = self.grip(ui)?;
        let spot = self.spot(grip.spot).filter(|spot| !spot.locked)?;
        let pointer = self.viewport.to_world(canvas.interact_pointer_pos()?);
        let free = !self.snap || ui.input(|i| i.modifiers.alt);
        let to = std::array::from_fn(|i| {
            let by = pointer[i] - grip.pointer_at[i];
            match spot.snap {
                _ if free => grip.spot_at[i] + by,
                Snap::Place => snapped(grip.spot_at[i] + by, self.grid),
                Snap::Offset => grip.spot_at[i] + snapped(by, self.grid),
            }
        });
        (to != spot.at).then_some(Moved {
            spot: grip.spot,
            to,
            by: Gesture::Drag,
        })
    }

    /// Lets Tab visit every handle, and arrows move the one that has focus.
    fn focus(&self, ui: &mut Ui) -> Option<Moved> {
        let mut moved = None;
        for spot in self.spots {
            let i = spot.index;
            let id = self.id_of(i);
            let place = Rect::from_center_size(self.viewport.to_screen(spot.at), Vec2::splat(24.0));
            let response = ui.interact(place, id, Sense::focusable_noninteractive());
            response.widget_info(|| {
                let label = Message::new("access-handle")
                    .with("name", spot.name.clone())
                    .with("point", spot.at);
                WidgetInfo::labeled(
                    Role::Button,
                    !spot.locked,
                    self.look.catalog.message(&label),
                )
            });
            if response.has_focus() {
                keep_arrows(ui, id);
                let [dx, dy] = nudge(ui, self.grid);
                if [dx, dy] != [0.0; 2] && !spot.locked {
                    moved = Some(Moved {
                        spot: i,
                        to: [spot.at[0] + dx, spot.at[1] + dy],
                        by: Gesture::Nudge,
                    });
                }
            }
        }
        moved
    }

    /// The widget id of the handle with this index.
    pub fn id_of(&self, spot: usize) -> Id {
        self.id.with(spot)
    }

    /// Draws the handles that need it, and the ring of the one that is touched. Sets the cursor.
    pub fn draw(&self, ui: &Ui, painter: &Painter, canvas: &Response) {
        let theme = self.look.theme;
        let focused = ui.memory(egui::Memory::focused);
        let pointed = canvas.hover_pos().and_then(|at| self.near(at));
        let touched = self.gripped(ui).or(pointed);
        let is_near = canvas.hovered() || focused.is_some_and(|id| self.owns(id));
        for spot in self.spots {
            let i = spot.index;
            let centre = self.viewport.to_screen(spot.at);
            // A figure as a whole shows its handle only when it is touched: labels stand in its middle.
            let is_shown =
                spot.snap == Snap::Place || touched == Some(i) || focused == Some(self.id_of(i));
            if !spot.locked && !spot.marked && (spot.selected || is_near && is_shown) {
                let square = Rect::from_center_size(centre, Vec2::splat(7.0));
                let (fill, colour) = match (spot.selected, touched == Some(i)) {
                    (true, _) => (theme.accent, theme.accent),
                    (false, true) => (theme.background, theme.accent),
                    (false, false) => (theme.background, theme.soft),
                };
                painter.rect_filled(square, 1.0, fill);
                painter.rect_stroke(square, 1.0, theme.stroke(1.25, colour), StrokeKind::Middle);
            }
            if touched == Some(i) && !spot.locked {
                let wash = theme.accent.gamma_multiply(0.18);
                painter.circle_filled(centre, 12.0, wash);
            }
            if focused == Some(self.id_of(i)) {
                painter.circle_stroke(centre, 13.0, theme.stroke(2.0, theme.accent));
            }
        }
        if let Some(i) = touched {
            let held = self.gripped(ui).is_some();
            ui.set_cursor_icon(match (self.spot(i), held) {
                (Some(spot), _) if spot.locked => CursorIcon::NotAllowed,
                (_, true) => CursorIcon::Grabbing,
                (_, false) => CursorIcon::Grab,
            });
        }
    }

    fn owns(&self, id: Id) -> bool {
        self.spots.iter().any(|spot| self.id_of(spot.index) == id)
    }
}

fn grip(ui: &Ui, id: Id) -> Option<Grip> {
    ui.data(|data| data.get_temp(id))
}

/// The index of the handle of a canvas that is being dragged.
#[must_use]
pub fn gripped(ui: &Ui, id: Id) -> Option<usize> {
    grip(ui, id).map(|grip| grip.spot)
}

/// The nearest number that is on the grid.
pub(super) fn snapped(x: f64, grid: f64) -> f64 {
    // Dividing first keeps decimal steps decimal: 3 · 0.1 is not 0.3, 3 / 10 is.
    let per_unit = (1.0 / grid).round();
    if grid < 1.0 && per_unit >= 1.0 {
        (x / grid).round() / per_unit
    } else {
        (x / grid).round() * grid
    }
}

/// Keeps egui from moving the focus when an arrow is pressed: it moves the handle.
fn keep_arrows(ui: &Ui, id: Id) {
    let arrows = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
}

/// The way that the pressed arrows go together; the presses are consumed.
fn nudge(ui: &Ui, grid: f64) -> [f64; 2] {
    let mut by = [0.0; 2];
    ui.input_mut(|input| {
        input.events.retain(|event| {
            let Event::Key {
                key,
                pressed: true,
                modifiers,
                ..
            } = event
            else {
                return true;
            };
            let direction = match key {
                Key::ArrowLeft => [-1.0, 0.0],
                Key::ArrowRight => [1.0, 0.0],
                Key::ArrowDown => [0.0, -1.0],
                Key::ArrowUp => [0.0, 1.0],
                _ => return true,
            };
            if modifiers.command {
                return true;
            }
            let factor = match (modifiers.shift, modifiers.alt) {
                (_, true) => FINE,
                (true, false) => LEAP,
                (false, false) => 1.0,
            };
            by[0] += direction[0] * factor * grid;
            by[1] += direction[1] * factor * grid;
            false
        });
    });
    by
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapping_gives_the_decimals_that_people_write() {
        for (x, grid, expected) in [
            (0.29, 0.1, 0.3),
            (0.74, 0.5, 0.5),
            (-0.76, 0.5, -1.0),
            (17.0, 5.0, 15.0),
            (0.149, 0.05, 0.15),
        ] {
            assert_eq!(snapped(x, grid), expected, "{x} on a grid of {grid}");
        }
    }
}
