//! Lengths as text.

/// A length in points: a hundredth is finer than any screen.
pub fn number(value: f32) -> String {
    let hundredths = (f64::from(value) * 100.0).round();
    let text = format!("{:.2}", hundredths / 100.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}
