//! A language's text of a lesson: its title, and one section for each step.

use std::collections::BTreeMap;

use super::{
    card::{self, Card},
    markdown::{self, Block, StepText, TextPart, stray_claim, stray_sides},
    prelude::*,
    reference::{Braces, WrittenStep, WrittenText},
};

/// One `## id: Title` and what follows it.
struct Section {
    id: String,
    title: String,
    claim: Option<String>,
    sides: Option<[String; 2]>,
    body: Vec<Block>,
    span: Range<usize>,
    /// The places of references in its title and its body.
    references: Vec<Range<usize>>,
}

/// Reads a text; `ids` are the lesson's steps, `None` where `lesson.toml` leaves them unclear; `controls` is what it can lead to.
pub(super) fn read(
    ids: Option<&[String]>,
    controls: Option<&[&'static str]>,
    sink: &Sink<'_>,
) -> Option<WrittenText> {
    if sink.source.bad_byte.is_some() {
        return None;
    }
    let braces = Braces::of(&sink.source.text);
    if let Some(at) = braces.unclosed {
        let expected = [Message::new("expect-reference")];
        sink.error(at..at + 1, Message::new("problem-bad-reference"), expected);
    }
    let mut file = Splitter::default();
    for (part, span) in markdown::parse(&braces.text, controls, sink) {
        match part {
            TextPart::Heading { level: 1, title } => file.title(title.trim(), span, sink),
            TextPart::Heading { title, .. } => file.section(&title, span, sink),
            TextPart::Claim(claim) => file.claim(&claim, span, sink),
            TextPart::Block(block) => file.block(block, span, sink),
        }
    }
    let Some((title, title_span)) = file.title.take() else {
        let expected = [Message::new("expect-title")];
        sink.error(0..0, Message::new("problem-missing-title"), expected);
        return None;
    };
    file.take_references(&braces.spans, sink);
    let is_note = |block: &Block| matches!(block, Block::Note(_));
    let is_empty = |section: &&Section| section.body.iter().all(is_note);
    for section in file.sections.iter().filter(is_empty) {
        let message = Message::new("problem-empty-section").with("name", clipped(&section.id));
        sink.error(section.span.clone(), message, []);
    }
    let steps = in_order(ids?, file.sections, title_span, sink);
    let card = file.card.take().map(|(card, span)| {
        if !card.is_whole() {
            bad_card(span, sink);
        }
        card
    });
    (sink.n_errors() == 0).then_some(WrittenText { title, card, steps })
}

#[derive(Default)]
struct Splitter {
    title: Option<(String, Range<usize>)>,
    sections: Vec<Section>,
    /// It comes last.
    card: Option<(Card, Range<usize>)>,
    /// Under a heading that could not be read, or in text that was reported already.
    is_lost: bool,
}

impl Splitter {
    fn title(&mut self, text: &str, span: Range<usize>, sink: &Sink<'_>) {
        if self.title.is_some() || !self.sections.is_empty() || self.card.is_some() {
            let message = Message::new("problem-second-title");
            sink.error(span, message, [Message::new("expect-heading")]);
            return;
        }
        if text.is_empty() {
            sink.error(span.clone(), Message::new("problem-empty-text"), []);
        }
        self.title = Some((text.to_owned(), span));
    }

    fn section(&mut self, text: &str, span: Range<usize>, sink: &Sink<'_>) {
        if self.card.is_some() {
            bad_card(span, sink);
            return;
        }
        if text.trim() == card::HEADING {
            self.card = Some((Card::default(), span));
            self.is_lost = false;
            return;
        }
        let heading = heading(text);
        self.is_lost = heading.is_none();
        let Some((id, title)) = heading else {
            let message = Message::new("problem-bad-heading");
            sink.error(span, message, [Message::new("expect-heading")]);
            return;
        };
        self.sections.push(Section {
            id: id.to_owned(),
            title: title.to_owned(),
            claim: None,
            sides: None,
            body: Vec::new(),
            span,
            references: Vec::new(),
        });
    }

    /// It stands under the heading of a step, once, over all else.
    fn claim(&mut self, claim: &str, span: Range<usize>, sink: &Sink<'_>) {
        if self.is_lost {
            return;
        }
        let section = self.sections.last_mut().filter(|_| self.card.is_none());
        match section.filter(|it| it.claim.is_none() && it.body.is_empty()) {
            Some(section) => match with_sides(claim) {
                Some((claim, sides)) => {
                    (section.claim, section.sides) = (Some(claim.to_owned()), sides);
                }
                None => stray_sides(span, sink),
            },
            None => stray_claim(span, sink),
        }
    }

    /// Gives each section the references that stand in it; the lesson's title and its card have none.
    fn take_references(&mut self, spans: &[Range<usize>], sink: &Sink<'_>) {
        let card = self
            .card
            .as_ref()
            .map_or(usize::MAX, |(_, span)| span.start);
        for span in spans {
            if span.start > card {
                sink.error(span.clone(), Message::new("problem-reference-outside"), []);
                continue;
            }
            let begun = |section: &&mut Section| section.span.start <= span.start;
            match self.sections.iter_mut().rfind(begun) {
                Some(section) => section.references.push(span.clone()),
                None => sink.error(span.clone(), Message::new("problem-reference-outside"), []),
            }
        }
    }

    fn block(&mut self, block: Block, span: Range<usize>, sink: &Sink<'_>) {
        if self.is_lost {
            return;
        }
        if let Some((card, _)) = &mut self.card {
            if card.take(block).is_none() {
                bad_card(span, sink);
            }
        } else if let Some(section) = self.sections.last_mut() {
            section.body.push(block);
        } else if self.title.is_some() {
            self.is_lost = true;
            let message = Message::new("problem-text-outside");
            sink.error(span, message, [Message::new("expect-heading")]);
        }
    }
}

fn bad_card(span: Range<usize>, sink: &Sink<'_>) {
    let expected = [Message::new("expect-card")];
    sink.error(span, Message::new("problem-bad-card"), expected);
}

/// A claim, and what the line `=| … | …` under it names.
fn with_sides(text: &str) -> Option<(&str, Option<[String; 2]>)> {
    let Some((claim, sides)) = text.split_once(" =| ") else {
        return Some((text, None));
    };
    let (was, is) = sides.split_once(" | ")?;
    Some((claim, Some([was.to_owned(), is.to_owned()])))
}

/// `id: Title`, with a colon as any keyboard types it.
fn heading(text: &str) -> Option<(&str, &str)> {
    let (id, title) = text.split_once([':', '：'])?;
    let (id, title) = (id.trim(), title.trim());
    (!id.is_empty() && !title.is_empty()).then_some((id, title))
}

/// One section for each step, in the steps' order; what is missing or too much is reported.
fn in_order(
    ids: &[String],
    sections: Vec<Section>,
    title_span: Range<usize>,
    sink: &Sink<'_>,
) -> Vec<WrittenStep> {
    let names: Vec<&str> = ids.iter().map(String::as_str).collect();
    let index: BTreeMap<&str, usize> = names.iter().copied().zip(0..).collect();
    let mut slots: Vec<Option<Section>> = ids.iter().map(|_| None).collect();
    for section in sections {
        let message = |key| Message::new(key).with("name", clipped(&section.id));
        let Some(&i) = index.get(&*section.id) else {
            let meant = sink.nearest(&section.id, names.iter().copied());
            let notes = suggestion(meant, &names);
            sink.error(section.span.clone(), message("problem-unknown-step"), notes);
            continue;
        };
        if let Some(first) = &slots[i] {
            let line = sink.source.line(first.span.start).to_string();
            let first = Message::new("expect-first-here").with("line", line);
            sink.error(
                section.span.clone(),
                message("problem-duplicate-section"),
                [first],
            );
            continue;
        }
        slots[i] = Some(section);
    }
    let mut before = title_span;
    let mut steps = Vec::new();
    for (id, slot) in ids.iter().zip(slots) {
        if let Some(section) = slot {
            before = section.span;
            let text = StepText {
                title: section.title,
                claim: section.claim,
                sides: section.sides,
                body: section.body,
                note: Vec::new(),
            };
            steps.push(WrittenStep::new(text, &section.references, sink));
        } else {
            let message = Message::new("problem-missing-section").with("name", clipped(id));
            let heading = Message::new("expect-section").with("name", clipped(id));
            sink.error(before.clone(), message, [heading]);
        }
    }
    steps
}
