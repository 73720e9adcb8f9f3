//! The words of every method of this lab: those of all methods in space, and those of large pixels.

pub(super) use crate::{
    algo::surface::{Picture, Rays, Surfaces},
    labs::{
        space::{
            prelude::*,
            soup::{MOST_ASKED, surface_link, surfaces_on_raster},
        },
        words::pixel_formula,
    },
};

pub(super) use super::crosses::{Names, with_crosses, wrong_pixels};
pub(super) use super::on_raster::{
    self, RASTER_VIEW, faces, lettered, lettered_or_outlined, mark, middle, middle_at, middle_of,
    name_of, outline, pixels, raster_so_far, segment, sight, sign, spaced, text_of, tone, triangle,
};
