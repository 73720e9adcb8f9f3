//! What leads from one space to the next, row by row.

use crate::{
    algo::pipeline::{PipelineSpace, ViewingPipeline, ViewingPipelineEvent as Event},
    figure::{MatrixProduct, MatrixRow},
    labs::frustum::prelude::*,
};

use super::super::{super::stage::PictureSpace, asked::place};
use super::{
    formulas::{BEHIND, DIVIDE_FLAT, SCREEN, TO_W, before, is_within, sum},
    reached,
};

pub const ARROWS: [&str; 5] = [
    "world_from_model",
    "view_from_world",
    "clip_from_view",
    "ndc_from_clip",
    "screen_from_ndc",
];

/// The product that a step is about; before the first one, the one to come.
pub fn product(at: &At<'_, ViewingPipeline>) -> MatrixProduct {
    match at.step.event() {
        None => matrix(at, PipelineSpace::World),
        Some(Event::Row { space, .. }) => matrix(at, space),
        Some(Event::Test { .. }) => test(at),
        Some(Event::Divide { ndc }) => divide(at, ndc),
        Some(Event::Screen { screen }) => viewport(at, screen),
        Some(Event::Behind) => behind(at),
    }
}

fn row_link(row: usize) -> Link {
    Link::nth("row", row)
}

fn matrix(at: &At<'_, ViewingPipeline>, into: PipelineSpace) -> MatrixProduct {
    let (input, event) = (at.step.input, at.step.event());
    let operand = before(input, at.step.held, into);
    let known = reached(at, into);
    let current = match event {
        Some(Event::Row { row, .. }) => Some(row),
        _ => None,
    };
    let rows = input.matrix(into).rows().into_iter().enumerate();
    let rows = rows.map(|(i, entries)| {
        let found = known.get(i).copied();
        // The last row of an affine matrix leaves the 1 where it is.
        let one = event.filter(|_| i >= into.n_rows()).map(|_| 1.0);
        MatrixRow {
            entries: entries.map(|x| x + 0.0).to_vec(),
            operand: Some(if i == 3 { 1.0 } else { operand[i] }),
            result: one.or(found),
            sum: found.map(|value| sum(i, entries, operand, value)),
            is_current: current == Some(i),
            link: Some(row_link(i)),
        }
    });
    let [from, to] = [0, 1].map(|i| PictureSpace::ALL[into as usize + i].name_key());
    MatrixProduct {
        name: name(ARROWS[into as usize]),
        notes: vec![note(at, into)],
        from: Value::Term(from),
        operator: None,
        into: Some(Value::Term(to)),
        rows: rows.collect(),
    }
}

fn note(at: &At<'_, ViewingPipeline>, into: PipelineSpace) -> Value {
    let camera = &at.step.input.camera;
    let volume = camera.volume();
    Value::Message(match into {
        PipelineSpace::World => Message::new("pipeline-note-world"),
        PipelineSpace::View => {
            Message::new("pipeline-note-view").with("at", place(camera.position()))
        }
        PipelineSpace::Clip => {
            let key = match volume.sight() {
                Sight::Perspective => "pipeline-note-clip",
                Sight::Parallel => "pipeline-note-clip-parallel",
            };
            let [width, height] = volume.half_size();
            Message::new(key)
                .with("near", volume.near())
                .with("far", volume.far())
                .with("aspect", width / height)
                .with("angle", 2.0 * libm::atan(height).to_degrees())
                .with("height", 2.0 * height)
        }
    })
}

fn rows(
    operand: &[f64],
    result: &[f64],
    sum: impl Fn(usize) -> Option<Formula>,
    is_current: impl Fn(usize) -> bool,
) -> Vec<MatrixRow> {
    let row = |(i, &x): (usize, &f64)| MatrixRow {
        entries: Vec::new(),
        operand: Some(x),
        result: result.get(i).copied(),
        sum: sum(i),
        is_current: is_current(i),
        link: Some(row_link(i)),
    };
    operand.iter().enumerate().map(row).collect()
}

/// A step without a matrix.
fn plain(name: Value, from: &'static str, rows: Vec<MatrixRow>) -> MatrixProduct {
    MatrixProduct {
        name,
        notes: Vec::new(),
        from: Value::Term(from),
        operator: None,
        into: None,
        rows,
    }
}

fn test(at: &At<'_, ViewingPipeline>) -> MatrixProduct {
    let held = at.step.held;
    let sum = |i: usize| at.formula(TO_W.get(i)?);
    let is_current = |i| i < 3 && (held.inside || !is_within(&held.clip, i));
    let rows = rows(&held.clip, &[], sum, is_current);
    plain(name("−w ≤ x, y, z ≤ w"), "space-clip", rows)
}

fn divide(at: &At<'_, ViewingPipeline>, ndc: [f64; 3]) -> MatrixProduct {
    let clip = at.step.held.clip;
    let rows = rows(&clip, &ndc, |i| at.formula(DIVIDE_FLAT.get(i)?), |i| i < 3);
    MatrixProduct {
        operator: Some(Formula::decimals().sym("÷ ").num(clip[3])),
        into: Some(Value::Term("space-ndc")),
        ..plain(name(ARROWS[3]), "space-clip", rows)
    }
}

fn viewport(at: &At<'_, ViewingPipeline>, screen: [f64; 2]) -> MatrixProduct {
    let ndc = at.step.held.ndc.unwrap_or_default();
    let size = at.formula("{width} × {height}").map(Value::Formula);
    let rows = rows(&ndc, &screen, |i| at.formula(SCREEN.get(i)?), |i| i < 2);
    MatrixProduct {
        notes: size.into_iter().collect(),
        into: Some(Value::Term("space-screen")),
        ..plain(name(ARROWS[4]), "space-ndc", rows)
    }
}

fn behind(at: &At<'_, ViewingPipeline>) -> MatrixProduct {
    let no_more = |i: usize| at.formula(BEHIND).filter(|_| i == 3);
    let rows = rows(&at.step.held.clip, &[], no_more, |i| i == 3);
    plain(name("w ≤ 0"), "space-clip", rows)
}
