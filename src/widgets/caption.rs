//! A step's sentence: the decision semibold, the arithmetic after it.

use egui::{
    Align, Color32, Label, Rect, TextFormat, TextStyle, Ui, UiBuilder,
    text::{LayoutJob, TextWrapping},
    vec2,
};

use crate::{
    figure::Caption,
    paint::{Theme, theme},
    text::Catalog,
};

use super::Look;

/// Height of the bar that holds a caption of up to `n_rows`: the same at every step, so that nothing moves.
#[must_use]
pub fn caption_height(theme: &Theme, n_rows: usize) -> f32 {
    (24.0 + 20.0 * n_rows as f32 * theme.text_scale).ceil()
}

/// The caption as plain text, for screen readers and tooltips.
#[must_use]
pub fn caption_text(catalog: &Catalog, caption: &Caption) -> String {
    let mut text = catalog.message(&caption.decision);
    for (i, formula) in caption.arithmetic.iter().enumerate() {
        text.push_str(if i == 0 { "  " } else { ",  " });
        text.push_str(&catalog.formula(formula));
    }
    text
}

/// Draws the caption in `rect`, in the middle of its height, on as many lines as it takes, `n_rows` at most.
pub fn caption(ui: &mut Ui, look: Look<'_>, rect: Rect, n_rows: usize, shown: &Caption) {
    let inner = rect.shrink2(vec2(24.0, 8.0).min(rect.size() * 0.1));
    let job = caption_job(ui, look, shown, inner.width(), n_rows);
    let height = ui.fonts_mut(|fonts| fonts.layout_job(job.clone())).size().y;
    let place = Rect::from_min_size(
        egui::pos2(inner.left(), (inner.center().y - 0.5 * height).round()),
        vec2(inner.width(), height),
    );
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        ui.add(Label::new(job).selectable(true))
            .on_hover_text(caption_text(look.catalog, shown));
    });
}

/// The caption to be laid out in lines of at most `width` points; what does not fit into `max_rows` of them
/// ends in an ellipsis.
#[must_use]
pub fn caption_job(
    ui: &Ui,
    look: Look<'_>,
    caption: &Caption,
    width: f32,
    max_rows: usize,
) -> LayoutJob {
    let format = |style: TextStyle, color: Color32| TextFormat {
        font_id: style.resolve(ui.style()),
        color,
        valign: Align::BOTTOM,
        ..TextFormat::default()
    };
    let strong = format(theme::caption_strong(), look.theme.ink);
    let soft = format(theme::caption(), look.theme.soft);
    let mut job = LayoutJob {
        wrap: TextWrapping {
            max_width: width,
            max_rows,
            ..TextWrapping::default()
        },
        ..LayoutJob::default()
    };
    job.append(&look.catalog.message(&caption.decision), 0.0, strong);
    let last = caption.arithmetic.len().saturating_sub(1);
    for (i, formula) in caption.arithmetic.iter().enumerate() {
        let mut text = unbroken(&look.catalog.formula(formula));
        if width_of(ui, &text, &soft) > width {
            // Too long for any line: it goes on before a relation, not within a number.
            for relation in ['=', '≈'] {
                text = text.replace(&format!("\u{a0}{relation}"), &format!(" {relation}"));
            }
        }
        if i < last {
            text.push(',');
        }
        job.append(" ", 8.0, soft.clone());
        job.append(&text, 0.0, soft.clone());
    }
    job
}

/// A formula that does not break across lines as long as it fits on one.
fn unbroken(formula: &str) -> String {
    formula.replace(' ', "\u{a0}")
}

fn width_of(ui: &Ui, text: &str, format: &TextFormat) -> f32 {
    let font = format.font_id.clone();
    let galley = ui.fonts_mut(|fonts| fonts.layout_no_wrap(text.to_owned(), font, format.color));
    galley.size().x
}
