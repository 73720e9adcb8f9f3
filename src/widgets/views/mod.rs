//! What an algorithm holds, drawn beside the drawing or under it: one file a kind. Window and export share them.

mod bits;
mod clipper_row;
mod costs;
mod fold;
mod gauges;
mod graph;
mod lists;
mod matrix;
mod multiples;
mod number_line;
mod prelude;
mod products;
mod raster;
mod ribbon;
mod slate;
mod space;
mod space_row;
mod story;
mod table;
#[cfg(test)]
mod tests;

use egui::Role as Access;

use crate::figure::{Body, View};

use prelude::*;

pub use space::{
    covered, keep_ahead, picture_viewport, place_inset, projected, space, stage_viewport,
    title as title_of_space, title_ground, under_title,
};

/// Draws a view of any kind but the drawing in `rect`, from its top; what it shows under the pointer.
pub fn view(ui: &Ui, look: Look<'_>, rect: Rect, shown: &View, lit: Option<Link>) -> Option<Link> {
    if let Body::Space(body) = &shown.body {
        return space(ui, look, rect, (shown.id, body), &[], lit);
    }
    let body = body_of(shown)?;
    // Two columns may stand side by side, each with views of its own.
    let id = ui.scope_id().with((shown.id, rect.left() as i32));
    let response = ui.interact(rect, id, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Access::Canvas, true, body.spoken(look)));
    let mut links = Links {
        lit,
        pointer: response.hover_pos(),
        chips: look.chips.to_vec(),
        ..Links::default()
    };
    // Boxes and rings may reach a little beyond what they go round.
    let painter = ui.painter().with_clip_rect(rect.expand(6.0));
    let mut slate = body.slate(Slate::new(&painter, look), rect.size());
    body.draw(&mut slate, rect, &mut links);
    links.draw_chips(ui.painter(), look.theme);
    links.pointed
}

fn body_of(shown: &View) -> Option<&dyn OnSlate> {
    Some(match &shown.body {
        Body::Plane(_) | Body::Space(_) => return None,
        Body::Raster(body) => body,
        Body::Bits(body) => body,
        Body::Table(body) => body,
        Body::Lists(body) => body,
        Body::Products(body) => body,
        Body::NumberLine(body) => body,
        Body::Clippers(body) => body,
        Body::Gauges(body) => body,
        Body::Ribbon(body) => body,
        Body::Multiples(body) => body,
        Body::Matrix(body) => body,
        Body::Spaces(body) => body,
        Body::Graph(body) => body,
        Body::Story(body) => body,
        Body::Costs(body) => body,
    })
}
