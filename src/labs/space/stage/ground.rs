//! A grid under everything, and where things stand over it.

use super::{
    super::{Object, Scene},
    prelude::*,
};

/// At most so many lines a direction.
const MOST_LINES: f64 = 16.0;
/// Beyond so many objects a line down from each tells nothing.
const MOST_DROPPED: usize = 24;

pub fn ground(scene: &Scene) -> Vec<Mark3> {
    let corners = scene.culler().corners_in_world();
    let [position, ..] = scene.camera.places();
    let objects = if scene.shows_objects() {
        scene.objects()
    } else {
        &[]
    };
    let middles = || objects.iter().map(Object::at);
    let mut min = position;
    let mut max = position;
    for at in corners.into_iter().chain(middles()) {
        for i in 0..3 {
            min[i] = min[i].min(at[i]);
            max[i] = max[i].max(at[i]);
        }
    }
    // What stands on y = 0 stands on the ground; where something is lower, the ground is.
    let lows = objects.iter().filter_map(|object| object.bounds().ok());
    let level = lows.map(|bounds| bounds.min()[1]).fold(0.0, f64::min);
    let size = (max[0] - min[0]).max(max[2] - min[2]);
    let step = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0]
        .into_iter()
        .find(|step| size / step <= MOST_LINES)
        .unwrap_or(1000.0);
    let [low, high] = [min, max].map(|at| [at[0], at[2]]);
    let low = low.map(|x| (x / step).floor() * step);
    let high = high.map(|x| (x / step).ceil() * step);
    let line = |a: [f64; 2], b: [f64; 2]| {
        let ends = [a, b].map(|[x, z]| [x, level, z]);
        Mark3::new(Role::Faint, Shape3::Segment(ends)).fine()
    };
    let mut marks = Vec::new();
    let n = |i: usize| ((high[i] - low[i]) / step).round().min(4.0 * MOST_LINES) as usize;
    for i in 0..=n(0) {
        let x = low[0] + i as f64 * step;
        marks.push(line([x, low[1]], [x, high[1]]));
    }
    for i in 0..=n(1) {
        let z = low[1] + i as f64 * step;
        marks.push(line([low[0], z], [high[0], z]));
    }
    let dropped = middles().take(MOST_DROPPED).chain([position]);
    marks.extend(dropped.map(|[x, y, z]| {
        let down = Shape3::Segment([[x, y, z], [x, level, z]]);
        Mark3::new(Role::Soft, down).fine()
    }));
    marks
}
