//! What the surfaces lab adds to the window: how its scenes are drawn pixel by pixel, and what that costs.

mod costs_view;
mod raster;
mod surface_costs;

use crate::labs::surfaces;

use super::space::SpacePanel;

use costs_view::costs_view;
use surface_costs::SurfaceCosts;

/// The lab's part of the window.
pub fn panel() -> SpacePanel<SurfaceCosts> {
    SpacePanel::new(surfaces::LAB, raster::form, costs_view)
}
