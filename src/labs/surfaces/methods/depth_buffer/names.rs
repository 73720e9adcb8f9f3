//! What the names stand for at a step.

use crate::{
    algo::surface::{DepthBuffer, DepthBufferEvent as Event, Fragment, FragmentTally},
    labs::space::Tones,
};

use super::super::{
    glass::{blended, unsorted},
    prelude::*,
};

use super::{
    numbers::{t_of, value},
    variant::{COMPARE, Variant},
};

fn average(fragments: u64, pixels: u64) -> Formula {
    let [all, pixels] = [fragments, pixels].map(|n| n as f64);
    let formula = Formula::decimals().num(all).sym(" / ").num(pixels);
    formula.equals(all / pixels)
}

pub fn named<L: Variant>(at: &At<'_, DepthBuffer<L>>, name: &str) -> Option<Named> {
    let (input, so_far) = (at.step.input, &at.step.held.so_far);
    let (tally, fragment) = (so_far.tally, fragment_of(at));
    let count = |n: u64| Named::from(n as usize);
    let stored = |depth: f64| value(&input.format, depth);
    let n_bits = input.format.number.n_bits() as usize;
    Some(match (name, at.step.event()) {
        ("triangle", _) => triangle(at.scenery, current(at)?),
        ("other", _) => u32::try_from(fragment?.stored_id).map_or_else(
            |_| Value::Term("depth-nothing").into(),
            |id| triangle(at.scenery, id),
        ),
        ("at", _) => {
            let pixel = fragment?.pixel;
            let link = Link::nth(Raster::LINK, so_far.picture.place(pixel));
            Named::from(pixel_formula(pixel)).linked(link)
        }
        ("z", _) => Named::maybe(fragment.map(|fragment| stored(fragment.new))),
        ("sign", _) => spaced(sign(fragment?.new, fragment?.stored)),
        ("stored", _) => Named::maybe(fragment.map(|fragment| stored(fragment.stored)))
            .labelled(Value::Term("story-stored")),
        ("blend", _) => blended(&input.surfaces, &fragment?)?.into(),
        ("C", _) => {
            let place = so_far.picture.place(pixel_of(at)?);
            Formula::decimals()
                .num(*so_far.brightness.get(place)?)
                .into()
        }
        ("through", _) => {
            let there = u32::try_from(fragment?.stored_id).ok()?;
            let opacity = input.surfaces.tint(there)?.opacity();
            Formula::decimals().num(1.0 - opacity).into()
        }
        ("unsorted", _) => unsorted(&input.surfaces, &so_far.brightness).len().into(),
        ("cleared", Some(Event::Clear { depth })) => stored(depth).into(),
        ("place", _) => {
            let id = current(at)?;
            (input.order.iter().position(|&other| other == id)? + 1).into()
        }
        ("triangles", _) => input.order.len().into(),
        ("row", Some(Event::Span { row, .. })) => (row as usize).into(),
        ("first", Some(Event::Span { columns, .. })) => (columns[0] as usize).into(),
        ("last", Some(Event::Span { columns, .. })) => {
            (columns[1].saturating_sub(1) as usize).into()
        }
        ("fragments", Some(Event::Done)) => count(tally.fragments),
        ("writes", Some(Event::Done)) => count(tally.writes),
        ("pixels", Some(Event::Done)) => in_shades(at)
            .map_or(tally.pixels as usize, |shades| shades.n_pixels)
            .into(),
        ("fragments", _) => count(tally.fragments - before(at.step.past).fragments),
        ("writes", _) => count(tally.writes - before(at.step.past).writes),
        ("least", _) => in_shades(at)?.range[0].clone().into(),
        ("most", _) => in_shades(at)?.range[1].clone().into(),
        ("average", _) => average(tally.fragments, tally.pixels).into(),
        ("bits", _) => n_bits.into(),
        ("bytes", _) => (input.surfaces.n_pixels() * n_bits).div_ceil(8).into(),
        _ => return watched(at, name),
    })
}

fn watched<L: Variant>(at: &At<'_, DepthBuffer<L>>, name: &str) -> Option<Named> {
    let tally = at.step.held.so_far.tally;
    let count = |n: u64| Named::from(n as usize);
    Some(match name {
        "watch-triangle" => Named::maybe(current(at).map(|id| name_of(at.scenery, id))),
        "watch-pixel" => Named::maybe(pixel_of(at).map(pixel_formula)),
        "watch-fragments" => count(tally.fragments),
        "watch-writes" => count(tally.writes),
        "watch-pixels" => count(tally.pixels),
        _ => return on_raster::named(&at.step.input.surfaces, at.scenery, name),
    })
}

pub fn current<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> Option<u32> {
    match at.step.event()? {
        Event::Triangle { id, .. } | Event::Span { id, .. } => Some(id),
        Event::Fragment { fragment, .. } => Some(fragment.id),
        Event::Clear { .. } | Event::Done => None,
    }
}

pub fn fragment_of<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> Option<Fragment> {
    match at.step.event()? {
        Event::Fragment { fragment, .. } => Some(fragment),
        _ => None,
    }
}

pub fn pixel_of<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> Option<[u32; 2]> {
    let input = at.step.input;
    let [width, height] = input.surfaces.size();
    let pixel = fragment_of(at).map(|fragment| fragment.pixel);
    let pixel = pixel.or(input.pixel);
    pixel.filter(|&[column, row]| column < width && row < height)
}

fn before(past: &[Event]) -> FragmentTally {
    match past.iter().nth_back(1) {
        Some(
            Event::Triangle { tally, .. }
            | Event::Span { tally, .. }
            | Event::Fragment { tally, .. },
        ) => *tally,
        Some(Event::Clear { .. } | Event::Done) | None => FragmentTally::default(),
    }
}

/// The row of a step that is said in another way where light comes through.
pub fn of_glass<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> Option<&'static Row> {
    const BEHIND: Row = Row::new(Test, COMPARE, "depth-glass-behind")
        .so(&["{z}{sign}{stored}"])
        .about("at")
        .answers_as("nearer", "depth-fragment-lost");
    const DONE: Row = Row::new(Accept, COMPARE, "depth-glass-done").so(&["{average}"]);
    let surfaces = &at.step.input.surfaces;
    match at.step.event()? {
        Event::Fragment { fragment, .. } if !fragment.kept && fragment.new != fragment.stored => {
            let there = surfaces.tint(u32::try_from(fragment.stored_id).ok()?)?;
            (there.opacity() < 1.0).then_some(&BEHIND)
        }
        Event::Done if surfaces.is_tinted() && at.step.input.pixel.is_none() => Some(&DONE),
        Event::Clear { .. }
        | Event::Triangle { .. }
        | Event::Span { .. }
        | Event::Fragment { .. }
        | Event::Done => None,
    }
}

pub struct InShades {
    pub row: &'static Row,
    /// So many of its pixels have a depth.
    n_pixels: usize,
    /// Which part of their scale the shades need: the least and the most of what they tell.
    range: [Value; 2],
}

pub fn in_shades<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> Option<InShades> {
    const STORED: Row = Row::new(Accept, COMPARE, "depth-done-stored");
    const DISTANCE: Row = Row::new(Accept, COMPARE, "depth-done-distance");
    if at.step.event() != Some(Event::Done) {
        return None;
    }
    let (input, plan) = (at.step.input, &at.scenery?.scene().raster);
    if !plan.is_toned_alone() {
        return None;
    }
    let rays = Rays::of(&input.surfaces);
    let depths = at.step.held.so_far.depth.iter().copied();
    let finite = depths.filter(|depth| depth.is_finite());
    let distance = |stored| rays.distance(t_of::<L>(&rays, input.format.turned(stored)));
    let tells_distance = plan.tones == Tones::Distance;
    let (row, values): (_, Vec<f64>) = if tells_distance {
        (&DISTANCE, finite.map(distance).collect())
    } else {
        (&STORED, finite.collect())
    };
    let least = values.iter().copied().reduce(f64::min)?;
    let most = values.iter().copied().reduce(f64::max)?;
    let said = |number: f64| {
        if tells_distance {
            Formula::decimals().num(number).into()
        } else {
            value(&input.format, number)
        }
    };
    Some(InShades {
        row,
        n_pixels: values.len(),
        range: [least, most].map(said),
    })
}
