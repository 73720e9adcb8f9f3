//! Which lines of a method's pseudocode are about what: as its own run has it, line by line.

use super::{extent::Asked, role::Link, run::Run};

const MOST_ASKED: usize = 128;

#[derive(Clone, Debug, Default)]
pub struct CodeLinks(Vec<Visit>);

#[derive(Clone, Debug)]
struct Visit {
    step: usize,
    line: usize,
    links: Vec<Link>,
}

impl CodeLinks {
    pub fn of(run: &dyn Run) -> Self {
        let asked = Asked::of(run, MOST_ASKED);
        let mut visits = Vec::new();
        for from_to in asked.stretches() {
            let wanted = |step| asked.holds(step);
            run.frames(from_to, wanted, |step, frame| {
                let links = frame.focus().collect();
                let line = frame.code_line;
                visits.extend(line.map(|line| Visit { step, line, links }));
            });
        }
        Self(visits)
    }

    /// What a line was about when it was reached last, or else will be about first: seen from `step`.
    pub fn of_line(&self, line: usize, step: usize) -> Option<Link> {
        let visits = self.0.iter();
        let mut visits = visits.filter(|visit| visit.line == line && !visit.links.is_empty());
        let before = visits.clone().take_while(|visit| visit.step <= step).last();
        let visit = before.or_else(|| visits.next())?;
        visit.links.first().copied()
    }

    pub fn lines(&self, link: Link) -> Vec<usize> {
        let visits = self.0.iter();
        let about = visits.filter(|visit| visit.links.contains(&link));
        let mut lines: Vec<usize> = about.map(|visit| visit.line).collect();
        lines.sort_unstable();
        lines.dedup();
        lines
    }
}
