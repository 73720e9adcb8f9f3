//! What a drawing says of itself to who writes it down as shapes: which parts belong together, and what areas are that are painted as
//! triangles. Without such a listener nothing is added.

use std::sync::Arc;

use egui::{Color32, Context, Id, Painter, Pos2, Rect, Shape, epaint::PaintCallback};

#[derive(Clone, PartialEq, Debug)]
pub enum Note {
    Begin(&'static str),
    End,
    /// The next shape is everything that an odd number of these outlines goes round.
    Area(Vec<Vec<Pos2>>, Color32),
    /// The next shape is a frame inside this rectangle: of this colour at the outer edge, and less and less over this many points.
    Fade(Rect, f32, Color32),
}

fn id() -> Id {
    Id::unique("drawings say what they are")
}

/// From now on, until egui's memory is forgotten.
pub fn listen(ctx: &Context) {
    ctx.data_mut(|data| data.insert_temp(id(), true));
}

fn is_heard(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(id())).unwrap_or(false)
}

impl Note {
    /// That of a shape, if it is one.
    pub fn of(shape: &Shape) -> Option<&Self> {
        match shape {
            Shape::Callback(callback) => callback.callback.downcast_ref(),
            _ => None,
        }
    }

    fn add(self, painter: &Painter) {
        painter.add(PaintCallback {
            rect: Rect::ZERO,
            callback: Arc::new(self),
        });
    }
}

/// All that is drawn in `add` has this name, an SVG file's group.
pub fn group<R>(painter: &Painter, name: &'static str, add: impl FnOnce() -> R) -> R {
    if !is_heard(painter.ctx()) {
        return add();
    }
    Note::Begin(name).add(painter);
    let done = add();
    Note::End.add(painter);
    done
}

/// Says what the shape that is painted next is.
pub fn area(painter: &Painter, outlines: impl FnOnce() -> Vec<Vec<Pos2>>, colour: Color32) {
    if is_heard(painter.ctx()) {
        Note::Area(outlines(), colour).add(painter);
    }
}

/// Says that the shape that is painted next is a frame that fades.
pub fn fade(painter: &Painter, rect: Rect, width: f32, colour: Color32) {
    if is_heard(painter.ctx()) {
        Note::Fade(rect, width, colour).add(painter);
    }
}
