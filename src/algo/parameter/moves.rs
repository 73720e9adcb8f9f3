//! How far something may be moved along one direction before a border rejects it: a border leaves it room, and a move by s
//! changes that by s · slope.

/// The moves s that all borders allow, of which each is given as its room and its slope; none where they allow no move.
#[must_use]
pub fn moves_allowed(borders: impl IntoIterator<Item = [f64; 2]>) -> Option<[f64; 2]> {
    let [mut low, mut high] = [f64::NEG_INFINITY, f64::INFINITY];
    for [room, slope] in borders {
        if slope > 0.0 {
            low = low.max(-room / slope);
        } else if slope < 0.0 {
            high = high.min(-room / slope);
        } else if room < 0.0 {
            return None;
        }
    }
    (low <= high).then_some([low, high])
}

/// The one that is nearest to none.
pub(in crate::algo) fn nearest_move([low, high]: [f64; 2]) -> Option<f64> {
    let nearest = if low > 0.0 { low } else { high.min(0.0) };
    nearest.is_finite().then_some(nearest)
}

/// The least move outwards beyond which nothing is left, and the border that it crosses, the last of those that are as near;
/// of each border the moves along its normal that leave something.
pub(in crate::algo) fn least_move(
    borders: impl Iterator<Item = (usize, Option<[f64; 2]>)>,
) -> Option<(usize, f64)> {
    let moves = borders.filter_map(|(idx, leave)| Some((idx, leave?[0].min(0.0))));
    let finite = moves.filter(|(_, by)| by.is_finite());
    finite.max_by(|a, b| a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::moves_allowed;

    #[test]
    fn borders_across_leave_an_interval_and_one_beside_decides_alone() {
        let across = [[-1.0, 2.0], [3.0, -1.0]];
        assert_eq!(moves_allowed(across), Some([0.5, 3.0]));
        let beside = |room: f64| [across[0], across[1], [room, 0.0]];
        assert_eq!(moves_allowed(beside(0.0)), Some([0.5, 3.0]));
        assert_eq!(moves_allowed(beside(-1e-300)), None);
        assert_eq!(moves_allowed([[-4.0, 1.0], [3.0, -1.0]]), None);
    }
}
