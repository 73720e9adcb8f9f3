//! The words of every method of this lab: those of all methods, and those of lists beside a drawing.

pub(super) use serde_json::{Value as Json, json};

pub(super) use crate::{
    figure::{ItemMarker, ListColumn, ListLink, ListRow, Lists, Shape, Tick},
    geom::Point,
    labs::{
        polygons::{PolygonTelling, Scene, ScenePart, UnfitScene},
        prelude::*,
        words::{vertex_name, vertex_symbol},
    },
};
