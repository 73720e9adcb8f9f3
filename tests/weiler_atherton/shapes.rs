//! Random polygons on small grids: vertices on edges, shared edges and common vertices are frequent.

use clipscope::geom::{GeomError, Region, SimplePolygon};
use proptest::prelude::*;

/// One ring.
pub type Outline = Vec<[i64; 2]>;

pub fn simple(outline: &[[i64; 2]]) -> Result<SimplePolygon, GeomError> {
    let floats: Vec<[f64; 2]> = outline.iter().map(|p| p.map(|x| x as f64)).collect();
    SimplePolygon::new(&floats)
}

pub fn region(outer: &[[i64; 2]], holes: &[Outline]) -> Option<Region> {
    let holes: Result<Vec<_>, _> = holes.iter().map(|hole| simple(hole)).collect();
    Region::new(simple(outer).ok()?, holes.ok()?).ok()
}

/// Random points joined in any order, then untangled: two edges that meet are exchanged for the two that join
/// their first ends and their last ones.
fn untangled(
    n: impl Into<prop::collection::SizeRange>,
    size: i64,
) -> impl Strategy<Value = Outline> {
    prop::collection::vec([0..=size, 0..=size], n).prop_filter_map("untangled", |points| {
        let mut outline: Outline = Vec::new();
        for p in points {
            if !outline.contains(&p) {
                outline.push(p);
            }
        }
        for _ in 0..200 {
            match simple(&outline) {
                Ok(_) => return Some(outline),
                Err(GeomError::EdgesMeet { edges: [i, j] }) => outline[i + 1..=j].reverse(),
                Err(_) => return None,
            }
        }
        None
    })
}

/// The border of some cells of a grid, grown from one, each `scale` wide.
fn cells(size: usize, n: usize, scale: i64) -> impl Strategy<Value = Outline> {
    prop::collection::vec((0..size * size, 0..4_usize), n).prop_filter_map(
        "one border",
        move |steps| {
            let mut taken = vec![false; size * size];
            taken[size * size / 2] = true;
            for (from, direction) in steps {
                let (x, y) = (from % size, from / size);
                let next = match direction {
                    0 if x + 1 < size => from + 1,
                    1 if x > 0 => from - 1,
                    2 if y + 1 < size => from + size,
                    3 if y > 0 => from - size,
                    _ => continue,
                };
                if taken[from] {
                    taken[next] = true;
                }
            }
            let outline = border(&taken, size as i64);
            let scaled: Outline = outline.into_iter().map(|p| p.map(|x| x * scale)).collect();
            simple(&scaled).is_ok().then_some(scaled)
        },
    )
}

/// Walks around the taken cells, keeping them to the left.
fn border(taken: &[bool], size: i64) -> Outline {
    let is_taken = |x: i64, y: i64| {
        (0..size).contains(&x) && (0..size).contains(&y) && taken[(y * size + x) as usize]
    };
    // The lowest one on the left: its lower side runs to the right.
    let cells = (0..size).flat_map(|x| (0..size).map(move |y| (x, y)));
    let first = cells.into_iter().find(|&(x, y)| is_taken(x, y));
    let Some((x, y)) = first else {
        return Vec::new();
    };
    let (start, mut at, mut heading) = ([x, y], [x, y], [1, 0]);
    let mut outline = Vec::new();
    loop {
        outline.push(at);
        at = [at[0] + heading[0], at[1] + heading[1]];
        if at == start || outline.len() > 400 {
            return outline;
        }
        // The cells ahead to the left and to the right, by the heading.
        let ahead = |left: [i64; 2]| {
            let corner = [0, 1].map(|k| 2 * at[k] + heading[k] + left[k]);
            is_taken((corner[0] - 1) / 2, (corner[1] - 1) / 2) && corner[0] > 0 && corner[1] > 0
        };
        let left = [-heading[1], heading[0]];
        heading = match (ahead(left), ahead(left.map(|x| -x))) {
            (true, true) => left.map(|x| -x),
            (true, false) => heading,
            (false, _) => left,
        };
    }
}

/// Corners around a centre, at growing angles.
fn star(n: usize, size: i64) -> impl Strategy<Value = Outline> {
    prop::collection::vec(0.2..1.0_f64, n).prop_filter_map("a simple star", move |radii| {
        let middle = size as f64 / 2.0;
        let outline: Outline = radii
            .iter()
            .enumerate()
            .map(|(i, radius)| {
                let (sin, cos) =
                    libm::sincos(std::f64::consts::TAU * i as f64 / radii.len() as f64);
                [cos, sin].map(|x| (middle + middle * radius * x).round() as i64)
            })
            .collect();
        simple(&outline).is_ok().then_some(outline)
    })
}

/// Any of them, within `0..=16`.
pub fn outline() -> impl Strategy<Value = Outline> {
    prop_oneof![
        untangled(3..12_usize, 5),
        untangled(3..20_usize, 16),
        cells(4, 40, 1),
        cells(5, 80, 3),
        star(9, 8),
        star(16, 16),
    ]
}

/// Two that have much in common: the second one is the first with a vertex less, moved, mirrored, or another one.
pub fn pair() -> impl Strategy<Value = [Outline; 2]> {
    let related = (outline(), 0..20_usize, [-1..=1_i64, -1..=1_i64], 0..4_usize).prop_filter_map(
        "simple",
        |(first, idx, by, how)| {
            let mut second = first.clone();
            match how {
                0 if second.len() > 3 => {
                    second.remove(idx % first.len());
                }
                1 => {
                    let moved = &mut second[idx % first.len()];
                    *moved = [moved[0] + by[0], moved[1] + by[1]];
                }
                2 => second = second.iter().map(|[x, y]| [x + by[0], y + by[1]]).collect(),
                _ => second = second.iter().map(|[x, y]| [*y, *x]).collect(),
            }
            simple(&second).is_ok().then_some([first, second])
        },
    );
    let whole = (outline(), outline()).prop_map(|(a, b)| [a, b]);
    prop_oneof![whole, related]
}

/// An outline of cells that are 4 wide, with a few holes of their own cells, and another outline of the same size.
pub fn with_holes() -> impl Strategy<Value = (Outline, Vec<Outline>, Outline)> {
    const HOLES: [&[[i64; 2]]; 5] = [
        &[[1, 1], [3, 1], [3, 3], [1, 3]],
        &[[1, 1], [3, 1], [2, 3]],
        &[[2, 1], [3, 2], [2, 3], [1, 2]],
        &[[1, 1], [2, 1], [2, 2], [3, 2], [3, 3], [1, 3]],
        &[[1, 2], [2, 1], [3, 3]],
    ];
    let holes = prop::collection::vec((0..25_usize, 0..HOLES.len()), 0..12);
    let clip = prop_oneof![
        untangled(3..16_usize, 20),
        cells(5, 80, 4),
        cells(10, 200, 2),
        star(12, 20)
    ];
    let outer = prop_oneof![
        cells(5, 120, 4),
        Just(vec![[0, 0], [20, 0], [20, 20], [0, 20]])
    ];
    (outer, holes, clip, any::<bool>()).prop_map(|(outer, holes, clip, around)| {
        let border = simple(&outer).expect("simple");
        let mut taken = [false; 25];
        let mut made = Vec::new();
        for (cell, shape) in holes {
            let at = [(cell % 5) as i64 * 4, (cell / 5) as i64 * 4];
            let hole: Outline = HOLES[shape]
                .iter()
                .map(|p| [p[0] + at[0], p[1] + at[1]])
                .collect();
            let [x, y] = hole[0].map(|x| x as f64);
            let p = clipscope::geom::Point::new(x, y).expect("finite");
            if !taken[cell] && border.locate(p) == clipscope::geom::Location::Inside {
                taken[cell] = true;
                made.push(hole);
            }
        }
        // Now and then the clip polygon runs along a hole.
        let clip = match made.first() {
            Some(hole) if around => hole.clone(),
            _ => clip,
        };
        (outer, made, clip)
    })
}
