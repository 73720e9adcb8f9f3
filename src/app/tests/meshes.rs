//! Meshes that are dropped on the window, or opened in it.

use std::{fs, thread, time::Duration};

use super::*;
use crate::labs::frustum;

/// Waits until all that was dropped has been read.
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

/// A folder with these files in it.
fn folder(files: &[(&str, &[u8])]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).expect("writable");
    }
    folder
}

/// Drops a file of this name, and waits until it has been read.
fn dropped(bench: &mut Bench, name: &str, text: &str) {
    let folder = folder(&[(name, text.as_bytes())]);
    bench.drop_file(folder.path().join(name), None);
    wait(bench);
}

/// So many more objects than the frustum lab's first scene has.
fn n_added(bench: &Bench) -> usize {
    let n_objects = |scene: &Scene| {
        let scene = scene.get::<space::Scene>();
        scene.map_or(0, |scene| scene.objects().len())
    };
    n_objects(bench.app.scene()) - n_objects(&(frustum::LAB.first_scene)())
}

const WEDGE: &str = "mtllib wedge.mtl\nusemtl wood\n\
    v 10 10 10\nv 14 10 10\nv 10 12 10\nv 10 10 11\n\
    f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#[test]
fn a_mesh_that_is_dropped_stands_in_the_free_scene_and_can_be_undone() {
    let mut bench = Bench::on_a_desktop();
    let lines = bench.app.scene().clone();
    dropped(&mut bench, "wedge.OBJ", WEDGE);
    assert_eq!(n_added(&bench), 1, "{}", bench.said());
    let wedge = bench.space().focused();
    let space::Model::Mesh(named) = wedge.model() else {
        panic!("a mesh, not {:?}", wedge.model());
    };
    assert_eq!((&*named.name, named.mesh.faces().len()), ("wedge", 4));
    // Four units long: around the origin, from −1 to 1.
    let bounds = named.mesh.bounds().expect("it has vertices");
    let around = ([-1.0, -0.5, -0.25], [1.0, 0.5, 0.25]);
    assert_eq!((bounds.min(), bounds.max()), around);
    let said = &bench.app.notices[0].text;
    assert!(said.contains("wedge"), "{said}");
    bench.command(Command::Undo);
    assert_eq!(n_added(&bench), 0);
    bench.command(Command::Lab("lines"));
    assert_eq!(*bench.app.scene(), lines, "what was open is as it was");
}

#[test]
fn what_is_no_mesh_is_explained_with_its_place_and_changes_nothing() {
    let mut bench = Bench::on_a_desktop();
    let before = bench.app.scene().clone();
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (text, place) in [
        (&*format!("{triangle}f 1 2 4\n"), "bad.obj:4:7"),
        (&*format!("{triangle}f 1 2 0\r\n"), "bad.obj:4:7"),
        ("v 0 nan 0\n", "bad.obj:1:5"),
        ("", "bad.obj:1:1"),
        ("\u{0}\u{1}", "bad.obj:1:1"),
    ] {
        dropped(&mut bench, "bad.obj", text);
        let said = bench.said();
        assert!(said.contains(place) && said.contains("as it was"), "{said}");
        assert_eq!(*bench.app.scene(), before);
    }
    let folder = folder(&[]);
    let file = fs::File::create(folder.path().join("large.obj")).expect("writable");
    file.set_len(2 << 30).expect("a hole takes no room");
    // Two gigabytes are refused unread.
    for (name, why) in [("there-is-none.obj", ""), ("large.obj", "128 MiB")] {
        bench.drop_file(folder.path().join(name), None);
        wait(&mut bench);
        let said = bench.said();
        assert!(said.contains(name) && said.contains(why), "{said}");
        assert!(!said.contains("os error"), "{said}");
        assert_eq!(*bench.app.scene(), before);
    }
}

#[test]
fn what_is_left_out_of_a_mesh_is_said() {
    let mut bench = Bench::on_a_desktop();
    dropped(&mut bench, "odd.obj", &format!("{WEDGE}f 1 2\n"));
    let said = bench.said();
    assert!(said.contains("odd.obj:11:1"), "{said}");
    assert!(said.contains("left out"), "{said}");
    assert_eq!(n_added(&bench), 1);
}

#[test]
fn escape_gives_a_mesh_up() {
    let mut bench = Bench::on_a_desktop();
    let before = bench.app.scene().clone();
    let folder = folder(&[("large.obj", WEDGE.repeat(10_000).as_bytes())]);
    let path = folder.path().join("large.obj").display().to_string();
    let ctx = bench.ctx.clone();
    bench.app.load_mesh(&path, &ctx);
    let said = |bench: &Bench| bench.app.notices[0].text.clone();
    assert!(said(&bench).contains("large.obj"), "it says what it does");
    bench.apply(Command::Cancel);
    assert!(bench.app.loading.is_empty());
    assert!(said(&bench).contains("was cancelled"), "{}", said(&bench));
    thread::sleep(Duration::from_millis(50));
    bench.settle();
    assert_eq!(*bench.app.scene(), before);
}

#[test]
fn what_comes_along_with_a_mesh_is_no_scene_of_its_own() {
    let mut bench = Bench::on_a_desktop();
    let names = ["one.obj", "wedge.mtl", "wood.png", "two.obj"];
    let folder = folder(&names.map(|name| (name, WEDGE.as_bytes())));
    let files = names.map(|name| {
        let file = Arc::new(Dropped(folder.path().join(name), None));
        file as egui::DroppedFileHandle
    });
    bench.frame_with(0.1, Vec::new(), files.into());
    wait(&mut bench);
    let said = bench.said();
    assert_eq!(n_added(&bench), 2, "{said}");
    // What stands in wedge.mtl is no material.
    assert!(said.contains("wedge.mtl"), "{said}");
}

#[test]
fn a_mesh_is_painted_with_the_picture_beside_it() {
    const PAINTED: &str = "mtllib wedge.mtl\nusemtl wood\n\
        v 0 0 0\nv 4 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    let mut bench = Bench::on_a_desktop();
    let material = b"newmtl stone\nmap_Kd ../elsewhere.png\nnewmtl wood\nmap_Kd my wood.jpg\n";
    let picture = include_bytes!("../../lesson/mesh_file/grey.jpg");
    let folder = folder(&[
        ("wedge.mtl", material),
        ("my wood.jpg", picture),
        ("wedge.obj", PAINTED.as_bytes()),
    ]);
    bench.drop_file(folder.path().join("wedge.obj"), None);
    wait(&mut bench);
    let wedge = bench.space().focused();
    let skin = wedge.model().skin([0, 1, 2]).expect("it is painted");
    assert_eq!(skin.texture.size(), [16, 8]);
    assert_eq!(skin.uvs, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    let said = bench.said();
    assert!(!said.contains("wedge.mtl"), "{said}");
}

#[test]
fn a_picture_of_the_mesh_s_name_is_taken_as_its_texture_and_said() {
    const PAINTED: &str = "v 0 0 0\nv 4 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    let grey = include_bytes!("../../lesson/mesh_file/grey.jpg");
    for (mesh, name, text, is_painted) in [
        ("wedge.obj", "wedge.jpg", PAINTED.to_owned(), true),
        ("wedge.obj", "wedge_texture.jpeg", PAINTED.to_owned(), true),
        (
            "wedge_fine.obj",
            "wedge_texture.jpeg",
            PAINTED.to_owned(),
            true,
        ),
        ("wedge.obj", "other.jpg", PAINTED.to_owned(), false),
        // Its corners have no places on a texture.
        (
            "wedge.obj",
            "wedge.jpg",
            WEDGE.replace("mtllib wedge.mtl\n", ""),
            false,
        ),
    ] {
        let mut bench = Bench::on_a_desktop();
        let folder = folder(&[(name, grey), (mesh, text.as_bytes())]);
        bench.drop_file(folder.path().join(mesh), None);
        wait(&mut bench);
        let skin = bench.space().focused().model().skin([0, 1, 2]);
        assert_eq!(skin.is_some(), is_painted, "{name}");
        assert_eq!(bench.said().contains(name), is_painted, "{name}");
    }
}

#[test]
fn triangles_without_area_are_counted() {
    let mut bench = Bench::on_a_desktop();
    dropped(
        &mut bench,
        "flat.obj",
        &format!("{WEDGE}f 1 2 2\nf 3 3 1\n"),
    );
    let said = bench.said();
    assert!(said.contains("flat.obj:11:1"), "{said}");
    assert!(said.contains("2 triangles have no area"), "{said}");
}

#[test]
fn a_mesh_is_opened_by_its_path_too() {
    let mut bench = Bench::on_a_desktop();
    let folder = folder(&[("wedge.obj", WEDGE.as_bytes())]);
    let path = folder.path().join("wedge.obj").display().to_string();
    bench.apply(Command::Show(Some(Dialog::Open(Target::new(path)))));
    bench.apply(Command::Confirm);
    wait(&mut bench);
    assert_eq!(n_added(&bench), 1);
}
