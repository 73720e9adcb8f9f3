//! What a run has worked out at a step.

use crate::algo::pipeline::{BresenhamInput, LineToPixelsEvent as Event, LineToPixelsInput};

/// What has been told before the first pixel, and of the last one.
#[derive(Clone, Copy, Default)]
pub struct Known {
    /// Ends in clip space.
    pub projected: [Option<[f64; 4]>; 2],
    /// What is left of them.
    pub clipped: Option<[[f64; 4]; 2]>,
    /// Nothing is left.
    pub is_rejected: bool,
    /// In pixels, with fractions.
    pub screen: Option<[[f64; 2]; 2]>,
    /// The pixels that they lie in.
    pub rounded: Option<[[i64; 2]; 2]>,
    /// e at the last pixel.
    pub error: Option<i64>,
}

impl Known {
    /// After these events.
    pub fn of(past: &[Event]) -> Self {
        let mut known = Self::default();
        for event in past.iter().take(5).chain(past.last()) {
            match *event {
                Event::Project { end, clip } => known.projected[end.idx()] = Some(clip),
                Event::Clip { ends } => known.clipped = Some(ends),
                Event::Reject => known.is_rejected = true,
                Event::Divide { screen } => known.screen = Some(screen),
                Event::Round { from, to } => known.rounded = Some([from, to]),
                Event::Pixel { error, .. } => known.error = Some(error),
            }
        }
        known
    }

    /// The pixels that the run goes from and to, once they are known.
    pub fn ends(&self, input: &LineToPixelsInput) -> Option<BresenhamInput> {
        match input {
            LineToPixelsInput::Pixels(ends) => Some(*ends),
            LineToPixelsInput::Segment(_) => {
                let [from, to] = self.rounded?;
                BresenhamInput::new(from, to).ok()
            }
        }
    }
}
