//! Labels in the slots that drawings really get: on a page, beside lists and in halves of comparisons.

use crate::{
    paint::{Obstacle, Placed},
    widgets::{projected, title_ground},
};

use super::*;

/// Of all labels so many, in percent, may have no place that is free, and stand in a halo.
const MOST_HALOS_PERCENT: f64 = 2.6;
/// And so many may stand nearer to another mark's marker than to their own.
const MOST_AMBIGUOUS_PERCENT: f64 = 0.3;

#[test]
fn in_the_slots_of_the_course_labels_belong_to_their_points() {
    for (theme, lang) in [
        (ThemeKind::Light, Lang::En),
        (ThemeKind::Projector, Lang::En),
        (ThemeKind::Light, Lang::ZhCn),
    ] {
        let course = Course::embedded();
        let mut studio = Studio::new(theme);
        let options = small(theme, lang);
        let mut all: Vec<(String, Placed)> = Vec::new();
        for job in jobs(&course.lessons, Steps::Figures) {
            for labels in placed(&mut studio, &job.picture(options)) {
                for (i, label) in labels.iter().enumerate() {
                    for other in &labels[..i] {
                        let is_over = label.rect.intersects(other.rect);
                        let (path, [a, b]) = (&job.path, [&label.text, &other.text]);
                        assert!(!is_over, "{path}, {theme}, {lang:?}: `{a}` over `{b}`");
                    }
                }
                all.extend(labels.into_iter().map(|label| (job.path.clone(), label)));
            }
        }
        for (what, most, is_so) in [
            (
                "halos",
                MOST_HALOS_PERCENT,
                (|it| it.has_halo) as fn(&Placed) -> bool,
            ),
            ("of another", MOST_AMBIGUOUS_PERCENT, |it| it.is_ambiguous),
        ] {
            let found = all.iter().filter(|(_, label)| is_so(label));
            let found: Vec<_> = found.map(|(path, label)| (path, &label.text)).collect();
            let percent = 100.0 * found.len() as f64 / all.len() as f64;
            println!("{theme}, {lang:?}: {percent:.2} % {what} of {}", all.len());
            assert!(percent <= most, "{percent:.2} % {what}: {found:#?}");
        }
    }
}

/// On a face a name is meant to stand.
const fn is_line(obstacle: &Obstacle) -> bool {
    matches!(obstacle, Obstacle::Stroke(..) | Obstacle::Disc(..))
}

/// The labels of each of a figure's drawings.
fn placed(studio: &mut Studio, picture: &Picture<'_>) -> Vec<Vec<Placed>> {
    let mut all = Vec::new();
    laid_out(studio, picture, |ui, look, columns, layout| {
        all = Vec::new();
        for (i, (&drawn, places)) in columns.iter().zip(&layout.columns).enumerate() {
            let (half, _, column) = drawn;
            let drawing = &column.frame.views[0];
            let Some(slot) = places.slot(drawing.id) else {
                continue;
            };
            let rect = rect_of(slot);
            let mut covered = covered(places, drawing.id, look);
            let (viewport, marks) = if let Body::Space(space) = &drawing.body {
                let lens = Lens::from(space.seer);
                let seen = picture_viewport(under_title(ui, rect, look, space), &lens);
                covered.extend(title_ground(ui, look, rect, space));
                let marks = projected(ui.ctx(), ui.scope_id().with(i), space, &lens);
                (seen, marks.to_vec())
            } else {
                let seen = Viewport::fit(rect, half.recorded.bounds);
                (seen, plane_marks(drawn))
            };
            let around = Around {
                covered: &covered,
                ..Around::default()
            };
            let (mut labels, obstacles) = look.arrange(ui.painter(), &viewport, &marks, around);
            for label in &mut labels {
                label.has_halo = obstacles
                    .iter()
                    .any(|it| is_line(it) && it.covers(label.rect));
            }
            all.push(labels);
        }
    });
    all
}
