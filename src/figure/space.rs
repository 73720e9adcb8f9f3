//! A view of three dimensions: solids and marks, and what they are seen through.

use std::{collections::HashMap, sync::Arc};

use crate::{
    geom::{Camera, Orbit, pairs_around},
    text::Value,
};

use super::{
    facet::Facet,
    facets::Facets,
    role::{Label, Link, Role, told},
};

#[derive(Clone, PartialEq, Debug)]
pub struct Space {
    pub title: Option<Value>,
    pub seer: Seer,
    /// The faces of all solids.
    pub facets: Facets,
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
    Cross([f64; 3]),
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
