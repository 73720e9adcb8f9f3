//! The laws of told runs. Every method joins with one line in a property test.

use std::{convert::Infallible, fmt::Debug};

use super::{
    method::{Listening, Method, Told, silent},
    recording::Recording,
};

/// Checks the laws: the silent and the recorded run agree, a run that is made again tells the same events, so does one from
/// every copy that was kept, and the number of events keeps its bound.
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
    let (events, output) = (recording.events(), recording.output());
    let quiet = silent::<M>(input);
    assert_eq!(quiet, output, "silent and recorded runs agree on {input:?}");
    let (n, most) = (events.len(), M::max_events(input));
    assert!(
        n <= most,
        "{n} events on {input:?}, more than the stated {most}"
    );
    let start = (0, M::begin(input));
    for (from, held) in std::iter::once(&start).chain(recording.rests()) {
        let (mut n, mut held) = (*from, held.clone());
        let mut same = Listening(|_: &M::Held, event| {
            let told = events.get(n).copied();
            // A number that is none, of coordinates too large, is not equal to itself.
            assert!(
                told == Some(event) || format!("{told:?}") == format!("{:?}", Some(event)),
                "event {n} is {event:?}, not {told:?}, from step {from} of {input:?}"
            );
            n += 1;
            Told::<Infallible>::Continue(())
        });
        let Told::Continue(()) = M::run::<f64, _>(input, &mut held, &mut same);
        assert_eq!(
            n,
            events.len(),
            "all events again, from step {from} of {input:?}"
        );
        let again = M::output(held);
        assert_eq!(
            again, output,
            "the same answer, from step {from} of {input:?}"
        );
    }
}
