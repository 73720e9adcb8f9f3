//! What a person can take hold of on the stage, by mouse or by keyboard.

use std::{fmt, str::FromStr};

use crate::{
    algo::line::End,
    geom::{ConvexPolygon, Edge, GeomError, Point, Segment, Window},
};

use super::Scene;

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
    /// A vertex of the convex clip region.
    Vertex(usize),
}

impl Handle {
    /// All handles that the scene has, in the order in which Tab visits them.
    #[must_use]
    pub fn all(scene: &Scene) -> Vec<Self> {
        let mut handles = vec![Self::End(End::P1), Self::End(End::P2), Self::Segment];
        match scene.polygon_in_use() {
            Some(clip) => handles.extend((0..clip.vertices().len()).map(Self::Vertex)),
            None => {
                for (right, top) in [(false, false), (true, false), (true, true), (false, true)] {
                    handles.push(Self::Corner(Corner { right, top }));
                }
                handles.extend(Edge::ALL.map(Self::Side));
                handles.push(Self::Window);
            }
        }
        handles
    }

    /// Where it lies.
    #[must_use]
    pub fn position(self, scene: &Scene) -> [f64; 2] {
        let segment = scene.focused();
        let (min, max) = (scene.window.min(), scene.window.max());
        let centre = [mean(min.x(), max.x()), mean(min.y(), max.y())];
        match self {
            Self::End(end) => end.of(&segment).to_array(),
            Self::Segment => [
                mean(segment.p1.x(), segment.p2.x()),
                mean(segment.p1.y(), segment.p2.y()),
            ],
            Self::Corner(Corner { right, top }) => [
                if right { max.x() } else { min.x() },
                if top { max.y() } else { min.y() },
            ],
            Self::Side(edge @ (Edge::Left | Edge::Right)) => [scene.window.border(edge), centre[1]],
            Self::Side(edge) => [centre[0], scene.window.border(edge)],
            // Not in the middle, where segments like to have theirs: below it and to the right.
            Self::Window => [mean(centre[0], max.x()), mean(min.y(), centre[1])],
            Self::Vertex(i) => scene
                .polygon_in_use()
                .and_then(|clip| clip.vertices().get(i).copied())
                .map_or(centre, Point::to_array),
        }
    }

    /// Moves the handle to a place, as far as the scene stays valid there.
    ///
    /// # Errors
    /// [`GeomError`] where it would not: the scene is left as it was.
    pub fn drag(self, scene: &mut Scene, [x, y]: [f64; 2]) -> Result<(), GeomError> {
        let to = Point::new(x, y)?;
        let focus = scene.focus();
        match self {
            Self::End(End::P1) => {
                let p2 = scene.focused().p2;
                scene.set_segment(focus, Segment { p1: to, p2 });
            }
            Self::End(End::P2) => {
                let p1 = scene.focused().p1;
                scene.set_segment(focus, Segment { p1, p2: to });
            }
            Self::Segment => {
                let [dx, dy] = self.offset(scene, to);
                let [x1, y1, x2, y2] = scene.focused().to_array();
                scene.set_segment(focus, Segment::new(x1 + dx, y1 + dy, x2 + dx, y2 + dy)?);
            }
            Self::Window | Self::Side(_) | Self::Corner(_) => {
                scene.window = self.drag_window(scene, to)?;
            }
            Self::Vertex(i) => {
                if let Some(clip) = scene.polygon_in_use() {
                    let mut outline: Vec<[f64; 2]> = clip.clone().into();
                    if let Some(vertex) = outline.get_mut(i) {
                        *vertex = to.to_array();
                    }
                    scene.clip = Some(ConvexPolygon::new(&outline)?);
                }
            }
        }
        Ok(())
    }

    fn offset(self, scene: &Scene, to: Point) -> [f64; 2] {
        let [x, y] = self.position(scene);
        [to.x() - x, to.y() - y]
    }

    fn drag_window(self, scene: &Scene, to: Point) -> Result<Window, GeomError> {
        let [mut xmin, mut ymin, mut xmax, mut ymax] = scene.window.to_array();
        let [dx, dy] = self.offset(scene, to);
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
}

fn mean(a: f64, b: f64) -> f64 {
    a.midpoint(b)
}

/// As lesson files spell handles that are locked: `p1`, `p2`, `segment`, `window` (with its sides and
/// corners), `clip` (every vertex of the convex region).
impl fmt::Display for Handle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::End(End::P1) => "p1",
            Self::End(End::P2) => "p2",
            Self::Segment => "segment",
            Self::Corner(_) | Self::Side(_) | Self::Window => "window",
            Self::Vertex(_) => "clip",
        })
    }
}

/// A group of handles that a lesson can lock.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Lock(&'static str);

impl Lock {
    /// What can be locked.
    pub const ALL: [&'static str; 5] = ["p1", "p2", "segment", "window", "clip"];

    /// Is this handle locked?
    #[must_use]
    pub fn holds(self, handle: Handle) -> bool {
        handle.to_string() == self.0
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
