//! Labels that take their places one after the other, and then each again, now that the others stand.

use egui::{Pos2, Rect, Vec2};

use crate::paint::cut::length_in;

use super::{
    choices::Choices,
    seat::{APART, Candidate},
};

const ROUNDS: usize = 3;

pub struct Seating {
    stage: Rect,
    pub taken: Vec<Candidate>,
}

impl Seating {
    pub fn filled(stage: Rect, mut labels: Vec<Choices<'_>>) -> Self {
        let mut table = Self {
            stage,
            taken: Vec::new(),
        };
        for choices in &mut labels {
            table.seat(choices);
        }
        for _ in 0..ROUNDS {
            for (i, choices) in labels.iter_mut().enumerate() {
                table.taken[i] = table.best(choices, Some(i));
            }
        }
        table
    }

    /// The place of one more, for whom nobody makes room.
    pub fn seat(&mut self, choices: &mut Choices<'_>) -> Candidate {
        let place = self.best(choices, None);
        self.taken.push(place);
        place
    }

    /// The best place among all that are taken, but for the label's own.
    fn best(&self, choices: &mut Choices<'_>, own: Option<usize>) -> Candidate {
        let mut best = Candidate {
            rect: Rect::from_center_size(self.stage.center(), Vec2::ZERO),
            leader: None,
            cost: f32::INFINITY,
        };
        for n in 0.. {
            // All that follow cost more by themselves.
            let Some(candidate) = choices.nth(n).filter(|it| it.cost < best.cost) else {
                break;
            };
            let others = self.taken.iter().enumerate();
            let others = others.filter(|(i, _)| Some(*i) != own);
            let cost: f32 = others.map(|(_, other)| between(&candidate, other)).sum();
            let cost = candidate.cost + cost;
            if cost < best.cost {
                best = Candidate { cost, ..candidate };
            }
        }
        best
    }
}

fn between(a: &Candidate, b: &Candidate) -> f32 {
    let apart = a.rect.expand2(APART);
    let overlap = if apart.intersects(b.rect) {
        400.0 + apart.intersect(b.rect).area()
    } else {
        0.0
    };
    let struck = |leader: Option<[Pos2; 2]>, rect: Rect| {
        leader.is_some_and(|ends| length_in(ends, rect.expand(2.0)) > 0.0)
    };
    let is_struck = struck(a.leader, b.rect) || struck(b.leader, a.rect);
    overlap + if is_struck { 200.0 } else { 0.0 }
}
