//! The picture of each space.

use crate::algo::volume::clipped;

use super::{
    super::{
        super::Object, FaceLook, Fate, Solids, prelude::*, solids::parts_of_segment,
        views::object_link, volume::volume,
    },
    marks::{cube, frame, pyramid, vertex_marks},
    picture_space::{Followed, PictureSpace},
    space_places::SpacePlaces,
};

/// A long lens, so that only the taught perspective speaks.
const LENS_DEG: f64 = 16.0;
/// Degrees from ahead, and from above.
const ANGLES: [f64; 2] = [58.0, 18.0];

impl SpacePlaces<'_> {
    pub fn draw(&self, space: PictureSpace, vertex: &Followed) -> Space {
        let mut marks = match space {
            PictureSpace::World => return self.world(vertex),
            PictureSpace::Model => Vec::new(),
            PictureSpace::View => volume(self.camera)
                .into_iter()
                .map(|mark| mapped(mark, |at| self.camera.view_from_world().point(at)))
                .map(|mark| if vertex.is_large { mark } else { bare(mark) })
                .collect(),
            PictureSpace::Clip if self.is_parallel() => cube(),
            PictureSpace::Clip => pyramid(self, vertex),
            PictureSpace::Ndc => cube(),
            PictureSpace::Screen => frame(self),
        };
        let (facets, edges) = self.object(space);
        let eye = self.eye(space, &facets);
        marks.extend(vertex_marks(self, space, vertex));
        let title = space.title_key(self.is_parallel());
        Space {
            title: vertex.is_large.then_some(Value::Term(title)),
            seer: Seer::Apart(eye),
            facets: facets.into(),
            edges: edges.into(),
            marks,
        }
    }

    /// The observer's view, who is in it.
    fn world(&self, vertex: &Followed) -> Space {
        let focus = self.scenery.scene().focus();
        let fate = |i: usize| if i == focus { Fate::Kept } else { Fate::ToCome };
        let own = vertex_marks(self, PictureSpace::World, vertex);
        let mut space = self.scenery.seen(&fate, &|_, _| FaceLook::Whole, own);
        let title = PictureSpace::World.title_key(false);
        space.title = vertex.is_large.then_some(Value::Term(title));
        if !vertex.is_large {
            space.marks = space.marks.into_iter().map(bare).collect();
        }
        space
    }

    /// The object in focus; after the divide no more of it than is inside.
    fn object(&self, space: PictureSpace) -> (Vec<Facet>, Vec<Edge3>) {
        let object = self.focused();
        let link = object_link(self.scenery.scene().focus());
        let mut solids = Solids::default();
        let planes = self.scenery.planes();
        let look = |_| FaceLook::Whole;
        let is_own = space == PictureSpace::Model;
        let own = is_own.then(|| Object::new(object.model().clone(), [0.0; 3], [0.0; 3], 1.0));
        let own = own.and_then(Result::ok);
        let object = own.as_ref().unwrap_or(object);
        solids.object(object, &|_| link, Fate::Kept, planes, &look);
        let solids = solids.settled();
        let is_divided = matches!(space, PictureSpace::Ndc | PictureSpace::Screen);
        let seen_by = self.camera.planes_in_world();
        let facets = solids.facets.into_iter().map(|mut facet| {
            if is_divided {
                let whole = std::mem::take(&mut facet.corners);
                let part = seen_by
                    .iter()
                    .fold(whole, |left, plane| clipped(&left, plane));
                facet.corners = part;
            }
            for corner in &mut facet.corners {
                *corner = self.drawn_from_world(space, *corner);
            }
            facet
        });
        let edges = solids.edges.into_iter().filter_map(|edge| {
            let ends = if is_divided {
                let [inside, _] = parts_of_segment(edge.ends, &seen_by);
                inside.first().copied()?
            } else {
                edge.ends
            };
            let ends = ends.map(|at| self.drawn_from_world(space, at));
            Some(Edge3 { ends, ..edge })
        });
        (facets.collect(), edges.collect())
    }

    /// From where a space is looked at: all of the object, and the origin where that is what counts.
    fn eye(&self, space: PictureSpace, facets: &[Facet]) -> Orbit {
        let corners = facets
            .iter()
            .flat_map(|facet| facet.corners.iter().copied());
        let around = |places: &mut dyn Iterator<Item = [f64; 3]>, zoom: f64, angles| {
            let mut low = DVec3::INFINITY;
            let mut high = DVec3::NEG_INFINITY;
            for at in places.map(DVec3::from) {
                (low, high) = (low.min(at), high.max(at));
            }
            let radius = 0.5 * low.distance(high) / zoom;
            let tan = libm::tan((0.5 * LENS_DEG).to_radians());
            Orbit::new(low.midpoint(high).into(), angles, radius / tan, LENS_DEG)
        };
        let unit = [[-1.0; 3], [1.0; 3]];
        match space {
            PictureSpace::Model | PictureSpace::World => {
                around(&mut corners.chain([[0.0; 3]]), 0.8, [28.0, 20.0])
            }
            PictureSpace::View | PictureSpace::Clip if self.is_parallel() => {
                around(&mut corners.chain(unit), 0.9, ANGLES)
            }
            PictureSpace::View | PictureSpace::Clip => {
                around(&mut corners.chain([[0.0; 3]]), 0.68, ANGLES)
            }
            PictureSpace::Ndc => around(&mut unit.into_iter(), 1.1, [30.0, 18.0]),
            PictureSpace::Screen => {
                let [width, height] = self.half_screen();
                let frame = [[-width, -height, 0.0], [width, height, 0.0]];
                around(&mut frame.into_iter(), 1.2, [0.0, 0.0])
            }
        }
    }
}

/// Without its words: they have no room in a small picture.
fn bare(mut mark: Mark3) -> Mark3 {
    mark.label = None;
    mark
}

fn mapped(mut mark: Mark3, to: impl Fn([f64; 3]) -> [f64; 3]) -> Mark3 {
    match &mut mark.shape {
        Shape3::Segment(ends) | Shape3::Arrow(ends) => *ends = ends.map(&to),
        Shape3::Outline(places) | Shape3::Sheet(places) | Shape3::Wash(places) => {
            for at in places {
                *at = to(*at);
            }
        }
        Shape3::RightAngle(places) | Shape3::Angle(places) => *places = places.map(&to),
        Shape3::Ball(at, _)
        | Shape3::Dot(at)
        | Shape3::Ring(at)
        | Shape3::Cross(at)
        | Shape3::Label(at) => *at = to(*at),
    }
    mark
}
