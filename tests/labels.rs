//! Every label of every lesson figure against every other label, and against every stroke and marker. The placer is
//! asked, not the pixels.

use clipscope::{
    figure::{Mark, Shape},
    labs::Scene,
    lesson::Course,
    paint::{Around, Headless, Look, Obstacle, Placed, ThemeKind, Viewport},
    text::{Catalog, Lang},
};
use egui::{Pos2, Rect, Ui, Vec2, vec2};

/// A page, and the stage of a window of 1280 by 720.
const STAGES: [Vec2; 2] = [vec2(960.0, 540.0), vec2(768.0, 460.0)];
/// The drawing of a comparison, and one beside tall lists: labels have hardly room.
const SMALL: [Vec2; 3] = [vec2(420.0, 300.0), vec2(300.0, 320.0), vec2(200.0, 240.0)];
/// Of the labels of the course so many, in percent, may have no place that is free, and stand in a halo.
const MOST_HALOS_PERCENT: f64 = 2.0;

/// And so many may stand nearer to another mark's marker than to their own.
const MOST_AMBIGUOUS_PERCENT: f64 = 1.0;

/// The marks of each of a scene's drawings at a step.
fn drawings(scene: &Scene, step: usize) -> Vec<Vec<Mark>> {
    let runs = scene.document().record();
    let drawing = |i: usize| {
        let step = match i {
            0 => step,
            _ => runs[i].beside(&*runs[0], step),
        };
        let run = &runs[i];
        let mut marks = scene.document().backdrop(i, step >= run.n_steps());
        marks.extend_from_slice(run.frame(step.min(run.n_steps())).marks());
        marks
    };
    (0..runs.len()).map(drawing).collect()
}

#[test]
fn no_label_covers_another_or_stands_on_a_stroke_without_a_halo() {
    let course = Course::embedded();
    let (mut n_labels, mut faults) = (0, Vec::new());
    let (mut halos, mut ambiguous) = (Vec::new(), Vec::new());
    for theme in [ThemeKind::Light, ThemeKind::Projector] {
        let mut table = Headless::new(theme);
        for lesson in &course.lessons {
            for step in &lesson.steps {
                let Some(figure) = &step.figure else { continue };
                for marks in drawings(&step.scene, step.position().expect("its moment comes")) {
                    for size in STAGES {
                        let (placed, obstacles) = place(
                            &mut table,
                            size,
                            step.scene.document().bounds(),
                            &marks,
                            &[],
                        );
                        let whole = Rect::from_min_size(Pos2::ZERO, size);
                        let place = format!("{figure}, {theme}, {} wide", size.x);
                        n_labels += placed.len();
                        let with_halo = placed.iter().filter(|label| label.has_halo);
                        halos.extend(with_halo.map(|l| format!("{place}: {}", l.text)));
                        let of_another = placed.iter().filter(|label| label.is_ambiguous);
                        ambiguous.extend(of_another.map(|l| format!("{place}: {}", l.text)));
                        let wrong = faults_of(&placed, &obstacles, whole);
                        faults.extend(wrong.into_iter().map(|fault| format!("{place}: {fault}")));
                    }
                }
            }
        }
    }
    println!("{n_labels} labels, {} with a halo", halos.len());
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
    let n_labels = f64::from(u32::try_from(n_labels).unwrap_or(1));
    for (found, most) in [
        (&halos, MOST_HALOS_PERCENT),
        (&ambiguous, MOST_AMBIGUOUS_PERCENT),
    ] {
        let percent = 100.0 * found.len() as f64 / n_labels;
        assert!(percent <= most, "{percent:.1} %: {found:#?}");
    }
}

fn place(
    table: &mut Headless,
    size: Vec2,
    bounds: [[f64; 2]; 2],
    marks: &[Mark],
    before: &[Placed],
) -> (Vec<Placed>, Vec<Obstacle>) {
    let theme = table.theme();
    let viewport = Viewport::fit(Rect::from_min_size(Pos2::ZERO, size), bounds);
    let mut found = (Vec::new(), Vec::new());
    let arrange = |ui: &mut Ui| {
        let catalog = Catalog::of(Lang::En);
        let around = Around {
            before,
            ..Around::default()
        };
        found = Look::new(theme, catalog).arrange(ui.painter(), &viewport, marks, around);
    };
    // As shapes: nobody looks at the pixels.
    table.write(size, 1.0, arrange, |_| {});
    found
}

fn faults_of(placed: &[Placed], obstacles: &[Obstacle], stage: Rect) -> Vec<String> {
    let mut faults = Vec::new();
    for (i, label) in placed.iter().enumerate() {
        let Placed {
            text,
            rect,
            has_halo,
            ..
        } = label;
        for other in &placed[..i] {
            if rect.intersects(other.rect) {
                faults.push(format!("`{text}` over `{}`", other.text));
            }
            let leaders = [(label.leader, other.rect), (other.leader, *rect)];
            let is_struck = |(leader, rect): (Option<[Pos2; 2]>, Rect)| {
                leader.is_some_and(|ends| Obstacle::Stroke(ends, 0.5).covers(rect))
            };
            if leaders.into_iter().any(is_struck) {
                faults.push(format!("a leader between `{text}` and `{}`", other.text));
            }
        }
        if !has_halo && obstacles.iter().any(|obstacle| obstacle.covers(*rect)) {
            faults.push(format!("`{text}` is crossed, and has no halo"));
        }
        if !stage.contains_rect(*rect) {
            faults.push(format!("`{text}` is cut off"));
        }
    }
    faults
}

/// A code beside its region, or an inequality on the other side of its line, would be a false statement.
#[test]
fn no_label_of_a_region_or_a_half_plane_stands_elsewhere() {
    let course = Course::embedded();
    let (mut n_regions, mut n_sides, mut faults) = (0, 0, Vec::new());
    for theme in [ThemeKind::Light, ThemeKind::Projector] {
        let mut table = Headless::new(theme);
        for step in course.lessons.iter().flat_map(|lesson| &lesson.steps) {
            let bounds = step.scene.document().bounds();
            for marks in drawings(&step.scene, step.position().expect("its moment comes")) {
                for size in STAGES.into_iter().chain(SMALL) {
                    let (placed, _) = place(&mut table, size, bounds, &marks, &[]);
                    let viewport = Viewport::fit(Rect::from_min_size(Pos2::ZERO, size), bounds);
                    let place = format!("{}, {theme}, {} wide", step.id, size.x);
                    for mark in &marks {
                        let Some(label) = &mark.label else { continue };
                        let text = Catalog::of(Lang::En).value(&label.text);
                        let mut same = placed.iter().filter(|placed| placed.text == text);
                        let is_right = |placed: &Placed| match mark.shape {
                            Shape::Region(corners) => lies_in(placed.rect, &viewport, corners),
                            Shape::HalfPlane([a, b]) => {
                                let at = viewport.to_world(placed.rect.center());
                                // Where nothing else is said, the side that is not shaded, to the right.
                                let [x, y] = label.toward.unwrap_or([b[1] - a[1], a[0] - b[0]]);
                                (at[0] - a[0]) * x + (at[1] - a[1]) * y > 0.0
                            }
                            _ => true,
                        };
                        n_regions += usize::from(matches!(mark.shape, Shape::Region(_)));
                        n_sides += usize::from(matches!(mark.shape, Shape::HalfPlane(_)));
                        if !same.all(is_right) {
                            faults.push(format!("{place}: {text}"));
                        }
                    }
                }
            }
        }
    }
    assert!(n_regions > 1_000 && n_sides > 100, "{n_regions}, {n_sides}");
    assert!(faults.is_empty(), "{} faults: {faults:#?}", faults.len());
}

/// Of the steps of a run so many are looked at.
const MOST_STEPS: usize = 40;
/// A label that moves by more than this, in points, hops.
const HOP: f32 = 6.0;
/// So many may hop from one step to the next of those that stand at both, in percent.
const MOST_HOPS_PERCENT: f64 = 2.0;

/// In a window, where it is known where they stood; two of the same text are not told apart here and are left out.
#[test]
fn labels_do_not_hop_between_steps() {
    let course = Course::embedded();
    let (mut n_both, mut hops) = (0, Vec::new());
    let mut table = Headless::new(ThemeKind::Light);
    for lesson in &course.lessons {
        for step in &lesson.steps {
            let document = step.scene.document();
            let runs = document.record();
            let mut before: Vec<Placed> = Vec::new();
            for i in 0..=runs[0].n_steps().min(MOST_STEPS) {
                let mut marks = document.backdrop(0, i == runs[0].n_steps());
                marks.extend_from_slice(runs[0].frame(i).marks());
                let (placed, _) = place(&mut table, STAGES[1], document.bounds(), &marks, &before);
                let only = |labels: &[Placed], text: &str| {
                    let mut same = labels.iter().filter(|label| label.text == text);
                    same.next()
                        .map(|label| label.rect)
                        .filter(|_| same.next().is_none())
                };
                for Placed { text, .. } in &before {
                    let Some((from, to)) = only(&before, text).zip(only(&placed, text)) else {
                        continue;
                    };
                    n_both += 1;
                    let by = from.center().distance(to.center());
                    if by > HOP {
                        hops.push(format!(
                            "{}, {}, step {i}: {text} by {by:.0}",
                            lesson.id, step.id
                        ));
                    }
                }
                before = placed;
            }
        }
    }
    let percent = 100.0 * hops.len() as f64 / f64::from(n_both);
    println!("{} of {n_both} hop: {percent:.1} %", hops.len());
    assert!(percent <= MOST_HOPS_PERCENT, "{percent:.1} %: {hops:#?}");
}

fn lies_in(rect: Rect, viewport: &Viewport, [min, max]: [[f64; 2]; 2]) -> bool {
    let half_a_pixel = 0.6 / viewport.scale;
    [rect.min, rect.max].into_iter().all(|corner| {
        let at = viewport.to_world(corner);
        (0..2).all(|i| min[i] - half_a_pixel <= at[i] && at[i] <= max[i] + half_a_pixel)
    })
}
