//! The lines lab's document: what is clipped against what, and by which method; and what the lab knows of a method.

use glam::DVec2;
use serde::Serialize;
use serde_json::json;

use crate::{
    algo::line::{BitOrder, End, Visible, WindowInput},
    geom::{ConvexPolygon, HalfPlane, Segment, Window},
    labs::prelude::*,
    text::Diagnostic,
    trace::{self, Counts},
};

/// More segments than this are refused: a frame could not draw them in time, nor a file be read.
pub const MAX_SEGMENTS: usize = 1_000_000;

pub type Method = crate::labs::Method<MethodInfo>;

pub struct MethodInfo {
    pub takes_polygon: bool,
    pub writes_codes: bool,
    pub record: fn(&Scene, Segment) -> Box<dyn Run>,
    pub cost: fn(&Scene, Segment) -> Counts,
    pub decided: fn(&Scene, Segment) -> Decided,
    pub dropped: fn(&Scene, Segment) -> Vec<Dropped>,
    pub pass: fn(&Scene, &[Segment]) -> Pass,
}

#[derive(Clone, PartialEq, Debug)]
pub struct Decided {
    pub step: usize,
    pub rejected_by: Option<usize>,
    /// The borders that it comes in and goes out by, where it comes in only after it has gone out.
    pub between: Option<[Value; 2]>,
    pub borders: Vec<(HalfPlane, Value)>,
}

/// A part of a segment that a step has cut away, from one parameter along it to another.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Dropped {
    pub step: usize,
    pub from_to: [f64; 2],
}

/// Clips a batch, the same one each time it is called; the number of segments that are visible.
pub type Pass = Box<dyn FnMut() -> usize>;

/// Always valid: at least one segment, and the focus is one of them.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    pub method: Method,
    pub compare: Option<Method>,
    pub window: Window,
    /// A convex clip region that takes the window's place for methods that can use one.
    pub clip: Option<ConvexPolygon>,
    pub bit_order: BitOrder,
    /// What someone clipped by mistake in place of the segment in focus: its piece is crossed.
    pub mistaken: Option<Segment>,
    segments: Vec<Segment>,
    focus: usize,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SceneError {
    NoSegments,
    TooManySegments(usize),
    NoSuchFocus { focus: usize, n_segments: usize },
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

impl Scene {
    pub fn new(method: Method, window: Window, segments: Vec<Segment>) -> Result<Self, SceneError> {
        check(&segments)?;
        Ok(Self {
            method,
            compare: None,
            window,
            clip: None,
            bit_order: BitOrder::default(),
            mistaken: None,
            focus: 0,
            segments,
        })
    }

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

    pub fn on_stage(&self) -> impl Iterator<Item = Method> {
        [Some(self.method), self.compare].into_iter().flatten()
    }

    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    pub const fn focus(&self) -> usize {
        self.focus
    }

    pub fn focused(&self) -> Segment {
        self.segments[self.focus]
    }

    /// Steps another segment's clipping; an index that is none is ignored.
    pub fn set_focus(&mut self, segment_idx: usize) {
        if segment_idx < self.segments.len() {
            self.focus = segment_idx;
        }
    }

    pub fn set_segment(&mut self, segment_idx: usize, segment: Segment) {
        if let Some(old) = self.segments.get_mut(segment_idx) {
            *old = segment;
        }
    }

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

    pub fn clip_polygon(&self) -> ConvexPolygon {
        let window = || ConvexPolygon::from(self.window);
        self.clip.clone().unwrap_or_else(window)
    }

    pub const fn with(&self, segment: Segment) -> WindowInput {
        let window = self.window;
        WindowInput { window, segment }
    }

    /// What `method` clips against: the convex polygon where there is one and the method can use it, else the window.
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

/// A line clipper that can be shown. Of a step that decides about the segment it names `rejects`, the border by which that is
/// rejected; and `enters` and `leaves`, where the segment's line comes in only after it has gone out.
pub trait LineTelling: Telling<Scenery = ()> + trace::Method<Output = Visible> {
    const TAKES_POLYGON: bool = false;
    const WRITES_CODES: bool = false;

    fn input(scene: &Scene, segment: Segment) -> Self::Input;

    /// The end that an event cuts off, and up to which parameter along the segment.
    fn cuts(event: &Self::Event, segment: &Segment) -> Option<(End, f64)>;
}

/// The parameter of the place along a segment that is nearest to a point.
pub fn nearest_along(segment: &Segment, at: [f64; 2]) -> f64 {
    let ends = [segment.p1, segment.p2].map(|end| DVec2::from(end.to_array()));
    let along = ends[1] - ends[0];
    let share = (DVec2::from(at) - ends[0]).dot(along) / along.length_squared();
    if share.is_nan() {
        0.0
    } else {
        share.clamp(0.0, 1.0)
    }
}

impl Answer for Visible {
    fn told(&self) -> impl Serialize {
        json!({ "visible": self.is_some(), "segment": self })
    }
}
