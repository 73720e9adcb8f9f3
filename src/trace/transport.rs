//! The cursor: stepping, seeking and playing through a recording, without a clock.

/// Where in a recording of `n_steps` events the reader stands, and whether it is playing. Position 0 is before the first event.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Transport {
    position: usize,
    n_steps: usize,
    playing: bool,
    /// Steps a second.
    speed: f32,
    /// Part of a step already waited for.
    waited: f32,
}

impl Transport {
    /// Steps a second that the app offers: slow enough to read aloud, fast enough to skim.
    pub const SPEEDS: [f32; 5] = [0.25, 0.5, 1.0, 2.0, 4.0];

    /// At the start of a recording of `n_steps` events.
    #[must_use]
    pub const fn new(n_steps: usize) -> Self {
        Self {
            position: 0,
            n_steps,
            playing: false,
            speed: 1.0,
            waited: 0.0,
        }
    }

    /// Events folded so far.
    #[must_use]
    pub const fn position(&self) -> usize {
        self.position
    }

    /// Events in the recording.
    #[must_use]
    pub const fn n_steps(&self) -> usize {
        self.n_steps
    }

    /// Is time passing?
    #[must_use]
    pub const fn is_playing(&self) -> bool {
        self.playing
    }

    /// Steps a second.
    #[must_use]
    pub const fn speed(&self) -> f32 {
        self.speed
    }

    /// Goes to a position, or to the end where it lies beyond; stops playing.
    pub fn seek(&mut self, position: usize) {
        self.position = position.min(self.n_steps);
        self.pause();
    }

    /// Goes `by` steps on (back where negative), as far as there are steps; stops playing.
    pub fn step(&mut self, by: isize) {
        self.seek(self.position.saturating_add_signed(by));
    }

    /// Another recording of the same thing: keeps playing, goes to `position`.
    pub fn rebase(&mut self, n_steps: usize, position: usize) {
        self.n_steps = n_steps;
        self.position = position.min(n_steps);
        self.playing &= self.position < n_steps;
    }

    /// Starts playing, from the start where it stood at the end; or stops.
    pub fn toggle(&mut self) {
        if self.playing {
            self.pause();
        } else if self.n_steps > 0 {
            if self.position == self.n_steps {
                self.position = 0;
            }
            self.playing = true;
        }
    }

    /// Stops playing.
    pub fn pause(&mut self) {
        self.playing = false;
        self.waited = 0.0;
    }

    /// Sets the speed in steps a second; a value that is not positive is ignored.
    pub fn set_speed(&mut self, steps_per_sec: f32) {
        if steps_per_sec > 0.0 {
            self.speed = steps_per_sec;
        }
    }

    /// Lets time pass: one step at most, so that a slow frame skips nothing. The seconds until the next step, while playing.
    pub fn advance(&mut self, elapsed_secs: f32) -> Option<f32> {
        if !self.playing {
            return None;
        }
        self.waited += elapsed_secs.max(0.0) * self.speed;
        if self.waited >= 1.0 {
            self.waited = 0.0;
            self.position += 1;
            if self.position >= self.n_steps {
                self.pause();
                return None;
            }
        }
        Some((1.0 - self.waited) / self.speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_stop_at_both_ends() {
        let mut t = Transport::new(3);
        t.step(-1);
        assert_eq!(t.position(), 0);
        t.step(10);
        assert_eq!(t.position(), 3);
        t.seek(1);
        assert_eq!(t.position(), 1);
    }

    #[test]
    fn playing_takes_one_step_at_a_time_and_stops_at_the_end() {
        let mut t = Transport::new(2);
        t.toggle();
        assert_eq!(t.advance(0.5), Some(0.5));
        assert_eq!(t.advance(7.0), Some(1.0));
        assert_eq!(t.position(), 1);
        assert_eq!(t.advance(1.0), None);
        assert_eq!((t.position(), t.is_playing()), (2, false));
        t.toggle();
        assert_eq!((t.position(), t.is_playing()), (0, true));
    }

    #[test]
    fn an_empty_recording_does_not_play() {
        let mut t = Transport::new(0);
        t.toggle();
        assert_eq!((t.is_playing(), t.advance(1.0)), (false, None));
    }

    #[test]
    fn a_shorter_recording_keeps_the_cursor_inside() {
        let mut t = Transport::new(9);
        t.seek(8);
        t.rebase(4, 8);
        assert_eq!((t.position(), t.n_steps()), (4, 4));
    }
}
