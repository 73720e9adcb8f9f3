//! A number of a scene in a form: dragged, or typed as people write it.

use std::ops::RangeInclusive;

use egui::{DragValue, Ui};

use crate::{text::read_numbers, widgets::Look};

/// Digits behind the point that are shown.
const DECIMALS: usize = 3;

/// A number with its name before it and its unit behind; the other one that was asked for. One that was typed may lie beyond the
/// range: whether it makes a scene, the scene knows.
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
    let changed = ui
        .horizontal(|ui| {
            let label = ui.label(look.say(name_key));
            let field = DragValue::new(&mut number)
                .speed(speed)
                .suffix(unit)
                .max_decimals(DECIMALS)
                .update_while_editing(false)
                .custom_formatter(|x, _| written(x))
                .custom_parser(|text| read_numbers(text.trim_end_matches('°'))?.first().copied());
            ui.add(field).labelled_by(label.id)
        })
        .inner;
    if changed.dragged() {
        number = number.clamp(*range.start(), *range.end());
    }
    (changed.changed() && number != value).then_some(number)
}

/// `−1.5`, without zeros at the end.
fn written(x: f64) -> String {
    let text = format!("{x:.DECIMALS$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.replace('-', "−")
}
