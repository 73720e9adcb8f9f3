//! The words of every file that tells how a segment is clipped.

pub(super) use crate::{
    algo::{
        parameter::{End, Ratio},
        segment::{Given, LineClip, LineEvent, LineRules, RowNumbers, VisibleLine},
    },
    figure::Side,
    labs::{
        interval::{direction, value_of},
        prelude::*,
    },
};
