//! The lines lab's document: what is clipped against what, and by which method; and what the lab knows of a method.

use std::fmt;

use crate::{
    algo::line::BitOrder,
    figure::Run,
    geom::{ConvexPolygon, HalfPlane, Segment, Window},
    text::{Diagnostic, Message, Value},
    trace::Counts,
};

/// More segments than this are refused: a frame could not draw them in time, nor a file be read.
pub const MAX_SEGMENTS: usize = 1_000_000;

/// One of the lab's methods.
pub type Method = crate::labs::Method<MethodInfo>;

/// What the lab knows of a method without running it.
pub struct MethodInfo {
    /// Can it clip against any convex polygon?
    pub takes_polygon: bool,
    /// Does it write outcodes, so that the order of their bits matters?
    pub writes_codes: bool,
    /// Runs it on one segment of a scene.
    pub record: fn(&Scene, Segment) -> Box<dyn Run>,
    /// How many operations it takes for one segment of a scene, without recording the steps.
    pub cost: fn(&Scene, Segment) -> Counts,
    /// The test that decides one segment's fate.
    pub decided: fn(&Scene, Segment) -> Decided,
    /// Clips all these segments silently each time it is called.
    pub pass: fn(&Scene, &[Segment]) -> Pass,
}

/// What decided a segment's fate in one method's run.
#[derive(Clone, PartialEq, Debug)]
pub struct Decided {
    /// The step of the test that decided it.
    pub step: usize,
    /// The border that rejects it.
    pub rejected_by: Option<usize>,
    /// The borders that it comes in and goes out by, where it comes in only after it has gone out.
    pub between: Option<[Value; 2]>,
    /// The borders of what this method clips against, and their names.
    pub borders: Vec<(HalfPlane, Value)>,
}

/// Clips a batch, the same one each time it is called; the number of segments that are visible.
pub type Pass = Box<dyn FnMut() -> usize>;

/// Always valid: at least one segment, and the focus is one of them.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    /// How the focused segment is clipped.
    pub method: Method,
    /// A second method on the same input, side by side.
    pub compare: Option<Method>,
    /// The clip window.
    pub window: Window,
    /// A convex clip region that takes the window's place for methods that can use one.
    pub clip: Option<ConvexPolygon>,
    /// The order in which outcodes are written.
    pub bit_order: BitOrder,
    segments: Vec<Segment>,
    focus: usize,
}

/// Why a scene is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SceneError {
    /// A scene needs a segment.
    NoSegments,
    /// More than [`MAX_SEGMENTS`].
    TooManySegments(usize),
    /// The focus is not the index of a segment.
    NoSuchFocus {
        /// As given.
        focus: usize,
        /// Segments that there are.
        n_segments: usize,
    },
}

impl From<SceneError> for Diagnostic {
    fn from(error: SceneError) -> Self {
        match error {
            SceneError::NoSegments => Self::new(Message::new("error-no-segments")),
            SceneError::TooManySegments(count) => {
                let message = Message::new("error-too-many-segments").with("count", count);
                Self::new(message.with("limit", MAX_SEGMENTS)).coded("too-large")
            }
            SceneError::NoSuchFocus { focus, n_segments } => {
                let message = Message::new("error-no-such-focus").with("focus", focus.to_string());
                Self::new(message.with("count", n_segments))
            }
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Diagnostic::from(*self).fmt(f)
    }
}

impl Scene {
    /// A scene with one window and these segments, the first in focus.
    ///
    /// # Errors
    /// [`SceneError`] where there is no segment, or too many.
    pub fn new(method: Method, window: Window, segments: Vec<Segment>) -> Result<Self, SceneError> {
        check(&segments)?;
        Ok(Self {
            method,
            compare: None,
            window,
            clip: None,
            bit_order: BitOrder::default(),
            focus: 0,
            segments,
        })
    }

    /// What the lab opens on where there is no lesson.
    ///
    /// # Panics
    /// Never: its numbers are valid.
    pub fn first() -> Self {
        let method = Method::by_id("cohen-sutherland").or_else(|| Method::all().next());
        let window = Window::new(-1.0, -1.0, 1.0, 1.0);
        let segment = Segment::new(-2.0, -1.0, 2.0, 1.5);
        let parts = method.zip(window.ok()).zip(segment.ok());
        let ((method, window), segment) = parts.expect("constants that are valid");
        Self::new(method, window, vec![segment]).expect("one segment")
    }

    /// The methods on stage.
    pub fn on_stage(&self) -> impl Iterator<Item = Method> {
        [Some(self.method), self.compare].into_iter().flatten()
    }

    /// At least one.
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Index of the segment whose clipping is stepped.
    pub const fn focus(&self) -> usize {
        self.focus
    }

    /// The segment whose clipping is stepped.
    pub fn focused(&self) -> Segment {
        self.segments[self.focus]
    }

    /// Steps another segment's clipping; an index that is none is ignored.
    pub fn set_focus(&mut self, segment_idx: usize) {
        if segment_idx < self.segments.len() {
            self.focus = segment_idx;
        }
    }

    /// Replaces a segment; an index that is none is ignored.
    pub fn set_segment(&mut self, segment_idx: usize, segment: Segment) {
        if let Some(old) = self.segments.get_mut(segment_idx) {
            *old = segment;
        }
    }

    /// Adds a segment and puts it in focus.
    ///
    /// # Errors
    /// [`SceneError::TooManySegments`]
    pub fn add_segment(&mut self, segment: Segment) -> Result<(), SceneError> {
        if self.segments.len() >= MAX_SEGMENTS {
            return Err(SceneError::TooManySegments(self.segments.len() + 1));
        }
        self.segments.push(segment);
        self.focus = self.segments.len() - 1;
        Ok(())
    }

    /// Takes the focused segment out; the last one stays.
    pub fn remove_focused(&mut self) {
        if self.segments.len() > 1 {
            self.segments.remove(self.focus);
            self.focus = self.focus.min(self.segments.len() - 1);
        }
    }

    /// Replaces all segments, the first in focus.
    ///
    /// # Errors
    /// [`SceneError`] where there is none, or too many.
    pub fn set_segments(&mut self, segments: Vec<Segment>) -> Result<(), SceneError> {
        check(&segments)?;
        (self.segments, self.focus) = (segments, 0);
        Ok(())
    }

    /// The convex region, where there is one and a method on stage can use it.
    pub fn polygon_in_use(&self) -> Option<&ConvexPolygon> {
        let is_used = self.on_stage().any(|method| method.info().takes_polygon);
        self.clip.as_ref().filter(|_| is_used)
    }

    /// The convex region, or the window's outline where there is none.
    pub fn clip_polygon(&self) -> ConvexPolygon {
        let window = || ConvexPolygon::from(self.window);
        self.clip.clone().unwrap_or_else(window)
    }

    /// The region that `method` clips against: the convex polygon where there is one and the method can
    /// use it, else the window.
    pub fn region(&self, method: Method) -> ConvexPolygon {
        if method.info().takes_polygon {
            self.clip_polygon()
        } else {
            ConvexPolygon::from(self.window)
        }
    }
}

const fn check(segments: &[Segment]) -> Result<(), SceneError> {
    match segments.len() {
        0 => Err(SceneError::NoSegments),
        1..=MAX_SEGMENTS => Ok(()),
        n => Err(SceneError::TooManySegments(n)),
    }
}
