//! The frustum lab's menu: its camera, its objects.

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

    /// Types a number into the field behind this name.
    pub(super) fn type_into(&mut self, name: &str, text: &str) {
        let field = self.found(name);
        self.press_at(field.right_center() + vec2(24.0, 0.0));
        self.write(text);
        self.key(Key::Enter);
        self.settle();
    }
}

#[test]
fn the_camera_s_numbers_are_typed_and_undone() {
    let mut bench = Bench::lab("frustum");
    let before = bench.space().clone();
    bench.open_menus(&["Scene", "Camera"]);
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
    assert!(!bench.app.notices.is_empty(), "and that is said");
    bench.command(Command::Undo);
    bench.command(Command::Undo);
    assert_eq!(*bench.space(), before);
}

#[test]
fn perspective_and_parallel_see_as_much_at_the_target() {
    let mut bench = Bench::lab("frustum");
    let before = bench.space().camera.opening();
    bench.open_menus(&["Scene", "Camera", "Parallel"]);
    let parallel = bench.space().camera.opening();
    assert!(
        matches!(parallel, Opening::Height(height) if height > 0.0),
        "{parallel:?}"
    );
    bench.click_on("Perspective");
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
    bench.open_menus(&["Scene", "Object in focus"]);
    bench.type_into("Size", "0,5");
    assert_eq!(bench.space().focused().size(), 0.5);
    bench.type_into("Turned about y", "−30°");
    assert_eq!(bench.space().focused().turn_deg(), [0.0, -30.0, 0.0]);
    bench.type_into("Object", "1");
    assert_eq!(bench.space().focus(), 0);
    bench.key(Key::Escape);
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
