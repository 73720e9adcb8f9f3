//! Solids as they are seen: which facet at each sample of a picture.

use std::{borrow::Cow, ops::Range};

use glam::DVec3;

use crate::{
    algo::surface::{ScreenTriangle, Viewport, draw_rows},
    geom::Texture,
};

use super::{
    facet::{Facet, normal},
    facets::Facets,
    lens::{Lens, Optics},
    role::{Link, Role},
    solid_mesh::SolidMesh,
};

#[derive(Clone, PartialEq, Debug)]
pub struct Solids {
    pub facets: Facets,
    pub lens: Lens,
}

impl Solids {
    /// The outlines of the faces that are turned to the eye, and what each means.
    pub fn faces(&self) -> Vec<(Role, Vec<[f64; 2]>)> {
        self.faces_that(|_| true)
    }

    /// The outlines of those about `link`.
    pub fn faces_of(&self, link: Link) -> Vec<Vec<[f64; 2]>> {
        let faces = self.faces_that(|facet| facet.link == Some(link));
        faces.into_iter().map(|(_, outline)| outline).collect()
    }

    fn faces_that(&self, is_meant: impl Fn(&Facet) -> bool) -> Vec<(Role, Vec<[f64; 2]>)> {
        let Some(optics) = Optics::of(&self.lens) else {
            return Vec::new();
        };
        let face = |(facet, role): (&Facet, Role)| {
            let corners = optics.all_from_world(&facet.corners);
            let is_before = corners.iter().all(|at| at.z < -optics.near);
            let outline = corners.iter().map(|&at| optics.picture_from_view(at));
            let is_seen = is_before && normal(&corners).dot(optics.toward_eye(corners[0])) > 0.0;
            is_seen.then(|| (role, outline.collect()))
        };
        let facets = self.facets.shown();
        let facets = facets.filter(|(facet, _)| !facet.corners.is_empty() && is_meant(facet));
        facets.filter_map(face).collect()
    }

    pub fn link_at(&self, at: [f64; 2]) -> Option<Link> {
        let optics = Optics::of(&self.lens)?;
        let distances = self.facets.shown().filter_map(|(facet, _)| {
            let corners = optics.all_from_world(&facet.corners);
            Some((distance(&corners, &optics, at)?, facet))
        });
        let (_, nearest) = distances.min_by(|a, b| a.0.total_cmp(&b.0))?;
        nearest.link
    }
}

fn distance(corners: &[DVec3], optics: &Optics, at: [f64; 2]) -> Option<f64> {
    let (start, along) = optics.sight_line(at);
    let &first = corners.first()?;
    let normal = normal(corners);
    let mut turns = [false; 2];
    for (i, &a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        let side = optics.toward_eye(a).cross(b - a).dot(start + along - a);
        turns[usize::from(side < 0.0)] |= side != 0.0;
    }
    let depth = normal.dot(first - start) / normal.dot(along);
    let is_met = turns != [true; 2] && depth > optics.near && depth <= optics.far;
    is_met.then_some(depth)
}

/// In which order the samples of two rows and two columns are taken by what can be seen through: as many as it hides.
const RANKS: [[u8; 2]; 2] = [[0, 2], [3, 1]];

/// The triangles of a mesh on a screen.
pub struct SolidScreen {
    triangles: Drawable,
    /// Those that can be seen through.
    glass: Drawable,
    viewport: Viewport,
}

/// A screen's triangles, as far as they are there, with their facets' textures.
pub struct SolidPicture<'a> {
    mesh: &'a SolidMesh,
    triangles: Cow<'a, Drawable>,
    glass: Cow<'a, Drawable>,
    viewport: Viewport,
    /// How facets look now, where not by themselves.
    looks: Option<&'a Facets>,
}

#[derive(Clone)]
enum Drawable {
    Plain(Vec<ScreenTriangle<0>>),
    Skinned(Vec<ScreenTriangle<2>>),
}

impl SolidScreen {
    pub const MAX_SIDE: u32 = Viewport::MAX_SIDE;

    /// The part of the picture from `min` to `max`, in so many columns and rows. `None` where there is nothing to see.
    pub fn new(mesh: &SolidMesh, lens: &Lens, part: [[f64; 2]; 2], size: [u32; 2]) -> Option<Self> {
        let optics = Optics::of(lens)?;
        let viewport = Viewport::new(size, Viewport::PICTURE_BITS)?;
        let clip_from_world = optics.clip_from_world(part, depths(mesh, &optics)?)?;
        let triangles = if mesh.uvs.is_empty() {
            let none = vec![[]; mesh.positions.len()];
            Drawable::Plain(mesh.on_screen(&none, &clip_from_world, &viewport))
        } else {
            Drawable::Skinned(mesh.on_screen(&mesh.uvs, &clip_from_world, &viewport))
        };
        let opacities = &mesh.opacities;
        let is_whole = |id: u32| {
            let opacity = opacities.get(mesh.facets[id as usize] as usize);
            opacity.is_none_or(|&opacity| opacity == 1.0)
        };
        let [triangles, glass] = if opacities.is_empty() {
            [triangles, Drawable::Plain(Vec::new())]
        } else {
            triangles.parted(is_whole)
        };
        Some(Self {
            triangles,
            glass,
            viewport,
        })
    }
}

impl<'a> SolidPicture<'a> {
    pub const fn new(mesh: &'a SolidMesh, screen: &'a SolidScreen) -> Self {
        Self {
            mesh,
            triangles: Cow::Borrowed(&screen.triangles),
            glass: Cow::Borrowed(&screen.glass),
            viewport: screen.viewport,
            looks: None,
        }
    }

    /// Of these facets, as they look now: those that are not there are left out, what is cut away has no texture.
    pub fn looking(self, facets: &'a Facets) -> Self {
        let facet_of = |id: u32| self.mesh.facets[id as usize] as usize;
        let is_shown = |id: u32| facets.role(facet_of(id)).is_some();
        let [triangles, glass] = [&self.triangles, &self.glass].map(|all| {
            if facets.are_all_shown() {
                all.clone()
            } else {
                Cow::Owned(all.only(is_shown))
            }
        });
        Self {
            triangles,
            glass,
            looks: Some(facets),
            ..self
        }
    }

    fn texture_of(&self, facet: usize) -> Option<&Texture> {
        let role = self.looks.and_then(|facets| facets.role(facet));
        let texture = self.mesh.textures[facet].as_ref();
        texture.filter(|_| role != Some(Role::Discarded))
    }

    pub fn n_triangles(&self) -> usize {
        self.triangles.len() + self.glass.len()
    }

    pub fn rows(&self) -> Range<u32> {
        let rows = [&self.triangles, &self.glass].map(|all| all.rows());
        rows.into_iter()
            .flatten()
            .reduce(around)
            .unwrap_or_default()
    }

    pub fn has_skin(&self) -> bool {
        match *self.triangles {
            Drawable::Plain(_) => false,
            Drawable::Skinned(_) => true,
        }
    }

    /// Puts the facets that are seen in some rows into `facets`, one for each sample, and how far away they are, from 0 to
    /// 1, into `depths`; where there is none, both stay. Where [`Self::has_skin`], the texels go into `texels`, as long as
    /// the others: `None` of a facet without a texture.
    pub fn draw_rows(
        &self,
        rows: Range<u32>,
        depths: &mut [f32],
        facets: &mut [u32],
        texels: &mut [Option<[u8; 3]>],
    ) {
        self.draw_some(&self.triangles, rows.clone(), depths, facets, texels);
        if self.glass.len() > 0 {
            self.draw_glass(rows, depths, facets, texels);
        }
    }

    /// What can be seen through takes some of the samples: they are averaged.
    fn draw_glass(
        &self,
        rows: Range<u32>,
        depths: &mut [f32],
        facets: &mut [u32],
        texels: &mut [Option<[u8; 3]>],
    ) {
        let mut nearer = (depths.to_vec(), facets.to_vec(), texels.to_vec());
        let (near, over, skins) = (&mut nearer.0, &mut nearer.1, &mut nearer.2);
        self.draw_some(&self.glass, rows.clone(), near, over, skins);
        let n_columns = (depths.len() / rows.len().max(1)).max(1);
        for at in 0..depths.len() {
            let facet = over[at];
            if facet == facets[at] && near[at] == depths[at] {
                continue;
            }
            let [row, column] = [rows.start as usize + at / n_columns, at % n_columns];
            let rank = f32::from(RANKS[row % 2][column % 2]);
            if (rank + 0.5) / 4.0 < self.mesh.opacities[facet as usize] {
                (depths[at], facets[at]) = (near[at], facet);
                if let Some(texel) = texels.get_mut(at) {
                    *texel = skins[at];
                }
            }
        }
    }

    fn draw_some(
        &self,
        triangles: &Drawable,
        rows: Range<u32>,
        depths: &mut [f32],
        facets: &mut [u32],
        texels: &mut [Option<[u8; 3]>],
    ) {
        let facet_of = |triangle: u32| self.mesh.facets[triangle as usize];
        let viewport = &self.viewport;
        match triangles {
            Drawable::Plain(all) => draw_rows(all, viewport, rows, depths, |at, triangle, []| {
                facets[at] = facet_of(triangle);
            }),
            Drawable::Skinned(all) => draw_rows(all, viewport, rows, depths, |at, triangle, uv| {
                let facet = facet_of(triangle);
                facets[at] = facet;
                let texture = self.texture_of(facet as usize);
                texels[at] = texture.map(|texture| texture.at(uv));
            }),
        }
    }
}

impl Drawable {
    /// Those of which this is so, and the others.
    fn parted(self, is_so: impl Fn(u32) -> bool) -> [Self; 2] {
        match self {
            Self::Plain(all) => {
                let (some, others) = all.into_iter().partition(|it| is_so(it.id));
                [some, others].map(Self::Plain)
            }
            Self::Skinned(all) => {
                let (some, others) = all.into_iter().partition(|it| is_so(it.id));
                [some, others].map(Self::Skinned)
            }
        }
    }

    fn only(&self, is_so: impl Fn(u32) -> bool) -> Self {
        match self {
            Self::Plain(all) => {
                Self::Plain(all.iter().filter(|it| is_so(it.id)).copied().collect())
            }
            Self::Skinned(all) => {
                Self::Skinned(all.iter().filter(|it| is_so(it.id)).copied().collect())
            }
        }
    }

    const fn len(&self) -> usize {
        match self {
            Self::Plain(all) => all.len(),
            Self::Skinned(all) => all.len(),
        }
    }

    /// The rows that they are in; none where there are none.
    fn rows(&self) -> Option<Range<u32>> {
        match self {
            Self::Plain(all) => all.iter().map(ScreenTriangle::rows).reduce(around),
            Self::Skinned(all) => all.iter().map(ScreenTriangle::rows).reduce(around),
        }
    }
}

fn around(all: Range<u32>, rows: Range<u32>) -> Range<u32> {
    all.start.min(rows.start)..all.end.max(rows.end)
}

/// A little less than the distance of the nearest corner, and more than that of the farthest, as far as they are seen.
fn depths(mesh: &SolidMesh, optics: &Optics) -> Option<[f64; 2]> {
    let far = |at: &[f32; 3]| -optics.view_from_world(at.map(f64::from).into()).z;
    let [mut nearest, mut farthest] = [f64::INFINITY, f64::NEG_INFINITY];
    for distance in mesh.positions.iter().map(far) {
        nearest = nearest.min(distance);
        farthest = farthest.max(distance);
    }
    let air = 0.01 * (farthest - nearest).max(farthest.abs() * 1e-3);
    let near = optics.near.max(nearest - air);
    let far = optics.far.min(farthest + air);
    (near < far).then_some([near, far])
}
