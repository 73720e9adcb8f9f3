//! What is seen at a pixel's middle, by determinants of whole numbers.

use super::soup::{FAR, NEAR, SIZE, Whole};

/// What a line of sight meets.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Seen {
    Nothing,
    Surface {
        id: u32,
        depth: f64,
    },
    /// It passes an edge within the step that vertices are snapped to, or two surfaces are as deep but for 10⁻⁶.
    Unsure,
}

fn det([a, b, c]: [[i128; 3]; 3]) -> i128 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// In sixteenths of the near plane's distance.
fn sight([column, row]: [u32; 2]) -> [i128; 3] {
    let [width, height] = SIZE.map(i128::from);
    [
        2 * i128::from(column) + 1 - width,
        height - 1 - 2 * i128::from(row),
        -width,
    ]
}

/// Twice `place`'s distance from an edge, in pixels, as its side over the length of what the side grows by.
fn is_near_edge(side: i128, [a, b]: [[i128; 3]; 2]) -> bool {
    // Of r·(a × b), from pixel to pixel.
    let grows = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2]].map(|x| 2.0 * x as f64);
    (side as f64).abs() <= 2.0_f64.powi(-16) * grows[0].hypot(grows[1])
}

/// By depth, among `triangles` in eighths; backs are left out where they are culled.
pub fn seen(triangles: &[Whole], culls_backs: bool, pixel: [u32; 2]) -> Seen {
    let r = sight(pixel);
    let mut hits: Vec<(f64, u32)> = Vec::new();
    for (id, triangle) in (0..).zip(triangles) {
        let corners = triangle.map(|v| v.map(i128::from));
        let [a, b, c] = corners;
        let whole = det(corners);
        if whole == 0 || (culls_backs && whole > 0) {
            continue;
        }
        let edges = [[a, b], [b, c], [c, a]];
        let sides = edges.map(|[p, q]| det([r, p, q]));
        if edges
            .iter()
            .zip(sides)
            .any(|(edge, side)| is_near_edge(side, *edge))
        {
            return Seen::Unsure;
        }
        if !sides.iter().all(|side| side.signum() == whole.signum()) {
            continue;
        }
        // Where r·s/16 lies in the plane, for s in units of the near plane: s = 16·whole/(8·Σ sides).
        let sum: i128 = sides.iter().sum();
        let distance = 2.0 * whole as f64 / sum as f64;
        if [NEAR, FAR].iter().any(|end| (distance - end).abs() < 1e-9) {
            return Seen::Unsure;
        }
        if distance > NEAR && distance < FAR {
            hits.push((FAR / (FAR - NEAR) * (1.0 - NEAR / distance), id));
        }
    }
    hits.sort_by(|one, other| one.0.total_cmp(&other.0));
    match hits[..] {
        [] => Seen::Nothing,
        [one, two, ..] if two.0 - one.0 < 1e-6 => Seen::Unsure,
        [(depth, id), ..] => Seen::Surface { id, depth },
    }
}

pub fn pixels() -> impl Iterator<Item = [u32; 2]> {
    (0..SIZE[1]).flat_map(|row| (0..SIZE[0]).map(move |column| [column, row]))
}
