//! The words of every method that works on a scene in space.

pub use crate::labs::{
    prelude::*,
    space::{
        Scene, SpaceTelling, Subject,
        stage::{
            FaceLook, Fate, Scenery, face_link, normal_of, object_link, plane_at_work, side_link,
            side_name, side_named, volume,
        },
    },
};
