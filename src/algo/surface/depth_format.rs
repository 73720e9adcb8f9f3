//! How a depth is stored: how many bits it is given, and which end of the room is 0.
//!
//! Depth is linear in 1/distance: of its steps most lie close to the near plane. A number of fixed point has steps of one size
//! in depth; a floating-point number has its finest about 0, which is wasted on the near plane unless depth is reversed, so that the
//! far plane is at 0 (N. Reed, "Depth precision visualized", 2015).

use crate::trace::Real;

/// Whole numbers from 0 to 2ᵇ − 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DepthBits(u32);

impl DepthBits {
    /// From 1 to 32 bits; `None` beyond that.
    #[must_use]
    pub fn new(bits: u32) -> Option<Self> {
        (1..=32).contains(&bits).then_some(Self(bits))
    }

    /// As many as there are.
    #[must_use]
    pub const fn get(self) -> u32 {
        self.0
    }

    /// The largest number: depth 1.
    #[must_use]
    pub fn largest(self) -> f64 {
        ((1_u64 << self.0) - 1) as f64
    }
}

/// The numbers that depths are rounded to.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum DepthNumber {
    /// As computed, in f64.
    #[default]
    Double,
    /// f32
    Single,
    /// Steps of 1/(2ᵇ − 1).
    Fixed(DepthBits),
}

impl DepthNumber {
    /// What one takes.
    #[must_use]
    pub const fn n_bits(self) -> u32 {
        match self {
            Self::Double => 64,
            Self::Single => 32,
            Self::Fixed(bits) => bits.get(),
        }
    }
}

/// How a depth is stored.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct DepthFormat {
    /// By which numbers.
    pub number: DepthNumber,
    /// Is 1 the near plane, and 0 the far plane?
    pub is_reversed: bool,
}

impl DepthFormat {
    /// What stands in the buffer for a depth from 0 on the near plane to 1 on the far plane.
    #[must_use]
    pub fn stored(&self, depth: f64) -> f64 {
        let turned = self.turned(depth);
        match self.number {
            DepthNumber::Double => turned,
            DepthNumber::Single => f64::from(turned as f32),
            DepthNumber::Fixed(bits) => (turned * bits.largest()).round() / bits.largest(),
        }
    }

    /// The other way round where depth is reversed: from a depth to what is stored, before that is rounded, and back.
    #[must_use]
    pub const fn turned(&self, depth: f64) -> f64 {
        if self.is_reversed { 1.0 - depth } else { depth }
    }

    /// Where nothing has been written: farther than everything.
    #[must_use]
    pub const fn nothing(&self) -> f64 {
        if self.is_reversed {
            f64::NEG_INFINITY
        } else {
            f64::INFINITY
        }
    }

    /// What is stored for the near plane.
    #[must_use]
    pub const fn nearest(&self) -> f64 {
        if self.is_reversed { 1.0 } else { 0.0 }
    }

    /// From one depth that can be stored to the next one away from the eye, at this depth.
    #[must_use]
    pub fn step(&self, depth: f64) -> f64 {
        let stored = self.stored(depth);
        let next = |up: f64, down: f64| {
            if self.is_reversed {
                stored - down
            } else {
                up - stored
            }
        };
        match self.number {
            DepthNumber::Double => next(stored.next_up(), stored.next_down()),
            DepthNumber::Single => {
                let single = stored as f32;
                next(single.next_up().into(), single.next_down().into())
            }
            DepthNumber::Fixed(bits) => 1.0 / bits.largest(),
        }
    }

    /// Is a new depth, of two as they are stored, the nearer one?
    pub fn is_nearer<R: Real>(&self, new: f64, stored: f64) -> bool {
        let [new, stored] = [new, stored].map(R::new);
        if self.is_reversed {
            new > stored
        } else {
            new < stored
        }
    }
}
