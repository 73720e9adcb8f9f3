//! What several methods side by side show: a picture about what differs between them, and nothing twice.
//!
//! Where all give the same answer they are one drawing, in which what only one of them does is seen beside what all do, and
//! the costs. Where the answers differ the drawings that differ stand beside each other, as large as they can be.

use super::{
    extent::{Need, Stand},
    frame::Frame,
    mark::{Mark, Shape},
    over::over,
    role::Role,
    run::Run,
    small_pictures::{Raster, RasterMark, RasterShape},
    space::Seer,
    values::{Costs, Table},
    view::{Body, View, ViewId},
};
use crate::{text::Value, trace::Counts};

type Outline = Vec<[f64; 2]>;

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
        let agrees = |end: &Frame| end.body(ViewId::AGREEMENT).is_some();
        let is_said = has_raster || ends.iter().all(agrees);
        if is_same_picture && (is_said || others.iter().all(is_same)) {
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

    /// What is drawn live, from what each of these runs wants: of runs that stand apart a small picture is large where nothing
    /// but it differs in the end.
    pub fn needs(self, needs: &[Vec<Need>], runs: &[&dyn Run]) -> Vec<Vec<Need>> {
        let mut needs = self.joined_needs(needs, runs);
        if needs.len() < 2 {
            return needs;
        }
        let ends = ends(runs);
        for needs in &mut needs {
            let mut drawings = needs.iter().filter(|need| need.stand == Stand::Drawing);
            if !drawings.any(|need| differs(&ends, need)) {
                let insets = needs.iter_mut().filter(|need| differs(&ends, need));
                insets.for_each(|need| *need = need.enlarged());
            }
        }
        needs
    }

    /// The same where costs are not shown: what methods ask on their way still stands there, if they say it.
    #[must_use]
    pub fn without_costs(self, mut needs: Vec<Vec<Need>>, runs: &[&dyn Run]) -> Vec<Vec<Need>> {
        if self == Self::Same && first_asked(runs).is_none() {
            for needs in &mut needs {
                needs.retain(|need| need.id != View::COSTS);
            }
        }
        needs
    }

    /// Of methods that are one drawing, what that wants.
    fn joined_needs(self, needs: &[Vec<Need>], runs: &[&dyn Run]) -> Vec<Vec<Need>> {
        match (self, needs) {
            (Self::Same, [first, others @ ..]) => {
                let drawings = first.iter().filter(|need| need.is_drawing());
                let counts = vec![Counts::default(); 1 + others.len()];
                let mut costs = View::costs(Vec::new(), counts).need();
                for table in first_and_last_asked(runs) {
                    let (id, body) = (View::COSTS, Body::Table(table));
                    costs.widen(&View { id, body }.need());
                }
                vec![drawings.copied().chain([costs]).collect()]
            }
            (Self::Over { wrong }, [_, _]) => {
                let own = needs[wrong]
                    .iter()
                    .filter(|need| need.stand != Stand::Across);
                // What both make stands in one list, or table: at the beginning and at the end it is seen how wide that is.
                let steps = [[0; 2], [0, 1].map(|i| runs[i].n_steps())];
                let shown = steps.map(|at| {
                    let [a, b] = [0, 1].map(|i| runs[i].frame(at[i]));
                    if wrong == 0 {
                        over(&a, &b)
                    } else {
                        over(&b, &a)
                    }
                });
                let shown = shown.iter().flat_map(|frame| &frame.views);
                let shown: Vec<Need> = shown.map(View::need).collect();
                let widened = own.map(|&(mut need)| {
                    let id = need.id;
                    let others = needs[1 - wrong].iter().chain(&shown);
                    for more in others.filter(|more| more.id == id) {
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
        let needs = self.joined_needs(needs, runs);
        if needs.len() < 2 {
            return needs;
        }
        let ends = ends(runs);
        let differs = |need: &Need| differs(&ends, need);
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

    /// The same at a step that shows this: what is made stands large, one picture of all methods, or two that are compared.
    /// Who looks on is not in it.
    pub fn needs_at(self, mut needs: Vec<Vec<Need>>, frame: &Frame) -> Vec<Vec<Need>> {
        if let [needs] = &mut needs[..] {
            let is_there = |need: &&Need| frame.body(need.id).is_some();
            let drawings = needs.iter().filter(|need| need.stand == Stand::Drawing);
            let drawings: Vec<ViewId> = drawings.filter(is_there).map(|need| need.id).collect();
            let n_made = if self == Self::Same { 1 } else { 2 };
            let made = &drawings[drawings.len().saturating_sub(n_made)..];
            let is_whole = made.len() == drawings.len();
            needs.retain(|need| match need.stand {
                Stand::Drawing => made.contains(&need.id),
                Stand::Inset => is_whole,
                _ => true,
            });
        }
        needs
    }

    /// The one frame of all methods, of these names; none where each is drawn by itself. What they do not agree about when
    /// all have come to their end is hatched.
    pub fn together(self, frames: &[Frame], names: &[Value], at_end: bool) -> Option<Frame> {
        let (first, others) = match (self, frames) {
            (Self::Same, [first, others @ ..]) => (first, others),
            (Self::Over { wrong }, [_, _]) => {
                return Some(over(&frames[wrong], &frames[1 - wrong]));
            }
            _ => return None,
        };
        let mut frame = together(first, others, names);
        if let (false, Some(table), Some(costs)) = (at_end, asked(frames), frame.views.last_mut()) {
            costs.body = Body::Table(table);
        }
        if at_end {
            for view in &mut frame.views {
                let bodies = frames.iter().filter_map(|frame| frame.body(view.id));
                let bodies: Vec<&Body> = bodies.collect();
                match &mut view.body {
                    Body::Plane(marks) => marks.extend(unlike_areas(&bodies)),
                    Body::Raster(raster) => raster.over.extend(unlike_pixels(&bodies)),
                    _ => {}
                }
            }
        }
        Some(frame)
    }
}

fn differs(ends: &[Frame], need: &Need) -> bool {
    let mut bodies = ends.iter().map(|end| end.body(need.id));
    let first = bodies.next().flatten();
    bodies.any(|body| body != first)
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
        match &mut view.body {
            Body::Plane(marks) => {
                for other in others {
                    let more = other.marks().iter().filter(|mark| !is_there(marks, mark));
                    let more: Vec<Mark> = more.cloned().collect();
                    marks.extend(more);
                }
            }
            Body::Raster(raster) => {
                let others = others.iter().filter_map(|other| other.body(view.id));
                let is_bare = raster.pixels.iter().all(|pixel| pixel.value.is_none());
                others.for_each(|other| look_on(raster, other, is_bare));
            }
            _ => {}
        }
    }
    frame
}

/// What another method is at, in the picture of the first: its outlines, its pixel, and while that is bare, its names.
fn look_on(raster: &mut Raster, other: &Body, is_bare: bool) {
    let Body::Raster(other) = other else {
        return;
    };
    let middle = |[column, row]: [usize; 2]| [column as f64 + 0.5, row as f64 + 0.5];
    let at = other.current.filter(|at| Some(*at) != raster.current);
    let at = at.map(|at| RasterMark {
        role: Role::Signal,
        shape: RasterShape::Ring(middle(at)),
    });
    let more: Vec<RasterMark> = other.over.iter().cloned().chain(at).collect();
    raster.over.extend(more);
    let named = other.pixels.iter().enumerate();
    let named = named.filter_map(|(i, pixel)| Some((i, pixel.value.clone()?)));
    for (i, name) in named.filter(|_| is_bare) {
        let mut known = raster
            .pixels
            .iter()
            .filter_map(|pixel| pixel.value.as_ref());
        let is_new = known.all(|known| *known != name);
        if let Some(pixel) = raster.pixels.get_mut(i).filter(|_| is_new) {
            pixel.value = Some(name);
        }
    }
}

/// What methods ask on their way stands where their costs come to stand, and is widest in the end. Where they do not say it, their
/// ends, which take a run each, are not made.
fn first_and_last_asked(runs: &[&dyn Run]) -> Vec<Table> {
    let first = first_asked(runs);
    let last = first.as_ref().and_then(|_| asked(&ends(runs)));
    first.into_iter().chain(last).collect()
}

fn first_asked(runs: &[&dyn Run]) -> Option<Table> {
    let begun = runs.iter().map(|run| run.frame(run.n_steps().min(1)));
    asked(&begun.collect::<Vec<_>>())
}

/// What each asks on its way, where all say it.
fn asked(frames: &[Frame]) -> Option<Table> {
    let tables = frames.iter().map(|frame| match frame.body(ViewId::ASKED)? {
        Body::Table(table) => Some(table.clone()),
        _ => None,
    });
    let tables = tables.collect::<Option<Vec<_>>>()?.into_iter();
    tables.reduce(|mut table, more| {
        table.rows.extend(more.rows);
        table
    })
}

/// What some methods fill and others do not.
fn unlike_areas(bodies: &[&Body]) -> Option<Mark> {
    let filled = |body: &&Body| match body {
        Body::Plane(marks) => {
            let areas = marks.iter().filter_map(|mark| match &mark.shape {
                Shape::Area(outlines) | Shape::Fill(outlines) => Some(outlines),
                _ => None,
            });
            areas.cloned().collect()
        }
        _ => Vec::new(),
    };
    let filled: Vec<Vec<Vec<Outline>>> = bodies.iter().map(filled).collect();
    let is_everywhere = |area: &&Vec<Outline>| filled.iter().all(|areas| areas.contains(area));
    let unlike = filled.iter().flatten().filter(|area| !is_everywhere(area));
    let outlines: Vec<Outline> = unlike.flatten().cloned().collect();
    (!outlines.is_empty()).then(|| Mark::new(Role::Signal, Shape::Hatch(outlines)))
}

/// The pixels in which not all methods have the same.
fn unlike_pixels(bodies: &[&Body]) -> Vec<RasterMark> {
    let rasters = bodies.iter().filter_map(|body| match body {
        Body::Raster(raster) => Some(raster),
        _ => None,
    });
    let rasters: Vec<&Raster> = rasters.collect();
    let [first, others @ ..] = &rasters[..] else {
        return Vec::new();
    };
    let pixels = first.pixels.iter().enumerate();
    let unlike =
        pixels.filter(|&(i, pixel)| others.iter().any(|it| it.pixels.get(i) != Some(pixel)));
    let place = |i: usize| [i % first.size[0], i / first.size[0]].map(|at| at as f64);
    let mark = |(i, _)| RasterMark {
        role: Role::Signal,
        shape: RasterShape::Hatch(place(i)),
    };
    unlike.map(mark).collect()
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
