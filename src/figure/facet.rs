//! A facet of a solid.

use glam::DVec3;

use crate::geom::Texture;

use super::role::{Link, Role};

#[derive(Clone, PartialEq, Debug)]
pub struct Facet {
    /// Three or more, counter-clockwise as seen from outside.
    pub corners: Vec<[f64; 3]>,
    pub role: Role,
    pub link: Option<Link>,
    pub skin: Option<Skin>,
    pub edging: Edging,
    /// How much of what is behind it hides, from 0 to 1.
    pub opacity: f32,
}

/// How the edges of a facet's solid are drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Edging {
    /// One by one: they are the space's.
    #[default]
    Lines,
    /// They are too many: outlines are found between the samples of the picture. Has the solid an edge that bounds only one facet?
    Samples { is_open: bool },
}

#[derive(Clone, PartialEq, Debug)]
pub struct Skin {
    pub texture: Texture,
    pub uvs: [[f32; 2]; 3],
}

impl Facet {
    pub fn uv_at(&self, at: [f64; 3]) -> [f32; 2] {
        let (Some(skin), [a, b, c, ..]) = (&self.skin, &self.corners[..]) else {
            return [0.0; 2];
        };
        let [a, b, c, at] = [*a, *b, *c, at].map(DVec3::from);
        let (along, aside) = (b - a, c - a);
        let normal = along.cross(aside);
        let area = normal.length_squared();
        if area == 0.0 {
            return skin.uvs[0];
        }
        let share = |of: DVec3| (of.dot(normal) / area) as f32;
        let (second, third) = (share((at - a).cross(aside)), share(along.cross(at - a)));
        let [first, uv_b, uv_c] = skin.uvs;
        std::array::from_fn(|i| {
            first[i] + second * (uv_b[i] - first[i]) + third * (uv_c[i] - first[i])
        })
    }

    pub fn part(&self, corners: Vec<[f64; 3]>) -> Self {
        let skin = self.skin.as_ref().filter(|_| corners.len() >= 3);
        let skin = skin.map(|skin| Skin {
            texture: skin.texture.clone(),
            uvs: [0, 1, 2].map(|i| self.uv_at(corners[i])),
        });
        Self {
            corners,
            skin,
            role: self.role,
            link: self.link,
            edging: self.edging,
            opacity: self.opacity,
        }
    }

    /// Away from the solid, of length 1; zero of a facet without an area.
    pub fn normal(&self) -> DVec3 {
        let corners = self.corners.iter().copied().map(DVec3::from);
        normal(&corners.collect::<Vec<_>>()).normalize_or_zero()
    }
}

/// Of a flat polygon, away from the side on which its corners go clockwise; as long as twice its area.
pub fn normal(corners: &[DVec3]) -> DVec3 {
    let from_first = |i: usize| corners[i] - corners[0];
    let fan = 2..corners.len();
    fan.map(|i| from_first(i - 1).cross(from_first(i))).sum()
}
