//! Space as a camera or an eye sees it: a picture in a frame, with its title over it.

use egui::{Align2, Rect, Role, Sense, StrokeKind, Ui, WidgetInfo, vec2};

use crate::{
    figure::{Lens, Link, Space, ViewId, project},
    paint::{self, Viewport},
    widgets::{Look, hit},
};

use super::slate::{Face, Slate};

/// Of a camera's picture: its frame, and the size of its title.
const FRAME: f32 = 1.5;
const TITLE_PTS: f32 = 13.0;

/// The picture of a lens, whose lower edge is at −1 and upper at 1, as large as it fits in `rect`.
#[must_use]
pub fn picture_viewport(rect: Rect, lens: &Lens) -> Viewport {
    let width = lens.aspect().map(|aspect| rect.height() * aspect as f32);
    let width = width.unwrap_or_else(|| rect.width());
    let size = vec2(width, rect.height());
    let part = (rect.width() / width).min(1.0);
    let rect = Rect::from_center_size(rect.center(), size * part);
    Viewport {
        rect,
        centre: [0.0; 2],
        scale: f64::from(rect.height()) / 2.0,
    }
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
    let marks = project(shown, &lens);
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
    let gap = slate.pts(5.0);
    if Lens::from(shown.seer).aspect().is_some() {
        slate.put(
            &title,
            rect.left_top() - vec2(0.0, gap),
            Align2::LEFT_BOTTOM,
        );
    } else {
        slate.put(&title, rect.left_top() + vec2(gap, gap), Align2::LEFT_TOP);
    }
}
