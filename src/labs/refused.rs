//! A scene that a method cannot take: said and shown on stage, in place of a run.

use std::ops::ControlFlow;

use serde_json::{Value as Json, json};

use crate::{
    figure::{Caption, Run, Shown, Tick, View, Watch, Words},
    trace::Counts,
};

/// A run without a step.
pub struct RefusedRun {
    /// As the command line spells it.
    pub code: &'static str,
    pub caption: Caption,
    pub views: Vec<View>,
}

impl Run for RefusedRun {
    fn n_steps(&self) -> usize {
        0
    }

    fn is_refused(&self) -> bool {
        true
    }

    fn tick(&self, _step: usize) -> Tick {
        Tick::Reject
    }

    fn event_json(&self, _step: usize) -> Json {
        Json::Null
    }

    fn read_words(&self, _step: usize, _words: &mut Words) {}

    fn counts_at(&self, _step: usize) -> Counts {
        Counts::default()
    }

    fn code_line(&self, _step: usize) -> Option<usize> {
        None
    }

    fn visit(
        &self,
        _from_to: [usize; 2],
        look: &mut dyn FnMut(usize, &dyn Shown) -> ControlFlow<()>,
    ) {
        // Its only step: there is none after it to go on to.
        let _ = look(0, self);
    }

    fn output_json(&self) -> Json {
        json!({ "refused": self.code })
    }
}

impl Shown for RefusedRun {
    fn caption(&self) -> Caption {
        self.caption.clone()
    }

    fn watch(&self) -> Watch {
        Watch::new()
    }

    fn views(&self) -> Vec<View> {
        self.views.clone()
    }
}
