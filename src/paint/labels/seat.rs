//! What a label is about, what it would like, and where it came to stand.

use egui::{Pos2, Rect, Vec2, vec2};

use crate::{
    figure::{Chip, Link},
    paint::Theme,
};

use super::{anchor::Anchor, obstacles::Obstacle};

/// White space around a label.
pub const APART: Vec2 = vec2(5.0, 2.0);
const OFF_MARKERS: f32 = 10.0;
/// Points nearer than this are one, and its names one label.
pub const SAME_POINT: f32 = 0.5;

#[derive(Clone, PartialEq, Debug)]
pub struct Placed {
    pub text: String,
    pub rect: Rect,
    /// From what it belongs to, to the middle of its box: while an eye turns, both go together.
    pub offset: Vec2,
    pub has_halo: bool,
    pub has_plate: bool,
    pub leader: Option<[Pos2; 2]>,
    pub is_ambiguous: bool,
    /// What it names.
    pub link: Option<Link>,
}

#[derive(Clone, Copy, Default)]
pub struct Around<'a> {
    pub before: &'a [Placed],
    pub covered: &'a [Rect],
    /// What the edge of the drawing cuts grows faint before it.
    pub fades: bool,
}

/// A candidate, and what it costs whatever the other labels do.
#[derive(Clone, Copy)]
pub struct Candidate {
    pub rect: Rect,
    pub leader: Option<[Pos2; 2]>,
    pub cost: f32,
}

/// What a label or a chip needs and would like.
pub struct Seat {
    pub anchor: Anchor,
    pub size: Vec2,
    pub plain: String,
    pub toward: Option<Vec2>,
    pub is_of_side: bool,
    pub keeps_off_solids: bool,
    pub is_chip: bool,
}

impl Seat {
    pub fn of_chip(chip: Chip, anchor: Anchor, theme: &Theme) -> Self {
        Self {
            anchor,
            size: chip.size(theme),
            plain: format!("[{}]", chip.digit),
            toward: None,
            is_of_side: false,
            keeps_off_solids: false,
            is_chip: true,
        }
    }

    pub fn placed(&self, place: &Candidate, link: Option<Link>, obstacles: &[Obstacle]) -> Placed {
        let Candidate { rect, leader, .. } = *place;
        let is_point = matches!(self.anchor, Anchor::Point(..));
        let on = |is: &dyn Fn(&Obstacle) -> bool| obstacles.iter().any(is);
        Placed {
            text: self.plain.clone(),
            rect,
            offset: rect.center() - self.anchor.middle(),
            has_halo: on(&|it| it.covers(rect)),
            has_plate: on(&|it| it.is_picture() && it.covers(rect)),
            leader,
            is_ambiguous: is_point
                && leader.is_none()
                && is_of_another(&self.anchor, obstacles, rect),
            link,
        }
    }
}

pub fn is_of_another(anchor: &Anchor, obstacles: &[Obstacle], rect: Rect) -> bool {
    let (own, reach) = match *anchor {
        Anchor::Point(at, radius) => (Some(at), rect.distance_to_pos(at) - radius),
        Anchor::Along(_) => (None, OFF_MARKERS),
        // A region's code is its own, whatever lies in the region.
        Anchor::Inside(_) | Anchor::Within(_) => return false,
    };
    obstacles.iter().any(|obstacle| match *obstacle {
        Obstacle::Disc(at, radius) => {
            let is_own = own.is_some_and(|own| own.distance(at) <= radius + SAME_POINT);
            !is_own && rect.distance_to_pos(at) - radius < reach
        }
        _ => false,
    })
}

/// The direction that strokes which end in a point leave free: at a corner, out of it.
pub fn away(anchor: &Anchor, obstacles: &[(Rect, Obstacle)]) -> Option<Vec2> {
    let Anchor::Point(at, _) = anchor else {
        return None;
    };
    let ending = obstacles
        .iter()
        .filter_map(|(_, obstacle)| match *obstacle {
            Obstacle::Stroke([a, b], _) if a.distance(*at) < SAME_POINT => Some(b - *at),
            Obstacle::Stroke([a, b], _) if b.distance(*at) < SAME_POINT => Some(a - *at),
            _ => None,
        });
    let towards: Vec2 = ending.fold(Vec2::ZERO, |sum, d| sum + d.normalized());
    (towards.length() > 0.3).then(|| -towards.normalized())
}
