//! A row of the course: a lesson’s title, whole on two lines if need be.

use std::sync::Arc;

use egui::{
    Galley, Response, Role, Sense, StrokeKind, TextFormat, TextStyle, WidgetInfo,
    text::{LayoutJob, TextWrapping},
};

use crate::widgets::target;

use super::{
    course_steps::{CHANGED, named},
    prelude::*,
};

/// A lesson in the list.
#[derive(Clone, Copy, Default)]
pub struct Row<'a> {
    pub number: &'a str,
    pub title: &'a str,
    pub is_open: bool,
    pub is_changed: bool,
    /// In the list: how many of a lesson's questions have been told.
    pub tally: &'a str,
}

/// A title has so many lines before it is cut.
const MOST_LINES: usize = 2;

pub fn row(ui: &mut Ui, look: Look<'_>, row: Row<'_>) -> Response {
    let theme = look.theme;
    let words = Words::of(ui, theme, row);
    let least = target(ui, 28.0 * theme.text_scale.sqrt());
    let height = least.max(words.title.size().y + 10.0).round();
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
    let name = named(look, row.title, row.is_changed);
    response.widget_info(|| WidgetInfo::selected(Role::Tab, true, row.is_open, &name));
    let plate = rect.shrink2(vec2(0.0, 1.0));
    if row.is_open {
        ui.painter().rect_filled(plate, 6.0, theme.accent_wash);
    } else if response.hovered() {
        ui.painter().rect_filled(plate, 6.0, theme.hover);
    }
    if response.has_focus() {
        let rim = theme.stroke(2.0, theme.accent);
        ui.painter()
            .rect_stroke(plate, 6.0, rim, StrokeKind::Inside);
    }
    let is_cut = words.title.elided;
    words.draw(ui, theme, rect, row);
    let response = response.on_hover_cursor(CursorIcon::PointingHand);
    if is_cut || row.is_changed {
        response.on_hover_text(name)
    } else {
        response
    }
}

struct Words {
    pub title: Arc<Galley>,
    pub tally: Arc<Galley>,
}

impl Words {
    /// From a row's left edge to its title.
    const LEFT: f32 = 32.0;
    /// At its right.
    const MARGIN: f32 = 12.0;

    fn of(ui: &Ui, theme: &Theme, row: Row<'_>) -> Self {
        let small = TextStyle::Small.resolve(ui.style());
        let tally = row.tally.to_owned();
        let tally = (ui.painter()).layout_no_wrap(tally, small, theme.faint);
        let (style, colour) = if row.is_open {
            (theme::strong(), theme.ink)
        } else {
            (TextStyle::Body, theme.soft)
        };
        let format = TextFormat::simple(style.resolve(ui.style()), colour);
        let mut job = LayoutJob::single_section(row.title.to_owned(), format);
        let around = Self::LEFT + Self::MARGIN + tally.size().x + 4.0;
        job.wrap = TextWrapping {
            max_rows: MOST_LINES,
            ..TextWrapping::wrap_at_width(ui.available_width() - around)
        };
        let title = ui.fonts_mut(|fonts| fonts.layout_job(job));
        Self { title, tally }
    }

    fn draw(self, ui: &Ui, theme: &Theme, rect: Rect, row: Row<'_>) {
        let (painter, y) = (ui.painter(), rect.center().y);
        if row.is_changed {
            let at = pos2(rect.right() - 6.0, y);
            painter.circle_filled(at, CHANGED, theme.accent);
        }
        let of_number = if row.is_open {
            theme.accent
        } else {
            theme.faint
        };
        let small = TextStyle::Small.resolve(ui.style());
        let at = pos2(rect.left() + 16.0, y);
        painter.text(at, Align2::CENTER_CENTER, row.number, small, of_number);
        let at = |x: f32, galley: &Galley| pos2(x, y - 0.5 * galley.size().y);
        let left = at(rect.left() + Self::LEFT, &self.title);
        painter.galley(left, self.title, theme.ink);
        let right = rect.right() - Self::MARGIN - self.tally.size().x;
        painter.galley(at(right, &self.tally), self.tally, theme.faint);
    }
}
