//! The watch table: the values that are alive, with those that changed at this step.

use std::collections::BTreeSet;

use egui::{FontFamily, Role};

use crate::figure::{Watch, WatchRow, WatchSection};

use super::{fingers::target, headings::focus_ring, prelude::*, whole_rows::WholeRows};

const DOT_ROOM: f32 = 8.0;
const NAME_WIDTH: f32 = 60.0;
const GAP: f32 = 12.0;
/// Height of a row in sizes of its text: room for a stacked quotient, so that nothing moves when one comes.
const ROW_SIZE: f32 = 2.2;
/// The same in large type, which leaves the pseudocode little room.
const LARGE_ROW_SIZE: f32 = 2.0;
const SMALLEST: f32 = 0.7;
const SECTION_GAP: f32 = 8.0;

/// What the tables of a run want: found once, so that nothing moves from one step to the next.
#[derive(Default)]
pub struct WatchRoom {
    sections: Vec<SectionRoom>,
    pub height: f32,
}

#[derive(Default)]
struct SectionRoom {
    header: Vec<Value>,
    names: f32,
    /// The widest word of a name.
    word: f32,
    columns: Vec<f32>,
    /// Of its natural size text keeps so much.
    least: f32,
    known: BTreeSet<(usize, String)>,
}

impl WatchRoom {
    pub fn widen(&mut self, ui: &Ui, look: Look<'_>, watch: &Watch) {
        let table = Table::new(ui, look, None);
        for section in watch {
            let known = self.section_idx(section).unwrap_or_else(|| {
                self.sections.push(SectionRoom {
                    header: section.header.clone(),
                    least: SMALLEST.max(look.theme.least_text / table.mono.size),
                    ..SectionRoom::default()
                });
                self.sections.len() - 1
            });
            self.sections[known].widen(&table, ui, section);
        }
        self.height = self.height.max(table.heights(watch).iter().sum());
    }

    fn section_idx(&self, section: &WatchSection) -> Option<usize> {
        let mut known = self.sections.iter();
        known.position(|known| known.header == section.header)
    }
}

impl SectionRoom {
    fn widen(&mut self, table: &Table<'_>, ui: &Ui, section: &WatchSection) {
        let n_columns = section.rows.iter().map(|row| row.cells.len());
        let n_columns = n_columns.max().unwrap_or(1).max(self.columns.len());
        self.columns.resize(n_columns, 0.0);
        // A title counts as well: that of the names comes first where they have one.
        let skip = section.header.len().saturating_sub(n_columns);
        for (i, title) in section.header.iter().skip(skip).enumerate() {
            let width = table.widest_word(ui, title);
            self.columns[i] = self.columns[i].max(width);
        }
        for row in &section.rows {
            let is_table = !section.header.is_empty();
            let name = table.name(ui, (&row.name, is_table), Color32::PLACEHOLDER);
            self.names = self.names.max(name.size().x);
            self.word = self.word.max(if is_words(&row.name, is_table) {
                table.widest_word(ui, &row.name)
            } else {
                name.size().x
            });
            for (i, cell) in row.cells.iter().enumerate() {
                if let Some(value) = cell {
                    self.measure(table, ui, i, value);
                }
            }
        }
    }

    fn measure(&mut self, table: &Table<'_>, ui: &Ui, column: usize, value: &Value) {
        if !self.known.insert((column, table.look.catalog.value(value))) {
            return;
        }
        let width = table.set(ui, value, Color32::PLACEHOLDER).size().x;
        self.columns[column] = self.columns[column].max(width);
    }

    /// For names, and for names and values. Short names have as much as long ones if there is room; words of long ones stand over
    /// each other if there is none.
    fn wanted(&self, room: f32) -> [f32; 2] {
        let values = self.columns.iter().sum::<f32>();
        let widths = [self.names.max(NAME_WIDTH - GAP), self.names];
        let names = widths.into_iter().find(|names| names + values <= room);
        let names = names.unwrap_or_else(|| self.word.max(room - values));
        [names, names + values]
    }

    /// The width of names, and what part of its natural size all text has; and has it room, as small as it may be?
    fn fit(&self, width: f32) -> ([f32; 2], bool) {
        let room = width - DOT_ROOM - GAP * self.columns.len() as f32;
        let [names, text] = self.wanted(room);
        let scale = (room / text).clamp(self.least, 1.0);
        ([scale * names, scale], self.least * text <= room)
    }

    /// Offsets of the value columns from the left of the row: evenly apart, or where that would put a
    /// value onto the next, each as far along as the values before it need.
    fn columns(&self, width: f32) -> Vec<f32> {
        let ([names, scale], _) = self.fit(width);
        let first = DOT_ROOM + GAP + names;
        let n = self.columns.len();
        let step = ((width - first) / n.max(1) as f32).max(24.0);
        let fits = |column: &f32| scale * column + 0.5 * GAP <= step;
        if self.columns.iter().all(fits) {
            return (0..n).map(|i| first + i as f32 * step).collect();
        }
        let mut next = first;
        let mut place = |column: &f32| {
            let x = next;
            next += scale * column + GAP;
            x
        };
        self.columns.iter().map(&mut place).collect()
    }
}

/// Words in a table are set in the type of words, which is less wide.
const fn is_words(value: &Value, is_table: bool) -> bool {
    is_table && matches!(value, Value::Term(_) | Value::Message(_))
}

pub struct WatchTable<'a> {
    pub watch: &'a Watch,
    pub room: (&'a WatchRoom, f32),
    pub moment: usize,
    pub lit: Option<Link>,
    pub is_typed: &'a dyn Fn(Link) -> bool,
}

#[derive(Clone, Copy, Debug, Default)]
pub struct WatchShown {
    pub pointed: Option<Link>,
    pub clicked: Option<(Link, Pos2)>,
}

pub fn watch(ui: &mut Ui, look: Look<'_>, asked: &WatchTable<'_>) -> WatchShown {
    let WatchTable { watch, room, .. } = *asked;
    let (room, most) = room;
    let mut table = Table::new(ui, look, asked.lit);
    let mut shown = WatchShown::default();
    ui.spacing_mut().item_spacing.y = 0.0;
    let top = ui.cursor().top();
    let heights = table.heights(watch);
    let mut changed = watch.iter().flat_map(|section| {
        let header = (!section.header.is_empty()).then_some(false).into_iter();
        header.chain(section.rows.iter().map(WatchRow::has_changed))
    });
    let rows = WholeRows {
        name: "watch",
        heights: &heights,
        most,
        focus: changed.position(|has_changed| has_changed),
        moment: asked.moment,
    };
    rows.show(ui, |ui| table.sections(ui, asked, &mut shown));
    let rest = top + room.height.min(most) - ui.cursor().top();
    ui.add_space(rest.max(0.0));
    shown
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
        let is_large = look.theme.text_scale > 1.0;
        let row_size = if is_large { LARGE_ROW_SIZE } else { ROW_SIZE };
        Self {
            look,
            lit,
            small: TextStyle::Small.resolve(ui.style()),
            height: target(ui, (mono.size * row_size).round()),
            mono,
        }
    }

    fn heights(&self, watch: &Watch) -> Vec<f32> {
        let mut heights = Vec::new();
        for (i, section) in watch.iter().enumerate() {
            let n = section.rows.len() + usize::from(!section.header.is_empty());
            let gap = if i > 0 { SECTION_GAP } else { 0.0 };
            let first = heights.len();
            heights.resize(first + n, self.height);
            if !section.header.is_empty() {
                heights[first] = self.header_height(section);
            }
            heights
                .iter_mut()
                .skip(first)
                .take(1)
                .for_each(|height| *height += gap);
        }
        heights
    }

    fn sections(&mut self, ui: &mut Ui, asked: &WatchTable<'_>, shown: &mut WatchShown) {
        let room = asked.room.0;
        let natural = self.mono.clone();
        let width = ui.available_width();
        ui.spacing_mut().item_spacing.y = 0.0;
        for (i, section) in asked.watch.iter().enumerate() {
            let Some(known) = room.section_idx(section).map(|i| &room.sections[i]) else {
                continue;
            };
            if i > 0 && !(section.rows.is_empty() && section.header.is_empty()) {
                ui.add_space(SECTION_GAP);
            }
            // Where the columns do not fit, smaller digits are better than digits in each other's place; and if those would be too
            // small to read, digits of the type of words, which are less wide.
            let ([_, scale], fits) = known.fit(width);
            self.mono.size = natural.size * scale;
            self.mono.family = if fits {
                natural.family.clone()
            } else {
                FontFamily::Proportional
            };
            let columns = known.columns(width);
            if !section.header.is_empty() {
                self.header(ui, section, &columns);
            }
            for row in &section.rows {
                let is_table = !section.header.is_empty();
                let is_typed = row.link.is_some_and(asked.is_typed);
                let response = self.row(ui, row, &columns, (is_table, is_typed));
                if response.hovered() {
                    shown.pointed = row.link.or(shown.pointed);
                }
                if let Some(link) = row.link.filter(|_| response.clicked()) {
                    let at = response.interact_pointer_pos();
                    shown.clicked = Some((link, at.unwrap_or_else(|| response.rect.center())));
                }
            }
        }
    }

    fn set(&self, ui: &Ui, value: &Value, colour: Color32) -> Typeset {
        let font = self.mono.clone();
        let span = Span::value(self.look.catalog, value, font, colour);
        Typeset::line(ui.painter(), &[span])
    }

    /// Of a title or a name in words, which stand over each other where they have no room; of another its width.
    fn widest_word(&self, ui: &Ui, title: &Value) -> f32 {
        if !is_words(title, true) {
            return self.set(ui, title, Color32::PLACEHOLDER).size().x;
        }
        let said = self.look.catalog.value(title);
        let width = |word: &str| {
            let (word, font) = (word.to_owned(), self.small.clone());
            let galley = (ui.painter()).layout_no_wrap(word, font, Color32::PLACEHOLDER);
            galley.size().x
        };
        said.split(' ').map(width).fold(0.0, f32::max)
    }

    /// A name in one line: of a table, if it is words, in the type of words.
    fn name(&self, ui: &Ui, (name, is_table): (&Value, bool), colour: Color32) -> Typeset {
        if is_words(name, is_table) {
            self.words(ui, name, colour, f32::INFINITY)
        } else {
            self.set(ui, name, colour)
        }
    }

    fn words(&self, ui: &Ui, words: &Value, colour: Color32, room: f32) -> Typeset {
        let span = Span::value(self.look.catalog, words, self.small.clone(), colour);
        Typeset::wrapped(ui.painter(), &[span], room)
    }

    fn header_height(&self, section: &WatchSection) -> f32 {
        const LINES: f32 = 2.5;
        let is_words = |title: &Value| self.look.catalog.value(title).contains(' ');
        if section.header.iter().any(is_words) {
            self.height.max((LINES * self.small.size).round())
        } else {
            self.height
        }
    }

    fn header(&self, ui: &mut Ui, section: &WatchSection, columns: &[f32]) {
        let size = vec2(ui.available_width(), self.header_height(section));
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        // A header may name the column of names too.
        let skip = section.header.len().saturating_sub(columns.len());
        let colour = self.look.theme.soft;
        let titles = section.header[skip..].iter().zip(columns.iter().copied());
        let names = section.header[..skip].iter().zip([DOT_ROOM]);
        for (title, x) in names.chain(titles) {
            let at = pos2(rect.left() + x, rect.center().y);
            let next = columns.iter().copied().find(|next| *next > x);
            let room = next.map_or(rect.width(), |next| next - GAP) - x;
            let title = if is_words(title, true) {
                self.words(ui, title, colour, room)
            } else {
                self.set(ui, title, colour)
            };
            title.paint(ui.painter(), at, Align2::LEFT_CENTER);
        }
    }

    fn row(
        &self,
        ui: &mut Ui,
        row: &WatchRow,
        columns: &[f32],
        (is_table, is_typed): (bool, bool),
    ) -> Response {
        let theme = self.look.theme;
        let size = vec2(ui.available_width(), self.height);
        let (sense, role) = if is_typed {
            (Sense::click(), Role::Button)
        } else {
            (Sense::hover(), Role::Label)
        };
        let (rect, response) = ui.allocate_exact_size(size, sense);
        response.widget_info(|| WidgetInfo::labeled(role, true, self.spoken(row)));
        if row.link.is_some() && (response.hovered() || row.link == self.lit) {
            let wash = rect.expand2(vec2(8.0, 0.0));
            ui.painter().rect_filled(wash, 0.0, theme.accent_wash);
        }
        focus_ring(ui.painter(), self.look, &response, rect, 0.0);
        let y = rect.center().y;
        if row.has_changed() {
            let dot = pos2(rect.left() + 1.0, y);
            ui.painter().circle_filled(dot, 2.5, theme.signal);
        }
        let at = |x: f32| pos2(rect.left() + x, y);
        let mut name = self.name(ui, (&row.name, is_table), theme.soft);
        let room = columns.first().map_or(rect.width(), |first| first - GAP) - DOT_ROOM;
        if is_words(&row.name, is_table) && name.size().x > room {
            name = self.words(ui, &row.name, theme.soft, room);
        }
        name.paint(ui.painter(), at(DOT_ROOM), Align2::LEFT_CENTER);
        let mut end = rect.left();
        let nothing = Value::Name(if is_table { "" } else { "–" }.to_owned());
        for (i, (cell, x)) in row.cells.iter().zip(columns).enumerate() {
            let (value, ink) = match cell {
                Some(value) if row.changed.get(i) == Some(&true) => (value, theme.signal_text),
                Some(value) => (value, theme.ink),
                None => (&nothing, theme.soft),
            };
            let set = self.set(ui, value, ink);
            end = set.paint(ui.painter(), at(*x), Align2::LEFT_CENTER).right();
        }
        if let Some(note) = &row.note {
            let (catalog, small) = (self.look.catalog, self.small.clone());
            let note = Span::value(catalog, note, small, theme.soft);
            let note = Typeset::line(ui.painter(), &[note]);
            // Where there is no room it is left out, as it only explains.
            if rect.right() - note.size().x >= end + 8.0 {
                note.paint(ui.painter(), rect.right_center(), Align2::RIGHT_CENTER);
            }
        }
        if is_typed {
            response.on_hover_cursor(CursorIcon::Text)
        } else {
            response
        }
    }

    fn spoken(&self, row: &WatchRow) -> String {
        let cells = row.cells.iter().flatten().chain(&row.note);
        let values = std::iter::once(&row.name).chain(cells);
        let words = values.map(|value| self.look.catalog.value(value));
        words.collect::<Vec<_>>().join(" ")
    }
}
