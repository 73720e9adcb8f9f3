//! Rows that are too many for their room: as many as fit whole are in sight, none is cut.

use std::ops::Range;

use egui::{Id, Rect, ScrollArea, Ui, UiBuilder, vec2};

pub struct WholeRows<'a> {
    pub name: &'static str,
    pub heights: &'a [f32],
    /// The room that they have; it is taken up whole where they are too many.
    pub most: f32,
    /// The row that comes into sight when it, or the `moment`, is another one.
    pub focus: Option<usize>,
    pub moment: usize,
}

impl WholeRows<'_> {
    /// Draws the rows: `add` draws all of them, each as high as was said. The scroll bar stands in the margin on the right,
    /// so that they are as wide with it as without.
    pub fn show<R>(self, ui: &mut Ui, add: impl FnOnce(&mut Ui) -> R) -> R {
        let all: f32 = self.heights.iter().sum();
        if all <= self.most {
            return ui.scope(add).inner;
        }
        let id = Id::unique(("whole rows", self.name));
        let last = ui.data(|data| data.get_temp::<(usize, Id)>(id));
        let first = last.map_or(0, |(first, _)| first);
        let rows = in_sight(self.heights, self.focus, first, self.most);
        let above: f32 = self.heights[..rows.start].iter().sum();
        let sizes = [above, all].map(f32::to_bits);
        let shown = Id::unique((self.moment, self.focus, &rows, sizes));
        let height: f32 = self.heights[rows.clone()].iter().sum();
        let width = ui.available_width();
        let at = ui.cursor().min;
        let beside = vec2(width + ui.spacing().scroll.allocated_width(), height);
        let inner = UiBuilder::new()
            .id_salt(self.name)
            .max_rect(Rect::from_min_size(at, beside));
        let mut area = ScrollArea::vertical()
            .id_salt(self.name)
            .max_height(height)
            .min_scrolled_height(height);
        if last != Some((rows.start, shown)) {
            area = area.vertical_scroll_offset(above);
            ui.data_mut(|data| data.insert_temp(id, (rows.start, shown)));
        }
        let mut inner = ui.new_child(inner);
        // It comes to rest at whole rows, not where it bounces back from.
        inner.spacing_mut().scroll.kinetic.rubber_band = false;
        let shown = area.show(&mut inner, |ui| {
            ui.set_max_width(width);
            add(ui)
        });
        ui.advance_cursor_after_rect(Rect::from_min_size(at, vec2(width, self.most)));
        shown.inner
    }
}

/// As many rows as fit whole: from the `first` on, or as near to that as has the one in focus among them.
fn in_sight(heights: &[f32], focus: Option<usize>, first: usize, most: f32) -> Range<usize> {
    let fitting = |heights: &mut dyn Iterator<Item = &f32>| {
        let mut room = most;
        let whole = heights.take_while(|height| {
            room -= **height;
            room >= 0.0
        });
        whole.count()
    };
    let up_from = |end: usize| end - fitting(&mut heights[..end].iter().rev());
    let n = heights.len();
    let first = first.min(up_from(n));
    let first = match focus {
        Some(focus) if focus < first => focus,
        Some(focus) => first.max(up_from((focus + 1).min(n))),
        None => first,
    };
    first..first + fitting(&mut heights[first..].iter())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_as_fit_are_in_sight_and_the_one_in_focus_among_them() {
        let heights = [10.0, 20.0, 10.0, 10.0, 30.0];
        let seen = |focus, first| in_sight(&heights, focus, first, 45.0);
        assert_eq!(seen(None, 0), 0..3);
        assert_eq!(seen(Some(2), 0), 0..3, "nothing moves that need not");
        assert_eq!(seen(Some(3), 0), 1..4);
        assert_eq!(seen(Some(1), 3), 1..4, "back up");
        assert_eq!(seen(Some(4), 1), 3..5);
        assert_eq!(seen(None, 4), 3..5, "no room is left empty below the last");
    }
}
