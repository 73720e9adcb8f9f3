//! Depth over distance, with what a pixel has been given on both axes; and the same enlarged, where it is a staircase: what
//! lands on one step is as deep.

use crate::{
    algo::surface::DepthFormat,
    figure::{Multiples, SmallDrawing, Weight},
};

use super::{super::prelude::*, numbers::value};

const WIDTH: f64 = 1.7;
const POINTS: usize = 480;
/// What is said of the ends of the axes stands so far off them.
const BESIDE: f64 = 0.02;
/// Around a drawing, for what is written on the axes.
const BOUNDS: [[f64; 2]; 2] = [[-0.24, -0.2], [WIDTH + 0.1, 1.1]];
/// What is enlarged reaches so far beyond what has landed, at least as far as so many steps.
const BEYOND: [f64; 2] = [0.8, 1.7];

/// A fragment that has come, and the triangle's name.
pub struct Landed {
    pub name: Value,
    pub depth: f64,
    pub role: Role,
}

/// From one depth that can be stored to the next, as a distance in view space.
pub fn step_in_view(rays: &Rays, format: &DepthFormat, depth: f64) -> Option<f64> {
    let distance = |depth: f64| rays.distance(rays.t_at(depth));
    let next = depth + format.step(depth);
    let step = distance(next) - distance(depth);
    (next <= 1.0 && step.is_finite()).then_some(step)
}

/// The curve; what is about the fragments that have landed, where they are close to each other; beside it that of another near
/// plane, or, of a reversed buffer, what it would be otherwise.
pub fn curves(
    rays: &Rays,
    format: &DepthFormat,
    landed: &[Landed],
    before: Option<&Rays>,
) -> Multiples {
    let forward = DepthFormat {
        is_reversed: false,
        ..*format
    };
    let curve = |format: &DepthFormat, rays: &Rays| Curve {
        rays: *rays,
        format: *format,
        shown: rays.ends(),
    };
    let near = |key, format: &DepthFormat| {
        let curve = curve(format, rays);
        curve.enlarged(Value::Term(key), landed, curve.about(landed)?)
    };
    let drawings = if let Some(before) = before {
        let earlier: Vec<Landed> = landed.iter().map(|it| it.seen_by(rays, before)).collect();
        // Both are drawn as far as the coarser one needs.
        let reach = curve(format, before).about(&earlier);
        let drawing = |rays: &Rays, landed: &[Landed]| {
            let curve = curve(format, rays);
            let title = Message::new("curve-near").with("near", rays.ends()[0]);
            let title = Value::Message(title);
            let enlarged = reach.and_then(|reach| curve.enlarged(title.clone(), landed, reach));
            enlarged.unwrap_or_else(|| curve.drawing(title, landed))
        };
        vec![drawing(before, &earlier), drawing(rays, landed)]
    } else if format.is_reversed {
        let both = [
            near("curve-forward", &forward),
            near("curve-reversed", format),
        ];
        both.into_iter().flatten().collect()
    } else {
        let whole = || curve(format, rays).drawing(Value::Term("curve-whole"), landed);
        vec![near("curve-enlarged", format).unwrap_or_else(whole)]
    };
    Multiples {
        drawings,
        bounds: BOUNDS,
        tiles: Tiles::Large,
    }
}

#[derive(Clone, Copy)]
struct Curve {
    rays: Rays,
    format: DepthFormat,
    /// The distances that it is drawn between.
    shown: [f64; 2],
}

impl Curve {
    fn distance(&self, depth: f64) -> f64 {
        self.rays.distance(self.rays.t_at(depth))
    }

    /// What is stored at a distance.
    fn stored(&self, distance: f64) -> f64 {
        self.format
            .stored(self.rays.depth(self.rays.t_of(distance)))
    }

    /// From where to where the fragments are told apart, if the format can.
    fn about(&self, landed: &[Landed]) -> Option<[f64; 2]> {
        let depth = landed.last()?.depth;
        let distances = || landed.iter().map(|it| self.distance(it.depth));
        let least = distances().fold(f64::INFINITY, f64::min);
        let most = distances().fold(0.0, f64::max);
        let step = step_in_view(&self.rays, &self.format, depth).unwrap_or_default();
        let reach = (BEYOND[0] * (most - least)).max(BEYOND[1] * step);
        Some([least - reach, most + reach])
    }

    fn enlarged(
        self,
        title: Value,
        landed: &[Landed],
        [from, to]: [f64; 2],
    ) -> Option<SmallDrawing> {
        let [near, far] = self.rays.ends();
        let shown = [from.max(near), to.min(far)];
        let is_closer = shown[1] - shown[0] < 0.5 * (far - near);
        let drawing = Self { shown, ..self }.drawing(title, landed);
        let step = step_in_view(&self.rays, &self.format, landed.last()?.depth).unwrap_or_default();
        let note = Message::new("curve-step").with("step", decimals(step));
        let note = (step > 0.0).then_some((Role::Ink, Value::Message(note)));
        is_closer.then_some(SmallDrawing { note, ..drawing })
    }

    fn drawing(&self, title: Value, landed: &[Landed]) -> SmallDrawing {
        SmallDrawing::new(title, None, self.marks(landed))
    }

    /// Distance to the right, what is stored upwards.
    fn marks(&self, landed: &[Landed]) -> Vec<Mark> {
        let [near, far] = self.shown;
        let ends = self.shown.map(|distance| self.stored(distance));
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let right = |distance: f64| WIDTH * (distance - near) / (far - near);
        let place = |distance: f64, stored: f64| {
            let up = (stored - low) / (high - low).max(f64::MIN_POSITIVE);
            [right(distance), up]
        };
        let axes = vec![[0.0, 1.08], [0.0, 0.0], [WIDTH + 0.08, 0.0]];
        let axis = Mark::new(Role::Soft, Shape::Path(axes)).weighing(Weight::of(1.0));
        // Labels of one place would be one label.
        let beside = |at, toward, text: Value| {
            let mark = Mark::new(Role::Soft, Shape::Label(at));
            mark.labelled(text).toward(toward)
        };
        let mut marks = vec![
            axis,
            beside(
                [0.86 * WIDTH, 0.0],
                [0.0, 1.0],
                Value::Term("curve-distance"),
            ),
            beside([0.0, 1.08], [1.0, 0.0], Value::Term("curve-depth")),
        ];
        let distances = (0..=POINTS).map(|i| near + (far - near) * i as f64 / POINTS as f64);
        let curve = distances.map(|distance| place(distance, self.stored(distance)));
        marks.push(Mark::new(Role::Accent, Shape::Path(curve.collect())).weighing(Weight::of(2.0)));
        if self.shown == self.rays.ends() {
            for distance in self.shown {
                let stored = self.stored(distance);
                let [x, y] = place(distance, stored);
                let far_away = Value::Formula(decimals(distance));
                marks.push(beside([x, -BESIDE], [0.0, -1.0], far_away));
                marks.push(beside(
                    [-BESIDE, y],
                    [-1.0, 0.0],
                    value(&self.format, stored),
                ));
            }
        }
        for it in landed {
            let distance = self.distance(it.depth);
            let stored = self.stored(distance);
            let read = [
                Value::Formula(decimals(distance)),
                value(&self.format, stored),
            ];
            marks.extend(it.marks(place(distance, stored), read));
        }
        marks
    }
}

impl Landed {
    /// The same place, as deep as it is with another near plane.
    fn seen_by(&self, rays: &Rays, other: &Rays) -> Self {
        Self {
            name: self.name.clone(),
            depth: other.depth(other.t_of(rays.distance(rays.t_at(self.depth)))),
            role: self.role,
        }
    }

    /// A dot there, and what is read under it and beside it.
    fn marks(&self, at: [f64; 2], [below, beside]: [Value; 2]) -> Vec<Mark> {
        let tick = |to, toward, text: Value| {
            let drop = Mark::new(self.role, Shape::Segment([at, to])).weighing(Weight::of(1.0));
            let foot = Mark::new(self.role, Shape::Vertex(to)).weighing(Weight::of(2.0));
            [drop.dashed(), foot.labelled(text).toward(toward)]
        };
        let dot = Mark::new(self.role, Shape::Dot(at)).labelled(self.name.clone());
        let ticks = [
            tick([at[0], 0.0], [0.0, -1.0], below),
            tick([0.0, at[1]], [-1.0, 0.0], beside),
        ];
        let ticks = ticks.into_iter().flatten();
        ticks.chain([dot.strong()]).collect()
    }
}

fn decimals(number: f64) -> Formula {
    Formula::decimals().num(number)
}
