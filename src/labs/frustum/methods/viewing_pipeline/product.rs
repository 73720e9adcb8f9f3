//! What leads from one space to the next, row by row.

use crate::{
    algo::pipeline::{
        PipelineSpace, ViewingPipelineEvent as Event, ViewingPipelineInput,
        ViewingPipelineState as State,
    },
    figure::{Link, MatrixProduct, MatrixRow},
    geom::Sight,
    labs::words::name,
    text::{Formula, Message, Value},
};

use super::super::planes::place;
use super::formulas::{AXES, against_w, before, screen_formula, sum};

/// What leads from each space to the next, as it is called.
pub const ARROWS: [&str; 5] = [
    "world_from_model",
    "view_from_world",
    "clip_from_view",
    "ndc_from_clip",
    "screen_from_ndc",
];

/// A step, whatever it is drawn in.
pub struct PipelineStep<'a> {
    /// What is followed.
    pub input: &'a ViewingPipelineInput,
    /// After the event.
    pub state: &'a State,
    /// None before the first one.
    pub event: Option<Event>,
}

/// The product that a step is about; before the first one, the one to come.
pub fn product(step: &PipelineStep<'_>) -> MatrixProduct {
    match step.event {
        None => matrix(step, PipelineSpace::World),
        Some(Event::Row { space, .. }) => matrix(step, space),
        Some(Event::Test { .. }) => test(step),
        Some(Event::Divide { ndc }) => divide(step, ndc),
        Some(Event::Screen { screen }) => viewport(step, screen),
        Some(Event::Behind) => behind(step),
    }
}

fn row_link(row: usize) -> Link {
    Link::nth("row", row)
}

fn matrix(step: &PipelineStep<'_>, into: PipelineSpace) -> MatrixProduct {
    let input = step.input;
    let operand = before(input, step.state, into);
    let known = &step.state.known[into as usize];
    let current = match step.event {
        Some(Event::Row { row, .. }) => Some(row),
        None
        | Some(Event::Test { .. } | Event::Divide { .. } | Event::Screen { .. } | Event::Behind) => {
            None
        }
    };
    let rows = input.matrix(into).rows().into_iter().enumerate();
    let rows = rows.map(|(i, entries)| {
        let found = known.get(i).copied();
        // The last row of an affine matrix leaves the 1 where it is.
        let result = if i < into.n_rows() {
            found
        } else {
            step.event.map(|_| 1.0)
        };
        MatrixRow {
            entries: entries.map(|x| x + 0.0).to_vec(),
            operand: Some(if i == 3 { 1.0 } else { operand[i] }),
            result,
            sum: found.map(|value| sum(i, entries, operand, value)),
            is_current: current == Some(i),
            link: Some(row_link(i)),
        }
    });
    let (from, name_key) = match into {
        PipelineSpace::World => ("space-model", "space-world"),
        PipelineSpace::View => ("space-world", "space-view"),
        PipelineSpace::Clip => ("space-view", "space-clip"),
    };
    MatrixProduct {
        name: name(ARROWS[into as usize]),
        notes: vec![note(step, into)],
        from: Value::Term(from),
        operator: None,
        into: Some(Value::Term(name_key)),
        rows: rows.collect(),
    }
}

/// What a matrix is made of.
fn note(step: &PipelineStep<'_>, into: PipelineSpace) -> Value {
    let camera = &step.input.camera;
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
            let depths = Message::new(key)
                .with("near", volume.near())
                .with("far", volume.far());
            depths
                .with("aspect", width / height)
                .with("angle", 2.0 * libm::atan(height).to_degrees())
                .with("height", 2.0 * height)
        }
    })
}

/// Rows without a matrix.
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

fn test(step: &PipelineStep<'_>) -> MatrixProduct {
    let clip: [f64; 4] = step.state.at(PipelineSpace::Clip);
    let inside = step.state.inside.unwrap_or_default();
    let is_within = |i: usize| -clip[3] <= clip[i] && clip[i] <= clip[3];
    MatrixProduct {
        name: name("−w ≤ x, y, z ≤ w"),
        notes: Vec::new(),
        from: Value::Term("space-clip"),
        operator: None,
        into: None,
        rows: rows(
            &clip,
            &[],
            |i| (i < 3).then(|| against_w(&clip, i)),
            |i| i < 3 && (inside || !is_within(i)),
        ),
    }
}

fn divide(step: &PipelineStep<'_>, ndc: [f64; 3]) -> MatrixProduct {
    let clip: [f64; 4] = step.state.at(PipelineSpace::Clip);
    let quotient = |i: usize| {
        let formula = Formula::decimals().sym(AXES[i]).sym(" / w = ");
        let formula = formula.num(clip[i]).sym(" / ");
        formula.operand(clip[3]).equals(ndc[i])
    };
    MatrixProduct {
        name: name(ARROWS[3]),
        notes: Vec::new(),
        from: Value::Term("space-clip"),
        operator: Some(Formula::decimals().sym("÷ ").num(clip[3])),
        into: Some(Value::Term("space-ndc")),
        rows: rows(&clip, &ndc, |i| (i < 3).then(|| quotient(i)), |i| i < 3),
    }
}

fn viewport(step: &PipelineStep<'_>, screen: [f64; 2]) -> MatrixProduct {
    let ndc = step.state.ndc.unwrap_or_default();
    let size = step.input.viewport.size();
    let pixels = Formula::default().num(f64::from(size[0])).sym(" × ");
    MatrixProduct {
        name: name(ARROWS[4]),
        notes: vec![Value::Formula(pixels.num(f64::from(size[1])))],
        from: Value::Term("space-ndc"),
        operator: None,
        into: Some(Value::Term("space-screen")),
        rows: rows(
            &ndc,
            &screen,
            |i| {
                let found = screen.get(i)?;
                Some(screen_formula(i, ndc[i], size[i], *found))
            },
            |i| i < 2,
        ),
    }
}

fn behind(step: &PipelineStep<'_>) -> MatrixProduct {
    let clip: [f64; 4] = step.state.at(PipelineSpace::Clip);
    let no_more = |i: usize| {
        let formula = Formula::decimals().sym("w = ").num(clip[3]);
        (i == 3).then(|| formula.sym(" ≤ 0"))
    };
    MatrixProduct {
        name: name("w ≤ 0"),
        notes: Vec::new(),
        from: Value::Term("space-clip"),
        operator: None,
        into: None,
        rows: rows(&clip, &[], no_more, |i| i == 3),
    }
}
