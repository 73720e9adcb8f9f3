//! How far a drawing reaches: what its frame has to hold.

use std::sync::LazyLock;

use glam::DVec3;

use crate::geom::pairs_around;

use super::super::{
    role::Role,
    space::{Mark3, Shape3, Space},
};

/// Of some places those that lie farthest out, in [`N_DIRECTIONS`] directions.
#[derive(Clone, Debug, Default)]
struct Hull {
    farthest: Vec<(f64, DVec3)>,
}

/// The farthest out of them in all directions: between two of these a ball's outline is missed by 2 %.
const N_DIRECTIONS: usize = 96;

/// A spiral over the sphere, evenly spaced (Fibonacci).
static DIRECTIONS: LazyLock<[DVec3; N_DIRECTIONS]> = LazyLock::new(|| {
    const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;
    std::array::from_fn(|i| {
        let y = 1.0 - (2 * i + 1) as f64 / N_DIRECTIONS as f64;
        let (sin, cos) = libm::sincos(GOLDEN_ANGLE * i as f64);
        let around = (1.0 - y * y).sqrt();
        DVec3::new(around * cos, y, around * sin)
    })
});

#[derive(Clone, Debug, Default)]
pub struct Extent {
    /// Solids, the camera among them, and what steps mark.
    marked: Hull,
    /// The view volume.
    volume: Hull,
    /// Planes as far as they are drawn, axes, names.
    around: Hull,
}

impl Extent {
    /// Solids stay where they are throughout a run.
    pub fn of_solids(space: &Space) -> Self {
        let mut extent = Self::default();
        let corners = space.facets.iter().flat_map(|facet| &facet.corners);
        extent.marked.add(corners.map(|&at| (at, 0.0)));
        extent
    }

    pub fn extend(&mut self, other: &Self) {
        self.marked.extend(&other.marked);
        self.volume.extend(&other.volume);
        self.around.extend(&other.around);
    }

    pub fn add(&mut self, marks: &[Mark3]) {
        for mark in marks.iter().filter(|mark| mark.role != Role::Faint) {
            let hull = match &mark.shape {
                Shape3::Sheet(_) | Shape3::Label(_) => &mut self.around,
                Shape3::Wash(_) if mark.role == Role::Signal => &mut self.around,
                _ if mark.role == Role::Soft => &mut self.around,
                Shape3::Wash(_) => &mut self.volume,
                _ if mark.is_fine => &mut self.volume,
                _ => &mut self.marked,
            };
            match &mark.shape {
                Shape3::Segment(ends) | Shape3::Arrow(ends) => {
                    hull.add(ends.iter().map(|&at| (at, 0.0)));
                }
                Shape3::Outline(corners) | Shape3::Sheet(corners) | Shape3::Wash(corners) => {
                    hull.add(corners.iter().map(|&at| (at, 0.0)));
                }
                Shape3::Ball(centre, radius) => hull.add([(*centre, *radius)]),
                Shape3::Dot(at) | Shape3::Ring(at) | Shape3::Cross(at) | Shape3::Label(at) => {
                    hull.add([(*at, 0.0)]);
                }
                // They lie on what they measure.
                Shape3::RightAngle(_) | Shape3::Angle(_) => {}
            }
        }
    }

    /// What is marked, and what more there is around it, the most telling first.
    pub fn places(&self) -> [Vec<DVec3>; 3] {
        [&self.marked, &self.volume, &self.around].map(|hull| hull.places().collect())
    }
}

/// Places along the lines of a drawing, and where its solids end.
pub fn drawn(space: &Space) -> Vec<DVec3> {
    const N_PLACES: usize = 12;
    let along = |a: [f64; 3], b: [f64; 3]| {
        let ends = [a, b].map(DVec3::from);
        (0..N_PLACES).map(move |i| ends[0].lerp(ends[1], i as f64 / N_PLACES as f64))
    };
    let mut places = Vec::new();
    for mark in space.marks.iter().filter(|mark| mark.role != Role::Faint) {
        match &mark.shape {
            Shape3::Segment([a, b]) | Shape3::Arrow([a, b]) => places.extend(along(*a, *b)),
            Shape3::Outline(corners) | Shape3::Sheet(corners) => {
                places.extend(pairs_around(corners).flat_map(|[a, b]| along(a, b)));
            }
            _ => {}
        }
    }
    let corners = space.facets.iter().flat_map(|facet| &facet.corners);
    places.extend(corners.take(MOST_CORNERS).copied().map(DVec3::from));
    places
}

/// Of more corners of solids the first stand for all.
const MOST_CORNERS: usize = 2000;

impl Hull {
    fn extend(&mut self, other: &Self) {
        if self.farthest.is_empty() {
            self.farthest.clone_from(&other.farthest);
        }
        for (farthest, more) in self.farthest.iter_mut().zip(&other.farthest) {
            if more.0 > farthest.0 {
                *farthest = *more;
            }
        }
    }

    /// Balls, with their radii.
    fn add(&mut self, balls: impl IntoIterator<Item = ([f64; 3], f64)>) {
        for (centre, radius) in balls {
            let centre = DVec3::from(centre);
            if !centre.is_finite() {
                continue;
            }
            if self.farthest.is_empty() {
                self.farthest = vec![(f64::NEG_INFINITY, centre); N_DIRECTIONS];
            }
            for (direction, farthest) in DIRECTIONS.iter().zip(&mut self.farthest) {
                let far = direction.dot(centre) + radius;
                if far > farthest.0 {
                    *farthest = (far, centre + *direction * radius);
                }
            }
        }
    }

    fn places(&self) -> impl Iterator<Item = DVec3> {
        let mut known = Vec::new();
        let places = self.farthest.iter().map(|&(_, at)| at);
        places.filter(move |&at| {
            let is_new = !known.contains(&at);
            known.push(at);
            is_new
        })
    }
}
