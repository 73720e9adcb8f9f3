//! The nearest good eye among some hundred directions, and the frame of one.

use glam::DVec3;

use crate::geom::Orbit;

use super::super::{
    layout::Slot,
    lens::{Lens, Optics},
};
use super::{
    corner::{count, emptiest},
    sights::Sights,
};

/// Two points are three radii of a marker apart.
pub const APART_PTS: f64 = 3.0 * 5.5;
/// A drawing that stands alone on a page, its width and height where it has least room.
const DRAWING_PTS: [f64; 2] = [420.0, 300.0];
/// Between an inset and the drawing's edges, and the height of its title.
const INSET_PTS: [f32; 2] = [13.0, 22.0];
/// White space around what is in the frame: labels stand there.
pub const AROUND: f64 = 1.08;

/// Between directions that are tried, in degrees; from the first of the pitches, above the ground, to the last.
const BETWEEN_DEG: u16 = 12;
const PITCHES_DEG: [u16; 2] = [6, 84];
/// The worth of a fault of the step in hand, and of one that every step of the run has, against a turn by a right angle.
const OF_STEP: f64 = 1000.0;
const OF_RUN: f64 = 6.0;
/// And of a part of the drawing's room that its frame leaves bare, where that is more than [`BARE`].
const OF_BARE: f64 = 3.0;
const BARE: f64 = 0.4;
/// An eye that serves other steps, too, may see a step so much smaller.
const MOST_FARTHER: f64 = 1.1;
/// What the scene's own eye has not in its frame is in the found one's, unless what is marked becomes smaller by more than this.
const MOST_SHRUNK: f64 = 1.9;

pub struct Search<'a> {
    pub home: Orbit,
    pub now: &'a [Sights],
    pub run: &'a [Sights],
    /// What the frame holds.
    pub places: &'a [DVec3],
    pub inset: Option<f64>,
    pub n_columns: usize,
}

/// What the frame holds: all that is marked, and of what is around it what the scene's own eye has in its frame, or what leaves
/// the marked large enough.
pub fn held(home: Orbit, [marked, around @ ..]: [Vec<DVec3>; 3]) -> Vec<DVec3> {
    let Some(optics) = Optics::of(&Lens::Eye(home)) else {
        return marked;
    };
    let size = |places: &[DVec3]| {
        let (min, max) = bounds(places.iter().filter_map(|&at| on_picture(&optics, at)));
        ((max - min) / DVec3::new(home.aspect(), 1.0, 1.0)).max_element()
    };
    let frame = AROUND * DVec3::new(home.aspect(), 1.0, 1.0);
    let is_framed =
        |&at: &DVec3| on_picture(&optics, at).is_some_and(|at| at.abs().cmple(frame).all());
    let least = size(&marked);
    let mut held = marked;
    for more in around {
        let is_whole = more.iter().all(is_framed);
        let with: Vec<DVec3> = held.iter().copied().chain(more).collect();
        if held.is_empty() || is_whole || size(&with) <= MOST_SHRUNK * least {
            held = with;
        }
    }
    held
}

fn on_picture(optics: &Optics, at: DVec3) -> Option<DVec3> {
    let [x, y] = optics.seen(at)?;
    Some(DVec3::new(x, y, 0.0))
}

impl Search<'_> {
    pub fn nearest(&self) -> Orbit {
        if self.places.is_empty() {
            return self.home;
        }
        let home = self.home.angles_deg();
        let straight = self.back(home);
        let mut best = (f64::INFINITY, home);
        for angles in std::iter::once(home).chain(directions(home)) {
            let turn = straight.angle_between(self.back(angles)) / std::f64::consts::FRAC_PI_2;
            // No fault makes up for a turn that costs more than the best eye does.
            if turn < best.0
                && let Some(cost) = self.less_than(best.0, turn, &self.framed(angles, ROUNDS[0]))
            {
                best = (cost, angles);
            }
        }
        self.framed(best.1, ROUNDS[1])
    }

    /// From what is looked at to an eye in this direction.
    fn back(&self, angles: [f64; 2]) -> DVec3 {
        let eye = Orbit::new([0.0; 3], angles, 1.0, self.home.fov_y_deg());
        let [_, _, back] = eye.axes().map(DVec3::from);
        back
    }

    /// Does an eye see what the step measures, in a frame that holds it, and from not much farther than the step's own?
    pub fn may_take(&self, eye: &Orbit, own: &Orbit) -> bool {
        let is_framed = |optics: &Optics| {
            let frame = DVec3::new(eye.aspect(), 1.0, 1.0);
            let mut seen = self.places.iter().map(|&at| on_picture(optics, at));
            seen.all(|at| at.is_some_and(|at| at.abs().cmple(frame).all()))
        };
        let size = |eye: &Orbit| eye.distance() * eye.aspect().max(1.0);
        let faults = |eye: &Orbit| Some(self.now_faults(&Optics::of(&Lens::Eye(*eye))?, eye));
        size(eye) <= MOST_FARTHER * size(own)
            && Optics::of(&Lens::Eye(*eye)).is_some_and(|optics| is_framed(&optics))
            && faults(eye) <= faults(own)
    }

    /// Of the step in hand.
    fn now_faults(&self, optics: &Optics, eye: &Orbit) -> f64 {
        let apart = APART_PTS / self.scale(eye);
        let short = |sights: &Sights| sights.seen(optics).shortfalls(apart);
        let now: f64 = self.now.iter().flat_map(short).sum();
        now + self.covered(optics, eye)
    }

    /// What an eye costs that has turned so far, if that is less; what only adds to a sum that is not is not looked at.
    fn less_than(&self, most: f64, turn: f64, eye: &Orbit) -> Option<f64> {
        let optics = Optics::of(&Lens::Eye(*eye))?;
        let now = OF_STEP * self.now_faults(&optics, eye);
        let turn = turn + OF_BARE * (self.bare(eye) - BARE).max(0.0);
        let cost = (now + turn < most).then(|| now + self.run_faults(&optics, eye) + turn);
        cost.filter(|cost| *cost < most)
    }

    /// Of all steps, where points of other steps have their turn.
    fn run_faults(&self, optics: &Optics, eye: &Orbit) -> f64 {
        let apart = APART_PTS / self.scale(eye);
        let short = |sights: &Sights| sights.seen(optics).shortfalls(apart);
        let run = self.run.iter().map(|sights| {
            let [lengths, angles, _, areas] = short(sights);
            lengths + angles + areas
        });
        let run: f64 = run.sum();
        let n_steps = self.run.len().max(1) as f64;
        OF_RUN * run / n_steps
    }

    /// Points to 1 on the picture.
    fn scale(&self, eye: &Orbit) -> f64 {
        let [width, height] = DRAWING_PTS.map(|side| 0.5 * side / self.n_columns as f64);
        height.min(width / eye.aspect())
    }

    /// The part of the drawing's room that a high frame leaves bare beside it: a line, which is flat, fills none.
    fn bare(&self, eye: &Orbit) -> f64 {
        let [width, height] = DRAWING_PTS;
        let shape = eye.aspect() * height * self.n_columns as f64 / width;
        1.0 - shape.min(1.0)
    }

    /// The part of what the step marks that lies under the inset, wherever that stands.
    fn covered(&self, optics: &Optics, eye: &Orbit) -> f64 {
        let Some(aspect) = self.inset else { return 0.0 };
        let size = DRAWING_PTS.map(|side| (side / self.n_columns as f64) as f32);
        let drawing = Slot::new(size.map(|side| -0.5 * side), size);
        let inset = drawing.inset([aspect as f32, 1.0], INSET_PTS[0]);
        let scale = self.scale(eye);
        let places = self.now.iter().flat_map(Sights::places).map(|at| {
            let [x, y] = optics.picture_from_view(optics.view_from_world(at));
            [(scale * x) as f32, (-scale * y) as f32]
        });
        let places: Vec<[f32; 2]> = places.collect();
        let under = |slot: Slot| count(places.iter().copied(), slot);
        let stands = emptiest(drawing, inset, INSET_PTS[1], under);
        under(stands) as f64 / places.len().max(1) as f64
    }

    /// The eye in a direction, which has everything in its frame, from −1 to 1 across its height.
    fn framed(&self, angles: [f64; 2], rounds: usize) -> Orbit {
        let (min, max) = bounds(self.places.iter().copied());
        let (middle, radius) = (min.midpoint(max), 0.5 * min.distance(max));
        let fov = self.home.fov_y_deg();
        let mut eye = Orbit::new(middle.into(), angles, 2.0 * radius, fov);
        eye = Orbit::new(
            middle.into(),
            angles,
            radius / eye.half_height() + radius,
            fov,
        );
        for _ in 0..rounds {
            let Some(optics) = Optics::of(&Lens::Eye(eye)) else {
                return eye;
            };
            let seen = self.places.iter();
            let (min, max) = bounds(seen.filter_map(|&at| on_picture(&optics, at)));
            let (middle, half) = (min.midpoint(max), AROUND * 0.5 * (max - min));
            // What lies on a line has some room on both sides.
            let half = half.max(DVec3::new(half.y, half.x, 0.0) * FLATTEST);
            if half.y <= 0.0 || !half.is_finite() {
                return eye;
            }
            eye = eye.panned([middle.x, middle.y]).zoomed(half.y.recip());
            eye = eye.wide(half.x / half.y);
        }
        eye
    }
}

/// Rounds of framing: for a direction that is tried, and for the one that is taken. Each is a tenth as far off as the last.
const ROUNDS: [usize; 2] = [2, 8];
/// The least of a frame's sides over the other.
const FLATTEST: f64 = 0.15;

fn bounds(places: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    places.fold(none, |(min, max), at| (min.min(at), max.max(at)))
}

/// All around, in rings of the same distance.
fn directions([yaw, _]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let [low, high] = PITCHES_DEG;
    let pitches = (low..=high).step_by(BETWEEN_DEG.into());
    pitches.flat_map(move |pitch| {
        let around = (0..360_u16).step_by(BETWEEN_DEG.into());
        around.map(move |turn| [yaw + f64::from(turn), f64::from(pitch)])
    })
}
