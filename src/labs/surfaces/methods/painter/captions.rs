//! What is said at each step.

use crate::{
    algo::surface::{PainterEvent as Event, PainterState as State, PairTest, Surfaces},
    figure::Caption,
    labs::{space::OnSceneInput, surfaces::methods::on_raster::name_of},
    text::{Formula, Message},
};

pub type Input = OnSceneInput<Surfaces>;

pub fn caption(event: &Event, before: &State, input: &Input) -> Caption {
    let named = |key, id| Message::new(key).with("triangle", name_of(input, id));
    match *event {
        Event::Key { id, key, depths } => {
            let range = Formula::decimals().num(depths[0]).sym(" … ").num(depths[1]);
            let message = named("painter-key", id);
            Caption::new(message.with("key", Formula::decimals().num(key))).so(range)
        }
        Event::Sort { id } => {
            let place = before.sorted.len() + 1;
            let message = named("painter-sort", id).with("place", place);
            Caption::new(message).so(key_formula(before, id))
        }
        Event::Pair {
            id,
            other,
            test,
            may,
            ..
        } => pair(before, input, [id, other], (test, may)),
        Event::Constraint {
            before: first,
            after,
        } => {
            let message = Message::new("painter-constraint")
                .with("before", name_of(input, first))
                .with("after", name_of(input, after));
            Caption::new(message)
        }
        Event::Place { id } => {
            let message = named("painter-place", id).with("place", before.placed.len() + 1);
            Caption::new(message.with("triangles", before.sorted.len()))
        }
        Event::Cycle { id } => match before.cycle.last() {
            None => Caption::new(named("painter-cycle-first", id)),
            Some(&last) => {
                let first = before.cycle[0];
                let is_closed = before.constraints.contains(&[id, first]);
                let key = if is_closed {
                    "painter-cycle-closes"
                } else {
                    "painter-cycle-next"
                };
                let message = named(key, id).with("before", name_of(input, last));
                Caption::new(message.with("first", name_of(input, first)))
            }
        },
        Event::Paint { id } => {
            let place = before.placed.iter().position(|&placed| placed == id);
            let message = named("painter-paint", id);
            let message = message.with("place", place.unwrap_or_default() + 1);
            Caption::new(message.with("triangles", before.placed.len()))
        }
        Event::Done => {
            let key = if before.cycle.is_empty() {
                "painter-done"
            } else {
                "painter-done-cycle"
            };
            let message = Message::new(key)
                .with("pairs", before.tally.pairs as usize)
                .with("triangles", before.sorted.len())
                .with("cycle", before.cycle.len());
            Caption::new(message)
        }
    }
}

fn key_formula(state: &State, id: u32) -> Formula {
    let key = state.keys.iter().find(|(of, ..)| *of == id);
    let formula = Formula::decimals().sym("z = ");
    key.map_or_else(Formula::decimals, |(_, key, _)| formula.num(*key))
}

/// The test that decided, with the depths that it may have compared.
fn pair(
    state: &State,
    input: &Input,
    [id, other]: [u32; 2],
    (test, may): (PairTest, bool),
) -> Caption {
    let key = match (test, may) {
        (PairTest::DepthExtents, _) => "painter-pair-depths",
        (PairTest::ScreenExtents, _) => "painter-pair-screen",
        (PairTest::BehindPlane, _) => "painter-pair-behind",
        (PairTest::BeforePlane, _) => "painter-pair-before",
        (PairTest::Overlap, true) => "painter-pair-overlap",
        (PairTest::Overlap, false) => "painter-pair-hides",
    };
    let message = Message::new(key)
        .with("triangle", name_of(input, id))
        .with("other", name_of(input, other));
    let caption = Caption::new(message);
    let depths_of = |id: u32| state.keys.iter().find(|(of, ..)| *of == id).map(|it| it.2);
    let (Some([nearest, _]), Some([_, farthest])) = (depths_of(id), depths_of(other)) else {
        return caption;
    };
    let sign = match nearest.total_cmp(&farthest) {
        std::cmp::Ordering::Less => " < ",
        std::cmp::Ordering::Equal => " = ",
        std::cmp::Ordering::Greater => " > ",
    };
    caption.so(Formula::decimals().num(nearest).sym(sign).num(farthest))
}
