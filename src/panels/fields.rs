//! Numbers in a form: one of a scene, dragged or typed as people write it; or how much of something random is asked for next,
//! and from which seed.

use std::{cell::RefCell, ops::RangeInclusive};

use egui::{DragValue, Response, Slider, Ui};

use crate::{
    labs::not_read,
    text::{Catalog, Diagnostic, Notation, Value, read_numbers},
    widgets::Look,
};

/// What came of a field.
pub struct NumberField {
    /// The other number that was asked for.
    pub to: Option<f64>,
    /// Was it typed? Then it may lie beyond the range of dragging: whether it makes a scene, the scene knows.
    pub is_typed: bool,
    /// What was typed is no number.
    pub unread: Option<Diagnostic>,
    pub response: Response,
}

/// A number with its unit behind.
pub fn number_field(
    ui: &mut Ui,
    look: Look<'_>,
    unit: &str,
    value: f64,
    range: &RangeInclusive<f64>,
) -> NumberField {
    let mut number = value;
    // A hundredth of what it is for each point that the pointer moves.
    let speed = (0.01 * value.abs()).max(0.001);
    let unread = RefCell::new(None);
    let field = DragValue::new(&mut number)
        .speed(speed)
        .suffix(unit)
        .update_while_editing(false)
        .custom_formatter(|x, _| written(look.catalog, x))
        .custom_parser(|text| {
            let number = read(text, unit);
            let is_unread = number.is_none() && !text.trim().is_empty();
            *unread.borrow_mut() = is_unread.then(|| not_read(1, text));
            number
        });
    let response = ui.add(field);
    let is_typed = !response.dragged();
    if !is_typed {
        number = number.clamp(*range.start(), *range.end());
    }
    // A field that was visited and left is read as it was rounded for show.
    let is_another = written(look.catalog, number) != written(look.catalog, value);
    NumberField {
        to: is_another.then_some(number),
        is_typed,
        unread: unread.take(),
        response,
    }
}

fn written(catalog: &Catalog, x: f64) -> String {
    catalog.alike(Notation::Decimals).number(x)
}

/// One number, as a decimal or a fraction; a comma is a decimal point.
fn read(text: &str, unit: &str) -> Option<f64> {
    let number = text.trim().trim_end_matches(unit).replace(',', ".");
    match read_numbers(&number)?[..] {
        [number] => Some(number),
        _ => None,
    }
}

const LAST_SEED: u64 = 999_999;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Seeded {
    pub count: usize,
    pub seed: u64,
}

impl Default for Seeded {
    fn default() -> Self {
        Self { count: 12, seed: 1 }
    }
}

impl Seeded {
    /// Two fields, with the catalogue key of the first, and two buttons, with that of the first: this one, and one from
    /// the next seed. Was either asked for?
    pub fn show(
        &mut self,
        ui: &mut Ui,
        look: Look<'_>,
        keys: [&str; 2],
        range: RangeInclusive<usize>,
    ) -> bool {
        self.show_with(ui, look, keys, |ui, count| {
            ui.add(DragValue::new(count).range(range).speed(1.0))
        })
    }

    pub fn show_with(
        &mut self,
        ui: &mut Ui,
        look: Look<'_>,
        [count_key, make_key]: [&str; 2],
        field: impl FnOnce(&mut Ui, &mut usize) -> Response,
    ) -> bool {
        ui.horizontal(|ui| {
            let label = ui.label(look.say(count_key));
            field(ui, &mut self.count).labelled_by(label.id);
        });
        ui.horizontal(|ui| {
            let label = ui.label(look.say("batch-seed"));
            let seed = DragValue::new(&mut self.seed)
                .range(0..=LAST_SEED)
                .speed(0.2);
            ui.add(seed).labelled_by(label.id);
        });
        ui.add_space(4.0);
        if ui.button(look.say(make_key)).clicked() {
            ui.close();
            return true;
        }
        // The menu stays open: who wants another may want one more.
        let again = ui.button(look.say("batch-again")).clicked();
        if again {
            self.seed = (self.seed + 1) % (LAST_SEED + 1);
        }
        again
    }
}

/// So many of something, with the thousands of a large number apart.
pub fn count_slider<'a>(look: Look<'a>, count: &'a mut usize, most: usize) -> Slider<'a> {
    Slider::new(count, 1..=most)
        .logarithmic(true)
        .custom_formatter(move |count, _| look.catalog.value(&Value::Count(count as usize)))
        .custom_parser(|typed| {
            let digits: String = typed.chars().filter(char::is_ascii_digit).collect();
            digits.parse().ok()
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Lang;

    #[test]
    fn what_is_written_is_read_and_so_is_what_people_type() {
        for lang in Lang::ALL {
            let catalog = Catalog::of(lang);
            for x in [0.0, -1.5, 40.0, 0.6, 1000.0, -0.125] {
                assert_eq!(read(&written(catalog, x), ""), Some(x), "{lang}");
            }
        }
        for (text, expected) in [
            ("3/2", Some(1.5)),
            ("0,5", Some(0.5)),
            (" −30° ", Some(-30.0)),
            ("1 2", None),
            ("", None),
            ("wide", None),
        ] {
            assert_eq!(read(text, "°"), expected, "{text}");
        }
    }
}
