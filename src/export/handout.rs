//! A lesson on paper: its text, its figures, its questions with room for answers, a run to work out, and its card.

mod leaves;
mod pages;

use egui::{Vec2, vec2};

use crate::{
    lesson::{Asks, Block, Lesson, LessonStep, Link},
    paint::ThemeKind,
    text::{Catalog, Lang, Message},
};

use super::{
    figure::{Options, Steps, Studio},
    jobs::{Source, jobs_of},
    vector::{About, Tag, pdf},
};

use leaves::{Leaf, Press};
use pages::paged;

/// What it is printed on. The words are those of the command line's help.
#[derive(clap::ValueEnum, Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Paper {
    /// 210 × 297 mm
    #[default]
    A4,
    /// 8½ × 11 inches
    Letter,
}

impl Paper {
    /// In points.
    fn size(self) -> Vec2 {
        match self {
            Self::A4 => vec2(595.28, 841.89),
            Self::Letter => vec2(612.0, 792.0),
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Handout<'a> {
    pub paper: Paper,
    pub lang: Lang,
    /// Are questions answered, and the run worked out?
    pub is_answered: bool,
    /// The address of a page that links are opened on.
    pub page: Option<&'a str>,
}

/// Text beside figures is as large as theirs is when they are as wide as a column: figures of the projector's theme.
const THEME: ThemeKind = ThemeKind::Projector;
/// A run with more steps takes pages, and is not given to be worked out.
const MOST_ROWS: usize = 24;

impl Handout<'_> {
    /// The file's bytes.
    pub fn pdf(self, studio: &mut Studio, lesson: &Lesson) -> Vec<u8> {
        let title = lesson.title(self.lang);
        let mut press = Press::new(studio, THEME, self.lang, self.paper.size());
        let mut leaves = vec![press.title(title)];
        let mut worked = to_work_out(lesson);
        for step_idx in 0..lesson.steps.len() {
            leaves.extend(self.step(&mut press, lesson, step_idx));
            if worked.take_if(|nth| *nth == step_idx).is_some() {
                leaves.extend(press.run(&lesson.steps[step_idx], self.is_answered));
            }
        }
        if let Some(card) = lesson.card(self.lang) {
            let heading = press.heading(&press.say("handout-kept"));
            leaves.extend([heading, press.card(card)]);
        }
        let about = About {
            title,
            lang: self.lang.id(),
            ..About::default()
        };
        let feet = paged(&mut press, leaves, title);
        let pages: Vec<_> = feet.iter().map(|sheet| sheet.page()).collect();
        pdf(&pages, about)
    }

    fn step(self, press: &mut Press<'_>, lesson: &Lesson, step_idx: usize) -> Vec<Leaf> {
        let step = &lesson.steps[step_idx];
        let Some(text) = lesson.step_text(step_idx, self.lang) else {
            return Vec::new();
        };
        let mut leaves = vec![press.heading(&text.title)];
        let question = text.question().unwrap_or_default();
        let is_question = |block: &Block| question.iter().any(|it| std::ptr::eq(it, block));
        let first = text.body.iter().position(is_question);
        let (told, asked) = text.body.split_at(first.unwrap_or(text.body.len()));
        leaves.extend(told.iter().filter_map(|block| self.text(press, block)));
        leaves.extend(self.figure(press, lesson, step));
        for block in asked {
            let leaf = self.text(press, block);
            // A question stays with the room for its answer.
            leaves.extend(leaf.map(|leaf| Leaf {
                keeps: is_question(block) && !matches!(block, Block::Answer(_)),
                ..leaf
            }));
        }
        leaves
    }

    fn text(self, press: &mut Press<'_>, block: &Block) -> Option<Leaf> {
        match block {
            Block::Wait => None,
            Block::Answer(_) if !self.is_answered => Some(press.room()),
            Block::Paragraph(_)
            | Block::ListItem { .. }
            | Block::Goal { .. }
            | Block::Code(_)
            | Block::Answer(_)
            | Block::Note(_) => Some(press.text(block)),
        }
    }

    fn figure(self, press: &mut Press<'_>, lesson: &Lesson, step: &LessonStep) -> Vec<Leaf> {
        let jobs = jobs_of(Source::Step(lesson, step), &step.id, Steps::Figures);
        let Some(job) = jobs.first().filter(|_| step.figure.is_some()) else {
            return Vec::new();
        };
        let options = Options {
            size_px: [1920, 1080],
            theme: THEME,
            lang: self.lang,
            steps: Steps::Figures,
            asks: step.asks.is_some() && !self.is_answered,
        };
        let mut picture = job.picture(options);
        // What is asked is the step's title, which stands over its text.
        picture.title = picture.title.filter(|_| !options.asks);
        let mut leaves = vec![press.figure(&picture)];
        leaves.push(self.link(press, lesson, step));
        leaves
    }

    /// Under a figure: what opens its step.
    fn link(self, press: &mut Press<'_>, lesson: &Lesson, step: &LessonStep) -> Leaf {
        let place = Link::to_step(&lesson.id, &step.id).to_string();
        let (words, target) = match self.page {
            Some(page) => {
                let address = format!("{page}{place}");
                (address.clone(), Some(address))
            }
            None => (format!("clipscope open '{place}'"), None),
        };
        let message = Message::new("handout-open").with("link", words);
        let words = Catalog::of(self.lang).message(&message);
        press.small(&words, Tag::Paragraph, target)
    }
}

/// The step of which a run of few steps is worked out: the first that asks for all of it, else the first that asks.
fn to_work_out(lesson: &Lesson) -> Option<usize> {
    let is_short = |step: &LessonStep| {
        let run = step.scene.document().record().into_iter().next();
        run.is_some_and(|run| run.n_steps() <= MOST_ROWS)
    };
    let first = |is_meant: &dyn Fn(&LessonStep) -> bool| {
        (lesson.steps.iter()).position(|step| is_meant(step) && is_short(step))
    };
    first(&|step| matches!(step.asks, Some(Asks::Run)))
        .or_else(|| first(&|step| step.asks.is_some()))
}
