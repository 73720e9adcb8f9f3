//! Solids as facets and edges, drawn by what becomes of them.

use std::ops::Range;

use crate::{
    algo::volume::{signed_distance, split},
    figure::{Edging, between, complement, inside},
};

use super::{super::Object, prelude::*};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fate {
    ToCome,
    Kept,
    /// It straddles: what is beyond the volume is shown cut away.
    Cut,
    Culled,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FaceLook {
    Whole,
    /// By what becomes of itself.
    Own(Role),
    /// Not at all: what it hides is seen.
    Hidden,
}

/// Faces that meet at a smaller angle than this, by its cosine, make no crease: they stand for something round.
const ROUND: f64 = 0.72;
/// And these lie in one plane: there is no edge at all.
const FLAT: f64 = 1.0 - 1e-9;

/// Corners of a box by the bits of their numbers, counter-clockwise as seen from outside.
const BOX_FACES: [[usize; 4]; 6] = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
];

/// Of more edges not all are drawn one by one.
const MOST_EDGES: usize = 3_000;

#[derive(Default)]
pub struct Solids {
    pub facets: Vec<Facet>,
    pub edges: Vec<Edge3>,
    objects: Vec<Extent>,
}

/// Which facets and edges are an object's.
struct Extent {
    facets: Range<usize>,
    edges: Range<usize>,
    is_open: bool,
}

impl Solids {
    /// One more object, with a look for each of its faces where they differ; of each face its first facet, if it is there.
    pub fn object(
        &mut self,
        object: &Object,
        link: &dyn Fn(usize) -> Link,
        fate: Fate,
        planes: &[Plane; 6],
        look: &dyn Fn(usize) -> FaceLook,
    ) -> Vec<Option<u32>> {
        let mesh = object.model().mesh();
        let (first_facet, first_edge) = (self.facets.len(), self.edges.len());
        let points: Vec<[f64; 3]> = object.points().collect();
        // Of each face a part that has its plane.
        let mut facet_of = Vec::with_capacity(mesh.faces().len());
        for (face_idx, face) in mesh.faces().iter().enumerate() {
            let role = match look(face_idx) {
                FaceLook::Whole => fate.role(),
                FaceLook::Own(role) => role,
                FaceLook::Hidden => {
                    facet_of.push(None);
                    continue;
                }
            };
            facet_of.push(Some(self.facets.len() as u32));
            let whole = Facet {
                corners: face.map(|i| points[i as usize]).to_vec(),
                role,
                link: Some(link(face_idx)),
                skin: object
                    .model()
                    .skin(*face)
                    .filter(|_| role != Role::Discarded),
                edging: Edging::Lines,
                opacity: object.opacity() as f32,
            };
            match fate {
                Fate::Cut => self.cut_face(&whole, planes),
                Fate::ToCome | Fate::Kept | Fate::Culled => self.facets.push(whole),
            }
        }
        self.edges_of(object, &facet_of, fate, planes);
        self.objects.push(Extent {
            facets: first_facet..self.facets.len(),
            edges: first_edge..self.edges.len(),
            is_open: !mesh.is_closed(),
        });
        facet_of
    }

    /// Where edges are too many, those of the objects that have the most are left out, but for cuts.
    pub fn settled(mut self) -> Self {
        if self.edges.len() <= MOST_EDGES {
            return self;
        }
        let mut sizes: Vec<usize> = self.objects.iter().map(|it| it.edges.len()).collect();
        sizes.sort_unstable();
        // All objects of one size are drawn alike.
        let (mut n_drawn, mut most) = (0, 0);
        for alike in sizes.chunk_by(|a, b| a == b) {
            n_drawn += alike.len() * alike[0];
            if n_drawn > MOST_EDGES {
                break;
            }
            most = alike[0];
        }
        let mut edges = Vec::new();
        for Extent {
            facets,
            edges: own,
            is_open,
        } in &self.objects
        {
            let own = self.edges[own.clone()].iter();
            if own.len() <= most {
                edges.extend(own.cloned());
                continue;
            }
            let edging = Edging::Samples { is_open: *is_open };
            let facets = &mut self.facets[facets.clone()];
            for facet in facets.iter_mut() {
                facet.edging = edging;
            }
            let cuts = own.filter(|edge| edge.role == Role::Accent);
            edges.extend(cuts.take(MOST_EDGES.saturating_sub(edges.len())).cloned());
        }
        self.edges = edges;
        self
    }

    /// The edges of an object, of whose faces these facets are drawn.
    fn edges_of(
        &mut self,
        object: &Object,
        facet_of: &[Option<u32>],
        fate: Fate,
        planes: &[Plane; 6],
    ) {
        let mesh = object.model().mesh();
        let world_from_model = object.world_from_model();
        let normals: Vec<DVec3> = mesh
            .faces()
            .iter()
            .map(|&face| DVec3::from(mesh.normal(face)).normalize_or_zero())
            .collect();
        for edge in mesh.edges() {
            let cosine = match edge.faces {
                [Some(a), Some(b)] => normals[a as usize].dot(normals[b as usize]),
                _ => -1.0,
            };
            if cosine > FLAT {
                continue;
            }
            let ends = edge
                .ends
                .map(|i| world_from_model.point(mesh.positions()[i as usize].map(f64::from)));
            let facets = edge.faces.map(|face| facet_of[face? as usize]);
            if facets == [None; 2] {
                continue;
            }
            let drawn = |ends, role| Edge3 {
                ends,
                facets,
                is_crease: cosine < ROUND,
                role,
            };
            if fate == Fate::Cut {
                let parts = parts_of_segment(ends, planes).into_iter();
                for (parts, role) in parts.zip([Role::Ink, Role::Discarded]) {
                    let edges = parts.into_iter().map(|ends| drawn(ends, role));
                    self.edges.extend(edges);
                }
            } else {
                self.edges.push(drawn(ends, fate.edge_role()));
            }
        }
    }

    /// The part inside all planes, and what each plane cuts off.
    fn cut_face(&mut self, whole: &Facet, planes: &[Plane; 6]) {
        let first = self.facets.len();
        let mut left = whole.corners.clone();
        let mut cutting = Vec::new();
        for plane in planes {
            let [inside, outside] = split(&left, plane);
            if !outside.is_empty() {
                self.facets.push(Facet {
                    role: Role::Discarded,
                    skin: None,
                    ..whole.part(outside)
                });
                cutting.push(plane);
            }
            left = inside;
        }
        for cut in cutting.into_iter().flat_map(|plane| cuts(&left, plane)) {
            self.edges.push(Edge3 {
                ends: cut,
                facets: [Some(first as u32), None],
                is_crease: true,
                role: Role::Accent,
            });
        }
        if !left.is_empty() {
            self.facets.push(whole.part(left));
        }
    }

    pub fn camera(&mut self, camera: &Camera, size: f64, link: Link) {
        let corner = |i: usize| {
            let along = |axis: usize, low: f64, high: f64| {
                size * if i >> axis & 1 == 1 { high } else { low }
            };
            let at = [
                along(0, -0.6, 0.6),
                along(1, -0.45, 0.45),
                along(2, 0.0, 1.5),
            ];
            camera.world_from_view(at)
        };
        self.facets.extend(BOX_FACES.map(|face| Facet {
            corners: face.map(corner).to_vec(),
            role: Role::Ink,
            link: Some(link),
            skin: None,
            edging: Edging::Lines,
            opacity: 1.0,
        }));
    }
}

impl Fate {
    pub const fn role(self) -> Role {
        match self {
            Self::ToCome => Role::Soft,
            Self::Kept | Self::Cut => Role::Accent,
            Self::Culled => Role::Discarded,
        }
    }

    pub const fn edge_role(self) -> Role {
        match self {
            Self::ToCome | Self::Kept | Self::Cut => Role::Ink,
            Self::Culled => Role::Discarded,
        }
    }
}

/// The edges of a polygon that lie in a plane that has cut it.
fn cuts<'a>(polygon: &'a [[f64; 3]], plane: &'a Plane) -> impl Iterator<Item = [[f64; 3]; 2]> + 'a {
    let n = polygon.len();
    let is_on = |at: [f64; 3]| {
        let distance: f64 = signed_distance(plane, at);
        distance.abs() < 1e-9 * (1.0 + at.iter().map(|x| x.abs()).sum::<f64>())
    };
    (0..n)
        .map(move |i| [polygon[i], polygon[(i + 1) % n]])
        .filter(move |ends| ends.iter().all(|&at| is_on(at)))
}

/// Of a segment what is inside of all planes, and what is not: one part, and up to two.
pub fn parts_of_segment(ends: [[f64; 3]; 2], planes: &[Plane; 6]) -> [Vec<[[f64; 3]; 2]>; 2] {
    let [a, b] = ends.map(DVec3::from);
    let bounds = planes.map(|plane| (DVec3::from(plane.normal()), -plane.d()));
    let kept: Vec<[f64; 2]> = inside([a, b], bounds).into_iter().collect();
    let dropped = complement(&kept);
    [kept, dropped].map(|parts| {
        let ends = parts
            .into_iter()
            .map(|part| part.map(|t| between(a, b, t).into()));
        ends.collect()
    })
}
