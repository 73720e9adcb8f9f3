//! What stands on a figure's page, and where.

use egui::{FontId, Rect, Ui, vec2};

use crate::{
    figure::{Body, ColumnLayout, Layout, Mark, Need, Spacing, ViewId, notation},
    labs::Difference,
    paint::{Around, Look, Theme, Viewport, notes},
    text::{Catalog, Notation},
    widgets::{
        Album, Bars, Column, Composition, Cost, covered, height_for_all, most_of_a_kind,
        place_inset, rect_of, space, view,
    },
};

use super::{
    halves::{Half, headings},
    picture::{Picture, Steps},
};

const MARGIN_PTS: f32 = 24.0;
/// Around all that stands on a page, at the sides and over and under it.
#[cfg(not(target_arch = "wasm32"))]
pub const PAGE_MARGINS: [f32; 2] = [SPACING.margin, MARGIN_PTS];
const FOOT_PTS: f32 = 9.0;
/// A sentence has room for two lines, in all themes: the body of the page is equally high.
const CAPTION_PTS: f32 = 62.0;
const SPACING: Spacing = Spacing {
    margin: 48.0,
    gutter: 40.0,
    inset: 0.0,
    titled: 46.0,
    name: 36.0,
    over_caption: 8.0,
    keeps: 0.75,
    is_fixed: false,
    is_tall: false,
};
/// Of what was and what is, the views that differ are larger than the drawing needs them.
const BESIDE_BEFORE: Spacing = Spacing {
    keeps: 0.2,
    ..SPACING
};
const OVER_COST_PTS: f32 = 8.0;

/// The views there is no room for.
pub fn lost(needs: &[Vec<Need>], layout: &Layout) -> Vec<ViewId> {
    let lost = |(needs, places): (&Vec<Need>, &ColumnLayout)| {
        let ids = needs.iter().map(|need| need.id);
        ids.filter(|&id| places.slot(id).is_none())
            .collect::<Vec<_>>()
    };
    needs.iter().zip(&layout.columns).flat_map(lost).collect()
}

pub struct Page<'a> {
    pub picture: &'a Picture<'a>,
    pub look: Look<'static>,
    album: &'a Album,
    pub halves: Vec<Half<'a>>,
    pub needs: Vec<Vec<Need>>,
}

/// What is drawn in a column: whose it is, and which of its methods.
pub type Drawn<'a> = (&'a Half<'a>, usize, &'a Column);

impl<'a> Page<'a> {
    /// With these halves on it, as the eyes that are found for them see them.
    pub fn of(album: &'a Album, picture: &'a Picture<'a>, mut halves: Vec<Half<'a>>) -> Self {
        let of_all = picture.options.steps == Steps::All;
        for Half {
            recorded,
            columns,
            eyes,
        } in &mut halves
        {
            *eyes = recorded.turned(columns, of_all, album.eyes());
            *columns = recorded.drawn(std::mem::take(columns));
        }
        let needs = match &halves[..] {
            [was, now] => was.recorded.needs_beside(now.recorded),
            _ => {
                let needs = |half: &Half<'_>| half.recorded.needs_at(&half.columns);
                halves.iter().flat_map(needs).collect()
            }
        };
        let own = halves.iter().map(|half| half.recorded.notation);
        let own = own.fold(Notation::Own, Notation::max);
        let columns = halves.iter().flat_map(|half| &half.columns);
        let notation = notation(own, columns.map(|column| &column.frame));
        let look = Look::new(
            Theme::of(picture.options.theme),
            Catalog::of(picture.options.lang).alike(notation),
        );
        Page {
            picture,
            look,
            album,
            halves,
            needs,
        }
    }

    pub fn columns(&self) -> impl Iterator<Item = Drawn<'_>> {
        self.halves.iter().flat_map(|half| {
            let columns = half.columns.iter().enumerate();
            columns.map(move |(nth, column)| (half, nth, column))
        })
    }

    /// Draws it, and says where everything stands.
    pub fn show(&self, ui: &mut Ui) -> Layout {
        let area = ui.max_rect().shrink2(vec2(0.0, MARGIN_PTS));
        let headings = headings(&self.halves, self.picture);
        let composition = Composition {
            look: self.look,
            spacing: match self.halves[..] {
                [_, _] => &BESIDE_BEFORE,
                _ => &SPACING,
            },
            headings: &headings,
            difference: self.difference(),
        };
        let width = composition.column_width(area);
        let costs = self.costs();
        let bars: Vec<_> = costs
            .iter()
            .map(|cost| Bars::new(ui.painter(), self.look, cost, width))
            .collect();
        let (mut layout, has_bars) = self.lay_out(ui, area, &composition, bars.first());
        for ((half, _, column), places) in self.columns().zip(&mut layout.columns) {
            place_inset(ui, self.look, places, &column.frame.views, &half.eyes);
        }
        for (i, (drawn, places)) in self.columns().zip(&layout.columns).enumerate() {
            let (_, _, column) = drawn;
            let painter = ui.painter().clone();
            notes::group(&painter, "drawing", || self.drawing(ui, drawn, places));
            let moment = column.moment(self.look.catalog);
            let words = (&column.frame.caption, moment.as_deref());
            composition.beside_the_drawing(ui, (i, places), &column.frame.views, words, None);
            if let Some(bars) = bars.get(i).filter(|_| has_bars && column.has_run) {
                let mut rect = rect_of(places.cost);
                rect.min.y += OVER_COST_PTS;
                notes::group(&painter, "costs", || bars.paint(&painter, rect));
            }
        }
        self.print_foot(ui);
        layout
    }

    /// In the margin, at the right.
    fn print_foot(&self, ui: &Ui) {
        let Some(foot) = self.picture.foot else {
            return;
        };
        let font = FontId::monospace(FOOT_PTS * self.look.theme.text_scale);
        let at = ui.max_rect().right_bottom() - vec2(SPACING.margin, 0.25 * MARGIN_PTS);
        let soft = self.look.theme.soft;
        let galley = ui.painter().layout_no_wrap(foot.to_owned(), font, soft);
        let (painter, at) = (ui.painter(), at - galley.size());
        notes::group(painter, "foot", || painter.galley(at, galley, soft));
    }

    /// Where all stands, and whether the bars of the costs do: of what was and what is only where what differs has no room.
    fn lay_out(
        &self,
        ui: &Ui,
        area: Rect,
        composition: &Composition<'_>,
        bars: Option<&Bars<'_>>,
    ) -> (Layout, bool) {
        let width = composition.column_width(area);
        let caption = self.caption_height(ui, width).max(CAPTION_PTS);
        let lay_out = |cost| {
            let heights = [caption, cost];
            composition.lay_out(
                ui,
                area,
                self.picture.title,
                heights,
                &self.needs,
                [1.0, 0.0],
            )
        };
        if let [_, _] = self.halves[..] {
            let layout = lay_out(0.0);
            if lost(&self.needs, &layout).is_empty() {
                return (layout, false);
            }
        }
        let cost = bars.map_or(0.0, |bars| bars.height() + OVER_COST_PTS);
        (lay_out(cost), true)
    }

    /// Of two methods of which one is wrong on purpose.
    fn difference(&self) -> Option<Difference> {
        self.halves.iter().find_map(|half| half.recorded.difference)
    }

    /// Of the highest sentence of the lesson's runs, so that pictures that follow each other stay where they are. Two columns
    /// leave no room for sentences that are not shown.
    fn caption_height(&self, ui: &Ui, width: f32) -> f32 {
        let shown = self.columns().map(|(_, _, it)| it.frame.caption.clone());
        let shown = height_for_all(ui.painter(), self.look, shown, width);
        if self.picture.options.steps == Steps::Figures && self.columns().nth(1).is_some() {
            return shown;
        }
        let highest = self.album.caption_height(ui.painter(), self.look, width);
        highest.max(shown)
    }

    /// What each column has done, where two are compared and do not do the same; what a mistake costs is not what is to be seen.
    fn costs(&self) -> Vec<Cost<'static>> {
        let counts: Vec<_> = self.columns().map(|(_, _, it)| it.frame.counts).collect();
        let is_equal = counts.iter().all(|count| *count == counts[0]);
        if is_equal || self.difference().is_some() {
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

    fn drawing(&self, ui: &Ui, drawn: Drawn<'_>, places: &ColumnLayout) {
        let (_, _, column) = drawn;
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
            let viewport = Viewport::fit(rect, drawn.0.recorded.bounds);
            let painter = ui.painter().with_clip_rect(rect);
            let (marks, around) = (plane_marks(drawn), Around::default());
            (self.look).stage(&painter, &viewport, &marks, None, around);
        } else {
            view(ui, self.look, rect, first, None);
        }
    }
}

/// What a column draws of the plane, with what stands there before its method begins.
pub fn plane_marks((half, nth, column): Drawn<'_>) -> Vec<Mark> {
    let scene = half.recorded.scene.document();
    let mut marks = scene.backdrop(nth, column.at_end());
    marks.extend(column.frame.marks().iter().cloned());
    marks
}
