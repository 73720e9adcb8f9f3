//! How the views of a scene are seen, as the reader left them.

use std::collections::BTreeMap;

use crate::{figure::ViewId, geom::Orbit, widgets::PanZoom};

/// How the views of a scene are seen: kept while another page is open.
#[derive(Clone, Default)]
pub struct Sight {
    /// Views that were panned or zoomed, the same for two methods side by side; others fit `bounds`.
    pub moved: BTreeMap<ViewId, PanZoom>,
    /// Eyes that were turned; others stand where their view has them.
    pub turned: Vec<Turned>,
    /// What was to be seen when the scene was opened: dragging a handle does not move the view.
    pub bounds: [[f64; 2]; 2],
}

impl Sight {
    /// As nobody has moved or turned anything yet.
    pub fn new(bounds: [[f64; 2]; 2]) -> Self {
        Self {
            bounds,
            ..Self::default()
        }
    }
}

/// An eye that was turned away from where its view has it. A view that shows one space after the other has one for each.
#[derive(Clone)]
pub struct Turned {
    pub id: ViewId,
    pub home: Orbit,
    pub now: Orbit,
}
