//! One entry of a list: its marker, its name, what is said of it.

use egui::{Align2, Color32, Pos2, Rect, Shape, Stroke, StrokeKind, vec2};

use crate::{
    figure::{ItemMarker, ListRow, Role},
    text::Value,
};

use super::super::{
    on_slate::Links,
    slate::{Face, Slate, wash},
};
use super::plan::{DETAIL_SIZE, NAME_SIZE, Widths};

/// How an entry of a role looks: its surface, its border, its name.
fn look_of(slate: &Slate<'_>, role: Role) -> (Color32, Stroke, (Face, Color32)) {
    let theme = slate.theme();
    let border = |width, colour| slate.stroke(width, colour);
    let fill = wash(theme, role);
    let strong = |colour| (Face::Strong, colour);
    match role {
        Role::Signal => (fill, border(1.75, theme.signal), strong(theme.signal_text)),
        Role::Accent => (fill, border(1.25, theme.accent), strong(theme.accent)),
        Role::Accepted => (fill, border(1.25, theme.accepted), strong(theme.ink)),
        Role::Discarded => (
            fill,
            border(1.0, theme.discarded),
            (Face::Plain, theme.soft),
        ),
        Role::Ink => (fill, Stroke::NONE, strong(theme.ink)),
        Role::Soft => (fill, Stroke::NONE, (Face::Plain, theme.soft)),
        Role::Faint => (
            theme.background,
            border(1.0, theme.hairline),
            (Face::Plain, theme.soft),
        ),
    }
}

/// Draws it; what is under the pointer stands out.
pub fn chip(
    slate: &mut Slate<'_>,
    place: Rect,
    widths: &Widths,
    entry: &ListRow,
    links: &mut Links,
) {
    let (fill, border, (face, ink)) = look_of(slate, entry.role);
    let corner = slate.pts(3.0);
    if links.touch(place, entry.link) {
        let ring = slate.stroke(1.25, slate.theme().accent);
        let around = place.expand(slate.pts(2.5));
        slate
            .painter
            .rect_stroke(around, corner, ring, StrokeKind::Middle);
    }
    if entry.role == Role::Discarded {
        dashed_box(slate, place, border);
    } else {
        slate
            .painter
            .rect(place, corner, fill, border, StrokeKind::Inside);
    }
    let marker = widths.marker(slate);
    // What is said of the names stands under each other; a name alone stands in the middle.
    let left = place.center().x - 0.5 * widths.content(slate);
    let y = place.center().y;
    if let Some(kind) = entry.marker {
        let at = Pos2::new(left + 0.3 * marker, y);
        draw_marker(slate, at, kind, entry.role);
    }
    let name = slate.value(&entry.name, (face, NAME_SIZE, ink));
    let is_alone = entry.marker.is_none() && widths.details.is_empty();
    let x = if is_alone {
        place.center().x
    } else {
        left + marker + 0.5 * widths.name
    };
    slate.put(&name, Pos2::new(x, y), Align2::CENTER_CENTER);
    let soft = if entry.role == Role::Signal {
        ink
    } else {
        slate.theme().soft
    };
    let columns = widths.columns(slate, place.center().x);
    for ([left, right], detail) in columns.into_iter().zip(&entry.details) {
        if let Some(detail) = detail {
            let (x, align) = if is_flush_right(detail) {
                (right, Align2::RIGHT_CENTER)
            } else {
                (left, Align2::LEFT_CENTER)
            };
            let detail = slate.low(detail, (Face::Plain, DETAIL_SIZE, soft));
            slate.put(&detail, Pos2::new(x, y), align);
        }
    }
}

/// Numbers end at the right end of their column.
pub const fn is_flush_right(detail: &Value) -> bool {
    match detail {
        Value::Number(_) | Value::Ratio { .. } | Value::Count(_) => true,
        Value::Point(_)
        | Value::Name(_)
        | Value::Term(_)
        | Value::Formula(_)
        | Value::Message(_) => false,
    }
}

/// The place of a first entry that has not come yet.
pub fn none(slate: &mut Slate<'_>, place: Rect) {
    let stroke = slate.stroke(1.0, slate.theme().faint);
    dashed_box(slate, place, stroke);
    let dash = slate.words("–", (Face::Plain, NAME_SIZE, slate.theme().soft));
    slate.put(&dash, place.center(), Align2::CENTER_CENTER);
}

fn dashed_box(slate: &Slate<'_>, place: Rect, stroke: Stroke) {
    let [a, b, c, d] = [
        place.left_top(),
        place.right_top(),
        place.right_bottom(),
        place.left_bottom(),
    ];
    let dash = slate.pts(3.5);
    let shapes = Shape::dashed_line(&[a, b, c, d, a], stroke, dash, dash);
    slate.painter.extend(shapes);
}

/// The same marks as on the stage.
pub fn draw_marker(slate: &Slate<'_>, at: Pos2, marker: ItemMarker, role: Role) {
    let theme = slate.theme();
    let colour = match role {
        Role::Ink | Role::Accent | Role::Signal | Role::Accepted => theme.ink,
        Role::Soft | Role::Faint | Role::Discarded => theme.soft,
    };
    let r = slate.pts(4.0);
    let stroke = slate.stroke(1.75, colour);
    let cross = |r: f32| {
        for y in [-r, r] {
            let ends = [at + vec2(-r, -y), at + vec2(r, y)];
            slate.painter.line_segment(ends, stroke);
        }
    };
    match marker {
        ItemMarker::Dot => {
            slate.painter.circle_filled(at, r, colour);
        }
        ItemMarker::Ring => {
            slate.painter.circle(at, r, theme.background, stroke);
        }
        ItemMarker::Cross => cross(r),
        ItemMarker::CrossedRing => {
            slate.painter.circle(at, r, theme.background, stroke);
            cross(0.65 * r);
        }
    }
}
