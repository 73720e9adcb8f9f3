//! Operations done so far, as bars: this run's, and another's to compare with.

use egui::{RichText, Role};

use crate::trace::Counts;

use super::prelude::*;

pub struct Cost<'a> {
    pub now: Counts,
    pub compared: Option<(Counts, &'a str)>,
    /// The most of any kind that either run does in the end: the bars' full length.
    pub most: u64,
}

const GAP: f32 = 20.0;
const INNER_GAP: f32 = 8.0;
const BAR: f32 = 5.0;
const OTHER_BAR: f32 = 4.0;

pub fn most_of_a_kind(runs: &[Counts]) -> u64 {
    let counts = runs.iter().flat_map(|run| KINDS.map(|(.., of)| of(run)));
    counts.max().unwrap_or_default()
}

pub type Kind = (&'static str, &'static str, fn(&Counts) -> u64);

pub const KINDS: [Kind; 4] = [
    ("cost-divisions", "cost-divisions", |c| c.div),
    ("cost-multiplications", "cost-multiplications", |c| c.mul),
    ("cost-sums", "cost-additions", |c| c.add),
    ("cost-comparisons", "cost-comparisons", |c| c.cmp),
];

pub fn cost(ui: &mut Ui, look: Look<'_>, cost: &Cost<'_>) {
    let bars = Bars::new(ui.painter(), look, cost, ui.available_width());
    let size = vec2(ui.available_width(), bars.height());
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    bars.paint(ui.painter(), rect);
    for (i, kind) in KINDS.iter().enumerate() {
        let (key, name_key, _) = kind;
        let name = look.say(name_key);
        let said = format!("{name}: {}", bars.numbers(kind));
        let id = ui.scope_id().with(("cost", key));
        let response = ui.interact(bars.cell(rect, i), id, Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &said));
        response.on_hover_text(name);
    }
    if let Some((_, name)) = cost.compared {
        let note = Message::new("cost-compared-with").with("method", name.to_owned());
        let note = RichText::new(look.catalog.message(&note)).small();
        ui.label(note.color(look.theme.soft));
    }
}

pub struct Bars<'a> {
    look: Look<'a>,
    cost: &'a Cost<'a>,
    small: FontId,
    mono: FontId,
    n_columns: usize,
    width: f32,
    widest: [f32; 2],
}

impl<'a> Bars<'a> {
    pub fn new(painter: &Painter, look: Look<'a>, cost: &'a Cost<'a>, width: f32) -> Self {
        let style = painter.ctx().global_style();
        let mut bars = Self {
            look,
            cost,
            small: TextStyle::Small.resolve(&style),
            mono: TextStyle::Monospace.resolve(&style),
            n_columns: 1,
            width,
            widest: [0.0; 2],
        };
        // The numbers of the end are the widest: nothing moves on the way there.
        let end = cost.most;
        for kind in &KINDS {
            let texts = bars.texts(painter, kind, bars.written(end, end));
            for (widest, text) in bars.widest.iter_mut().zip(&texts) {
                *widest = widest.max(text.size().x);
            }
        }
        let cell = bars.widest[0] + bars.gap() + bars.widest[1];
        let fits = |n: &usize| *n as f32 * (cell + GAP) - GAP <= width;
        bars.n_columns = [4, 2].into_iter().find(fits).unwrap_or(1);
        bars
    }

    pub fn height(&self) -> f32 {
        let n_rows = KINDS.len().div_ceil(self.n_columns);
        n_rows as f32 * self.row_height()
    }

    pub fn paint(&self, painter: &Painter, rect: Rect) {
        let theme = self.look.theme;
        for (i, kind) in KINDS.iter().enumerate() {
            let cell = self.cell(rect, i);
            let y = cell.top() + 0.5 * self.text_height();
            let [name, numbers] = self.texts(painter, kind, self.numbers(kind));
            name.paint(painter, pos2(cell.left(), y), Align2::LEFT_CENTER);
            numbers.paint(painter, pos2(cell.right(), y), Align2::RIGHT_CENTER);
            let room = self.room(cell);
            let mut top = room.top();
            let mut bar = |counts: &Counts, height: f32, colour| {
                let share = (kind.2)(counts) as f32 / self.cost.most.max(1) as f32;
                let size = vec2(room.width() * share, height * theme.text_scale);
                let bar = Rect::from_min_size(pos2(room.left(), top), size);
                painter.rect_filled(bar, 1.0, colour);
                top = bar.bottom() + 1.0;
            };
            bar(&self.cost.now, BAR, theme.accent);
            if let Some((other, _)) = &self.cost.compared {
                bar(other, OTHER_BAR, theme.discarded);
            }
        }
    }

    fn texts(&self, painter: &Painter, kind: &Kind, numbers: String) -> [Typeset; 2] {
        let theme = self.look.theme;
        let name = self.look.say(kind.0);
        [
            Typeset::text(painter, name, self.small.clone(), theme.soft),
            Typeset::text(painter, numbers, self.mono.clone(), theme.ink),
        ]
    }

    fn numbers(&self, kind: &Kind) -> String {
        let other = self.cost.compared.as_ref();
        let other = other.map_or(0, |(other, _)| (kind.2)(other));
        self.written((kind.2)(&self.cost.now), other)
    }

    fn written(&self, now: u64, other: u64) -> String {
        let [now, other] = [now, other].map(|n| {
            let n = usize::try_from(n).unwrap_or(usize::MAX);
            self.look.catalog.value(&Value::Count(n))
        });
        match &self.cost.compared {
            Some(_) => format!("{now} ({other})"),
            None => now,
        }
    }

    fn text_height(&self) -> f32 {
        (self.mono.size * 1.4).round()
    }

    fn gap(&self) -> f32 {
        INNER_GAP * self.look.theme.text_scale
    }

    fn bars_height(&self) -> f32 {
        let other = self.cost.compared.map_or(0.0, |_| 1.0 + OTHER_BAR);
        (BAR + other) * self.look.theme.text_scale
    }

    fn row_height(&self) -> f32 {
        if self.n_columns == 1 {
            return (self.text_height() * 1.2).round();
        }
        (self.text_height() + self.bars_height() + 5.0).round()
    }

    fn room(&self, cell: Rect) -> Rect {
        if self.n_columns > 1 {
            return cell.with_min_y(cell.top() + self.text_height());
        }
        let [left, right] = self.widest.map(|width| width + self.gap());
        let top = cell.top() + 0.5 * (self.text_height() - self.bars_height());
        let right = (cell.right() - right).max(cell.left() + left);
        Rect::from_x_y_ranges(cell.left() + left..=right, top..=cell.bottom())
    }

    fn cell(&self, rect: Rect, i: usize) -> Rect {
        let n = self.n_columns as f32;
        let width = (self.width - (n - 1.0) * GAP) / n;
        let [row, column] = [i / self.n_columns, i % self.n_columns].map(|k| k as f32);
        let at = rect.min + vec2(column * (width + GAP), row * self.row_height());
        Rect::from_min_size(at, vec2(width, self.row_height()))
    }
}
