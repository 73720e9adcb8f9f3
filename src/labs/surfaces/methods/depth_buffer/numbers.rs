//! Depths as they are stored, in words and in pixels.

use crate::{
    algo::surface::{DepthBufferInput, DepthFormat, DepthNumber, Fragment},
    labs::space::{RasterPlan, Tones},
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

/// Where on their rays corners are, between the near and the far plane.
fn t_of_corners(surfaces: &Surfaces) -> impl Iterator<Item = f64> {
    let rays = Rays::of(surfaces);
    let corners = surfaces.triangles().iter().flatten();
    corners.map(move |[.., z]| rays.t_of(-z).clamp(1.0, rays.far()))
}

/// The largest depth that is stored for a corner.
fn largest(surfaces: &Surfaces, format: &DepthFormat) -> f64 {
    let rays = Rays::of(surfaces);
    let stored = t_of_corners(surfaces).map(|t| format.stored(rays.depth(t)));
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
/// stands for. Where a scale says from where to where, tones reach over all of it, else over what the scene has of it.
pub struct Shades<'a> {
    rays: Rays,
    format: &'a DepthFormat,
    numbers: InPixels<'a>,
    plan: &'a RasterPlan,
    ends: [f64; 2],
}

impl<'a> Shades<'a> {
    pub fn of<L: Variant>(input: &'a DepthBufferInput, plan: &'a RasterPlan) -> Self {
        let (surfaces, format) = (&input.surfaces, &input.format);
        let mut shades = Self {
            rays: Rays::of(surfaces),
            format,
            numbers: InPixels::of(surfaces, format),
            plan,
            ends: [0.0, 1.0],
        };
        if !plan.is_toned_alone() {
            let parts = t_of_corners(surfaces).map(|t| shades.part::<L>(t));
            let widened = |[least, most]: [f64; 2], part: f64| [least.min(part), most.max(part)];
            let [least, most] = parts.fold([1.0, 0.0], widened);
            // What is farthest still has a tone: it is not empty.
            shades.ends = [least, most + 0.2 * (most - least)];
        }
        shades
    }

    /// What is stored at a pixel, as it looks and as it is said.
    pub fn pixel<L: Variant>(&self, stored: f64, role: Role) -> Pixel {
        let depth = self.format.turned(stored);
        if !depth.is_finite() {
            let value = Some(self.numbers.value(stored));
            return Pixel {
                value,
                ..Pixel::EMPTY
            };
        }
        let t = t_of::<L>(&self.rays, depth);
        let [least, most] = self.ends;
        let value = if self.tells_distance() {
            short(self.rays.distance(t))
        } else {
            self.numbers.value(stored)
        };
        Pixel {
            role: Some(role),
            shade: (most - self.part::<L>(t)) / (most - least).max(f64::MIN_POSITIVE),
            value: Some(value),
        }
    }

    /// From near to far, of what tones tell.
    fn part<L: Variant>(&self, t: f64) -> f64 {
        let [near, far] = self.rays.ends();
        if self.tells_distance() || L::STRAIGHT_DISTANCE {
            (self.rays.distance(t) - near) / (far - near)
        } else {
            self.rays.depth(t)
        }
    }

    fn tells_distance(&self) -> bool {
        self.plan.tones == Tones::Distance
    }

    pub fn scale(&self) -> Option<[Value; 2]> {
        let nearest = self.format.nearest();
        let [near, far] = if self.tells_distance() {
            self.rays.ends().map(short)
        } else {
            [nearest, 1.0 - nearest].map(|depth| self.numbers.value(depth))
        };
        let end = |key, value| Value::Message(Message::new(key).with("value", value));
        let ends = [end("scale-near", near), end("scale-far", far)];
        self.plan.is_toned_alone().then_some(ends)
    }

    /// With its unit, and without.
    pub fn titles<L: Variant>(&self) -> (Value, Option<Value>) {
        if self.tells_distance() {
            (Value::Term("raster-distance"), None)
        } else if L::STRAIGHT_DISTANCE {
            let bare = Value::Term("raster-straight-bare");
            (Value::Term("raster-straight"), Some(bare))
        } else {
            let bare = Value::Term("raster-depth-bare");
            let bare = self.numbers.unit.is_some().then_some(bare);
            (self.numbers.title(), bare)
        }
    }
}

/// A distance in at most three characters, up to a thousand: a pixel has no room for more.
fn short(distance: f64) -> Value {
    let in_tenths = (distance * 10.0).round() / 10.0;
    let said = if in_tenths < 10.0 {
        in_tenths
    } else {
        distance.round()
    };
    Value::Formula(Formula::decimals().num(said))
}
