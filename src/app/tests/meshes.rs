//! Meshes that are dropped on the window, or opened in it.

use std::{path::PathBuf, sync::Arc, thread, time::Duration};

use super::{Bench, SIZE};
use crate::{
    app::{App, Command, Dialog, Settings, Target},
    labs::{Scene, frustum, space},
    lesson::Course,
};

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        &self.0
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        Err("it is read in a thread".to_owned())
    }
}

/// Drops a file of this name, and waits until it has been read.
fn dropped(bench: &mut Bench, name: &str, text: &str) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(name);
    std::fs::write(&path, text).expect("writable");
    bench.frame_with(0.1, Vec::new(), vec![Arc::new(Dropped(path))]);
    wait(bench);
}

fn wait(bench: &mut Bench) {
    for _ in 0..2000 {
        if bench.app.loading.is_empty() {
            return;
        }
        thread::sleep(Duration::from_millis(5));
        bench.frame(0.01, Vec::new());
    }
    panic!("it is never read");
}

fn bench() -> Bench {
    Bench::with(App::new(Course::default(), Settings::default()), SIZE)
}

fn said(bench: &Bench) -> Vec<String> {
    let notices = bench.app.notices.shown().iter();
    notices.map(|notice| notice.text.clone()).collect()
}

fn objects(scene: &Scene) -> usize {
    let scene = scene.get::<space::Scene>();
    scene.map_or(0, |scene| scene.objects().len())
}

const WEDGE: &str = "mtllib wedge.mtl\nusemtl wood\n\
    v 10 10 10\nv 14 10 10\nv 10 12 10\nv 10 10 11\n\
    f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#[test]
fn a_mesh_that_is_dropped_stands_in_the_free_scene_and_can_be_undone() {
    let mut bench = bench();
    let lines = bench.app.scene().clone();
    dropped(&mut bench, "wedge.OBJ", WEDGE);
    let first = objects(&frustum::LAB.first_scene());
    assert_eq!(objects(bench.app.scene()), first + 1, "{:?}", said(&bench));
    let scene = bench.app.scene().get::<space::Scene>();
    let wedge = scene.expect("of that lab").focused().clone();
    let space::Model::Mesh(named) = wedge.model() else {
        panic!("a mesh, not {:?}", wedge.model());
    };
    assert_eq!(
        (named.name.as_str(), named.mesh.faces().len()),
        ("wedge", 4)
    );
    // Four units long: around the origin, from −1 to 1.
    let bounds = named.mesh.bounds().expect("it has vertices");
    assert_eq!(
        (bounds.min(), bounds.max()),
        ([-1.0, -0.5, -0.25], [1.0, 0.5, 0.25])
    );
    assert!(said(&bench)[0].contains("wedge"), "{:?}", said(&bench));
    bench.command(Command::Undo);
    assert_eq!(objects(bench.app.scene()), first);
    bench.command(Command::Lab("lines"));
    assert_eq!(*bench.app.scene(), lines, "what was open is as it was");
}

#[test]
fn what_is_no_mesh_is_explained_with_its_place_and_changes_nothing() {
    let mut bench = bench();
    let before = bench.app.scene().clone();
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (text, place) in [
        (format!("{triangle}f 1 2 4\n"), "bad.obj:4:7"),
        (format!("{triangle}f 1 2 0\r\n"), "bad.obj:4:7"),
        ("v 0 nan 0\n".to_owned(), "bad.obj:1:5"),
        (String::new(), "bad.obj:1:1"),
        ("\u{0}\u{1}".to_owned(), "bad.obj:1:1"),
    ] {
        dropped(&mut bench, "bad.obj", &text);
        let said = said(&bench).join("\n");
        assert!(said.contains(place) && said.contains("as it was"), "{said}");
        assert_eq!(*bench.app.scene(), before);
    }
    let missing = Dropped(PathBuf::from("/nowhere/there-is-none.obj"));
    bench.frame_with(0.1, Vec::new(), vec![Arc::new(missing)]);
    wait(&mut bench);
    let said = said(&bench).join("\n");
    assert!(
        said.contains("there-is-none.obj") && !said.contains("os error"),
        "{said}"
    );
    assert_eq!(*bench.app.scene(), before);
}

#[test]
fn what_is_left_out_of_a_mesh_is_said() {
    let mut bench = bench();
    dropped(&mut bench, "odd.obj", &format!("{WEDGE}f 1 2\n"));
    let said = said(&bench).join("\n");
    assert!(
        said.contains("odd.obj:11:1") && said.contains("left out"),
        "{said}"
    );
    assert_eq!(
        objects(bench.app.scene()),
        objects(&frustum::LAB.first_scene()) + 1
    );
}

#[test]
fn escape_gives_a_mesh_up() {
    let mut bench = bench();
    let before = bench.app.scene().clone();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("large.obj");
    std::fs::write(&path, WEDGE.repeat(10_000)).expect("writable");
    let ctx = bench.ctx.clone();
    bench.app.load_mesh(&path.display().to_string(), &ctx);
    assert!(
        said(&bench)[0].contains("large.obj"),
        "it says what it does"
    );
    bench.app.apply(&ctx, Command::Cancel);
    assert!(bench.app.loading.is_empty());
    assert!(said(&bench)[0].contains("given up"), "{:?}", said(&bench));
    thread::sleep(Duration::from_millis(50));
    bench.settle();
    assert_eq!(*bench.app.scene(), before);
}

#[test]
fn what_comes_along_with_a_mesh_is_no_scene_of_its_own() {
    let mut bench = bench();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let files = ["one.obj", "wedge.mtl", "wood.png", "two.obj"].map(|name| {
        let path = folder.path().join(name);
        std::fs::write(&path, WEDGE).expect("writable");
        let file: egui::DroppedFileHandle = Arc::new(Dropped(path));
        file
    });
    bench.frame_with(0.1, Vec::new(), files.into());
    wait(&mut bench);
    let first = objects(&frustum::LAB.first_scene());
    assert_eq!(objects(bench.app.scene()), first + 2, "{:?}", said(&bench));
    let said = said(&bench).join("\n");
    // What stands in wedge.mtl is no material.
    assert!(said.contains("wedge.mtl"), "{said}");
}

#[test]
fn a_mesh_is_painted_with_the_picture_beside_it() {
    const PAINTED: &str = "mtllib wedge.mtl\nusemtl wood\n\
        v 0 0 0\nv 4 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    let mut bench = bench();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, bytes: &[u8]| {
        std::fs::write(folder.path().join(name), bytes).expect("writable");
    };
    let material = "newmtl stone\nmap_Kd ../elsewhere.png\nnewmtl wood\nmap_Kd my wood.jpg\n";
    write("wedge.mtl", material.as_bytes());
    write(
        "my wood.jpg",
        include_bytes!("../../lesson/mesh_file/grey.jpg"),
    );
    write("wedge.obj", PAINTED.as_bytes());
    let path = folder.path().join("wedge.obj");
    bench.frame_with(0.1, Vec::new(), vec![Arc::new(Dropped(path))]);
    wait(&mut bench);
    let scene = bench.app.scene().get::<space::Scene>();
    let wedge = scene.expect("of that lab").focused();
    let skin = wedge.model().skin([0, 1, 2]).expect("it is painted");
    assert_eq!(skin.texture.size(), [16, 8]);
    assert_eq!(skin.uvs, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    let said = said(&bench).join("\n");
    assert!(!said.contains("wedge.mtl"), "{said}");
}

#[test]
fn two_gigabytes_are_refused_unread() {
    let mut bench = bench();
    let before = bench.app.scene().clone();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("large.obj");
    let file = std::fs::File::create(&path).expect("writable");
    file.set_len(2 << 30).expect("a hole takes no room");
    bench.frame_with(0.1, Vec::new(), vec![Arc::new(Dropped(path))]);
    wait(&mut bench);
    let said = said(&bench).join("\n");
    assert!(
        said.contains("large.obj") && said.contains("128 MiB"),
        "{said}"
    );
    assert_eq!(*bench.app.scene(), before);
}

#[test]
fn a_mesh_is_opened_by_its_path_too() {
    let mut bench = bench();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("wedge.obj");
    std::fs::write(&path, WEDGE).expect("writable");
    let target = Target::new(path.display().to_string());
    let ctx = bench.ctx.clone();
    bench
        .app
        .apply(&ctx, Command::Show(Some(Dialog::Open(target))));
    bench.app.apply(&ctx, Command::Confirm);
    wait(&mut bench);
    assert_eq!(
        objects(bench.app.scene()),
        objects(&frustum::LAB.first_scene()) + 1
    );
}
