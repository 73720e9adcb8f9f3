//! The watch table: the values that are alive, with those that changed at this step.

use egui::{Align2, Color32, FontId, Rect, Role, Sense, TextStyle, Ui, WidgetInfo, pos2, vec2};

use crate::{
    figure::{Link, Watch, WatchRow, WatchSection},
    text::{Catalog, Value},
};

use super::Look;

/// Room left of the names for the dot of a changed row.
const DOT_ROOM: f32 = 8.0;
/// The narrowest first column.
const NAME_WIDTH: f32 = 60.0;

/// Draws the table; the link of the row under the pointer.
pub fn watch(ui: &mut Ui, look: Look<'_>, watch: &Watch, lit: Option<Link>) -> Option<Link> {
    let table = Table::new(ui, look, lit);
    let mut pointed = None;
    ui.spacing_mut().item_spacing.y = 0.0;
    for (i, section) in watch.iter().enumerate() {
        if i > 0 {
            ui.add_space(8.0);
        }
        let columns = table.columns(ui, section);
        if !section.header.is_empty() {
            table.header(ui, section, &columns);
        }
        for row in &section.rows {
            pointed = table
                .row(ui, row, &columns, !section.header.is_empty())
                .or(pointed);
        }
    }
    pointed
}

struct Table<'a> {
    look: Look<'a>,
    lit: Option<Link>,
    mono: FontId,
    small: FontId,
    height: f32,
}

impl<'a> Table<'a> {
    fn new(ui: &Ui, look: Look<'a>, lit: Option<Link>) -> Self {
        let mono = TextStyle::Monospace.resolve(ui.style());
        Self {
            look,
            lit,
            small: TextStyle::Small.resolve(ui.style()),
            height: (mono.size * 1.7).round(),
            mono,
        }
    }

    fn words(&self, value: &Value) -> String {
        words(self.look.catalog, value)
    }

    fn width(&self, ui: &Ui, text: &str) -> f32 {
        let colour = Color32::PLACEHOLDER;
        ui.fonts_mut(|fonts| {
            fonts
                .layout_no_wrap(text.to_owned(), self.mono.clone(), colour)
                .size()
                .x
        })
    }

    /// Offsets of the value columns from the left of the row.
    fn columns(&self, ui: &Ui, section: &WatchSection) -> Vec<f32> {
        let names = section
            .rows
            .iter()
            .map(|row| self.width(ui, &self.words(&row.name)));
        let first = DOT_ROOM + 12.0 + names.fold(NAME_WIDTH - 12.0, f32::max);
        let n_columns = section
            .rows
            .iter()
            .map(|row| row.cells.len())
            .max()
            .unwrap_or(1);
        let step = ((ui.available_width() - first) / n_columns.max(1) as f32).max(24.0);
        (0..n_columns).map(|i| first + i as f32 * step).collect()
    }

    fn header(&self, ui: &mut Ui, section: &WatchSection, columns: &[f32]) {
        let size = vec2(ui.available_width(), self.height);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        // A header may name the column of names too.
        let skip = section.header.len().saturating_sub(columns.len());
        if skip == 1 {
            let at = pos2(rect.left() + DOT_ROOM, rect.center().y);
            self.text(
                ui,
                at,
                Align2::LEFT_CENTER,
                section.header[0],
                self.look.theme.faint,
            );
        }
        for (title, x) in section.header[skip..].iter().zip(columns) {
            let at = pos2(rect.left() + x, rect.center().y);
            self.text(ui, at, Align2::LEFT_CENTER, title, self.look.theme.faint);
        }
    }

    fn text(&self, ui: &Ui, at: egui::Pos2, align: Align2, text: &str, colour: Color32) -> Rect {
        ui.painter()
            .text(at, align, text, self.mono.clone(), colour)
    }

    fn row(&self, ui: &mut Ui, row: &WatchRow, columns: &[f32], is_table: bool) -> Option<Link> {
        let theme = self.look.theme;
        let size = vec2(ui.available_width(), self.height);
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, self.spoken(row)));
        if row.link.is_some() && (response.hovered() || row.link == self.lit) {
            ui.painter()
                .rect_filled(rect.expand2(vec2(8.0, 0.0)), 0.0, theme.accent_wash);
        }
        let y = rect.center().y;
        let value_colour = if row.changed { theme.signal } else { theme.ink };
        if row.changed {
            ui.painter()
                .circle_filled(pos2(rect.left() + 1.0, y), 2.5, theme.signal);
        }
        let at = |x: f32| pos2(rect.left() + x, y);
        self.text(
            ui,
            at(DOT_ROOM),
            Align2::LEFT_CENTER,
            &self.words(&row.name),
            theme.soft,
        );
        let mut end = rect.left();
        for (cell, x) in row.cells.iter().zip(columns) {
            let (text, colour) = match cell {
                Some(value) => (self.words(value), value_colour),
                None if is_table => (String::new(), theme.faint),
                None => ("–".to_owned(), theme.faint),
            };
            end = self
                .text(ui, at(*x), Align2::LEFT_CENTER, &text, colour)
                .right();
        }
        if let Some(note) = &row.note {
            self.note(ui, rect, end, &self.words(note));
        }
        row.link.filter(|_| response.hovered())
    }

    /// At the right end of a row, where there is room; else left out, as it only explains.
    fn note(&self, ui: &Ui, rect: Rect, end: f32, note: &str) {
        let colour = self.look.theme.soft;
        let galley =
            ui.fonts_mut(|fonts| fonts.layout_no_wrap(note.to_owned(), self.small.clone(), colour));
        let at = pos2(
            rect.right() - galley.size().x,
            rect.center().y - 0.5 * galley.size().y,
        );
        if at.x >= end + 8.0 {
            ui.painter().galley(at, galley, colour);
        }
    }

    fn spoken(&self, row: &WatchRow) -> String {
        let cells = row.cells.iter().flatten().chain(&row.note);
        let words: Vec<String> = std::iter::once(&row.name)
            .chain(cells)
            .map(|value| self.words(value))
            .collect();
        words.join(" ")
    }
}

fn words(catalog: &Catalog, value: &Value) -> String {
    catalog.value(value)
}
