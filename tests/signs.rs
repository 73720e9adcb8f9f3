//! One sign, one meaning: over the runs of the course.

use clipscope::{
    figure::{Body, ItemMarker, Raster, RasterShape, Role, Tick, View},
    lesson::{Course, LessonStep},
    text::Value,
};

fn steps() -> Vec<LessonStep> {
    let lessons = Course::embedded().lessons;
    lessons
        .into_iter()
        .flat_map(|lesson| lesson.steps)
        .collect()
}

/// Every view of some forty moments of each run of the course that has rasters or lists.
fn views(mut look: impl FnMut(&str, usize, &View)) {
    for step in steps() {
        let document = step.scene.document();
        for (run, method) in document.record().into_iter().zip(document.methods()) {
            let every = (run.n_steps() / 40).max(1);
            for k in (0..=run.n_steps()).step_by(every).chain([run.n_steps()]) {
                for view in &run.frame(k).views {
                    look(method.id, k, view);
                }
            }
        }
    }
}

/// Of wrong pixels, or of one that is not taken.
fn tells_of_wrong_pixels(raster: &Raster) -> bool {
    let keys = ["raster-wrong", "raster-lens"];
    matches!(&raster.title, Value::Message(message) if keys.contains(&message.key))
}

#[test]
fn a_cross_says_not_so() {
    let (mut n_rings, mut n_halves, mut n_crosses) = (0, 0, 0);
    views(|method, k, view| match &view.body {
        Body::Raster(raster) => {
            for mark in &raster.over {
                match mark.shape {
                    RasterShape::Cross(_) => {
                        n_crosses += 1;
                        assert!(
                            tells_of_wrong_pixels(raster),
                            "{method}, step {k}: a cross on a pixel that is not wrong"
                        );
                    }
                    // A pixel that passes.
                    RasterShape::Ring(_) => {
                        n_rings += 1;
                        assert_eq!(mark.role, Role::Accent, "{method}, step {k}");
                    }
                    RasterShape::Line(_)
                    | RasterShape::Bar(_)
                    | RasterShape::Dot(_)
                    | RasterShape::Hatch(_) => {}
                }
            }
        }
        Body::Lists(lists) => {
            for row in lists.lists.iter().flat_map(|list| &list.entries) {
                n_halves += usize::from(row.marker == Some(ItemMarker::HalfDot));
                // An intersection that is no crossing.
                let is_not = row.marker == Some(ItemMarker::Cross);
                assert!(!is_not || method == "weiler-atherton", "{method}, step {k}");
            }
        }
        _ => {}
    });
    assert!(n_rings > 0 && n_halves > 0 && n_crosses > 0);
}

/// The numbers in pixels and their tones, by number.
fn numbered(raster: &Raster) -> Vec<(usize, f64)> {
    let pixels = raster.pixels.iter().filter(|pixel| pixel.role.is_some());
    let numbers = pixels.filter_map(|pixel| match pixel.value {
        Some(Value::Count(n)) => Some((n, pixel.shade)),
        _ => None,
    });
    let mut numbers: Vec<_> = numbers.collect();
    numbers.sort_by_key(|&(n, _)| n);
    numbers
}

#[test]
fn tones_of_a_raster_of_depths_are_of_depths() {
    let mut n_rasters = 0;
    views(|method, k, view| {
        let Body::Raster(raster) = &view.body else {
            return;
        };
        let numbers = numbered(raster);
        let [Some(first), Some(last)] = [numbers.first(), numbers.last()] else {
            return;
        };
        if method.contains("depth") && last.0 > first.0 + 1 {
            n_rasters += 1;
            let turn = (last.1 - first.1).signum();
            for (i, &(n, shade)) in numbers.iter().enumerate() {
                // Numbers are rounded, tones are not.
                let farther = numbers[i..].iter().find(|other| other.0 > n + 1);
                let is_ramp = farther.is_none_or(|other| turn * (other.1 - shade) >= 0.0);
                assert!(is_ramp, "{method}, step {k}: {n} and {farther:?}");
            }
        }
    });
    assert!(n_rasters > 100, "{n_rasters}");
}

fn figure(name: &str) -> LessonStep {
    let wanted = |step: &LessonStep| step.figure.as_deref() == Some(name);
    steps().into_iter().find(wanted).expect("a figure")
}

/// The views of a figure's first run.
fn views_of(name: &str) -> Vec<View> {
    let step = figure(name);
    let runs = step.scene.document().record();
    runs[0]
        .frame(step.position().expect("its moment comes"))
        .views
}

#[test]
fn a_count_map_holds_every_fragment() {
    let counts = |name| {
        let views = views_of(name);
        let rasters = views.iter().filter_map(|view| match &view.body {
            Body::Raster(raster) => Some(raster),
            _ => None,
        });
        let number = |pixel: &clipscope::figure::Pixel| match pixel.value {
            Some(Value::Count(n)) => Some((n, pixel.role)),
            _ => None,
        };
        let counts = rasters.map(|raster| {
            let numbers: Vec<_> = raster.pixels.iter().filter_map(number).collect();
            assert!(
                numbers
                    .iter()
                    .all(|&(n, role)| (role == Some(Role::Accent)) == (n == 1))
            );
            let all: usize = numbers.iter().map(|(n, _)| n).sum();
            [numbers.len(), all - numbers.len()]
        });
        counts.collect::<Vec<_>>()
    };
    // As they were counted for the drafts of these figures: pixels that are seen, fragments in vain.
    assert_eq!(counts("cull-overdraw"), [[65, 89], [65, 12]]);
    assert_eq!(counts("cull-only-fronts"), [[55, 55], [55, 0]]);
    assert_eq!(counts("cull-open"), [[85, 44], [44, 0]]);
}

#[test]
fn the_inset_leaves_out_what_the_method_leaves_out() {
    let views = views_of("cull-open");
    let faces = |id| {
        let view = views.iter().find(|view| view.id.0 == id);
        let Some(Body::Space(space)) = view.map(|view| &view.body) else {
            panic!("no {id}");
        };
        let corners = space.facets.iter().filter(|facet| facet.link.is_some());
        corners.count()
    };
    assert!(faces("observer") >= 10, "all of the box");
    // Of two walls that look at the camera two triangles each: the inner sides are backs, and the floor is.
    assert_eq!(faces("camera"), 4);
}

#[test]
fn blue_numbers_of_the_box_are_of_corners_inside_and_green_frames_of_what_is_accepted() {
    let mut n_distances = 0;
    views(|method, k, view| match &view.body {
        Body::Table(table) if method == "box-cull" => {
            for cell in table.rows.iter().flat_map(|row| &row.cells) {
                if let (Role::Accent, Some(Value::Number(d))) = (cell.role, &cell.value) {
                    n_distances += 1;
                    assert!(*d >= 0.0, "step {k}: {d} is outside");
                }
            }
        }
        // Nobody accepts what is painted or drawn.
        Body::Lists(lists) if ["painter", "occlusion"].contains(&method) => {
            let mut rows = lists.lists.iter().flat_map(|list| &list.entries);
            assert!(
                rows.all(|row| row.role != Role::Accepted),
                "{method}, step {k}"
            );
        }
        _ => {}
    });
    assert!(n_distances > 0);
}

#[test]
fn no_mistake_ends_with_a_check() {
    let runs = steps()
        .into_iter()
        .flat_map(|step| step.scene.document().record());
    let mistakes: Vec<_> = runs.filter(|run| run.differs_at().is_some()).collect();
    assert!(mistakes.len() > 5, "{}", mistakes.len());
    for run in mistakes {
        assert_ne!(run.tick(run.n_steps()), Tick::Accept);
    }
}
