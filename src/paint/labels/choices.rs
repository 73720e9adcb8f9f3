//! The places of a label, the cheapest first. What a place covers is looked at only once no other can be cheaper.

use std::{cmp::Reverse, collections::BinaryHeap};

use egui::{Pos2, Rect, emath::OrderedFloat};

use super::{
    anchor::Anchor,
    obstacles::Obstacle,
    places::{LabelPlace, Lean, places},
    seat::{APART, Around, Candidate, Seat, away, is_of_another},
    text::INSIDE,
};

const UNSEEN: f32 = 1_000.0;
const WRONG: f32 = 100_000.0;
/// What costs as much is wrong, cut off, or over another.
pub const UNFIT: f32 = UNSEEN;
/// What it costs to stand nearer to another point's marker than to its own: it would seem to be that one's name.
const AMBIGUOUS: f32 = 60.0;
/// How much better than the place that it had another has to be: no label hops for the sake of a neighbour's.
const STAY: f32 = 40.0;
const SAME_PLACE: f32 = 2.0;
/// A chip lies on what it is about, and may lie on a line or two more: they count so much.
const UNDER_A_CHIP: f32 = 0.3;

/// A place, with what is known of it before one looks at what it covers.
struct Place {
    rect: Rect,
    leader: Option<[Pos2; 2]>,
    dislike: f32,
    stays: f32,
    unseen: f32,
    wrong: f32,
    /// Once it has been looked at.
    cost: Option<f32>,
}

pub struct Choices<'a> {
    seat: &'a Seat,
    nearby: Vec<(Rect, Obstacle)>,
    discs: Vec<Obstacle>,
    places: Vec<Place>,
    /// What each costs, or costs at least: the cheapest comes first, and of equal ones the first.
    waiting: BinaryHeap<Reverse<(OrderedFloat<f32>, usize)>>,
    /// The cheapest first: none of those that wait costs less.
    sorted: Vec<Candidate>,
}

impl<'a> Choices<'a> {
    pub fn new(
        seat: &'a Seat,
        stage: Rect,
        obstacles: &[(Rect, Obstacle)],
        around: Around<'_>,
    ) -> Self {
        let lean = Lean {
            toward: seat.toward,
            is_of_side: seat.is_of_side,
            is_on: seat.is_chip,
            away: away(&seat.anchor, obstacles),
        };
        let all = places(&seat.anchor, seat.size, stage, lean);
        let centres: Vec<Pos2> = all.iter().map(|place| place.centre).collect();
        let reach = Rect::from_points(&centres).expand2(seat.size);
        let nearby = obstacles.iter().filter(|(bounds, it)| {
            bounds.intersects(reach) && (seat.keeps_off_solids || !it.is_surface())
        });
        let nearby: Vec<(Rect, Obstacle)> = nearby.copied().collect();
        let discs = nearby.iter().map(|(_, obstacle)| *obstacle);
        let discs = discs.filter(|it| matches!(it, Obstacle::Disc(..)));
        let places: Vec<Place> = all.iter().map(Place::of(seat, stage, around)).collect();
        let least = places.iter().map(|place| place.cost_with(0.0, 0.0));
        let waiting = least.enumerate();
        let waiting = waiting.map(|(nth, least)| Reverse((OrderedFloat(least), nth)));
        Self {
            seat,
            discs: discs.collect(),
            nearby,
            waiting: waiting.collect(),
            places,
            sorted: Vec::new(),
        }
    }

    /// The place that comes after `n` cheaper ones.
    pub fn nth(&mut self, n: usize) -> Option<Candidate> {
        while self.sorted.len() <= n {
            let next = self.cheapest()?;
            self.sorted.push(next);
        }
        self.sorted.get(n).copied()
    }

    /// The cheapest of the places that wait.
    fn cheapest(&mut self) -> Option<Candidate> {
        // Each place is taken out twice at most.
        loop {
            let Reverse((_, nth)) = self.waiting.pop()?;
            let place = &self.places[nth];
            if let Some(cost) = place.cost {
                let (rect, leader) = (place.rect, place.leader);
                return Some(Candidate { rect, leader, cost });
            }
            let cost = self.cost_of(place);
            self.places[nth].cost = Some(cost);
            self.waiting.push(Reverse((OrderedFloat(cost), nth)));
        }
    }

    fn cost_of(&self, place: &Place) -> f32 {
        let rect = place.rect;
        let near = rect.expand2(APART);
        let touching = self.nearby.iter();
        let touching = touching.filter(|(bounds, _)| bounds.intersects(near));
        let covered: f32 = touching.map(|(_, obstacle)| obstacle.cost(rect)).sum();
        let covered = covered * if self.seat.is_chip { UNDER_A_CHIP } else { 1.0 };
        let is_ambiguous =
            place.leader.is_none() && is_of_another(&self.seat.anchor, &self.discs, rect);
        place.cost_with(covered, if_so(is_ambiguous, AMBIGUOUS))
    }
}

impl Place {
    fn of(seat: &Seat, stage: Rect, around: Around<'_>) -> impl Fn(&LabelPlace) -> Self {
        let middle = seat.anchor.middle();
        let stood = around.before.iter();
        let stood = stood.filter(|it| it.text == seat.plain);
        let stood = stood.flat_map(|it| [it.rect.center(), middle + it.offset]);
        let stood: Vec<Pos2> = stood.collect();
        move |place| {
            let rect = Rect::from_center_size(place.centre, seat.size);
            // Whole pixels keep the text crisp.
            let rect = rect.translate(rect.min.round() - rect.min);
            let near = rect.expand2(APART);
            let is_free = |covered: &Rect| !covered.intersects(near);
            let is_seen =
                stage.shrink(3.0).contains_rect(rect) && around.covered.iter().all(is_free);
            let is_inside = match seat.anchor {
                Anchor::Inside(region) => region.expand(0.5).contains_rect(rect.expand2(INSIDE)),
                _ => true,
            };
            let is_there = |at: &Pos2| at.distance(rect.center()) < SAME_PLACE;
            Self {
                rect,
                leader: place.leader.map(|from| [from, rect.clamp(from)]),
                dislike: place.dislike,
                stays: if_so(stood.iter().any(is_there), STAY),
                unseen: if_so(!is_seen, UNSEEN),
                wrong: if_so(!is_inside || place.is_wrong, WRONG),
                cost: None,
            }
        }
    }

    /// Never less than where nothing is covered: what is added is not below zero, and rounding keeps the order.
    fn cost_with(&self, covered: f32, ambiguous: f32) -> f32 {
        self.dislike + covered + ambiguous - self.stays + self.unseen + self.wrong
    }
}

const fn if_so(is_so: bool, cost: f32) -> f32 {
    if is_so { cost } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use egui::{pos2, vec2};

    use super::*;

    #[test]
    fn all_places_come_the_cheapest_first_and_equal_ones_in_their_order() {
        let at = pos2(100.0, 100.0);
        let seat = Seat {
            anchor: Anchor::Point(at, 4.0),
            size: vec2(40.0, 14.0),
            plain: "P₁".to_owned(),
            toward: Some(vec2(1.0, 0.2)),
            is_of_side: false,
            keeps_off_solids: false,
            is_chip: false,
        };
        let obstacles = [
            Obstacle::Stroke([pos2(80.0, 110.0), pos2(150.0, 90.0)], 1.0),
            Obstacle::Disc(pos2(130.0, 120.0), 4.0),
            Obstacle::Picture([pos2(60.0, 60.0), pos2(110.0, 60.0), pos2(60.0, 95.0)]),
        ];
        let obstacles = obstacles.map(|it| (it.bounds(), it));
        let stage = Rect::from_min_max(pos2(20.0, 20.0), pos2(180.0, 140.0));
        let choices = || Choices::new(&seat, stage, &obstacles, Around::default());
        let eager = choices();
        let costs = eager.places.iter().map(|place| eager.cost_of(place));
        let mut costs: Vec<(f32, Rect)> =
            costs.zip(eager.places.iter().map(|it| it.rect)).collect();
        costs.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let mut lazy = choices();
        for (n, (cost, rect)) in costs.iter().enumerate() {
            let place = lazy.nth(n).expect("as many as there are");
            assert_eq!((place.cost, place.rect), (*cost, *rect), "the place {n}");
        }
        assert!(lazy.nth(costs.len()).is_none());
        let mut first = choices();
        first.nth(0);
        let n_looked_at = first.places.iter().filter(|it| it.cost.is_some()).count();
        assert!(
            n_looked_at < costs.len() / 2,
            "{n_looked_at} were looked at"
        );
    }
}
