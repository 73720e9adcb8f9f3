//! Space as a camera or an eye sees it: a picture in a frame, with its title over it.

use std::sync::Arc;

use egui::{Align2, Context, Id, Rect, Role, Sense, StrokeKind, Ui, WidgetInfo, vec2};

use crate::{
    figure::{Lens, Link, Mark, Space, ViewId, project},
    paint::{self, Viewport},
    widgets::{Look, hit},
};

use super::slate::{Face, Slate};

/// Of a camera's picture: its frame, and the size of its title.
const FRAME: f32 = 1.5;
const TITLE_PTS: f32 = 13.0;

/// Width over height that what an eye sees has room for, at least.
const ASPECT: f32 = 1.4;

/// The picture of a lens, whose lower edge is at −1 and upper at 1, as large as it fits in `rect`: all of a camera's, and
/// of an eye's as much as there is room for.
#[must_use]
pub fn picture_viewport(rect: Rect, lens: &Lens) -> Viewport {
    let aspect = lens.aspect().map(|aspect| aspect as f32);
    let height = rect.height().min(rect.width() / aspect.unwrap_or(ASPECT));
    let seen =
        aspect.map(|aspect| Rect::from_center_size(rect.center(), vec2(aspect, 1.0) * height));
    Viewport {
        rect: seen.unwrap_or(rect),
        centre: [0.0; 2],
        scale: f64::from(height) / 2.0,
    }
}

/// What was seen last, and what it came to: nothing is projected again that has not changed.
#[derive(Clone)]
struct Projected {
    space: Space,
    lens: Lens,
    marks: Arc<[Mark]>,
}

/// What is seen of a space, as marks: under this name those of the last frame, if they still hold.
#[must_use]
pub fn projected(ctx: &Context, id: Id, space: &Space, lens: &Lens) -> Arc<[Mark]> {
    let id = id.with("projected");
    let known: Option<Projected> = ctx.data(|data| data.get_temp(id));
    if let Some(known) = known
        && known.lens == *lens
        && known.space.is_same(space)
    {
        return known.marks;
    }
    let marks: Arc<[Mark]> = project(space, lens).into();
    let now = Projected {
        space: space.clone(),
        lens: *lens,
        marks: marks.clone(),
    };
    ctx.data_mut(|data| data.insert_temp(id, now));
    marks
}

/// Draws what is seen; what is under the pointer.
pub fn space(
    ui: &Ui,
    look: Look<'_>,
    rect: Rect,
    (id, shown): (ViewId, &Space),
    lit: Option<Link>,
) -> Option<Link> {
    let id = ui.scope_id().with((id, rect.left() as i32));
    let response = ui.interact(rect, id, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, look.say("panel-stage")));
    let lens = shown.seer.into();
    let viewport = picture_viewport(rect, &lens);
    let marks = projected(ui.ctx(), id, shown, &lens);
    let painter = ui.painter_at(viewport.rect);
    painter.rect_filled(viewport.rect, 0.0, look.theme.background);
    let Look { theme, catalog } = look;
    paint::stage(&painter, &viewport, theme, catalog, &marks, lit, &[]);
    if lens.aspect().is_some() {
        let frame = theme.stroke(FRAME, theme.accent);
        ui.painter()
            .rect_stroke(viewport.rect, 0.0, frame, StrokeKind::Middle);
    }
    title(ui, look, viewport.rect, shown);
    hit::link_at(&viewport, &marks, response.hover_pos()?)
}

/// Over a camera's picture; in the corner of what an eye sees.
pub fn title(ui: &Ui, look: Look<'_>, rect: Rect, shown: &Space) {
    let Some(title) = &shown.title else { return };
    let mut slate = Slate::new(ui.painter(), look);
    let title = slate.value(title, (Face::Strong, TITLE_PTS, look.theme.ink));
    if Lens::from(shown.seer).aspect().is_some() {
        let above = rect.left_top() - vec2(0.0, slate.pts(5.0));
        slate.put(&title, above, Align2::LEFT_BOTTOM);
    } else {
        let inside = rect.left_top() + vec2(slate.pts(16.0), slate.pts(14.0));
        slate.put(&title, inside, Align2::LEFT_TOP);
    }
}
