//! What a handout is made of, one under the other: each is laid out as wide as a column is.

use egui::{Color32, FontFamily, FontId, Pos2, Rect, Sense, Stroke, Ui, Vec2, pos2, vec2};

use crate::{
    case::worksheet,
    export::{
        figure::{PAGE_MARGINS, Picture, Studio},
        vector::{Tag, VectorPage, read},
    },
    lesson::{Block, BlockMarker, Card, Inline, LessonStep},
    paint::{Look, Span, Theme, ThemeKind, Typeset, fonts::semibold},
    text::{Catalog, Lang},
    widgets::{TextTold, card, lesson_text},
};

/// A part that no page's end cuts.
pub struct Leaf {
    pub drawing: VectorPage,
    pub tag: Tag,
    /// Of its own points to the paper's.
    pub scale: f32,
    /// Margins of its own, on each side: they are not printed.
    pub trim: Vec2,
    /// Over it, where it is not the first on a page, in the paper's points.
    pub above: f32,
    /// Does the next one stand on the same page?
    pub keeps: bool,
    pub link: Option<String>,
}

impl Leaf {
    pub fn height(&self) -> f32 {
        self.scale * (self.drawing.size.y - 2.0 * self.trim.y)
    }

    /// Where its drawing begins if what is printed of it does here.
    pub fn place(&self, at: Pos2) -> Pos2 {
        at - self.scale * self.trim
    }
}

/// Lays leaves out.
pub struct Press<'a> {
    pub studio: &'a mut Studio,
    look: Look<'static>,
    pub paper: Vec2,
}

/// Of the paper, on each side.
pub const MARGIN: f32 = 54.0;
/// The theme's text is 18.2 points high, and is printed 10.5.
const TEXT: f32 = 10.5 / 18.2;
const TITLE_PTS: f32 = 34.0;
const HEADING_PTS: f32 = 23.0;
const SMALL_PTS: f32 = 14.5;
/// Nothing is higher.
const MOST_HEIGHT: f32 = 4_000.0;
/// Shapes are put on pixels of this size, of which there are so many in a point.
const PIXELS_PER_POINT: f32 = 4.0;
/// Lines to write an answer on, and how far they are apart.
const N_LINES: usize = 3;
const LINE_PTS: f32 = 34.0;

impl<'a> Press<'a> {
    pub fn new(studio: &'a mut Studio, theme: ThemeKind, lang: Lang, paper: Vec2) -> Self {
        let look = Look::new(Theme::of(theme), Catalog::of(lang));
        studio.table().set_theme(theme);
        Self {
            studio,
            look,
            paper,
        }
    }

    pub fn say(&self, key: &str) -> String {
        self.look.say(key)
    }

    pub fn column(&self) -> f32 {
        self.paper.x - 2.0 * MARGIN
    }

    fn leaf(&mut self, tag: Tag, above: f32, mut add: impl FnMut(&mut Ui)) -> Leaf {
        let width = self.column() / TEXT;
        let mut height = 0.0;
        let size = vec2(width, MOST_HEIGHT);
        let shown = |ui: &mut Ui| {
            add(ui);
            height = ui.min_rect().height();
        };
        let table = self.studio.table();
        let mut drawing = table.write(size, PIXELS_PER_POINT, shown, read);
        drawing.size = vec2(width, height.clamp(1.0, MOST_HEIGHT));
        Leaf {
            drawing,
            tag,
            scale: TEXT,
            trim: Vec2::ZERO,
            above,
            keeps: false,
            link: None,
        }
    }

    pub fn title(&mut self, title: &str) -> Leaf {
        self.headline(title, Tag::Title, (TITLE_PTS, 0.0))
    }

    pub fn heading(&mut self, title: &str) -> Leaf {
        self.headline(title, Tag::Heading, (HEADING_PTS, 18.0))
    }

    fn headline(&mut self, words: &str, tag: Tag, (points, above): (f32, f32)) -> Leaf {
        let ink = self.look.theme.ink;
        let leaf = self.leaf(tag, above, |ui| {
            set(ui, words, FontId::new(points, semibold()), ink);
        });
        Leaf {
            keeps: true,
            ..leaf
        }
    }

    pub fn small(&mut self, words: &str, tag: Tag, link: Option<String>) -> Leaf {
        let soft = self.look.theme.soft;
        let leaf = self.leaf(tag, 2.0, |ui| {
            set(
                ui,
                words,
                FontId::new(SMALL_PTS, FontFamily::Proportional),
                soft,
            );
        });
        Leaf { link, ..leaf }
    }

    /// Running text, as beside the stage. Terms are not explained on paper, and nothing there can be pressed.
    pub fn text(&mut self, block: &Block) -> Leaf {
        let look = self.look;
        let block = [printed(block)];
        let tag = if matches!(block[0], Block::Code(_)) {
            Tag::Code
        } else {
            Tag::Paragraph
        };
        let above = match block[0] {
            Block::ListItem {
                marker: BlockMarker::Bullet | BlockMarker::Number(_),
                ..
            } => 2.5,
            _ => 5.0,
        };
        self.leaf(tag, above, |ui| {
            let id = ui.scope_id();
            lesson_text(ui, look, id, &block, TextTold::answered());
        })
    }

    /// Room for an answer.
    pub fn room(&mut self) -> Leaf {
        let faint = self.look.theme.faint;
        self.leaf(Tag::Furniture, 4.0, |ui| {
            let size = vec2(ui.available_width(), N_LINES as f32 * LINE_PTS);
            let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
            for nth in 1..=N_LINES {
                let y = rect.top() + nth as f32 * LINE_PTS - 1.0;
                let line = Stroke::new(1.0, faint);
                ui.painter().hline(rect.x_range(), y, line);
            }
        })
    }

    pub fn figure(&mut self, picture: &Picture<'_>) -> Leaf {
        let (drawing, words) = self.studio.vector(picture);
        let trim = Vec2::from(PAGE_MARGINS);
        Leaf {
            scale: self.column() / (drawing.size.x - 2.0 * trim.x),
            trim,
            drawing,
            tag: Tag::Figure(words.trim_end().to_owned()),
            above: 8.0,
            keeps: true,
            link: None,
        }
    }

    pub fn card(&mut self, kept: &Card) -> Leaf {
        let look = self.look;
        self.leaf(Tag::Paragraph, 2.0, |ui| card(ui, look, kept))
    }

    /// The run of a step as a table, with room for what is worked out.
    pub fn run(&mut self, step: &LessonStep, is_answered: bool) -> Vec<Leaf> {
        let runs = step.scene.document().record();
        let Some(run) = runs.first() else {
            return Vec::new();
        };
        let sheet = worksheet(&**run, is_answered, self.look.catalog);
        let heading = self.say("handout-work-out");
        let mut leaves = vec![self.heading(&heading)];
        let head = sheet.head.map(|word| vec![word]);
        leaves.push(self.row(&head, true));
        leaves.extend(sheet.rows.iter().map(|row| self.row(row, false)));
        let n = leaves.len();
        // The last two rows stay together, as the first two do.
        for nth in [2, n - 2] {
            if let Some(leaf) = leaves.get_mut(nth) {
                leaf.keeps = true;
            }
        }
        leaves
    }

    /// Of a table: each cell as wide as such cells need.
    fn row(&mut self, cells: &[Vec<String>; 4], is_head: bool) -> Leaf {
        const WIDTHS: [f32; 4] = [0.07, 0.4, 0.31, 0.22];
        const BESIDE: f32 = 10.0;
        let theme = self.look.theme;
        let leaf = self.leaf(Tag::Paragraph, 0.0, |ui| {
            let area = ui.max_rect();
            let (mut left, mut bottom) = (area.left(), area.top());
            let family = if is_head {
                semibold()
            } else {
                FontFamily::Proportional
            };
            let font = FontId::new(SMALL_PTS, family);
            for (cell, share) in cells.iter().zip(WIDTHS) {
                let width = share * area.width();
                let mut top = area.top() + 6.0;
                for words in cell {
                    let spans = [Span::text(words, font.clone(), theme.ink)];
                    let line = (1.35 * SMALL_PTS).round();
                    let text = Typeset::running(ui.painter(), &spans, width - BESIDE, line);
                    let placed = text.paint(ui.painter(), pos2(left, top), egui::Align2::LEFT_TOP);
                    top = placed.bottom() + if is_head { 2.0 } else { 6.0 };
                }
                left += width;
                bottom = bottom.max(top);
            }
            let row = Rect::from_min_max(area.left_top(), pos2(area.right(), bottom + 4.0));
            ui.allocate_rect(row, Sense::hover());
            let line = Stroke::new(if is_head { 1.5 } else { 1.0 }, theme.hairline);
            ui.painter().hline(row.x_range(), row.bottom() - 1.0, line);
        });
        Leaf {
            keeps: is_head,
            ..leaf
        }
    }
}

fn set(ui: &mut Ui, words: &str, font: FontId, colour: Color32) {
    let line = (1.3 * font.size).round();
    let spans = [Span::text(words, font, colour)];
    let text = Typeset::running(ui.painter(), &spans, ui.available_width(), line);
    ui.add(egui::Label::new(text.galley()));
}

fn printed(block: &Block) -> Block {
    let plain = |text: &[Inline]| -> Vec<Inline> {
        let plain = |part: &Inline| Inline {
            control: None,
            term: None,
            ..part.clone()
        };
        text.iter().map(plain).collect()
    };
    match block {
        Block::Paragraph(text) => Block::Paragraph(plain(text)),
        Block::ListItem {
            depth,
            marker,
            text,
        } => Block::ListItem {
            depth: *depth,
            marker: *marker,
            text: plain(text),
        },
        Block::Goal { nth, text } => Block::Goal {
            nth: *nth,
            text: plain(text),
        },
        Block::Answer(blocks) => Block::Answer(blocks.iter().map(printed).collect()),
        Block::Note(text) => Block::Note(plain(text)),
        Block::Code(_) | Block::Wait => block.clone(),
    }
}
