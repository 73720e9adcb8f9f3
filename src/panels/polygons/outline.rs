//! An outline that is drawn by clicking, point by point.

use crate::{geom::Polygon, text::Message};

use super::PolygonsEdit;

/// What an outline will become.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outline {
    /// The subject polygon.
    Subject,
    /// The clip polygon.
    Clip,
    /// One more hole in the subject.
    Hole,
}

impl Outline {
    /// Every one, in the order of the menu, with its catalogue key and its key on the keyboard.
    pub const ALL: [(Self, &'static str, &'static str); 3] = [
        (Self::Subject, "action-draw-subject", "D"),
        (Self::Clip, "action-draw-clip", "C"),
        (Self::Hole, "action-draw-hole", "H"),
    ];
}

/// Half an outline: no part of the document until it is closed.
#[derive(Clone, PartialEq, Debug)]
pub struct Sketch {
    outline: Outline,
    points: Vec<[f64; 2]>,
}

impl Sketch {
    /// Without a point yet.
    #[must_use]
    pub const fn new(outline: Outline) -> Self {
        Self {
            outline,
            points: Vec::new(),
        }
    }

    /// What was placed so far.
    #[must_use]
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

    /// Could it be closed?
    #[must_use]
    pub fn can_close(&self) -> bool {
        self.points.len() >= 3
    }

    /// The change that it comes to, once it has three points.
    #[must_use]
    pub fn edit(&self) -> Option<PolygonsEdit> {
        let polygon = Polygon::new(&self.points).ok()?;
        Some(match self.outline {
            Outline::Subject => PolygonsEdit::Subject(polygon),
            Outline::Clip => PolygonsEdit::Clip(Some(polygon)),
            Outline::Hole => PolygonsEdit::Hole(polygon),
        })
    }

    /// What to do next.
    #[must_use]
    pub fn hint(&self) -> Message {
        let message = match (self.outline, self.can_close()) {
            (Outline::Subject, false) => Message::new("draw-subject"),
            (Outline::Clip, false) => Message::new("draw-clip"),
            (Outline::Hole, false) => Message::new("draw-hole"),
            (_, true) => Message::new("draw-close"),
        };
        message.with("number", self.points.len() + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_points_close_and_a_repeated_one_does_not_count() {
        let mut sketch = Sketch::new(Outline::Hole);
        for at in [[0.0; 2], [0.0; 2], [1.0, 0.0]] {
            sketch.place(at);
        }
        assert_eq!((sketch.edit(), sketch.can_close()), (None, false));
        sketch.place([0.0, 1.0]);
        assert!(matches!(sketch.edit(), Some(PolygonsEdit::Hole(_))));
        for _ in 0..3 {
            assert!(sketch.take_back());
        }
        assert!(!sketch.take_back());
    }
}
