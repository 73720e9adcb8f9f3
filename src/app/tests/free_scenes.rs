//! Scenes of one's own: made, named, gone between, deleted, and there again after a restart.

use super::*;
use crate::app::desk::SceneAct;

/// Makes a scene of this name, as its dialog does.
fn make(bench: &mut Bench, act: SceneAct, name: &str) {
    bench.command(Command::AskAboutScene(act));
    assert!(matches!(bench.app.shown.dialog, Some(Dialog::Scene(..))));
    bench.command(Command::Show(Some(Dialog::Scene(act, name.to_owned()))));
    bench.command(Command::Confirm);
}

fn names(bench: &Bench) -> Vec<Option<String>> {
    let pages = bench.app.free_scenes().into_iter();
    pages.map(|page| page.name().map(str::to_owned)).collect()
}

#[test]
fn every_lab_has_a_smallest_scene_that_runs() {
    for lab in ["lines", "polygons", "frustum", "surfaces"] {
        let mut bench = Bench::lab(lab);
        let first = bench.document().size();
        bench.press(Key::N, ctrl());
        bench.settle();
        bench.key(Key::Enter);
        bench.settle();
        assert_eq!(
            bench
                .app
                .bookmark
                .page()
                .and_then(|page| page.name().map(str::to_owned))
                .as_deref(),
            Some("Scene 2"),
            "{lab}"
        );
        assert_eq!(bench.document().lab().id, lab);
        assert!(bench.document().size() <= first && !bench.app.playback.main().is_refused());
        let before = bench.app.scene().clone();
        bench.edit(Edit::Remove(None));
        assert_eq!(bench.app.scene(), &before, "{lab}: nothing more can go");
    }
}

#[test]
fn scenes_are_copied_renamed_deleted_and_kept_over_a_restart() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Seek(2));
    let stage = bench.app.scene().clone();
    make(&mut bench, SceneAct::Copy, " of the lesson ");
    assert_eq!((bench.app.scene(), bench.app.position()), (&stage, 2));
    bench.edit(Edit::Add(None));
    let mine = bench.app.scene().clone();
    make(&mut bench, SceneAct::New, "other");
    assert_ne!(bench.app.scene(), &mine);
    let known = |list: &[&str]| -> Vec<Option<String>> {
        let named = list.iter().map(|name| Some((*name).to_owned()));
        std::iter::once(None).chain(named).collect()
    };
    assert_eq!(names(&bench), known(&["of the lesson", "other"]));
    // Renamed to a name that is taken it asks again.
    make(&mut bench, SceneAct::Rename, "of the lesson");
    assert!(bench.app.shown.dialog.is_some());
    bench.key(Key::Escape);
    make(&mut bench, SceneAct::Rename, "another");
    for key in [Key::PageDown, Key::PageDown, Key::PageUp] {
        bench.press(key, ctrl());
    }
    assert_eq!(bench.app.scene(), &mine);
    let mut again = Bench::with(restarted(&bench.app), SIZE);
    assert_eq!(names(&again), known(&["another", "of the lesson"]));
    assert_eq!(again.app.scene(), &mine);
    // To the course and back again.
    again.key(Key::F8);
    again.key(Key::F8);
    assert_eq!(again.app.scene(), &mine);
    again.press(Key::Delete, ctrl());
    again.key(Key::Enter);
    again.settle();
    assert_eq!(names(&again), known(&["another"]));
    again.press(Key::Delete, ctrl());
    assert!(
        again.app.shown.dialog.is_none(),
        "the one without a name stays"
    );
    assert_eq!(
        names(&Bench::with(restarted(&again.app), SIZE)),
        known(&["another"])
    );
}

#[test]
fn the_panel_and_the_menu_lead_to_each() {
    let mut bench = Bench::new(SIZE);
    make(&mut bench, SceneAct::Copy, "mine");
    bench.click_on("mine");
    bench.click_on("Free scene");
    assert_eq!(
        bench.app.bookmark.page(),
        Some(Page::Free("lines".to_owned()))
    );
    bench.open_menus(&["Scene", "Free scenes"]);
    bench.click_on("mine");
    let mine = Page::Named("lines".to_owned(), "mine".to_owned());
    assert_eq!(bench.app.bookmark.page(), Some(mine));
}

/// R throws nothing away that is the reader's.
#[test]
fn reset_shows_a_free_scene_anew_and_leaves_it_as_it_is() {
    let mut bench = Bench::new(SIZE);
    bench.edit(Edit::Add(None));
    let mine = bench.app.scene().clone();
    bench.command(Command::LAST);
    bench.command(Command::FitView);
    let view = bench.on_screen([0.0, 0.0]);
    bench.command(Command::Zoom(2.0));
    bench.key(Key::R);
    bench.settle();
    assert_eq!((bench.app.scene(), bench.app.position()), (&mine, 0));
    assert_eq!(bench.on_screen([0.0, 0.0]), view);
}
