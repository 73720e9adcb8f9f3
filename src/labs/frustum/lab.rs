//! The frustum lab.

use crate::labs::{self, Lab, MethodCard};

use super::{Method, Scene};

/// Objects in front of a camera, and around it.
pub static LAB: &dyn Lab = &Frustum;

struct Frustum;

impl Lab for Frustum {
    fn id(&self) -> &'static str {
        "frustum"
    }

    fn name_key(&self) -> &'static str {
        "lab-frustum"
    }

    fn about_key(&self) -> &'static str {
        "lab-frustum-about"
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        Method::all().map(Method::card).collect()
    }

    fn first_scene(&self) -> labs::Scene {
        Scene::first().into()
    }

    fn lock_groups(&self) -> &'static [&'static str] {
        &["camera", "volume", "object", "point", "segment", "triangle"]
    }
}
