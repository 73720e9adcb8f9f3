//! Places for labels. They are placed one by one, this step's first, and then each again, now that the others stand: where
//! distance and what it covers cost least. In a window a label would rather stay; in a figure there is no before.

mod anchor;
mod chips;
mod obstacles;
mod places;
mod seating;
mod text;

use egui::{Painter, Pos2, Rect, Vec2, vec2};

use crate::figure::{Chip, Label, Link, Mark, Role, Shape};

use super::{Look, Theme, Viewport, layers::LayeredPart};

use self::{
    anchor::Anchor,
    obstacles::obstacles,
    places::{LabelPlace, Lean, places},
    seating::{APART, Candidate, Seating},
    text::{INSIDE, Setter, Text},
};

pub use self::obstacles::Obstacle;

/// Of a drawing whose smaller side has so many points labels are as large as at scale 1; of larger ones larger.
const ROOMY: f32 = 250.0;
/// More labels than this would cover the figure, and finding places for them would take longer than a frame.
const MOST_LABELS: usize = 160;
const PLATE: Vec2 = vec2(3.0, 1.0);
const UNSEEN: f32 = 1_000.0;
const WRONG: f32 = 100_000.0;
/// What it costs to stand nearer to another point's marker than to its own: it would seem to be that one's name.
const AMBIGUOUS: f32 = 60.0;
/// How much better than the place that it had another has to be: no label hops for the sake of a neighbour's.
const STAY: f32 = 40.0;
const SAME_PLACE: f32 = 2.0;
const OFF_MARKERS: f32 = 10.0;
/// A chip lies on what it is about, and may lie on a line or two more: they count so much.
const UNDER_A_CHIP: f32 = 0.3;
/// What costs more covers a label: the chip is left out.
const MOST_OF_A_CHIP: f32 = 340.0;
/// Points nearer than this are one, and its names one label.
const SAME_POINT: f32 = 0.5;

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

pub struct Labels {
    texts: Vec<Text>,
    /// The labels, then the chips.
    pub placed: Vec<Placed>,
    pub chips: Vec<Chip>,
    pub obstacles: Vec<Obstacle>,
}

/// What a label or a chip needs and would like.
struct Seat {
    anchor: Anchor,
    size: Vec2,
    plain: String,
    toward: Option<Vec2>,
    is_of_side: bool,
    keeps_off_solids: bool,
    is_chip: bool,
}

struct Waiting {
    text: Text,
    seat: Seat,
    rank: u8,
    link: Option<Link>,
}

impl Labels {
    pub fn new(
        painter: &Painter,
        viewport: &Viewport,
        look: Look<'_>,
        (marks, pieces): (&[Mark], &[LayeredPart<'_>]),
        around: Around<'_>,
    ) -> Self {
        let scale = scale(look.theme, viewport);
        let setter = Setter {
            painter,
            look,
            scale,
        };
        let mut waiting = waiting(setter, viewport, marks);
        waiting.sort_by_key(|label| label.rank);
        waiting.truncate(MOST_LABELS);
        let obstacles = obstacles(viewport, look.theme, pieces);
        let stage = viewport.rect;
        let candidates = |seat: &Seat| candidates(seat, stage, &obstacles, around);
        let mut table = Seating {
            stage,
            places: waiting.iter().map(|it| candidates(&it.seat)).collect(),
            taken: Vec::new(),
        };
        table.fill();
        // After all labels, which stay where they are.
        let chips = chips::anchored(viewport, look, marks).into_iter();
        let seated = chips.map(|(chip, anchor)| {
            let seat = Seat::of_chip(chip, anchor, look.theme);
            let place = table.seat(candidates(&seat));
            (chip, seat, place)
        });
        let seated = seated.filter(|(.., place)| place.cost < MOST_OF_A_CHIP);
        let seated: Vec<(Chip, Seat, Candidate)> = seated.collect();
        let places = waiting.into_iter().zip(table.taken);
        // What has a place only where it would be wrong, cut off, or over another is better not said.
        let places = places.filter(|(_, place)| place.cost < UNSEEN);
        let (texts, mut placed): (_, Vec<Placed>) = places
            .map(|(label, place)| {
                let placed = label.seat.placed(&place, label.link, &obstacles);
                (label.text, placed)
            })
            .unzip();
        let of_chip = |(chip, seat, place): &(Chip, Seat, Candidate)| {
            seat.placed(place, chip.link, &obstacles)
        };
        placed.extend(seated.iter().map(of_chip));
        Self {
            texts,
            placed,
            chips: seated.into_iter().map(|(chip, ..)| chip).collect(),
            obstacles,
        }
    }

    pub fn draw(&self, painter: &Painter, look: Look<'_>, lit: Option<Link>) {
        let theme = look.theme;
        for Placed { leader, .. } in &self.placed {
            if let Some(ends) = leader {
                painter.line_segment(*ends, theme.stroke(1.0, theme.discarded));
            }
        }
        let labels = || self.texts.iter().zip(&self.placed);
        // Neither covers another label.
        for (text, placed) in labels() {
            if placed.has_plate {
                let plate = placed.rect.expand2(PLATE);
                painter.rect_filled(plate, PLATE.x, theme.background);
            } else if placed.has_halo {
                text.paint_halo(painter, theme, placed.rect);
            }
        }
        for (text, placed) in labels() {
            text.paint(painter, placed.rect);
        }
        for (chip, placed) in self.chips.iter().zip(&self.placed[self.texts.len()..]) {
            let is_lit = lit.is_some() && chip.link == lit;
            chip.draw(painter, theme, placed.rect.center(), is_lit);
        }
    }
}

impl Seat {
    fn of_chip(chip: Chip, anchor: Anchor, theme: &Theme) -> Self {
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

    fn placed(&self, place: &Candidate, link: Option<Link>, obstacles: &[Obstacle]) -> Placed {
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

/// How large labels are: on a small drawing not much larger than is read well, for it has to be seen beside them.
fn scale(theme: &Theme, viewport: &Viewport) -> f32 {
    let room = viewport.rect.size().min_elem() / ROOMY;
    theme.text_scale.min(room.max(1.0))
}

/// The labels of all marks. Those of one point are one label: `C₁ = I₁`.
fn waiting(setter: Setter<'_>, viewport: &Viewport, marks: &[Mark]) -> Vec<Waiting> {
    let mut waiting: Vec<Waiting> = Vec::new();
    for mark in marks {
        let Some(label) = &mark.label else { continue };
        let Some(anchor) = Anchor::of(viewport, setter.look.theme, mark) else {
            continue;
        };
        let text = match anchor {
            // A region's label beside the region would say what is not true.
            Anchor::Inside(region) => setter.set_in(region.size(), label, mark.role),
            _ => Some(setter.set_at(1.0, label, mark.role)),
        };
        let Some(text) = text else { continue };
        let rank = rank(label, &anchor, mark.role);
        let is_same = |other: &&mut Waiting| {
            is_same_point(&other.seat.anchor, &anchor) && can_join(&other.text, &text)
        };
        match waiting.iter_mut().find(is_same) {
            Some(other) if other.text.plain == text.plain => {
                // The later mark lies over the one before.
                other.says(text, rank);
            }
            Some(other) => {
                let joined = setter.join(&other.text, &text);
                other.says(joined, rank);
            }
            None => waiting.push(Waiting {
                seat: Seat {
                    anchor,
                    size: text.size(),
                    plain: text.plain.clone(),
                    toward: toward(viewport, mark, label),
                    is_of_side: label.toward.is_some(),
                    keeps_off_solids: matches!(mark.shape, Shape::Label(_)),
                    is_chip: false,
                },
                text,
                rank,
                link: mark.link,
            }),
        }
    }
    waiting
}

impl Waiting {
    fn says(&mut self, text: Text, rank: u8) {
        self.rank = self.rank.min(rank);
        (self.seat.size, self.seat.plain) = (text.size(), text.plain.clone());
        self.text = text;
    }
}

/// This step's labels choose first, those that can stand anywhere choose last.
const fn rank(label: &Label, anchor: &Anchor, role: Role) -> u8 {
    match anchor {
        Anchor::Inside(_) | Anchor::Within(_) => 3,
        _ if matches!(role, Role::Signal) => 0,
        _ if label.strong => 1,
        _ => 2,
    }
}

fn is_same_point(a: &Anchor, b: &Anchor) -> bool {
    let (Anchor::Point(a, radius), Anchor::Point(b, other)) = (a, b) else {
        return false;
    };
    (*radius > 0.0) == (*other > 0.0) && a.distance(*b) < SAME_POINT
}

/// Names can be said to be of one thing; an equation cannot.
fn can_join(a: &Text, b: &Text) -> bool {
    let is_name = |text: &Text| !text.plain.contains([':', '<', '>', '≈']);
    a.plain == b.plain || (is_name(a) && is_name(b) && !b.plain.contains('='))
}

fn toward(viewport: &Viewport, mark: &Mark, label: &Label) -> Option<Vec2> {
    let on_screen = |[x, y]: [f64; 2]| vec2(x as f32, -y as f32);
    let unshaded = || {
        let Shape::HalfPlane([a, b]) = mark.shape else {
            return None;
        };
        let along = viewport.to_screen(b) - viewport.to_screen(a);
        Some(vec2(-along.y, along.x))
    };
    label.toward.map(on_screen).or_else(unshaded)
}

fn candidates(
    label: &Seat,
    stage: Rect,
    obstacles: &[Obstacle],
    around: Around<'_>,
) -> Vec<Candidate> {
    let middle = label.anchor.middle();
    let stood = around.before.iter();
    let stood = stood.filter(|it| it.text == label.plain);
    let stood = stood.flat_map(|it| [it.rect.center(), middle + it.offset]);
    let stood: Vec<Pos2> = stood.collect();
    let size = label.size;
    let lean = Lean {
        toward: label.toward,
        is_of_side: label.is_of_side,
        is_on: label.is_chip,
        away: away(&label.anchor, obstacles),
    };
    let places = places(&label.anchor, size, stage, lean);
    let centres: Vec<Pos2> = places.iter().map(|place| place.centre).collect();
    let reach = Rect::from_points(&centres).expand2(size);
    let nearby = obstacles
        .iter()
        .map(|it| (it.bounds(), *it))
        .filter(|(bounds, it)| {
            bounds.intersects(reach) && (label.keeps_off_solids || !it.is_surface())
        });
    let nearby: Vec<(Rect, Obstacle)> = nearby.collect();
    let discs = nearby.iter().map(|(_, obstacle)| *obstacle);
    let discs: Vec<Obstacle> = discs
        .filter(|it| matches!(it, Obstacle::Disc(..)))
        .collect();
    let if_so = |is_so: bool, cost: f32| if is_so { cost } else { 0.0 };
    let of_place = |place: LabelPlace| {
        let rect = Rect::from_center_size(place.centre, size);
        // Whole pixels keep the text crisp.
        let rect = rect.translate(rect.min.round() - rect.min);
        let near = rect.expand2(APART);
        let touching = nearby.iter().filter(|(bounds, _)| bounds.intersects(near));
        let covered: f32 = touching.map(|(_, obstacle)| obstacle.cost(rect)).sum();
        let covered = covered * if label.is_chip { UNDER_A_CHIP } else { 1.0 };
        let is_free = |covered: &Rect| !covered.intersects(near);
        let is_seen = stage.shrink(3.0).contains_rect(rect) && around.covered.iter().all(is_free);
        let is_inside = match label.anchor {
            Anchor::Inside(region) => region.expand(0.5).contains_rect(rect.expand2(INSIDE)),
            _ => true,
        };
        let leader = place.leader.map(|from| [from, rect.clamp(from)]);
        let is_ambiguous = leader.is_none() && is_of_another(&label.anchor, &discs, rect);
        let is_there = |at: &Pos2| at.distance(rect.center()) < SAME_PLACE;
        let stays = stood.iter().any(is_there);
        Candidate {
            rect,
            leader,
            cost: place.dislike + covered + if_so(is_ambiguous, AMBIGUOUS) - if_so(stays, STAY)
                + if_so(!is_seen, UNSEEN)
                + if_so(!is_inside || place.is_wrong, WRONG),
        }
    };
    let mut candidates: Vec<Candidate> = places.into_iter().map(of_place).collect();
    candidates.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    candidates
}

fn is_of_another(anchor: &Anchor, obstacles: &[Obstacle], rect: Rect) -> bool {
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
fn away(anchor: &Anchor, obstacles: &[Obstacle]) -> Option<Vec2> {
    let Anchor::Point(at, _) = anchor else {
        return None;
    };
    let ending = obstacles.iter().filter_map(|obstacle| match *obstacle {
        Obstacle::Stroke([a, b], _) if a.distance(*at) < SAME_POINT => Some(b - *at),
        Obstacle::Stroke([a, b], _) if b.distance(*at) < SAME_POINT => Some(a - *at),
        _ => None,
    });
    let towards: Vec2 = ending.fold(Vec2::ZERO, |sum, d| sum + d.normalized());
    (towards.length() > 0.3).then(|| -towards.normalized())
}
