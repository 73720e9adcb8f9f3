//! Handles: the places on a stage that a person takes hold of, with the pointer or with the keyboard.

use egui::{
    Color32, CursorIcon, Event, EventFilter, Id, Key, Painter, Pos2, Rect, Response, Role, Sense,
    StrokeKind, Ui, Vec2, WidgetInfo,
};

use crate::{
    paint::Viewport,
    text::{Message, Notation},
};

use super::look::Look;

/// A finger or a shaky hand finds a handle within this distance, in points.
const REACH: f32 = 14.0;
/// A press this near to a handle was meant for it: the view does not move.
const MISSED: f32 = 28.0;
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
    /// Away from the eye, in the world's units; on the plane nothing is.
    pub deeper: f64,
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

    /// Was a press there meant for a handle?
    pub fn is_about(&self, at: Pos2) -> bool {
        let mut spots = self.spots.iter();
        spots.any(|spot| self.viewport.to_screen(spot.at).distance(at) <= MISSED)
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
        let free = !self.snap || is_off_grid(ui);
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
            deeper: 0.0,
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
                let [dx, dy, deeper] = nudge(ui, self.grid);
                if [dx, dy, deeper] != [0.0; 3] && !spot.locked {
                    moved = Some(Moved {
                        spot: i,
                        to: [spot.at[0] + dx, spot.at[1] + dy],
                        deeper,
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

    /// Draws the handles that nobody has touched, fainter than what the step shows and under it.
    pub fn draw_idle(&self, ui: &Ui, painter: &Painter, canvas: &Response) {
        let focused = ui.memory(egui::Memory::focused);
        let touched = self.touched(ui, canvas);
        if !canvas.hovered() && !focused.is_some_and(|id| self.owns(id)) {
            return;
        }
        for spot in self.spots {
            // A figure as a whole shows its handle only when it is touched: labels stand in its middle.
            let is_idle = spot.snap == Snap::Place && !spot.selected && touched != Some(spot.index);
            if is_idle && !spot.locked && !spot.marked {
                self.square(painter, spot, self.look.theme.faint);
            }
        }
    }

    /// Draws the handles that are in use, over everything. Sets the cursor, and says where one is and why it stays.
    pub fn draw(&self, ui: &Ui, painter: &Painter, canvas: &Response) {
        let theme = self.look.theme;
        let focused = ui.memory(egui::Memory::focused);
        let touched = self.touched(ui, canvas);
        for spot in self.spots {
            let i = spot.index;
            let is_touched = touched == Some(i) && !spot.locked;
            let centre = self.viewport.to_screen(spot.at);
            if !spot.locked && !spot.marked && (spot.selected || is_touched) {
                self.square(painter, spot, theme.accent);
            }
            if is_touched {
                let wash = theme.accent.gamma_multiply(0.18);
                painter.circle_filled(centre, 12.0, wash);
            }
            if focused == Some(self.id_of(i)) {
                painter.circle_stroke(centre, 13.0, theme.stroke(2.0, theme.accent));
            }
        }
        if let Some(spot) = touched.and_then(|i| self.spot(i)) {
            let held = self.gripped(ui).is_some();
            ui.set_cursor_icon(match (spot.locked, held) {
                (true, _) => CursorIcon::NotAllowed,
                (false, true) => CursorIcon::Grabbing,
                (false, false) => CursorIcon::Grab,
            });
            if spot.locked {
                let why = Message::new("handle-locked").with("name", spot.name.clone());
                let why = self.look.catalog.message(&why);
                canvas.clone().on_hover_text_at_pointer(why);
            }
        }
    }

    fn touched(&self, ui: &Ui, canvas: &Response) -> Option<usize> {
        let pointed = canvas.hover_pos().and_then(|at| self.near(at));
        self.gripped(ui).or(pointed)
    }

    fn square(&self, painter: &Painter, spot: &Spot, colour: Color32) {
        let theme = self.look.theme;
        let centre = self.viewport.to_screen(spot.at);
        let square = Rect::from_center_size(centre, Vec2::splat(7.0));
        let fill = if spot.selected {
            theme.accent
        } else {
            theme.background
        };
        painter.rect_filled(square, 1.0, fill);
        painter.rect_stroke(square, 1.0, theme.stroke(1.25, colour), StrokeKind::Middle);
    }

    /// Where the pointer is, or the handle that is held: its coordinates.
    pub fn coordinates(&self, ui: &Ui, canvas: &Response, grid: f64) -> Option<String> {
        let point = |at: [f64; 2]| {
            let catalog = self.look.catalog;
            catalog.value_as(&at.into(), Notation::Decimals)
        };
        if let Some(spot) = self.touched(ui, canvas).and_then(|i| self.spot(i)) {
            return Some(format!("{} {}", spot.name, point(spot.at)));
        }
        // A pixel is no place: as many digits as can be told apart.
        let at = self.viewport.to_world(canvas.hover_pos()?);
        Some(point(at.map(|x| snapped(x, grid / 20.0))))
    }

    fn owns(&self, id: Id) -> bool {
        self.spots.iter().any(|spot| self.id_of(spot.index) == id)
    }
}

/// Are the keys held that let a drag leave the grid? Window managers may keep Alt and the pointer for themselves.
pub(super) fn is_off_grid(ui: &Ui) -> bool {
    ui.input(|input| input.modifiers.shift || input.modifiers.alt)
}

fn grip(ui: &Ui, id: Id) -> Option<Grip> {
    ui.data(|data| data.get_temp(id))
}

/// The index of the handle of a canvas that is being dragged.
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

/// The way that the pressed arrows go together, and full stop and comma, away from the eye and back; the presses are
/// consumed.
fn nudge(ui: &Ui, grid: f64) -> [f64; 3] {
    let mut by = [0.0; 3];
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
                Key::ArrowLeft => [-1.0, 0.0, 0.0],
                Key::ArrowRight => [1.0, 0.0, 0.0],
                Key::ArrowDown => [0.0, -1.0, 0.0],
                Key::ArrowUp => [0.0, 1.0, 0.0],
                Key::Period => [0.0, 0.0, 1.0],
                Key::Comma => [0.0, 0.0, -1.0],
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
            for (by, direction) in by.iter_mut().zip(direction) {
                *by += direction * factor * grid;
            }
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
