//! Numbers as people write them: decimals and fractions.

/// `−1.5, 1/4`, `(2, −3/2)`; none where something is no number. Where semicolons part them, a comma is a decimal point.
pub fn read_numbers(text: &str) -> Option<Vec<f64>> {
    let text = text.trim();
    let opened = text.strip_prefix('(');
    let inner = opened.and_then(|text| text.strip_suffix(')'));
    let text = inner.unwrap_or(text).replace(['−', '–'], "-");
    let mut text = text.replace('，', ",");
    if text.contains(';') {
        text = text.replace(',', ".").replace(';', " ");
    }
    let mut parts: Vec<String> = Vec::new();
    let words = text.replace(',', " ").replace('/', " / ");
    for word in words.split_whitespace() {
        // Around the stroke of a fraction there may be white space.
        let is_open = parts.last().is_some_and(|last| last.ends_with('/'));
        match parts.last_mut() {
            Some(last) if is_open || word == "/" => last.push_str(word),
            _ => parts.push(word.to_owned()),
        }
    }
    parts.iter().map(|part| read_number(part)).collect()
}

fn read_number(text: &str) -> Option<f64> {
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    // `1e-3`, but not `inf` or `nan`.
    let is_written = |part: &str| !part.contains(|c: char| c.is_alphabetic() && !"eE".contains(c));
    let read = |part: &str| part.parse::<f64>().ok().filter(|_| is_written(part));
    let quotient = read(above)? / read(below)?;
    quotient.is_finite().then_some(quotient)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_people_write_is_read_and_what_is_no_number_is_not() {
        for (text, expected) in [
            ("1", vec![1.0]),
            ("−1.5, 1/4", vec![-1.5, 0.25]),
            ("(2; -3/2)", vec![2.0, -1.5]),
            ("1,5; 2", vec![1.5, 2.0]),
            ("3 / 4 -0.5", vec![0.75, -0.5]),
            ("1e-3 , .5", vec![0.001, 0.5]),
            ("", vec![]),
        ] {
            assert_eq!(read_numbers(text), Some(expected), "{text}");
        }
        for text in [
            "（1", "x", "1/0", "1//2", "/2", "inf", "nan, 1", "1/", "0/0", "--1", "1e999",
        ] {
            assert_eq!(read_numbers(text), None, "{text}");
        }
    }
}
