//! Texts with references in them: how they are kept while a file is read, and how they are filled in.

use std::sync::OnceLock;

use crate::{
    lesson::{
        Card, Goal, LessonStep,
        markdown::{Block, StepText, stray_sides},
        mentions,
        prelude::*,
    },
    text::{Catalog, Lang, Notation, Value},
};

use super::{Form, Reference, Runs, braces::SLOT, parse::parse, resolve::Scenes};

/// A reference of a text, and where it stands in its file.
#[derive(Clone, PartialEq, Debug)]
pub struct Placed {
    pub reference: Reference,
    pub span: Range<usize>,
}

/// A step's text as it was written.
#[derive(Clone, Debug)]
pub struct WrittenStep {
    /// Its notes stand among the blocks of its body, in the order of the references.
    text: StepText,
    /// In the order in which they stand.
    references: Vec<Placed>,
    filled: OnceLock<StepText>,
}

impl PartialEq for WrittenStep {
    fn eq(&self, other: &Self) -> bool {
        (&self.text, &self.references) == (&other.text, &other.references)
    }
}

#[derive(Clone, PartialEq, Debug)]
pub struct WrittenText {
    pub title: String,
    pub card: Option<Card>,
    /// One for each step, in their order.
    pub steps: Vec<WrittenStep>,
}

impl WrittenText {
    /// Does a reference name this scene?
    pub fn speaks_of(&self, scene: &str) -> bool {
        let mut references = self.steps.iter().flat_map(|step| &step.references);
        references.any(|placed| placed.reference.scene.as_deref() == Some(scene))
    }
}

impl WrittenStep {
    /// `spans` are the references of the text; one that cannot be read is reported.
    pub fn new(text: StepText, spans: &[Range<usize>], sink: &Sink<'_>) -> Self {
        let placed = spans.iter().filter_map(|span| {
            let inner = &sink.source.text[span.start + 1..span.end - 1];
            match parse(inner) {
                Ok(reference) => Some(Placed {
                    reference,
                    span: span.clone(),
                }),
                Err(what) => {
                    sink.error(span.clone(), what, []);
                    None
                }
            }
        });
        Self {
            text,
            references: placed.collect(),
            filled: OnceLock::new(),
        }
    }

    /// Reports what does not come to anything in the text of `step`.
    pub fn check(&self, step: &LessonStep, runs: &Runs<'_>, sink: &Sink<'_>) {
        for Placed { reference, span } in &self.references {
            if let Err(what) = runs.resolve(reference, step) {
                sink.error(span.clone(), what, []);
            }
        }
        if self.text.sides.is_some() && step.before.is_none() {
            stray_sides(0..0, sink);
        }
        let is_goal = |block: &&Block| matches!(block, Block::Goal { .. });
        let count = self.text.body.iter().filter(is_goal).count();
        let parts = step.goal.as_ref().map_or(0, Goal::n_parts);
        if count != parts {
            let message = Message::new("problem-goal-text").with("name", step.id.clone());
            let message = message.with("count", count).with("limit", parts);
            sink.error(0..0, message, [Message::new("expect-goal-text")]);
        }
    }

    /// The title as a reader sees it.
    pub fn title(&self, step: &LessonStep, scenes: &Scenes, lang: Lang) -> &str {
        if self.text.title.contains(SLOT) {
            &self.filled(step, scenes, lang).title
        } else {
            &self.text.title
        }
    }

    /// What it shows, as a reader sees it; its title where no claim is written.
    pub fn claim(&self, step: &LessonStep, scenes: &Scenes, lang: Lang) -> &str {
        if self.text.claim.is_none() {
            return self.title(step, scenes, lang);
        }
        let filled = self.filled(step, scenes, lang);
        filled.claim.as_ref().unwrap_or(&filled.title)
    }

    /// As a reader sees it: with the numbers of its runs, and terms marked.
    pub fn filled(&self, step: &LessonStep, scenes: &Scenes, lang: Lang) -> &StepText {
        self.filled.get_or_init(|| {
            let runs = Runs::new(scenes);
            let values = self.references.iter();
            let values = values.map(|placed| said(&placed.reference, step, &runs, lang));
            let mut filler = Filler {
                values: values.collect::<Vec<_>>().into_iter(),
            };
            let title = filler.fill(&self.text.title);
            let claim = self.text.claim.as_ref().map(|it| filler.fill(it));
            let sides = self.text.sides.as_ref();
            let sides = sides.map(|it| it.each_ref().map(|side| filler.fill(side)));
            let blocks = filler.blocks(&self.text.body).into_iter();
            let is_note = |block: &Block| matches!(block, Block::Note(_));
            let (note, mut body): (Vec<_>, Vec<_>) = blocks.partition(is_note);
            mentions::mark(&mut body, lang);
            StepText {
                title,
                claim,
                sides,
                body,
                note,
            }
        })
    }

    /// The places of its references, and what stands there for a reader.
    pub fn said<'a>(
        &'a self,
        step: &'a LessonStep,
        runs: &'a Runs<'a>,
        lang: Lang,
    ) -> impl Iterator<Item = (Range<usize>, String)> + 'a {
        let placed = self.references.iter();
        placed.map(move |it| (it.span.clone(), said(&it.reference, step, runs, lang)))
    }
}

/// What does not resolve is shown as what it is: a course that was checked has none.
fn said(reference: &Reference, step: &LessonStep, runs: &Runs<'_>, lang: Lang) -> String {
    match runs.resolve(reference, step) {
        Ok(value) => write(&value, reference.form, Catalog::of(lang)),
        Err(what) => format!("⟦{}⟧", what.code),
    }
}

fn write(value: &Value, form: Form, catalog: &Catalog) -> String {
    let number = match value {
        Value::Number(x) => Some(*x),
        Value::Ratio { num, den } => Some(num / den),
        Value::Count(n) => Some(*n as f64),
        _ => None,
    };
    match (form, number) {
        (Form::Fraction, _) => catalog.alike(Notation::Fractions).value(value),
        (Form::Decimal, _) => catalog.alike(Notation::Decimals).value(value),
        (Form::Places(n), Some(x)) => catalog.rounded(x, n),
        (Form::Grouped, Some(x)) => catalog.grouped(x),
        (Form::Own | Form::Places(_) | Form::Grouped, _) => catalog.value(value),
    }
}

/// Puts values into slots, one after the other.
struct Filler {
    values: std::vec::IntoIter<String>,
}

impl Filler {
    fn fill(&mut self, text: &str) -> String {
        let mut parts = text.split(SLOT);
        let mut filled = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            filled += &self.values.next().unwrap_or_default();
            filled += part;
        }
        filled
    }

    fn blocks(&mut self, blocks: &[Block]) -> Vec<Block> {
        let mut blocks = blocks.to_vec();
        for block in &mut blocks {
            match block {
                Block::Paragraph(text)
                | Block::ListItem { text, .. }
                | Block::Goal { text, .. }
                | Block::Note(text) => {
                    for part in text {
                        part.text = self.fill(&part.text);
                    }
                }
                Block::Answer(inner) => *inner = self.blocks(inner),
                Block::Code(_) | Block::Wait => {}
            }
        }
        blocks
    }
}
