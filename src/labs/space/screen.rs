//! The pixels that a scene's camera is thought to fill.

use crate::algo::surface::Viewport;

/// A screen of so many rows for a camera of this shape.
///
/// # Panics
/// Never: its sides are kept to what a picture may have; `rows` is from 1 to [`Viewport::MAX_SIDE`].
pub fn screen(aspect: f64, rows: u32) -> Viewport {
    let most = f64::from(Viewport::MAX_SIDE);
    let columns = (aspect * f64::from(rows)).round().clamp(1.0, most) as u32;
    let viewport = Viewport::new([columns, rows], Viewport::ANSWER_BITS);
    viewport.expect("no side is too long")
}
