//! A view of three dimensions: solids and marks, and what they are seen through.

use std::{collections::HashMap, sync::Arc};

use glam::DVec3;

use crate::{
    geom::{Camera, Orbit, Texture},
    text::Value,
};

use super::{
    mark::Label,
    role::{Link, Role},
};

/// What is seen in space. It is turned into marks of a plane by [`super::project`], before anything is painted.
#[derive(Clone, PartialEq, Debug)]
pub struct Space {
    /// Over it, where two stand side by side: "Observer".
    pub title: Option<Value>,
    /// What it is seen through, until the viewer turns it.
    pub seer: Seer,
    /// The faces of all solids. Shared, so that a step that changes none copies none.
    pub facets: Arc<[Facet]>,
    /// The edges of all solids that may be drawn.
    pub edges: Arc<[Edge3]>,
    /// What is drawn over them.
    pub marks: Vec<Mark3>,
}

/// What a space is seen through.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Seer {
    /// An eye of the viewer's own, who may go round.
    Eye(Orbit),
    /// The camera that the scene is about: its whole picture, in a frame.
    Camera(Camera),
    /// An eye in another space than the world: nothing of the scene can be taken hold of there.
    Apart(Orbit),
}

/// A face of a solid: convex and flat.
#[derive(Clone, PartialEq, Debug)]
pub struct Facet {
    /// Three or more, counter-clockwise as seen from outside.
    pub corners: Vec<[f64; 3]>,
    /// What it means.
    pub role: Role,
    /// What it is about.
    pub link: Option<Link>,
    /// What it is painted with.
    pub skin: Option<Skin>,
}

/// A part of a texture.
#[derive(Clone, PartialEq, Debug)]
pub struct Skin {
    /// The whole of it.
    pub texture: Texture,
    /// Where in it the facet's first three corners lie.
    pub uvs: [[f32; 2]; 3],
}

/// An edge of a solid.
#[derive(Clone, PartialEq, Debug)]
pub struct Edge3 {
    /// From, to.
    pub ends: [[f64; 3]; 2],
    /// The facets that meet in it, by their index; of an edge that bounds one, the other is missing.
    pub facets: [Option<u32>; 2],
    /// Do they meet at an angle that is meant? Of a round solid they do not: such an edge is drawn where it is part of the
    /// outline, and as a hairline elsewhere.
    pub is_crease: bool,
    /// [`Role::Ink`] of a solid, [`Role::Discarded`] of what is cut away, [`Role::Accent`] of a cut.
    pub role: Role,
}

/// A mark in space.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark3 {
    /// Where and what.
    pub shape: Shape3,
    /// Its meaning.
    pub role: Role,
    /// Text beside it.
    pub label: Option<Label>,
    /// What it is about.
    pub link: Option<Link>,
    /// A line of construction: a frustum's edge, a sight line, a drop line to the ground.
    pub is_fine: bool,
    /// Dashed whatever its role: not there to stay, and yet what the step is about.
    pub is_dashed: bool,
    /// Is it an edge of an outline, and as light as that?
    pub is_edge: bool,
}

/// Something to draw, at world coordinates.
#[derive(Clone, PartialEq, Debug)]
pub enum Shape3 {
    /// From a to b; dashed where a solid hides it.
    Segment([[f64; 3]; 2]),
    /// A segment with a head at b, seen through everything: a vector, a normal.
    Arrow([[f64; 3]; 2]),
    /// From point to point and back to the first, dashed where a solid hides it.
    Outline(Vec<[f64; 3]>),
    /// A flat convex area, a tint of its role; solids cover it.
    Wash(Vec<[f64; 3]>),
    /// The outline of a ball as it is seen: centre and radius. Seen through everything.
    Ball([f64; 3], f64),
    /// The small square that says that the directions from the first point to the other two are at right angles.
    RightAngle([[f64; 3]; 3]),
    /// The arc at the first point, from the direction of the second to that of the third, the shorter way round.
    Angle([[f64; 3]; 3]),
    /// A filled point, seen through everything.
    Dot([f64; 3]),
    /// A hollow point, seen through everything.
    Ring([f64; 3]),
    /// A label alone.
    Label([f64; 3]),
}

impl Mark3 {
    /// Without label or link.
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

    /// One edge of an outline, drawn as that.
    pub const fn edge(mut self) -> Self {
        self.is_edge = true;
        self
    }

    /// With a label in the text face.
    pub fn labelled(mut self, text: impl Into<Value>) -> Self {
        self.label = Some(Label::new(text, false));
        self
    }

    /// Its label set semibold.
    pub fn strong(mut self) -> Self {
        if let Some(label) = &mut self.label {
            label.strong = true;
        }
        self
    }

    /// A line of construction.
    pub const fn fine(mut self) -> Self {
        self.is_fine = true;
        self
    }

    /// Drawn with dashes, in its role's colour.
    pub const fn dashed(mut self) -> Self {
        self.is_dashed = true;
        self
    }

    /// About `link`.
    pub fn linked(mut self, link: impl Into<Link>) -> Self {
        self.link = Some(link.into());
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
            let next = facet.corners.iter().cycle().skip(1);
            for (&a, &b) in facet.corners.iter().zip(next) {
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
    /// Where in its texture a place of its plane lies; a facet without one, or without an area, says nothing.
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

    /// A part of it, in its plane.
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
        let Some((&first, rest)) = self.corners.split_first() else {
            return DVec3::ZERO;
        };
        let first = DVec3::from(first);
        let from_first = |at: [f64; 3]| DVec3::from(at) - first;
        let fan = rest.windows(2);
        let sum: DVec3 = fan
            .map(|pair| from_first(pair[0]).cross(from_first(pair[1])))
            .sum();
        sum.normalize_or_zero()
    }
}
