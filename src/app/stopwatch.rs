//! The one seam through which the app measures time: browsers have no `std::time::Instant`.

use web_time::Instant;

/// Measures how long something takes, on this machine, here and now.
pub struct Stopwatch(Instant);

impl Stopwatch {
    /// Starts it.
    pub fn start() -> Self {
        Self(Instant::now())
    }

    /// Since the start.
    pub fn secs(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}
