//! How much is left after each of several tests.

use egui::{Align2, Painter, Rect, pos2};

use crate::{
    figure::{Ribbon, RibbonStage},
    widgets::Look,
};

use super::{
    links::Links,
    on_slate::OnSlate,
    slate::{Face, Slate},
};

impl OnSlate for Ribbon {
    fn slate<'a>(&self, painter: &'a Painter, look: Look<'a>, _rect: Rect) -> Slate<'a> {
        Slate::new(painter, look)
    }

    fn draw(&self, slate: &mut Slate<'_>, rect: Rect, _: &mut Links) {
        let theme = slate.theme();
        let width = rect.width() / self.stages.len().max(1) as f32;
        for (i, stage) in self.stages.iter().enumerate() {
            let left = rect.left() + i as f32 * width;
            let title = slate.sentence(&stage.title, width, (Face::Plain, 12.0, theme.soft));
            let put = slate.put(&title, pos2(left, rect.top()), Align2::LEFT_TOP);
            let counts = slate.sentence(&stage.counts, width, (Face::Plain, 13.0, theme.ink));
            slate.put(&counts, put.left_bottom(), Align2::LEFT_TOP);
        }
    }

    fn spoken(&self, look: Look<'_>) -> String {
        let stage = |stage: &RibbonStage| {
            let [title, counts] =
                [&stage.title, &stage.counts].map(|said| look.catalog.message(said));
            format!("{title}: {counts}")
        };
        self.stages.iter().map(stage).collect::<Vec<_>>().join("; ")
    }
}
