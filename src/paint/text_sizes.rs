//! How large the text of a window can be.

/// Text can be so many times as large as it is at first.
pub const TEXT_SIZES: [f32; 7] = [0.9, 1.0, 1.1, 1.25, 1.5, 1.75, 2.0];

/// So many of [`TEXT_SIZES`] on from the nearest to `text`.
pub fn text_size(text: f32, by: isize) -> f32 {
    let distance = |i: &usize| (TEXT_SIZES[*i] - text).abs();
    let nearest = (0..TEXT_SIZES.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let at = nearest.unwrap_or_default().saturating_add_signed(by);
    TEXT_SIZES[at.min(TEXT_SIZES.len() - 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_goes_from_size_to_size_and_no_further() {
        assert_eq!([text_size(1.0, 1), text_size(1.0, -1)], [1.1, 0.9]);
        assert_eq!([text_size(2.0, 1), text_size(0.9, -1)], [2.0, 0.9]);
        assert_eq!([text_size(1.33, 0), text_size(17.0, 0)], [1.25, 2.0]);
    }
}
