//! The first answer of a program that is not right, as a figure: what it says over what is true, and both as they were written.

use egui::{Align2, Color32, FontId, Rect, Stroke, Ui, Vec2, pos2, vec2};
use serde_json::Value as Json;

use crate::{
    case::Solvers,
    figure::{Body, Caption, View},
    grade::{Kind, Report, Scenery, Wrong, score, sentence, title},
    paint::{
        Around, Headless, Image, Look, Span, Theme, ThemeKind, Typeset, Viewport, fonts::semibold,
    },
    text::{Catalog, Lang, Message},
    widgets::{caption, height_for_all, space, view},
};

/// In points; twice as many pixels.
const PAGE: Vec2 = vec2(960.0, 540.0);
const MARGIN: f32 = 48.0;
const PIXELS_PER_POINT: f32 = 4.0 / 3.0;
/// Under the title.
const TOP: f32 = 72.0;
/// Over the sentence.
const BOTTOM: f32 = 448.0;
const LEFT_WIDTH: f32 = 432.0;
const RIGHT: f32 = 516.0;
/// More cases have no room in one row.
const MOST_CASES: usize = 33;
/// A longer text is cut.
const MOST_CHARS: usize = 260;

/// Between two views.
const GAP: f32 = 20.0;
/// From the row of cases to the sentence.
const CASES: f32 = 64.0;

/// What a box is called, what stands in it, of what is true or else of what was said, and the colours of both.
type Said<'a> = (&'static str, (&'a Json, usize), [Color32; 2]);

/// A figure, and the same in words.
pub struct Drawn {
    pub image: Image,
    pub alternative: String,
}

/// None where everything is right.
pub fn draw_graded(report: &Report, solvers: Solvers, lang: Lang) -> Option<Drawn> {
    let wrong = report.wrong.first()?;
    let kind = ThemeKind::Light;
    let look = Look::new(Theme::of(kind), Catalog::of(lang));
    let page = Page {
        look,
        report,
        wrong,
        scenery: wrong.scenery(solvers),
        numbers: wrong.numbers(solvers),
        title: heading(wrong, look.catalog),
        sentence: sentence(wrong, look.catalog),
    };
    let image = Headless::new(kind).draw(PAGE, PIXELS_PER_POINT, |ui| page.show(ui));
    Some(Drawn {
        image,
        alternative: format!("{}. {}", page.title, page.sentence),
    })
}

fn heading(wrong: &Wrong, catalog: &Catalog) -> String {
    let event = [&wrong.said, &wrong.truth]
        .into_iter()
        .find_map(|event| Some(event.get("event")?.as_str()?.to_owned()));
    let message = match (wrong.kind, event) {
        (Kind::Event, Some(event)) => Message::new("grade-title-event").with("event", event),
        (Kind::Event | Kind::Output, _) => Message::new("grade-title-output"),
        (Kind::Missing | Kind::BadJson | Kind::Refused, _) => Message::new("grade-title-none"),
        (Kind::Extra, _) => Message::new("grade-title-extra"),
    };
    catalog.message(&message)
}

struct Page<'a> {
    look: Look<'static>,
    report: &'a Report,
    wrong: &'a Wrong,
    scenery: Option<Scenery>,
    numbers: Option<Caption>,
    title: String,
    sentence: String,
}

impl Page<'_> {
    fn show(&self, ui: &mut Ui) {
        let theme = self.look.theme;
        let at = pos2(MARGIN, 26.0);
        set(ui, &self.title, FontId::new(19.5, semibold()), theme.ink).paint(
            ui.painter(),
            at,
            Align2::LEFT_TOP,
        );
        let corner = pos2(PAGE.x - MARGIN, 34.0);
        set(ui, &self.which(), FontId::proportional(11.5), theme.soft).paint(
            ui.painter(),
            corner,
            Align2::RIGHT_TOP,
        );
        let stage = Rect::from_min_max(pos2(MARGIN, TOP), pos2(MARGIN + LEFT_WIDTH, BOTTOM - 20.0));
        match &self.scenery {
            Some(Scenery::Plane { marks, bounds }) => {
                let viewport = Viewport::fit(stage, *bounds);
                let painter = ui.painter().with_clip_rect(stage);
                let around = Around::default();
                (self.look).stage(&painter, &viewport, marks, None, around);
            }
            Some(Scenery::Views(views)) => self.views(ui, stage, views),
            None => {
                let plain = self.look.say("grade-figure-plain");
                let plain = set(ui, &plain, FontId::proportional(13.0), theme.soft);
                plain.paint(ui.painter(), stage.left_top(), Align2::LEFT_TOP);
            }
        }
        let said = (
            "grade-figure-said",
            (&self.wrong.said, 1),
            [theme.signal_text, theme.signal],
        );
        let truth = (
            "grade-figure-true",
            (self.wrong.expected(), 0),
            [theme.accent, theme.accent],
        );
        let y = self.boxed(ui, TOP, said);
        let y = self.boxed(ui, y + 16.0, truth);
        self.numbers(ui, y + 16.0);
        self.cases(ui);
        self.caption(ui);
    }

    fn which(&self) -> String {
        let catalog = self.look.catalog;
        let mut parts = vec![title(self.wrong.case, &self.wrong.id, catalog)];
        parts.extend(self.wrong.algorithm_key().map(|key| catalog.term(key)));
        parts.join("  ·  ")
    }

    /// Beside each other, or one over the other where each is wide.
    fn views(&self, ui: &Ui, stage: Rect, views: &[View]) {
        let is_wide = |view: &View| match &view.body {
            Body::Raster(raster) => 4 * raster.size[0] > 5 * raster.size[1],
            _ => false,
        };
        let (n, is_stacked) = (views.len() as f32, views.iter().all(is_wide));
        let along = if is_stacked { Vec2::Y } else { Vec2::X };
        let gaps = along * (n - 1.0) * GAP;
        let part = (stage.size() - gaps) / (along * (n - 1.0) + Vec2::splat(1.0));
        for (nth, shown) in views.iter().enumerate() {
            let at = stage.min + along * nth as f32 * (part + Vec2::splat(GAP));
            let rect = Rect::from_min_size(at, part);
            match &shown.body {
                Body::Space(body) => space(ui, self.look, rect, (shown.id, body), &[], None),
                _ => view(ui, self.look, rect, shown, None),
            };
        }
    }

    /// What the true run says there, where it has room over the cases.
    fn numbers(&self, ui: &mut Ui, y: f32) {
        let Some(numbers) = &self.numbers else {
            return;
        };
        let width = PAGE.x - MARGIN - RIGHT;
        let height = height_for_all(ui.painter(), self.look, [numbers.clone()], width);
        let rect = Rect::from_min_size(pos2(RIGHT, y), vec2(width, height));
        if rect.bottom() < BOTTOM - CASES {
            caption(ui, self.look, rect, numbers);
        }
    }

    /// What was written, under its name; where it ends.
    fn boxed(&self, ui: &Ui, y: f32, (key, (json, nth), [text, bar]): Said<'_>) -> f32 {
        let (theme, painter) = (self.look.theme, ui.painter());
        let name = self.look.say(key);
        let font = FontId::new(12.0, semibold());
        set(ui, &name, font, text).paint(painter, pos2(RIGHT, y), Align2::LEFT_TOP);
        let shown = match json {
            Json::Null => self.look.say("grade-figure-nothing"),
            json => self.cut(json, nth),
        };
        let width = PAGE.x - MARGIN - RIGHT;
        let galley = painter.layout(shown, FontId::monospace(11.5), theme.ink, width - 24.0);
        let frame = Rect::from_min_size(pos2(RIGHT, y + 20.0), vec2(width, galley.size().y + 16.0));
        painter.rect_filled(frame, 3.0, theme.panel);
        painter.vline(frame.left() + 1.0, frame.y_range(), Stroke::new(2.0, bar));
        painter.galley(frame.min + vec2(14.0, 8.0), galley, theme.ink);
        frame.bottom()
    }

    /// A dot for each case that is right, a cross for each that is not, the drawn one ringed.
    fn cases(&self, ui: &Ui) {
        let names = &self.report.names;
        if names.len() > MOST_CASES {
            return;
        }
        let (theme, painter) = (self.look.theme, ui.painter());
        let y = BOTTOM - 36.0;
        let label = self.look.say("grade-figure-cases");
        let label = set(ui, &label, FontId::proportional(11.0), theme.soft);
        label.paint(painter, pos2(RIGHT, y - 24.0), Align2::LEFT_TOP);
        for number in 1..=names.len() {
            let at = pos2(RIGHT + 8.0 + 12.0 * (number - 1) as f32, y + 4.0);
            let mut wrong = self.report.wrong.iter().filter_map(|wrong| wrong.case);
            if !wrong.any(|case| case == number) {
                painter.circle_filled(at, 3.5, theme.accent);
                continue;
            }
            let is_drawn = self.wrong.case == Some(number);
            let colour = if is_drawn { theme.signal } else { theme.ink };
            for turn in [1.0, -1.0] {
                let arm = vec2(3.5, 3.5 * turn);
                painter.line_segment([at - arm, at + arm], Stroke::new(1.5, colour));
            }
            if is_drawn {
                painter.circle_stroke(at, 7.5, Stroke::new(1.2, colour));
            }
        }
    }

    /// As it is written; of what is too long only where it differs.
    fn cut(&self, json: &Json, nth: usize) -> String {
        let text = json.to_string();
        if text.chars().count() <= MOST_CHARS {
            return text;
        }
        if let Some((path, parts)) = self.wrong.parts() {
            let part = format!("… {path}: {} …", parts[nth]);
            if part.chars().count() <= MOST_CHARS {
                return part;
            }
        }
        text.chars().take(MOST_CHARS).collect::<String>() + "…"
    }

    fn caption(&self, ui: &Ui) {
        let (theme, painter) = (self.look.theme, ui.painter());
        let width = PAGE.x - 2.0 * MARGIN;
        painter.hline(
            MARGIN..=PAGE.x - MARGIN,
            BOTTOM,
            Stroke::new(1.0, theme.hairline),
        );
        let spans = [Span::text(
            &self.sentence,
            FontId::proportional(13.0),
            theme.ink,
        )];
        let said = Typeset::wrapped(painter, &spans, width);
        let rect = said.paint(painter, pos2(MARGIN, BOTTOM + 14.0), Align2::LEFT_TOP);
        let score = score(self.report, self.look.catalog);
        let score = set(ui, &score, FontId::proportional(11.0), theme.soft);
        score.paint(painter, pos2(MARGIN, rect.bottom() + 8.0), Align2::LEFT_TOP);
    }
}

fn set(ui: &Ui, text: &str, font: FontId, colour: Color32) -> Typeset {
    Typeset::text(ui.painter(), text, font, colour)
}
