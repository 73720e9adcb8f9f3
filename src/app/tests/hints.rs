//! What helps towards a goal, and a hunt whose scene is made smaller.

use super::*;

#[test]
fn each_part_of_a_goal_has_its_own_hint() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("06-touching-and-parallel", "a-point");
    bench.command(Command::Hint);
    let decides = |bench: &Bench| {
        let hint = &bench.app.goals.help.hint;
        let said = hint
            .decides
            .as_ref()
            .map(|it| bench.app.look().catalog.message(it));
        said.expect("something decides")
    };
    assert!(decides(&bench).contains("left"), "{}", decides(&bench));
    let mut scene = bench.solution();
    let ends: Vec<_> = scene.document().handles().into_iter().take(2).collect();
    let [x, y, z] = scene.document().position(ends[1]).expect("an end");
    let _ = scene.document_mut().drag(ends[1], [x.min(0.5), y, z]);
    bench.edit(Edit::Replace(scene));
    bench.frame(0.1, Vec::new());
    assert!(
        bench.app.met()[0] && !bench.app.met()[2],
        "{:?}",
        bench.app.met()
    );
    assert!(
        !decides(&bench).contains("left edge"),
        "{}",
        decides(&bench)
    );
}

#[test]
fn a_hunts_hint_tells_what_a_solution_moves_and_where_the_programs_part() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("37-far-to-near", "hunt-keys");
    bench.command(Command::Hint);
    let said = |bench: &Bench| {
        let said = bench.app.goals.help.hint.said(bench.app.look().catalog);
        (said[0].clone(), said[1..].join(" "))
    };
    let (first, second) = said(&bench);
    assert!(first.starts_with("One solution moves only: "), "{first}");
    assert!(
        second.starts_with("In one solution the two programs part here: "),
        "{second}"
    );
    assert!(second.contains(" has the key "), "{second}");
}

#[test]
fn of_several_parts_the_open_one_is_named() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("03-outcodes", "all-ones");
    bench.command(Command::Hint);
    let said = bench.app.goals.help.hint.said(bench.app.look().catalog);
    assert_eq!(said[0], "“A piece of the segment is visible”: not yet.");
}

#[test]
fn a_scene_is_made_smaller_once_the_hunt_is_over_and_it_is_said_what_became_smaller() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("37-far-to-near", "hunt-keys");
    let first = bench.app.scene().clone();
    bench.command(Command::Smaller);
    assert_eq!(bench.app.scene(), &first);
    let told = |bench: &Bench| bench.app.notices.last().map(|it| it.text.clone());
    assert!(told(&bench).is_some_and(|text| text.starts_with("First change the scene")));
    assert_eq!(bench.app.playback.steps().len(), 2);
    assert!(
        !bars::step_told(&bench.app, [9, 9]).contains("of"),
        "a total tells"
    );
    bench.edit(Edit::Replace(bench.solution()));
    bench.frame(0.1, Vec::new());
    assert!(bars::step_told(&bench.app, [9, 9]).contains("of"));
    let eyes = format!("{:?}", bench.app.playback.eyes);
    bench.command(Command::Smaller);
    while bench.app.is_making_smaller() {
        bench.frame(0.01, Vec::new());
    }
    assert_eq!(
        format!("{:?}", bench.app.playback.eyes),
        eyes,
        "it is seen as before"
    );
    let said = told(&bench).expect("it is said");
    assert!(
        said.contains("same difference") || said.contains("difference is the same"),
        "{said}"
    );
}

#[test]
fn a_smaller_scene_leaves_what_is_locked() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("06-touching-and-parallel", "hunt-parallel");
    let step = bench.app.bookmark.step().expect("it is open").clone();
    let window = |bench: &Bench| {
        let document = bench.app.scene().document();
        let handles = document.handles().into_iter();
        let locked = handles.filter(|handle| Lock::any_holds(&step.locks, *handle));
        locked.map(|it| document.position(it)).collect::<Vec<_>>()
    };
    let before = window(&bench);
    assert!(!before.is_empty());
    bench.edit(Edit::Replace(bench.solution()));
    bench.command(Command::Smaller);
    let begun = std::time::Instant::now();
    while bench.app.is_making_smaller() {
        bench.frame(0.01, Vec::new());
        assert!(begun.elapsed().as_secs() < 120);
    }
    assert!(bench.app.is_reached());
    assert_eq!(window(&bench), before);
}
