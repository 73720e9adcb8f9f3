//! The lines lab, as the table of labs has it.

use crate::labs::{self, Lab, MethodCard, window_handles};

use super::{Method, Scene};

/// Segments against a window.
pub static LAB: &dyn Lab = &Lines;

struct Lines;

impl Lab for Lines {
    fn id(&self) -> &'static str {
        "lines"
    }

    fn name_key(&self) -> &'static str {
        "lab-lines"
    }

    fn about_key(&self) -> &'static str {
        "lab-lines-about"
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        Method::all().map(Method::card).collect()
    }

    fn first_scene(&self) -> labs::Scene {
        Scene::first().into()
    }

    fn lock_groups(&self) -> &'static [&'static str] {
        &["p1", "p2", "segment", window_handles::GROUP, "clip"]
    }
}
