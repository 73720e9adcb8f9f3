//! Lengths as text.

/// A length in points: a hundredth is finer than any screen.
pub fn number(value: f32) -> String {
    // The cast saturates, far beyond any page.
    let hundredths = (f64::from(value) * 100.0).round() as i64;
    let sign = if hundredths < 0 { "-" } else { "" };
    let [whole, part] = [
        hundredths.unsigned_abs() / 100,
        hundredths.unsigned_abs() % 100,
    ];
    match part {
        0 => format!("{sign}{whole}"),
        part if part % 10 == 0 => format!("{sign}{whole}.{}", part / 10),
        part => format!("{sign}{whole}.{part:02}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_at_most_two_decimals_and_nothing_to_spare() {
        let cases = [
            (0.0, "0"),
            (-0.004, "0"),
            (-0.006, "-0.01"),
            (12.0, "12"),
            (-0.5, "-0.5"),
            (3.05, "3.05"),
            (299.999, "300"),
            (1.25, "1.25"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
