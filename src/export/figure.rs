//! One figure: the step's title, what the stage shows, and the run's sentence under it.

#[cfg(test)]
mod tests;

use egui::{Rect, Ui, Vec2, vec2};

use crate::{
    figure::{Body, ColumnLayout, Eyes, Layout, Need, Spacing, ViewId, notation},
    labs::Scene,
    lesson::Lesson,
    paint::{Around, Headless, Image, Look, Theme, ThemeKind, Viewport},
    text::{Catalog, Lang, Message},
    widgets::{
        Album, Bars, Column, Composition, Cost, Medium, Recorded, covered, height_for_all,
        most_of_a_kind, place_inset, rect_of, space, view,
    },
};

/// A figure is laid out on a page of this size in points, or larger along one side as its shape asks, and
/// then enlarged to its size in pixels: text keeps its proportion to the picture. At 1280 × 720 pixels the title is 26
/// high, the text 17, the caption 19, the margin 64.
const PAGE_PTS: [f32; 2] = [960.0, 540.0];
/// Where a view of one method has no room, the page is enlarged by so much, and again, until all have: what is on it
/// becomes smaller, but where text is large on purpose.
const ENLARGED_BY: f32 = 0.1;
const MOST_ENLARGED: f32 = 1.4;
const MARGIN_PTS: f32 = 24.0;
/// A sentence has room for two lines, in all themes: the body of the page is equally high.
const CAPTION_PTS: f32 = 62.0;
const SPACING: Spacing = Spacing {
    margin: 48.0,
    gutter: 40.0,
    inset: 0.0,
    titled: 46.0,
    name: 36.0,
    over_caption: 8.0,
    is_fixed: false,
};
const OVER_COST_PTS: f32 = 8.0;

/// Which steps of the runs become pictures. The words are those of the command line's help.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, clap::ValueEnum)]
pub enum Steps {
    /// Those that lessons name
    #[default]
    Figures,
    /// Every one
    All,
}

/// How pictures are drawn.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    pub size_px: [u32; 2],
    pub theme: ThemeKind,
    pub lang: Lang,
    /// Which steps are drawn, so that a picture leaves room for what the others say.
    pub steps: Steps,
    /// What is asked is drawn, and what might come, in place of what comes.
    pub asks: bool,
}

#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// The idea in words, over everything.
    pub title: Option<&'a str>,
    pub scene: &'a Scene,
    /// The lesson that the scene is of: its figures are drawn alike.
    pub lesson: Option<&'a Lesson>,
    /// Events folded so far.
    pub step: usize,
    pub options: Options,
}

impl Picture<'_> {
    /// The language in which it is asked what comes, if it is.
    fn asked_in(&self) -> Option<Lang> {
        self.options.asks.then_some(self.options.lang)
    }
}

/// Draws figures. One that has drawn others draws faster, and records the runs of a lesson once, however many of its steps
/// it draws; the bytes are the same.
pub struct Studio {
    table: Headless,
    last: Option<Album>,
}

impl Studio {
    pub fn new(theme: ThemeKind) -> Self {
        Self {
            table: Headless::new(theme),
            last: None,
        }
    }

    /// What else is drawn without a window is drawn on this.
    pub const fn table(&mut self) -> &mut Headless {
        &mut self.table
    }

    pub fn draw(&mut self, picture: &Picture<'_>) -> Image {
        self.drawn(picture).0
    }

    /// In words what the figure shows: its title, and under each method's name its sentence.
    pub fn alternative(&mut self, picture: &Picture<'_>) -> String {
        let catalog = Catalog::of(picture.options.lang);
        let recorded = album(&mut self.last, picture).recorded(picture.scene);
        let columns = recorded.columns(picture.step, picture.asked_in());
        let sentence = |column: &Column| {
            let said = column.frame.caption.text(catalog);
            if columns.len() > 1 {
                let name = catalog.message(&Message::new(column.method.name_key));
                catalog.message(
                    &Message::new("named-sentence")
                        .with("name", name)
                        .with("said", said),
                )
            } else {
                said
            }
        };
        let title = picture.title.map(str::to_owned);
        let lines: Vec<String> = title
            .into_iter()
            .chain(columns.iter().map(sentence))
            .collect();
        lines.join("\n") + "\n"
    }

    /// The figure, and the views that have no room even on the largest page.
    fn drawn(&mut self, picture: &Picture<'_>) -> (Image, Vec<ViewId>) {
        let Self { table, last } = self;
        drawn(table, album(last, picture), picture)
    }
}

/// What is kept of this lesson; another one's goes.
fn album<'a>(last: &'a mut Option<Album>, picture: &Picture<'_>) -> &'a Album {
    last.take_if(|known| !known.holds(picture.scene, picture.lesson));
    last.get_or_insert_with(|| Album::new(picture.scene, picture.lesson, Medium::Page))
}

fn drawn(table: &mut Headless, album: &Album, picture: &Picture<'_>) -> (Image, Vec<ViewId>) {
    table.set_theme(picture.options.theme);
    let size = Vec2::from(picture.options.size_px.map(|side| side as f32));
    let pixels_per_point = (size.x / PAGE_PTS[0]).min(size.y / PAGE_PTS[1]);
    let (page, columns, eyes) = Page::of(album, picture);
    let mut page_scale = 1.0;
    loop {
        let pixels_per_point = pixels_per_point / page_scale;
        let mut layout = Layout::default();
        let image = table.draw(size / pixels_per_point, pixels_per_point, |ui| {
            layout = page.show(ui, &columns, &eyes);
        });
        let may_grow = columns.len() == 1 && !page.look.theme.has_large_text();
        let lost = lost(&page.needs, &layout);
        if lost.is_empty() || page_scale >= MOST_ENLARGED || !may_grow {
            return (image, lost);
        }
        page_scale += ENLARGED_BY;
    }
}

/// The views there is no room for.
fn lost(needs: &[Vec<Need>], layout: &Layout) -> Vec<ViewId> {
    let lost = |(needs, places): (&Vec<Need>, &ColumnLayout)| {
        let ids = needs.iter().map(|need| need.id);
        ids.filter(|&id| places.slot(id).is_none())
            .collect::<Vec<_>>()
    };
    needs.iter().zip(&layout.columns).flat_map(lost).collect()
}

struct Page<'a> {
    picture: &'a Picture<'a>,
    look: Look<'static>,
    album: &'a Album,
    recorded: &'a Recorded,
    needs: Vec<Vec<Need>>,
}

impl<'a> Page<'a> {
    /// With what is drawn on it, as the eyes that are found for it see it.
    fn of(album: &'a Album, picture: &'a Picture<'a>) -> (Self, Vec<Column>, Eyes) {
        let recorded = album.recorded(picture.scene);
        let mut columns = recorded.columns(picture.step, picture.asked_in());
        let eyes = recorded.turned(
            &mut columns,
            picture.options.steps == Steps::All,
            album.eyes(),
        );
        let columns = recorded.drawn(columns);
        let needs = recorded.needs_at(&columns);
        let notation = notation(
            recorded.notation,
            columns.iter().map(|column| &column.frame),
        );
        let page = Page {
            picture,
            look: Look {
                theme: Theme::of(picture.options.theme),
                catalog: Catalog::of(picture.options.lang).alike(notation),
            },
            album,
            recorded,
            needs,
        };
        (page, columns, eyes)
    }

    /// Draws it, and says where everything stands.
    fn show(&self, ui: &mut Ui, columns: &[Column], eyes: &Eyes) -> Layout {
        let area = ui.max_rect().shrink2(vec2(0.0, MARGIN_PTS));
        let methods: Vec<_> = columns.iter().map(|column| column.method).collect();
        let composition = Composition {
            look: self.look,
            spacing: &SPACING,
            methods: &methods,
            difference: self.recorded.difference,
        };
        let width = composition.column_width(area);
        let costs = self.costs(columns);
        let bars: Vec<_> = costs
            .iter()
            .map(|cost| Bars::new(ui.painter(), self.look, cost, width))
            .collect();
        let cost = bars
            .first()
            .map_or(0.0, |bars| bars.height() + OVER_COST_PTS);
        let caption = self.caption_height(ui, columns, width);
        let heights = [caption.max(CAPTION_PTS), cost];
        let (title, needs) = (self.picture.title, &self.needs);
        let mut layout = composition.lay_out(ui, area, title, heights, needs, 1.0);
        for (column, places) in columns.iter().zip(&mut layout.columns) {
            place_inset(ui, self.look, places, &column.frame.views, eyes);
        }
        for (i, (column, places)) in columns.iter().zip(&layout.columns).enumerate() {
            self.drawing(ui, i, column, places);
            let moment = column.moment(self.look.catalog);
            let words = (&column.frame.caption, moment.as_deref());
            composition.beside_the_drawing(ui, (i, places), &column.frame.views, words, None);
            if let Some(bars) = bars.get(i).filter(|_| column.has_run) {
                let mut rect = rect_of(places.cost);
                rect.min.y += OVER_COST_PTS;
                bars.paint(ui.painter(), rect);
            }
        }
        layout
    }

    /// Of the highest sentence of the lesson's runs, so that pictures that follow each other stay where they are. Two methods
    /// leave no room for sentences that are not shown.
    fn caption_height(&self, ui: &Ui, columns: &[Column], width: f32) -> f32 {
        let shown = columns.iter().map(|column| column.frame.caption.clone());
        let shown = height_for_all(ui.painter(), self.look, shown, width);
        if self.picture.options.steps == Steps::Figures && columns.len() > 1 {
            return shown;
        }
        let highest = self.album.caption_height(ui.painter(), self.look, width);
        highest.max(shown)
    }

    /// What each method has done, where two are compared and do not do the same; what a mistake costs is not what is to be seen.
    fn costs(&self, columns: &[Column]) -> Vec<Cost<'static>> {
        if columns.len() < 2 || self.recorded.difference.is_some() {
            return Vec::new();
        }
        let counts: Vec<_> = columns.iter().map(|column| column.frame.counts).collect();
        if counts.iter().all(|count| *count == counts[0]) {
            return Vec::new();
        }
        let most = most_of_a_kind(&counts);
        let cost = |&now: &_| Cost {
            now,
            compared: None,
            most,
        };
        counts.iter().map(cost).collect()
    }

    fn drawing(&self, ui: &Ui, index: usize, column: &Column, places: &ColumnLayout) {
        let Some(first) = column.frame.views.first() else {
            return;
        };
        let Some(slot) = places.slot(first.id) else {
            return;
        };
        let rect = rect_of(slot);
        if let Body::Space(shown) = &first.body {
            let covered = covered(places, first.id, self.look);
            space(ui, self.look, rect, (first.id, shown), &covered, None);
        } else if first.id == ViewId::PLANE {
            self.plane(ui, rect, index, column);
        } else {
            view(ui, self.look, rect, first, None);
        }
    }

    fn plane(&self, ui: &Ui, rect: Rect, index: usize, column: &Column) {
        let scene = self.picture.scene.document();
        let viewport = Viewport::fit(rect, self.recorded.bounds);
        let painter = ui.painter().with_clip_rect(rect);
        let mut marks = scene.backdrop(index, column.at_end());
        marks.extend(column.frame.marks().iter().cloned());
        let around = Around::default();
        (self.look).stage(&painter, &viewport, &marks, None, around);
    }
}
