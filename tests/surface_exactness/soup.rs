//! Triangles to ask about.

use clipscope::{
    algo::surface::Surfaces,
    geom::{Matrix, Solid, ViewVolume},
};
use proptest::prelude::*;

/// Columns and rows: with an opening of 90° the middles lie in sixteenths.
pub const SIZE: [u32; 2] = [16, 16];
pub const NEAR: f64 = 1.0;
pub const FAR: f64 = 16.0;

/// In eighths.
pub type Whole = [[i64; 3]; 3];

/// A triangle anywhere in and around the volume, also behind the eye: they intersect, and cross its sides.
pub fn anywhere() -> impl Strategy<Value = Whole> {
    prop::array::uniform3((-64..65_i64, -64..65_i64, -144..17_i64).prop_map(|(x, y, z)| [x, y, z]))
}

/// One that lies wholly before the eye, and not wholly beside the picture.
pub fn ahead() -> impl Strategy<Value = Whole> {
    prop::array::uniform3(
        (-8..9_i64, -8..9_i64, -100..-15_i64).prop_map(|(x, y, z)| [x * z / 8, y * z / 8, z]),
    )
}

/// Some of both kinds.
pub fn soup(n: usize) -> impl Strategy<Value = Vec<Whole>> {
    prop::collection::vec(prop_oneof![ahead(), anywhere()], 1..n)
}

pub fn volume() -> ViewVolume {
    ViewVolume::perspective(90.0, 1.0, NEAR, FAR).expect("a volume")
}

pub fn placed(triangles: &[Whole]) -> Vec<[[f64; 3]; 3]> {
    let eighth = |x: i64| x as f64 / 8.0;
    triangles.iter().map(|t| t.map(|v| v.map(eighth))).collect()
}

pub fn surfaces(triangles: &[Whole], culls_backs: bool) -> Surfaces {
    Surfaces::new(SIZE, volume(), placed(triangles), culls_backs).expect("finite")
}

/// As many random cases as `PROPTEST_CASES` says, or these: what asks every pixel of a soup is slow.
pub fn cases(n: u32) -> ProptestConfig {
    let named = std::env::var("PROPTEST_CASES")
        .ok()
        .and_then(|n| n.parse().ok());
    ProptestConfig::with_cases(named.unwrap_or(n))
}

/// One in perspective and a parallel one.
pub fn volumes() -> [ViewVolume; 2] {
    [
        ViewVolume::perspective(50.0, 1.5, 0.5, 9.0).expect("a volume"),
        ViewVolume::parallel(3.0, 1.5, -1.0, 9.0).expect("a volume"),
    ]
}

/// A solid before the eye, turned so that none of its edges passes through a pixel's middle.
pub fn of_mesh(solid: Solid, volume: ViewVolume, size: [u32; 2], culls_backs: bool) -> Surfaces {
    let mesh = solid.mesh();
    let placed = Matrix::translation([0.1, -0.2, -4.0]).after(&Matrix::rotation([0.4, 0.7, 0.1]));
    let corners = mesh
        .faces()
        .iter()
        .map(|&face| mesh.corners(face).map(|p| placed.point(p)));
    Surfaces::new(size, volume, corners.collect::<Vec<_>>(), culls_backs).expect("finite")
}

/// Three bars around the middle: the near end of each lies over the far end of the next.
pub fn three_bars() -> [[[f64; 3]; 3]; 3] {
    [0.0, 1.0, 2.0].map(|k| {
        let turn = Matrix::rotation([0.0, 0.0, k * std::f64::consts::TAU / 3.0]);
        // Seen from the eye, from the lower left to the lower right; the far end is the broad one.
        let seen = [[-2.4, -1.4, 5.0], [-2.4, -0.7, 5.0], [2.6, -1.05, 3.0]];
        seen.map(|[x, y, w]: [f64; 3]| turn.point([x * w / 5.0, y * w / 5.0, -w]))
    })
}
