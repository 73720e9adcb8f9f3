//! What can be taken hold of in the lines lab.

use crate::{
    algo::line::End,
    figure::Link,
    geom::{ConvexPolygon, Point, Segment},
    labs::{
        Draggable, Handle, HandleKind,
        window_handles::{self, CLIP_VERTEX},
    },
    text::{Diagnostic, Message},
};

use super::Scene;

static END: [HandleKind; 2] = [
    HandleKind {
        is_marked: true,
        ..HandleKind::new("p1", "p1", |_| end_name("P₁"))
    },
    HandleKind {
        is_marked: true,
        ..HandleKind::new("p2", "p2", |_| end_name("P₂"))
    },
];
static SEGMENT: HandleKind = HandleKind {
    is_whole: true,
    ..HandleKind::new("segment", "segment", |_| Message::new("handle-segment"))
};

fn end_name(symbol: &str) -> Message {
    Message::new("handle-end").with("end", symbol.to_owned())
}

pub fn end(end: End) -> Handle {
    END[end.idx()].at([0, 0])
}

impl Draggable for Scene {
    fn handles(&self) -> Vec<Handle> {
        let mut handles = End::BOTH.map(end).to_vec();
        handles.push(SEGMENT.at([0, 0]));
        match self.polygon_in_use() {
            Some(clip) => {
                handles.extend((0..clip.vertices().len()).map(|i| CLIP_VERTEX.at([i, 0])));
            }
            None => handles.extend(window_handles::handles()),
        }
        handles
    }

    fn seized(&self, link: Link) -> Option<Handle> {
        (link == Link::to("segment")).then(|| SEGMENT.at([0, 0]))
    }

    fn position(&self, handle: Handle) -> Option<[f64; 3]> {
        let focused = self.focused();
        let [i, _] = handle.idx();
        let at = if let Some(end) = end_of(handle) {
            end.of(&focused).to_array()
        } else if handle.is(&SEGMENT) {
            middle(&focused)
        } else if handle.is(&CLIP_VERTEX) {
            self.polygon_in_use()?.vertices().get(i)?.to_array()
        } else {
            return window_handles::position(handle, &self.window);
        };
        Some([at[0], at[1], 0.0])
    }

    fn drag(&mut self, handle: Handle, [x, y, _]: [f64; 3]) -> Result<(), Diagnostic> {
        let to = Point::new(x, y)?;
        let Segment { p1, p2 } = self.focused();
        let [i, _] = handle.idx();
        if let Some(end) = end_of(handle) {
            let moved = match end {
                End::P1 => Segment { p1: to, p2 },
                End::P2 => Segment { p1, p2: to },
            };
            self.set_segment(self.focus(), moved);
        } else if handle.is(&SEGMENT) {
            let [x, y] = middle(&self.focused());
            let [dx, dy] = [to.x() - x, to.y() - y];
            let moved = Segment::new(p1.x() + dx, p1.y() + dy, p2.x() + dx, p2.y() + dy)?;
            self.set_segment(self.focus(), moved);
        } else if handle.is(&CLIP_VERTEX) {
            if let Some(clip) = self.polygon_in_use() {
                let mut outline: Vec<[f64; 2]> = clip.clone().into();
                if let Some(vertex) = outline.get_mut(i) {
                    *vertex = to.to_array();
                }
                self.clip = Some(ConvexPolygon::new(&outline)?);
            }
        } else {
            self.window = window_handles::dragged(handle, &self.window, to)?;
        }
        Ok(())
    }
}

fn end_of(handle: Handle) -> Option<End> {
    End::BOTH.into_iter().find(|&which| end(which) == handle)
}

fn middle(segment: &Segment) -> [f64; 2] {
    let [x1, y1, x2, y2] = segment.to_array();
    [x1.midpoint(x2), y1.midpoint(y2)]
}
