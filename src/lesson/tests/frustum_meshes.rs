//! Lessons with meshes in their folders.

use crate::labs::space::Scene;

use super::{
    frustum_scenes::{SCENE, read},
    *,
};

const LESSON: &str = r#"lab = "frustum"
source = "J. H. Clark, 1976"

[scenes.wedge]
method = "sphere-cull"
camera = { position = [0, 2, 6], target = [0, 1, -2], fov_y_deg = 40, aspect = 1.6, near = 1, far = 12 }
objects = [{ mesh = "wedge.obj", at = [0, 1, 0] }]

[[step]]
id = "first"
scene = "wedge"
figure = "one"

[[step]]
id = "second"
at = "end"
"#;

const WEDGE: &str = "v 0 0 0\nv 8 0 0\nv 0 4 0\nf 1 2 3\n";

#[test]
fn a_lesson_has_meshes_in_its_folder() {
    let with_mesh = |toml: &str, mesh: &str| {
        let mut files = with(toml, TEXT);
        files.insert("01-a/wedge.obj".to_owned(), mesh.into());
        files
    };
    let files = with_mesh(LESSON, WEDGE);
    assert!(found(&files).is_empty(), "{:?}", found(&files));
    let course = Course::check(&files).course;
    let scene = course.lessons[0].steps[0].scene.get::<Scene>();
    let object = scene.expect("of this lab").focused();
    let bounds = object.model().mesh().bounds().expect("it has vertices");
    assert_eq!(
        (bounds.min(), bounds.max()),
        ([-1.0, -0.5, 0.0], [1.0, 0.5, 0.0])
    );
    for (old, new, mesh, expected) in [
        ("", "", "v 0 0 0\nf 1 1 2\n", "wedge.obj:2:7 no-such-vertex"),
        (
            "",
            "",
            &format!("{WEDGE}f 1 2\n"),
            "wedge.obj:5:1 face-too-short",
        ),
        (
            "wedge.obj",
            "gone.obj",
            WEDGE,
            "lesson.toml:7:21 unreadable",
        ),
        (
            "wedge.obj",
            "../wedge.obj",
            WEDGE,
            "lesson.toml:7:21 no-such-mesh",
        ),
        (
            "wedge.obj",
            "wedge.ply",
            WEDGE,
            "lesson.toml:7:21 no-such-mesh",
        ),
    ] {
        let files = with_mesh(&LESSON.replacen(old, new, 1), mesh);
        assert!(
            found(&files).contains(&expected.to_owned()),
            "{new}: {:?}",
            found(&files)
        );
    }
    let alone = SCENE.replace("solid = \"spot\"", "mesh = \"wedge.obj\"");
    assert_eq!(
        read(&alone),
        Err(vec!["a.toml:11:14 no-such-mesh".to_owned()])
    );
}
