//! Finding places for labels: near their anchor, covering nothing, inside the stage.
//!
//! Every label has a short list of candidate places. Labels are placed one by one, this step's first;
//! each takes the candidate that covers least of the lines, points and labels that are there already.

use std::sync::Arc;

use egui::{Color32, FontFamily, FontId, Galley, Painter, Pos2, Rect, Vec2, pos2, vec2};

use crate::{
    figure::{Label, Mark, Role, Shape},
    text::Catalog,
};

use super::{
    Theme, Viewport,
    fonts::semibold,
    layers::Piece,
    parts::{Part, parts, visible},
    pen::{Pen, radius},
};

/// More labels than this would cover the figure, and finding places for them would take longer than a frame.
const MOST_LABELS: usize = 160;
/// More lines than this are in the way of any place; nor do more points matter.
const MOST_AVOIDED: usize = 1_000;

/// What a label belongs to.
#[derive(Clone, Copy, Debug)]
pub enum Anchor {
    /// Beside a point.
    Point(Pos2),
    /// Along a line.
    Line([Pos2; 2]),
    /// Anywhere in a rectangle, best in its middle.
    Inside(Rect),
}

/// Labels waiting for a place, and what they must not cover.
pub struct Labels {
    stage: Rect,
    lines: Vec<[Pos2; 2]>,
    discs: Vec<(Pos2, f32)>,
}

impl Labels {
    /// With what they must not cover.
    pub fn new(viewport: &Viewport, theme: &Theme, pieces: &[Piece<'_>]) -> Self {
        let mut labels = Self {
            stage: viewport.rect,
            lines: Vec::new(),
            discs: Vec::new(),
        };
        for Piece { mark, part, .. } in pieces {
            match part {
                Part::Stroke(points) | Part::Ring(points) => {
                    labels.lines.extend(points.windows(2).map(|e| [e[0], e[1]]));
                    if let (Part::Ring(_), Some(&a), Some(&b)) =
                        (part, points.first(), points.last())
                    {
                        labels.lines.push([b, a]);
                    }
                }
                Part::Arrow(ends) | Part::Head(ends) => labels.lines.push(*ends),
                Part::Marker(marker, at) => {
                    labels.discs.push((*at, radius(theme, *marker, mark.role)));
                }
                Part::Wash(_) | Part::Fill(_) | Part::Texture(_) | Part::Crowd(_) => {}
            }
        }
        labels.lines.truncate(MOST_AVOIDED);
        labels.discs.truncate(MOST_AVOIDED);
        labels
    }

    /// Places and draws them, this step's first.
    pub fn draw(
        &self,
        painter: &Painter,
        viewport: &Viewport,
        theme: &Theme,
        catalog: &Catalog,
        marks: &[Mark],
    ) {
        let mut waiting: Vec<(&Label, Anchor, Color32, Role)> = Vec::new();
        for mark in marks {
            let anchor = anchor(viewport, &mark.shape);
            if let (Some(anchor), Some(label)) = (anchor, &mark.label) {
                waiting.push((label, anchor, Pen::of(theme, mark).text, mark.role));
            }
        }
        // This step's labels choose first, those that can stand anywhere choose last.
        waiting.sort_by_key(|(label, anchor, _, role)| match (role, anchor) {
            (_, Anchor::Inside(_)) => 3,
            (Role::Signal, _) => 0,
            _ if label.strong => 1,
            _ => 2,
        });
        let mut placed: Vec<Rect> = Vec::new();
        for &(label, anchor, colour, _) in waiting.iter().take(MOST_LABELS) {
            let text = catalog.value(&label.text);
            let galley = painter.layout_no_wrap(text, font(label, theme), colour);
            let place = self.best(&galley, anchor, &placed);
            placed.push(place);
            painter.galley(place.min, galley, colour);
        }
    }

    fn best(&self, galley: &Arc<Galley>, anchor: Anchor, placed: &[Rect]) -> Rect {
        let size = galley.size();
        let mut best = Rect::from_center_size(self.stage.center(), size);
        let mut least = f32::INFINITY;
        for (order, centre) in candidates(anchor, size, self.stage).into_iter().enumerate() {
            let place = Rect::from_center_size(centre, size);
            // Earlier candidates are nicer: a later one must be clearly freer.
            let cost = self.covered(place, placed) + order as f32 * 0.4;
            if cost < least {
                (least, best) = (cost, place);
            }
        }
        // Whole pixels keep the text crisp.
        best.translate(best.min.round() - best.min)
    }

    /// How much a label at this place would cover, roughly in points of line.
    fn covered(&self, place: Rect, placed: &[Rect]) -> f32 {
        let near = place.expand(3.0);
        let lines: f32 = self.lines.iter().map(|&line| length_in(line, near)).sum();
        let discs = self
            .discs
            .iter()
            .filter(|(centre, radius)| near.distance_to_pos(*centre) < *radius)
            .count();
        let labels: f32 = placed
            .iter()
            .map(|other| near.intersect(*other))
            .filter(Rect::is_positive)
            .map(|overlap| 60.0 + overlap.area())
            .sum();
        let outside = if self.stage.shrink(4.0).contains_rect(place) {
            0.0
        } else {
            400.0
        };
        lines * 2.0 + discs as f32 * 60.0 + labels * 2.0 + outside
    }
}

fn anchor(viewport: &Viewport, shape: &Shape) -> Option<Anchor> {
    if let Shape::Region(corners) = shape {
        return Some(Anchor::Inside(visible(viewport, *corners)));
    }
    parts(viewport, shape)
        .into_iter()
        .find_map(|part| match part {
            Part::Stroke(points) => match points[..] {
                [a, b] => Some(Anchor::Line([a, b])),
                _ => None,
            },
            Part::Arrow([_, at]) | Part::Marker(_, at) => Some(Anchor::Point(at)),
            _ => None,
        })
}

fn font(label: &Label, theme: &Theme) -> FontId {
    let (size, family) = match (label.mono, label.strong) {
        (true, _) => (14.0, FontFamily::Monospace),
        (false, true) => (13.0, semibold()),
        (false, false) => (13.0, FontFamily::Proportional),
    };
    FontId::new(size * theme.text_scale, family)
}

/// Centres of a label's possible places, the nicest first.
fn candidates(anchor: Anchor, size: Vec2, stage: Rect) -> Vec<Pos2> {
    let half = size * 0.5;
    match anchor {
        Anchor::Point(at) => {
            let sides = [
                vec2(1.0, 0.0),
                vec2(1.0, -1.0),
                vec2(1.0, 1.0),
                vec2(-1.0, 0.0),
                vec2(0.0, -1.0),
                vec2(0.0, 1.0),
                vec2(-1.0, -1.0),
                vec2(-1.0, 1.0),
            ];
            [12.0, 18.0, 28.0]
                .into_iter()
                .flat_map(|gap| {
                    sides.map(|side| {
                        let corner = side.x != 0.0 && side.y != 0.0;
                        let gap = if corner { gap * 0.6 } else { gap };
                        at + side * (half + Vec2::splat(gap))
                    })
                })
                .collect()
        }
        Anchor::Line([a, b]) => [0.12, 0.88, 0.25, 0.75, 0.5, 0.04, 0.96]
            .into_iter()
            .flat_map(|t| {
                let at = stage
                    .shrink2(half + Vec2::splat(8.0))
                    .clamp(a + (b - a) * t);
                let normal = (b - a).normalized().rot90();
                let gap = normal.x.abs() * half.x + normal.y.abs() * half.y + 8.0;
                [at + normal * gap, at - normal * gap]
            })
            .collect(),
        Anchor::Inside(rect) => {
            let inner = rect.shrink2((half + Vec2::splat(6.0)).min(rect.size() * 0.5));
            let at = |x: f32, y: f32| {
                pos2(
                    inner.left() + x * inner.width(),
                    inner.top() + y * inner.height(),
                )
            };
            // Where only a part of the label would be seen, it comes in far enough.
            let seen = stage.shrink2((half + Vec2::splat(4.0)).min(stage.size() * 0.5));
            let steps = [0.5, 0.3, 0.7, 0.1, 0.9];
            steps
                .into_iter()
                .flat_map(|y| steps.map(|x| seen.clamp(at(x, y))))
                .collect()
        }
    }
}

/// Length of the part of a line that lies in a rectangle: the parameter interval of the slab method.
fn length_in([a, b]: [Pos2; 2], rect: Rect) -> f32 {
    let d = b - a;
    let (mut from, mut to) = (0.0f32, 1.0f32);
    for (origin, d, min, max) in [
        (a.x, d.x, rect.left(), rect.right()),
        (a.y, d.y, rect.top(), rect.bottom()),
    ] {
        if d == 0.0 {
            if origin < min || origin > max {
                return 0.0;
            }
            continue;
        }
        let (t0, t1) = ((min - origin) / d, (max - origin) / d);
        from = from.max(t0.min(t1));
        to = to.min(t0.max(t1));
    }
    (to - from).max(0.0) * d.length()
}
