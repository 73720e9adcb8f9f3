//! The words of every file that reads a lesson: what is wrong, where, and how it is told.

pub(super) use std::ops::Range;

pub(super) use crate::text::{Diagnostic, Lang, Message};

pub(super) use super::{
    nearest::{clipped, nearest, suggestion},
    problem::{Place, Problem, Severity},
    sink::Sink,
    source::Source,
};
