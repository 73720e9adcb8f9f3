//! Where lines break.

use std::ops::Range;

use super::script::{Char, Gap};

/// Characters in lines of at most `width`, given where on one long line each begins and ends.
pub fn rows(chars: &[Char], places: &[[f32; 2]], width: f32) -> Vec<Range<usize>> {
    let mut lines = Lines {
        chars,
        places,
        width,
        done: Vec::new(),
        line: 0..0,
    };
    lines.fill(0..chars.len(), Gap::Words);
    lines.done.push(lines.line.clone());
    lines.done
}

struct Lines<'a> {
    chars: &'a [Char],
    places: &'a [[f32; 2]],
    width: f32,
    done: Vec<Range<usize>>,
    /// The one that is being filled.
    line: Range<usize>,
}

impl Lines<'_> {
    /// Goes on with these characters, breaking at no worse gaps than these unless it must.
    fn fill(&mut self, range: Range<usize>, gap: Gap) {
        let worse = match gap {
            Gap::Words => Some(Gap::Relation),
            Gap::Relation => Some(Gap::Term),
            Gap::Term => Some(Gap::Any),
            Gap::Any | Gap::Closed => None,
        };
        let mut start = range.start;
        while start < range.end {
            let next = (start + 1..range.end).find(|&i| self.chars[i].gap <= gap);
            let chunk = start..next.unwrap_or(range.end);
            start = chunk.end;
            let fits = self.fits(self.line.start..chunk.end);
            match worse {
                _ if fits => self.line.end = chunk.end,
                Some(worse) if !self.fits(chunk.clone()) => self.fill(chunk, worse),
                _ => {
                    if !self.line.is_empty() {
                        self.done.push(self.line.clone());
                    }
                    self.line = chunk;
                }
            }
        }
    }

    /// A space at the end of a line takes no room.
    fn fits(&self, range: Range<usize>) -> bool {
        let last = range.clone().rev().find(|&i| self.chars[i].c != ' ');
        last.is_none_or(|last| self.places[last][1] - self.places[range.start][0] <= self.width)
    }
}
