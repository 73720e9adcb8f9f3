//! Space as a camera or an eye sees it: a picture in a frame, with its title over it.

use std::sync::Arc;

use egui::{Context, Role as Access};

use crate::figure::{
    AROUND, Body, ColumnLayout, Eyes, Lens, Mark, Projected, Seer, Space, View, ViewId,
};

use super::{
    super::{composed::rect_of, hit},
    prelude::*,
};

const FRAME: f32 = 1.5;
const TITLE_PTS: f32 = 13.0;
/// From a point that is marked to the rim of its marker, in points.
const MARKER: f64 = 8.0;

/// The picture of a lens, whose lower edge is at −1 and upper at 1, as large as it fits in `rect`: all of a camera's, and
/// of an eye's what has to be seen, and around it as much as there is room for.
pub fn picture_viewport(rect: Rect, lens: &Lens) -> Viewport {
    let aspect = lens.least_aspect() as f32;
    let height = rect.height().min(rect.width() / aspect);
    let seen = Rect::from_center_size(rect.center(), vec2(aspect, 1.0) * height);
    Viewport {
        rect: lens.aspect().map_or(rect, |_| seen),
        centre: [0.0; 2],
        scale: f64::from(height) / 2.0,
    }
}

/// The same where the stage's edge would cut markers of what an eye has in its frame.
pub fn stage_viewport(rect: Rect, lens: &Lens) -> Viewport {
    let viewport = picture_viewport(rect, lens);
    if !matches!(lens, Lens::Eye(_)) {
        return viewport;
    }
    let height = 2.0 * viewport.scale;
    let bare = AROUND * (height - 2.0 * MARKER).max(0.0);
    Viewport {
        scale: 0.5 * height.min(bare),
        ..viewport
    }
}

/// Where the picture of a space stands: under its title, where that would cover a part of what has to be seen.
pub fn under_title(ui: &Ui, rect: Rect, look: Look<'_>, shown: &Space) -> Rect {
    let lens = Lens::from(shown.seer);
    let title = title_ground(ui, look, rect, shown).filter(|_| lens.aspect().is_none());
    let Some(title) = title else { return rect };
    let size = vec2(lens.least_aspect() as f32, 1.0) * rect.height();
    let middle = Rect::from_center_size(rect.center(), size);
    if title.intersects(middle) {
        rect.with_min_y(title.bottom())
    } else {
        rect
    }
}

/// What is seen of a space, as marks: what the last frame had under this name is not found again where it still holds.
pub fn projected(ctx: &Context, id: Id, space: &Space, lens: &Lens) -> Arc<[Mark]> {
    let id = id.with("projected");
    let known: Option<Option<Projected>> = ctx.data_mut(|data| data.remove_temp(id));
    let known = known.flatten().filter(|known| known.is_of(space, lens));
    let now = match known.or_else(|| taken_ahead(ctx, space, lens)) {
        Some(known) => known.again(space, lens),
        None => Projected::new(space, lens),
    };
    let marks = now.marks().clone();
    ctx.data_mut(|data| data.insert_temp(id, Some(now)));
    marks
}

/// Keeps what has been found of some spaces, in place of what is left of others, for the frames that are to show them.
pub fn keep_ahead(ctx: &Context, found: Vec<Projected>) {
    ctx.data_mut(|data| data.insert_temp(Id::unique("ahead"), found));
}

fn taken_ahead(ctx: &Context, space: &Space, lens: &Lens) -> Option<Projected> {
    ctx.data_mut(|data| {
        let found: &mut Vec<Projected> = data.get_temp_mut_or_default(Id::unique("ahead"));
        let nth = found.iter().position(|it| it.is_of(space, lens))?;
        Some(found.swap_remove(nth))
    })
}

fn title_height(look: Look<'_>) -> f32 {
    1.7 * TITLE_PTS * look.theme.text_scale
}

/// Puts the camera's picture, where it stands on the drawing, into its emptiest corner.
pub fn place_inset(
    ui: &Ui,
    look: Look<'_>,
    places: &mut ColumnLayout,
    views: &[View],
    eyes: &Eyes,
) {
    let [drawing, others @ ..] = views else {
        return;
    };
    let is_inset = |view: &&View| match &view.body {
        Body::Space(space) => matches!(space.seer, Seer::Camera(_)),
        _ => false,
    };
    let stands = others.iter().find(is_inset).zip(places.slot(drawing.id));
    let (Body::Space(shown), Some((inset, slot))) = (&drawing.body, stands) else {
        return;
    };
    let Seer::Eye(eye) = shown.seer else { return };
    let rect = under_title(ui, rect_of(slot), look, shown);
    let viewport = picture_viewport(rect, &Lens::Eye(eye));
    let middle = viewport.to_screen([0.0; 2]);
    let inset = (inset.id, title_height(look));
    let on_page = ([middle.x, middle.y], viewport.scale as f32);
    eyes.place_inset(places, inset, (drawing.id, eye), on_page);
}

pub fn covered(places: &ColumnLayout, drawing: ViewId, look: Look<'_>) -> Vec<Rect> {
    let title = title_height(look);
    let over = places.over(drawing).map(rect_of);
    let over = over.map(|rect| rect.with_min_y(rect.top() - title));
    over.collect()
}

pub fn space(
    ui: &Ui,
    look: Look<'_>,
    rect: Rect,
    (id, shown): (ViewId, &Space),
    covered: &[Rect],
    lit: Option<Link>,
) -> Option<Link> {
    let id = ui.scope_id().with((id, rect.left() as i32));
    let response = ui.interact(rect, id, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Access::Canvas, true, spoken(look, shown)));
    let lens = shown.seer.into();
    let viewport = picture_viewport(under_title(ui, rect, look, shown), &lens);
    let marks = projected(ui.ctx(), id, shown, &lens);
    let painter = ui.painter_at(viewport.rect);
    painter.rect_filled(viewport.rect, 0.0, look.theme.background);
    let is_camera = lens.aspect().is_some();
    let corner = if is_camera { viewport.rect } else { rect };
    let mut covered = covered.to_vec();
    covered.extend(title_ground(ui, look, corner, shown));
    let around = Around {
        covered: &covered,
        fades: !is_camera,
        ..Around::default()
    };
    look.stage(&painter, &viewport, &marks, lit, around);
    if is_camera {
        let frame = look.theme.stroke(FRAME, look.theme.accent);
        let painter = ui.painter();
        painter.rect_stroke(viewport.rect, 0.0, frame, StrokeKind::Middle);
    }
    title(ui, look, corner, shown);
    hit::link_at(&viewport, &marks, response.hover_pos()?, hit::REACH)
}

fn spoken(look: Look<'_>, shown: &Space) -> String {
    let title = shown.title.as_ref().map(|title| look.catalog.value(title));
    let title = title.unwrap_or_else(|| look.say("panel-stage"));
    let labels = shown.marks.iter().filter_map(|mark| mark.label.as_ref());
    let labels = joined(labels.map(|label| look.catalog.value(&label.text)), ", ");
    if labels.is_empty() {
        title
    } else {
        format!("{title}: {labels}")
    }
}

/// Over a camera's picture or in the corner of what an eye sees, on a ground: it is read on whatever is drawn there. The
/// words, their upper left corner, and the ground.
fn titled(ui: &Ui, look: Look<'_>, rect: Rect, shown: &Space) -> Option<(Typeset, Pos2, Rect)> {
    let slate = Slate::new(ui.painter(), look);
    let style = (Face::Strong, TITLE_PTS, look.theme.ink);
    let words = slate.value(shown.title.as_ref()?, style);
    let gap = slate.pts(5.0);
    let (down, align) = match Lens::from(shown.seer).aspect() {
        Some(_) => (-gap, Align2::LEFT_BOTTOM),
        None => (2.0 * gap, Align2::LEFT_TOP),
    };
    let place = align.anchor_size(rect.left_top() + vec2(0.0, down), words.size());
    let ground = place.expand(2.0).with_min_x(place.left());
    Some((words, place.min, ground))
}

pub fn title_ground(ui: &Ui, look: Look<'_>, rect: Rect, shown: &Space) -> Option<Rect> {
    titled(ui, look, rect, shown).map(|(.., ground)| ground)
}

pub fn title(ui: &Ui, look: Look<'_>, rect: Rect, shown: &Space) {
    if let Some((words, corner, ground)) = titled(ui, look, rect, shown) {
        let painter = ui.painter();
        painter.rect_filled(ground, 0.0, look.theme.background);
        words.paint(painter, corner, Align2::LEFT_TOP);
    }
}
