//! Nodes and arrows: standing as the things do in the picture, or as a tree.
//!
//! ```text
//!   must come before                      tree
//!
//!   (C)◄─────4.61 > 3.05────(B)②                 (A)③
//!     ╲                     ↗              before ╱     ╲ behind
//!      ╲      cycle        ╱                  (B)⑤      (C)①
//!       ╲                 ╱                   ╱            ╲
//!        └──────►(A)─────┘                 (D+)④          +12
//! ```

mod arrows;
mod plan;

use crate::{
    figure::{ArrowKind, Graph, GraphArrow, GraphNode, NodeStage},
    paint::crosses,
};

use super::prelude::*;

use arrows::Route;
use plan::{Chip, NAME_PTS, Plan};

const RING_PTS: f32 = 13.0;
const NUMBER_PTS: f32 = 10.5;
const NOTE_PTS: f32 = 11.0;
const STEPS: i32 = 12;
const ASIDE: f32 = 6.0;

impl OnSlate for Graph {
    fn slate<'a>(&self, natural: Slate<'a>, room: Vec2) -> Slate<'a> {
        plan::fitted(natural, self, room)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        slate.title(&self.title, rect);
        let plan = Plan::new(slate, rect, self);
        for &[above, below] in &plan.folds {
            let stroke = slate.stroke(1.0, slate.theme().discarded);
            slate.dashed([above, below], stroke, 3.0);
        }
        let routes = arrows::routes(slate, self, &plan);
        for route in &routes {
            arrows::draw(slate, &plan, route);
        }
        for chip in &plan.chips {
            draw_chip(slate, chip, self, links);
        }
        for chip in &plan.chips {
            if let Some(number) = chip.node(self).and_then(|node| node.number.as_ref()) {
                draw_number(slate, chip.place, number, &plan);
            }
        }
        notes(slate, rect, self, &plan);
        reasons(slate, rect, &plan, &routes);
        if let Some(ring) = &self.ring {
            name_ring(slate, rect, ring, &plan, &routes);
        }
        if plan.n_left_out > 0 {
            let words = slate.more(plan.n_left_out, NOTE_PTS);
            slate.put(&words, rect.right_top(), Align2::RIGHT_TOP);
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let said = |value: &Value| look.catalog.value(value);
        let is_seen = |node: &&GraphNode| node.stage != NodeStage::ToCome;
        let node = |node: &GraphNode| {
            let beside = node.number.iter().chain(&node.note).map(said);
            let name = bracketed(&said(&node.name), beside);
            format!("{}{name}", now(node.role == Role::Signal))
        };
        let nodes = joined(self.nodes.iter().filter(is_seen).map(node), ", ");
        let title = format!("{}: {nodes}", said(&self.title));
        let arrow = |arrow: &GraphArrow| {
            let name = |idx: usize| self.nodes.get(idx).map(|node| said(&node.name));
            let sign = match arrow.kind {
                ArrowKind::Holds | ArrowKind::Ring | ArrowKind::Branch => "→",
                ArrowKind::Allowed => "→?",
                ArrowKind::Refused => "×→",
            };
            let ends = format!("{} {sign} {}", name(arrow.from)?, name(arrow.to)?);
            Some(bracketed(&ends, arrow.reason.iter().map(said)))
        };
        let arrows = self.arrows.iter().filter_map(arrow);
        let parts = std::iter::once(title).chain(arrows);
        joined(parts.chain(self.ring.iter().map(said)), "; ")
    }
}

fn draw_chip(slate: &mut Slate<'_>, chip: &Chip, graph: &Graph, links: &mut Links) {
    let theme = slate.theme();
    let place = chip.place;
    let round = 0.5 * place.height();
    let Some(node) = chip.node(graph) else {
        let words = slate.words(chip.words(), (Face::Plain, NOTE_PTS, theme.soft));
        outline(slate, place, slate.stroke(1.0, theme.discarded), true);
        slate.put(&words, place.center(), Align2::CENTER_CENTER);
        return;
    };
    if node.stage == NodeStage::ToCome {
        return;
    }
    let is_asked = node.stage == NodeStage::Asked;
    let (width, border, ink) = match node.role {
        Role::Signal if is_asked => (2.5, theme.signal, theme.signal_text),
        Role::Signal => (2.5, theme.signal, theme.ink),
        Role::Accent => (2.0, theme.accent, theme.ink),
        Role::Faint | Role::Discarded => (1.0, theme.discarded, theme.soft),
        Role::Ink | Role::Soft | Role::Accepted => (1.0, theme.ink, theme.ink),
    };
    let painter = slate.painter;
    painter.rect_filled(place, round, theme.background);
    if links.touch(place, node.link) {
        let around = place.expand(slate.pts(3.5));
        slate.ring(around, 0.5 * around.height(), 1.25);
    }
    if !is_asked && node.role != Role::Faint {
        let (of, shade) = node.tone;
        painter.rect_filled(place, round, tone(theme, of, shade));
    }
    outline(slate, place, slate.stroke(width, border), is_asked);
    let name = slate.value(&node.name, (Face::Strong, NAME_PTS, ink));
    slate.put(&name, place.center(), Align2::CENTER_CENTER);
}

fn outline(slate: &Slate<'_>, place: Rect, stroke: Stroke, is_dashed: bool) {
    if is_dashed {
        let mut path: Vec<_> = plan::rim(place.shrink(0.5 * stroke.width)).collect();
        path.extend(path.first().copied());
        slate.dashes(&path, stroke, 3.0, 0.8);
    } else {
        let round = 0.5 * place.height();
        slate.rim(place, round, stroke, StrokeKind::Inside);
    }
}

/// Its place in the order, on a disc at that corner of the chip which no arrow runs through.
fn draw_number(slate: &mut Slate<'_>, place: Rect, number: &Value, plan: &Plan) {
    let theme = slate.theme();
    let number = slate.value(number, (Face::Mono, NUMBER_PTS, theme.accent));
    let corners = plan::number_places(slate, place, number.size().x);
    let is_clear = |disc: &Rect| {
        let is_other = |taken: &&Rect| taken.center() != place.center();
        let mut others = plan.taken.iter().filter(is_other);
        !slate.strokes.iter().any(|&stroke| crosses(stroke, *disc))
            && others.all(|other| !other.intersects(*disc))
    };
    let disc = corners.into_iter().find(is_clear).unwrap_or(corners[0]);
    let round = 0.5 * disc.height();
    let border = slate.stroke(1.25, theme.accent);
    let painter = slate.painter;
    painter.rect(disc, round, theme.background, border, StrokeKind::Inside);
    slate.put(&number, disc.center(), Align2::CENTER_CENTER);
}

fn reasons(slate: &mut Slate<'_>, rect: Rect, plan: &Plan, routes: &[Route<'_>]) {
    let is_now = |route: &&Route<'_>| route.arrow.role == Role::Signal;
    let now = routes.iter().filter(is_now);
    let others = routes.iter().filter(|route| !is_now(route));
    for route in now.chain(others) {
        let Some(reason) = &route.arrow.reason else {
            continue;
        };
        let colour = text_colour(slate.theme(), route.arrow.role);
        let face = Face::strong_if(is_now(&route));
        let words = slate.low(reason, (face, NOTE_PTS, colour));
        let at = route.beside(words.size(), slate.pts(ASIDE));
        put_clear(slate, rect, plan, &words, at);
    }
}

fn notes(slate: &mut Slate<'_>, rect: Rect, graph: &Graph, plan: &Plan) {
    for chip in &plan.chips {
        let node = chip.node(graph);
        let Some((node, note)) = node.and_then(|node| Some((node, node.note.as_ref()?))) else {
            continue;
        };
        let ink = match node.role {
            Role::Signal => slate.theme().signal_text,
            _ => slate.theme().soft,
        };
        let words = slate.low(note, (Face::Plain, NOTE_PTS, ink));
        let off = 0.5 * (chip.place.size() + words.size()) + Vec2::splat(slate.pts(ASIDE));
        let past = plan::number_size(slate, 0.0).x;
        let at = [
            vec2(off.x + past, 0.0),
            vec2(off.x, 0.0),
            vec2(-off.x, 0.0),
            vec2(-off.x, -0.25 * chip.place.height()),
            vec2(0.0, -off.y),
            vec2(0.0, off.y),
        ];
        let middle = chip.place.center();
        put_clear(slate, rect, plan, &words, at.map(|off| middle + off));
    }
}

fn name_ring(slate: &mut Slate<'_>, rect: Rect, ring: &Value, plan: &Plan, routes: &[Route<'_>]) {
    let of_ring = |route: &&Route<'_>| route.arrow.kind == ArrowKind::Ring;
    let middles = routes.iter().filter(of_ring).map(Route::middle);
    let Some(middle) = arrows::centre(middles) else {
        return;
    };
    let style = (Face::Strong, RING_PTS, slate.theme().signal_text);
    let words = slate.value(ring, style);
    let grid = (0..=STEPS).flat_map(|i| (0..=STEPS).map(move |j| [i, j]));
    let grid = grid.map(|place| {
        let [u, v] = place.map(|i| i as f32 / STEPS as f32);
        rect.min + vec2(u * rect.width(), v * rect.height())
    });
    let mut at: Vec<_> = std::iter::once(middle).chain(grid).collect();
    at.sort_by(|a, b| a.distance(middle).total_cmp(&b.distance(middle)));
    put_clear(slate, rect, plan, &words, at);
}

fn put_clear(
    slate: &mut Slate<'_>,
    rect: Rect,
    plan: &Plan,
    words: &Typeset,
    at: impl IntoIterator<Item = Pos2>,
) {
    let is_clear = |at: &Pos2| !plan.is_taken(Rect::from_center_size(*at, words.size()));
    slate.put_free(words, rect, at.into_iter().filter(is_clear));
}
