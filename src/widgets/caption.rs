//! A step's sentence: the decision semibold, the arithmetic after it.

use egui::{Label, UiBuilder, accesskit::Live};

use crate::{
    figure::Caption,
    paint::theme,
    text::{Catalog, Piece},
};

use super::prelude::*;

/// Room for a line with a stacked quotient, whether or not it has one.
const ROW_PTS: f32 = 32.0;
const MARGIN_PTS: f32 = 8.0;
/// What is too long is set in smaller type, down to this, before anything is left out.
const SMALLER: [f32; 3] = [1.0, 0.9, 0.8];
const MOST_MEASURED: usize = 4;

/// Height of the bar that has room for each of these captions, whole, in lines of at most `width` points: the same at
/// every step, so that nothing moves.
pub fn height_for_all(
    painter: &Painter,
    look: Look<'_>,
    captions: impl IntoIterator<Item = Caption>,
    width: f32,
) -> f32 {
    let captions = captions.into_iter();
    let captions = captions.map(|caption| (caption_text(look.catalog, &caption), caption));
    let mut by_length: Vec<(String, Caption)> = captions.collect();
    by_length.sort_by_key(|(text, _)| std::cmp::Reverse(text.len()));
    // The highest is one of the longest, or of the longest with a quotient, which is stacked.
    let by_length = by_length.into_iter();
    let (stacked, flat): (Vec<_>, Vec<_>) = by_length.partition(|(text, _)| text.contains(" / "));
    let longest = [stacked, flat].into_iter();
    let longest = longest.flat_map(|captions| captions.into_iter().take(MOST_MEASURED));
    let height = |(_, caption): (String, Caption)| {
        let room = vec2(width, f32::INFINITY);
        in_lines(painter, look, &caption, room).0.size().y
    };
    let one = ROW_PTS * look.theme.title_scale;
    let most = longest.map(height).fold(one, f32::max);
    (2.0 * MARGIN_PTS + most).ceil()
}

pub fn caption_text(catalog: &Catalog, caption: &Caption) -> String {
    let formulas = caption.arithmetic.iter();
    let arithmetic = in_a_row(formulas.map(|f| catalog.formula_pieces(f)).collect());
    catalog.message(&caption.decision) + &Piece::plain(&arithmetic)
}

/// Draws the caption in `rect` on as many lines as it takes and there is room for, the first of them always in one place.
pub fn caption(ui: &mut Ui, look: Look<'_>, rect: Rect, shown: &Caption) {
    let inner = rect.shrink2(vec2(0.0, MARGIN_PTS).min(rect.size() * 0.1));
    let (lines, is_whole) = in_lines(ui.painter(), look, shown, inner.size());
    let height = lines.size().y;
    // Its first line stands in the middle of the room that a line has; higher up if the last would not fit below that.
    let middle = inner.top() + 0.5 * ROW_PTS * look.theme.title_scale;
    let first = lines.galley().rows.first().map_or(0.0, |row| row.size.y);
    let top = (middle - 0.5 * first).min(inner.bottom() - height).round();
    let size = vec2(inner.width(), height);
    let place = Rect::from_min_size(pos2(inner.left(), top), size);
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        let said = caption_text(look.catalog, shown);
        let label = ui.add(Label::new(lines.galley()).selectable(true));
        // However it is set, it is read as a whole, and each step's when it comes.
        ui.ctx().accesskit_node_builder(label.id, |node| {
            node.set_value(&*said);
            node.set_live(Live::Polite);
            node.set_author_id("caption");
        });
        if !is_whole {
            label.on_hover_ui(|ui| {
                let room = vec2(ui.spacing().tooltip_width, f32::INFINITY);
                let (whole, _) = in_lines(ui.painter(), look, shown, room);
                ui.label(whole.galley());
            });
        }
    });
}

/// Sets a caption in lines. Where it does not fit into the room it is smaller, and where that is not enough, steps are
/// left out from the middle of its arithmetic; the decision is always whole. Is all of it there?
fn in_lines(painter: &Painter, look: Look<'_>, caption: &Caption, room: Vec2) -> (Typeset, bool) {
    let style = painter.ctx().global_style();
    let font = |of: TextStyle, part: f32| {
        let font = of.resolve(&style);
        FontId::new(part * font.size, font.family)
    };
    let set = |(formulas, part): (Vec<Vec<Piece>>, f32)| {
        let fonts = [theme::caption_strong(), theme::caption()].map(|of| font(of, part));
        Typeset::wrapped(painter, &spans(look, caption, formulas, fonts), room.x)
    };
    let [.., smallest] = SMALLER;
    let mut shorter = shorter_and_shorter(look.catalog, caption);
    let whole = shorter.next().unwrap_or_default();
    let smaller = SMALLER.into_iter().map(|part| (whole.clone(), part));
    let smaller = smaller.map(|formulas| (set(formulas), true));
    let shorter = shorter.map(|formulas| (set((formulas, smallest)), false));
    let fitting = smaller
        .chain(shorter)
        .find(|(lines, _)| lines.size().y <= room.y);
    fitting.unwrap_or_else(|| (set((Vec::new(), smallest)), false))
}

fn spans(
    look: Look<'_>,
    caption: &Caption,
    formulas: Vec<Vec<Piece>>,
    [strong, plain]: [FontId; 2],
) -> [Span; 2] {
    let decision = look.catalog.message_pieces(&caption.decision);
    [
        Span::upright(decision, strong, look.theme.ink),
        Span::upright(in_a_row(formulas), plain, look.theme.soft),
    ]
}

/// The same as running text, as wide as there is room.
pub fn explained(ui: &mut Ui, look: Look<'_>, shown: &Caption) {
    let font = TextStyle::Body.resolve(ui.style());
    let formulas = shown.arithmetic.iter();
    let formulas = formulas.map(|f| look.catalog.formula_pieces(f)).collect();
    let spans = spans(look, shown, formulas, [font.clone(), font]);
    set_label(ui, &spans, &caption_text(look.catalog, shown));
}

/// Text with its quotients stacked, which can be selected; `said` is what a screen reader reads.
pub fn set_label(ui: &mut Ui, spans: &[Span], said: &str) {
    let lines = Typeset::wrapped(ui.painter(), spans, ui.available_width());
    let label = ui.add(Label::new(lines.galley()).selectable(true));
    (ui.ctx()).accesskit_node_builder(label.id, |node| node.set_value(said));
}

/// All of a caption's formulas, then fewer: those in the middle are left out first, then the steps in the middle of the
/// one that is left, and that one last.
fn shorter_and_shorter(
    catalog: &Catalog,
    caption: &Caption,
) -> impl Iterator<Item = Vec<Vec<Piece>>> {
    let left_out = |text: &str| vec![Piece::Text(text.to_owned())];
    let formulas = caption.arithmetic.iter();
    let formulas: Vec<Vec<Piece>> = formulas.map(|f| catalog.formula_pieces(f)).collect();
    let first = formulas.first();
    let steps = first.map_or_else(Vec::new, |first| Piece::steps(first));
    let fewer = (1..=formulas.len()).rev();
    let fewer = fewer.map(move |n| without_middle(&formulas, n, left_out("…")));
    let shorter = (2..steps.len()).rev();
    let shorter = shorter.map(move |n| vec![without_middle(&steps, n, left_out("… ")).concat()]);
    fewer.chain(shorter).chain([Vec::new()])
}

fn without_middle<T: Clone>(all: &[T], n: usize, left_out: T) -> Vec<T> {
    if n >= all.len() {
        return all.to_vec();
    }
    let (head, tail) = (&all[..n.div_ceil(2)], &all[all.len() - n / 2..]);
    [head, &[left_out], tail].concat()
}

fn in_a_row(formulas: Vec<Vec<Piece>>) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for (i, formula) in formulas.into_iter().enumerate() {
        pieces.push(Piece::Text(if i == 0 { "  " } else { ",  " }.to_owned()));
        pieces.push(Piece::Kept(formula));
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Lang;

    #[test]
    fn what_is_too_long_is_left_out_from_the_middle() {
        let formula = |symbol: &'static str| {
            let sum = Formula::default().sym(symbol).sym(" = 1 + 1 + 1");
            sum.equals(3.0)
        };
        let caption = Caption::new(Message::new("transport-step"));
        let caption = ["x", "y", "z"]
            .map(formula)
            .into_iter()
            .fold(caption, Caption::so);
        let said: Vec<String> = shorter_and_shorter(Catalog::of(Lang::En), &caption)
            .map(|formulas| Piece::plain(&in_a_row(formulas)))
            .collect();
        let expected = [
            "  x = 1 + 1 + 1 = 3,  y = 1 + 1 + 1 = 3,  z = 1 + 1 + 1 = 3",
            "  x = 1 + 1 + 1 = 3,  …,  z = 1 + 1 + 1 = 3",
            "  x = 1 + 1 + 1 = 3,  …",
            "  x … = 3",
            "",
        ];
        assert_eq!(said, expected);
    }
}
