//! From space to the plane: what is seen through a lens, as marks that painter, labels, pointer and export know already.
//!
//! Lines are cut at the plane in front of the eye first; nothing behind it is ever divided by its depth.

mod curves;
mod edges;
mod facets;
mod grid;
mod interval;
mod marks;
#[cfg(test)]
mod oracle;
mod projected;
#[cfg(test)]
mod tests;

use glam::DVec3;

use super::{
    facet::{Edging, Facet},
    facets::Facets,
    lens::{Lens, Optics},
    mark::{Mark, Weight},
    space::{Edge3, Space},
};

use self::facets::FacetsInView;
pub(crate) use interval::{between, complement, inside};
pub use projected::Projected;

/// Tints, then the solids with their edges, then the marks, each in parts where a solid hides some of it.
pub fn project(space: &Space, lens: &Lens) -> Vec<Mark> {
    Projected::new(space, lens).marks().to_vec()
}

#[derive(Clone, Debug)]
struct Seen {
    optics: Optics,
    facets: FacetsInView,
}

#[derive(Default)]
struct Parted {
    visible: Vec<[[f64; 2]; 2]>,
    hidden: Vec<[[f64; 2]; 2]>,
}

impl Seen {
    /// Of a space through a lens, if anything can be seen; where no line is drawn that facets could hide, they are left out.
    fn of(space: &Space, lens: &Lens, hides: bool) -> Option<Self> {
        let optics = Optics::of(lens)?;
        let bounds_two = |edge: &Edge3| edge.facets.iter().all(Option::is_some);
        let is_open = |facet: &Facet| facet.edging == Edging::Samples { is_open: true };
        let is_closed = space.facets.are_all_shown()
            && space.edges.iter().all(bounds_two)
            && !space.facets.iter().any(is_open);
        let hiding = if hides {
            space.facets.clone()
        } else {
            Facets::default()
        };
        Some(Self {
            optics,
            facets: FacetsInView::new(hiding, is_closed, optics),
        })
    }

    fn on_picture(&self, at: DVec3) -> [f64; 2] {
        self.optics.picture_from_view(at)
    }

    fn in_view(&self, at: [f64; 3]) -> Option<DVec3> {
        let view = self.optics.view_from_world(at.into());
        let is_seen = view.z < -self.optics.near && view.z >= -self.optics.far;
        is_seen.then_some(view)
    }

    fn cut(&self, ends: [[f64; 3]; 2]) -> Option<[DVec3; 2]> {
        let ends = ends.map(|at| self.optics.view_from_world(at.into()));
        let is_endless = self.optics.far.is_infinite();
        let far = (!is_endless).then_some((DVec3::Z, -self.optics.far));
        let planes = std::iter::once((DVec3::NEG_Z, self.optics.near)).chain(far);
        let part = inside(ends, planes)?;
        Some(part.map(|t| between(ends[0], ends[1], t)))
    }

    fn parted(&mut self, ends: [[f64; 3]; 2], but: [Option<u32>; 2]) -> Parted {
        let Some(ends) = self.cut(ends) else {
            return Parted::default();
        };
        let hidden = self.facets.hidden(ends, but);
        let part = |&[from, to]: &[f64; 2]| {
            [from, to].map(|t| self.on_picture(between(ends[0], ends[1], t)))
        };
        Parted {
            visible: complement(&hidden).iter().map(part).collect(),
            hidden: hidden.iter().map(part).collect(),
        }
    }
}

const fn weight(points: f32, strength: f32) -> Weight {
    Weight { points, strength }
}
