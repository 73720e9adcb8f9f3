//! Which pixels a triangle in view space covers, and how deep it lies there.

use std::{
    convert::Infallible,
    ops::{ControlFlow, Range},
};

use crate::{
    algo::{ring::Right, volume::ClipVertex},
    geom::{Sight, ViewVolume, Wide, times_power},
    trace::Real,
};

use super::{
    Cull, Picture, Rays, ScreenTriangle, SurfaceRules, Surfaces, Tint, Viewport,
    assembly::{Seen, for_each_piece},
    excess::excess,
    scan::try_for_each_span,
    screen_triangle::{Corner, Linear},
};

/// Components of a normal: neither they nor their products with points have left the range of f64.
const PLAIN: Range<f64> = 1e-180..1e180;

pub(super) struct Coverage {
    pieces: Vec<Piece>,
    /// Between the shallowest and the deepest corner: a pixel's middle that only snapping puts inside is not far outside of it.
    range: [f64; 2],
}

struct Piece {
    screen: ScreenTriangle<0>,
    depth: Linear<f64>,
}

#[derive(Clone, Copy)]
pub(super) struct Span<'a> {
    pub row: u32,
    /// From the first to the one after the last.
    pub columns: [u32; 2],
    depth: &'a Linear<f64>,
    range: [f64; 2],
}

impl Span<'_> {
    pub fn depth<R: Real>(&self, column: u32) -> f64 {
        let [low, high] = self.range;
        self.depth.of::<R>(column, self.row).get().clamp(low, high)
    }
}

impl Coverage {
    /// `None` where nothing of it can be seen, whatever stands before it.
    pub fn of<L: SurfaceRules>(surfaces: &Surfaces, triangle: &[[f64; 3]; 3]) -> Option<Self> {
        if !surfaces.shows(triangle) {
            return None;
        }
        let by = excess(surfaces.volume(), triangle);
        let (viewport, volume) = (surfaces.viewport(), &surfaces.volume().times_power(-by));
        let triangle = &triangle.map(|at| times_power(at, -by));
        let at = triangle.map(|at| in_clip_space(volume, at));
        let TrianglePlane { n, d, .. } = TrianglePlane::of(triangle);
        let plane_depth = Rays::through_all(*volume, surfaces.size()).plane_depth(n, d)?;
        // A parallel camera's depth is the distance.
        let is_straight = L::STRAIGHT_DISTANCE && volume.sight() == Sight::Perspective;
        let mut range = [1.0_f64, 0.0_f64];
        let mut pieces = Vec::with_capacity(1);
        let seen = at.map(|at| Seen::new(at, viewport));
        let vertex = |i: usize| ClipVertex {
            at: at[i],
            attributes: [],
        };
        for_each_piece(
            seen.each_ref(),
            vertex,
            viewport,
            Cull::Nothing,
            |mut corners| {
                if is_straight {
                    for corner in &mut corners {
                        let distance = 1.0 / corner.inverse_w;
                        corner.depth = (distance - volume.near()) / (volume.far() - volume.near());
                    }
                }
                for Corner { depth, .. } in corners {
                    range = [range[0].min(depth), range[1].max(depth)];
                }
                if let Some(screen) = ScreenTriangle::new(0, &corners, viewport) {
                    let depth = if is_straight {
                        screen.depth
                    } else {
                        plane_depth
                    };
                    pieces.push(Piece { screen, depth });
                }
            },
        );
        let [low, high] = range.map(|depth| depth.clamp(0.0, 1.0));
        (low <= high && !pieces.is_empty()).then_some(Self {
            pieces,
            range: [low, high],
        })
    }

    pub fn for_each_span(&self, viewport: &Viewport, mut span: impl FnMut(Span<'_>)) {
        let [_, height] = viewport.size();
        let ControlFlow::Continue(()) = self.try_for_each_span(viewport, &(0..height), |it| {
            span(it);
            ControlFlow::<Infallible>::Continue(())
        });
    }

    /// The same among some rows, until the callback breaks off.
    #[inline]
    pub fn try_for_each_span<S>(
        &self,
        viewport: &Viewport,
        rows: &Range<u32>,
        mut span: impl FnMut(Span<'_>) -> ControlFlow<S>,
    ) -> ControlFlow<S> {
        for Piece { screen, depth } in &self.pieces {
            try_for_each_span(screen, viewport, rows, |row, columns| {
                span(Span {
                    row,
                    columns: [columns.start, columns.end],
                    depth,
                    range: self.range,
                })
            })?;
        }
        ControlFlow::Continue(())
    }
}

/// Near and far decide by the distance itself, whatever the matrix rounds to.
fn in_clip_space(volume: &ViewVolume, [x, y, z]: [f64; 3]) -> [f64; 4] {
    let matrix = volume.clip_from_view();
    let at = matrix.times([x, y, z, 1.0]);
    let [clip_x, clip_y, clip_z, w] = if at.iter().all(|x| x.is_finite()) {
        at
    } else {
        // In clip space all four may be made smaller: it is the same point.
        matrix.times(times_power([x, y, z, 1.0], -1000))
    };
    let clip_z = if -z < volume.near() {
        clip_z.min((-w).next_down())
    } else if -z > volume.far() {
        clip_z.max(w.next_up())
    } else {
        clip_z.max(-w).min(w)
    };
    [clip_x, clip_y, clip_z, w]
}

/// The plane n·p + d = 0 that a triangle lies in.
#[derive(Clone, Copy, Debug)]
pub(super) struct TrianglePlane {
    /// (V1 − V0) × (V2 − V0)
    pub n: [f64; 3],
    /// −n·V0
    pub d: f64,
    /// So many times smaller both are, as a power of two, than they would be if there were such numbers.
    pub by: i32,
}

impl TrianglePlane {
    pub fn of(triangle: &[[f64; 3]; 3]) -> Self {
        let (n, d) = plane::<f64>(triangle);
        let largest = n.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if PLAIN.contains(&largest) && d.is_finite() {
            Self { n, d, by: 0 }
        } else {
            Self::near_one(triangle)
        }
    }

    /// With a normal shorter than 1/8, so that n·p is not too large for any point that a triangle may have.
    #[cold]
    fn near_one(triangle: &[[f64; 3]; 3]) -> Self {
        let (n, d) = plane::<Wide>(triangle);
        let (_, by) = Wide::near_one(n);
        let by = by + 4;
        let over_power = |x: Wide| x.times_power(-by).get();
        Self {
            n: n.map(over_power),
            d: over_power(d),
            by,
        }
    }
}

/// n and d as they are computed.
pub(super) fn plane<R: Real>(triangle: &[[f64; 3]; 3]) -> ([R; 3], R) {
    let [v0, v1, v2] = triangle.map(|v| v.map(R::new));
    let [a, b]: [[R; 3]; 2] = [v1, v2].map(|v| std::array::from_fn(|i| v[i] - v0[i]));
    let n = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
    (n, -(n[0] * v0[0] + n[1] * v0[1] + n[2] * v0[2]))
}

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Rows(pub Vec<(u32, [u32; 2])>);

impl Rows {
    pub fn of(surfaces: &Surfaces, id: u32) -> Self {
        let mut rows = Vec::new();
        let triangle = surfaces.triangles().get(id as usize);
        if let Some(coverage) = triangle.and_then(|t| Coverage::of::<Right>(surfaces, t)) {
            coverage.for_each_span(surfaces.viewport(), |span| {
                rows.push((span.row, span.columns));
            });
        }
        Self(rows)
    }

    pub fn paint(&self, picture: &mut Picture, id: u32) {
        for &(row, columns) in &self.0 {
            picture.put_row(row, columns, id);
        }
    }

    /// The same in brightness.
    pub fn paint_over<R: Real>(&self, brightness: &mut [f64], width: u32, tint: Tint) {
        for &(row, columns) in &self.0 {
            let [first, end] = columns.map(|column| (row * width + column) as usize);
            for there in &mut brightness[first..end] {
                *there = tint.over::<R>(*there);
            }
        }
    }
}

impl Surfaces {
    /// How many pixels a triangle covers, seen or not.
    #[must_use]
    pub fn n_covered(&self, id: u32) -> u64 {
        let widths = Rows::of(self, id).0;
        widths
            .iter()
            .map(|(_, [first, end])| u64::from(end - first))
            .sum()
    }

    /// At how many pixels some of the triangles are seen, if there are no others. The picture shows none of them before, and them after.
    #[must_use]
    pub fn n_covered_by_all(&self, ids: Range<u32>, picture: &mut Picture) -> usize {
        let (mark, mut n_covered) = (ids.start, 0);
        for id in ids {
            for (row, [first, end]) in Rows::of(self, id).0 {
                for pixel in (first..end).map(|column| [column, row]) {
                    if picture.at(pixel) != Some(mark) {
                        picture.put(pixel, mark);
                        n_covered += 1;
                    }
                }
            }
        }
        n_covered
    }
}
