//! The buffer as a picture: what is near is dark, what is far is pale, by the depth that is stored or by the distance that it
//! stands for.

use crate::{
    algo::surface::{DepthFormat, DepthNumber, Rays},
    figure::{Pixel, Role},
    labs::space::Tones,
    text::{Formula, Message, Value},
};

use super::{
    numbers::{in_pixel, t_of},
    variant::Variant,
};

/// Depths of one picture as shades.
pub struct Shades<'a> {
    pub rays: Rays,
    pub format: &'a DepthFormat,
    pub tones: Tones,
}

impl Shades<'_> {
    /// What is stored at a pixel, as it looks and as it is said; none where the pixel looks like its triangle.
    pub fn pixel<L: Variant>(&self, stored: f64) -> Option<Pixel> {
        let depth = self.format.forward(stored);
        let [near, far] = self.ends();
        let (part, value) = match self.tones {
            Tones::Triangles => return None,
            _ if !depth.is_finite() => return Some(Pixel::EMPTY),
            Tones::Stored => (depth, in_pixel(self.format, stored)),
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

    /// Distances of the near and the far plane.
    fn ends(&self) -> [f64; 2] {
        [1.0, self.rays.far()].map(|t| self.rays.distance(t))
    }

    /// What the darkest and the palest shade stand for.
    pub fn scale(&self) -> Option<[Value; 2]> {
        let nearest = self.format.nearest();
        let values = match self.tones {
            Tones::Triangles => return None,
            Tones::Stored => [nearest, 1.0 - nearest].map(|depth| in_pixel(self.format, depth)),
            Tones::Distance => self.ends().map(|distance| Some(short(distance))),
        };
        let [near, far] = values;
        let end = |key, value| Value::Message(Message::new(key).with("value", value));
        Some([end("scale-near", near?), end("scale-far", far?)])
    }

    pub fn title(&self) -> Value {
        match (self.tones, self.format.number) {
            (Tones::Distance, _) => Value::Term("raster-distance"),
            (_, DepthNumber::Fixed(bits)) => {
                let message = Message::new("raster-depth-steps").with("bits", bits.get() as usize);
                Value::Message(message.with("last", bits.largest() as usize))
            }
            (_, DepthNumber::Double | DepthNumber::Single) => Value::Term("raster-depth"),
        }
    }
}

/// A distance with at most three digits: a pixel has no room for more.
fn short(distance: f64) -> Value {
    let parts = if distance.abs() < 100.0 { 10.0 } else { 1.0 };
    Value::Formula(Formula::decimals().num((distance * parts).round() / parts))
}
