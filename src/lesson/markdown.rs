//! The part of Markdown that lesson texts are written in, parsed once into blocks that are only laid out.

use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd};

use super::{glossary::Word, prelude::*, problem::is_wide, reference::Braces};

#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Block {
    Paragraph(Vec<Inline>),
    ListItem {
        /// 0 for a list that is not in another.
        depth: usize,
        marker: BlockMarker,
        text: Vec<Inline>,
    },
    /// A part of the step's goal, counted from 0.
    Goal {
        nth: usize,
        text: Vec<Inline>,
    },
    /// Lines of code, each ended by a line break.
    Code(String),
    /// Hidden until the reader asks for it.
    Answer(Vec<Self>),
    /// For whoever presents the step, and for nobody else.
    Note(Vec<Inline>),
    /// `---`: while the step asks what comes, what follows waits for the answer.
    Wait,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BlockMarker {
    Bullet,
    Number(u64),
    /// Nothing: another paragraph of the item above.
    Continued,
}

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Inline {
    /// Spaces between words are its own; `\n` breaks the line.
    pub text: String,
    pub strong: bool,
    pub emphasis: bool,
    pub code: bool,
    /// The control that it leads to, by its id.
    pub control: Option<&'static str>,
    /// The term that this is the first mention of in its step, once the text is to be read.
    pub term: Option<&'static Word>,
}

/// A step's text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct StepText {
    /// What is asked, or spoken of.
    pub title: String,
    /// What is shown: the step's finding, in a sentence.
    pub claim: Option<String>,
    /// What stands over how it was and how it is, where a step shows both.
    pub sides: Option<[String; 2]>,
    pub body: Vec<Block>,
    /// What the speaker is told.
    pub note: Vec<Block>,
}

impl StepText {
    /// From the paragraph that asks to the answer.
    pub fn question(&self) -> Option<&[Block]> {
        let is_answer = |block: &Block| matches!(block, Block::Answer(_));
        let answer = self.body.iter().position(is_answer)?;
        let asks = |block: &Block| matches!(block, Block::Paragraph(_));
        let question = self.body[..answer].iter().rposition(asks)?;
        Some(&self.body[question..=answer])
    }
}

pub(super) enum TextPart {
    /// `# …` is level 1, `## …` level 2.
    Heading {
        level: usize,
        title: String,
    },
    /// `=> …`
    Claim(String),
    Block(Block),
}

/// Reads a text of which the references have been taken out; what the format has no place for is reported. It can lead to these
/// controls.
pub(super) fn parse(
    text: &str,
    controls: Option<&[&'static str]>,
    sink: &Sink<'_>,
) -> Vec<(TextPart, Range<usize>)> {
    let mut reader = Reader {
        controls,
        ..Reader::default()
    };
    let parser = Parser::new_ext(text, Options::ENABLE_TASKLISTS);
    for (event, span) in parser.into_offset_iter() {
        reader.event(event, span, sink);
    }
    reader.parts
}

#[derive(Default)]
struct Reader<'a> {
    /// None where the lab is not known.
    controls: Option<&'a [&'static str]>,
    control: Option<&'static str>,
    parts: Vec<(TextPart, Range<usize>)>,
    inlines: Vec<Inline>,
    strong: usize,
    emphasis: usize,
    code_block: Option<String>,
    /// The next number of each open list, outermost first.
    lists: Vec<Option<u64>>,
    /// The marker of the item that has not begun yet.
    marker: Option<BlockMarker>,
    /// Blocks of the open answer, and how many quotes are open.
    answer: Vec<Block>,
    quotes: usize,
    is_heading: bool,
    /// Is the open item a part of a goal, and how many were there before in its step?
    is_goal: bool,
    n_goals: usize,
}

impl Reader<'_> {
    fn event(&mut self, event: Event<'_>, span: Range<usize>, sink: &Sink<'_>) {
        match event {
            Event::Start(tag) => self.start(&tag, &span, sink),
            Event::End(tag) => self.end(tag, span, sink),
            Event::Text(text) => match &mut self.code_block {
                Some(code) => code.push_str(&text),
                None => self.push(&text, false),
            },
            Event::Code(code) => self.push(&code, true),
            Event::SoftBreak => self.push("\u{2028}", false),
            Event::HardBreak => self.push("\n", false),
            Event::Rule if self.quotes == 0 && self.lists.is_empty() => {
                self.block(Block::Wait, span);
            }
            Event::InlineHtml(_) | Event::Html(_) | Event::Rule => unsupported(span, sink),
            // Extensions that are not switched on.
            Event::InlineMath(_) | Event::DisplayMath(_) | Event::FootnoteReference(_) => {}
            Event::TaskListMarker(_) => self.is_goal = true,
        }
    }

    fn start(&mut self, tag: &Tag<'_>, span: &Range<usize>, sink: &Sink<'_>) {
        match tag {
            Tag::Strong => self.strong += 1,
            Tag::Emphasis => self.emphasis += 1,
            Tag::CodeBlock(CodeBlockKind::Fenced(_) | CodeBlockKind::Indented) => {
                self.code_block = Some(String::new());
            }
            Tag::List(first) => {
                // The text of an item that has a list in it ends here.
                self.end_of_text(span.clone(), sink);
                self.lists.push(*first);
            }
            Tag::Item => {
                self.marker = Some(match self.lists.last_mut() {
                    Some(Some(number)) => {
                        *number += 1;
                        BlockMarker::Number(*number - 1)
                    }
                    _ => BlockMarker::Bullet,
                });
            }
            Tag::BlockQuote(_) => {
                self.end_of_text(span.clone(), sink);
                self.quotes += 1;
                if self.quotes > 1 || !self.lists.is_empty() {
                    unsupported(span.clone(), sink);
                }
            }
            Tag::Heading { .. } => {
                self.is_heading = true;
                if self.quotes > 0 || !self.lists.is_empty() {
                    unsupported(span.clone(), sink);
                }
            }
            Tag::Link { dest_url, .. } => self.control = self.link(dest_url, span, sink),
            Tag::Image { .. } => unsupported(span.clone(), sink),
            _ => {}
        }
    }

    fn end(&mut self, tag: TagEnd, span: Range<usize>, sink: &Sink<'_>) {
        match tag {
            TagEnd::Strong => self.strong -= 1,
            TagEnd::Emphasis => self.emphasis -= 1,
            TagEnd::Link => self.control = None,
            TagEnd::Paragraph | TagEnd::Item => self.end_of_text(span, sink),
            TagEnd::List(_) => {
                self.lists.pop();
                self.marker = None;
            }
            TagEnd::CodeBlock => {
                let code = self.code_block.take().unwrap_or_default();
                self.block(Block::Code(code), span);
            }
            TagEnd::BlockQuote(_) => {
                self.quotes -= 1;
                if self.quotes == 0 {
                    let answer = std::mem::take(&mut self.answer);
                    self.block(Block::Answer(answer), span);
                }
            }
            TagEnd::Heading(level) => self.heading(level, span, sink),
            _ => {}
        }
    }

    /// The control that `control:section.name` names.
    fn link(&self, url: &str, span: &Range<usize>, sink: &Sink<'_>) -> Option<&'static str> {
        let Some(id) = url.strip_prefix("control:").filter(|_| !self.is_heading) else {
            unsupported(span.clone(), sink);
            return None;
        };
        let all = self.controls?;
        let known = all.iter().find(|known| **known == id).copied();
        if known.is_none() {
            let message = Message::new("problem-unknown-control").with("name", clipped(id));
            let meant = sink.nearest(id, all.iter().copied());
            sink.error(span.clone(), message, suggestion(meant, all));
        }
        known
    }

    fn heading(&mut self, level: HeadingLevel, span: Range<usize>, sink: &Sink<'_>) {
        (self.is_heading, self.n_goals) = (false, 0);
        let title: String = self.inlines().into_iter().map(|part| part.text).collect();
        if level > HeadingLevel::H2 {
            unsupported(span, sink);
            return;
        }
        let level = level as usize;
        self.parts.push((TextPart::Heading { level, title }, span));
    }

    /// Takes the marks from the lines of a note; is the open paragraph one?
    fn take_marks(&mut self, span: &Range<usize>, sink: &Sink<'_>) -> bool {
        let text: String = self.inlines.iter().map(|part| &*part.text).collect();
        let mut lines = text.split(SOFT_BREAK);
        if !lines.clone().any(|line| line.starts_with(NOTE.trim_end())) {
            return false;
        }
        let is_whole = lines.all(|line| line.starts_with(NOTE));
        if !is_whole || self.quotes > 0 || !self.lists.is_empty() {
            let expected = [Message::new("expect-note")];
            sink.error(span.clone(), Message::new("problem-stray-note"), expected);
        }
        let mark = format!("{SOFT_BREAK}{NOTE}");
        for (i, part) in self.inlines.iter_mut().enumerate() {
            let first = part.text.strip_prefix(NOTE).filter(|_| i == 0);
            let rest = first.unwrap_or(&part.text);
            part.text = rest.replace(&mark, &SOFT_BREAK.to_string());
        }
        true
    }

    /// Ends a paragraph or the text of an item, where one is open.
    fn end_of_text(&mut self, span: Range<usize>, sink: &Sink<'_>) {
        let is_note = self.take_marks(&span, sink);
        let mut text = self.inlines();
        if text.is_empty() {
            return;
        }
        if text[0].text.starts_with(CLAIM) {
            text[0].text.drain(..CLAIM.len());
            if self.quotes > 0 || !self.lists.is_empty() {
                stray_claim(span, sink);
                return;
            }
            let claim = text.into_iter().map(|part| part.text).collect();
            self.parts.push((TextPart::Claim(claim), span));
            return;
        }
        let n_letters: usize = text.iter().map(|part| part.text.chars().count()).sum();
        if n_letters > MAX_LETTERS {
            let message = Message::new("problem-long-paragraph").with("count", n_letters);
            sink.error(span, message.with("limit", MAX_LETTERS), []);
            return;
        }
        let is_stray = |part: &Inline| !part.code && part.text.contains("**");
        if text.iter().any(is_stray) {
            let at = sink.source.text[span.clone()].find("**").unwrap_or(0);
            let start = span.start + at;
            let expected = [Message::new("expect-emphasis")];
            sink.error(
                start..start + 2,
                Message::new("problem-stray-emphasis"),
                expected,
            );
        }
        let block = if is_note {
            Block::Note(text)
        } else if std::mem::take(&mut self.is_goal) {
            let nth = self.n_goals;
            self.n_goals += 1;
            Block::Goal { nth, text }
        } else if self.lists.is_empty() {
            Block::Paragraph(text)
        } else {
            Block::ListItem {
                depth: self.lists.len() - 1,
                marker: self.marker.take().unwrap_or(BlockMarker::Continued),
                text,
            }
        };
        self.block(block, span);
    }

    fn block(&mut self, block: Block, span: Range<usize>) {
        if self.quotes > 0 {
            self.answer.push(block);
        } else {
            self.parts.push((TextPart::Block(block), span));
        }
    }

    fn push(&mut self, text: &str, code: bool) {
        let text = &Braces::without_filler(text);
        let (strong, emphasis) = (self.strong > 0, self.emphasis > 0);
        let look = (strong, emphasis, code, self.control);
        match self.inlines.last_mut() {
            Some(last) if (last.strong, last.emphasis, last.code, last.control) == look => {
                last.text.push_str(text);
            }
            _ => self.inlines.push(Inline {
                text: text.clone(),
                strong,
                emphasis,
                code,
                control: self.control,
                term: None,
            }),
        }
    }

    /// The text so far, its soft line breaks resolved.
    fn inlines(&mut self) -> Vec<Inline> {
        let mut inlines = std::mem::take(&mut self.inlines);
        let all: Vec<char> = inlines.iter().flat_map(|part| part.text.chars()).collect();
        let mut i = 0_usize;
        for part in &mut inlines {
            let resolve = |c: char| {
                i += 1;
                if c != SOFT_BREAK {
                    return Some(c);
                }
                // Between two Chinese characters a line break is no space.
                let before = i.checked_sub(2).and_then(|i| all.get(i)).copied();
                let after = all.get(i).copied();
                let joins = before.is_some_and(is_wide) && after.is_some_and(is_wide);
                (!joins).then_some(' ')
            };
            part.text = part.text.chars().filter_map(resolve).collect();
        }
        inlines.retain(|part| !part.text.is_empty());
        inlines
    }
}

/// A longer paragraph is no text, and would take seconds to set.
const MAX_LETTERS: usize = 20_000;

/// Begins the claim under a step's heading.
const CLAIM: &str = "=> ";

/// Begins each line of a note for the speaker.
const NOTE: &str = "!> ";

/// Stands for a line break in the file until its neighbours are known.
const SOFT_BREAK: char = '\u{2028}';

pub(super) fn stray_claim(span: Range<usize>, sink: &Sink<'_>) {
    let expected = [Message::new("expect-claim")];
    sink.error(span, Message::new("problem-stray-claim"), expected);
}

pub(super) fn stray_sides(span: Range<usize>, sink: &Sink<'_>) {
    let expected = [Message::new("expect-sides")];
    sink.error(span, Message::new("problem-stray-sides"), expected);
}

fn unsupported(span: Range<usize>, sink: &Sink<'_>) {
    let expected = [Message::new("expect-markdown")];
    sink.error(span, Message::new("problem-unsupported-markdown"), expected);
}
