//! The pixels that a line goes between.

use crate::algo::pipeline::{BresenhamInput, LineToPixelsInput, LineToPixelsState as State};

/// The pixels that a run goes from and to, once they are known.
pub fn ends(input: &LineToPixelsInput, state: &State) -> Option<BresenhamInput> {
    match input {
        LineToPixelsInput::Pixels(ends) => Some(*ends),
        LineToPixelsInput::Segment(_) => {
            let [from, to] = state.rounded?;
            BresenhamInput::new(from, to).ok()
        }
    }
}

/// a and b.
pub fn lengths(ends: &BresenhamInput) -> [u64; 2] {
    let distances = ends.distances();
    let major = ends.major();
    [distances[major], distances[1 - major]]
}
