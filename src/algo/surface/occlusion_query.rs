//! The box that stands for an object in a query: would any of its pixels be seen?

use crate::{
    algo::ring::Right,
    geom::{AlignedBox, Sight},
    trace::Real,
};

use super::{DepthFormat, Picture, Surfaces, coverage::Coverage};

/// The faces of a box, counter-clockwise as seen from outside, by the numbers of its corners.
const FACES: [[usize; 3]; 12] = [
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
];

/// Around some triangles in view space, and a little larger: by more than vertices are moved when they are snapped, wherever in the box they
/// are. `None` around none.
pub(super) fn query_box(surfaces: &Surfaces, triangles: &[[[f64; 3]; 3]]) -> Option<AlignedBox> {
    /// Of a pixel: four of the steps that vertices are snapped to.
    const MARGIN: f64 = 1.0 / 16_384.0;
    let bounds = AlignedBox::around(triangles.as_flattened().iter().copied()).ok()?;
    let volume = surfaces.volume();
    let distance = match volume.sight() {
        Sight::Perspective => -bounds.min()[2],
        Sight::Parallel => 1.0,
    };
    let (half, size) = (volume.half_size(), surfaces.size().map(f64::from));
    let pixel = (2.0 * half[0] / size[0]).max(2.0 * half[1] / size[1]);
    let margin = MARGIN * pixel * distance.max(0.0);
    let [x, y, z] = bounds.min().map(|x| x - margin);
    let [right, top, front] = bounds.max().map(|x| x + margin);
    AlignedBox::new([x, y, z, right, top, front]).ok()
}

/// Does it reach the near plane? Then its front may be cut away, and nothing can be told from what is left.
pub(super) fn reaches_near(surfaces: &Surfaces, bounds: &AlignedBox) -> bool {
    -bounds.max()[2] <= surfaces.volume().near()
}

/// Calls back with every pixel that the box's front covers, and whether it would be seen there: nothing is written. What is as near as
/// what is stored counts as seen.
pub(super) fn ask<R: Real>(
    surfaces: &Surfaces,
    bounds: &AlignedBox,
    depths: &[f64],
    mut tell: impl FnMut([u32; 2], bool),
) {
    let corners = bounds.corners();
    let faces: Vec<[[f64; 3]; 3]> = FACES.map(|face| face.map(|i| corners[i])).to_vec();
    let (format, places) = (DepthFormat::default(), Picture::empty(surfaces.size()));
    let Some(faces) = Surfaces::new(surfaces.size(), *surfaces.volume(), faces, true) else {
        return;
    };
    for face in faces.triangles() {
        let Some(coverage) = Coverage::of::<Right>(&faces, face) else {
            continue;
        };
        coverage.for_each_span(faces.viewport(), |span| {
            let [first, end] = span.columns;
            for column in first..end {
                let pixel = [column, span.row];
                let stored = depths[places.place(pixel)];
                tell(
                    pixel,
                    !format.is_nearer::<R>(stored, span.depth::<R>(column)),
                );
            }
        });
    }
}
