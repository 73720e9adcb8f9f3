//! A number of a scene in a form: dragged, or typed as people write it.

use std::ops::RangeInclusive;

use egui::{DragValue, Ui};

use crate::{
    text::{Catalog, Notation, Value, read_numbers},
    widgets::Look,
};

/// A number with its name before it and its unit behind; the other one that was asked for. One that was typed may lie beyond
/// the range of dragging: whether it makes a scene, the scene knows.
pub fn number_field(
    ui: &mut Ui,
    look: Look<'_>,
    (name_key, unit): (&str, &str),
    value: f64,
    range: &RangeInclusive<f64>,
) -> Option<f64> {
    let mut number = value;
    // A hundredth of what it is for each point that the pointer moves.
    let speed = (0.01 * value.abs()).max(0.001);
    let field = ui
        .horizontal(|ui| {
            let label = ui.label(look.say(name_key));
            let field = DragValue::new(&mut number)
                .speed(speed)
                .suffix(unit)
                .update_while_editing(false)
                .custom_formatter(|x, _| written(look.catalog, x))
                .custom_parser(|text| read(text, unit));
            ui.add(field).labelled_by(label.id)
        })
        .inner;
    if field.dragged() {
        number = number.clamp(*range.start(), *range.end());
    }
    // A field that was visited and left is read as it was rounded for show.
    let is_another = written(look.catalog, number) != written(look.catalog, value);
    is_another.then_some(number)
}

fn written(catalog: &Catalog, x: f64) -> String {
    catalog.value_as(&Value::Number(x), Notation::Decimals)
}

/// One number, as a decimal or a fraction; a comma is a decimal point.
fn read(text: &str, unit: &str) -> Option<f64> {
    let number = text.trim().trim_end_matches(unit).replace(',', ".");
    match read_numbers(&number)?[..] {
        [number] => Some(number),
        _ => None,
    }
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
