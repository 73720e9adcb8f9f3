//! Numbers, words and colours as an element's attributes.

use std::fmt::Write;

use crate::export::vector::ink::Ink;

/// A length in points: a hundredth is finer than any screen.
pub fn number(value: f32) -> String {
    let hundredths = (f64::from(value) * 100.0).round();
    let text = format!("{:.2}", hundredths / 100.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

pub fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('"', "&quot;")
}

/// The class of a fill, or of a stroke where `prefix` is `s-`, and what it does not say.
pub fn ink_class(ink: Ink, prefix: &str, property: &str) -> (Option<String>, String) {
    let class = ink.role.map(|role| format!("{prefix}{role}"));
    let mut attributes = String::new();
    if class.is_none() {
        let _ = write!(attributes, " {property}=\"{}\"", ink.hex());
    }
    if !ink.is_opaque() {
        let _ = write!(attributes, " {property}-opacity=\"{:.3}\"", ink.strength());
    }
    (class, attributes)
}
