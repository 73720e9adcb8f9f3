//! What is said at each step.

use glam::DVec3;

use crate::{
    algo::{
        surface::{PainterEvent as Event, PainterState as State, PairTest, Surfaces},
        volume::signed_distance,
    },
    figure::Caption,
    labs::{
        space::OnSceneInput,
        surfaces::methods::on_raster::{name_of, plane_of},
    },
    text::{Formula, Message},
};

use super::overlap::overlap;

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
        Event::Cycle { id } => cycle(before, input, id),
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

/// One more of a cycle; the last of it comes before the first.
fn cycle(before: &State, input: &Input, id: u32) -> Caption {
    let named = |key| Message::new(key).with("triangle", name_of(input, id));
    let (Some(&first), Some(&last)) = (before.cycle.first(), before.cycle.last()) else {
        return Caption::new(named("painter-cycle-first"));
    };
    let key = if before.constraints.contains(&[id, first]) {
        "painter-cycle-closes"
    } else {
        "painter-cycle-next"
    };
    let message = named(key).with("before", name_of(input, last));
    Caption::new(message.with("first", name_of(input, first)))
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
    let formula = match test {
        PairTest::BehindPlane => distances(&input.own, id, other),
        PairTest::BeforePlane => distances(&input.own, other, id),
        PairTest::Overlap if !may => at_overlap(input, [other, id]),
        PairTest::DepthExtents | PairTest::ScreenExtents | PairTest::Overlap => {
            extents(state, [id, other])
        }
    };
    formula.into_iter().fold(caption, Caption::so)
}

/// How far the corners of a triangle lie before the plane of another one, on whose near side the eye is.
fn distances(surfaces: &Surfaces, of: u32, plane: u32) -> Option<Formula> {
    let triangle = surfaces.triangles().get(of as usize)?;
    let plane = plane_of(surfaces, plane)?;
    let [x, y, z, w] = surfaces.eye();
    let eye = DVec3::from(plane.normal()).dot(DVec3::new(x, y, z)) + plane.d() * w;
    let sign = if eye < 0.0 { -1.0 } else { 1.0 };
    let distances = triangle.map(|at| sign * signed_distance::<f64>(&plane, at));
    Some(Formula::decimals().sym("d = ").list(&distances))
}

/// How far both are where the second hides the first.
fn at_overlap(input: &Input, ends: [u32; 2]) -> Option<Formula> {
    let [far_depth, near_depth] = overlap(&input.own, ends)?.depths;
    let formula = Formula::decimals().num(near_depth).sym(" < ");
    Some(formula.num(far_depth))
}

/// The nearest of P beside the farthest of Q.
fn extents(state: &State, [id, other]: [u32; 2]) -> Option<Formula> {
    let depths_of = |id: u32| state.keys.iter().find(|(of, ..)| *of == id).map(|it| it.2);
    let ([nearest, _], [_, farthest]) = (depths_of(id)?, depths_of(other)?);
    let sign = match nearest.total_cmp(&farthest) {
        std::cmp::Ordering::Less => " < ",
        std::cmp::Ordering::Equal => " = ",
        std::cmp::Ordering::Greater => " > ",
    };
    Some(Formula::decimals().num(nearest).sym(sign).num(farthest))
}
