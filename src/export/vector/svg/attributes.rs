//! Numbers, words and colours as an element's attributes.

use std::fmt::Write;

use crate::export::vector::ink::Ink;

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
