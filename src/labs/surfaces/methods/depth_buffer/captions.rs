//! What is said at each step.

use crate::{
    algo::surface::{
        DepthBufferEvent as Event, DepthBufferInput, DepthBufferState as State, DepthSteps,
        Fragment, FragmentTally, Rays,
    },
    figure::Caption,
    labs::{
        space::{OnSceneInput, Tones},
        surfaces::methods::on_raster::name_of,
        words::pixel_formula,
    },
    text::{Formula, Message, Value},
};

use super::{
    numbers::{comparison, depth, t_of},
    variant::Variant,
};

pub type Input = OnSceneInput<DepthBufferInput>;

pub fn opening(input: &Input) -> Caption {
    let [columns, rows] = input.own.surfaces.size().map(|side| side as usize);
    let bits = input.own.format.number.n_bits() as usize;
    let message = Message::new("depth-opening")
        .with("bits", bits)
        .with("bytes", (columns * rows * bits).div_ceil(8))
        .with("triangles", input.own.order.len())
        .with("columns", columns)
        .with("rows", rows)
        .with("pixels", columns * rows);
    Caption::new(message)
}

pub fn caption<L: Variant>(event: &Event, before: &State, input: &Input) -> Caption {
    let own = &input.own;
    let named = |key, id| Message::new(key).with("triangle", name_of(input, id));
    match *event {
        Event::Clear { depth: to } => {
            let pixels = Message::new("depth-clear").with("pixels", own.surfaces.n_pixels());
            Caption::new(pixels).so(depth(Formula::decimals().sym("z = "), &own.format, to))
        }
        Event::Triangle {
            id, drawn: false, ..
        } => Caption::new(named("depth-triangle-unseen", id)),
        Event::Triangle { id, tally, .. } => match own.steps {
            DepthSteps::Fragments | DepthSteps::Spans => {
                let place = own.order.iter().position(|&other| other == id);
                let message = named("depth-triangle", id)
                    .with("place", place.unwrap_or_default() + 1)
                    .with("triangles", own.order.len());
                Caption::new(message)
            }
            DepthSteps::Triangles => {
                let message = named("depth-triangle-whole", id);
                Caption::new(since(message, before.so_far.tally, tally))
            }
        },
        Event::Span {
            id,
            row,
            columns,
            tally,
            ..
        } => {
            let message = named("depth-span", id)
                .with("row", row as usize)
                .with("first", columns[0] as usize)
                .with("last", columns[1].saturating_sub(1) as usize);
            Caption::new(since(message, before.so_far.tally, tally))
        }
        Event::Fragment { fragment, .. } => fragment_caption(&fragment, input),
        Event::Done => {
            in_shades::<L>(&before.so_far.depth, input).unwrap_or_else(|| done(before.so_far.tally))
        }
    }
}

/// How many fragments came, and were written, since before.
fn since(message: Message, before: FragmentTally, tally: FragmentTally) -> Message {
    message
        .with("fragments", (tally.fragments - before.fragments) as usize)
        .with("writes", (tally.writes - before.writes) as usize)
}

fn fragment_caption(fragment: &Fragment, input: &Input) -> Caption {
    let stored = u32::try_from(fragment.stored_id).ok();
    let is_tie = fragment.new == fragment.stored;
    let key = match (fragment.kept, stored) {
        (true, None) => "depth-fragment-first",
        (true, Some(_)) => "depth-fragment-kept",
        (false, None) => "depth-fragment-lost-to-nothing",
        (false, Some(_)) if is_tie => "depth-fragment-tie",
        (false, Some(_)) => "depth-fragment-lost",
    };
    let message = Message::new(key)
        .with("triangle", name_of(input, fragment.id))
        .with(
            "other",
            stored.map_or(Value::Term("depth-nothing"), |id| name_of(input, id)),
        )
        .with("at", pixel_formula(fragment.pixel));
    Caption::new(message).so(comparison(&input.own.format, fragment))
}

/// Of a buffer that is shown in shades: which part of their scale it needs. None where it is not, or nothing was drawn.
fn in_shades<L: Variant>(stored: &[f64], input: &Input) -> Option<Caption> {
    let own = &input.own;
    let rays = Rays::of(&own.surfaces);
    let distance = |stored| rays.distance(t_of::<L>(&rays, own.format.turned(stored)));
    let finite = stored.iter().copied().filter(|stored| stored.is_finite());
    let stored = |value| depth(Formula::decimals(), &own.format, value);
    let plain = |value| Formula::decimals().num(value);
    let (key, values, said): (_, Vec<f64>, &dyn Fn(f64) -> Formula) =
        match input.scenery.as_deref()?.scene().raster.tones {
            Tones::Triangles => return None,
            Tones::Stored => ("depth-done-stored", finite.collect(), &stored),
            Tones::Distance => (
                "depth-done-distance",
                finite.map(distance).collect(),
                &plain,
            ),
        };
    let least = values.iter().copied().reduce(f64::min)?;
    let most = values.iter().copied().reduce(f64::max)?;
    let message = Message::new(key).with("pixels", values.len());
    Some(Caption::new(
        message.with("least", said(least)).with("most", said(most)),
    ))
}

fn done(tally: FragmentTally) -> Caption {
    let [fragments, writes, pixels] = [tally.fragments, tally.writes, tally.pixels];
    let key = if pixels == 0 {
        "depth-done-nothing"
    } else {
        "depth-done"
    };
    let message = Message::new(key)
        .with("fragments", fragments as usize)
        .with("writes", writes as usize)
        .with("pixels", pixels as usize);
    let caption = Caption::new(message);
    if pixels == 0 {
        return caption;
    }
    let formula = Formula::decimals().num(fragments as f64).sym(" / ");
    let formula = formula.num(pixels as f64);
    caption.so(formula.equals(fragments as f64 / pixels as f64))
}
