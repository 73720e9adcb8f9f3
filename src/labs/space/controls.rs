//! Numbers of a scene that can be set in the inspector, in sections; a lesson's text leads to one by its id.

mod control;
mod tables;
#[cfg(test)]
mod tests;

use crate::text::Diagnostic;

use super::Scene;
use tables::SECTIONS;

pub use control::{Control, Section};

/// The ids of all that can be set in these sections.
pub fn ids(sections: &[&str]) -> Vec<&'static str> {
    let known = SECTIONS.iter().filter(|it| sections.contains(&it.id));
    let of = |it: &'static Section| {
        let numbers = it.numbers.iter().map(|control| control.id);
        numbers.chain(it.choices.iter().copied())
    };
    known.flat_map(of).collect()
}

pub fn sections(scene: &Scene) -> impl Iterator<Item = &'static Section> {
    SECTIONS.iter().filter(|it| (it.is_there)(scene))
}

/// Sets the number of this place among those that the control has.
pub fn set(scene: &mut Scene, id: &str, place: usize, to: f64) -> Result<(), Diagnostic> {
    let controls = SECTIONS.iter().flat_map(|section| section.numbers);
    let mut controls = controls.filter(|control| place < (control.numbers)(scene).len());
    let control = controls.find(|control| control.id == id);
    control.map_or(Ok(()), |control| (control.set)(scene, place, to))
}
