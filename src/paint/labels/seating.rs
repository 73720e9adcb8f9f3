//! Labels that take their places one after the other, and then each again, now that the others stand.

use egui::{Pos2, Rect, Vec2, vec2};

use crate::paint::cut::length_in;

const ROUNDS: usize = 3;
pub const APART: Vec2 = vec2(5.0, 2.0);

/// A candidate, and what it costs whatever the other labels do.
#[derive(Clone, Copy)]
pub struct Candidate {
    pub rect: Rect,
    pub leader: Option<[Pos2; 2]>,
    pub cost: f32,
}

pub struct Seating {
    pub stage: Rect,
    pub places: Vec<Vec<Candidate>>,
    pub taken: Vec<Candidate>,
}

impl Seating {
    pub fn fill(&mut self) {
        for i in 0..self.places.len() {
            let place = self.best(i);
            self.taken.push(place);
        }
        for _ in 0..ROUNDS {
            for i in 0..self.places.len() {
                self.taken[i] = self.best(i);
            }
        }
    }

    /// The place of one more, for whom nobody makes room.
    pub fn seat(&mut self, places: Vec<Candidate>) -> Candidate {
        self.places.push(places);
        let place = self.best(self.places.len() - 1);
        self.taken.push(place);
        place
    }

    fn best(&self, label: usize) -> Candidate {
        let mut best = Candidate {
            rect: Rect::from_center_size(self.stage.center(), Vec2::ZERO),
            leader: None,
            cost: f32::INFINITY,
        };
        for candidate in &self.places[label] {
            // All that follow cost more by themselves.
            if candidate.cost >= best.cost {
                break;
            }
            let others = self.taken.iter().enumerate().filter(|(i, _)| *i != label);
            let cost: f32 = others.map(|(_, other)| between(candidate, other)).sum();
            let cost = candidate.cost + cost;
            if cost < best.cost {
                best = Candidate { cost, ..*candidate };
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
