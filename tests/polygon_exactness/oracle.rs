//! The true area of what two polygons have in common, from the definition: the integral of both winding numbers'
//! product, for any two rings of integer coordinates.
//!
//! ```text
//!   ───────●──────────    Cut into strips at every vertex and every crossing of two edges: within a strip
//!      ╱──/──╲────────    no edges cross, so that their order at its middle holds all over it, and a
//!   ──●──/────●───────    trapezoid's area is its width there times its height.
//! ```
//!
//! Strips and widths are exact rational numbers; only each strip's finished area is rounded.

use std::cmp::Ordering;

/// A rational number in lowest terms, with a positive denominator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Rational {
    num: i128,
    den: i128,
}

impl Rational {
    fn new(num: i128, den: i128) -> Self {
        let (mut a, mut b) = (num.abs(), den.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let divisor = a.max(1) * den.signum();
        Self {
            num: num / divisor,
            den: den / divisor,
        }
    }

    fn plus(self, other: Self) -> Self {
        Self::new(
            self.num * other.den + other.num * self.den,
            self.den * other.den,
        )
    }

    fn minus(self, other: Self) -> Self {
        self.plus(Self::new(-other.num, other.den))
    }

    fn times(self, other: Self) -> Self {
        Self::new(self.num * other.num, self.den * other.den)
    }

    fn to_f64(self) -> f64 {
        self.num as f64 / self.den as f64
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.num * other.den).cmp(&(other.num * self.den))
    }
}

/// A point with integer coordinates.
type Grid = [i64; 2];

/// An edge that is not level, of the first ring or the second.
#[derive(Clone, Copy)]
struct Edge {
    from: [i128; 2],
    to: [i128; 2],
    ring: usize,
}

impl Edge {
    fn x_at(&self, y: Rational) -> Rational {
        let [dx, dy] = [0, 1].map(|i| self.to[i] - self.from[i]);
        let whole = |k: i128| Rational::new(k, 1);
        let along = y.minus(whole(self.from[1])).times(Rational::new(dx, dy));
        whole(self.from[0]).plus(along)
    }

    fn spans(&self, low: Rational, high: Rational) -> bool {
        let [from, to] = [self.from, self.to].map(|p| Rational::new(p[1], 1));
        from.min(to) <= low && high <= from.max(to)
    }

    /// The height at which the lines of two edges cross.
    fn crossing_y(&self, other: &Self) -> Option<Rational> {
        let d = |edge: &Self| [0, 1].map(|i| edge.to[i] - edge.from[i]);
        let ([ax, ay], [bx, by]) = (d(self), d(other));
        let det = ax * by - ay * bx;
        let [wx, wy] = [0, 1].map(|i| other.from[i] - self.from[i]);
        let along = wx * by - wy * bx;
        (det != 0).then(|| Rational::new(self.from[1] * det + along * ay, det))
    }
}

fn edges(outline: &[Grid], ring: usize) -> impl Iterator<Item = Edge> {
    let n = outline.len();
    (0..n)
        .map(move |i| {
            let [from, to] = [outline[i], outline[(i + 1) % n]].map(|p| p.map(i128::from));
            Edge { from, to, ring }
        })
        .filter(|edge| edge.from[1] != edge.to[1])
}

/// The integral of the product of the winding numbers of two rings: for simple, counter-clockwise ones the area
/// of their intersection; negative where one of them is clockwise.
pub fn common_area(first: &[Grid], second: &[Grid]) -> f64 {
    let edges: Vec<Edge> = edges(first, 0).chain(edges(second, 1)).collect();
    let mut heights: Vec<Rational> = edges
        .iter()
        .map(|edge| Rational::new(edge.from[1], 1))
        .collect();
    for (i, a) in edges.iter().enumerate() {
        heights.extend(edges[i + 1..].iter().filter_map(|b| a.crossing_y(b)));
    }
    heights.sort();
    heights.dedup();
    heights
        .windows(2)
        .map(|pair| strip(&edges, pair[0], pair[1]))
        .sum()
}

fn strip(edges: &[Edge], low: Rational, high: Rational) -> f64 {
    let middle = low.plus(high).times(Rational::new(1, 2));
    let mut crossed: Vec<(Rational, &Edge)> = edges
        .iter()
        .filter(|edge| edge.spans(low, high))
        .map(|edge| (edge.x_at(middle), edge))
        .collect();
    crossed.sort_by_key(|&(x, _)| x);
    let mut winding = [0_i128; 2];
    let mut width = 0.0;
    for (i, &(x, edge)) in crossed.iter().enumerate() {
        if i > 0 {
            let whole = Rational::new(winding[0] * winding[1], 1);
            width += x.minus(crossed[i - 1].0).times(whole).to_f64();
        }
        // Counter-clockwise, the left edge goes down.
        winding[edge.ring] += if edge.to[1] < edge.from[1] { 1 } else { -1 };
    }
    width * high.minus(low).to_f64()
}

#[test]
fn the_oracle_itself() {
    let square =
        |x: i64, y: i64, side: i64| [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    assert_eq!(common_area(&square(0, 0, 4), &square(2, 1, 4)), 6.0);
    assert_eq!(
        common_area(&square(0, 0, 4), &square(4, 0, 4)),
        0.0,
        "touching"
    );
    assert_eq!(
        common_area(&square(0, 0, 4), &square(0, 0, 4)),
        16.0,
        "identical"
    );
    let mut clockwise = square(2, 1, 4);
    clockwise.reverse();
    assert_eq!(common_area(&square(0, 0, 4), &clockwise), -6.0);
    let bow_tie = [[0, 0], [4, 4], [4, 0], [0, 4]];
    assert_eq!(
        common_area(&square(0, 0, 4), &bow_tie),
        0.0,
        "its halves cancel out"
    );
    assert_eq!(
        common_area(&square(2, 0, 4), &bow_tie),
        -4.0,
        "its right half runs clockwise"
    );
    let triangle = [[0, 0], [3, 0], [0, 3]];
    assert_eq!(common_area(&triangle, &square(1, 1, 9)), 0.5);
}
