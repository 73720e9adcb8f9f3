//! Every view of every figure of the course has room, and says all it has to say.

mod labels;

use egui::Rect;

use crate::{
    export::jobs,
    figure::{Body, Lens, Seer, judged},
    lesson::Course,
    paint::{Around, Look, Viewport},
    text::Lang,
    widgets::{covered, picture_viewport, rect_of, under_title},
};

use super::{
    page::{Drawn, plane_marks},
    *,
};

/// The figures of the course, in pictures that are quickly drawn.
const fn small(theme: ThemeKind, lang: Lang) -> Options {
    Options {
        size_px: [640, 360],
        theme,
        lang,
        steps: Steps::Figures,
        asks: false,
    }
}

/// The page is never smaller than at 16 : 9, whatever the size: a higher or wider one has room for more. Of methods side by
/// side, and where text is large, lists and tables go before a drawing shrinks; a drawing never goes.
#[test]
fn no_figure_of_the_course_loses_a_view() {
    let course = Course::embedded();
    let jobs = jobs(&course.lessons, Steps::Figures);
    // The dark theme's text is as large as the light one's. Each language once: a newcomer waits for this test.
    for (theme, lang) in [
        (ThemeKind::Light, Lang::En),
        (ThemeKind::Light, Lang::Es),
        (ThemeKind::Projector, Lang::PtBr),
        (ThemeKind::Projector, Lang::ZhCn),
    ] {
        let mut studio = Studio::new(theme);
        let options = small(theme, lang);
        let faults = jobs.iter().filter_map(|job| {
            let picture = job.picture(options);
            let (_, lost) = studio.drawn(&picture);
            let needs = &studio.last.as_ref()?.recorded(picture.scene).needs;
            let drawing = needs.first()?.first()?.id;
            let is_beside = needs.len() > 1 || picture.before.is_some();
            let may_go = is_beside || theme == ThemeKind::Projector;
            let is_lost = |id: &&ViewId| !may_go || **id == drawing;
            let gone: Vec<_> = lost.iter().filter(is_lost).collect();
            (!gone.is_empty()).then(|| format!("{}: {gone:?}", job.path))
        });
        let faults: Vec<String> = faults.collect();
        assert!(faults.is_empty(), "{theme}, {lang:?}: {faults:#?}");
    }
}

#[test]
fn every_figure_is_said_in_words_and_what_it_answers_is_asked() {
    let course = Course::embedded();
    let jobs = jobs(&course.lessons, Steps::Figures);
    let mut studio = Studio::new(ThemeKind::Light);
    let (mut n_asked, n_figures) = (0, jobs.len());
    for job in jobs {
        for lang in Lang::ALL {
            let options = |asks: bool| Options {
                asks,
                ..small(ThemeKind::Light, lang)
            };
            let [told, asked] = [false, true].map(|asks| {
                let said = studio.alternative(&job.picture(options(asks)));
                assert!(!said.contains('⟦'), "{}: {said}", job.path);
                said
            });
            let title = job.title(options(false)).expect("each step has a title");
            assert!(
                told.starts_with(title) && told.lines().count() > 1,
                "{told}"
            );
            assert_ne!(told, asked, "{}", job.path);
            let question = Catalog::of(lang)
                .message(&Message::new("what-comes-next").with("options", String::new()));
            n_asked += usize::from(asked.contains(question.trim()));
        }
    }
    // Some show the beginning, before anything is asked.
    assert!(
        n_asked > 3 * n_figures,
        "{n_asked} of {n_figures} in each language"
    );
}

const RULES: [&str; 6] = ["lengths", "angles", "points", "areas", "inset", "frame"];
/// Rounding of a frame that is found in rounds, and of places in points.
const LEAST_FAULT: f64 = 1e-6;

/// Where everything of a figure stands, and what `look` finds in it.
fn laid_out(
    studio: &mut Studio,
    picture: &Picture<'_>,
    mut look_at: impl FnMut(&Ui, Look<'_>, &[Drawn<'_>], &Layout),
) {
    let Studio { table, last } = studio;
    let album = album(last, picture);
    let page = Page::of(album, picture, shown(album, picture));
    let look = page.look;
    table.draw(Vec2::from(PAGE_PTS), 1.0, |ui| {
        let layout = page.show(ui);
        let drawn: Vec<_> = page.columns().collect();
        look_at(ui, look, &drawn, &layout);
    });
}

/// By how much a figure's drawings of space break each rule: a place that is covered or cut counts 1.
fn faults(studio: &mut Studio, picture: &Picture<'_>) -> [f64; 6] {
    let mut faults = [0.0; 6];
    laid_out(studio, picture, |ui, look, columns, layout| {
        faults = [0.0; 6];
        for ((_, _, column), places) in columns.iter().zip(&layout.columns) {
            let id = column.frame.views[0].id;
            let Some((space, slot)) = column.frame.space().zip(places.slot(id)) else {
                continue;
            };
            let Seer::Eye(eye) = space.seer else { continue };
            let rect = under_title(ui, rect_of(slot), look, space);
            let seen = picture_viewport(rect, &Lens::Eye(eye));
            let judged = judged(space, eye, seen.scale);
            let n_outside = |places: &[[f64; 2]], is_fine: &dyn Fn(egui::Pos2) -> bool| {
                let places = places.iter().map(|&at| seen.to_screen(at));
                places.filter(|&at| !is_fine(at)).count() as f64
            };
            let insets: Vec<Rect> = places.over(id).map(rect_of).collect();
            let is_bare = |at| !insets.iter().any(|inset| inset.contains(at));
            let more = [
                n_outside(&judged.marked, &is_bare),
                n_outside(&judged.framed, &|at| rect.contains(at)),
            ];
            let all = judged.shortfalls.into_iter().chain(more);
            for (fault, more) in faults.iter_mut().zip(all) {
                *fault += more;
            }
        }
    });
    faults
}

#[test]
fn every_eye_of_the_course_sees_what_its_step_measures() {
    let course = Course::embedded();
    let mut studio = Studio::new(ThemeKind::Light);
    let options = small(ThemeKind::Light, Lang::En);
    let mut all = Vec::new();
    for job in jobs(&course.lessons, Steps::Figures) {
        let faults = faults(&mut studio, &job.picture(options));
        let broken = RULES.iter().zip(faults).filter(|(_, by)| *by > LEAST_FAULT);
        let broken: Vec<_> = broken.collect();
        if !broken.is_empty() {
            all.push(format!("{}: {broken:?}", job.path));
        }
    }
    assert!(all.is_empty(), "{all:#?}");
}

/// Of a lesson's figures of the plane that show one place by one method, in the same views.
/// Are several columns in it?
fn is_beside(job: &jobs::Job<'_>) -> bool {
    let n_methods = job.source.scene().document().methods().len();
    n_methods > 1
        || job
            .picture(small(ThemeKind::Light, Lang::En))
            .before
            .is_some()
}

#[test]
fn from_figure_to_figure_of_a_lesson_nothing_moves() {
    let course = Course::embedded();
    let mut studio = Studio::new(ThemeKind::Light);
    let options = small(ThemeKind::Light, Lang::En);
    let mut n_alike = 0;
    for lesson in &course.lessons {
        let mut seen: Vec<(_, Layout)> = Vec::new();
        for job in jobs([lesson], Steps::Figures) {
            let scene = job.source.scene().document();
            if scene.region().is_none() || is_beside(&job) {
                continue;
            }
            laid_out(&mut studio, &job.picture(options), |_, _, columns, now| {
                let views = columns.iter().flat_map(|(_, _, it)| &it.frame.views);
                let ids: Vec<ViewId> = views.map(|view| view.id).collect();
                let kind = (ids, lesson.bounds_of(job.source.scene()));
                match seen.iter().find(|(known, _)| *known == kind) {
                    Some((_, known)) => {
                        assert_eq!(now, known, "{}", job.path);
                        n_alike += 1;
                    }
                    None => seen.push((kind, now.clone())),
                }
            });
        }
    }
    assert!(n_alike > 40, "{n_alike}");
}
