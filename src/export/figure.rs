//! One figure: what the stage shows, and the caption under it.

use egui::{Align2, Rect, Ui, pos2, vec2};

use crate::{
    figure::{Frame, Run},
    labs::{Difference, MethodCard, Scene},
    paint::{Headless, Image, Theme, ThemeKind, Viewport, stage},
    text::{Catalog, Lang},
    widgets::{Bars, CaptionLayout, Cost, Look, column_title, most_of_a_kind, strip_height, view},
};

/// A figure is laid out on a page of this size in points, or larger along one side as its shape asks, and
/// then enlarged to its size in pixels: text keeps its proportion to the picture.
const PAGE_PTS: [f32; 2] = [960.0, 540.0];
/// White space beside the caption, and above and below it.
const MARGIN_PTS: [f32; 2] = [24.0, 16.0];
/// Height of the strip that names the method, where two stand side by side.
const TITLE_PTS: f32 = 36.0;
/// A caption may take this many lines: more than any needs on a page of this width.
const MAX_ROWS: usize = 6;

/// What to draw, and how.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// The document.
    pub scene: &'a Scene,
    /// Events folded so far.
    pub step: usize,
    /// The language of the caption.
    pub lang: Lang,
    /// Colours and weights.
    pub theme: ThemeKind,
    /// Width and height in pixels.
    pub size_px: [u32; 2],
}

/// Draws a figure. A table that has drawn others draws it faster; the bytes are the same.
#[must_use]
pub fn draw(table: &mut Headless, picture: &Picture<'_>) -> Image {
    table.set_theme(picture.theme);
    let size = vec2(picture.size_px[0] as f32, picture.size_px[1] as f32);
    let pixels_per_point = (size.x / PAGE_PTS[0]).min(size.y / PAGE_PTS[1]);
    let scene = picture.scene;
    let runs = scene.document().record();
    let all: Vec<&dyn Run> = runs.iter().map(|run| &**run).collect();
    let columns: Vec<Column> = scene
        .document()
        .methods()
        .into_iter()
        .zip(&runs)
        .enumerate()
        .map(|(i, (method, run))| match i {
            0 => Column::new(method, &**run, picture.step),
            _ => Column::new(method, &**run, run.beside(&*runs[0], picture.step)),
        })
        .collect();
    let theme = Theme::of(picture.theme);
    let column_width = size.x / pixels_per_point / columns.len() as f32;
    let page = Page {
        scene,
        look: Look {
            theme,
            catalog: Catalog::of(picture.lang),
        },
        is_comparison: columns.len() > 1,
        most: most_of_a_kind(&columns.iter().map(|c| c.frame.counts).collect::<Vec<_>>()),
        difference: Difference::between(&scene.document().methods(), &all),
        second_height: columns
            .iter()
            .flat_map(|column| column.frame.views.iter().skip(1))
            .filter_map(|view| strip_height(theme, column_width, view))
            .fold(0.0, f32::max),
    };
    table.draw(size / pixels_per_point, pixels_per_point, |ui| {
        let whole = ui.max_rect();
        let width = whole.width() / columns.len() as f32;
        let captions: Vec<_> = columns
            .iter()
            .map(|column| page.caption(ui, width, &column.frame))
            .collect();
        // As much room under both stages, so that they show the same place at the same size.
        let room = captions
            .iter()
            .map(CaptionLayout::height)
            .fold(0.0, f32::max);
        for (i, (column, caption)) in columns.iter().zip(captions).enumerate() {
            let left = whole.left() + width * i as f32;
            let rect = Rect::from_min_size(pos2(left, whole.top()), vec2(width, whole.height()));
            page.column(ui, rect, i, column, (caption, room));
            if i > 0 {
                let hairline = page.look.theme.stroke(1.0, page.look.theme.hairline);
                ui.painter().vline(left, whole.y_range(), hairline);
            }
        }
    })
}

/// One method at one step.
struct Column {
    method: &'static MethodCard,
    frame: Frame,
    at_end: bool,
    /// Could the method take the scene? What it has not done has no cost.
    has_run: bool,
}

impl Column {
    fn new(method: &'static MethodCard, run: &dyn Run, step: usize) -> Self {
        Self {
            method,
            frame: run.frame(step.min(run.n_steps())),
            at_end: step >= run.n_steps(),
            has_run: run.n_steps() > 0,
        }
    }
}

struct Page<'a> {
    scene: &'a Scene,
    look: Look<'static>,
    is_comparison: bool,
    /// Operations at full length of a bar.
    most: u32,
    difference: Option<Difference>,
    /// Height of the second view: the same under both stages, so that they show the same place.
    second_height: f32,
}

impl Page<'_> {
    fn caption(&self, ui: &Ui, width: f32, frame: &Frame) -> CaptionLayout {
        let width = width - 2.0 * MARGIN_PTS[0];
        CaptionLayout::new(ui.painter(), self.look, &frame.caption, width, MAX_ROWS)
    }

    fn column(
        &self,
        ui: &mut Ui,
        rect: Rect,
        index: usize,
        column: &Column,
        (caption, caption_height): (CaptionLayout, f32),
    ) {
        let frame = &column.frame;
        let [margin_x, margin_y] = MARGIN_PTS;
        let cost = Cost {
            now: frame.counts,
            compared: None,
            most: self.most,
        };
        let width = rect.width() - 2.0 * margin_x;
        let bars = self
            .is_comparison
            .then(|| Bars::new(ui.painter(), self.look, &cost, width));
        let cost_height = bars.as_ref().map_or(0.0, |bars| bars.height() + 8.0);
        let bottom = rect.bottom() - margin_y;
        let caption_top = bottom - cost_height - caption_height;
        let strip_top = caption_top - margin_y;
        let title_height = if self.is_comparison {
            TITLE_PTS * self.look.theme.text_scale
        } else {
            0.0
        };
        let stage_rect = rect
            .with_min_y(rect.top() + title_height)
            .with_max_y(strip_top - self.second_height);
        if self.is_comparison {
            self.title(ui, rect, index, column.method);
        }
        self.stage(ui, stage_rect, index, column);
        if let Some(second) = frame.views.get(1) {
            let rect = rect
                .with_min_y(strip_top - self.second_height)
                .with_max_y(strip_top);
            view(ui, self.look, rect, second, None);
        }
        let hairline = self.look.theme.stroke(1.0, self.look.theme.hairline);
        ui.painter().hline(rect.x_range(), strip_top, hairline);
        let at = pos2(rect.left() + margin_x, caption_top);
        caption.paint(ui.painter(), at);
        if let Some(bars) = bars.filter(|_| column.has_run) {
            let top = bottom - bars.height();
            bars.paint(ui.painter(), rect.with_min_x(at.x).with_min_y(top));
        }
    }

    fn stage(&self, ui: &Ui, rect: Rect, index: usize, column: &Column) {
        let Column { frame, at_end, .. } = column;
        let viewport = Viewport::fit(rect, self.scene.document().bounds());
        let painter = ui.painter().with_clip_rect(rect);
        let mut marks = self.scene.document().backdrop(index, *at_end);
        marks.extend(frame.marks().iter().cloned());
        stage(
            &painter,
            &viewport,
            self.look.theme,
            self.look.catalog,
            &marks,
            None,
        );
    }

    fn title(&self, ui: &Ui, rect: Rect, index: usize, method: &MethodCard) {
        let note = self
            .difference
            .filter(|difference| difference.column == index)
            .map(|difference| self.look.catalog.message(&difference.message()));
        let [margin_x, margin_y] = MARGIN_PTS;
        column_title(
            ui.painter(),
            self.look,
            (rect.min + vec2(margin_x, margin_y), Align2::LEFT_TOP),
            rect.width() - 2.0 * margin_x,
            &self.look.catalog.term(method.name_key),
            note.as_deref(),
        );
    }
}
