//! Depth over distance: 1/z, with the steps that a format leaves it, forward and reversed.

use crate::{
    algo::surface::{DepthFormat, DepthNumber},
    figure::{Multiples, SmallDrawing, Weight},
};

use super::super::prelude::*;

/// A row of two has far more room to the side than upwards.
const WIDTH: f64 = 6.0;
const POINTS: usize = 64;
/// Of so many steps each is drawn, of more every so-manieth.
const MOST_STEPS: f64 = 16.0;

/// From one depth that can be stored to the next, as a distance in view space.
pub fn step_in_view(rays: &Rays, format: &DepthFormat, depth: f64) -> Option<f64> {
    let distance = |depth: f64| rays.distance(rays.t_at(depth));
    let next = depth + format.step(depth);
    let step = distance(next) - distance(depth);
    (next <= 1.0 && step.is_finite()).then_some(step)
}

pub fn curves(rays: &Rays, format: &DepthFormat, depth: Option<f64>) -> Multiples {
    let drawing = |is_reversed: bool| {
        let format = DepthFormat {
            is_reversed,
            ..*format
        };
        let key = if is_reversed {
            "curve-reversed"
        } else {
            "curve-forward"
        };
        let decimals = |number| Formula::decimals().num(number);
        let note = depth.and_then(|depth| {
            let step = decimals(step_in_view(rays, &format, depth)?);
            let distance = decimals(rays.distance(rays.t_at(depth)));
            let message = Message::new("curve-step").with("step", step);
            Some(Value::Message(message.with("distance", distance)))
        });
        let marks = marks(rays, &format, depth);
        SmallDrawing {
            note,
            ..SmallDrawing::new(Value::Term(key), marks)
        }
    };
    Multiples {
        drawings: vec![drawing(false), drawing(true)],
        bounds: [[0.0, 0.0], [WIDTH, 1.0]],
        is_beside: false,
    }
}

/// Distance to the right, what is stored upwards.
fn marks(rays: &Rays, format: &DepthFormat, depth: Option<f64>) -> Vec<Mark> {
    let [near, far] = rays.ends();
    let place = |depth: f64| {
        let distance = rays.distance(rays.t_at(depth));
        [
            WIDTH * (distance - near) / (far - near),
            format.turned(depth),
        ]
    };
    let line = |points| Weight {
        points,
        strength: 1.0,
    };
    let mut marks = vec![
        Mark::new(
            Role::Soft,
            Shape::Path(vec![[0.0, 1.0], [0.0, 0.0], [WIDTH, 0.0]]),
        )
        .weighing(line(1.0)),
    ];
    // Lines of equal depth: they crowd where distances are large.
    let steps = steps_of(format);
    let levels: Vec<[[f64; 2]; 2]> = steps
        .into_iter()
        .map(|level| {
            let [x, y] = place(level);
            [[x, 0.0], [x, y]]
        })
        .collect();
    marks.push(Mark::new(Role::Soft, Shape::Crowd(levels)).weighing(line(1.0)));
    let curve = (0..=POINTS).map(|i| {
        let t = rays.t_of(near + (far - near) * i as f64 / POINTS as f64);
        place(rays.depth(t))
    });
    marks.push(Mark::new(Role::Accent, Shape::Path(curve.collect())).weighing(line(2.0)));
    if let Some(depth) = depth {
        marks.push(Mark::new(Role::Signal, Shape::Dot(place(depth))).weighing(line(3.5)));
    }
    marks
}

fn steps_of(format: &DepthFormat) -> Vec<f64> {
    let n = match format.number {
        DepthNumber::Fixed(bits) => bits.largest().min(MOST_STEPS),
        DepthNumber::Double | DepthNumber::Single => MOST_STEPS,
    };
    (0..=n as usize).map(|i| i as f64 / n).collect()
}
