//! Clipping a polygon against a window or another polygon: what is left is one polygon, several, or none.

pub mod weiler_atherton;
