//! The events that all clippers of rings have in common.

use super::Happening;

/// An event of a clipper of rings: what happens to a vertex or an edge, or something between limits.
pub trait RingEvent<V> {
    /// What happens to a vertex or an edge; none between limits.
    fn happening(&self) -> Option<Happening<V>>;
}

/// Writes both ways between a [`Happening`] and an enum of events that has the variants `First`, `Test`, `Cross` and `Output`.
macro_rules! ring_events {
    ([$($generics:tt)*] $Event:ty, $V:ty, between: $($between:ident)|+) => {
        impl<$($generics)*> From<$crate::algo::ring::Happening<$V>> for $Event {
            #[inline]
            fn from(happening: $crate::algo::ring::Happening<$V>) -> Self {
                use $crate::algo::ring::{Crossing, Happening};
                match happening {
                    Happening::First { at, distance, inside } => Self::First { at, distance, inside },
                    Happening::Test { idx, ends, distances, rule } => {
                        Self::Test { idx, ends, distances, rule }
                    }
                    Happening::Cross(Crossing { at, t }) => Self::Cross { at, t },
                    Happening::Output(at) => Self::Output { at },
                }
            }
        }

        impl<$($generics)*> $crate::algo::ring::RingEvent<$V> for $Event {
            fn happening(&self) -> Option<$crate::algo::ring::Happening<$V>> {
                use $crate::algo::ring::{Crossing, Happening};
                Some(match *self {
                    Self::First { at, distance, inside } => Happening::First { at, distance, inside },
                    Self::Test { idx, ends, distances, rule } => {
                        Happening::Test { idx, ends, distances, rule }
                    }
                    Self::Cross { at, t } => Happening::Cross(Crossing { at, t }),
                    Self::Output { at } => Happening::Output(at),
                    $(Self::$between { .. })|+ => return None,
                })
            }
        }
    };
}

pub(in crate::algo) use ring_events;
