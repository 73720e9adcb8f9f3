use clipscope::{
    lesson::Course,
    text::{Catalog, Lang},
};
fn main() {
    let course = Course::embedded();
    for lesson in &course.lessons {
        for (i, step) in lesson.steps.iter().enumerate() {
            let runs = step.scene.document().record();
            let Some(p) = step.position() else { continue };
            let has_answer = lesson.step_text(i, Lang::En).is_some_and(|t| {
                t.body
                    .iter()
                    .any(|b| matches!(b, clipscope::lesson::Block::Answer(_)))
            });
            let d = runs[0].decision_by(p);
            match d {
                Some((d, choice)) => {
                    let said = choice.said(Catalog::of(Lang::En));
                    println!(
                        "{}\t{}\tp{}\td{}\tn{}\truns{}\t{}\tans{}\tcode{:?}\tlinks{}\t{}\t{}\t{}",
                        lesson.id,
                        step.id,
                        p,
                        d,
                        said.len(),
                        runs.len(),
                        choice.question,
                        has_answer as u8,
                        step.code,
                        choice.links.iter().flatten().count(),
                        choice.right,
                        said[choice.right],
                        said.join(" | ")
                    );
                }
                None => println!(
                    "{}\t{}\tp{}\t-\t{}\tans{}",
                    lesson.id,
                    step.id,
                    p,
                    runs.len(),
                    has_answer as u8
                ),
            }
        }
    }
}
