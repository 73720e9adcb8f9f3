//! Which steps of a lesson are seen at one scale.

use crate::labs::Scene;

use super::{course::Lesson, step::LessonStep};

/// Scenes are seen together where they are at most so many clip regions wide and high.
const MOST_REGIONS: f64 = 1.6;

type Rect = [[f64; 2]; 2];

/// Scenes that lie near one another.
struct Setting {
    bounds: Rect,
    /// What is shown: with what around the scenes belongs to the picture.
    frame: Rect,
    /// Width and height of the smallest clip region.
    region: [f64; 2],
}

impl Lesson {
    /// The rectangle of the plane that a scene of this lesson shows at first. It is the same for all steps whose scenes lie near
    /// one another, so that nothing moves from step to step.
    pub fn bounds_of(&self, scene: &Scene) -> Rect {
        let own = scene.document().frame();
        let mut settings: Vec<Setting> = Vec::new();
        let mut found = None;
        for step in &self.steps {
            let Some(now) = Setting::of_step(step) else {
                continue;
            };
            let among = |known: &Setting| known.with(&now).is_near();
            let nth = settings.iter().position(among).unwrap_or(settings.len());
            if *step.scene == *scene {
                found = Some(nth);
            }
            match settings.get_mut(nth) {
                Some(known) => *known = known.with(&now),
                None => settings.push(now),
            }
        }
        found.map_or(own, |nth| settings[nth].frame)
    }
}

impl Setting {
    fn of(scene: &Scene) -> Option<Self> {
        let document = scene.document();
        Some(Self {
            bounds: document.bounds(),
            frame: document.frame(),
            region: size(document.region()?),
        })
    }

    /// A scene that reaches the step's goal lies within what is shown.
    fn of_step(step: &LessonStep) -> Option<Self> {
        let own = Self::of(&step.scene)?;
        let goal = step.goal.as_ref();
        let reached = goal.and_then(|goal| Self::of(&goal.reached));
        Some(match reached {
            Some(reached) => own.with(&reached),
            None => own,
        })
    }

    fn with(&self, other: &Self) -> Self {
        Self {
            bounds: union(self.bounds, other.bounds),
            frame: union(self.frame, other.frame),
            region: [0, 1].map(|i| self.region[i].min(other.region[i])),
        }
    }

    fn is_near(&self) -> bool {
        (0..2).all(|i| size(self.bounds)[i] <= MOST_REGIONS * self.region[i])
    }
}

fn size([min, max]: Rect) -> [f64; 2] {
    [0, 1].map(|i| max[i] - min[i])
}

fn union(a: Rect, b: Rect) -> Rect {
    let of = |pick: fn(f64, f64) -> f64, nth: usize| [0, 1].map(|i| pick(a[nth][i], b[nth][i]));
    [of(f64::min, 0), of(f64::max, 1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::Course;

    #[test]
    fn scenes_near_one_another_are_seen_together_and_a_large_one_by_itself() {
        let course = Course::embedded();
        for lesson in &course.lessons {
            for step in &lesson.steps {
                let (own, now) = (step.scene.document().frame(), lesson.bounds_of(&step.scene));
                assert_eq!(union(own, now), now, "{}: nothing is cut", lesson.id);
                let Some(alone) = Setting::of_step(step) else {
                    assert_eq!(own, now, "{}: in space eyes are found", lesson.id);
                    continue;
                };
                let is_shared = lesson
                    .steps
                    .iter()
                    .any(|it| it.id != step.id && it.scene == step.scene);
                if !alone.is_near() && !is_shared {
                    assert_eq!(alone.frame, now, "{}: {}", lesson.id, step.id);
                }
            }
        }
    }
}
