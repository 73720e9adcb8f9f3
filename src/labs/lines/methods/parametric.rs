//! The interval of a parameter on the segment: its picture on the stage. Nothing here knows against what is clipped.

use crate::{
    algo::{line::End, segment::VisibleLine},
    figure::{Mark, Role, Shape, Side},
    geom::{Point, Segment},
    labs::{
        interval::{ShownCrossing, ShownInterval},
        words::name,
    },
    text::Formula,
};

use super::shared::{point, segment_marks};

/// The interval as the stage shows it.
pub struct SegmentInterval {
    /// What is left.
    pub shown: ShownInterval,
    /// What a crossing's parameter is called: `r` or `t`.
    pub crossing_symbol: &'static str,
    /// The answer, once known.
    pub verdict: Option<VisibleLine<2>>,
    /// Is the segment's line drawn beyond its ends, with the crossings there?
    pub goes_on: bool,
    /// At this step the segment is seen as a vector of this name, from P₁ to P₂.
    pub vector: Option<&'static str>,
}

impl SegmentInterval {
    /// The segment with the part that is left standing out, and the crossings on it.
    pub fn marks(&self, segment: &Segment) -> Vec<Mark> {
        if let Some(Some(visible)) = self.verdict {
            return segment_marks(segment, visible.map(point), Some(true));
        }
        let mut marks = self.parts(segment);
        for crossing in &self.shown.crossings {
            let at = on_line(segment, crossing.at);
            let is_drawn = self.goes_on || (0.0..=1.0).contains(&crossing.at);
            let on_end = End::BOTH.iter().any(|end| end.of(segment).to_array() == at);
            let mark = if crossing.holds {
                self.bound_mark(crossing, segment)
            } else if crossing.current {
                let label = Formula::default()
                    .sym(self.crossing_symbol)
                    .sym(" = ")
                    .ratio(crossing.quotient.num, crossing.quotient.den);
                Mark::new(Role::Signal, Shape::Cross(at))
                    .labelled(label)
                    .strong()
            } else if on_end || !is_drawn {
                // The end itself is enough; a cross on no line says nothing.
                continue;
            } else {
                Mark::new(Role::Discarded, Shape::Cross(at))
            };
            marks.push(mark.linked(crossing.link));
        }
        marks
    }

    /// A bound where it stands on the segment, with what it is.
    fn bound_mark(&self, crossing: &ShownCrossing, segment: &Segment) -> Mark {
        let at = on_line(segment, crossing.at);
        let role = match (crossing.current, self.shown.is_crossed_over()) {
            (true, _) => Role::Signal,
            (false, true) => Role::Ink,
            (false, false) => Role::Accent,
        };
        let label = Formula::default()
            .sym(self.shown.bound_symbol(crossing.side))
            .sym(" = ")
            .ratio(crossing.quotient.num, crossing.quotient.den);
        // The bound allows what comes after u_min and before u_max.
        let allowed = match crossing.side {
            Side::Entering => segment.p2,
            Side::Leaving => segment.p1,
        };
        let head = Shape::Bound([at, allowed.to_array()]);
        Mark::new(role, head).labelled(label).strong()
    }

    /// All of the segment is still there, only the bounds move: what is left stands out. Where they have passed each
    /// other, the part between them is crossed over.
    fn parts(&self, segment: &Segment) -> Vec<Mark> {
        let ends = [segment.p1, segment.p2];
        let crossed = self.shown.is_crossed_over();
        let verdict = self.verdict.or(crossed.then_some(None));
        let is_visible = verdict.map(|visible| visible.is_some());
        let mut marks = segment_marks(segment, ends, is_visible);
        let [from, to] = self.shown.bounds;
        let between = [from, to].map(|u| on_line(segment, u));
        if crossed {
            let middle = on_line(segment, from.midpoint(to));
            marks.push(Mark::new(Role::Signal, Shape::Segment(between)));
            marks.push(Mark::new(Role::Signal, Shape::Cross(middle)));
        } else if verdict.is_none() && self.shown.bounds != [0.0, 1.0] {
            marks[0] = Mark::new(Role::Discarded, Shape::Segment(ends.map(Point::to_array)));
            marks.insert(
                1,
                Mark::new(Role::Accent, Shape::Segment(between)).linked("segment"),
            );
        }
        if let (Some(symbol), None) = (self.vector, verdict) {
            let arrow = Mark::new(Role::Accent, Shape::Arrow(ends.map(Point::to_array)));
            if self.shown.bounds == [0.0, 1.0] {
                marks[0] = marks[0].clone().labelled(name(symbol)).strong();
                marks.insert(1, arrow);
            } else {
                marks[0] = arrow.dashed();
                marks[1] = marks[1].clone().labelled(name(symbol)).strong();
            }
        }
        marks
    }
}

/// P(u), to place a mark: the algorithm itself never computes points that it does not put out.
pub fn on_line(segment: &Segment, u: f64) -> [f64; 2] {
    let [x1, y1, x2, y2] = segment.to_array();
    [x1 + u * (x2 - x1), y1 + u * (y2 - y1)]
}
