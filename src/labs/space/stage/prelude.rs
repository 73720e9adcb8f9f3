//! The words of every file that draws a scene.

pub(super) use crate::{
    figure::{Edge3, Facet, Facets, Seer, Space},
    geom::{Camera, Orbit, Plane, Sight, VolumeSide},
    labs::prelude::*,
};
pub(super) use glam::DVec3;
