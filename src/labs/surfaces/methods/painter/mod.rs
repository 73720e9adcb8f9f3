//! Painter's algorithm, shown: the sorted list, who objects to whom, the order or the cycle, the picture growing.

mod graph;
mod names;
mod questions;
mod variant;
mod views;

use crate::algo::surface::{
    Painter, PainterEvent as Event, PainterOutput,
    PairTest::{BeforePlane, BehindPlane, DepthExtents, Overlap, ScreenExtents},
};

use super::prelude::*;

use variant::{ASK, CYCLE, KEY, OBJECT, PAINT, PLACE, SORT, Variant};

impl AnswerAsItIs for PainterOutput {}

impl<L: Variant> SpaceTelling for Painter<L> {
    const SUBJECT: Subject = Subject::Surfaces;

    fn shown(step: &Step<'_, Self>, place: usize) -> Option<i32> {
        step.held.picture.ids().get(place).copied()
    }

    /// Pairs grow with the square: a longer run cannot be followed.
    const MOST_FACES: usize = 300;

    fn input(scene: &Scene) -> Surfaces {
        surfaces_on_raster(scene)
    }
}

const EXTENTS: &[&str] = &["~ {nearest}{sign}{farthest}"];

const fn may(key: &'static str) -> Row {
    Row::new(Test, ASK, key).answers("may").keeps("triangle")
}

const fn in_cycle(key: &'static str) -> Row {
    Row::new(Reject, CYCLE, key).about("triangle")
}

impl<L: Variant> Telling for Painter<L> {
    type Scenery = Scenery;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Newell, Newell & Sancha, 1972";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "watch-pairs",
        "watch-depth-extents",
        "watch-screen-extents",
        "watch-behind-plane",
        "watch-before-plane",
        "watch-overlap",
        "C",
    ])];
    const OPENING: Row = Row::new(Phase, KEY, "painter-opening");

    table! { |event, step|
        key: Event::Key { .. } =>
            Row::new(Phase, KEY, "painter-key").so(&["~ {nearest} … {farthest}"]).about("triangle");
        sort: Event::Sort { .. } => Row::new(Phase, SORT, "painter-sort")
            .so(&["~ z = {z}"]).about("triangle").picks("triangle", "unsorted");
        depths: Event::Pair { test: DepthExtents, .. } => may("painter-pair-depths").so(EXTENTS);
        screen: Event::Pair { test: ScreenExtents, .. } => may("painter-pair-screen").so(EXTENTS);
        behind: Event::Pair { test: BehindPlane, .. } => may("painter-pair-behind").so(&["{behind}"]);
        front: Event::Pair { test: BeforePlane, .. } => may("painter-pair-before").so(&["{front}"]);
        nowhere: Event::Pair { test: Overlap, may: true, .. } =>
            may("painter-pair-overlap").so(EXTENTS);
        hides: Event::Pair { test: Overlap, may: false, .. } =>
            Row::new(Test, OBJECT, "painter-pair-hides")
                .so(&["{hidden}"]).answers("may").drops("triangle");
        constraint: Event::Constraint { .. } => Row::new(Cut, OBJECT, "painter-constraint");
        place: Event::Place { .. } => Row::new(Accept, PLACE, "painter-place").about("triangle");
        cycle_first: Event::Cycle { .. } if step.held.cycle.len() == 1 =>
            in_cycle("painter-cycle-first");
        cycle_closes: Event::Cycle { id } if step.held.constraints.contains(&[id, step.held.cycle[0]]) =>
            in_cycle("painter-cycle-closes");
        cycle_next: Event::Cycle { .. } => in_cycle("painter-cycle-next");
        paint: Event::Paint { .. } => Row::new(Cut, PAINT, "painter-paint")
            .so(&["{blend}"]).about("triangle");
        done: Event::Done if step.held.cycle.is_empty() => Row::new(Accept, PAINT, "painter-done");
        no_order: Event::Done => Row::new(Accept, CYCLE, "painter-done-cycle");
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        names::named(at, name)
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        let held = at.step.held;
        let unsorted = match list {
            "unsorted" => &held.list[held.n_sorted.saturating_sub(1)..],
            _ => &[],
        };
        let named = unsorted.iter().map(|(it, _)| triangle(at.scenery, it.id));
        named.collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        views::views(at)
    }
}
