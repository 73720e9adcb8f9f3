//! The words of every method of this lab, public so that one can be written outside of the house.

pub use crate::labs::space::prelude::*;

pub(super) use crate::{
    algo::{
        cull::{
            BackFace, BackFaceInput,
            Containment::{self, Inside, Outside, Straddles},
            asked_viewer,
        },
        parameter::End,
        ring::{Crossing, Right},
        volume::{
            ClipSpace, ClipVertex, HomogeneousTriangle, IntersectionPolygon, PlaneAtATime,
            SideCode, SpaceVertex, TrianglePlanes, VolumeRules, side_distances,
        },
    },
    figure::{Gauge, Gauges},
    geom::{AlignedBox, Camera, Plane, Sight, VolumeSide},
    labs::{
        rings::{RingStep, asked_now},
        segments::{LineLook, LineStep, LineVariant},
    },
};
pub(super) use glam::DVec3;
pub(super) use serde::Serialize;
pub(super) use serde_json::json;
