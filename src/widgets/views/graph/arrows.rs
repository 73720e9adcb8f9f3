//! Arrows from chip to chip: bent where they would run through another one, or back along another arrow.

use crate::figure::{ArrowKind, Graph, GraphArrow, Places};

use super::super::{prelude::*, slate::cross};
use super::plan::Plan;

const PIECES: usize = 16;
/// How far an arrow bends, over its length: away from the middle of the graph first.
const BENDS: [f32; 9] = [0.14, 0.08, -0.14, 0.02, 0.28, -0.28, 0.45, -0.45, 0.65];
/// Of one that another leads back along, to its left.
const BACK: [f32; 5] = [0.22, 0.1, 0.38, 0.55, -0.1];
const GAP: f32 = 4.0;

pub struct Route<'g> {
    pub arrow: &'g GraphArrow,
    pub path: Vec<Pos2>,
    outward: Vec2,
}

impl Route<'_> {
    pub fn middle(&self) -> Pos2 {
        self.path[self.path.len() / 2]
    }

    pub fn beside(&self, size: Vec2, aside: f32) -> Vec<Pos2> {
        let last = self.path.len() - 1;
        let mut places = Vec::new();
        for away in [1.0, 1.8, 2.8] {
            for part in [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8] {
                for side in [1.0, -1.0] {
                    let idx = (part * last as f32).round() as usize;
                    let off = side * self.outward;
                    let reach = 0.5 * (size.x * off.x.abs() + size.y * off.y.abs()) + away * aside;
                    places.push(self.path[idx] + reach * off);
                }
            }
        }
        places
    }
}

pub fn centre(places: impl Iterator<Item = Pos2>) -> Option<Pos2> {
    let (mut sum, mut n) = (Vec2::ZERO, 0);
    for place in places {
        sum += place.to_vec2();
        n += 1;
    }
    (n > 0).then(|| (sum / n as f32).to_pos2())
}

pub fn routes<'g>(slate: &Slate<'_>, graph: &'g Graph, plan: &Plan) -> Vec<Route<'g>> {
    let places = plan.chips.iter().map(|chip| chip.place.center());
    let middle = centre(places).unwrap_or_default();
    let route = |arrow: &'g GraphArrow| {
        let ends = [plan.place(arrow.from)?, plan.place(arrow.to)?];
        let path = match graph.places {
            Places::Layers(_) => {
                let gap = slate.pts(match arrow.kind {
                    ArrowKind::Branch => 0.0,
                    ArrowKind::Holds
                    | ArrowKind::Allowed
                    | ArrowKind::Refused
                    | ArrowKind::Ring => 2.0,
                });
                let from = ends[0].center_bottom();
                let to = ends[1].center_top() - vec2(0.0, gap);
                vec![from, from.lerp(to, 0.5), to]
            }
            Places::Free(_) => {
                let back = [arrow.to, arrow.from];
                let is_doubled = graph.arrows.iter().any(|a| [a.from, a.to] == back);
                bent(slate, plan, ends, middle, is_doubled)
            }
        };
        let (first, half_way, last) = (path[0], path[path.len() / 2], path[path.len() - 1]);
        let left = (last - first).normalized().rot90();
        let mut off = half_way - first.lerp(last, 0.5);
        if off.length() <= 0.5 {
            off = half_way - middle;
        }
        let outward = if left.dot(off) < 0.0 { -left } else { left };
        Some(Route {
            arrow,
            path,
            outward,
        })
    };
    graph.arrows.iter().filter_map(route).collect()
}

/// The first of the bends that keeps clear of all other chips, or the one that comes closest to that.
fn bent(
    slate: &Slate<'_>,
    plan: &Plan,
    [from, to]: [Rect; 2],
    middle: Pos2,
    is_doubled: bool,
) -> Vec<Pos2> {
    let ends = [from.center(), to.center()];
    let along = ends[1] - ends[0];
    let left = along.rot90();
    let half_way = ends[0].lerp(ends[1], 0.5);
    let is_inside = left.dot(half_way - middle) < 0.0;
    let sign = if is_inside { -1.0 } else { 1.0 };
    let gap = slate.pts(GAP);
    let others = plan.chips.iter().map(|chip| chip.place);
    let others = others.filter(|place| *place != from && *place != to);
    let others: Vec<Rect> = others.map(|place| place.expand(gap)).collect();
    let inside = plan.room.shrink(slate.pts(5.0));
    let curve = |bend: f32| -> Vec<Pos2> {
        let pull = half_way + 2.0 * bend * left;
        let at = |i: usize| {
            let t = i as f32 / PIECES as f32;
            ends[0].lerp(pull, t).lerp(pull.lerp(ends[1], t), t)
        };
        (0..=PIECES).map(at).collect()
    };
    // What leaves the room is not seen at all.
    let hits = |path: &[Pos2]| {
        let n_out = path.iter().filter(|at| !inside.contains(**at)).count();
        let is_hit = |at: &&Pos2| others.iter().any(|other| other.contains(**at));
        3 * n_out + path.iter().filter(is_hit).count()
    };
    let (bends, sign) = if is_doubled {
        (&BACK[..], 1.0)
    } else {
        (&BENDS[..], sign)
    };
    let curves = bends.iter().map(|bend| curve(sign * bend));
    let best = curves.min_by_key(|path| hits(path)).unwrap_or_default();
    cut(&best, [from.expand(gap), to.expand(gap)])
}

fn cut(path: &[Pos2], [from, to]: [Rect; 2]) -> Vec<Pos2> {
    let is_in = |rect: Rect, at: Pos2| {
        // Chips are round at their ends.
        let radius = 0.5 * rect.height();
        let core = (0.5 * rect.width() - radius).max(0.0);
        let off = at - rect.center();
        vec2((off.x.abs() - core).max(0.0), off.y).length() < radius
    };
    let edge = |inside: Pos2, outside: Pos2, rect: Rect| {
        let (mut a, mut b) = (inside, outside);
        for _ in 0..12 {
            let m = a.lerp(b, 0.5);
            let end = if is_in(rect, m) { &mut a } else { &mut b };
            *end = m;
        }
        b
    };
    let first = path.iter().position(|&at| !is_in(from, at));
    let last = path.iter().rposition(|&at| !is_in(to, at));
    let (Some(first), Some(last)) = (first, last) else {
        return path.to_vec();
    };
    if first > last || first == 0 || last + 1 == path.len() {
        return path.to_vec();
    }
    let mut cut = vec![edge(path[first - 1], path[first], from)];
    cut.extend(&path[first..=last]);
    cut.push(edge(path[last + 1], path[last], to));
    cut
}

pub fn draw(slate: &mut Slate<'_>, plan: &Plan, route: &Route<'_>) {
    let arrow = route.arrow;
    let ink = colour(slate.theme(), arrow.role);
    let is_now = arrow.role == Role::Signal;
    let width = match arrow.kind {
        ArrowKind::Ring => 3.25,
        ArrowKind::Holds | ArrowKind::Allowed | ArrowKind::Refused if is_now => 2.0,
        ArrowKind::Branch if is_now => 2.5,
        ArrowKind::Branch if arrow.role == Role::Accent => 2.0,
        ArrowKind::Holds | ArrowKind::Allowed | ArrowKind::Refused => 1.5,
        ArrowKind::Branch => 1.0,
    };
    let stroke = slate.stroke(width, ink);
    let mut path = route.path.clone();
    let tip = path[path.len() - 1];
    let has_head = arrow.kind != ArrowKind::Branch;
    let length = slate.head_length(stroke.width);
    if has_head {
        // The shaft ends in the head's foot.
        while path.len() > 2 && path[path.len() - 2].distance(tip) < 0.7 * length {
            path.remove(path.len() - 2);
        }
        let before = path[path.len() - 2];
        let last = path.len() - 1;
        path[last] = tip + (before - tip).normalized() * 0.7 * length;
    }
    let pieces = path.windows(2).map(|ends| [ends[0], ends[1]]);
    slate.strokes.extend(pieces);
    match arrow.kind {
        ArrowKind::Holds | ArrowKind::Ring | ArrowKind::Branch => {
            slate.painter.add(Shape::line(path.clone(), stroke));
        }
        ArrowKind::Allowed | ArrowKind::Refused => {
            slate.dashes(&path, stroke, 4.5, 0.75);
        }
    }
    if has_head {
        slate.head(tip, tip - path[path.len() - 2], length, ink);
    }
    if arrow.kind == ArrowKind::Refused {
        let arm = slate.pts(5.5);
        let place = |at: Pos2| Rect::from_center_size(at, Vec2::splat(2.0 * arm));
        let is_clear = |at: &Pos2| !plan.is_taken(place(*at));
        let last = route.path.len() - 1;
        let parts = [5, 4, 6, 3, 7].map(|part| route.path[part * last / 10]);
        let at = parts.into_iter().find(is_clear).unwrap_or(parts[0]);
        for ends in cross(at, arm).into_iter().rev() {
            slate.line(ends, slate.stroke(2.5, ink));
        }
    }
}
