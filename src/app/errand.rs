//! Work that takes longer than a frame: in a thread of its own where there are threads, else in a frame that comes after one
//! that says so.

use web_time::Duration;

use egui::Context;
#[cfg(not(target_arch = "wasm32"))]
use std::{
    sync::mpsc::{self, Receiver, RecvTimeoutError},
    thread,
};

/// The work has come to grief, and there will be no answer.
pub struct Lost;

#[cfg(not(target_arch = "wasm32"))]
pub struct Errand<T> {
    answer: Receiver<T>,
}

#[cfg(not(target_arch = "wasm32"))]
impl<T: Send + 'static> Errand<T> {
    /// The context is woken when there is an answer.
    pub fn start(ctx: &Context, work: impl FnOnce() -> T + Send + 'static) -> Self {
        let (said, answer) = mpsc::channel();
        let ctx = ctx.clone();
        thread::spawn(move || {
            let done = work();
            // Nobody listens where the window has been closed.
            if said.send(done).is_ok() {
                ctx.request_repaint();
            }
        });
        Self { answer }
    }

    /// What came of it, if it comes within this time: said once.
    pub fn answer(&mut self, within: Duration) -> Result<Option<T>, Lost> {
        match self.answer.recv_timeout(within) {
            Ok(done) => Ok(Some(done)),
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => Err(Lost),
        }
    }
}

#[cfg(target_arch = "wasm32")]
pub struct Errand<T> {
    work: Option<Box<dyn FnOnce() -> T>>,
    is_said: bool,
}

#[cfg(target_arch = "wasm32")]
impl<T> Errand<T> {
    pub fn start(ctx: &Context, work: impl FnOnce() -> T + 'static) -> Self {
        ctx.request_repaint();
        Self {
            work: Some(Box::new(work)),
            is_said: false,
        }
    }

    pub fn answer(&mut self, _: Duration) -> Result<Option<T>, Lost> {
        if !std::mem::replace(&mut self.is_said, true) {
            return Ok(None);
        }
        self.work.take().map(|work| Some(work())).ok_or(Lost)
    }
}
