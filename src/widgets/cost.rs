//! Operations done so far, as bars: this run's, and another's to compare with.

use egui::{Align2, Rect, RichText, Role, Sense, TextStyle, Ui, WidgetInfo, pos2, vec2};

use crate::{text::Message, trace::Counts};

use super::Look;

/// A run's cost, and another's.
pub struct Cost<'a> {
    /// Up to this step.
    pub now: Counts,
    /// The other run's, with its method's name.
    pub compared: Option<(Counts, &'a str)>,
    /// The most of any kind that either run does in the end: the bars' full length.
    pub most: u32,
}

/// Draws four rows of bars with their numbers.
pub fn cost(ui: &mut Ui, look: Look<'_>, cost: &Cost<'_>) {
    ui.spacing_mut().item_spacing.y = 0.0;
    let other = cost.compared.map(|(counts, _)| counts);
    for (sign, key, of) in ROWS {
        row(
            ui,
            look,
            sign,
            key,
            of(&cost.now),
            other.as_ref().map(of),
            cost.most.max(1),
        );
    }
    if let Some((_, name)) = cost.compared {
        ui.add_space(4.0);
        let note = Message::new("cost-compared-with").with("method", name.to_owned());
        ui.label(
            RichText::new(look.catalog.message(&note))
                .small()
                .color(look.theme.soft),
        );
    }
}

type Of = fn(&Counts) -> u32;

/// Dearest first.
const ROWS: [(&str, &str, Of); 4] = [
    ("÷", "cost-divisions", |c| c.div),
    ("×", "cost-multiplications", |c| c.mul),
    ("+ −", "cost-additions", |c| c.add),
    ("<", "cost-comparisons", |c| c.cmp),
];

fn row(
    ui: &mut Ui,
    look: Look<'_>,
    sign: &str,
    key: &str,
    now: u32,
    other: Option<u32>,
    most: u32,
) {
    let theme = look.theme;
    let mono = TextStyle::Monospace.resolve(ui.style());
    let height = (mono.size * 1.75).round();
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let numbers = match other {
        Some(other) => format!("{now} / {other}"),
        None => now.to_string(),
    };
    let name = look.say(key);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, format!("{name}: {numbers}")));
    let y = rect.center().y;
    let painter = ui.painter();
    painter.text(
        pos2(rect.left() + 8.0, y),
        Align2::LEFT_CENTER,
        sign,
        mono.clone(),
        theme.soft,
    );
    let written = painter.text(
        pos2(rect.right(), y),
        Align2::RIGHT_CENTER,
        &numbers,
        mono,
        theme.ink,
    );
    let left = rect.left() + 48.0 * theme.text_scale;
    // The numbers of all rows share one column, so that all bars share one scale.
    let room = (rect.right() - 72.0 * theme.text_scale).min(written.left() - 8.0) - left;
    let bar = |top: f32, count: u32, height: f32, colour| {
        let width = room.max(0.0) * count as f32 / most as f32;
        let bar = Rect::from_min_size(pos2(left, top), vec2(width, height));
        painter.rect_filled(bar, 1.0, colour);
    };
    match other {
        Some(other) => {
            bar(y - 6.0, now, 6.0, theme.accent);
            bar(y + 1.0, other, 5.0, theme.hairline);
        }
        None => bar(y - 3.0, now, 6.0, theme.accent),
    }
    response.on_hover_text(name);
}
