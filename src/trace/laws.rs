//! The laws of told runs. Every method joins with one line in a property test.

use std::{convert::Infallible, fmt::Debug};

use super::{
    method::{Listening, Method, Told, silent},
    recording::Recording,
};

/// Checks the laws of a told run: the silent and the recorded run agree, a run that is made again tells the same events, so does
/// one from every copy that was kept, and the number of events keeps its bound.
///
/// # Panics
/// Where a law is broken, in its own words.
pub fn check<M: Method>(input: &M::Input)
where
    M::Input: Debug,
    M::Output: Debug,
    M::Event: Debug,
{
    let recording = Recording::<M>::new(input.clone());
    let output = recording.output();
    assert_eq!(
        silent::<M>(input),
        output,
        "silent and recorded runs agree on {input:?}"
    );
    let n = recording.events().len();
    assert!(
        n <= M::max_events(input),
        "{n} events on {input:?}, more than the stated {}",
        M::max_events(input)
    );
    let start = (0, M::begin(input));
    for (from, held) in std::iter::once(&start).chain(recording.rests()) {
        let (mut n, mut held) = (*from, held.clone());
        let mut same = Listening(|_: &M::Held, event| {
            let told = recording.events().get(n).copied();
            assert_eq!(
                told,
                Some(event),
                "event {n} again, from step {from} of {input:?}"
            );
            n += 1;
            Told::<Infallible>::Continue(())
        });
        let Told::Continue(()) = M::run::<f64, _>(input, &mut held, &mut same);
        assert_eq!(
            n,
            recording.events().len(),
            "all events again, from step {from} of {input:?}"
        );
        assert_eq!(
            M::output(held),
            output,
            "the same answer, from step {from} of {input:?}"
        );
    }
}
