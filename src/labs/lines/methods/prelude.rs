//! The words of every method of this lab: those of all methods, and those of a segment against a window.

pub(super) use crate::{
    algo::line::{End, WindowInput},
    geom::{Axis, Edge, Point, Segment, Window},
    labs::{
        crossing_formulas::upright,
        lines::{LineTelling, Scene, scene::nearest_along},
        prelude::*,
        words::{along, axis_symbol, border_equation, edge_link, edge_name},
    },
};
