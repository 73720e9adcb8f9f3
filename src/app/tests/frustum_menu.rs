//! What a lab in space adds to menu and inspector: its camera, its objects, its raster.

use super::*;
use crate::{
    geom::Solid,
    labs::space::{MAX_OBJECTS, Model, Opening},
};

impl Bench {
    /// Opens these menus, one in the other.
    pub(super) fn open_menus(&mut self, names: &[&str]) {
        for name in names {
            self.click_on(name);
        }
    }

    /// In the inspector the field of this name, which stands right of what says it; in a menu the place behind that.
    fn field(&mut self, name: &str) -> Rect {
        let first = self.found(name);
        let all = self.names.iter().filter(|(known, _)| known == name);
        let lefts = all.map(|(_, rect)| *rect);
        let field = lefts
            .max_by(|a, b| a.left().total_cmp(&b.left()))
            .unwrap_or(first);
        if field.left() > 0.6 * self.size.x {
            field
        } else {
            first.translate(vec2(0.5 * first.width() + 24.0, 0.0))
        }
    }

    /// Opens a list of choices and takes one.
    fn choose(&mut self, name: &str, choice: &str) {
        let list = self.field(name);
        self.press_at(list.center());
        self.click_on(choice);
    }

    /// The first words of the lesson's text that lead to a control.
    fn link(&mut self) -> (String, Rect) {
        let is_there = |text: &str, at: Rect| at.right() < 300.0 && text.ends_with(" rows");
        let mut named = self.named().into_iter();
        named
            .find(|(text, at)| is_there(text, *at))
            .expect("a link")
    }

    /// Types a number into the field behind this name.
    pub(super) fn type_into(&mut self, name: &str, text: &str) {
        let field = self.field(name);
        self.press_at(field.center());
        self.write(text);
        self.key(Key::Enter);
        self.settle();
    }
}

#[test]
fn the_camera_s_numbers_are_typed_and_undone() {
    let mut bench = Bench::lab("frustum");
    let before = bench.space().clone();
    bench.open_menus(&["Scene", "Camera…"]);
    bench.type_into("Near plane", "3/2");
    assert_eq!(bench.space().camera.depths()[0], 1.5);
    bench.type_into("Field of view", "55");
    assert_eq!(bench.space().camera.opening(), Opening::FovY(55.0));
    bench.type_into("Far plane", "1");
    let depths = [1.5, before.camera.depths()[1]];
    assert_eq!(
        bench.space().camera.depths(),
        depths,
        "as they make a camera"
    );
    let said = |bench: &mut Bench, part: &str| {
        let texts = bench.texts().into_iter();
        texts.filter(|(text, _)| text.contains(part)).count()
    };
    assert_eq!(
        said(&mut bench, "The far plane must"),
        1,
        "and that is said"
    );
    bench.type_into("Near plane", "close");
    assert_eq!(said(&mut bench, "but close was typed"), 1);
    assert_eq!(said(&mut bench, "The far plane must"), 0);
    assert_eq!(bench.space().camera.depths(), depths);
    bench.type_into("Target x", "−1");
    let [_, target, up] = bench.space().camera.places();
    assert_eq!((target[0], up), (-1.0, before.camera.places()[2]));
    for _ in 0..3 {
        bench.command(Command::Undo);
    }
    assert_eq!(*bench.space(), before);
}

#[test]
fn what_a_lesson_locks_is_locked_in_the_inspector() {
    let mut bench = Bench::course(ROOMY);
    for (step, is_locked) in [(2, true), (3, false)] {
        bench.command(Command::Open([18, step]));
        bench.command(Command::Section(Some("camera")));
        let before = bench.space().camera.depths()[0];
        bench.type_into("Near plane", "3/2");
        let now = bench.space().camera.depths()[0];
        assert_eq!(now == before, is_locked, "step {step}: {before}, {now}");
    }
}

#[test]
fn a_text_leads_to_the_control_that_it_asks_for() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open([33, 0]));
    let rows = bench.space().raster.rows();
    bench.app.settings.inspector = false;
    bench.settle();
    let (link, at) = bench.link();
    assert_eq!(link, (2 * rows).to_string() + " rows");
    bench.frame(0.1, vec![Event::PointerMoved(at.center())]);
    assert_eq!(bench.cursor, CursorIcon::PointingHand);
    bench.tap(at.center());
    bench.frame(0.1, Vec::new());
    bench.frame(0.1, Vec::new());
    assert!(bench.wait_secs < 10.0, "it is lit for a moment");
    // The field has the focus: what is typed goes there.
    bench.write(&(2 * rows).to_string());
    bench.key(Key::Enter);
    assert_eq!(bench.space().raster.rows(), 2 * rows);
    bench.frame(3.0, Vec::new());
    bench.settle();
    assert!(bench.wait_secs > 10.0, "and nothing is drawn any more");
    bench.undo();
    assert_eq!(bench.space().raster.rows(), rows);
}

#[test]
fn perspective_and_parallel_see_as_much_at_the_target() {
    let mut bench = Bench::lab("frustum");
    let before = bench.space().camera.opening();
    bench.command(Command::Section(Some("camera")));
    bench.choose("Projection", "Parallel");
    let parallel = bench.space().camera.opening();
    assert!(
        matches!(parallel, Opening::Height(height) if height > 0.0),
        "{parallel:?}"
    );
    bench.choose("Projection", "Perspective");
    let after = bench.space().camera.opening();
    let (Opening::FovY(back), Opening::FovY(given)) = (after, before) else {
        panic!("in perspective");
    };
    assert!((back - given).abs() < 1e-9, "{back}");
}

#[test]
fn objects_are_added_enlarged_and_removed() {
    let mut bench = Bench::lab("frustum");
    let n_objects = bench.space().objects().len();
    bench.open_menus(&["Scene", "Add an object", "Torus"]);
    assert_eq!(bench.space().objects().len(), n_objects + 1);
    assert_eq!(*bench.space().focused().model(), Model::Solid(Solid::Torus));
    bench.open_menus(&["Scene", "Add an object", "Spot the cow"]);
    assert_eq!(bench.space().focused().model().mesh().faces().len(), 5856);
    bench.open_menus(&["Scene", &format!("Object {}…", n_objects + 2)]);
    bench.type_into("Size", "0,5");
    assert_eq!(bench.space().focused().size(), 0.5);
    bench.type_into("Turn y", "−30°");
    assert_eq!(bench.space().focused().turn_deg(), [0.0, -30.0, 0.0]);
    bench.type_into("Number", "1");
    assert_eq!(bench.space().focus(), 0);
    bench.open_menus(&["Scene", "Remove the object in focus"]);
    assert_eq!(bench.space().objects().len(), n_objects + 1);
}

#[test]
fn a_street_has_as_many_boxes_as_are_asked_for() {
    let mut bench = Bench::lab("frustum");
    bench.open_menus(&["Scene", "Street of boxes", "Build the street"]);
    assert_eq!(bench.space().objects().len(), 100);
    bench.command(Command::Undo);
    assert_ne!(bench.space().objects().len(), 100);
    assert_eq!(MAX_OBJECTS, 10_000);
}

#[test]
fn a_scene_is_taken_along_to_the_other_lab_in_space() {
    let mut bench = Bench::lab("frustum");
    let before = bench.space().clone();
    bench.open_menus(&["Scene", "Open this scene in: Surfaces"]);
    let shown = |scene: &space::Scene| (scene.objects().to_vec(), scene.camera);
    assert_eq!(bench.document().lab().id, "surfaces");
    assert_eq!(shown(bench.space()), shown(&before));
    bench.command(Command::Undo);
    assert_eq!(bench.document().lab().id, "surfaces", "its own scene there");
    bench.command(Command::Lab("frustum"));
    assert_eq!(bench.space(), &before);
}
