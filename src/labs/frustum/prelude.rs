//! The words of every method of this lab.

pub(super) use crate::labs::space::prelude::*;
