//! A language's text of a lesson: its title, and one section for each step.

use std::ops::Range;

use crate::text::Message;

use super::{
    course::{LessonText, StepText},
    markdown::{self, Block, Part},
    nearest::nearest,
    sink::Sink,
    toml_fields::suggestion,
};

/// One `## id: Title` and what follows it.
struct Section {
    id: String,
    title: String,
    body: Vec<Block>,
    span: Range<usize>,
}

/// Reads a text; `ids` are the lesson's steps, `None` where `lesson.toml` leaves them unclear.
pub(super) fn read(ids: Option<&[String]>, sink: &mut Sink<'_>) -> Option<LessonText> {
    if sink.source().bad_byte.is_some() {
        return None;
    }
    let (title, sections, title_span) = split(sink);
    for section in &sections {
        if section.body.is_empty() {
            let message = Message::new("problem-empty-section").with("name", section.id.clone());
            sink.error(section.span.clone(), message, []);
        }
    }
    let steps = in_order(ids?, sections, title_span, sink);
    (sink.n_errors() == 0).then_some(LessonText {
        title: title?,
        steps,
    })
}

/// The title, the sections in the order of the file, and where the title stands.
fn split(sink: &mut Sink<'_>) -> (Option<String>, Vec<Section>, Range<usize>) {
    let (mut title, mut title_span) = (None, 0..0);
    let mut sections: Vec<Section> = Vec::new();
    // Under a heading that could not be read, or in text that was reported already.
    let mut is_lost = false;
    for (part, span) in markdown::parse(sink) {
        match part {
            Part::Heading {
                level: 1,
                title: text,
            } => {
                if title.is_some() || !sections.is_empty() {
                    sink.error(
                        span,
                        Message::new("problem-second-title"),
                        [bad_heading_note()],
                    );
                } else if text.trim().is_empty() {
                    sink.error(span, Message::new("problem-empty-text"), []);
                    title = Some(text);
                } else {
                    (title, title_span) = (Some(text.trim().to_owned()), span);
                }
            }
            Part::Heading { title: text, .. } => match heading(&text) {
                Some((id, title)) => {
                    is_lost = false;
                    sections.push(Section {
                        id: id.to_owned(),
                        title: title.to_owned(),
                        body: Vec::new(),
                        span,
                    });
                }
                None => {
                    is_lost = true;
                    sink.error(
                        span,
                        Message::new("problem-bad-heading"),
                        [bad_heading_note()],
                    );
                }
            },
            Part::Block(_) if is_lost => {}
            Part::Block(block) => match sections.last_mut() {
                Some(section) => section.body.push(block),
                None => {
                    is_lost = true;
                    sink.error(
                        span,
                        Message::new("problem-text-outside"),
                        [bad_heading_note()],
                    );
                }
            },
        }
    }
    if title.is_none() {
        sink.error(
            0..0,
            Message::new("problem-missing-title"),
            [Message::new("expect-title")],
        );
    }
    (title, sections, title_span)
}

/// `id: Title`, with a colon as any keyboard types it.
fn heading(text: &str) -> Option<(&str, &str)> {
    let (id, title) = text.split_once([':', '：'])?;
    let (id, title) = (id.trim(), title.trim());
    (!id.is_empty() && !title.is_empty()).then_some((id, title))
}

fn bad_heading_note() -> Message {
    Message::new("expect-heading")
}

/// One section for each step, in the steps' order; what is missing or too much is reported.
fn in_order(
    ids: &[String],
    sections: Vec<Section>,
    title_span: Range<usize>,
    sink: &mut Sink<'_>,
) -> Vec<StepText> {
    let names: Vec<&str> = ids.iter().map(String::as_str).collect();
    let mut slots: Vec<Option<Section>> = ids.iter().map(|_| None).collect();
    for section in sections {
        let message = |key| Message::new(key).with("name", section.id.clone());
        let Some(i) = ids.iter().position(|id| *id == section.id) else {
            let unused = names.iter().copied();
            let notes = suggestion(nearest(&section.id, unused), &names);
            sink.error(section.span.clone(), message("problem-unknown-step"), notes);
            continue;
        };
        if let Some(first) = &slots[i] {
            let line = sink.source().line(first.span.start).to_string();
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
        match slot {
            Some(section) => {
                before = section.span;
                steps.push(StepText {
                    title: section.title,
                    body: section.body,
                });
            }
            None => {
                let message = Message::new("problem-missing-section").with("name", id.clone());
                sink.error(before.clone(), message, [bad_heading_note()]);
            }
        }
    }
    steps
}
