//! The words of every file that reads cases: what a case gives, and why it is refused.

pub(super) use serde_json::{Value as Json, json, value::RawValue};

pub(super) use crate::{
    input::{Dim, Fault, Field, Given, Got, Part, Shape},
    text::{Formula, Message, Value},
    trace::Counts,
};

pub(super) use super::{
    refusal::{Code, Path, Refusal, short},
    style::Detail,
};
