//! The words of every file here: those of this lab's methods, and those of two lists.

pub(super) use crate::algo::{
    line::Ratio,
    polygon::weiler_atherton::{
        Contact, Entry, Intersection,
        IntersectionLabel::{self, Entering, Leaving, Pinching, Touching},
        List::{self, Clip, Subject},
        RingKind::{self, Hole, Outer, Sliver},
        Side, WeilerAtherton, WeilerAthertonEvent as Event, WeilerAthertonHeld as Held,
        WeilerAthertonInput as Input,
    },
};

pub(super) use super::super::prelude::*;
