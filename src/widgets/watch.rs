//! The watch table: the values that are alive, with those that changed at this step.

use egui::{Align2, Color32, FontId, Rect, Role, Sense, TextStyle, Ui, WidgetInfo, pos2, vec2};

use crate::{
    figure::{Link, Watch, WatchRow, WatchSection},
    paint::Typeset,
    text::Value,
};

use super::Look;

/// Room left of the names for the dot of a changed row.
const DOT_ROOM: f32 = 8.0;
/// The narrowest first column.
const NAME_WIDTH: f32 = 60.0;
/// Between columns, at least.
const GAP: f32 = 12.0;
/// Height of a row in sizes of its text: room for a stacked quotient, so that nothing moves when one comes.
const ROW_SIZE: f32 = 2.0;
/// How far a table that is too wide is drawn smaller.
const SMALLEST: f32 = 0.7;

/// Draws the table; the link of the row under the pointer.
pub fn watch(ui: &mut Ui, look: Look<'_>, watch: &Watch, lit: Option<Link>) -> Option<Link> {
    let mut table = Table::new(ui, look, lit);
    let mono = table.mono.clone();
    let mut pointed = None;
    ui.spacing_mut().item_spacing.y = 0.0;
    for (i, section) in watch.iter().enumerate() {
        if i > 0 {
            ui.add_space(8.0);
        }
        table.mono.size = mono.size;
        // Where the columns do not fit, smaller digits are better than digits in each other's place.
        table.mono.size *= table.fit(ui, section);
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
            height: (mono.size * ROW_SIZE).round(),
            mono,
        }
    }

    fn set(&self, ui: &Ui, value: &Value, colour: Color32) -> Typeset {
        let font = self.mono.clone();
        Typeset::value(ui.painter(), self.look.catalog, value, font, colour)
    }

    fn width(&self, ui: &Ui, value: &Value) -> f32 {
        self.set(ui, value, Color32::PLACEHOLDER).size().x
    }

    /// The width of the names, and of each column of values.
    fn widths(&self, ui: &Ui, section: &WatchSection) -> (f32, Vec<f32>) {
        let names = section.rows.iter();
        let names = names.map(|row| self.width(ui, &row.name));
        let n_columns = section.rows.iter().map(|row| row.cells.len()).max();
        let mut columns = vec![0.0_f32; n_columns.unwrap_or(1)];
        for row in &section.rows {
            for (width, cell) in columns.iter_mut().zip(&row.cells) {
                let cell = cell.as_ref().map(|value| self.width(ui, value));
                *width = width.max(cell.unwrap_or_default());
            }
        }
        // A title counts as well: that of the names comes first where they have one.
        let skip = section.header.len().saturating_sub(columns.len());
        for (width, title) in columns.iter_mut().zip(section.header.iter().skip(skip)) {
            *width = width.max(self.width(ui, title));
        }
        (names.fold(NAME_WIDTH - GAP, f32::max), columns)
    }

    /// The scale of the text at which no column touches the next.
    fn fit(&self, ui: &Ui, section: &WatchSection) -> f32 {
        let (names, columns) = self.widths(ui, section);
        let room = ui.available_width() - DOT_ROOM - GAP * columns.len() as f32;
        let text = names + columns.iter().sum::<f32>();
        (room / text).clamp(SMALLEST, 1.0)
    }

    /// Offsets of the value columns from the left of the row: evenly apart, or where that would put a
    /// value onto the next, each as far along as the values before it need.
    fn columns(&self, ui: &Ui, section: &WatchSection) -> Vec<f32> {
        let (names, widths) = self.widths(ui, section);
        let first = DOT_ROOM + GAP + names;
        let step = ((ui.available_width() - first) / widths.len().max(1) as f32).max(24.0);
        if widths.iter().all(|width| width + 0.5 * GAP <= step) {
            return (0..widths.len()).map(|i| first + i as f32 * step).collect();
        }
        let mut next = first;
        let mut place = |width: &f32| {
            let x = next;
            next += width + GAP;
            x
        };
        widths.iter().map(&mut place).collect()
    }

    fn header(&self, ui: &mut Ui, section: &WatchSection, columns: &[f32]) {
        let size = vec2(ui.available_width(), self.height);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        // A header may name the column of names too.
        let skip = section.header.len().saturating_sub(columns.len());
        let colour = self.look.theme.soft;
        let titles = section.header[skip..].iter().zip(columns.iter().copied());
        let names = section.header[..skip].iter().zip([DOT_ROOM]);
        for (title, x) in names.chain(titles) {
            let at = pos2(rect.left() + x, rect.center().y);
            let title = self.set(ui, title, colour);
            title.paint(ui.painter(), at, Align2::LEFT_CENTER);
        }
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
        let value_colour = if row.changed {
            theme.signal_text
        } else {
            theme.ink
        };
        if row.changed {
            ui.painter()
                .circle_filled(pos2(rect.left() + 1.0, y), 2.5, theme.signal);
        }
        let at = |x: f32| pos2(rect.left() + x, y);
        let name = self.set(ui, &row.name, theme.soft);
        name.paint(ui.painter(), at(DOT_ROOM), Align2::LEFT_CENTER);
        let mut end = rect.left();
        let nothing = Value::Name(if is_table { "" } else { "–" }.to_owned());
        for (cell, x) in row.cells.iter().zip(columns) {
            let set = match cell {
                Some(value) => self.set(ui, value, value_colour),
                None => self.set(ui, &nothing, theme.soft),
            };
            end = set.paint(ui.painter(), at(*x), Align2::LEFT_CENTER).right();
        }
        if let Some(note) = &row.note {
            self.note(ui, rect, end, note);
        }
        row.link.filter(|_| response.hovered())
    }

    /// At the right end of a row, where there is room; else left out, as it only explains.
    fn note(&self, ui: &Ui, rect: Rect, end: f32, note: &Value) {
        let Look { catalog, theme } = self.look;
        let set = Typeset::value(ui.painter(), catalog, note, self.small.clone(), theme.soft);
        if rect.right() - set.size().x >= end + 8.0 {
            set.paint(ui.painter(), rect.right_center(), Align2::RIGHT_CENTER);
        }
    }

    fn spoken(&self, row: &WatchRow) -> String {
        let cells = row.cells.iter().flatten().chain(&row.note);
        let words: Vec<String> = std::iter::once(&row.name)
            .chain(cells)
            .map(|value| self.look.catalog.value(value))
            .collect();
        words.join(" ")
    }
}
