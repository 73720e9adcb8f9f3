//! The true answer for integer coordinates, in exact rational arithmetic, written from the definition: the
//! part of the parameter interval in which four inequalities hold.

/// A rational number with a positive denominator.
#[derive(Clone, Copy)]
struct Rational {
    num: i128,
    den: i128,
}

impl Rational {
    fn new(num: i128, den: i128) -> Self {
        let sign = den.signum();
        Self {
            num: num * sign,
            den: den * sign,
        }
    }

    fn is_less(self, other: Self) -> bool {
        self.num * other.den < other.num * self.den
    }

    /// Correctly rounded: one division of two numbers that are exact in f64.
    fn round(self) -> f64 {
        assert!(self.num.abs() < 1 << 53 && self.den < 1 << 53, "in range");
        self.num as f64 / self.den as f64
    }
}

/// What is visible of `[x1, y1, x2, y2]` in `[xmin, ymin, xmax, ymax]`, each coordinate correctly rounded.
pub fn clip(window: [i64; 4], segment: [i64; 4]) -> Option<[f64; 4]> {
    let [xmin, ymin, xmax, ymax] = window.map(i128::from);
    let [x1, y1, x2, y2] = segment.map(i128::from);
    let (dx, dy) = (x2 - x1, y2 - y1);
    let (mut from, mut to) = (Rational::new(0, 1), Rational::new(1, 1));
    // a + u·da ≥ 0 for each side.
    for (a, da) in [
        (x1 - xmin, dx),
        (xmax - x1, -dx),
        (y1 - ymin, dy),
        (ymax - y1, -dy),
    ] {
        if da == 0 {
            if a < 0 {
                return None;
            }
            continue;
        }
        let u = Rational::new(-a, da);
        if da > 0 && from.is_less(u) {
            from = u;
        }
        if da < 0 && u.is_less(to) {
            to = u;
        }
    }
    if to.is_less(from) {
        return None;
    }
    let at = |u: Rational, a: i128, da: i128| Rational::new(a * u.den + u.num * da, u.den).round();
    Some([
        at(from, x1, dx),
        at(from, y1, dy),
        at(to, x1, dx),
        at(to, y1, dy),
    ])
}

#[test]
fn the_oracle_itself() {
    let unit = [-1, -1, 1, 1];
    assert_eq!(clip(unit, [0, 0, 4, 0]), Some([0.0, 0.0, 1.0, 0.0]));
    assert_eq!(
        clip(unit, [-2, 0, 0, 2]),
        Some([-1.0, 1.0, -1.0, 1.0]),
        "a touched corner"
    );
    assert_eq!(clip(unit, [-2, 0, 0, 3]), None, "past the corner");
    assert_eq!(clip(unit, [2, 2, 2, 2]), None, "a point outside");
    assert_eq!(
        clip([0, 0, 3, 3], [-1, 0, 2, 1]),
        Some([0.0, 1.0 / 3.0, 2.0, 1.0])
    );
}
