//! What each role is drawn with: colour, weight and dash. No two roles differ by hue alone.

use egui::{Color32, Stroke};

use crate::figure::{Mark, Role, Shape};

use super::{
    Theme,
    parts::{HEAD, Marker},
};

const DOT_RADIUS: f32 = 5.5;
const SMALL_DOT_RADIUS: f32 = 3.5;
const RING_RADIUS: f32 = 6.5;
const CROSS_RADIUS: f32 = 6.0;

/// Up to this number the segments out of focus are part of the point that is made, and as strong as the one in focus.
const FEW: usize = 3;
/// And so many can still be told apart.
const SOME: usize = 50;

const THIN: f32 = 1.9;
const THIN_DASH: f32 = 0.6;

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pen {
    pub stroke: Stroke,
    pub is_dashed: bool,
    pub dash: f32,
    pub wash: Color32,
    pub text: Color32,
}

impl Pen {
    pub fn of(theme: &Theme, mark: &Mark) -> Self {
        let is_cut_off = mark.role == Role::Discarded && matches!(mark.shape, Shape::Segment(_));
        let colour = if is_cut_off {
            theme.soft
        } else {
            stroke_colour(theme, mark.role)
        };
        // What has a weight of its own is dashed where it says so.
        let is_quiet = matches!(mark.role, Role::Discarded | Role::Faint) && mark.weight.is_none();
        let (width, colour) = match mark.weight {
            Some(weight) => (weight.points, colour.gamma_multiply(weight.strength)),
            None => (width(mark), colour),
        };
        Self {
            stroke: theme.stroke(width, colour),
            is_dashed: mark.is_dashed || is_quiet,
            dash: if mark.weight.is_some_and(|weight| weight.points < THIN) {
                THIN_DASH
            } else {
                1.0
            },
            wash: wash(theme, mark.role)
                .gamma_multiply(mark.weight.map_or(1.0, |weight| weight.strength)),
            text: text_colour(theme, mark.role),
        }
    }

    /// For a crowd: the more there are, the quieter each is, so that the focused segment stays in front.
    pub fn of_crowd(theme: &Theme, mark: &Mark, n: usize) -> Self {
        let pen = Self::of(theme, mark);
        let is_living = mark.role == Role::Accent;
        let (width, strength) = match n {
            n if n <= FEW => (3.0, 1.0),
            n if n <= SOME => (if is_living { 2.0 } else { 1.25 }, 1.0),
            // So many cover every point several times over: what lies beneath still shows.
            n => {
                let strength = 0.3 * libm::powf(SOME as f32 / n as f32, 0.35);
                (if is_living { 1.5 } else { 1.0 }, strength)
            }
        };
        Self {
            stroke: theme.stroke(width, pen.stroke.color.gamma_multiply(strength)),
            is_dashed: pen.is_dashed && n <= FEW,
            ..pen
        }
    }
}

/// Of lines and markers: at least 3 : 1 on every ground.
pub const fn stroke_colour(theme: &Theme, role: Role) -> Color32 {
    match role {
        Role::Ink => theme.ink,
        Role::Soft => theme.soft,
        Role::Accent => theme.accent,
        Role::Signal => theme.signal,
        Role::Accepted => theme.accepted,
        Role::Faint | Role::Discarded => theme.discarded,
    }
}

/// Of labels: at least 4.5 : 1 on the stage.
pub const fn text_colour(theme: &Theme, role: Role) -> Color32 {
    match role {
        Role::Ink => theme.ink,
        Role::Accent => theme.accent,
        Role::Signal => theme.signal_text,
        Role::Accepted => theme.accepted,
        Role::Soft | Role::Faint | Role::Discarded => theme.soft,
    }
}

/// The window's is opaque. What is kept is a step stronger than what is discarded.
fn wash(theme: &Theme, role: Role) -> Color32 {
    let strength = match role {
        Role::Ink => return theme.accent_wash,
        Role::Accent | Role::Accepted => 0.2,
        Role::Signal => 0.1,
        Role::Soft | Role::Faint | Role::Discarded => 0.08,
    };
    stroke_colour(theme, role).gamma_multiply(strength)
}

fn width(mark: &Mark) -> f32 {
    let role = mark.role;
    let is_living = matches!(role, Role::Accent | Role::Accepted | Role::Signal);
    let is_angle = matches!(mark.shape, Shape::Angle(_) | Shape::RightAngle(_));
    if role == Role::Faint && !is_angle {
        return 1.0;
    }
    match &mark.shape {
        Shape::Angle(_) | Shape::RightAngle(_) | Shape::Hatch(_) => 1.25,
        Shape::Segment(_) if role != Role::Soft => 3.0,
        Shape::Path(_) if is_living || mark.is_dashed => 3.0,
        Shape::Arrow(_) => 2.5,
        Shape::Cross(_) if role == Role::Discarded => 1.75,
        Shape::Segment(_)
        | Shape::Path(_)
        | Shape::Cross(_)
        | Shape::Heading(_)
        | Shape::Border(..)
        | Shape::Line(_)
        | Shape::Ray(_)
        | Shape::Area(_)
        | Shape::Fill(_)
        | Shape::Outline(_)
        | Shape::HalfPlane(_)
        | Shape::Wash(_)
        | Shape::Solids(_)
        | Shape::Label(_)
        | Shape::Textured(_)
        | Shape::Dot(_)
        | Shape::Vertex(_)
        | Shape::Ring(_)
        | Shape::Bound(_)
        | Shape::Crowd(_)
        | Shape::Region(_) => 2.0,
    }
}

/// Room that a marker takes around its point, in points; a bound reaches to one side only.
pub fn radius(theme: &Theme, marker: Marker, mark: &Mark) -> f32 {
    let is_small = matches!(mark.role, Role::Soft | Role::Faint);
    let radius = match marker {
        Marker::Vertex => mark.weight.map_or(SMALL_DOT_RADIUS, |weight| weight.points),
        Marker::Dot if is_small => SMALL_DOT_RADIUS,
        Marker::Dot => DOT_RADIUS,
        Marker::Circle => RING_RADIUS,
        Marker::Cross => CROSS_RADIUS,
        Marker::Bound(_) => HEAD,
    };
    radius * theme.stroke_scale.sqrt()
}
