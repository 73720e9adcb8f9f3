//! The recorded runs on stage, and the cursor that walks them together.

use crate::{
    figure::{Frame, Need, Run, Tick, needs},
    labs::{Difference, MethodCard, Scene},
    trace::{Counts, Transport},
};

use super::stopwatch::Stopwatch;

/// One run, or several side by side; with the frames of the present step.
pub struct Playback {
    transport: Transport,
    main: Box<dyn Run>,
    beside: Vec<Box<dyn Run>>,
    /// Steps at which a phase begins, the first few hundred.
    phases: Vec<usize>,
    /// Where a method that is wrong on purpose first differs from the right one.
    difference: Option<Difference>,
    /// What the plainest method does on the same input, in all; none where it is that method.
    baseline: Option<(&'static MethodCard, Counts)>,
    /// Frames of the step they were made for.
    frames: Vec<Frame>,
    framed_at: Option<usize>,
    /// The furthest step that has been shown since the recording.
    reached: usize,
    /// What the views of each run want; empty until a frame of it is made.
    needs: Vec<Vec<Need>>,
    /// Another number for every recording.
    recording: u64,
    /// How many of the last recordings one after the other took too long for a drag.
    n_slow: usize,
    /// The scene has changed since: what is recorded is of an earlier one.
    is_late: bool,
    /// When time last passed, in seconds.
    clock: Option<f64>,
}

/// More phases than this are not marked on the timeline.
const MOST_PHASES: usize = 400;
/// A scene of at most this size is recorded in time, whatever the machine does meanwhile.
const LARGE: usize = 1000;
/// What a recording may take while something is dragged: half of a frame.
const MOST_SECS: f64 = 0.008;
/// One slow recording may be the machine's doing: so many are the scene's.
const PATIENCE: usize = 3;

impl Playback {
    /// Records the scene's methods, with the cursor at `position`.
    pub fn record(scene: &Scene, position: usize) -> Self {
        let (main, beside, difference) = runs(scene);
        let mut playback = Self {
            transport: Transport::new(main.n_steps()),
            phases: phases(&*main),
            main,
            beside,
            difference,
            baseline: scene.document().baseline(),
            frames: Vec::new(),
            framed_at: None,
            reached: 0,
            needs: Vec::new(),
            recording: 0,
            n_slow: 0,
            is_late: false,
            clock: None,
        };
        playback.transport.seek(position);
        playback
    }

    /// Records the changed scene; the cursor stays at the same moment where it comes again.
    pub fn rerecord(&mut self, scene: &Scene) {
        let stopwatch = Stopwatch::start();
        let (main, beside, difference) = runs(scene);
        let is_slow = stopwatch.secs() > MOST_SECS;
        self.n_slow = if is_slow { self.n_slow + 1 } else { 0 };
        self.is_late = false;
        let before = self.transport.position();
        let position = main.corresponding(&*self.main, before);
        self.transport.rebase(main.n_steps(), position);
        self.reached = position;
        self.phases = phases(&*main);
        (self.main, self.beside, self.difference) = (main, beside, difference);
        self.baseline = scene.document().baseline();
        self.framed_at = None;
        self.recording += 1;
        self.needs.clear();
    }

    /// The same while a handle is dragged: a large scene whose run takes too long waits until it is let go.
    pub fn follow(&mut self, scene: &Scene) {
        if scene.document().size() > LARGE && self.n_slow >= PATIENCE {
            (self.is_late, self.framed_at) = (true, None);
        } else {
            self.rerecord(scene);
        }
    }

    /// Is what is recorded of an earlier scene?
    pub const fn is_late(&self) -> bool {
        self.is_late
    }

    /// Where the cursor stands, and how fast it goes.
    pub const fn transport(&self) -> &Transport {
        &self.transport
    }

    /// To move it.
    pub const fn transport_mut(&mut self) -> &mut Transport {
        &mut self.transport
    }

    /// The run of the scene's method.
    pub fn main(&self) -> &dyn Run {
        &*self.main
    }

    /// All that is on stage, the scene's method first.
    pub fn runs(&self) -> impl Iterator<Item = &dyn Run> {
        std::iter::once(&*self.main).chain(self.beside.iter().map(|run| &**run))
    }

    /// Another number whenever the scene has been recorded again.
    pub const fn recording(&self) -> u64 {
        self.recording
    }

    /// Where the methods that stand side by side first differ, if one of them is wrong on purpose.
    pub const fn difference(&self) -> Option<Difference> {
        self.difference
    }

    /// Steps at which a phase begins: at most a few hundred.
    pub fn phases(&self) -> &[usize] {
        &self.phases
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
            if self.main.tick(step) == Tick::Phase {
                return step;
            }
        }
    }

    /// Makes the frames of the present step, unless they are there already.
    pub fn prepare(&mut self) {
        let position = self.transport.position();
        if self.framed_at == Some(position) {
            return;
        }
        let beside = |run: &dyn Run| run.frame(run.beside(&*self.main, position));
        self.frames = std::iter::once(self.main.frame(position))
            .chain(self.beside.iter().map(|run| beside(&**run)))
            .collect();
        self.framed_at = Some(position);
        self.reached = self.reached.max(position);
        if self.needs.is_empty() {
            self.needs = self.runs().map(needs).collect();
        }
    }

    /// The furthest step that has been shown: what comes after it is not known yet to whoever has been asked.
    pub const fn reached(&self) -> usize {
        self.reached
    }

    /// Of each run, where it stands and how many steps it has.
    pub fn steps(&self) -> Vec<[usize; 2]> {
        let position = self.transport.position();
        let stand = |run: &dyn Run| [run.beside(&*self.main, position), run.n_steps()];
        self.runs().map(stand).collect()
    }

    /// What the views of each run want, at all its steps.
    pub fn needs(&self) -> &[Vec<Need>] {
        &self.needs
    }

    /// The present step's, the scene's method first; empty before [`Playback::prepare`].
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// Cost so far and in the end, of the scene's method and of those beside it.
    pub fn costs(&self) -> Vec<[Counts; 2]> {
        let runs = self.runs().zip(self.steps());
        runs.map(|(run, [step, n_steps])| [run.counts_at(step), run.counts_at(n_steps)])
            .collect()
    }

    /// A method to compare with where none stands beside, and its cost in all.
    pub const fn baseline(&self) -> Option<(&'static MethodCard, Counts)> {
        self.baseline
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

fn phases(run: &dyn Run) -> Vec<usize> {
    (1..=run.n_steps())
        .filter(|&step| run.tick(step) == Tick::Phase)
        .take(MOST_PHASES)
        .collect()
}

/// The run of the scene's method, those beside it, and how they differ.
type Runs = (Box<dyn Run>, Vec<Box<dyn Run>>, Option<Difference>);

fn runs(scene: &Scene) -> Runs {
    let runs = scene.document().record();
    let all: Vec<&dyn Run> = runs.iter().map(|run| &**run).collect();
    let difference = Difference::between(&scene.document().methods(), &all);
    let mut runs = runs.into_iter();
    let main = runs.next().expect("a scene has a method");
    (main, runs.collect(), difference)
}
