//! The words of every method of this lab: those of all methods, those of rings that are clipped, and those of lists beside a drawing.

pub(super) use serde::Serialize;

pub(super) use crate::{
    algo::{
        polygon::{ClipRegion, Right, RingOutcome, Vertex},
        ring::{Crossing, Happening, RingEvent},
    },
    figure::{ItemMarker, ListColumn, ListLink, ListRow, Lists, Shape, Tick},
    geom::Point,
    labs::{
        polygons::{PolygonTelling, Scene, ScenePart, UnfitScene},
        prelude::*,
        rings::{
            Asked, RingStep, asked_vertex, is_crossed, puts_both, puts_crossing, puts_end,
            puts_nothing,
        },
        words::{vertex_name, vertex_symbol},
    },
};
