//! The words of every file that shows how a triangle is cut.

pub(super) use super::super::asked::{perpendicular, place};
pub(super) use super::agreement::{agreement_view, is_about_pictures, is_alone, vertex_rows};
pub(super) use super::marks::{
    cut_symbol, distance, given, kept, label_amid, lost, measured, named_cut, names, of_plane,
    parameter, places, plane_mark, triangle_label, triangle_link, triangle_symbol, vertex,
    vertex_symbol,
};
pub(super) use super::parts::{Parts, in_clip_space, of_polygon, of_triangles};
pub(super) use super::stages::{Progress, small_view, tally};
pub(super) use super::variant::{self, Homogeneous, OneByOne, OnePolygon, Variant};
pub(super) use super::{LISTS_VIEW, ToldTriangles};
pub(super) use crate::{
    figure::{ItemMarker, ListLink},
    labs::frustum::prelude::*,
};
