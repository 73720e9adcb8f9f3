//! What the names stand for at a step.

use crate::algo::surface::{PlaneHit, Ray, RayCasting, RayCastingEvent as Event, RayHit};

use super::super::prelude::*;

pub fn named(at: &At<'_, RayCasting>, name: &str) -> Option<Named> {
    let (input, held, past) = (at.step.input, at.step.held, at.step.past);
    let event = at.step.event();
    let decimals = |x: f64| Formula::decimals().num(x);
    let n_rays = input.pixel.map_or(input.surfaces.n_pixels(), |_| 1);
    Some(match (name, event) {
        ("triangle", Some(Event::Ask { id, .. })) => triangle(at.scenery, id),
        ("triangle", _) => triangle(at.scenery, held.nearest?.id),
        ("seen", _) => held.nearest.map_or_else(
            || Value::Term("depth-nothing").into(),
            |hit| triangle(at.scenery, hit.id),
        ),
        ("other", _) => triangle(at.scenery, nearest_before(past)?.id),
        ("t", Some(Event::Ask { .. })) => decimals(nearest_before(past)?.t).into(),
        ("t", _) => decimals(held.nearest?.t).into(),
        ("at", _) => {
            let (pixel, _) = turn(past)?;
            let link = Link::nth(Raster::LINK, held.so_far.picture.place(pixel));
            Named::from(pixel_formula(pixel)).linked(link)
        }
        ("hidden", _) => {
            let hidden =
                hidden(at).map(|hit| text_of(name_of(at.scenery, hit.id), hit.id as usize));
            Value::Name(hidden.collect::<Vec<_>>().join(", ")).into()
        }
        // `t = 2.94 < 3.9 < 4.2`
        ("order", _) => {
            let nearest = held.nearest?;
            let mut times: Vec<f64> = hidden(at).map(|hit| hit.t).collect();
            times.sort_by(f64::total_cmp);
            let formula = Formula::decimals().sym("t = ").num(nearest.t);
            times
                .into_iter()
                .fold((formula, nearest.t), |(formula, before), t| {
                    let formula = formula.sym(format!(" {} ", sign(before, t)));
                    (formula.num(t), t)
                })
                .0
                .into()
        }
        ("hits", _) => hits(past).count().into(),
        // `t = −(n·o + d) / (n·r) = 3.012 / 1.025 = 2.94`
        ("quotient", Some(Event::Ask { found, .. })) => {
            let symbols = Formula::decimals().sym("t = −(n·o + d) / (n·r) = ");
            let formula = quotient(symbols, &found);
            match found.t {
                Some(t) => formula.equals(t).into(),
                None => formula.into(),
            }
        }
        ("rays", _) => n_rays.into(),
        ("questions", _) => {
            let n_triangles = input.surfaces.triangles().len();
            let product = decimals(n_rays as f64).sym(" · ").num(n_triangles as f64);
            product.equals(held.so_far.n_asked as f64).into()
        }
        _ => return watched(at, name),
    })
}

fn watched(at: &At<'_, RayCasting>, name: &str) -> Option<Named> {
    let (held, past) = (at.step.held, at.step.past);
    Some(match name {
        "watch-pixel" => Named::maybe(turn(past).map(|(pixel, _)| pixel_formula(pixel))),
        "r" => {
            let direction = turn(past).map(|(_, ray)| ray.direction);
            Named::maybe(direction.map(|direction| Formula::decimals().place(direction)))
        }
        "watch-hits" => hits(past).count().into(),
        "watch-nearest" => Named::maybe(held.nearest.map(|hit| name_of(at.scenery, hit.id))),
        "nearest t" => Named::maybe(held.nearest.map(|hit| Formula::decimals().num(hit.t)))
            .labelled(Value::Name("t".to_owned())),
        "watch-asked" => (held.so_far.n_asked as usize).into(),
        _ => return on_raster::named(&at.step.input.surfaces, at.scenery, name),
    })
}

pub fn listed(at: &At<'_, RayCasting>, list: &str) -> Vec<Named> {
    if list != "hits" {
        return Vec::new();
    }
    let hits = hits(at.step.past).map(|hit| triangle(at.scenery, hit.id));
    hits.chain([Value::Term("depth-nothing").into()]).collect()
}

/// `3.012 / 1.025`
pub fn quotient(formula: Formula, found: &PlaneHit) -> Formula {
    let formula = formula.num(-found.numerator).sym(" / ");
    formula.divisor(found.denominator)
}

fn of_turn(past: &[Event]) -> &[Event] {
    let is_turn = |event: &Event| matches!(event, Event::Pixel { .. });
    &past[past.iter().rposition(is_turn).unwrap_or(past.len())..]
}

pub fn turn(past: &[Event]) -> Option<([u32; 2], Ray)> {
    match *of_turn(past).first()? {
        Event::Pixel { pixel, ray } => Some((pixel, ray)),
        _ => None,
    }
}

pub fn asked(past: &[Event]) -> impl DoubleEndedIterator<Item = (u32, PlaneHit)> {
    of_turn(past).iter().filter_map(|event| match *event {
        Event::Ask { id, found, .. } => Some((id, found)),
        _ => None,
    })
}

pub fn hits(past: &[Event]) -> impl DoubleEndedIterator<Item = RayHit> {
    of_turn(past).iter().filter_map(hit_of)
}

fn hit_of(event: &Event) -> Option<RayHit> {
    let Event::Ask {
        id, found, depth, ..
    } = *event
    else {
        return None;
    };
    let (t, depth) = found.t.zip(depth)?;
    Some(RayHit { id, t, depth })
}

/// What the ray has met and does not reach.
fn hidden<'a>(at: &At<'a, RayCasting>) -> impl Iterator<Item = RayHit> + use<'a> {
    let nearest = at.step.held.nearest.map(|hit| hit.id);
    hits(at.step.past).filter(move |hit| Some(hit.id) != nearest)
}

pub fn nearest_before(past: &[Event]) -> Option<RayHit> {
    let [before @ .., _] = past else {
        return None;
    };
    let asked = before.iter().rev();
    let mut asked = asked.take_while(|event| matches!(event, Event::Ask { .. }));
    let nearest = asked.find(|event| matches!(event, Event::Ask { nearest: true, .. }))?;
    hit_of(nearest)
}
