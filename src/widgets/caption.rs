//! A step's sentence: the decision semibold, the arithmetic after it.

use egui::{FontId, Label, Painter, Rect, TextStyle, Ui, UiBuilder, Vec2, pos2, vec2};

use crate::{
    figure::Caption,
    paint::{Span, Theme, Typeset, theme},
    text::{Catalog, Piece},
};

use super::look::Look;

/// Room for a line with a stacked quotient, whether or not it has one.
const ROW_PTS: f32 = 32.0;
/// White space above and below.
const MARGIN_PTS: f32 = 8.0;

/// What is too long is set in smaller type, down to this, before anything is left out.
const SMALLER: [f32; 3] = [1.0, 0.9, 0.8];

/// Of many captions so many are set to see how high they are.
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
    let mut by_length: Vec<(String, Caption)> = captions
        .map(|caption| (caption_text(look.catalog, &caption), caption))
        .collect();
    by_length.sort_by_key(|(text, _)| std::cmp::Reverse(text.len()));
    // The highest is one of the longest, or of the longest with a quotient, which is stacked.
    let (stacked, flat): (Vec<_>, Vec<_>) = by_length
        .into_iter()
        .partition(|(text, _)| text.contains(" / "));
    let longest = [stacked, flat].into_iter();
    let longest = longest.flat_map(|captions| captions.into_iter().take(MOST_MEASURED));
    let height = |(_, caption): (String, Caption)| {
        CaptionLayout::new(painter, look, &caption, vec2(width, f32::INFINITY)).height()
    };
    let one = ROW_PTS * look.theme.title_scale;
    let most = longest.map(height).fold(one, f32::max);
    (2.0 * MARGIN_PTS + most).ceil()
}

/// The caption as plain text, for screen readers and tooltips.
pub fn caption_text(catalog: &Catalog, caption: &Caption) -> String {
    let formulas = caption.arithmetic.iter();
    let arithmetic = in_a_row(formulas.map(|f| catalog.formula_pieces(f)).collect());
    catalog.message(&caption.decision) + &Piece::plain(&arithmetic)
}

/// Draws the caption in `rect` on as many lines as it takes and there is room for. Its first line stands where it stands
/// at every other step.
pub fn caption(ui: &mut Ui, look: Look<'_>, rect: Rect, shown: &Caption) {
    let inner = rect.shrink2(vec2(0.0, MARGIN_PTS).min(rect.size() * 0.1));
    let layout = CaptionLayout::new(ui.painter(), look, shown, inner.size());
    let top = layout.top(inner, look.theme);
    let place = Rect::from_min_size(
        pos2(inner.left(), top),
        vec2(inner.width(), layout.height()),
    );
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        ui.add(Label::new(layout.0.galley()).selectable(true))
            .on_hover_text(caption_text(look.catalog, shown));
    });
}

/// A caption set in lines.
pub struct CaptionLayout(Typeset);

impl CaptionLayout {
    /// Sets a caption in lines. Where it does not fit into the room it is smaller, and where that is not enough, steps are
    /// left out from the middle of its arithmetic; the decision is always whole.
    pub fn new(painter: &Painter, look: Look<'_>, caption: &Caption, room: Vec2) -> Self {
        let style = painter.ctx().global_style();
        let font = |of: TextStyle, part: f32| {
            let font = of.resolve(&style);
            FontId::new(part * font.size, font.family)
        };
        let set = |(formulas, part): (Vec<Vec<Piece>>, f32)| {
            let decision = Span::message(
                look.catalog,
                &caption.decision,
                font(theme::caption_strong(), part),
                look.theme.ink,
            );
            let face = font(theme::caption(), part);
            let arithmetic = Span::upright(in_a_row(formulas), face, look.theme.soft);
            Typeset::wrapped(painter, &[decision, arithmetic], room.x)
        };
        let [.., smallest] = SMALLER;
        let mut shorter = shorter_and_shorter(look.catalog, caption);
        let whole = shorter.next().unwrap_or_default();
        let smaller = SMALLER.into_iter().map(|part| (whole.clone(), part));
        let fitting = smaller
            .chain(shorter.map(|formulas| (formulas, smallest)))
            .map(set)
            .find(|typeset| typeset.size().y <= room.y);
        Self(fitting.unwrap_or_else(|| set((Vec::new(), smallest))))
    }

    /// Of all its lines.
    pub fn height(&self) -> f32 {
        self.0.size().y
    }

    /// Where its top goes so that its first line stands in the middle of the room that a line has; higher up if it would
    /// not fit below that.
    fn top(&self, inner: Rect, theme: &Theme) -> f32 {
        let middle = inner.top() + 0.5 * ROW_PTS * theme.title_scale;
        let first = self.0.galley().rows.first().map_or(0.0, |row| row.size.y);
        let top = middle - 0.5 * first;
        top.min(inner.bottom() - self.height()).round()
    }
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
    let steps = formulas
        .first()
        .map_or_else(Vec::new, |first| Piece::steps(first));
    let fewer = (1..=formulas.len())
        .rev()
        .map(move |n| without_middle(&formulas, n, left_out("…")));
    let shorter = (2..steps.len())
        .rev()
        .map(move |n| vec![without_middle(&steps, n, left_out("… ")).concat()]);
    fewer.chain(shorter).chain([Vec::new()])
}

/// The first and the last of these, `n` in all, and between them what stands for the others.
fn without_middle<T: Clone>(all: &[T], n: usize, left_out: T) -> Vec<T> {
    if n >= all.len() {
        return all.to_vec();
    }
    let (head, tail) = (&all[..n.div_ceil(2)], &all[all.len() - n / 2..]);
    head.iter()
        .cloned()
        .chain([left_out])
        .chain(tail.iter().cloned())
        .collect()
}

/// Formulas after each other, and after the decision.
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
    use crate::text::{Formula, Lang};

    #[test]
    fn what_is_too_long_is_left_out_from_the_middle() {
        let formula = |symbol: &'static str| {
            Formula::default()
                .sym(symbol)
                .sym(" = 1 + 1 + 1")
                .equals(3.0)
        };
        let caption = Caption::new(crate::text::Message::new("transport-step"))
            .so(formula("x"))
            .so(formula("y"))
            .so(formula("z"));
        let said: Vec<String> = shorter_and_shorter(Catalog::of(Lang::En), &caption)
            .map(|formulas| Piece::plain(&in_a_row(formulas)))
            .collect();
        assert_eq!(
            said,
            [
                "  x = 1 + 1 + 1 = 3,  y = 1 + 1 + 1 = 3,  z = 1 + 1 + 1 = 3",
                "  x = 1 + 1 + 1 = 3,  …,  z = 1 + 1 + 1 = 3",
                "  x = 1 + 1 + 1 = 3,  …",
                "  x … = 3",
                "",
            ]
        );
    }
}
