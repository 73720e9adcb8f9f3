//! A figure's marks as egui shapes.

use egui::{Color32, Painter, Pos2, Shape as Egui, Stroke, Vec2, pos2, vec2};

use crate::{
    figure::{Link, Mark, Role, Shape},
    geom::Axis,
    text::Catalog,
};

use super::{
    Theme, Viewport,
    area::filled,
    checker::textured,
    crowd::crowd,
    fill_cache::{LARGE, filled_large},
    labels::{Anchor, Labels},
};

/// Length of a dash and of the gap after it, in points.
const DASH: [f32; 2] = [6.0, 4.0];
const DOT_RADIUS: f32 = 5.5;
const RING_RADIUS: f32 = 6.5;
/// Length of an arrowhead.
const HEAD: f32 = 9.0;
/// Up to this number, segments out of focus can be told apart.
const FEW_ENOUGH: usize = 2_000;
/// Labels keep off outlines with up to this many edges; no place is left between more.
const FEW_ENOUGH_TO_AVOID: usize = 200;

/// An outline that would take more dashes is drawn as a plain line: no dash could be told from the next.
const MOST_DASHES: f32 = 4_000.0;

/// Draws the marks in order, then their labels where they cover nothing. What is about `lit` stands out.
pub fn stage(
    painter: &Painter,
    viewport: &Viewport,
    theme: &Theme,
    catalog: &Catalog,
    marks: &[Mark],
    lit: Option<Link>,
) {
    let mut stage = Stage {
        painter: &painter.with_clip_rect(viewport.rect),
        viewport,
        theme,
        labels: Labels::new(viewport.rect),
    };
    // Construction lines lie under everything, the window included.
    let (under, over): (Vec<_>, Vec<_>) = marks.iter().partition(|mark| mark.role == Role::Faint);
    for mark in under.into_iter().chain(over) {
        if lit.is_some() && mark.link == lit {
            stage.halo(mark);
        }
        stage.mark(mark);
    }
    stage.labels.draw(stage.painter, theme, catalog);
}

struct Stage<'a> {
    painter: &'a Painter,
    viewport: &'a Viewport,
    theme: &'a Theme,
    labels: Labels<'a>,
}

impl<'a> Stage<'a> {
    fn mark(&mut self, mark: &'a Mark) {
        let (colour, stroke) = (self.colour(mark.role), self.stroke(mark));
        let dashed = mark.is_dashed || matches!(mark.role, Role::Discarded | Role::Faint);
        let anchor = match &mark.shape {
            Shape::Polygon(outline) => {
                let points: Vec<Pos2> = outline.iter().map(|&p| self.at(p)).collect();
                self.polygon(points, stroke);
                None
            }
            Shape::Area(outlines) => {
                self.area(outlines, mark.role, stroke);
                None
            }
            Shape::Outline(outline) => {
                let points = self.on_screen(outline);
                self.ring_of(&points, stroke, dashed);
                None
            }
            Shape::Path(points) => {
                self.path(&self.on_screen(points), stroke, dashed);
                None
            }
            Shape::HalfPlane([a, b]) => {
                let tint = match mark.role {
                    Role::Signal => self.theme.signal,
                    _ => self.theme.accent,
                };
                self.half_plane([self.at(*a), self.at(*b)], tint);
                let ends = self.ends(&Shape::Line([*a, *b]));
                self.line(ends, stroke, false);
                Some(Anchor::Line(ends))
            }
            Shape::Textured(triangles) => {
                let ctx = self.painter.ctx();
                self.painter
                    .add(textured(ctx, self.theme, self.viewport, triangles));
                None
            }
            Shape::Dot(p) => {
                let at = self.at(*p);
                self.dot(at, colour);
                Some(Anchor::Point(at))
            }
            Shape::Ring(p) => {
                let at = self.at(*p);
                self.ring(at, stroke);
                Some(Anchor::Point(at))
            }
            Shape::Cross(p) => {
                let at = self.at(*p);
                for arm in [vec2(4.5, 4.5), vec2(4.5, -4.5)] {
                    self.painter.line_segment([at - arm, at + arm], stroke);
                }
                self.labels.avoid_disc(at, 6.0);
                Some(Anchor::Point(at))
            }
            Shape::Crowd(segments) => {
                self.crowd(segments, mark.role);
                None
            }
            Shape::Region(corners) => Some(Anchor::Inside(self.visible(*corners))),
            Shape::Arrow([a, b]) => {
                let ends = [self.at(*a), self.at(*b)];
                self.line(ends, stroke, false);
                self.head(ends, stroke);
                Some(Anchor::Point(ends[1]))
            }
            Shape::Heading([a, b]) => {
                let [a, b] = [self.at(*a), self.at(*b)];
                let half = (b - a).normalized() * HEAD / 2.0 * self.theme.stroke_scale;
                if a.distance(b) > 3.0 * HEAD {
                    self.head([a, a.lerp(b, 0.5) + half], stroke);
                }
                None
            }
            line => {
                let ends = self.ends(line);
                self.line(ends, stroke, dashed);
                Some(Anchor::Line(ends))
            }
        };
        if let (Some(anchor), Some(label)) = (anchor, &mark.label) {
            let colour = if mark.role == Role::Faint {
                self.theme.faint
            } else {
                colour
            };
            self.labels.add(label, anchor, colour, mark.role);
        }
    }

    fn at(&self, p: [f64; 2]) -> Pos2 {
        self.viewport.to_screen(p)
    }

    fn colour(&self, role: Role) -> Color32 {
        let theme = self.theme;
        match role {
            Role::Ink => theme.ink,
            Role::Soft => theme.soft,
            Role::Faint => theme.hairline,
            Role::Accent => theme.accent,
            Role::Signal => theme.signal,
            Role::Accepted => theme.accepted,
            Role::Discarded => theme.discarded,
        }
    }

    fn stroke(&self, mark: &Mark) -> Stroke {
        let living = matches!(mark.role, Role::Accent | Role::Accepted);
        let width = match (&mark.shape, mark.role) {
            (Shape::Segment(_) | Shape::Path(_), _) if living || mark.is_dashed => 3.0,
            (_, Role::Faint) => 1.0,
            (Shape::Cross(_) | Shape::Segment(_), Role::Discarded) => 1.75,
            _ => 2.0,
        };
        self.theme.stroke(width, self.colour(mark.role))
    }

    /// The ends of a line mark on the screen; lines without ends reach beyond the stage.
    fn ends(&self, shape: &Shape) -> [Pos2; 2] {
        let rect = self.viewport.rect;
        match shape {
            Shape::Border(Axis::X, c) => {
                let x = self.at([*c, 0.0]).x;
                [pos2(x, rect.top()), pos2(x, rect.bottom())]
            }
            Shape::Border(Axis::Y, c) => {
                let y = self.at([0.0, *c]).y;
                [pos2(rect.left(), y), pos2(rect.right(), y)]
            }
            Shape::Line([a, b]) => {
                let [a, b] = [self.at(*a), self.at(*b)];
                let reach = self.reach(a, b);
                [a - reach, b + reach]
            }
            Shape::Ray([a, b]) => {
                let [a, b] = [self.at(*a), self.at(*b)];
                [a, b + self.reach(a, b)]
            }
            Shape::Segment([a, b]) | Shape::Arrow([a, b]) | Shape::HalfPlane([a, b]) => {
                [self.at(*a), self.at(*b)]
            }
            _ => [rect.center(); 2],
        }
    }

    /// A step along a → b that leaves the stage from anywhere on it.
    fn reach(&self, a: Pos2, b: Pos2) -> Vec2 {
        let size = self.viewport.rect.size();
        (b - a).normalized() * (size.x + size.y + (b - a).length())
    }

    fn line(&mut self, ends: [Pos2; 2], stroke: Stroke, dashed: bool) {
        let Some(ends) = cut_to(ends, self.viewport.rect.expand(16.0)) else {
            return;
        };
        if dashed {
            let [dash, gap] = DASH.map(|length| length * self.theme.stroke_scale);
            self.painter
                .extend(Egui::dashed_line(&ends, stroke, dash, gap));
        } else {
            self.painter.line_segment(ends, stroke);
        }
        self.labels.avoid_line(ends);
    }

    fn polygon(&mut self, points: Vec<Pos2>, stroke: Stroke) {
        for (i, &a) in points.iter().enumerate() {
            self.labels.avoid_line([a, points[(i + 1) % points.len()]]);
        }
        self.painter
            .add(Egui::convex_polygon(points, self.theme.accent_wash, stroke));
    }

    fn on_screen(&self, points: &[[f64; 2]]) -> Vec<Pos2> {
        points.iter().map(|&p| self.at(p)).collect()
    }

    /// A wash of the role's colour, and the outlines over it.
    fn area(&mut self, outlines: &[Vec<[f64; 2]>], role: Role, stroke: Stroke) {
        let wash = match role {
            Role::Ink | Role::Accent => self.theme.accent_wash,
            _ => self.colour(role).gamma_multiply(0.12),
        };
        let on_screen: Vec<Vec<Pos2>> = outlines.iter().map(|o| self.on_screen(o)).collect();
        let is_large = outlines.iter().map(Vec::len).sum::<usize>() >= LARGE;
        self.painter.add(if is_large {
            filled_large(self.painter.ctx(), self.viewport, outlines, wash)
        } else {
            filled(&on_screen, wash)
        });
        for outline in &on_screen {
            self.ring_of(outline, stroke, role == Role::Discarded);
        }
    }

    fn ring_of(&mut self, points: &[Pos2], stroke: Stroke, dashed: bool) {
        if points.len() <= FEW_ENOUGH_TO_AVOID {
            for (i, &a) in points.iter().enumerate() {
                self.labels.avoid_line([a, points[(i + 1) % points.len()]]);
            }
        }
        let [dash, gap] = DASH.map(|length| length * self.theme.stroke_scale);
        let ring = || -> Vec<Pos2> { points.iter().chain(points.first()).copied().collect() };
        if dashed && length_of(&ring()) <= MOST_DASHES * (dash + gap) {
            self.painter
                .extend(Egui::dashed_line(&ring(), stroke, dash, gap));
        } else {
            self.painter.add(Egui::closed_line(points.to_vec(), stroke));
        }
    }

    fn path(&mut self, points: &[Pos2], stroke: Stroke, dashed: bool) {
        if points.len() > FEW_ENOUGH_TO_AVOID {
            self.painter.add(Egui::line(points.to_vec(), stroke));
            return;
        }
        for ends in points.windows(2) {
            self.line([ends[0], ends[1]], stroke, dashed);
        }
    }

    /// Shades what lies to the left of a → b on the world's plane: to the right on the screen's, where y
    /// points down and left and right are as seen along the line.
    fn half_plane(&self, [a, b]: [Pos2; 2], colour: Color32) {
        let along = self.reach(a, b);
        let left = vec2(along.y, -along.x);
        let corners = [a - along, b + along, b + along + left, a - along + left];
        self.painter.add(Egui::convex_polygon(
            corners.to_vec(),
            colour.gamma_multiply(0.08),
            Stroke::NONE,
        ));
    }

    fn crowd(&self, segments: &[[[f64; 2]; 2]], role: Role) {
        // The more there are, the quieter each is: the focused segment stays in front.
        let strength = match segments.len() {
            ..=50 => 0.55,
            51..=FEW_ENOUGH => 0.35,
            // So many cover every point several times over: what lies beneath still shows.
            n => 0.35 * (FEW_ENOUGH as f32 / n as f32).powf(0.75),
        };
        let width = if role == Role::Accent { 2.0 } else { 1.0 };
        let colour = self.colour(role).gamma_multiply(strength);
        let stroke = self.theme.stroke(width, colour);
        crowd(self.painter, self.viewport, segments, stroke);
    }

    fn dot(&mut self, at: Pos2, colour: Color32) {
        let radius = DOT_RADIUS * self.theme.stroke_scale.sqrt();
        // A rim in the background's colour sets the dot off from the lines that meet in it.
        self.painter
            .circle_filled(at, radius + 2.0, self.theme.background);
        self.painter.circle_filled(at, radius, colour);
        self.labels.avoid_disc(at, radius + 2.0);
    }

    fn ring(&mut self, at: Pos2, stroke: Stroke) {
        let radius = RING_RADIUS * self.theme.stroke_scale.sqrt();
        self.painter
            .circle(at, radius, self.theme.background, stroke);
        self.labels.avoid_disc(at, radius + 1.0);
    }

    fn head(&self, [a, b]: [Pos2; 2], stroke: Stroke) {
        let along = (b - a).normalized() * HEAD * self.theme.stroke_scale;
        let across = along.rot90() * 0.45;
        self.painter.add(Egui::convex_polygon(
            vec![b, b - along + across, b - along - across],
            stroke.color,
            Stroke::NONE,
        ));
    }

    fn halo(&self, mark: &Mark) {
        let glow = self.theme.stroke(9.0, self.theme.accent_wash);
        match &mark.shape {
            Shape::Dot(p) | Shape::Ring(p) | Shape::Cross(p) => {
                let radius = (RING_RADIUS + 6.0) * self.theme.stroke_scale.sqrt();
                let [fill, rim] = [self.theme.accent_wash, self.theme.accent];
                self.painter
                    .circle(self.at(*p), radius, fill, self.theme.stroke(1.5, rim));
            }
            Shape::Polygon(_)
            | Shape::Area(_)
            | Shape::Outline(_)
            | Shape::Path(_)
            | Shape::Region(_)
            | Shape::Textured(_)
            | Shape::Heading(_)
            | Shape::Crowd(_) => {}
            line => {
                if let Some(ends) = cut_to(self.ends(line), self.viewport.rect.expand(16.0)) {
                    self.painter.line_segment(ends, glow);
                }
            }
        }
    }

    /// The part of a world rectangle, possibly without end, that is on the stage.
    fn visible(&self, [a, b]: [[f64; 2]; 2]) -> egui::Rect {
        let rect = self.viewport.rect;
        let along = |i: usize, value: f64, min: f32, max: f32| {
            if value == f64::NEG_INFINITY {
                if i == 0 { min } else { max }
            } else if value == f64::INFINITY {
                if i == 0 { max } else { min }
            } else {
                let at = self.at([value, value]);
                let on_screen = if i == 0 { at.x } else { at.y };
                on_screen.clamp(min, max)
            }
        };
        let x = [a[0], b[0]].map(|v| along(0, v, rect.left(), rect.right()));
        let y = [b[1], a[1]].map(|v| along(1, v, rect.top(), rect.bottom()));
        egui::Rect::from_min_max(pos2(x[0], y[0]), pos2(x[1], y[1]))
    }
}

fn length_of(points: &[Pos2]) -> f32 {
    points
        .windows(2)
        .map(|ends| ends[0].distance(ends[1]))
        .sum()
}

/// The part of a line that is inside a rectangle on the screen, so that dashes of lines that reach far
/// beyond it are not laid in vain. Runs on this crate's own clipper.
pub(super) fn cut_to([a, b]: [Pos2; 2], rect: egui::Rect) -> Option<[Pos2; 2]> {
    use crate::{
        algo::line::kernel,
        geom::{Segment, Window},
    };
    let [left, top, right, bottom] =
        [rect.left(), rect.top(), rect.right(), rect.bottom()].map(f64::from);
    let window = Window::new(left, top, right, bottom).ok()?;
    let [ax, ay, bx, by] = [a.x, a.y, b.x, b.y].map(f64::from);
    let segment = Segment::new(ax, ay, bx, by).ok()?;
    let visible = kernel::clip(&window, &segment)?;
    Some([visible.p1, visible.p2].map(|p| pos2(p.x() as f32, p.y() as f32)))
}
