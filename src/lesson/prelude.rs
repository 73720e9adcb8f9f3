//! The words of every file that reads a lesson: what is wrong, where, and how it is told.

pub(super) use std::ops::Range;

pub(super) use crate::text::{Diagnostic, Lang, Message, clipped, nearest, suggestion};

pub(super) use super::{
    problem::{Place, Problem, Severity},
    sink::Sink,
    source::Source,
};
