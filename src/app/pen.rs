//! What a presenter shows with the pointer: a ring around it, and lines that are drawn while B is held.

use egui::{LayerId, Order, Sense, Shape};

use super::{App, prelude::*};

const KEY: Key = Key::B;
const RING: f32 = 18.0;
/// Nearer to the last point, in points, the pen has not moved.
const LEAST: f32 = 2.0;

#[derive(Default)]
pub struct Pen {
    lines: Vec<Vec<Pos2>>,
    is_down: bool,
    /// The step of the run that is drawn on.
    step: usize,
}

impl Pen {
    /// Takes up where the pointer is: a line for each time that the key is held. Another step is a clean sheet.
    fn follow(&mut self, ui: &Ui, step: usize) {
        if self.step != step {
            *self = Self {
                step,
                ..Self::default()
            };
        }
        let (is_down, at) = ui.input(|input| (input.key_down(KEY), input.pointer.latest_pos()));
        let at = at.filter(|_| is_down);
        let begins = at.is_some() && !self.is_down;
        self.is_down = at.is_some();
        let Some(at) = at else {
            return;
        };
        if begins {
            self.lines.push(Vec::new());
        }
        if let Some(line) = self.lines.last_mut()
            && line.last().is_none_or(|last| last.distance(at) >= LEAST)
        {
            line.push(at);
        }
    }
}

pub fn show(app: &App, ui: &Ui, pen: &mut Pen) {
    pen.follow(ui, app.position());
    if pen.is_down {
        // It draws on a sheet before all else: with the button pressed, too, nothing is dragged under it.
        let sheet = ui.ctx().content_rect();
        ui.interact(sheet, Id::unique("sheet"), Sense::click_and_drag());
    }
    let theme = app.look().theme;
    let painter = ui
        .ctx()
        .layer_painter(LayerId::new(Order::Tooltip, Id::unique("pen")));
    let stroke = theme.stroke(3.0, theme.signal);
    let lines = pen
        .lines
        .iter()
        .map(|line| Shape::line(line.clone(), stroke));
    painter.extend(lines);
    let pointer = ui.input(|input| input.pointer.latest_pos());
    if let Some(at) = pointer.filter(|_| !app.has_hidden_pointer(ui.ctx())) {
        let ring = theme.stroke(2.5, theme.signal.gamma_multiply(0.5));
        painter.circle_stroke(at, RING, ring);
    }
}

#[cfg(test)]
impl Pen {
    pub fn n_points(&self) -> Vec<usize> {
        self.lines.iter().map(Vec::len).collect()
    }
}
