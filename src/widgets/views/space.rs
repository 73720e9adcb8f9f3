//! Space as an eye sees it.

use egui::{Rect, Role, Sense, Ui, WidgetInfo};

use crate::{
    figure::{Link, Space, ViewId, project},
    geom::Orbit,
    paint::{self, Viewport},
    widgets::{Look, hit},
};

/// The part of a picture, whose lower edge is at −1 and upper at 1, that is seen in `rect`.
#[must_use]
pub fn picture_viewport(rect: Rect) -> Viewport {
    Viewport {
        rect,
        centre: [0.0; 2],
        scale: f64::from(rect.height()) / 2.0,
    }
}

/// Draws what `eye` sees; what is under the pointer.
pub fn space(
    ui: &Ui,
    look: Look<'_>,
    rect: Rect,
    (id, shown, eye): (ViewId, &Space, &Orbit),
    lit: Option<Link>,
) -> Option<Link> {
    let id = ui.scope_id().with((id, rect.left() as i32));
    let response = ui.interact(rect, id, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, look.say("panel-stage")));
    let viewport = picture_viewport(rect);
    let marks = project(shown, eye);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0.0, look.theme.background);
    paint::stage(
        &painter,
        &viewport,
        look.theme,
        look.catalog,
        &marks,
        lit,
        &[],
    );
    hit::link_at(&viewport, &marks, response.hover_pos()?)
}
