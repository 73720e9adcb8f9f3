//! Marks of space as marks of a plane.

use crate::geom::pairs_around;

use super::super::{
    mark::{Mark, Shape, Weight},
    role::{Label, Role},
    space::{Mark3, Shape3},
};
use super::{Seen, facets::cut_at, weight};

/// Lines of construction: widths in points, and how strong.
const FINE: Weight = weight(1.2, 1.0);
const FINE_SIGNAL: Weight = weight(1.75, 1.0);
const FINE_SOFT: Weight = weight(1.0, 0.5);
const FINE_FAINT: Weight = weight(1.0, 0.35);
const FINE_HIDDEN: Weight = weight(1.0, 0.5);
const HIDDEN: Weight = weight(1.5, 0.7);
const OUTLINE: Weight = weight(2.25, 1.0);
const FINE_DOT: Weight = weight(2.2, 1.0);
const ANGLE: Weight = weight(1.25, 1.0);
const BALL: Weight = weight(1.75, 1.0);
/// Places of a picture that are so near, of its half height, are one.
const NEAR: f64 = 1e-6;

impl Seen {
    pub(super) fn wash(&self, mark: &Mark3) -> Option<Mark> {
        let Shape3::Wash(corners) = &mark.shape else {
            return None;
        };
        let view = self.optics.all_from_world(corners);
        // What is just in front of the eye has no place on the picture.
        let kept = cut_at(&view, -self.optics.near * (1.0 + 1e-9));
        let corners: Vec<[f64; 2]> = kept.into_iter().map(|at| self.on_picture(at)).collect();
        let tint = Mark::new(mark.role, Shape::Fill(vec![corners]));
        // Several lie over each other.
        let strength = match mark.role {
            // Seen only where it is lit.
            _ if mark.is_fine => 0.0,
            Role::Signal => 1.0,
            Role::Ink | Role::Soft | Role::Faint | Role::Discarded => 0.5,
            Role::Accent | Role::Accepted => 0.3,
        };
        Some(named(tint.weighing(weight(0.0, strength)), mark))
    }

    pub(super) fn mark(&mut self, mark: &Mark3) -> Vec<Mark> {
        match &mark.shape {
            Shape3::Wash(_) => Vec::new(),
            Shape3::Segment(ends) => self.line(mark, &[*ends]),
            Shape3::Outline(corners) | Shape3::Sheet(corners) => {
                let ends: Vec<_> = pairs_around(corners).collect();
                self.line(mark, &ends)
            }
            Shape3::Arrow(ends) => self.arrow(mark, *ends),
            Shape3::Ball(centre, radius) => self.ball(mark, *centre, *radius),
            Shape3::RightAngle(points) => self.right_angle(mark, *points),
            Shape3::Angle(points) => self.angle(mark, *points),
            Shape3::Dot(at) if mark.is_fine => {
                let drawn = self.point(mark, *at, Shape::Vertex).into_iter();
                drawn.map(|dot| dot.weighing(FINE_DOT)).collect()
            }
            Shape3::Dot(at) => self.point(mark, *at, Shape::Dot),
            Shape3::Ring(at) => self.point(mark, *at, Shape::Ring),
            Shape3::Cross(at) => self.point(mark, *at, Shape::Cross),
            Shape3::Label(at) => self.point(mark, *at, Shape::Label),
        }
    }

    fn point(&self, mark: &Mark3, at: [f64; 3], shape: fn([f64; 2]) -> Shape) -> Vec<Mark> {
        let seen = self.in_view(at).map(|view| self.on_picture(view));
        let drawn = seen.map(|at| named(Mark::new(mark.role, shape(at)), mark));
        drawn.into_iter().collect()
    }

    fn line(&mut self, mark: &Mark3, edges: &[[[f64; 3]; 2]]) -> Vec<Mark> {
        let (mut hidden, mut visible) = (Vec::new(), Vec::new());
        for &ends in edges {
            let parted = self.parted(ends, [None; 2]);
            hidden.extend(parted.hidden);
            visible.extend(parted.visible);
        }
        let is_whole = hidden.is_empty() && visible.len() == edges.len();
        let behind = hidden.into_iter().map(|ends| {
            let path = Mark::new(mark.role, Shape::Path(ends.to_vec())).dashed();
            path.weighing(if mark.is_fine { FINE_HIDDEN } else { HIDDEN })
        });
        let mut drawn: Vec<Mark> = behind.collect();
        let is_outline = is_whole && edges.len() > 1;
        if is_outline {
            let corners = visible.iter().map(|ends| ends[0]).collect();
            let outline = quiet(Mark::new(mark.role, Shape::Outline(corners)));
            drawn.push(weighed(outline.weighing(OUTLINE), mark.is_fine));
        } else {
            let is_part = mark.is_edge || edges.len() > 1;
            let parts = visible.into_iter().map(|ends| {
                let part = if is_part {
                    Mark::new(mark.role, Shape::Path(ends.to_vec())).weighing(OUTLINE)
                } else {
                    Mark::new(mark.role, Shape::Segment(ends))
                };
                weighed(quiet(part), mark.is_fine)
            });
            drawn.extend(parts);
        }
        // What bounds a tone does not cross it.
        let crosses = edges.len() == 1 && !mark.is_edge && stands_out(mark.role);
        for part in &mut drawn {
            part.link = mark.link;
            part.is_dashed |= mark.is_dashed;
            part.is_cased = crosses && !part.is_dashed;
        }
        // Its name stands once, where it is seen and longest.
        let named = (0..drawn.len()).max_by(|&a, &b| {
            let order = |i: usize| (!drawn[i].is_dashed, length(&drawn[i].shape));
            let ((a_seen, a), (b_seen, b)) = (order(a), order(b));
            a_seen.cmp(&b_seen).then(a.total_cmp(&b))
        });
        if let Some(idx) = named {
            drawn[idx].label.clone_from(&mark.label);
        }
        drawn
    }

    /// A line with a head at its tip, hidden or not.
    fn arrow(&mut self, mark: &Mark3, ends: [[f64; 3]; 2]) -> Vec<Mark> {
        let tip = self.in_view(ends[1]).map(|view| self.on_picture(view));
        let mut drawn = self.line(mark, &[ends]);
        for part in &mut drawn {
            let ends = match &part.shape {
                Shape::Segment(ends) => *ends,
                Shape::Path(points) => [points[0], points[points.len() - 1]],
                _ => continue,
            };
            let apart = tip.map(|tip| libm::hypot(ends[1][0] - tip[0], ends[1][1] - tip[1]));
            if apart.is_some_and(|apart| apart < NEAR) {
                part.shape = Shape::Arrow(ends);
            }
        }
        drawn
    }

    fn ball(&self, mark: &Mark3, centre: [f64; 3], radius: f64) -> Vec<Mark> {
        let outline = self.ball_outline(centre, radius);
        if outline.is_empty() {
            return Vec::new();
        }
        let drawn = Mark::new(mark.role, Shape::Outline(outline));
        let drawn = if mark.is_fine {
            weighed(drawn, true)
        } else {
            drawn.weighing(BALL)
        };
        vec![named(drawn, mark)]
    }

    fn right_angle(&self, mark: &Mark3, points: [[f64; 3]; 3]) -> Vec<Mark> {
        let corner = self.right_angle_corner(points);
        let drawn = corner.map(|points| {
            let drawn = Mark::new(mark.role, Shape::Path(points.to_vec()));
            named(drawn.weighing(ANGLE), mark)
        });
        drawn.into_iter().collect()
    }

    fn angle(&self, mark: &Mark3, points: [[f64; 3]; 3]) -> Vec<Mark> {
        let Some((arc, apex)) = self.arc(points) else {
            return Vec::new();
        };
        let middle = arc[arc.len() / 2];
        let mut drawn = Mark::new(mark.role, Shape::Path(arc));
        drawn.link = mark.link;
        let label = mark.label.clone().map(|label| Label {
            toward: Some([middle[0] - apex[0], middle[1] - apex[1]]),
            ..label
        });
        let mut said = Mark::new(mark.role, Shape::Label(middle));
        (said.label, said.link) = (label, mark.link);
        vec![drawn.weighing(ANGLE), said]
    }
}

fn named(mut drawn: Mark, mark: &Mark3) -> Mark {
    (drawn.label, drawn.link) = (mark.label.clone(), mark.link);
    drawn.is_dashed |= mark.is_dashed;
    drawn
}

fn quiet(mut drawn: Mark) -> Mark {
    drawn.is_dashed |= drawn.role == Role::Discarded;
    drawn
}

fn weighed(drawn: Mark, is_fine: bool) -> Mark {
    if !is_fine {
        return drawn;
    }
    let weight = match drawn.role {
        Role::Ink | Role::Accent | Role::Accepted | Role::Discarded => FINE,
        Role::Signal => FINE_SIGNAL,
        Role::Soft => FINE_SOFT,
        Role::Faint => FINE_FAINT,
    };
    drawn.weighing(weight)
}

/// Is a line of this role what a picture is about? Then no tone may swallow it.
const fn stands_out(role: Role) -> bool {
    matches!(role, Role::Accent | Role::Signal | Role::Accepted)
}

fn length(shape: &Shape) -> f64 {
    let ends = if let Shape::Segment(ends) = shape {
        *ends
    } else if let Shape::Path(points) = shape
        && let [a, b] = points[..]
    {
        [a, b]
    } else {
        return f64::INFINITY;
    };
    libm::hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1])
}
