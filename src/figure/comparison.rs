//! What several methods side by side show: a picture about what differs between them, and nothing twice.
//!
//! Where all give the same answer they are one drawing, in which what only one of them does is seen beside what all do, and
//! the costs. Where the answers differ the drawings that differ stand beside each other, as large as they can be.

use super::{
    extent::{Need, Stand},
    frame::Frame,
    mark::Mark,
    over::over,
    run::Run,
    space::Seer,
    values::Costs,
    view::{Body, View, ViewId},
};
use crate::{text::Value, trace::Counts};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Comparison {
    /// Nothing is compared, or what differs is not known.
    Apart,
    Same,
    /// Of two the one at this place is wrong on purpose, and what it does lies over what is right.
    Over {
        wrong: usize,
    },
}

impl Comparison {
    /// Of these runs. What makes a picture answers with it.
    pub fn between(runs: &[&dyn Run]) -> Self {
        let [first, others @ ..] = runs else {
            return Self::Apart;
        };
        if others.is_empty() || runs.iter().any(|run| run.is_refused()) {
            return Self::Apart;
        }
        let ends = ends(runs);
        let pictures = |end: &Frame| {
            let bodies = end.views.iter().map(|view| &view.body);
            let made = bodies.filter(|body| match body {
                Body::Raster(_) => true,
                Body::Space(space) => matches!(space.seer, Seer::Camera(_)),
                _ => false,
            });
            made.cloned().collect::<Vec<Body>>()
        };
        let made = pictures(&ends[0]);
        let is_same_picture = ends.iter().all(|end| pictures(end) == made);
        let is_same = |run: &&dyn Run| run.output_json() == first.output_json();
        let has_raster = made.iter().any(|body| matches!(body, Body::Raster(_)));
        if is_same_picture && (has_raster || others.iter().all(is_same)) {
            Self::Same
        } else {
            Self::Apart
        }
    }

    /// Of two runs of which the one at this place is wrong: in one frame where both draw the same things, and make no picture of
    /// their own.
    pub fn over(runs: &[&dyn Run], wrong: usize) -> Self {
        let ends = ends(runs);
        let ids = |end: &Frame| end.views.iter().map(|view| view.id).collect::<Vec<_>>();
        let is_drawn = |view: &View| {
            matches!(
                view.body,
                Body::Plane(_) | Body::Space(_) | Body::Lists(_) | Body::Ribbon(_)
            )
        };
        let is_one = |[a, b]: &[Frame; 2]| ids(a) == ids(b) && a.views.iter().all(is_drawn);
        match <[Frame; 2]>::try_from(ends) {
            Ok(ends) if is_one(&ends) => Self::Over { wrong },
            _ => Self::Apart,
        }
    }

    /// What is drawn live, from what each run wants.
    pub fn needs(self, needs: &[Vec<Need>]) -> Vec<Vec<Need>> {
        match (self, needs) {
            (Self::Same, [first, others @ ..]) => {
                let drawings = first.iter().filter(|need| need.is_drawing());
                let counts = vec![Counts::default(); 1 + others.len()];
                let costs = View::costs(Vec::new(), counts);
                vec![drawings.copied().chain([costs.need()]).collect()]
            }
            (Self::Over { wrong }, [_, _]) => {
                // How much is left is not what differs.
                let own = needs[wrong]
                    .iter()
                    .filter(|need| need.stand != Stand::Across);
                let widened = own.map(|&(mut need)| {
                    let mut others = needs[1 - wrong].iter();
                    if let Some(more) = others.find(|more| more.id == need.id) {
                        need.widen(more);
                    }
                    need
                });
                vec![widened.collect()]
            }
            _ => needs.to_vec(),
        }
    }

    /// What is drawn on a page, whose drawings nobody turns: of runs that stand apart what differs in the end, and of
    /// several such drawings the last one, which is what the methods make.
    pub fn needs_of_page(self, needs: &[Vec<Need>], runs: &[&dyn Run]) -> Vec<Vec<Need>> {
        let mut needs = self.needs(needs);
        if let [needs] = &mut needs[..] {
            // What is made stands large: one picture of all methods, or two that are compared. Who looks on is not in it.
            let drawings = needs.iter().filter(|need| need.stand == Stand::Drawing);
            let drawings: Vec<ViewId> = drawings.map(|need| need.id).collect();
            let n_made = if self == Self::Same { 1 } else { 2 };
            if let Some(unmade @ 1..) = drawings.len().checked_sub(n_made) {
                let made = &drawings[unmade..];
                needs.retain(|need| !need.is_drawing() || made.contains(&need.id));
            }
        }
        if needs.len() < 2 {
            return needs;
        }
        let ends = ends(runs);
        let differs = |need: &Need| {
            let mut bodies = ends.iter().map(|end| end.body(need.id));
            let first = bodies.next().flatten();
            bodies.any(|body| body != first)
        };
        let different = |needs: &Vec<Need>| {
            let drawings = || needs.iter().filter(|need| need.is_drawing());
            let drawn = drawings().rfind(|need| need.stand == Stand::Drawing && differs(need));
            let drawn = drawn.or_else(|| drawings().rfind(|need| differs(need)));
            let drawn = drawn.or_else(|| drawings().next()).map(|need| need.id);
            let is_shown = |need: &&Need| {
                if need.is_drawing() {
                    Some(need.id) == drawn
                } else {
                    differs(need)
                }
            };
            needs.iter().filter(is_shown).copied().collect()
        };
        needs.iter().map(different).collect()
    }

    /// The one frame of all methods, of these names; none where each is drawn by itself.
    pub fn together(self, frames: &[Frame], names: &[Value]) -> Option<Frame> {
        match (self, frames) {
            (Self::Same, [first, others @ ..]) => Some(together(first, others, names)),
            (Self::Over { wrong }, [_, _]) => Some(over(&frames[wrong], &frames[1 - wrong])),
            _ => None,
        }
    }
}

fn ends(runs: &[&dyn Run]) -> Vec<Frame> {
    runs.iter().map(|run| run.frame(run.n_steps())).collect()
}

fn together(first: &Frame, others: &[Frame], names: &[Value]) -> Frame {
    let mut frame = first.clone();
    let counts = [first].into_iter().chain(others).map(|frame| frame.counts);
    let costs = View::costs(names.to_vec(), counts.collect());
    frame.views.retain(|view| view.need().is_drawing());
    frame.views.push(costs);
    for view in &mut frame.views {
        let Body::Plane(marks) = &mut view.body else {
            continue;
        };
        for other in others {
            let more = other.marks().iter().filter(|mark| !is_there(marks, mark));
            let more: Vec<Mark> = more.cloned().collect();
            marks.extend(more);
        }
    }
    frame
}

/// What has the same shape is one thing, however it is named.
fn is_there(marks: &[Mark], mark: &Mark) -> bool {
    marks.iter().any(|known| known.shape == mark.shape)
}

impl View {
    const COSTS: ViewId = ViewId("costs");

    fn costs(names: Vec<Value>, counts: Vec<Counts>) -> Self {
        let body = Body::Costs(Costs { names, counts });
        let id = Self::COSTS;
        Self { id, body }
    }
}
