//! What a section is, and a number in it.

use std::ops::RangeInclusive;

use crate::{
    labs::space::Scene,
    text::{Diagnostic, Message},
};

pub struct Section {
    pub id: &'static str,
    pub title: fn(&Scene) -> Message,
    pub numbers: &'static [Control],
    /// The ids of what can be set besides.
    pub(super) choices: &'static [&'static str],
    /// Has the scene what it is about?
    pub(super) is_there: fn(&Scene) -> bool,
}

/// One number, or two or three that belong together.
pub struct Control {
    pub id: &'static str,
    pub name: fn() -> Message,
    pub unit: &'static str,
    /// A lesson locks it with the handles of this group.
    pub group: &'static str,
    /// None where the scene has no such thing.
    pub numbers: fn(&Scene) -> Vec<f64>,
    /// As far as dragging takes it; whether one that is typed makes a scene, the scene knows.
    pub range: fn(&Scene) -> RangeInclusive<f64>,
    pub(super) set: fn(&mut Scene, usize, f64) -> Result<(), Diagnostic>,
}

impl Control {
    /// Why the scene does not take this number in this place, if it does not.
    pub fn refusal(&self, scene: &Scene, place: usize, to: f64) -> Option<Diagnostic> {
        let mut tried = scene.clone();
        if let Err(refused) = (self.set)(&mut tried, place, to) {
            return Some(refused);
        }
        let (range, numbers) = ((self.range)(scene), (self.numbers)(&tried));
        if range.contains(&to) || numbers.get(place) == Some(&to) {
            return None;
        }
        let message = Message::new("error-typed-range")
            .with("least", *range.start())
            .with("most", *range.end());
        Some(Diagnostic::new(message.with("typed", to)))
    }
}
