//! The recorded runs on stage, and the cursor that walks them together.

use std::cell::RefCell;

use crate::{
    figure::{
        Caption, CodeLinks, Comparison, Eyes, Frame, Need, Prospect, Run, Tick, View, Watch,
        notation, sentences, watches,
    },
    labs::{Difference, MethodCard, Scene, comparison},
    text::{Notation, Value},
    trace::{Counts, Transport},
    widgets::{Album, Recorded, wanted},
};

use super::found::{Found, Told, Wanted};

/// What would answer a question, and is not shown: the names of mistakes, pictures of what comes, what each program costs.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub struct Hidden {
    pub mistakes: bool,
    pub what_comes: bool,
    pub costs: bool,
}

/// One run, or several side by side; with the frames of the present step.
pub struct Playback {
    pub transport: Transport,
    /// What the runs are of.
    scene: Scene,
    /// The scene's method first.
    runs: Vec<Box<dyn Run>>,
    /// The last run that was none of a refused scene, and where it stood: a drag across such a scene comes back to there.
    interrupted: Option<(Box<dyn Run>, usize)>,
    /// Steps at which a phase begins, the first few hundred.
    pub phases: Vec<usize>,
    /// Where a method that is wrong on purpose first differs from the right one.
    pub difference: Option<Difference>,
    /// What the plainest method does on the same input, in all; none where it is that method.
    pub baseline: Option<(&'static MethodCard, Counts)>,
    /// Frames of the step they were made for; none before [`Playback::prepare`].
    pub frames: Vec<Frame>,
    framed_at: Option<usize>,
    /// The furthest step that has been shown since the recording.
    pub reached: usize,
    /// What the views of each run want; empty until a frame of it is made.
    pub needs: Vec<Vec<Need>>,
    /// The same, where it has been found with the runs.
    wanted: Option<Wanted>,
    told: Vec<Told>,
    /// How they stand beside each other, from when these methods were opened: dragging does not change it. Others, which are
    /// put there afterwards, are each seen by themselves.
    comparison: (Vec<&'static str>, Comparison),
    hidden: Hidden,
    together: Option<Frame>,
    /// At which position of the first run the others stand where: events are compared from the beginning to find that.
    beside: RefCell<Option<(usize, Vec<usize>)>>,
    /// How numbers are written: those of the whole run, and those of the present step.
    notations: [Notation; 2],
    /// Found with the first frames, and kept whatever is dragged; none where they are to be found anew.
    pub eyes: Option<Eyes>,
    /// Another number for every recording.
    pub recording: u64,
    /// How many of the last recordings one after the other took too long for a drag.
    n_slow: usize,
    /// The scene on stage is being dragged and has changed since: what is recorded is of an earlier one.
    pub is_late: bool,
    /// When time last passed, in seconds.
    clock: Option<f64>,
}

/// A scene of at most this size is recorded in time, whatever the machine does meanwhile.
const LARGE: usize = 1000;
/// What a recording may take while something is dragged: half of a frame.
const MOST_SECS: f64 = 0.008;
/// One slow recording may be the machine's doing: so many are the scene's.
const PATIENCE: usize = 3;

impl Playback {
    pub fn record(scene: &Scene, position: usize) -> Self {
        Self::of(Found::of(scene), position)
    }

    pub fn of(found: Found, position: usize) -> Self {
        let methods = found.scene.document().methods();
        let all: Vec<&dyn Run> = found.runs.iter().map(|run| &**run).collect();
        let comparison = (ids(&methods), comparison(&methods, &all));
        let mut transport = Transport::new(found.runs[0].n_steps());
        transport.seek(position);
        Self {
            transport,
            scene: found.scene,
            phases: found.phases,
            runs: found.runs,
            interrupted: None,
            difference: found.difference,
            baseline: found.baseline,
            frames: Vec::new(),
            framed_at: None,
            reached: 0,
            needs: Vec::new(),
            wanted: found.wanted,
            told: found.told,
            comparison,
            hidden: Hidden::default(),
            together: None,
            beside: RefCell::default(),
            notations: [Notation::Own; 2],
            eyes: None,
            recording: 0,
            n_slow: 0,
            is_late: false,
            clock: None,
        }
    }

    /// The same recording, with another number than the one that was there before.
    pub fn in_place_of(self, before: &Self) -> Self {
        Self {
            recording: before.recording + 1,
            ..self
        }
    }

    /// Records the changed scene; the cursor stays at the same moment where it comes again.
    pub fn rerecord(&mut self, scene: &Scene) {
        self.take(Found::of(scene));
    }

    /// The same of a scene that has been recorded elsewhere.
    pub fn take(&mut self, found: Found) {
        let is_slow = found.secs > MOST_SECS;
        self.n_slow = if is_slow { self.n_slow + 1 } else { 0 };
        self.is_late = false;
        self.scene = found.scene;
        let before = std::mem::replace(&mut self.runs, found.runs).swap_remove(0);
        self.beside = RefCell::default();
        let now = (before, self.transport.position());
        let (before, step) = self.interrupted.take().unwrap_or(now);
        let position = self.main().corresponding(&*before, step);
        self.transport.rebase(self.main().n_steps(), position);
        if self.main().is_refused() {
            self.interrupted = Some((before, step));
        }
        self.reached = position;
        self.phases = found.phases;
        self.difference = found.difference;
        self.baseline = found.baseline;
        self.recording += 1;
        self.framed_at = None;
        self.needs.clear();
        (self.wanted, self.told) = (found.wanted, found.told);
    }

    /// The scene is the recorded one again.
    pub const fn keep(&mut self) {
        (self.is_late, self.framed_at) = (false, None);
    }

    /// Its run takes so long that no drag records it.
    pub const fn is_slow(&mut self) {
        self.n_slow = PATIENCE;
    }

    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The same while a handle is dragged: a large scene whose run takes too long waits until it is let go.
    pub fn follow(&mut self, scene: &Scene) {
        if scene.document().size() > LARGE && self.n_slow >= PATIENCE {
            (self.is_late, self.framed_at) = (true, None);
        } else {
            self.rerecord(scene);
        }
    }

    /// The run of the scene's method.
    pub fn main(&self) -> &dyn Run {
        &*self.runs[0]
    }

    pub fn runs(&self) -> impl Iterator<Item = &dyn Run> {
        self.runs.iter().map(|run| &**run)
    }

    /// What the runs say at their steps.
    pub fn sentences(&self) -> Vec<Caption> {
        if self.told.is_empty() {
            return self.runs().flat_map(sentences).collect();
        }
        let told = self.told.iter().flat_map(|told| &told.sentences);
        told.cloned().collect()
    }

    /// The tables of a run at its steps.
    pub fn watches(&self, run: usize) -> Vec<Watch> {
        let told = self.told.get(run).map(|told| told.watches.clone());
        told.unwrap_or_else(|| watches(&*self.runs[run]))
    }

    pub fn code_links(&self, run: usize) -> CodeLinks {
        let told = self.told.get(run).map(|told| told.code_links.clone());
        told.unwrap_or_else(|| CodeLinks::of(&*self.runs[run]))
    }

    /// The next step, in this direction, at which a phase begins; the end where there is none.
    pub fn phase(&self, direction: isize) -> usize {
        let n_steps = self.transport.n_steps();
        let mut step = self.transport.position();
        loop {
            match step.checked_add_signed(direction) {
                None | Some(0) => return 0,
                Some(next) if next > n_steps => return n_steps,
                Some(next) => step = next,
            }
            if self.main().tick(step) == Tick::Phase {
                return step;
            }
        }
    }

    /// Would this answer what is asked?
    pub fn hide(&mut self, hidden: Hidden) {
        if self.hidden != hidden {
            if self.hidden.costs != hidden.costs {
                self.needs.clear();
            }
            self.hidden = hidden;
            self.framed_at = None;
        }
    }

    /// Makes the frames of the present step, unless they are there already, of which these bounds of the plane are to be seen;
    /// where the scene is in an `album`, as the others in that are seen.
    pub fn prepare(&mut self, bounds: [[f64; 2]; 2], album: Option<&Album>) {
        let position = self.transport.position();
        if self.framed_at == Some(position) {
            return;
        }
        let runs = self.runs().zip(self.steps());
        self.frames = runs.map(|(run, [step, _])| run.frame(step)).collect();
        self.framed_at = Some(position);
        self.reached = self.reached.max(position);
        if self.hidden.what_comes {
            self.frames.iter_mut().for_each(Frame::hide_answer);
        }
        let methods = self.scene.document().methods();
        let ids = ids(&methods);
        if self.comparison.0 != ids {
            self.comparison = (ids, Comparison::Apart);
        }
        let comparison = self.comparison.1;
        let is_new = self.needs.is_empty() || self.eyes.is_none();
        let known = album
            .filter(|_| is_new)
            .and_then(|album| album.find(&self.scene));
        let known = known.filter(|known| known.comparison == comparison);
        let mut prospect = Prospect::default();
        if self.needs.is_empty() {
            (self.needs, self.notations[0]) = self.wants(bounds, known, &mut prospect);
        }
        let eyes = self.eyes.take().unwrap_or_else(|| {
            let views = self.frames.iter().map(|frame| &frame.views[..]);
            let views: Vec<&[View]> = views.collect();
            let prospect = known.map_or(&prospect, |known| &known.prospect);
            prospect.eyes(&views, views.len(), known.and(album).map(Album::eyes))
        });
        for frame in &mut self.frames {
            eyes.turn(&mut frame.views);
        }
        self.eyes = Some(eyes);
        let name = |method: &&MethodCard| Value::Term(method.name_asked(self.hidden.mistakes));
        let names: Vec<_> = methods.iter().map(name).collect();
        let at_end = self.steps().iter().all(|[step, n_steps]| step == n_steps);
        self.together = comparison.together(&self.frames, &names, at_end);
        if let Some(frame) = self.together.as_mut().filter(|_| self.hidden.costs) {
            frame.hide_costs();
        }
        self.notations[1] = notation(self.notations[0], self.on_stage());
    }

    /// The room of the views, and how numbers are written; the prospect of a run that is asked now.
    fn wants(
        &mut self,
        bounds: [[f64; 2]; 2],
        known: Option<&Recorded>,
        prospect: &mut Prospect,
    ) -> (Vec<Vec<Need>>, Notation) {
        let ahead = self.wanted.take_if(|_| known.is_none());
        let ahead = ahead.filter(|ahead| ahead.bounds == bounds);
        let (comparison, all) = (self.comparison.1, self.runs().collect::<Vec<_>>());
        let (needs, notation) = if let Some(known) = known {
            (known.needs.clone(), known.notation)
        } else {
            let (needs, notation) = if let Some(ahead) = ahead {
                *prospect = ahead.prospect;
                (ahead.needs, ahead.notation)
            } else {
                let seen = self.eyes.is_none().then_some(prospect);
                wanted(self.runs(), bounds, seen)
            };
            (comparison.needs(&needs, &all), notation)
        };
        if self.hidden.costs {
            (comparison.without_costs(needs, &all), notation)
        } else {
            (needs, notation)
        }
    }

    /// Finds the eyes anew, for what is shown now.
    pub fn look_anew(&mut self) {
        (self.eyes, self.framed_at) = (None, None);
        self.needs.clear();
    }

    pub const fn notation(&self) -> Notation {
        self.notations[1]
    }

    /// What the stage shows: of methods that do the same, one.
    pub fn on_stage(&self) -> &[Frame] {
        let together = self.together.as_ref().map(std::slice::from_ref);
        together.unwrap_or(&self.frames)
    }

    /// Of each run, where it stands and how many steps it has.
    pub fn steps(&self) -> Vec<[usize; 2]> {
        let position = self.transport.position();
        let mut beside = self.beside.borrow_mut();
        if beside.as_ref().is_none_or(|(at, _)| *at != position) {
            let others = self.runs().skip(1);
            let stand = others.map(|run| run.beside(self.main(), position));
            *beside = Some((position, stand.collect()));
        }
        let others = beside.iter().flat_map(|(_, steps)| steps.iter().copied());
        let stand = std::iter::once(position).chain(others);
        let of_all = stand.zip(self.runs());
        of_all.map(|(step, run)| [step, run.n_steps()]).collect()
    }

    /// Cost so far and in the end, of each run.
    pub fn costs(&self) -> Vec<[Counts; 2]> {
        let runs = self.runs().zip(self.steps());
        let costs = runs.map(|(run, steps)| steps.map(|step| run.counts_at(step)));
        costs.collect()
    }

    /// Lets time pass up to `now`, in seconds. Returns how long until the next step while playing.
    pub fn advance(&mut self, now: f64) -> Option<f32> {
        let elapsed = self.clock.map_or(0.0, |before| now - before);
        self.clock = self.transport.is_playing().then_some(now);
        let wait = self.transport.advance(elapsed as f32);
        if wait.is_none() {
            self.clock = None;
        }
        wait
    }
}

fn ids(methods: &[&'static MethodCard]) -> Vec<&'static str> {
    methods.iter().map(|method| method.id).collect()
}
