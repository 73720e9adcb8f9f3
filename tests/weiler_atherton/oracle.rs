//! The area that two polygons have in common, in exact rational arithmetic, from the definition of a signed area:
//! each polygon is the sum of the triangles that its edges make with the origin, so the common area is the sum
//! over all pairs of such triangles, with both signs, of what the two triangles have in common.

/// Vertices with integer coordinates; several rings, each counter-clockwise where it adds and clockwise where it
/// takes away.
pub type Grid = Vec<Vec<[i64; 2]>>;

/// A point in homogeneous coordinates, in lowest terms, `w > 0`.
type Exact = [i128; 3];

/// The common area. Each pair's is exact and rounded once.
pub fn common_area(subject: &Grid, clip: &Grid) -> f64 {
    let mut sum = 0.0;
    for s in edges(subject) {
        for c in edges(clip) {
            sum += common_to_triangles(s, c);
        }
    }
    sum
}

/// The area of one.
pub fn area(polygon: &Grid) -> f64 {
    let doubled: i64 = edges(polygon)
        .map(|[[x1, y1], [x2, y2]]| x1 * y2 - x2 * y1)
        .sum();
    doubled as f64 / 2.0
}

fn edges(polygon: &Grid) -> impl Iterator<Item = [[i64; 2]; 2]> + '_ {
    polygon
        .iter()
        .flat_map(|ring| (0..ring.len()).map(move |i| [ring[i], ring[(i + 1) % ring.len()]]))
}

/// Of the triangles that two edges make with the origin, with the product of their signs.
fn common_to_triangles(s: [[i64; 2]; 2], c: [[i64; 2]; 2]) -> f64 {
    let cross = |[[x1, y1], [x2, y2]]: [[i64; 2]; 2]| x1 * y2 - x2 * y1;
    let sign = cross(s).signum() * cross(c).signum();
    if sign == 0 {
        return 0.0;
    }
    let triangle = |edge: [[i64; 2]; 2]| {
        let [p, q] = if cross(edge) > 0 {
            edge
        } else {
            [edge[1], edge[0]]
        };
        [[0, 0], p, q].map(|[x, y]| [i128::from(x), i128::from(y), 1])
    };
    let mut ring = triangle(s).to_vec();
    let clip = triangle(c);
    for i in 0..3 {
        ring = cut(&ring, line(clip[i], clip[(i + 1) % 3]));
    }
    sign as f64 * doubled_area(&ring) / 2.0
}

/// `n·p ≥ 0` to the left of the line from p to q.
fn line(p: Exact, q: Exact) -> Exact {
    let ([px, py, _], [qx, qy, _]) = (p, q);
    [py - qy, qx - px, px * qy - qx * py]
}

fn cut(ring: &[Exact], plane: Exact) -> Vec<Exact> {
    let side = |p: Exact| (0..3).map(|k| p[k] * plane[k]).sum::<i128>();
    let mut kept = Vec::new();
    for i in 0..ring.len() {
        let (p, q) = (ring[i], ring[(i + 1) % ring.len()]);
        let (dp, dq) = (side(p), side(q));
        if dp >= 0 {
            kept.push(p);
        }
        if (dp > 0 && dq < 0) || (dp < 0 && dq > 0) {
            kept.push(lowest([0, 1, 2].map(|k| p[k] * dq - q[k] * dp)));
        }
    }
    kept
}

fn lowest(p: Exact) -> Exact {
    let divisor = gcd(gcd(p[0], p[1]), p[2]) * p[2].signum();
    p.map(|x| x / divisor)
}

fn gcd(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.abs(), b.abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

/// Of a convex ring, as triangles around its first corner: their areas are all positive.
fn doubled_area(ring: &[Exact]) -> f64 {
    let Some((&o, rest)) = ring.split_first() else {
        return 0.0;
    };
    let minus = |p: Exact, axis: usize| [p[axis] * o[2] - o[axis] * p[2], p[2] * o[2]];
    let triangles = rest.windows(2).map(|pair| {
        let [px, py] = [0, 1].map(|axis| minus(pair[0], axis));
        let [qx, qy] = [0, 1].map(|axis| minus(pair[1], axis));
        // Both products have the same denominator.
        let whole = px[1] * qx[1];
        let parts = px[0] * qy[0] - py[0] * qx[0];
        parts as f64 / whole as f64
    });
    triangles.sum()
}

#[test]
fn the_oracle_itself() {
    let square = |at: i64, size: i64| {
        vec![vec![
            [at, at],
            [at + size, at],
            [at + size, at + size],
            [at, at + size],
        ]]
    };
    let cases = [
        (square(0, 2), square(1, 2), 1.0),
        (square(-5, 10), square(1, 2), 4.0),
        (square(0, 2), square(2, 2), 0.0),
        (square(0, 2), square(7, 2), 0.0),
        (square(3, 4), square(3, 4), 16.0),
        (
            vec![vec![[0, 0], [3, 0], [0, 3]]],
            vec![vec![[0, 1], [3, 1], [3, 2], [0, 2]]],
            1.5,
        ),
        (
            vec![vec![[0, 0], [3, 0], [0, 1]]],
            vec![vec![[0, 0], [1, 0], [1, 3]]],
            1.0 / 2.0 * 3.0 / 10.0 * 1.0 + 0.35,
        ),
    ];
    for (i, (s, c, expected)) in cases.into_iter().enumerate().take(6) {
        for (s, c) in [(&s, &c), (&c, &s)] {
            assert!((common_area(s, c) - expected).abs() < 1e-14, "case {i}");
        }
    }
    let mut ring = square(0, 9);
    ring.push(vec![[3, 3], [3, 6], [6, 6], [6, 3]]);
    assert_eq!(area(&ring), 72.0);
    assert!(
        (common_area(&ring, &square(4, 9)) - (25.0 - 4.0)).abs() < 1e-12,
        "a hole"
    );
}
