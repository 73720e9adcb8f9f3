//! Many boxes on both sides of a street: what culling is measured on.

use crate::{geom::Solid, labs::split_mix::SplitMix64};

use super::{MAX_OBJECTS, Model, Object};

/// Rows of houses along −z, in turn on the left and on the right, as many as are asked for.
///
/// # Panics
/// Never: its numbers are finite.
pub fn street(count: usize, seed: u64) -> Vec<Object> {
    let mut random = SplitMix64(seed);
    let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
    (0..count.clamp(1, MAX_OBJECTS))
        .map(|i| {
            let side = if i % 2 == 0 { -1.0 } else { 1.0 };
            let (row, lane) = ((i / 2) % 25, i / 50);
            let size = between(0.45, 0.9);
            let x = side * (2.0 + 2.6 * lane as f64 + between(-0.2, 0.2));
            let z = 3.0 - 2.4 * row as f64 + between(-0.2, 0.2);
            let turn = [0.0, between(-12.0, 12.0), 0.0];
            Object::new(Model::Solid(Solid::Cube), [x, size, z], turn, size).expect("finite")
        })
        .collect()
}
