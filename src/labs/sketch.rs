//! An outline that is drawn by clicking, point by point: no part of the scene until it is closed.

use crate::text::Message;

use super::{OutlineKind, Own};

#[derive(Clone, PartialEq, Debug)]
pub struct Sketch {
    kind: &'static OutlineKind,
    points: Vec<[f64; 2]>,
}

impl Sketch {
    pub const fn new(kind: &'static OutlineKind) -> Self {
        Self {
            kind,
            points: Vec::new(),
        }
    }

    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// One more point; one on the last is none, nor is one beyond all numbers.
    pub fn place(&mut self, at: [f64; 2]) {
        if self.points.last() != Some(&at) && at.iter().all(|c| c.is_finite()) {
            self.points.push(at);
        }
    }

    /// Takes the last point back; false where there was none.
    pub fn take_back(&mut self) -> bool {
        self.points.pop().is_some()
    }

    pub fn can_close(&self) -> bool {
        self.points.len() >= 3
    }

    pub fn change(&self) -> Option<Own> {
        (self.kind.close)(&self.points)
    }

    pub fn hint(&self) -> Message {
        let key = if self.can_close() {
            "draw-close"
        } else {
            self.kind.hint_key
        };
        Message::new(key).with("number", self.points.len() + 1)
    }
}
