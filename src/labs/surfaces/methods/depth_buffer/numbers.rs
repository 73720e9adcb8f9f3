//! Depths as they are stored, in words and in pixels.

use crate::{
    algo::surface::{DepthFormat, DepthNumber, Fragment},
    labs::space::Tones,
};

use super::super::prelude::*;

use super::variant::Variant;

const THOUSANDTH: f64 = 0.001;

/// Along a pixel's ray, t where the depth is this by these rules.
pub fn t_of<L: Variant>(rays: &Rays, depth: f64) -> f64 {
    if L::STRAIGHT_DISTANCE {
        let [near, far] = rays.ends();
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
fn depth(formula: Formula, format: &DepthFormat, stored: f64) -> Formula {
    if stored.is_finite() {
        formula.num(shown(format, stored))
    } else if stored > 0.0 {
        formula.sym("∞")
    } else {
        formula.sym("−∞")
    }
}

/// `< 0.695`: what stands there, and how what is new compares to it.
pub fn against(format: &DepthFormat, fragment: &Fragment) -> Value {
    let sign = sign(fragment.new, fragment.stored);
    let sign = Formula::decimals().sym(format!("{sign} "));
    Value::Formula(depth(sign, format, fragment.stored))
}

pub fn value(format: &DepthFormat, stored: f64) -> Value {
    Value::Formula(depth(Formula::decimals(), format, stored))
}

/// Depths in pixels, where there is room for three digits.
pub struct InPixels<'a> {
    format: &'a DepthFormat,
    /// What one is, where that is not the step of a format.
    unit: Option<f64>,
}

impl<'a> InPixels<'a> {
    /// Steps where they have numbers; else thousandths, or finer parts where a reversed buffer keeps all of this scene near 0.
    pub fn of(surfaces: &Surfaces, format: &'a DepthFormat) -> Self {
        let unit = match format.number {
            DepthNumber::Fixed(_) => None,
            DepthNumber::Double | DepthNumber::Single if format.is_reversed => {
                Some(THOUSANDTH.min(unit_of(largest(surfaces, format))))
            }
            DepthNumber::Double | DepthNumber::Single => Some(THOUSANDTH),
        };
        Self { format, unit }
    }

    pub fn value(&self, stored: f64) -> Value {
        if !stored.is_finite() {
            let infinite = depth(Formula::default(), self.format, stored);
            return Value::Formula(infinite);
        }
        let n_units = shown(self.format, stored) / self.unit.unwrap_or(1.0);
        Value::Count(n_units.round().max(0.0) as usize)
    }

    pub fn title(&self) -> Value {
        match (self.format.number, self.unit) {
            (DepthNumber::Fixed(bits), _) => {
                let message = Message::new("raster-depth-steps").with("bits", bits.get() as usize);
                Value::Message(message.with("last", bits.largest() as usize))
            }
            (_, Some(unit)) if unit < THOUSANDTH => {
                let unit = Formula::decimals().num(unit);
                Value::Message(Message::new("raster-depth-unit").with("unit", unit))
            }
            (DepthNumber::Double | DepthNumber::Single, _) => Value::Term("raster-depth"),
        }
    }
}

/// The largest depth that is stored for a corner between the near and the far plane.
fn largest(surfaces: &Surfaces, format: &DepthFormat) -> f64 {
    let rays = Rays::of(surfaces);
    let corners = surfaces.triangles().iter().flatten();
    let stored = corners.map(|[.., z]| {
        let depth = rays.depth(rays.t_of(-z).clamp(1.0, rays.far()));
        format.stored(depth)
    });
    stored.fold(0.0, f64::max)
}

/// A power of ten that fits into this at least a hundred and fewer than a thousand times.
fn unit_of(largest: f64) -> f64 {
    if largest > 0.0 {
        libm::pow(10.0, libm::log10(largest).floor() - 2.0)
    } else {
        THOUSANDTH
    }
}

/// The buffer as a picture: what is near is dark, what is far is pale, by the depth that is stored or by the distance that it
/// stands for.
pub struct Shades<'a> {
    pub rays: Rays,
    pub format: &'a DepthFormat,
    pub numbers: &'a InPixels<'a>,
    pub tones: Tones,
}

impl Shades<'_> {
    /// What is stored at a pixel, as it looks and as it is said; none where the pixel looks like its triangle.
    pub fn pixel<L: Variant>(&self, stored: f64) -> Option<Pixel> {
        let depth = self.format.turned(stored);
        let [near, far] = self.rays.ends();
        let (part, value) = match self.tones {
            Tones::Triangles => return None,
            _ if !depth.is_finite() => return Some(Pixel::EMPTY),
            Tones::Stored => (depth, Some(self.numbers.value(stored))),
            Tones::Distance => {
                let distance = self.rays.distance(t_of::<L>(&self.rays, depth));
                ((distance - near) / (far - near), Some(short(distance)))
            }
        };
        Some(Pixel {
            role: Some(Role::Soft),
            shade: 1.0 - part,
            value,
        })
    }

    pub fn scale(&self) -> Option<[Value; 2]> {
        let nearest = self.format.nearest();
        let values = match self.tones {
            Tones::Triangles => return None,
            Tones::Stored => [nearest, 1.0 - nearest].map(|depth| self.numbers.value(depth)),
            Tones::Distance => self.rays.ends().map(short),
        };
        let [near, far] = values;
        let end = |key, value| Value::Message(Message::new(key).with("value", value));
        Some([end("scale-near", near), end("scale-far", far)])
    }

    pub fn title<L: Variant>(&self) -> Value {
        match self.tones {
            Tones::Distance => Value::Term("raster-distance"),
            Tones::Triangles | Tones::Stored if L::STRAIGHT_DISTANCE => {
                Value::Term("raster-straight")
            }
            Tones::Triangles | Tones::Stored => self.numbers.title(),
        }
    }
}

/// A distance with at most three digits: a pixel has no room for more.
fn short(distance: f64) -> Value {
    let parts = if distance.abs() < 100.0 { 10.0 } else { 1.0 };
    Value::Formula(Formula::decimals().num((distance * parts).round() / parts))
}
