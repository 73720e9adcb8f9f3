//! What a label belongs to, on the screen.

use egui::{Pos2, Rect};

use crate::{
    figure::{Link, Mark, Shape},
    geom::pairs_around,
    paint::{
        Theme, Viewport,
        cut::cut_to,
        parts::{Part, parts, visible},
        pen::radius,
    },
};

const MOST_EDGES: usize = 8;

#[derive(Clone, PartialEq, Debug)]
pub enum Anchor {
    Point(Pos2, f32),
    /// Along one of these edges; a line's only one is as long as it is seen.
    Along(Vec<[Pos2; 2]>),
    Inside(Rect),
    /// Anywhere that an odd number of outlines goes round.
    Within(Vec<Vec<Pos2>>),
}

impl Anchor {
    pub fn of(viewport: &Viewport, theme: &Theme, mark: &Mark) -> Option<Self> {
        let stage = viewport.rect;
        let parts = parts(viewport, &mark.shape);
        match &mark.shape {
            Shape::Region(corners) => Some(Self::Inside(visible(viewport, *corners))),
            Shape::Segment(_)
            | Shape::Border(..)
            | Shape::Line(_)
            | Shape::Ray(_)
            | Shape::HalfPlane(_)
            | Shape::Outline(_)
            | Shape::Path(_) => Self::along(&parts, stage),
            Shape::Area(outlines) | Shape::Fill(outlines) | Shape::Hatch(outlines) => {
                let on_screen = outlines.iter().map(|it| viewport.all_to_screen(it));
                Some(Self::Within(on_screen.collect()))
            }
            Shape::Wash(_) => {
                let corners = parts.into_iter().filter_map(|part| match part {
                    Part::Wash(corners) => Some(corners),
                    _ => None,
                });
                Some(Self::Within(corners.collect()))
            }
            Shape::Label(at) => {
                let at = viewport.to_screen(*at);
                stage.contains(at).then_some(Self::Point(at, 0.0))
            }
            // Too many things for one label.
            Shape::Solids(_) | Shape::Textured(_) | Shape::Crowd(_) => None,
            Shape::Arrow(_)
            | Shape::Heading(_)
            | Shape::Dot(_)
            | Shape::Vertex(_)
            | Shape::Ring(_)
            | Shape::Cross(_)
            | Shape::Bound(_)
            | Shape::Angle(_)
            | Shape::RightAngle(_) => {
                let (at, radius) = parts.iter().find_map(|part| match part {
                    Part::Marker(marker, at) => Some((*at, radius(theme, *marker, mark))),
                    Part::Arrow([_, tip]) | Part::Head([_, tip]) => Some((*tip, 2.0)),
                    Part::Stroke(points) => points.get(points.len() / 2).map(|&at| (at, 2.0)),
                    Part::Wash(_)
                    | Part::Fill(_)
                    | Part::Solids(_)
                    | Part::Texture(_)
                    | Part::Crowd(_)
                    | Part::Ring(_) => None,
                })?;
                let is_seen = stage.expand(1.0).contains(at);
                is_seen.then_some(Self::Point(at, radius))
            }
        }
    }

    /// Of what is about this the first mark that has a place, else its face.
    pub fn of_link(viewport: &Viewport, theme: &Theme, marks: &[Mark], link: Link) -> Option<Self> {
        let own = marks.iter().filter(|mark| mark.link == Some(link));
        let mut of_mark = own.filter_map(|mark| Self::of(viewport, theme, mark));
        let of_face = || {
            let solids = marks.iter().filter_map(|mark| match &mark.shape {
                Shape::Solids(solids) => Some(solids),
                _ => None,
            });
            let faces = solids.flat_map(|solids| solids.faces_of(link));
            let faces: Vec<Vec<Pos2>> = faces.map(|face| viewport.all_to_screen(&face)).collect();
            (!faces.is_empty()).then_some(Self::Within(faces))
        };
        of_mark.next().or_else(of_face)
    }

    pub fn middle(&self) -> Pos2 {
        match self {
            Self::Point(at, _) => *at,
            Self::Along(edges) => edges.first().map_or(Pos2::ZERO, |[a, b]| a.lerp(*b, 0.5)),
            Self::Inside(rect) => rect.center(),
            Self::Within(outlines) => {
                let points: Vec<Pos2> = outlines.iter().flatten().copied().collect();
                Rect::from_points(&points).center()
            }
        }
    }

    fn along(parts: &[Part<'_>], stage: Rect) -> Option<Self> {
        let edges = parts.iter().flat_map(edges_of);
        let seen = edges.filter_map(|ends| cut_to(ends, stage));
        let seen = seen.enumerate();
        let longest = seen.map(|(i, [a, b])| (a.distance(b), i, [a, b]));
        let mut longest: Vec<(f32, usize, [Pos2; 2])> = longest.collect();
        // Of edges of one length the first: the same place at every step.
        let order = |(a, i, _): &(f32, usize, _), (b, k, _): &(f32, usize, _)| {
            b.total_cmp(a).then(i.cmp(k))
        };
        if longest.len() > MOST_EDGES {
            longest.select_nth_unstable_by(MOST_EDGES, order);
            longest.truncate(MOST_EDGES);
        }
        longest.sort_unstable_by(order);
        let edges: Vec<[Pos2; 2]> = longest.into_iter().map(|(.., ends)| ends).collect();
        (!edges.is_empty()).then_some(Self::Along(edges))
    }
}

pub fn edges_of(part: &Part<'_>) -> Vec<[Pos2; 2]> {
    let (points, is_closed) = part.line().unwrap_or_default();
    let n = points.len().saturating_sub(usize::from(!is_closed));
    pairs_around(points).take(n).collect()
}
