//! Clipping a polygon against a window or another polygon: what is left is one polygon, several, or none.

mod ear_clipping;

pub use ear_clipping::{
    Corner, EarClipping, EarClippingEvent, EarClippingState, Ring, Triangle, Triangulation,
};
