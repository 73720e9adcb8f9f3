//! Handles: the places on a stage that a person takes hold of, with the pointer or with the keyboard.

use egui::{Event, EventFilter, Key, Role};

use super::prelude::*;

const LEAP: f64 = 10.0;
/// Parts of the grid.
const FINER: [f64; 3] = [0.5, 0.2, 0.1];
const FINE: f64 = 0.1;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Snap {
    /// It comes to lie on the grid: a point.
    Place,
    /// It moves by whole grid steps: a figure as a whole, whose own points keep their offsets.
    Offset,
}

#[allow(
    clippy::struct_excessive_bools,
    reason = "each is so or not whatever the others are"
)]
#[derive(Clone, PartialEq, Debug)]
pub struct Spot {
    /// Which of its owner's handles it is: a canvas need not know them all.
    pub index: usize,
    pub at: [f64; 2],
    pub name: String,
    /// Its coordinates in the world, or the one number that it stands for.
    pub place: Value,
    pub locked: bool,
    /// Does the lesson ask for it? It is shown then without the pointer, by its name.
    pub asked: bool,
    /// What it is a handle of.
    pub link: Option<Link>,
    pub snap: Snap,
    /// Has a mark of its own on the stage: nothing is drawn for it until it is touched.
    pub marked: bool,
    /// It was taken hold of last: keys are about it.
    pub selected: bool,
}

/// What moved a handle: moves of one gesture are undone together.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Gesture {
    Drag,
    /// So many lines of the grid, or steps of space.
    Nudge(f64),
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Moved {
    pub spot: usize,
    pub to: [f64; 2],
    /// Away from the eye, in the world's units; on the plane nothing is.
    pub deeper: f64,
    pub by: Gesture,
    /// It leaves the grid.
    pub is_free: bool,
}

#[derive(Clone, Copy, Default)]
struct Grip {
    spot: usize,
    spot_at: [f64; 2],
    pointer_at: [f64; 2],
    /// Has it left the grid? It stays off it, so that letting go of the key moves nothing.
    is_free: bool,
}

pub(super) struct Handles<'a> {
    pub id: Id,
    pub spots: &'a [Spot],
    pub viewport: &'a Viewport,
    pub grid: f64,
    pub snap: bool,
    /// It is a drawing of space: what a drag rounds is not the place on it, and handles are named.
    pub is_space: bool,
    /// The one whose drawing is under the pointer.
    pub pointed: Option<usize>,
    /// A press this near to a handle takes it, in points.
    pub reach: f32,
    pub look: Look<'a>,
}

impl Handles<'_> {
    pub fn spot(&self, index: usize) -> Option<&Spot> {
        self.spots.iter().find(|spot| spot.index == index)
    }

    /// `pressed` is the one whose drawing the button went down on.
    pub fn interact(
        &self,
        ui: &mut Ui,
        canvas: &Response,
        pressed: Option<usize>,
    ) -> Option<Moved> {
        if canvas.drag_started_by(egui::PointerButton::Primary)
            && let Some(origin) = ui.input(|i| i.pointer.press_origin())
            && let Some(spot) = self.held(ui, origin, pressed).and_then(|i| self.spot(i))
        {
            self.take(ui, spot.index);
            let grip = Grip {
                spot: spot.index,
                spot_at: spot.at,
                pointer_at: self.viewport.to_world(origin),
                is_free: false,
            };
            ui.data_mut(|data| data.insert_temp(self.id, grip));
        }
        if !canvas.dragged() && !canvas.drag_stopped() {
            self.let_go(ui);
        }
        let dragged = self.drag(ui, canvas);
        let nudged = self.focus(ui);
        dragged.or(nudged)
    }

    pub fn let_go(&self, ui: &Ui) {
        ui.data_mut(|data| data.remove_temp::<Grip>(self.id));
    }

    fn drag(&self, ui: &Ui, canvas: &Response) -> Option<Moved> {
        let mut grip = grip(ui, self.id)?;
        let spot = self.spot(grip.spot).filter(|spot| !spot.locked)?;
        let pointer = self.viewport.to_world(canvas.interact_pointer_pos()?);
        if is_off_grid(ui) {
            grip.is_free = true;
            ui.data_mut(|data| data.insert_temp(self.id, grip));
        }
        let is_free = !self.snap || grip.is_free;
        let exact = std::array::from_fn(|i| grip.spot_at[i] + pointer[i] - grip.pointer_at[i]);
        let to = std::array::from_fn(|i| {
            let by = pointer[i] - grip.pointer_at[i];
            match spot.snap {
                _ if is_free || self.is_space => exact[i],
                Snap::Place => snapped(exact[i], self.grid),
                Snap::Offset => grip.spot_at[i] + snapped(by, self.grid),
            }
        });
        let to = match spot.snap {
            Snap::Place if !is_free && !self.is_space => self.in_sight(to, exact),
            _ => to,
        };
        (to != spot.at).then_some(Moved {
            spot: grip.spot,
            to,
            deeper: 0.0,
            by: Gesture::Drag,
            is_free,
        })
    }

    /// The place itself where it can be seen, else the nearest on a finer grid that can be: what is dragged does not leave the
    /// picture that the pointer is in.
    fn in_sight(&self, to: [f64; 2], exact: [f64; 2]) -> [f64; 2] {
        let is_seen = |at: &[f64; 2]| self.viewport.rect.contains(self.viewport.to_screen(*at));
        let finer = FINER.map(|part| exact.map(|x| snapped(x, part * self.grid)));
        let mut places = std::iter::once(to).chain(finer);
        places.find(is_seen).unwrap_or(to)
    }

    fn focus(&self, ui: &mut Ui) -> Option<Moved> {
        let mut moved = None;
        for spot in self.spots {
            let i = spot.index;
            let id = self.id_of(i);
            let centre = self.viewport.to_screen(spot.at);
            let place = Rect::from_center_size(centre, Vec2::splat(24.0));
            let response = ui.interact(place, id, Sense::focusable_noninteractive());
            response.widget_info(|| {
                let label = Message::new("access-handle").with("name", spot.name.clone());
                let label = self
                    .look
                    .catalog
                    .message(&label.with("point", spot.place.clone()));
                WidgetInfo::labeled(Role::Button, !spot.locked, label)
            });
            if response.gained_focus() {
                self.take(ui, i);
            }
            if response.has_focus() {
                // An arrow moves the handle, and not the focus.
                let arrows = EventFilter {
                    horizontal_arrows: true,
                    vertical_arrows: true,
                    ..EventFilter::default()
                };
                ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
                let presses = nudge(ui);
                let [dx, dy, deeper] = presses.map(|by| by * self.grid);
                if presses != [0.0; 3] && !spot.locked {
                    moved = Some(Moved {
                        spot: i,
                        to: [spot.at[0] + dx, spot.at[1] + dy],
                        deeper,
                        by: Gesture::Nudge(presses.into_iter().map(f64::abs).fold(0.0, f64::max)),
                        is_free: true,
                    });
                }
            }
        }
        moved
    }

    pub fn id_of(&self, spot: usize) -> Id {
        spot_id(self.id, spot)
    }

    /// Draws the handles that nobody has touched, fainter than what the step shows and under it.
    pub fn draw_idle(&self, ui: &Ui, painter: &Painter, canvas: &Response) {
        let focused = ui.memory(egui::Memory::focused);
        let touched = self.touched(ui, canvas);
        let mut spots = self.spots.iter();
        let has_focus = spots.any(|spot| focused == Some(self.id_of(spot.index)));
        let are_shown = canvas.hovered() || has_focus;
        let theme = self.look.theme;
        for spot in self.spots {
            // A figure as a whole shows its handle only when it is touched: labels stand in its middle.
            let is_shown = spot.asked || (are_shown && spot.snap == Snap::Place);
            let is_idle = is_shown && !spot.selected && touched != Some(spot.index);
            if is_idle && !spot.locked && !spot.marked {
                let colour = if self.is_space {
                    theme.soft
                } else {
                    theme.faint
                };
                self.square(
                    painter,
                    spot,
                    if spot.asked { theme.accent } else { colour },
                );
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
            let held = gripped(ui, self.id).is_some();
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

    fn square(&self, painter: &Painter, spot: &Spot, colour: Color32) {
        let theme = self.look.theme;
        let centre = self.viewport.to_screen(spot.at);
        let side = if self.is_space { 12.0 } else { 7.0 };
        let square = Rect::from_center_size(centre, Vec2::splat(side));
        let rim = theme.stroke(1.25, colour);
        let (ground, full) = (theme.background, theme.accent);
        let fill = if spot.selected { full } else { ground };
        painter.rect_filled(square, 1.0, fill);
        painter.rect_stroke(square, 1.0, rim, StrokeKind::Middle);
    }

    pub fn coordinates(&self, ui: &Ui, canvas: &Response, grid: f64) -> Option<String> {
        if let Some(spot) = self.touched(ui, canvas).and_then(|i| self.spot(i)) {
            return Some(self.told(spot));
        }
        // A pixel is no place: as many digits as can be told apart.
        let at = self.viewport.to_world(canvas.hover_pos()?);
        let at = at.map(|x| snapped(x, grid / 20.0));
        Some(
            self.look
                .catalog
                .alike(Notation::Decimals)
                .value(&at.into()),
        )
    }

    /// Its name and where it is.
    pub fn told(&self, spot: &Spot) -> String {
        let catalog = self.look.catalog.alike(Notation::Decimals);
        format!("{} {}", spot.name, catalog.value(&spot.place))
    }
}

/// Are the keys held that let a drag leave the grid? Window managers may keep Alt and the pointer for themselves.
pub(super) fn is_off_grid(ui: &Ui) -> bool {
    ui.input(|input| input.modifiers.shift || input.modifiers.alt)
}

fn grip(ui: &Ui, id: Id) -> Option<Grip> {
    ui.data(|data| data.get_temp(id))
}

/// What a handle is to egui: not the canvas with a number, which a tooltip of the canvas is.
pub fn spot_id(canvas: Id, spot: usize) -> Id {
    canvas.with(("spot", spot))
}

pub fn gripped(ui: &Ui, id: Id) -> Option<usize> {
    grip(ui, id).map(|grip| grip.spot)
}

pub fn snapped(x: f64, grid: f64) -> f64 {
    // Dividing first keeps decimal steps decimal: 3 · 0.1 is not 0.3, 3 / 10 is.
    let per_unit = (1.0 / grid).round();
    if grid < 1.0 && per_unit >= 1.0 {
        (x / grid).round() / per_unit
    } else {
        (x / grid).round() * grid
    }
}

/// The way that the pressed arrows go together, in lines of the grid, and full stop and comma, away from the eye and back; the
/// presses are consumed.
fn nudge(ui: &Ui) -> [f64; 3] {
    let mut by = [0.0; 3];
    ui.input_mut(|input| {
        input.events.retain(|event| {
            let &Event::Key {
                key,
                modifiers,
                pressed: true,
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
                *by += direction * factor;
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
        let cases = [[0.29, 0.1, 0.3], [0.74, 0.5, 0.5], [-0.76, 0.5, -1.0]];
        let others = [[17.0, 5.0, 15.0], [0.149, 0.05, 0.15]];
        for [x, grid, expected] in cases.into_iter().chain(others) {
            assert_eq!(snapped(x, grid), expected, "{x} on a grid of {grid}");
        }
    }
}
