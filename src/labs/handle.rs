//! What a person can take hold of on the stage, by mouse or by keyboard.

use std::str::FromStr;

use crate::{
    algo::line::End,
    geom::{Edge, GeomError, Point, Window},
    text::{Message, Value},
};

/// A corner of the window, by the sides that meet there.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub struct Corner {
    /// At xmax?
    pub right: bool,
    /// At ymax?
    pub top: bool,
}

/// Something that can be dragged.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Handle {
    /// An end of the focused segment.
    End(End),
    /// The focused segment as a whole.
    Segment,
    /// A corner of the window.
    Corner(Corner),
    /// A side of the window.
    Side(Edge),
    /// The window as a whole.
    Window,
    /// A vertex of the clip polygon.
    ClipVertex(usize),
    /// A vertex of the subject polygon.
    Vertex(usize),
    /// A vertex of one of its holes: which hole, which vertex.
    HoleVertex(usize, usize),
    /// The subject polygon with its holes.
    Subject,
}

impl Handle {
    /// Corners and sides of the window and the window itself, in the order in which Tab visits them.
    pub fn of_window() -> impl Iterator<Item = Self> {
        [(false, false), (true, false), (true, true), (false, true)]
            .map(|(right, top)| Self::Corner(Corner { right, top }))
            .into_iter()
            .chain(Edge::ALL.map(Self::Side))
            .chain([Self::Window])
    }

    /// Where it lies, if it is one of the window's.
    #[must_use]
    pub fn on_window(self, window: &Window) -> Option<[f64; 2]> {
        let (min, max) = (window.min(), window.max());
        let centre = [min.x().midpoint(max.x()), min.y().midpoint(max.y())];
        Some(match self {
            Self::Corner(Corner { right, top }) => [
                if right { max.x() } else { min.x() },
                if top { max.y() } else { min.y() },
            ],
            Self::Side(edge @ (Edge::Left | Edge::Right)) => [window.border(edge), centre[1]],
            Self::Side(edge) => [centre[0], window.border(edge)],
            // Not in the middle, where segments like to have theirs: below it and to the right.
            Self::Window => [centre[0].midpoint(max.x()), min.y().midpoint(centre[1])],
            _ => return None,
        })
    }

    /// The window after the handle has gone to `to`; as it is where the handle is not the window's.
    ///
    /// # Errors
    /// [`GeomError`] where the window would not be valid.
    pub fn drag_window(self, window: &Window, to: Point) -> Result<Window, GeomError> {
        let Some([x, y]) = self.on_window(window) else {
            return Ok(*window);
        };
        let [mut xmin, mut ymin, mut xmax, mut ymax] = window.to_array();
        let [dx, dy] = [to.x() - x, to.y() - y];
        let (left, right, bottom, top) = match self {
            Self::Corner(Corner { right, top }) => (!right, right, !top, top),
            Self::Side(edge) => (
                edge == Edge::Left,
                edge == Edge::Right,
                edge == Edge::Bottom,
                edge == Edge::Top,
            ),
            _ => (true, true, true, true),
        };
        for (moves, side, by) in [
            (left, &mut xmin, dx),
            (right, &mut xmax, dx),
            (bottom, &mut ymin, dy),
            (top, &mut ymax, dy),
        ] {
            if moves {
                *side += by;
            }
        }
        Window::new(xmin, ymin, xmax, ymax)
    }

    /// Does it move with an offset to the pointer, as a whole, and not to a place of its own?
    #[must_use]
    pub const fn is_whole(self) -> bool {
        matches!(self, Self::Segment | Self::Window | Self::Subject)
    }

    /// Is it a vertex of an outline, so that it can be taken out and another put in after it?
    #[must_use]
    pub const fn is_vertex(self) -> bool {
        matches!(
            self,
            Self::Vertex(_) | Self::HoleVertex(..) | Self::ClipVertex(_)
        )
    }

    /// The handle of the vertex after this one's, where it is one; not wrapped round.
    #[must_use]
    pub const fn next(self) -> Self {
        match self {
            Self::Vertex(i) => Self::Vertex(i + 1),
            Self::HoleVertex(hole, i) => Self::HoleVertex(hole, i + 1),
            Self::ClipVertex(i) => Self::ClipVertex(i + 1),
            other => other,
        }
    }

    /// Does the figure draw a mark where it lies, so that the handle needs none?
    #[must_use]
    pub const fn is_marked(self) -> bool {
        matches!(self, Self::End(_))
    }

    /// What it is, for a screen reader.
    #[must_use]
    pub fn name(self) -> Message {
        match self {
            Self::End(End::P1) => Message::new("handle-end").with("end", "P₁".to_owned()),
            Self::End(End::P2) => Message::new("handle-end").with("end", "P₂".to_owned()),
            Self::Segment => Message::new("handle-segment"),
            Self::Corner(corner) => Message::new(corner_key(corner)),
            Self::Side(edge) => {
                Message::new("handle-side").with("edge", Value::Term(edge_key(edge)))
            }
            Self::Window => Message::new("handle-window"),
            Self::ClipVertex(i) => Message::new("handle-clip-vertex").with("number", i + 1),
            Self::Vertex(i) => Message::new("handle-vertex").with("number", i + 1),
            Self::HoleVertex(hole, i) => Message::new("handle-hole-vertex")
                .with("hole", hole + 1)
                .with("number", i + 1),
            Self::Subject => Message::new("handle-polygon"),
        }
    }

    /// The group that a lesson can lock it with.
    #[must_use]
    pub const fn group(self) -> &'static str {
        match self {
            Self::End(End::P1) => "p1",
            Self::End(End::P2) => "p2",
            Self::Segment => "segment",
            Self::Corner(_) | Self::Side(_) | Self::Window => "window",
            Self::ClipVertex(_) => "clip",
            Self::Vertex(_) | Self::HoleVertex(..) | Self::Subject => "polygon",
        }
    }
}

const fn corner_key(Corner { right, top }: Corner) -> &'static str {
    match (right, top) {
        (false, false) => "handle-corner-bottom-left",
        (true, false) => "handle-corner-bottom-right",
        (false, true) => "handle-corner-top-left",
        (true, true) => "handle-corner-top-right",
    }
}

const fn edge_key(edge: Edge) -> &'static str {
    match edge {
        Edge::Left => "edge-left",
        Edge::Right => "edge-right",
        Edge::Bottom => "edge-bottom",
        Edge::Top => "edge-top",
    }
}

/// A group of handles that a lesson can lock.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lock(&'static str);

impl Lock {
    /// What can be locked.
    pub const ALL: [&'static str; 6] = ["p1", "p2", "segment", "window", "clip", "polygon"];

    /// Is this handle locked?
    #[must_use]
    pub fn holds(self, handle: Handle) -> bool {
        handle.group() == self.0
    }
}

impl FromStr for Lock {
    type Err = ();
    fn from_str(name: &str) -> Result<Self, ()> {
        Self::ALL
            .into_iter()
            .find(|&known| known == name)
            .map(Self)
            .ok_or(())
    }
}
