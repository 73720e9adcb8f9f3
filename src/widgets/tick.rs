//! The shape of an event's tick: its kind is seen without colour.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2, vec2};

use crate::{figure::Tick, paint::Theme};

/// How a tick stands to the present step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum When {
    /// It has happened.
    Past,
    /// It is this step.
    Now,
    /// It has yet to happen.
    Future,
    /// It has yet to happen, and what it is must not be given away.
    Untold,
}

/// A dot, for whatever will happen.
const UNTOLD: f32 = 2.5;

/// Draws a tick; `size` is 1 where there is room, less in a crowd. `surface` shows through hollow ticks.
pub fn draw(
    painter: &Painter,
    at: Pos2,
    tick: Tick,
    when: When,
    size: f32,
    theme: &Theme,
    surface: Color32,
) {
    let colour = match (when, tick) {
        (When::Now, _) => theme.signal,
        (When::Past, _) => theme.accent,
        (When::Future | When::Untold, _) => theme.faint,
    };
    if when == When::Untold {
        painter.circle_filled(at, UNTOLD * size, colour);
        return;
    }
    let is_hollow = when == When::Future;
    let fill = if is_hollow { surface } else { colour };
    let stroke = Stroke::new(1.5, colour);
    let r = 4.5 * size;
    match tick {
        Tick::Test => {
            // One shape each: a stroke over a fill of its own colour shows as a rim.
            if is_hollow {
                painter.circle(at, r, fill, stroke);
            } else {
                painter.circle_filled(at, r + 0.75, fill);
            }
        }
        Tick::Cut => {
            let r = r * if is_hollow { 1.4 } else { 1.6 };
            let points = [vec2(0.0, -r), vec2(r, 0.0), vec2(0.0, r), vec2(-r, 0.0)];
            let points = points.map(|v| at + v).to_vec();
            let rim = if is_hollow { stroke } else { Stroke::NONE };
            painter.add(Shape::convex_polygon(points, fill, rim));
        }
        Tick::Accept => accept(painter, at, r * 1.15, when, stroke, theme, surface),
        Tick::Reject => {
            // The line of the track must not cross the cross out.
            painter.circle_filled(at, r * 1.5, surface);
            let stroke = Stroke::new(2.0, colour);
            for y in [-r, r] {
                painter.line_segment([at + vec2(-r, -y), at + vec2(r, y)], stroke);
            }
        }
        Tick::Phase => {
            let bar = Rect::from_center_size(at, vec2(4.0 * size, 13.0 * size));
            let rim = if is_hollow { stroke } else { Stroke::NONE };
            painter.rect(bar, 1.0, fill, rim, StrokeKind::Middle);
        }
    }
    if when == When::Now {
        let ring = Stroke::new(1.5, theme.signal);
        painter.circle_stroke(at, (7.5 * size).max(5.0) + 4.0, ring);
    }
}

/// A square with a check mark; green once it has happened.
fn accept(
    painter: &Painter,
    at: Pos2,
    r: f32,
    when: When,
    stroke: Stroke,
    theme: &Theme,
    surface: Color32,
) {
    let square = Rect::from_center_size(at, Vec2::splat(2.0 * r));
    if when == When::Future {
        painter.rect(square, 2.5, surface, stroke, StrokeKind::Middle);
        return;
    }
    let fill = theme.accepted;
    painter.rect(
        square.expand(1.0),
        2.5,
        fill,
        Stroke::NONE,
        StrokeKind::Middle,
    );
    let check = [vec2(-0.5, 0.0), vec2(-0.12, 0.4), vec2(0.55, -0.4)];
    let check = check.map(|v| at + v * r).to_vec();
    painter.add(Shape::line(check, Stroke::new(1.75, surface)));
}
