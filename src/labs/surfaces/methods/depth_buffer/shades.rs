//! The buffer as a picture: what is near is dark, what is far is pale, by the depth that is stored or by the distance that it
//! stands for.

use crate::{algo::surface::DepthFormat, labs::space::Tones};

use super::super::prelude::*;

use super::{
    numbers::{InPixels, t_of},
    variant::Variant,
};

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
