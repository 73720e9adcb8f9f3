//! What a student has seen of a course and told beforehand, as it is kept in a file.
//!
//! Marks only grow: two files of one student have one union, in whatever order they are put together. A new student begins afresh.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::text::{Diagnostic, Message};

use super::course::{Course, Lesson};

/// More than the marks of any course take.
pub const MAX_PROGRESS_BYTES: u64 = 1 << 20;
const VERSION: u64 = 1;

/// Marks of steps, by `lesson/step`.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Progress {
    /// When its student began, in seconds since 1970: of two students at one computer the later one is there.
    pub begun: u64,
    pub steps: BTreeMap<String, Mark>,
}

/// A step that was seen, and how its question was answered. What is not so yet is not written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Mark {
    #[serde(skip_serializing_if = "is_nothing")]
    pub told: Told,
    /// Has its goal been reached?
    #[serde(skip_serializing_if = "is_nothing")]
    pub reached: bool,
    /// How many parts of the hint towards it have been seen.
    #[serde(skip_serializing_if = "is_nothing")]
    pub hints: usize,
}

fn is_nothing<T: Default + PartialEq>(of: &T) -> bool {
    *of == T::default()
}

/// How a question was answered, the better the later.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Told {
    /// Not at all.
    #[default]
    Open,
    /// The numbers that decide have been seen.
    Missed,
    AfterTheNumbers,
    Beforehand,
}

/// How many steps of some were seen, and how their questions were answered.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Tally {
    pub seen: usize,
    /// Steps that ask.
    pub asked: usize,
    pub beforehand: usize,
    pub after: usize,
    /// Steps with a goal, and those of them where it has been reached.
    pub goals: usize,
    pub reached: usize,
}

impl Told {
    /// After this answer.
    pub fn answered(self, is_right: bool) -> Self {
        let now = match (is_right, self) {
            (true, Self::Missed | Self::AfterTheNumbers) => Self::AfterTheNumbers,
            (true, _) => Self::Beforehand,
            (false, _) => Self::Missed,
        };
        self.max(now)
    }
}

impl Tally {
    pub const fn open(&self) -> usize {
        self.asked - self.beforehand - self.after
    }

    /// What a platform is told: what was told beforehand and a goal that is reached count whole, what was told after the numbers
    /// half. 1 where nothing is asked.
    pub fn score(&self) -> f64 {
        let all = self.asked + self.goals;
        if all == 0 {
            return 1.0;
        }
        let whole = self.beforehand + self.reached;
        (whole as f64 + 0.5 * self.after as f64) / all as f64
    }

    fn add(&mut self, other: Self) {
        self.seen += other.seen;
        self.asked += other.asked;
        self.beforehand += other.beforehand;
        self.after += other.after;
        self.goals += other.goals;
        self.reached += other.reached;
    }
}

impl Progress {
    /// # Errors
    /// Where the bytes are no file of progress, or one of a later version.
    pub fn read(bytes: &[u8]) -> Result<Self, Diagnostic> {
        let json: Option<serde_json::Value> = serde_json::from_slice(bytes).ok();
        let version = json.as_ref().and_then(|json| json.get("version")?.as_u64());
        match (json, version) {
            (Some(json), Some(VERSION)) => serde_json::from_value(json)
                .map_err(|_| Message::new("error-progress-broken").into()),
            (_, Some(_)) => Err(Message::new("error-progress-version").into()),
            _ => Err(Message::new("error-progress-broken").into()),
        }
    }

    pub fn written(&self) -> String {
        format!("{:#}\n", self.json())
    }

    /// The same on one line, of these lessons alone.
    pub fn written_of(&self, lessons: &[&Lesson]) -> String {
        let is_of = |name: &str| {
            let of = name.split_once('/').map(|(lesson, _)| lesson);
            lessons.iter().any(|lesson| Some(&*lesson.id) == of)
        };
        let steps = self.steps.iter().filter(|(name, _)| is_of(name));
        let of_these = Self {
            begun: self.begun,
            steps: steps.map(|(name, mark)| (name.clone(), *mark)).collect(),
        };
        of_these.json().to_string()
    }

    /// As much as there can be of a lesson.
    pub fn mark_all(&mut self, lesson: &Lesson) {
        for step in &lesson.steps {
            let mark = Mark {
                told: step.asks.map_or(Told::Open, |_| Told::AfterTheNumbers),
                reached: step.goal.is_some(),
                hints: step.goal.as_ref().map_or(0, |_| 9),
            };
            self.steps.insert(name(&lesson.id, &step.id), mark);
        }
    }

    fn json(&self) -> serde_json::Value {
        json!({ "version": VERSION, "begun": self.begun, "steps": self.steps })
    }

    pub fn mark(&self, lesson: &str, step: &str) -> Option<Mark> {
        self.steps.get(&name(lesson, step)).copied()
    }

    /// Something new?
    pub fn see(&mut self, lesson: &str, step: &str) -> bool {
        let n_steps = self.steps.len();
        self.steps.entry(name(lesson, step)).or_default();
        self.steps.len() > n_steps
    }

    pub fn answer(&mut self, lesson: &str, step: &str, is_right: bool) {
        let mark = self.steps.entry(name(lesson, step)).or_default();
        mark.told = mark.told.answered(is_right);
    }

    /// Of a step that asks its whole run: were all its decisions told beforehand?
    pub fn finish(&mut self, lesson: &str, step: &str, is_whole: bool) {
        let mark = self.steps.entry(name(lesson, step)).or_default();
        let told = if is_whole {
            Told::Beforehand
        } else {
            Told::AfterTheNumbers
        };
        mark.told = mark.told.max(told);
    }

    /// Something new?
    pub fn reach(&mut self, lesson: &str, step: &str) -> bool {
        let mark = self.steps.entry(name(lesson, step)).or_default();
        !std::mem::replace(&mut mark.reached, true)
    }

    /// Something new?
    pub fn hint(&mut self, lesson: &str, step: &str, n_parts: usize) -> bool {
        let mark = self.steps.entry(name(lesson, step)).or_default();
        let seen = mark.hints.max(n_parts);
        std::mem::replace(&mut mark.hints, seen) != seen
    }

    /// With what another file of the same student has.
    pub fn merge(&mut self, other: &Self) {
        for (name, mark) in &other.steps {
            let own = self.steps.entry(name.clone()).or_default();
            own.told = own.told.max(mark.told);
            own.reached |= mark.reached;
            own.hints = own.hints.max(mark.hints);
        }
    }

    /// What has changed since it was like this.
    #[must_use]
    pub fn since(&self, before: &Self) -> Self {
        let is_new = |(name, mark): &(&String, &Mark)| before.steps.get(*name) != Some(*mark);
        let steps = self.steps.iter().filter(is_new);
        Self {
            begun: self.begun,
            steps: steps.map(|(name, mark)| (name.clone(), *mark)).collect(),
        }
    }

    /// Of two that were kept by windows of one computer: the union, where they are of one student, else the later student's.
    #[must_use]
    pub fn joined(mut self, other: &Self) -> Self {
        match self.begun.cmp(&other.begun) {
            std::cmp::Ordering::Less => other.clone(),
            std::cmp::Ordering::Equal => {
                self.merge(other);
                self
            }
            std::cmp::Ordering::Greater => self,
        }
    }

    pub fn of_lesson(&self, lesson: &Lesson) -> Tally {
        let mut tally = Tally::default();
        for step in &lesson.steps {
            let mark = self.mark(&lesson.id, &step.id);
            let told = mark.unwrap_or_default().told;
            tally.add(Tally {
                seen: usize::from(mark.is_some()),
                asked: usize::from(step.asks.is_some()),
                beforehand: usize::from(step.asks.is_some() && told == Told::Beforehand),
                after: usize::from(step.asks.is_some() && told == Told::AfterTheNumbers),
                goals: usize::from(step.goal.is_some()),
                reached: usize::from(step.goal.is_some() && mark.is_some_and(|it| it.reached)),
            });
        }
        tally
    }

    pub fn of_course(&self, course: &Course) -> Tally {
        self.of_lessons(&course.lessons)
    }

    pub fn of_lessons<'a>(&self, lessons: impl IntoIterator<Item = &'a Lesson>) -> Tally {
        let mut all = Tally::default();
        for lesson in lessons {
            all.add(self.of_lesson(lesson));
        }
        all
    }
}

fn name(lesson: &str, step: &str) -> String {
    format!("{lesson}/{step}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(begun: u64, marks: &[(&str, Told)]) -> Progress {
        let mark = |&(name, told): &(&str, Told)| {
            let reached = name.ends_with("goal");
            let mark = Mark {
                told,
                reached,
                hints: 0,
            };
            (name.to_owned(), mark)
        };
        let steps = marks.iter().map(mark).collect();
        Progress { begun, steps }
    }

    #[test]
    fn a_platform_keeps_the_marks_of_its_lessons_alone() {
        let course = Course::embedded();
        let [first, second, ..] = &course.lessons[..] else {
            panic!("a course has lessons");
        };
        let mut progress = Progress::default();
        progress.answer(&first.id, &first.steps[0].id, true);
        progress.see(&second.id, &second.steps[0].id);
        let kept = progress.written_of(&[first]);
        let read = Progress::read(kept.as_bytes()).expect("as it was written");
        assert_eq!(read.steps.len(), 1);
        assert_eq!(read.of_lesson(first), progress.of_lesson(first));
        assert_eq!(
            progress.of_lessons([first, second]).seen,
            progress.of_course(&course).seen
        );
    }

    #[test]
    fn an_answer_never_takes_a_mark_away() {
        use Told::{AfterTheNumbers, Beforehand, Missed, Open};
        for (before, is_right, after) in [
            (Open, true, Beforehand),
            (Open, false, Missed),
            (Missed, false, Missed),
            (Missed, true, AfterTheNumbers),
            (AfterTheNumbers, false, AfterTheNumbers),
            (AfterTheNumbers, true, AfterTheNumbers),
            (Beforehand, false, Beforehand),
            (Beforehand, true, Beforehand),
        ] {
            assert_eq!(before.answered(is_right), after, "{before:?} {is_right}");
        }
    }

    #[test]
    fn two_files_of_one_student_have_one_union() {
        let one = with(7, &[("a/x", Told::Missed), ("a/y", Told::Beforehand)]);
        let other = with(7, &[("a/x", Told::AfterTheNumbers), ("b/goal", Told::Open)]);
        let both = one.clone().joined(&other);
        assert_eq!(both, other.clone().joined(&one));
        assert_eq!(both.steps.len(), 3);
        assert!(both.mark("b", "goal").unwrap().reached);
        assert_eq!(both.mark("a", "x").unwrap().told, Told::AfterTheNumbers);
        let new = with(8, &[]);
        assert_eq!(both.clone().joined(&new), new);
        assert_eq!(new.clone().joined(&both), new);
    }

    #[test]
    fn what_is_written_is_read_again_and_all_else_is_refused() {
        let progress = with(9, &[("a/x", Told::Beforehand), ("b/z", Told::Open)]);
        let written = progress.written();
        assert_eq!(Progress::read(written.as_bytes()).unwrap(), progress);
        for (bytes, key) in [
            ("", "error-progress-broken"),
            ("[]", "error-progress-broken"),
            ("{}", "error-progress-broken"),
            ("{\"version\": 1, \"steps\": 3}", "error-progress-broken"),
            (
                "{\"version\": 1, \"steps\": {\"a/x\": {\"told\": \"best\"}}}",
                "error-progress-broken",
            ),
            ("{\"version\": 2}", "error-progress-version"),
        ] {
            let refused = Progress::read(bytes.as_bytes()).unwrap_err();
            assert_eq!(refused.message.key, key, "{bytes}");
        }
    }

    #[test]
    fn half_is_scored_after_the_numbers() {
        let tally = |beforehand, after, [reached, goals]: [usize; 2]| Tally {
            seen: 9,
            asked: 4,
            beforehand,
            after,
            goals,
            reached,
        };
        assert_eq!(tally(0, 0, [0, 0]).score(), 0.0);
        assert_eq!(tally(2, 1, [0, 0]).score(), 0.625);
        assert_eq!(tally(2, 1, [1, 1]).score(), 0.7);
        assert_eq!(tally(4, 0, [0, 1]).score(), 0.8);
        assert_eq!(tally(1, 1, [0, 0]).open(), 2);
        assert_eq!(Tally::default().score(), 1.0);
    }
}
