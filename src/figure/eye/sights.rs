//! What a step has to be seen of, and how much of it an eye sees.

use glam::{DVec2, DVec3};

use super::super::{
    facet::{Facet, normal},
    lens::Optics,
    role::Role,
    space::{Mark3, Shape3, Space},
};

/// So much of their length is seen of the first vectors whose length is written, and of all other lines.
const LENGTHS: [f64; 2] = [0.85, 0.6];
/// So many are seen that well.
const N_MEASURED: usize = 2;
const MOST_OFF_DEG: f64 = 5.0;
/// Of its true area.
const LEAST_AREA: f64 = 0.3;
/// Of more faces that stand out none is the one in hand: they are what is left of a solid.
const MOST_FACES: usize = 2;
/// Of more points not every two can be told apart.
const MOST_POINTS: usize = 24;

/// Of a drawing's marks those that measure: by what they are, not by what they mean.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Sights {
    /// Arrows and segments whose length is written beside them.
    pub measured: Vec<[DVec3; 2]>,
    /// Others that are drawn in full weight.
    pub lines: Vec<[DVec3; 2]>,
    /// Apex, and a point on each leg.
    pub angles: Vec<[DVec3; 3]>,
    pub points: Vec<DVec3>,
    /// The triangles and polygons in hand.
    pub polygons: Vec<Vec<DVec3>>,
}

/// How much of it is seen.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Seen {
    /// Length on the picture over true length, at the scale of the middle.
    pub measured: Vec<f64>,
    pub lines: Vec<f64>,
    /// By how many degrees an angle on the picture is another one.
    pub off_deg: Vec<f64>,
    /// Of every two points, how far they are from each other on the picture, and would be in the picture's plane.
    pub apart: Vec<[f64; 2]>,
    /// Area on the picture over true area, at the depth of the middle.
    pub areas: Vec<f64>,
}

impl Seen {
    /// How much is missing of lengths, of angles, of the distance that is to be between points, and of areas; 0 where nothing is.
    /// Points that are nearer to each other in space than that need not be farther on the picture.
    pub fn shortfalls(&self, apart: f64) -> [f64; 4] {
        let short = |value: f64, least: f64| (1.0 - value / least).max(0.0);
        let [well, enough] = LENGTHS;
        let measured = self.measured.iter().enumerate().map(|(i, &part)| {
            let least = if i < N_MEASURED { well } else { enough };
            short(part, least)
        });
        let lines = self.lines.iter().map(|&part| short(part, enough));
        let off = self.off_deg.iter();
        let off = off.map(|&off| ((off - MOST_OFF_DEG) / 90.0).max(0.0));
        let near = self.apart.iter();
        let near = near.map(|&[far, most]| short(far, apart.min(well * most)));
        let areas = self.areas.iter().map(|&area| short(area, LEAST_AREA));
        [
            measured.chain(lines).sum(),
            off.sum(),
            near.sum(),
            areas.sum(),
        ]
    }
}

impl Sights {
    pub fn of(space: &Space) -> Self {
        let mut sights = Self::default();
        for mark in space.marks.iter().filter(|mark| is_event(mark)) {
            sights.add(mark);
        }
        let stands_out = |(_, role): &(&Facet, Role)| matches!(role, Role::Accent | Role::Signal);
        let faces: Vec<(&Facet, Role)> = space.facets.shown().filter(stands_out).collect();
        if faces.len() <= MOST_FACES {
            let corners = faces.iter().map(|(facet, _)| all(&facet.corners));
            sights.polygons.extend(corners);
        }
        if sights.points.len() > MOST_POINTS {
            sights.points.clear();
        }
        sights
    }

    fn add(&mut self, mark: &Mark3) {
        match &mark.shape {
            Shape3::Segment(ends) | Shape3::Arrow(ends) => {
                let ends = ends.map(DVec3::from);
                if mark.label.is_some() {
                    self.measured.push(ends);
                } else if mark.role != Role::Discarded {
                    self.lines.push(ends);
                }
            }
            Shape3::Angle(points) => self.angles.push(points.map(DVec3::from)),
            Shape3::Outline(corners) if mark.role != Role::Discarded => {
                self.polygons.push(all(corners));
            }
            Shape3::Dot(at) | Shape3::Ring(at) | Shape3::Cross(at) => {
                let at = DVec3::from(*at);
                if !self.points.contains(&at) {
                    self.points.push(at);
                }
            }
            Shape3::Outline(_)
            | Shape3::Sheet(_)
            | Shape3::Wash(_)
            | Shape3::Ball(..)
            | Shape3::RightAngle(_)
            | Shape3::Label(_) => {}
        }
    }

    /// Where it is drawn: points, and along every line.
    pub fn places(&self) -> impl Iterator<Item = DVec3> {
        let along = |[a, b]: &[DVec3; 2]| {
            let (a, b) = (*a, *b);
            (0..=8).map(move |i| a.lerp(b, f64::from(i) / 8.0))
        };
        let lines = self.measured.iter().chain(&self.lines).flat_map(along);
        let corners = self.polygons.iter().flatten();
        self.points.iter().chain(corners).copied().chain(lines)
    }

    pub fn seen(&self, optics: &Optics) -> Seen {
        let lengths =
            |lines: &[[DVec3; 2]]| lines.iter().map(|ends| length(optics, ends)).collect();
        Seen {
            measured: lengths(&self.measured),
            lines: lengths(&self.lines),
            off_deg: self.angles.iter().map(|it| off_deg(optics, it)).collect(),
            apart: apart(optics, &self.points),
            areas: self
                .polygons
                .iter()
                .filter_map(|it| area(optics, it))
                .collect(),
        }
    }
}

/// Is it part of what a step says? What is fine or faint is a construction.
fn is_event(mark: &Mark3) -> bool {
    !mark.is_fine && !mark.is_edge && !matches!(mark.role, Role::Faint | Role::Soft)
}

fn all(corners: &[[f64; 3]]) -> Vec<DVec3> {
    corners.iter().copied().map(DVec3::from).collect()
}

fn on_picture(optics: &Optics, at: DVec3) -> Option<DVec2> {
    optics.seen(at).map(DVec2::from)
}

/// So large is the length 1 on the picture, at a place.
fn scale(optics: &Optics, at: DVec3) -> f64 {
    optics.half_height_at(optics.view_from_world(at).z).recip()
}

fn length(optics: &Optics, [a, b]: &[DVec3; 2]) -> f64 {
    let ends = on_picture(optics, *a).zip(on_picture(optics, *b));
    let true_length = a.distance(*b);
    if true_length == 0.0 {
        return 1.0;
    }
    ends.map_or(0.0, |(from, to)| {
        from.distance(to) / (true_length * scale(optics, a.midpoint(*b)))
    })
}

fn off_deg(optics: &Optics, [apex, a, b]: &[DVec3; 3]) -> f64 {
    let seen = [apex, a, b].map(|&at| on_picture(optics, at));
    let [Some(middle), Some(from), Some(to)] = seen else {
        return 180.0;
    };
    let true_angle = (*a - *apex).angle_between(*b - *apex);
    let angle = (from - middle).angle_to(to - middle).abs();
    (angle - true_angle).abs().to_degrees()
}

fn apart(optics: &Optics, points: &[DVec3]) -> Vec<[f64; 2]> {
    let seen: Vec<_> = points.iter().map(|&at| on_picture(optics, at)).collect();
    let pairs = (1..points.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let apart = |(i, j): (usize, usize)| {
        let far = seen[i].zip(seen[j]).map_or(0.0, |(a, b)| a.distance(b));
        let (a, b) = (points[i], points[j]);
        [far, a.distance(b) * scale(optics, a.midpoint(b))]
    };
    pairs.map(apart).collect()
}

fn area(optics: &Optics, corners: &[DVec3]) -> Option<f64> {
    let normal = normal(corners);
    let true_area = normal.length();
    let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
    let seen: Option<Vec<DVec2>> = corners.iter().map(|&at| on_picture(optics, at)).collect();
    if true_area == 0.0 {
        return None;
    }
    let Some(seen) = seen else { return Some(0.0) };
    let fan = (2..seen.len()).map(|i| (seen[i - 1] - seen[0]).perp_dot(seen[i] - seen[0]));
    let scale = scale(optics, middle);
    Some(fan.sum::<f64>().abs() / (true_area * scale * scale))
}
