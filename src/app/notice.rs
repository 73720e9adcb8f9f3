//! Messages over the stage: what went right for a moment, what went wrong until it is dismissed.

/// How long good news stays, in seconds.
const PASSING_SECS: f64 = 5.0;
/// More are dropped, the oldest first.
const MAX_NOTICES: usize = 4;

/// A message.
#[derive(Clone, PartialEq, Debug)]
pub struct Notice {
    /// In the reader's language.
    pub text: String,
    /// Does it tell of a problem, with lines of a file in it?
    pub is_problem: bool,
    until: Option<f64>,
}

impl Notice {
    /// Stays until it is dismissed.
    pub const fn problem(text: String) -> Self {
        Self {
            text,
            is_problem: true,
            until: None,
        }
    }

    /// Stays while something goes on.
    #[cfg(not(target_arch = "wasm32"))]
    pub const fn lasting(text: String) -> Self {
        Self {
            text,
            is_problem: false,
            until: None,
        }
    }

    /// Goes away by itself.
    pub const fn passing(text: String, now: f64) -> Self {
        Self {
            text,
            is_problem: false,
            until: Some(now + PASSING_SECS),
        }
    }
}

/// The messages that are shown.
#[derive(Clone, Debug, Default)]
pub struct Notices(Vec<Notice>);

impl Notices {
    /// Shows one more.
    pub fn push(&mut self, notice: Notice) {
        self.0.retain(|old| old.text != notice.text);
        self.0.push(notice);
        let surplus = self.0.len().saturating_sub(MAX_NOTICES);
        self.0.drain(..surplus);
    }

    /// Takes all away.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Is there none?
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Oldest first.
    pub fn shown(&self) -> &[Notice] {
        &self.0
    }

    /// Takes away what has been seen; seconds until the next one goes.
    pub fn expire(&mut self, now: f64) -> Option<f32> {
        self.0
            .retain(|notice| notice.until.is_none_or(|until| until > now));
        let next = self
            .0
            .iter()
            .filter_map(|notice| notice.until)
            .reduce(f64::min);
        next.map(|until| (until - now) as f32)
    }
}
