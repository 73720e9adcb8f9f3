//! What is on stage whatever the method and the step: the window, and the segments out of focus, which are clipped all at once
//! as a program would.

use crate::{
    algo::line::{
        CyrusBeck, CyrusBeckInput,
        batch::{ClippedSegments, Segments, clip_all},
    },
    figure::Costs,
    geom::{Point, Segment, extent, orientation},
    labs::{Backdrop, prelude::*},
    trace::Counts,
};

use super::{Method, Scene};

impl Backdrop for Scene {
    /// What lies under a step's marks: the clip region of `method`, and the segments out of focus. These show
    /// what becomes of them once the focused one is decided (`at_end`), so as not to answer first.
    fn backdrop(&self, column: usize, at_end: bool) -> Vec<Mark> {
        let method = self.on_stage().nth(column).unwrap_or(self.method);
        let region = self.region(method);
        let outline = region.vertices().iter().map(|p| p.to_array()).collect();
        let mut marks = vec![Mark::new(Role::Ink, Shape::Area(vec![outline])).linked("window")];
        marks.extend(crowd(self, at_end));
        marks.extend(mistaken(self));
        marks
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        let focused = [self.focused()];
        let segments = match self.segments() {
            few if few.len() <= MAX_FITTED => few,
            _ => &focused,
        };
        let region = self.region(self.method);
        let ends = segments.iter().flat_map(|s| [s.p1, s.p2]);
        extent(region.vertices().iter().copied().chain(ends))
    }

    /// All nine places that a point may have to the window are seen.
    fn frame(&self) -> [[f64; 2]; 2] {
        let [min, max] = extent(self.region(self.method).vertices().iter().copied());
        let [least, most] = Backdrop::bounds(self);
        let around = [0, 1].map(|i| AROUND * (max[i] - min[i]));
        [
            [0, 1].map(|i| least[i].min(min[i] - around[i])),
            [0, 1].map(|i| most[i].max(max[i] + around[i])),
        ]
    }

    fn region(&self) -> Option<[[f64; 2]; 2]> {
        let region = self.region(self.method);
        Some(extent(region.vertices().iter().copied()))
    }
}

/// So much of the window's width and height is seen beyond each side, whatever lies there.
const AROUND: f64 = 0.25;

/// Up to this many segments are looked at one by one: a view shows all of them at first. Of more, the one in focus.
pub const MAX_FITTED: usize = 20;

/// Of more the costs are not counted each time.
const MOST_COUNTED: usize = 1000;

impl Scene {
    /// What all segments cost by this method.
    pub fn cost_by(&self, method: Method) -> Counts {
        let segments = self.segments().iter();
        segments.map(|&it| (method.info().cost)(self, it)).sum()
    }

    /// Of segments that are too many to look at each: what all of them cost by each method, the least first.
    pub fn costs_of_all(&self) -> Option<Costs> {
        let is_crowd = (MAX_FITTED + 1..=MOST_COUNTED).contains(&self.segments().len());
        let region = self.region(self.method);
        let of = |method: Method| (self.cost_by(method), method.card().name());
        let methods =
            Method::all_right().filter(|&method| is_crowd && self.region(method) == region);
        let mut costs: Vec<_> = methods.map(of).collect();
        costs.sort_by_key(|(counts, _)| counts.total());
        let (counts, names) = costs.into_iter().unzip();
        is_crowd.then_some(Costs { names, counts })
    }
}

const LETTERS: [&str; 3] = ["Q", "R", "S"];

fn crowd(scene: &Scene, clipped: bool) -> Vec<Mark> {
    let (before, rest) = scene.segments().split_at(scene.focus());
    let given: Vec<Segment> = before.iter().chain(&rest[1..]).copied().collect();
    if given.is_empty() {
        return Vec::new();
    }
    let visible = if clipped {
        clip(scene, &given)
    } else {
        Vec::new()
    };
    let names = names(&given);
    [(Role::Discarded, given), (Role::Accent, visible)]
        .into_iter()
        .map(|(role, segments)| {
            let ends = |s: Segment| [s.p1.to_array(), s.p2.to_array()];
            Mark::new(role, Shape::Crowd(segments.into_iter().map(ends).collect()))
        })
        .chain(names)
        .collect()
}

/// Few of them have names at their ends, as the one in focus has: Q₁ and Q₂, R₁ and R₂.
fn names(given: &[Segment]) -> Vec<Mark> {
    if given.len() > LETTERS.len() {
        return Vec::new();
    }
    let ends = |(segment, letter): (&Segment, &str)| {
        [(segment.p1, 1), (segment.p2, 2)].map(|(at, nth)| {
            let symbol = format!("{letter}{}", subscript(nth));
            Mark::new(Role::Soft, Shape::Vertex(at.to_array())).labelled(name(symbol))
        })
    };
    given.iter().zip(LETTERS).flat_map(ends).collect()
}

/// The piece of what was clipped by mistake, by what is wrong in it, and both of its ends.
fn mistaken(scene: &Scene) -> Vec<Mark> {
    let Some(taken) = scene.mistaken else {
        return Vec::new();
    };
    let right = scene.focused();
    let ends = |of: Segment| [of.p1, of.p2].map(Point::to_array);
    let said = |of: Segment| sym("Δx = ").num(of.p2.x() - of.p1.x());
    let not_so = |what: Value| Message::new("not-so").with("what", what);
    let mut marks = Vec::new();
    for piece in clip(scene, &[taken]) {
        let wrong = Mark::new(Role::Signal, Shape::Segment(ends(piece))).dashed();
        marks.push(wrong.labelled(not_so(said(taken).into())));
        for (at, symbol) in [piece.p1, piece.p2].into_iter().zip(["Q₁", "Q₂"]) {
            let cross = Mark::new(Role::Signal, Shape::Cross(at.to_array()));
            let is_off = orientation(right.p1, right.p2, at).is_ne();
            let off = Message::new("line-not-on-it").with("point", name(symbol));
            marks.extend(is_off.then(|| cross.labelled(not_so(off.into()))));
        }
    }
    let [[x1, y1], [x2, y2]] = ends(right);
    let middle = Shape::Label([x1.midpoint(x2), y1.midpoint(y2)]);
    marks.push(Mark::new(Role::Accent, middle).labelled(said(right)));
    marks
}

fn clip(scene: &Scene, given: &[Segment]) -> Vec<Segment> {
    match scene.polygon_in_use() {
        Some(clip) => {
            let clipped = given.iter().map(|&segment| {
                let clip = clip.clone();
                silent::<CyrusBeck>(&CyrusBeckInput { clip, segment })
            });
            clipped.flatten().collect()
        }
        None => {
            let mut clipped = ClippedSegments::default();
            let segments: Segments = given.iter().copied().collect();
            clip_all(&scene.window, &segments, &mut clipped);
            clipped.iter().flatten().collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::Course;

    #[test]
    fn every_place_around_the_window_is_seen() {
        let course = Course::embedded();
        let scenes = course.lessons.iter().flat_map(|lesson| &lesson.steps);
        let scenes = scenes.filter_map(|step| step.scene.get::<Scene>());
        let mut n = 0;
        for scene in scenes {
            let [min, max] = Backdrop::region(scene).expect("a window");
            let [least, most] = scene.frame();
            for i in 0..2 {
                assert!(least[i] < min[i] && max[i] < most[i]);
            }
            n += 1;
        }
        assert!(n > 50, "{n}");
    }
}
