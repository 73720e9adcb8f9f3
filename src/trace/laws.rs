//! The laws of traced execution. Every algorithm joins with one line in a property test.

use std::fmt::Debug;

use super::{Algorithm, Trace, silent};

/// Checks that silent and recorded runs agree, that the folded state holds the answer, that the number
/// of events keeps its bound, and that seeking equals folding.
///
/// # Panics
/// Where a law is broken, in its own words.
pub fn check<A>(input: &A::Input)
where
    A: Algorithm,
    A::Input: Debug,
    A::Output: Debug,
    A::State: PartialEq + Debug,
{
    let trace = Trace::<A>::record(input.clone());
    assert_eq!(
        &silent::<A>(input),
        trace.output(),
        "silent and recorded runs agree on {input:?}"
    );
    let n = trace.events().len();
    assert_eq!(
        &A::finish(&trace.state_at(n)),
        trace.output(),
        "the folded state holds the answer to {input:?}"
    );
    assert!(
        n <= A::max_events(input),
        "{n} events on {input:?}, more than the stated {}",
        A::max_events(input)
    );
    let mut state = A::start(input);
    for (i, &event) in trace.events().iter().enumerate() {
        assert_eq!(
            trace.state_at(i),
            state,
            "seeking to {i} equals folding {i} events of {input:?}"
        );
        A::apply(&mut state, event);
    }
    assert_eq!(
        trace.state_at(n + 1),
        state,
        "seeking past the end stops at the end"
    );
}
