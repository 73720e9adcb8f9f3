//! Depths as they are stored, in words and in pixels.

use crate::{
    algo::surface::{DepthFormat, DepthNumber, Fragment, Rays},
    text::{Formula, Value},
};

use super::variant::Variant;

/// Along a pixel's ray, t where the depth is this by these rules.
pub fn t_of<L: Variant>(rays: &Rays, depth: f64) -> f64 {
    if L::STRAIGHT_DISTANCE {
        let [near, far] = [1.0, rays.far()].map(|t| rays.distance(t));
        rays.t_of(near + depth * (far - near))
    } else {
        rays.t_at(depth)
    }
}

/// As the buffer holds it: of fixed point the number of its step.
fn shown(format: &DepthFormat, stored: f64) -> f64 {
    match format.number {
        DepthNumber::Double | DepthNumber::Single => stored,
        DepthNumber::Fixed(bits) => (stored * bits.largest()).round(),
    }
}

/// `0.647`, or ∞.
pub fn depth(formula: Formula, format: &DepthFormat, stored: f64) -> Formula {
    if stored.is_finite() {
        formula.num(shown(format, stored))
    } else if stored > 0.0 {
        formula.sym("∞")
    } else {
        formula.sym("−∞")
    }
}

/// `0.647 < 0.695`: what is new, and what stands there.
pub fn comparison(format: &DepthFormat, fragment: &Fragment) -> Formula {
    let new = depth(Formula::decimals(), format, fragment.new);
    let new = new.sym(format!(" {} ", sign(fragment)));
    depth(new, format, fragment.stored)
}

/// `< 0.695`: what stands there, and how what is new compares to it.
pub fn against(format: &DepthFormat, fragment: &Fragment) -> Value {
    let sign = Formula::decimals().sym(format!("{} ", sign(fragment)));
    Value::Formula(depth(sign, format, fragment.stored))
}

fn sign(fragment: &Fragment) -> char {
    match fragment.new.total_cmp(&fragment.stored) {
        std::cmp::Ordering::Less => '<',
        std::cmp::Ordering::Equal => '=',
        std::cmp::Ordering::Greater => '>',
    }
}

/// `0.647`, for a table.
pub fn value(format: &DepthFormat, stored: f64) -> Value {
    Value::Formula(depth(Formula::decimals(), format, stored))
}

/// In a pixel, where there is room for three digits: thousandths, or the number of the step.
pub fn in_pixel(format: &DepthFormat, stored: f64) -> Option<Value> {
    let scale = match format.number {
        DepthNumber::Double | DepthNumber::Single => 1000.0,
        DepthNumber::Fixed(_) => 1.0,
    };
    let is_written = stored.is_finite();
    is_written.then(|| Value::Count((shown(format, stored) * scale).round().max(0.0) as usize))
}
