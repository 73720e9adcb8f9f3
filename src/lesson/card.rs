//! The card at the end of a lesson: what is to be kept of it.

use super::markdown::{Block, Inline};

/// What a row of a card says. The words are those that begin it in the file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CardRow {
    Rule,
    Formula,
    Cost,
    Pitfall,
    Can,
}

impl CardRow {
    pub const ALL: [Self; 5] = [
        Self::Rule,
        Self::Formula,
        Self::Cost,
        Self::Pitfall,
        Self::Can,
    ];

    pub const fn id(self) -> &'static str {
        match self {
            Self::Rule => "rule",
            Self::Formula => "formula",
            Self::Cost => "cost",
            Self::Pitfall => "pitfall",
            Self::Can => "can",
        }
    }

    pub const fn name_key(self) -> &'static str {
        match self {
            Self::Rule => "card-rule",
            Self::Formula => "card-formula",
            Self::Cost => "card-cost",
            Self::Pitfall => "card-pitfall",
            Self::Can => "card-can",
        }
    }
}

/// Rows in their order: one of each kind, and of pitfalls two or more.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Card {
    pub rows: Vec<(CardRow, Vec<Inline>)>,
}

impl Card {
    /// Takes an item `rule: …` of the list that a card is; `None` where it is none.
    pub(super) fn take(&mut self, block: Block) -> Option<()> {
        let Block::ListItem {
            depth: 0, mut text, ..
        } = block
        else {
            return None;
        };
        let first = text.first_mut()?;
        let (word, rest) = first.text.split_once([':', '：'])?;
        let word = word.trim();
        let row = CardRow::ALL.into_iter().find(|row| row.id() == word)?;
        first.text = rest.trim_start().to_owned();
        text.retain(|part| !part.text.is_empty());
        self.rows.push((row, text));
        Some(())
    }

    /// Has it all of its rows, each with its words, in order?
    pub(super) fn is_whole(&self) -> bool {
        let mut kinds: Vec<CardRow> = self.rows.iter().map(|(row, _)| *row).collect();
        let n_pitfalls = kinds.iter().filter(|&&it| it == CardRow::Pitfall).count();
        kinds.dedup();
        let has_words = self.rows.iter().all(|(_, text)| !text.is_empty());
        has_words && kinds == CardRow::ALL && n_pitfalls >= 2
    }
}

/// The heading of a card, which is no step.
pub(super) const HEADING: &str = "card";
