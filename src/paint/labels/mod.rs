//! Places for labels. They are placed one by one, this step's first, and then each again, now that the others stand: where
//! distance and what it covers cost least. In a window a label would rather stay; in a figure there is no before.

mod anchor;
mod chips;
mod choices;
mod obstacles;
mod places;
mod seat;
mod seating;
mod text;

use egui::{Painter, Rect, Vec2, vec2};

use crate::figure::{Chip, Label, Link, Mark, Role, Shape};

use super::{Look, Theme, Viewport, layers::LayeredPart};

use self::{
    anchor::Anchor,
    choices::{Choices, UNFIT},
    obstacles::obstacles,
    seat::{Candidate, SAME_POINT, Seat},
    seating::Seating,
    text::{Setter, Text},
};

pub use self::{
    obstacles::Obstacle,
    seat::{Around, Placed},
};

/// Of a drawing whose smaller side has so many points labels are as large as at scale 1; of larger ones larger.
const ROOMY: f32 = 250.0;
/// More labels than this would cover the figure, and finding places for them would take longer than a frame.
const MOST_LABELS: usize = 160;
const PLATE: Vec2 = vec2(3.0, 1.0);
/// What costs more covers a label: the chip is left out.
const MOST_OF_A_CHIP: f32 = 340.0;

pub struct Labels {
    texts: Vec<Text>,
    /// The labels, then the chips.
    pub placed: Vec<Placed>,
    pub chips: Vec<Chip>,
    pub obstacles: Vec<Obstacle>,
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
        let bounded = obstacles.iter().map(|it| (it.bounds(), *it));
        let bounded: Vec<(Rect, Obstacle)> = bounded.collect();
        let seats = waiting.iter().map(|it| &it.seat);
        let choices = seats.map(|seat| Choices::new(seat, stage, &bounded, around));
        let mut table = Seating::filled(stage, choices.collect());
        // After all labels, which stay where they are.
        let chips = chips::anchored(viewport, look, marks).into_iter();
        let seated = chips.map(|(chip, anchor)| {
            let seat = Seat::of_chip(chip, anchor, look.theme);
            let place = table.seat(&mut Choices::new(&seat, stage, &bounded, around));
            (chip, seat, place)
        });
        let seated = seated.filter(|(.., place)| place.cost < MOST_OF_A_CHIP);
        let seated: Vec<(Chip, Seat, Candidate)> = seated.collect();
        let places = waiting.into_iter().zip(table.taken);
        // What has a place only where it would be wrong, cut off, or over another is better not said.
        let places = places.filter(|(_, place)| place.cost < UNFIT);
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
