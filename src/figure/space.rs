//! A view of three dimensions: solids and marks, and what they are seen through.

use std::{collections::HashMap, sync::Arc};

use glam::DVec3;

use crate::{
    geom::{Camera, Orbit, Texture, pairs_around},
    text::Value,
};

use super::role::{Label, Link, Role, told};

#[derive(Clone, PartialEq, Debug)]
pub struct Space {
    pub title: Option<Value>,
    pub seer: Seer,
    /// The faces of all solids. Shared, so that a step that changes none copies none.
    pub facets: Arc<[Facet]>,
    pub edges: Arc<[Edge3]>,
    pub marks: Vec<Mark3>,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Seer {
    Eye(Orbit),
    Camera(Camera),
    /// An eye in another space than the world: nothing of the scene can be taken hold of there.
    Apart(Orbit),
}

#[derive(Clone, PartialEq, Debug)]
pub struct Facet {
    /// Three or more, counter-clockwise as seen from outside.
    pub corners: Vec<[f64; 3]>,
    pub role: Role,
    pub link: Option<Link>,
    pub skin: Option<Skin>,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Skin {
    pub texture: Texture,
    pub uvs: [[f32; 2]; 3],
}

#[derive(Clone, PartialEq, Debug)]
pub struct Edge3 {
    pub ends: [[f64; 3]; 2],
    /// The facets that meet in it, by their index; of an edge that bounds one, the other is missing.
    pub facets: [Option<u32>; 2],
    /// Do they meet at an angle that is meant? Otherwise it is drawn as part of the outline, or as a hairline.
    pub is_crease: bool,
    /// [`Role::Ink`] of a solid, [`Role::Discarded`] of what is cut away, [`Role::Accent`] of a cut.
    pub role: Role,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Mark3 {
    pub shape: Shape3,
    pub role: Role,
    pub label: Option<Label>,
    pub link: Option<Link>,
    /// A line of construction: a frustum's edge, a sight line, a drop line to the ground.
    pub is_fine: bool,
    pub is_dashed: bool,
    /// Is it an edge of an outline, and as light as that?
    pub is_edge: bool,
}

#[derive(Clone, PartialEq, Debug)]
pub enum Shape3 {
    Segment([[f64; 3]; 2]),
    Arrow([[f64; 3]; 2]),
    /// From point to point and back to the first, dashed where a solid hides it.
    Outline(Vec<[f64; 3]>),
    /// The outline of a part of a plane: what is about the plane is seen as well on its edge.
    Sheet(Vec<[f64; 3]>),
    Wash(Vec<[f64; 3]>),
    /// The outline of a ball as it is seen: centre and radius. Seen through everything.
    Ball([f64; 3], f64),
    RightAngle([[f64; 3]; 3]),
    Angle([[f64; 3]; 3]),
    Dot([f64; 3]),
    Ring([f64; 3]),
    Label([f64; 3]),
}

told!(Mark3);

impl Mark3 {
    pub const fn new(role: Role, shape: Shape3) -> Self {
        Self {
            shape,
            role,
            label: None,
            link: None,
            is_fine: false,
            is_dashed: false,
            is_edge: false,
        }
    }

    pub const fn edge(mut self) -> Self {
        self.is_edge = true;
        self
    }

    pub const fn fine(mut self) -> Self {
        self.is_fine = true;
        self
    }
}

impl Edge3 {
    /// How far two facets turn from one plane, at least, so that their edge is a crease: the cosine, of 20°.
    const FLAT: f64 = 0.94;

    /// The edges of facets that meet corner on corner, each once. Where they meet at more than 20° it is a crease.
    pub fn of(facets: &[Facet]) -> Vec<Self> {
        let mut known: HashMap<[[u64; 3]; 2], usize> = HashMap::new();
        let mut edges: Vec<Self> = Vec::new();
        let bits = |at: [f64; 3]| at.map(|x| (x + 0.0).to_bits());
        for (idx, facet) in (0..).zip(facets) {
            for [a, b] in pairs_around(&facet.corners) {
                let twin = known.get(&[bits(b), bits(a)]).copied();
                if let Some(edge) = twin.and_then(|twin| edges.get_mut(twin)) {
                    edge.facets[1] = Some(idx);
                    let [one, other] = edge
                        .facets
                        .map(|at| facets[at.unwrap_or(idx) as usize].normal());
                    edge.is_crease = one.dot(other) < Self::FLAT;
                    continue;
                }
                known.insert([bits(a), bits(b)], edges.len());
                edges.push(Self {
                    ends: [a, b],
                    facets: [Some(idx), None],
                    is_crease: true,
                    role: Role::Ink,
                });
            }
        }
        edges
    }
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
            role: self.role,
            link: self.link,
            skin,
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
