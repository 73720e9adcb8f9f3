//! One triangle: which pixels it covers, and the weights of its corners at each.
//!
//! Corners are snapped to 1/256 pixel, so the edge functions are exact integers and two
//! triangles that share an edge cover every pixel along it exactly once (the top-left rule).
//!
//! ```text
//!   w0, w1, w2   twice the signed areas that a pixel centre cuts off: all ≥ 0 inside
//!
//!            0                 w0 + w1 + w2 = area
//!           / \
//!          /w2 w1             λ1 = w1 / area, λ2 = w2 / area, and an attribute is
//!         / · p \             a0 + λ1 (a1 − a0) + λ2 (a2 − a0)
//!        /  w0   \
//!       1---------2
//! ```
//!
//! Source: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988, 17–20.

const SUBPIXEL_BITS: u32 = 8;
const PIXEL: i64 = 1 << SUBPIXEL_BITS;
/// 2^20 pixels: differences fit 2^29 and an edge function 2^60. What lies farther out is moved to this line.
const FARTHEST: f64 = (1_i64 << (20 + SUBPIXEL_BITS)) as f64;
pub(super) const WEIGHT_BITS: u32 = 29;
/// An area's bits before it is inverted: the reciprocal keeps at least 23 significant bits.
const AREA_BITS: u32 = 40;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PixelRect {
    pub left: i64,
    pub top: i64,
    pub right: i64,
    pub bottom: i64,
}

/// An edge function: its value at a pixel centre is `dx · x + dy · y` more than at the corner.
#[derive(Clone, Copy, Debug, Default)]
struct EdgeFunction {
    from: [i64; 2],
    /// Change for one snapped unit to the right, and downwards.
    step: [i64; 2],
    /// The least value that counts as inside: 0 on top and left edges, 1 on the others.
    least: i64,
}

impl EdgeFunction {
    fn between(a: [i64; 2], b: [i64; 2]) -> Self {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let is_top_left = dy < 0 || (dy == 0 && dx > 0);
        Self {
            from: a,
            step: [-dy, dx],
            least: i64::from(!is_top_left),
        }
    }

    fn at(&self, x_px: i64, y_px: i64) -> i64 {
        self.step[0] * (x_px * PIXEL + PIXEL / 2 - self.from[0])
            + self.step[1] * (y_px * PIXEL + PIXEL / 2 - self.from[1])
    }

    /// Narrows the half-open range of `offsets` from a pixel where the edge function is `value`.
    fn narrow(&self, value: i64, offsets: &mut (i64, i64)) {
        let (value, step) = (value - self.least, self.step[0] * PIXEL);
        if step > 0 {
            if value < 0 {
                offsets.0 = offsets.0.max((step - 1 - value) / step);
            }
        } else if value < 0 {
            offsets.1 = offsets.0;
        } else if step < 0 {
            offsets.1 = offsets.1.min(value / -step + 1);
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct PixelRun {
    pub y: usize,
    pub left: usize,
    pub right: usize,
    /// Edge functions of corners 1 and 2 at the first pixel.
    w: [i64; 2],
}

#[derive(Clone, Copy, Debug)]
pub(super) struct RasterTriangle {
    edges: [EdgeFunction; 3],
    bounds: PixelRect,
    /// True if corners 1 and 2 were exchanged to make the area positive.
    pub is_flipped: bool,
    scale: Scale,
}

/// One over the area.
#[derive(Clone, Copy, Debug)]
struct Scale {
    shift: u32,
    reciprocal: u64,
}

impl RasterTriangle {
    /// In pixels; none where a corner is not finite, there is no area, or all of it is out of `clip`.
    pub fn new(corners_px: [[f64; 2]; 3], clip: PixelRect) -> Option<Self> {
        if !corners_px.iter().flatten().all(|c| c.is_finite()) {
            return None;
        }
        let mut p = corners_px.map(|c| c.map(snap));
        let mut area =
            (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
        let is_flipped = area < 0;
        if is_flipped {
            p.swap(1, 2);
            area = -area;
        }
        let bounds = bounds_of(&p, clip);
        if area == 0 || bounds.left >= bounds.right || bounds.top >= bounds.bottom {
            return None;
        }
        let shift = (i64::BITS - area.leading_zeros()).saturating_sub(AREA_BITS);
        Some(Self {
            edges: [
                EdgeFunction::between(p[1], p[2]),
                EdgeFunction::between(p[2], p[0]),
                EdgeFunction::between(p[0], p[1]),
            ],
            bounds,
            is_flipped,
            scale: Scale {
                shift,
                reciprocal: (1_u64 << 63) / (area.unsigned_abs() >> shift),
            },
        })
    }

    pub fn rows(&self) -> std::ops::Range<i64> {
        self.bounds.top..self.bounds.bottom
    }

    pub fn span(&self, y: i64) -> Option<PixelRun> {
        let left = self.bounds.left;
        let mut offsets = (0, self.bounds.right - left);
        let w = self.edges.map(|edge| {
            let value = edge.at(left, y);
            edge.narrow(value, &mut offsets);
            value
        });
        (offsets.0 < offsets.1).then(|| PixelRun {
            y: y as usize,
            left: (left + offsets.0) as usize,
            right: (left + offsets.1) as usize,
            w: [1, 2].map(|i| w[i] + self.edges[i].step[0] * PIXEL * offsets.0),
        })
    }

    /// The weights λ1 and λ2, with [`WEIGHT_BITS`] fractional bits, along a span.
    pub fn weights(&self, span: &PixelRun) -> impl Iterator<Item = [i64; 2]> + use<> {
        let scale = self.scale;
        let steps = self.steps();
        let mut w = span.w;
        (span.left..span.right).map(move |_| {
            let lambda = scale.weights(w);
            w = [w[0] + steps[0], w[1] + steps[1]];
            lambda
        })
    }

    /// The same at the first and at the last pixel of a span.
    pub fn weights_at_ends(&self, span: &PixelRun) -> [[i64; 2]; 2] {
        let n_steps = (span.right - span.left).saturating_sub(1) as i64;
        let [first, second] = self.steps().map(|step| step * n_steps);
        let last = [span.w[0] + first, span.w[1] + second];
        [span.w, last].map(|w| self.scale.weights(w))
    }

    fn steps(&self) -> [i64; 2] {
        [1, 2].map(|i: usize| self.edges[i].step[0] * PIXEL)
    }
}

impl Scale {
    fn weights(self, w: [i64; 2]) -> [i64; 2] {
        // Inside, 0 ≤ w ≤ area, so the product stays below 2^63 (and a bit of rounding).
        w.map(|w| {
            let scaled = (w.max(0).unsigned_abs() >> self.shift).saturating_mul(self.reciprocal);
            (scaled >> (63 - WEIGHT_BITS)) as i64
        })
    }
}

pub(super) fn mix(start: i64, deltas: [i64; 2], weights: [i64; 2]) -> i64 {
    let sum = deltas[0] * weights[0] + deltas[1] * weights[1];
    start + ((sum + (1 << (WEIGHT_BITS - 1))) >> WEIGHT_BITS)
}

fn snap(pixels: f64) -> i64 {
    (pixels * PIXEL as f64).round().clamp(-FARTHEST, FARTHEST) as i64
}

fn bounds_of(p: &[[i64; 2]; 3], clip: PixelRect) -> PixelRect {
    let least = |axis: usize| p[0][axis].min(p[1][axis]).min(p[2][axis]);
    let most = |axis: usize| p[0][axis].max(p[1][axis]).max(p[2][axis]);
    // The first centre at or after `v`, as a pixel index.
    let first = |v: i64| (v + PIXEL / 2 - 1) >> SUBPIXEL_BITS;
    let past = |v: i64| ((v - PIXEL / 2) >> SUBPIXEL_BITS) + 1;
    PixelRect {
        left: first(least(0)).max(clip.left),
        top: first(least(1)).max(clip.top),
        right: past(most(0)).min(clip.right),
        bottom: past(most(1)).min(clip.bottom),
    }
}
