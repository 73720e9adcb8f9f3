//! Outcodes: one bit for each side that a point lies beyond.

use std::{
    fmt,
    ops::{BitAnd, BitOr},
};

use serde::{Serialize, Serializer};

/// One bit for each of `N` sides. Written as its binary digits.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Code<const N: usize>(pub(in crate::algo) u8);

impl<const N: usize> Code<N> {
    /// Bitwise OR.
    #[inline]
    #[must_use]
    pub const fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Bitwise AND.
    #[inline]
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// No bit is set: inside every side.
    #[inline]
    #[must_use]
    pub const fn is_inside(self) -> bool {
        self.0 == 0
    }
}

impl<const N: usize> BitOr for Code<N> {
    type Output = Self;

    #[inline]
    fn bitor(self, other: Self) -> Self {
        self.or(other)
    }
}

impl<const N: usize> BitAnd for Code<N> {
    type Output = Self;

    #[inline]
    fn bitand(self, other: Self) -> Self {
        self.and(other)
    }
}

impl<const N: usize> fmt::Display for Code<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:0N$b}", self.0)
    }
}

impl<const N: usize> Serialize for Code<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
