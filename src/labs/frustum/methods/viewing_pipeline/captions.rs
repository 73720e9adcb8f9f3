//! What is said at each step.

use crate::{
    algo::pipeline::{
        PipelineSpace, ViewingPipelineEvent as Event, ViewingPipelineInput,
        ViewingPipelineState as State,
    },
    figure::Caption,
    geom::Sight,
    text::{Formula, Message},
};

use super::formulas::{AXES, against_w, before, screen_formula, sum};

pub fn opening(input: &ViewingPipelineInput) -> Caption {
    let formula = Formula::decimals().sym("P = ").place(input.point);
    Caption::new(Message::new("pipeline-opening")).so(formula)
}

pub fn caption(event: &Event, state: &State, input: &ViewingPipelineInput) -> Caption {
    let clip: [f64; 4] = state.at(PipelineSpace::Clip);
    match *event {
        Event::Row { space, row, value } => {
            let operand = before(input, state, space);
            let entries = input.matrix(space).rows()[row];
            let message = row_message(space, row, value, input);
            Caption::new(message).so(sum(row, entries, operand, value))
        }
        Event::Test { inside: true } => {
            let axes = (0..3).map(|i| against_w(&clip, i));
            let said = Caption::new(Message::new("pipeline-inside"));
            axes.fold(said, Caption::so)
        }
        Event::Test { inside: false } => {
            let beyond = (0..3).filter(|&i| !(-clip[3] <= clip[i] && clip[i] <= clip[3]));
            let axes = beyond.map(|i| against_w(&clip, i));
            let said = Caption::new(Message::new("pipeline-outside"));
            axes.fold(said, Caption::so)
        }
        Event::Divide { ndc } => {
            let quotient = |i: usize| {
                let formula = Formula::decimals().sym(format!("{} / w = ", AXES[i]));
                let [num, den] = [clip[i], clip[3]].map(|x| Formula::default().num(x));
                formula.over(num, den).equals(ndc[i])
            };
            let said = Caption::new(Message::new("pipeline-divide").with("w", clip[3]));
            (0..3).map(quotient).fold(said, Caption::so)
        }
        Event::Screen { screen } => {
            let ndc = state.ndc.unwrap_or_default();
            let size = input.viewport.size();
            let message = Message::new("pipeline-screen")
                .with("columns", size[0] as usize)
                .with("rows", size[1] as usize);
            let axis = |i: usize| screen_formula(i, ndc[i], size[i], screen[i]);
            Caption::new(message).so(axis(0)).so(axis(1))
        }
        Event::Behind => {
            let formula = Formula::decimals().sym("w = ").num(clip[3]).sym(" ≤ 0");
            Caption::new(Message::new("pipeline-behind")).so(formula)
        }
    }
}

/// Of each row of the camera's matrix: where what it measures is at least 0, and where it is less.
const OF_VIEW: [[&str; 2]; 3] = [
    ["pipeline-view-right", "pipeline-view-left"],
    ["pipeline-view-above", "pipeline-view-under"],
    ["pipeline-view-back", "pipeline-view-ahead"],
];

const OF_CLIP: [&str; 4] = [
    "pipeline-clip-x",
    "pipeline-clip-y",
    "pipeline-clip-z",
    "pipeline-clip-w",
];

/// What a row of a matrix does.
fn row_message(
    space: PipelineSpace,
    row: usize,
    value: f64,
    input: &ViewingPipelineInput,
) -> Message {
    let is_parallel = input.camera.volume().sight() == Sight::Parallel;
    let key = match space {
        PipelineSpace::World => "pipeline-world-row",
        PipelineSpace::View => OF_VIEW[row][usize::from(value < 0.0)],
        PipelineSpace::Clip if is_parallel && row == 3 => "pipeline-clip-w-parallel",
        PipelineSpace::Clip => OF_CLIP[row],
    };
    let message = Message::new(key).with("row", row + 1);
    message.with("value", value.abs())
}
