//! Finding places for labels: near their anchor, on nothing else, inside the stage.
//!
//! Each label has candidate places. Labels are placed one by one, this step's first, and then each again, now that the
//! others stand: it takes the place where distance and what it covers cost least. In a window a label that stood there
//! before would rather stay; in a figure there is no before, and the same marks give the same places.

mod anchor;
mod obstacles;
mod places;
mod seating;
mod text;

use egui::{Painter, Pos2, Rect, Vec2, vec2};

use crate::{
    figure::{Label, Mark, Role, Shape},
    text::Catalog,
};

use super::{Theme, Viewport, layers::LayeredPart};

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
/// By so much a plate is larger than what stands on it, in points.
const PLATE: Vec2 = vec2(3.0, 1.0);
/// What it costs a label to be cut off.
const UNSEEN: f32 = 1_000.0;
/// What it costs a label to stand where it says what is not true: more than anything else.
const WRONG: f32 = 100_000.0;
/// What it costs to stand nearer to another point's marker than to its own: it would seem to be that one's name.
const AMBIGUOUS: f32 = 14.0;
/// How much better than the place that it had another has to be: no label hops for the sake of a neighbour's.
const STAY: f32 = 40.0;
/// A place is the same if it is no farther off than this, in points.
const SAME_PLACE: f32 = 2.0;
/// White space between what is no point's label and a marker, in points.
const OFF_MARKERS: f32 = 10.0;
/// Points nearer than this are one, and its names one label.
const SAME_POINT: f32 = 0.5;

/// A label in its place.
#[derive(Clone, PartialEq, Debug)]
pub struct Placed {
    /// What it says.
    pub text: String,
    /// The box around its letters.
    pub rect: Rect,
    /// From what it belongs to, to the middle of its box: while an eye turns, both go together.
    pub offset: Vec2,
    /// A stroke or a marker runs under it: it has a halo, so that it can be read.
    pub has_halo: bool,
    /// It stands on a picture, and on a plate of its own.
    pub has_plate: bool,
    /// A thin line that leads from its mark to it.
    pub leader: Option<[Pos2; 2]>,
    /// The marker of another mark is nearer to it than its own.
    pub is_ambiguous: bool,
}

/// What labels heed beside the marks.
#[derive(Clone, Copy, Default)]
pub struct Around<'a> {
    /// Where labels stood before: they would rather stay there.
    pub before: &'a [Placed],
    /// What something else stands on.
    pub covered: &'a [Rect],
}

/// All labels of a stage in their places.
pub struct Labels {
    texts: Vec<Text>,
    /// In the order of placing.
    pub placed: Vec<Placed>,
    /// What they keep off.
    pub obstacles: Vec<Obstacle>,
}

/// A label that waits for its place.
struct Waiting {
    text: Text,
    anchor: Anchor,
    toward: Option<Vec2>,
    is_of_side: bool,
    /// It is beside something and on nothing: no solid is its ground.
    keeps_off_solids: bool,
    rank: u8,
}

impl Labels {
    /// Finds places for the labels of these marks.
    pub fn new(
        painter: &Painter,
        viewport: &Viewport,
        theme: &Theme,
        catalog: &Catalog,
        (marks, pieces): (&[Mark], &[LayeredPart<'_>]),
        around: Around<'_>,
    ) -> Self {
        let setter = Setter {
            painter,
            theme,
            scale: scale(theme, viewport),
            catalog,
        };
        let mut waiting = waiting(setter, viewport, marks);
        waiting.sort_by_key(|label| label.rank);
        waiting.truncate(MOST_LABELS);
        let obstacles = obstacles(viewport, theme, pieces);
        let mut table = Seating {
            stage: viewport.rect,
            places: waiting
                .iter()
                .map(|label| candidates(label, viewport.rect, &obstacles, around))
                .collect(),
            taken: Vec::new(),
        };
        table.fill();
        let places = waiting.into_iter().zip(table.taken);
        // What has a place only where it would be wrong, cut off, or over another is better not said.
        let places = places.filter(|(_, place)| place.cost < UNSEEN);
        let (texts, placed) = places
            .map(|(label, Candidate { rect, leader, .. })| {
                let is_point = matches!(label.anchor, Anchor::Point(..));
                let placed = Placed {
                    text: label.text.plain.clone(),
                    rect,
                    offset: rect.center() - label.anchor.middle(),
                    has_halo: obstacles.iter().any(|obstacle| obstacle.covers(rect)),
                    has_plate: obstacles
                        .iter()
                        .any(|it| it.is_picture() && it.covers(rect)),
                    leader,
                    is_ambiguous: is_point
                        && leader.is_none()
                        && is_of_another(&label.anchor, &obstacles, rect),
                };
                (label.text, placed)
            })
            .unzip();
        Self {
            texts,
            placed,
            obstacles,
        }
    }

    /// Draws them.
    pub fn draw(&self, painter: &Painter, theme: &Theme) {
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
        let Some(anchor) = Anchor::of(viewport, setter.theme, mark) else {
            continue;
        };
        let text = match anchor {
            // A region's label beside the region would say what is not true.
            Anchor::Inside(region) => setter.set_in(region.size(), label, mark.role),
            Anchor::Point(..) | Anchor::Along(_) | Anchor::Within(_) => {
                Some(setter.set(label, mark.role))
            }
        };
        let Some(text) = text else { continue };
        let rank = rank(label, &anchor, mark.role);
        let same = waiting
            .iter_mut()
            .find(|other| is_same_point(&other.anchor, &anchor) && can_join(&other.text, &text));
        match same {
            Some(other) if other.text.plain == text.plain => {
                // The later mark lies over the one before.
                (other.text, other.rank) = (text, other.rank.min(rank));
            }
            Some(other) => {
                other.text = setter.join(&other.text, &text);
                other.rank = other.rank.min(rank);
            }
            None => waiting.push(Waiting {
                text,
                anchor,
                toward: toward(viewport, mark, label),
                is_of_side: label.toward.is_some(),
                keeps_off_solids: matches!(mark.shape, Shape::Label(_)),
                rank,
            }),
        }
    }
    waiting
}

/// This step's labels choose first, those that can stand anywhere choose last.
const fn rank(label: &Label, anchor: &Anchor, role: Role) -> u8 {
    match anchor {
        Anchor::Inside(_) | Anchor::Within(_) => 3,
        Anchor::Point(..) | Anchor::Along(_) if matches!(role, Role::Signal) => 0,
        Anchor::Point(..) | Anchor::Along(_) if label.strong => 1,
        Anchor::Point(..) | Anchor::Along(_) => 2,
    }
}

/// What is said beside a point that has no mark is said of something larger.
fn is_same_point(a: &Anchor, b: &Anchor) -> bool {
    let (Anchor::Point(a, radius), Anchor::Point(b, other)) = (a, b) else {
        return false;
    };
    (*radius > 0.0) == (*other > 0.0) && a.distance(*b) < SAME_POINT
}

/// Names can be said to be of one thing; an equation cannot.
fn can_join(a: &Text, b: &Text) -> bool {
    let is_name = |text: &Text| !text.plain.contains([':', '<', '>']);
    a.plain == b.plain || (is_name(a) && is_name(b) && !b.plain.contains('='))
}

/// On the screen, where y points down.
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

/// The places of a label, the least costly first.
fn candidates(
    label: &Waiting,
    stage: Rect,
    obstacles: &[Obstacle],
    around: Around<'_>,
) -> Vec<Candidate> {
    let stood = around
        .before
        .iter()
        .filter(|it| it.text == label.text.plain);
    let middle = label.anchor.middle();
    let stood: Vec<Pos2> = stood
        .flat_map(|placed| [placed.rect.center(), middle + placed.offset])
        .collect();
    let size = label.text.size();
    let lean = Lean {
        toward: label.toward,
        is_of_side: label.is_of_side,
        away: away(&label.anchor, obstacles),
    };
    let places = places(&label.anchor, size, stage, lean);
    let centres: Vec<Pos2> = places.iter().map(|place| place.centre).collect();
    let reach = Rect::from_points(&centres).expand2(size);
    let nearby: Vec<&Obstacle> = obstacles
        .iter()
        .filter(|obstacle| obstacle.bounds().intersects(reach))
        .filter(|obstacle| label.keeps_off_solids || !obstacle.is_surface())
        .collect();
    let is_disc = |obstacle: &&&Obstacle| matches!(obstacle, Obstacle::Disc(..));
    let discs: Vec<Obstacle> = nearby.iter().filter(is_disc).map(|&&disc| disc).collect();
    let of_place = |place: LabelPlace| {
        let rect = Rect::from_center_size(place.centre, size);
        // Whole pixels keep the text crisp.
        let rect = rect.translate(rect.min.round() - rect.min);
        let near = rect.expand2(APART);
        let touching = nearby.iter().filter(|it| it.bounds().intersects(near));
        let covered: f32 = touching.map(|obstacle| obstacle.cost(rect)).sum();
        let is_free = |covered: &Rect| !covered.intersects(near);
        let is_seen = stage.shrink(3.0).contains_rect(rect) && around.covered.iter().all(is_free);
        let is_inside = match label.anchor {
            Anchor::Inside(region) => region.expand(0.5).contains_rect(rect.expand2(INSIDE)),
            Anchor::Point(..) | Anchor::Along(_) | Anchor::Within(_) => true,
        };
        let leader = place.leader.map(|from| [from, rect.clamp(from)]);
        let is_ambiguous = leader.is_none() && is_of_another(&label.anchor, &discs, rect);
        let stays = stood
            .iter()
            .any(|at| at.distance(rect.center()) < SAME_PLACE);
        Candidate {
            rect,
            leader,
            cost: place.dislike + covered + if is_ambiguous { AMBIGUOUS } else { 0.0 }
                - if stays { STAY } else { 0.0 }
                + if is_seen { 0.0 } else { UNSEEN }
                + if is_inside && !place.is_wrong {
                    0.0
                } else {
                    WRONG
                },
        }
    };
    let mut candidates: Vec<Candidate> = places.into_iter().map(of_place).collect();
    candidates.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    candidates
}

/// Would a label here seem to belong to another point's marker?
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
        Obstacle::Stroke(..) | Obstacle::Picture(_) | Obstacle::Surface(_) => false,
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
        Obstacle::Stroke(..) | Obstacle::Disc(..) | Obstacle::Picture(_) | Obstacle::Surface(_) => {
            None
        }
    });
    let towards: Vec2 = ending.fold(Vec2::ZERO, |sum, d| sum + d.normalized());
    (towards.length() > 0.3).then(|| -towards.normalized())
}
