//! Why? What is clicked is told, and Enter goes to the step that decided it.

use super::*;

impl Bench {
    /// What the inspector says under "Why?".
    fn verdict(&mut self) -> Option<String> {
        let texts = self.texts();
        let title = texts.iter().position(|(text, _)| text == "Why?")?;
        texts.get(title + 1).map(|(text, _)| text.clone())
    }

    /// The area of a view on the stage.
    fn size_of(&self, view: &str) -> f32 {
        let mut places = self.app.stage.places.iter();
        let found = places.find(|(id, _)| id.0 == view);
        rect_of(found.expect("it is there").1).area()
    }

    fn click_in_space(&mut self, world: [f64; 3]) {
        let at = self.app.stage.on_screen(world).expect("it is in sight");
        self.tap(at);
        self.settle();
    }
}

#[test]
fn an_object_that_is_clicked_is_told_and_enter_goes_to_its_step() {
    let mut bench = Bench::lab("frustum");
    assert_eq!(bench.verdict(), None, "nothing was asked");
    bench.key(Key::Enter);
    assert_eq!(bench.app.position(), 0);
    bench.click_in_space([-6.5, 0.8, 0.5]);
    let said = bench.verdict().expect("it is told");
    assert!(said.starts_with("Object 5 is culled"), "{said}");
    bench.key(Key::Enter);
    let step = bench.app.position();
    let event = bench.app.playback.main().event_json(step);
    assert_eq!(event["event"], "sphere");
    assert_eq!(event["class"], "outside");
    bench.key(Key::Home);
    bench.click_on("Go to that step (Enter)");
    assert_eq!(bench.app.position(), step);
    bench.key(Key::Escape);
    assert_eq!(bench.verdict(), None, "nothing is asked any more");
}

#[test]
fn a_segment_or_a_part_that_is_clicked_is_told_by_the_method_on_stage() {
    let segment = [0.0, 0.25, 0.0];
    let corner = [-5.5, 0.5, 0.0];
    let edge = [1.5, 2.5, -1.5];
    for (lab, of_lab) in [
        (
            "lines",
            &[
                ("brute-force", segment, "", "accept"),
                ("cohen-sutherland", segment, "", "or"),
                ("liang-barsky", segment, "", "interval"),
                ("cyrus-beck", segment, "", "interval"),
                ("nicholl-lee-nicholl", segment, "", "sector"),
            ][..],
        ),
        (
            "frustum",
            &[
                ("intersection-polygon", corner, "vertex V₀", "first"),
                ("intersection-polygon", edge, "edge V₁V₂", "cross"),
                ("liang-barsky-3d", [3.0, 2.5, -4.0], "P₂", "row"),
            ],
        ),
    ] {
        let mut bench = Bench::lab(lab);
        for &(method, at, said, event) in of_lab {
            bench.edit(Edit::Method(method));
            bench.command(Command::FIRST);
            bench.command(Command::Ask(None));
            bench.click_in_space(at);
            let texts = bench.texts();
            let is_said = texts.iter().any(|(text, _)| text.contains(said));
            assert!(bench.verdict().is_some() && is_said, "{method}: {said}");
            bench.key(Key::Enter);
            assert_eq!(bench.event(), event, "{method}: {said}");
        }
    }
}

#[test]
fn a_vertex_that_is_clicked_is_selected_and_told() {
    let mut bench = Bench::lab("polygons");
    let handle = bench.document().handles()[0];
    let at = bench.document().position(handle);
    bench.click_in_space(at.expect("the first vertex"));
    assert_eq!(bench.app.stage.selected, Some(handle));
    assert!(bench.verdict().is_some());
    bench.key(Key::Enter);
    assert!(bench.app.position() > 0);
}

#[test]
fn enter_belongs_to_whoever_has_the_focus() {
    let mut bench = Bench::lab("frustum");
    bench.click_in_space([-6.5, 0.8, 0.5]);
    bench.focus(bench.app.stage.handle_ids[0]);
    bench.settle();
    bench.key(Key::Enter);
    assert!(bench.app.stage.typing.is_some(), "the handle's place");
    assert_eq!(bench.app.position(), 0);
}

fn middle_of(bench: &Bench, view: &str) -> Pos2 {
    let mut places = bench.app.stage.places.iter();
    let found = places.find(|(id, _)| id.0 == view);
    let (_, slot) = found.unwrap_or_else(|| panic!("no {view}"));
    rect_of(*slot).center()
}

#[test]
fn in_the_cameras_picture_its_place_is_told_in_no_pixels_that_nobody_sees() {
    let mut bench = Bench::lab("frustum");
    bench.press_at(middle_of(&bench, "camera"));
    let said = bench.verdict().expect("it is told");
    assert!(said.contains("Here face"), "{said}");
    assert!(!said.contains("ixel"), "{said}");
}

#[test]
fn to_ask_about_a_pixel_changes_nothing_and_from_the_answer_it_is_looked_at_alone() {
    let mut bench = Bench::lab("surfaces");
    let looked_at = |bench: &Bench| bench.space().raster.pixel;
    let all = bench.n_steps();
    let at = middle_of(&bench, "raster");
    bench.press_at(at);
    assert!(bench.verdict().is_some());
    assert!(!bench.app.history.can_undo(), "a question is no change");
    bench.press_at(at);
    assert_eq!(bench.verdict(), None, "the same click takes it back");
    bench.press_at(at);
    bench.key(Key::Escape);
    assert_eq!(bench.verdict(), None, "and so does Escape");
    bench.press_at(at);
    let press = |bench: &mut Bench, key: &str| {
        let button = Catalog::of(Lang::En).term(key);
        let texts = bench.texts();
        let found = texts.iter().find(|(text, _)| *text == button);
        let (_, rect) = found.unwrap_or_else(|| panic!("no {button}: {texts:?}"));
        bench.press_at(rect.center());
    };
    press(&mut bench, "pixel-alone");
    assert!(looked_at(&bench).is_some());
    assert!(bench.n_steps() < all, "its story alone");
    press(&mut bench, "pixel-all");
    assert_eq!((looked_at(&bench), bench.n_steps()), (None, all));
}

/// Two surfaces that eight bits cannot tell apart: the picture shows the one behind.
#[test]
fn why_a_pixel_shows_it_is_told_of_the_run_on_stage() {
    let mut bench = Bench::course(SIZE);
    let lesson = bench.app.bookmark.course.lessons.iter();
    let step = lesson.enumerate().find_map(|(i, lesson)| {
        let is_it = |step: &LessonStep| step.figure.as_deref() == Some("depth-eight-bits");
        Some([i, lesson.steps.iter().position(is_it)?])
    });
    bench.command(Command::Open(step.expect("there is such a step")));
    let place = Link::nth(crate::figure::Raster::LINK, 5 * 16 + 8);
    let told = |bench: &mut Bench, seek: usize| {
        bench.command(Command::Seek(seek));
        bench.command(Command::Ask(None));
        bench.command(Command::Ask(Some((place, 0))));
        bench.verdict().expect("it is told")
    };
    assert!(told(&mut bench, 0).contains("shows nothing at this step"));
    let end = bench.n_steps();
    let said = told(&mut bench, end);
    assert!(said.contains("shows face 1 of object A"), "{said}");
    let run = bench.app.playback.main();
    let verdict = bench.document().verdict(place, (run, end));
    let notes = verdict.expect("it is told").notes;
    let said = |note: &Message| Catalog::of(Lang::En).message(note);
    let said: Vec<String> = notes.iter().map(said).collect();
    let nearest = "nearest face there is face 1 of object B";
    assert!(said.join(" ").contains(nearest), "{said:?}");
    let lost = said
        .iter()
        .any(|it| it.contains("B is as near as A at pixel [8, 5]"));
    assert!(lost, "why the picture does not show it: {said:?}");
    // The picture is the same where another pixel alone is looked at, and so is the answer.
    let mut plan = bench.space().raster;
    plan.pixel = Some([2, 2]);
    bench.edit(Edit::Own(Arc::new(space::SpaceChange::Raster(plan))));
    let end = bench.n_steps();
    assert!(told(&mut bench, end).contains("shows face 1 of object A"));
    let run = bench.app.playback.main();
    let alone = bench.document().verdict(place, (run, end));
    let alone = alone.expect("it is told").notes;
    let alone: Vec<String> = alone
        .iter()
        .map(|it| Catalog::of(Lang::En).message(it))
        .collect();
    assert_eq!(alone, said);
}

#[test]
fn the_cameras_picture_is_enlarged_by_a_double_click_and_by_a_key_and_put_back() {
    let mut bench = Bench::lab("frustum");
    let size = |bench: &Bench| bench.size_of("camera");
    let small = size(&bench);
    let at = middle_of(&bench, "camera");
    bench.tap(at);
    bench.tap(at);
    bench.settle();
    assert!(size(&bench) > 3.0 * small, "{} {small}", size(&bench));
    bench.press_at(middle_of(&bench, "camera"));
    assert!(bench.verdict().is_some(), "it can be asked there, too");
    bench.key(Key::V);
    bench.settle();
    assert!((size(&bench) - small).abs() < 1.0);
    bench.key(Key::V);
    assert!(bench.app.has_large_picture());
    bench.command(Command::Lab("surfaces"));
    assert!(!bench.app.has_large_picture(), "elsewhere it begins small");
}

#[test]
fn the_cameras_picture_has_the_room_of_bars_and_tables_and_where_there_is_none_that_is_said() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("24-faces-turned-away", "in-perspective");
    let small = bench.size_of("camera");
    bench.key(Key::V);
    bench.settle();
    let large = bench.size_of("camera");
    assert!(large > 2.0 * small, "{large} {small}");
    bench.open_step("38-no-order", "three-pixels");
    bench.key(Key::V);
    assert!(!bench.app.has_large_picture(), "no method shows one");
    let told = bench.app.notices.iter().map(|notice| &notice.text);
    let told: Vec<&String> = told.collect();
    assert!(
        told.iter()
            .any(|text| text.contains("picture of the camera")),
        "{told:?}"
    );
}

#[test]
fn without_an_inspector_beside_it_why_is_told_on_the_stage_and_has_a_way_out() {
    for is_presenting in [false, true] {
        let mut bench = Bench::lab("frustum");
        if is_presenting {
            bench.command(Command::Present);
        } else {
            bench.command(Command::Inspector);
        }
        bench.settle();
        bench.click_in_space([-6.5, 0.8, 0.5]);
        let texts = bench.texts();
        let why = texts.iter().filter(|(text, _)| text == "Why?").count();
        assert_eq!(why, 1, "told once");
        let said = bench.verdict().expect("it is told");
        assert!(said.starts_with("Object 5 is culled"), "{said}");
        bench.key(Key::Escape);
        assert_eq!(bench.verdict(), None, "nothing is asked any more");
        bench.click_in_space([-6.5, 0.8, 0.5]);
        bench.click_on("Go to that step (Enter)");
        assert_ne!(bench.app.position(), 0);
    }
}

#[test]
fn in_each_column_the_method_that_stands_there_is_asked() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("14-both-lists", "side-by-side");
    bench.key(Key::End);
    // In the column that is drawn last, an edge that was cut away, at its middle.
    let at = bench.app.stage.on_screen([5.0, 2.875, 0.0]);
    bench.press_at(at.expect("it is in sight"));
    let texts = bench.texts();
    let said: Vec<&String> = texts.iter().map(|(text, _)| text).collect();
    let is_told = |text: &&&String| text.starts_with("From (") && text.contains("(6, 3)");
    assert!(said.iter().any(|text| is_told(&text)), "{said:?}");
}
