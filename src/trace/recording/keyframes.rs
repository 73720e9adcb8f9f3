//! States kept on the way, so that a seek need not start from the beginning.
//!
//! ```text
//!   steps   0 ──── 256 ──── 512 ──── 768 ──── 1024 ── …      one kept every `interval` steps
//!           ●       ●        ●        ●        ●
//!   full:   ●                ●                 ●             every other one goes, the interval doubles
//! ```
//!
//! A state may be as large as the input: a polygon's holds two lists of vertices. So their number is bounded,
//! whatever the length of the run, and with it what a recording weighs; a seek in a long run folds more events
//! in exchange, each of which is a copy.

/// Steps between two kept states at first: a state of a short run is about as large as ten events, so that
/// keyframes cost a few per cent of the recording.
const FIRST_INTERVAL: usize = 256;

/// No more states than these are kept. A polygon of 10,000 vertices against a window makes some 100,000 events:
/// a seek then folds at most 4,096 of them, which takes tens of microseconds, and its states together weigh
/// about 10 MB.
const MOST_KEPT: usize = 32;

/// At most [`MOST_KEPT`] states, at equal intervals.
#[derive(Clone)]
pub struct Keyframes<S> {
    interval: usize,
    /// After `i · interval` steps.
    kept: Vec<S>,
}

impl<S: Clone> Keyframes<S> {
    /// With the state before the first step.
    pub fn starting_with(state: S) -> Self {
        Self {
            interval: FIRST_INTERVAL,
            kept: vec![state],
        }
    }

    /// Keeps the state after `n_steps` where its turn has come. To be offered every state in order.
    pub fn offer(&mut self, n_steps: usize, state: &S) {
        if n_steps != self.kept.len() * self.interval {
            return;
        }
        if self.kept.len() == MOST_KEPT {
            let mut idx = 0;
            self.kept.retain(|_| {
                idx += 1;
                idx % 2 == 1
            });
            self.interval *= 2;
        }
        // As MOST_KEPT is even, `n_steps` is a multiple of the doubled interval too.
        self.kept.push(state.clone());
    }

    /// The last kept state that is no later than `n_steps`, and after how many steps it stood.
    pub fn before(&self, n_steps: usize) -> (usize, &S) {
        let idx = (n_steps / self.interval).min(self.kept.len() - 1);
        (idx * self.interval, &self.kept[idx])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(n_steps: usize) -> Keyframes<usize> {
        let mut keyframes = Keyframes::starting_with(0);
        for step in 1..=n_steps {
            keyframes.offer(step, &step);
        }
        keyframes
    }

    #[test]
    fn never_more_than_the_bound_and_never_far_apart() {
        for n_steps in [0, 255, 256, 8_191, 8_192, 8_193, 100_000, 1_000_000] {
            let keyframes = after(n_steps);
            let kept = &keyframes.kept;
            assert!(kept.len() <= MOST_KEPT, "{} of {n_steps}", kept.len());
            for (i, &steps) in kept.iter().enumerate() {
                assert_eq!(steps, i * keyframes.interval, "state {i} of {n_steps}");
            }
            let reach = kept.len() * keyframes.interval;
            assert!(reach > n_steps, "one is missing behind step {reach}");
            let half_full = kept.len() >= MOST_KEPT / 2;
            assert!(half_full || keyframes.interval == FIRST_INTERVAL);
        }
    }

    #[test]
    fn a_seek_starts_from_the_last_one_before_it() {
        let keyframes = after(100_000);
        let interval = keyframes.interval;
        for n_steps in [0, 1, interval - 1, interval, interval + 1, 99_999, 100_000] {
            let (steps, &state) = keyframes.before(n_steps);
            assert_eq!(steps, state);
            assert!(steps <= n_steps && n_steps - steps < interval);
        }
    }
}
