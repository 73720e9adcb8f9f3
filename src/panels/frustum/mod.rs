//! What the frustum lab adds to the window: what culling costs.

mod culling_costs;
mod culling_view;

use crate::labs::frustum;

use super::space::SpacePanel;

use culling_costs::CullingCosts;
use culling_view::culling_view;

/// The lab's part of the window.
pub fn panel() -> SpacePanel<CullingCosts> {
    SpacePanel::new(frustum::LAB, |_, _, _| None, culling_view)
}
