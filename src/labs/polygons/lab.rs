//! The polygons lab, as the table of labs has it.

use crate::labs::{self, Lab, MethodCard, OutlineKind, window_handles};

use super::{Method, Scene, change::OUTLINES};

/// A polygon against a window or another polygon.
pub static LAB: &dyn Lab = &Polygons;

struct Polygons;

impl Lab for Polygons {
    fn id(&self) -> &'static str {
        "polygons"
    }

    fn name_key(&self) -> &'static str {
        "lab-polygons"
    }

    fn about_key(&self) -> &'static str {
        "lab-polygons-about"
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        Method::all().map(Method::card).collect()
    }

    fn first_scene(&self) -> labs::Scene {
        Scene::first().into()
    }

    fn lock_groups(&self) -> &'static [&'static str] {
        &["polygon", window_handles::GROUP, "clip"]
    }

    fn outlines(&self) -> &'static [OutlineKind] {
        &OUTLINES
    }
}
