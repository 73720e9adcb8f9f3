//! Signed numbers on axes of their own, one over the other.

use egui::{Align2, Painter, Rect, pos2};

use crate::{figure::Gauges, text::Value, widgets::Look};

use super::{
    links::Links,
    on_slate::OnSlate,
    slate::{Face, Slate, text_colour},
};

impl OnSlate for Gauges {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, _rect: Rect) -> Slate<'a> {
        Slate::new(painter, look)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, links: &mut Links) {
        let theme = slate.theme();
        let title = slate.sentence(&self.title, rect.width(), (Face::Strong, 13.0, theme.ink));
        let mut y = slate.put(&title, rect.min, Align2::LEFT_TOP).bottom() + slate.pts(8.0);
        for row in &self.rows {
            let style = (Face::Plain, 13.0, text_colour(theme, row.role));
            let name = slate.value(&row.name, style);
            let put = slate.put(&name, pos2(rect.left(), y), Align2::LEFT_TOP);
            if let Some(value) = row.value {
                let number = slate.value(&Value::Number(value), style);
                slate.put(&number, pos2(rect.right(), y), Align2::RIGHT_TOP);
            }
            links.touch(put, row.link);
            y = put.bottom() + slate.pts(4.0);
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let row = |row: &crate::figure::Gauge| {
            let name = look.catalog.value(&row.name);
            let value = row
                .value
                .map(|value| look.catalog.value(&Value::Number(value)));
            format!("{name} {}", value.unwrap_or_default())
        };
        let rows: Vec<String> = self.rows.iter().map(row).collect();
        format!("{}: {}", look.catalog.message(&self.title), rows.join("; "))
    }
}
