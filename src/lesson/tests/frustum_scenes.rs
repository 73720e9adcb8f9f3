//! Scenes of the frustum lab in files, and meshes beside them: read as they were written, and every mistake with its place.

use std::sync::Arc;

use proptest::prelude::*;

use crate::{
    figure::{Lens, Moment},
    geom::{Mesh, Orbit, Solid},
    labs::{
        self,
        frustum::{FRUSTUM, LAB},
        space::{
            Method, Model, NamedMesh, Object, Opening, Part, Picture, Places, Scene, TaughtCamera,
        },
    },
};

use super::*;

const SCENE: &str = r#"method = "sphere-cull"
compare = "box-cull"
camera = { position = [0, 2, 6], target = [0, 1, -2], fov_y_deg = 40, aspect = 1.6, near = 1, far = 12 }
eye = { target = [0, 1, 0], yaw_deg = -58, pitch_deg = 24, distance = 26, fov_y_deg = 26 }
point = [0.5, 1, -2]
focus = 1
face = 2
objects = [
    { solid = "cube", at = [0, 1, 0], turn_deg = [0, 20, 0], size = 0.6 },
    { mesh = { name = "wedge", vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0.5]], faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] } },
    { solid = "spot" },
]
"#;

fn read(text: &str) -> Result<Scene, Vec<String>> {
    let read = SceneFormats::standard().read("a.toml", text.as_bytes());
    let read = read.map_err(|problems| problems.iter().map(super::spot).collect::<Vec<_>>())?;
    Ok(read.scene.get::<Scene>().expect("of this lab").clone())
}

fn written(scene: &Scene) -> String {
    let scene = labs::Scene::from(scene.clone());
    SceneFormats::standard().write(&scene, &Moment::Start)
}

#[test]
fn every_field_is_read() {
    let scene = read(SCENE).expect("in order");
    assert_eq!(scene.method.card().id, "sphere-cull");
    assert_eq!(scene.beside[0].card().id, "box-cull");
    let camera = &scene.camera;
    let places = [[0.0, 2.0, 6.0], [0.0, 1.0, -2.0], [0.0, 1.0, 0.0]];
    assert_eq!(camera.places(), places);
    assert_eq!(camera.opening(), Opening::FovY(40.0));
    assert_eq!((camera.aspect(), camera.depths()), (1.6, [1.0, 12.0]));
    let eye = Orbit::new([0.0, 1.0, 0.0], [-58.0, 24.0], 26.0, 26.0);
    assert_eq!(scene.eye, eye);
    assert_eq!(scene.places().point, [0.5, 1.0, -2.0]);
    assert_eq!((scene.focus(), scene.face()), (1, 2));
    let [cube, wedge, cow] = scene.objects() else {
        panic!("three objects");
    };
    assert_eq!(*cube.model(), Model::Solid(Solid::Cube));
    assert_eq!((cube.turn_deg(), cube.size()), ([0.0, 20.0, 0.0], 0.6));
    assert_eq!(wedge.model().mesh().faces().len(), 4);
    assert_eq!((wedge.at(), wedge.size()), ([0.0; 3], 1.0));
    assert_eq!(cow.model().mesh().faces().len(), 5856, "Spot is shipped");
    let skin = cow.model().skin(cow.model().mesh().faces()[0]);
    assert_eq!(
        skin.map(|it| it.texture.size()),
        Some([1024; 2]),
        "and is painted"
    );
}

#[test]
fn a_parallel_camera_has_a_height_and_a_street_its_boxes() {
    let text = r#"method = "funnel"
camera = { position = [0, 2, 6], target = [0, 1, -2], up = [1, 0, 0], height = 4, aspect = 2, near = -1, far = 12 }
street = { count = 40, seed = 3 }
"#;
    let scene = read(text).expect("in order");
    assert_eq!(scene.camera.opening(), Opening::Height(4.0));
    assert_eq!(scene.objects().len(), 40);
    assert_eq!(read(&written(&scene)), Ok(scene));
}

#[test]
fn where_no_eye_is_given_one_sees_the_whole_volume() {
    let text = SCENE.lines().filter(|line| !line.starts_with("eye"));
    let scene = read(&text.collect::<Vec<_>>().join("\n")).expect("in order");
    let corners = scene.camera.camera().corners_in_world();
    let [position, ..] = scene.camera.places();
    for at in corners.into_iter().chain([position]) {
        let seen = Lens::Eye(scene.eye).drawing_from_world(at);
        let [x, y] = seen.expect("before the eye");
        assert!(x.abs() < 1.0 && y.abs() < 1.0, "{at:?} is seen at {x}, {y}");
    }
}

const BROKEN: &str = r#"
"sphere-cull" => "sphere-cul" => 1:10 unknown-method
compare = "box-cull" => compare = ["box-cull", "funnel"] => 2:11 too-many-beside
"box-cull" => ["box"] => 2:12 unknown-method
camera = => camra = => 3:1 unknown-field
position = [0, 2, 6],  =>  => 3:10 missing-field
position = [0, 2, 6] => position = [0, 2] => 3:23 wrong-length
position = [0, 2, 6] => position = [0, 2, nan] => 3:30 not-finite
[0, 1, -2], fov => [0, 2, 6], fov => 3:43 degenerate
fov_y_deg = 40 => up = [0, 1, 8], fov_y_deg = 40 => 3:60 degenerate
fov_y_deg = 40 => fov_y_deg = 180 => 3:67 degenerate
fov_y_deg = 40 => fov_y_deg = 40, height = 1 => 3:80 two-openings
fov_y_deg = 40,  =>  => 3:10 missing-field
fov_y_deg = 40 => height = 0 => 3:64 degenerate
aspect = 1.6 => aspect = 0 => 3:80 degenerate
near = 1, => near = 0, => 3:92 degenerate
far = 12 => far = 1 => 3:101 degenerate
far = 12 => far = "away" => 3:101 wrong-type
pitch_deg = 24 => pitch_deg = 95 => 4:56 out-of-range
distance = 26 => distance = 0 => 4:71 out-of-range
point = [0.5, 1, -2] => point = [0.5, 1] => 5:9 wrong-length
focus = 1 => focus = 3 => 6:9 no-such-object
focus = 1 => focus = -1 => 6:9 out-of-range
face = 2 => face = 4 => 7:8 no-such-face
"cube" => "cub" => 9:15 unknown-value
size = 0.6 => size = 0 => 9:69 degenerate
size = 0.6 => size = 0.6, opacity = 1.5 => 9:84 out-of-range
at = [0, 1, 0] => at = [0, 1, 1e999] => 9:35 not-finite
solid = "cube",  =>  => 9:5 missing-field
{ mesh = => { solid = "cube", mesh = => 10:30 two-models
name = "wedge",  =>  => 10:14 missing-field
[1, 2, 3] => [1, 2, 4] => 10:133 degenerate
[1, 2, 3] => [1, 2] => 10:133 wrong-length
[1, 2, 3] => [1, 2, 3.5] => 10:140 wrong-type
[0, 0, 0.5] => [0, 0] => 10:77 wrong-length
name = "wedge" => name = "wedge", obj = "f 1" => 10:56 two-meshes
name = "wedge" => name = "wedge", picture = "cow!" => 10:42 no-picture
{ solid = "spot" } => street => 11:5 toml-value
"#;

#[test]
fn every_mistake_has_its_place() {
    for [old, new, expected] in cases(BROKEN) {
        assert!(SCENE.contains(&old), "the scene has no {old:?}");
        let found = read(&SCENE.replacen(&old, &new, 1)).expect_err(&new);
        let expected = format!("a.toml:{expected}");
        assert!(
            found.contains(&expected),
            "{new}: {found:?}, not {expected}"
        );
    }
    let (head, _) = SCENE.split_once("focus").expect("it has a focus");
    let refused = |expected: &str| Err(vec![expected.to_owned()]);
    let none = read(&format!("{head}objects = []\n"));
    assert_eq!(none, refused("a.toml:6:11 no-objects"));
    let two = read(&format!("{SCENE}street = {{ count = 2, seed = 1 }}\n"));
    assert_eq!(two, refused("a.toml:13:10 two-kinds-of-objects"));
}

fn named(name: &str, mesh: Mesh, picture: Option<Picture>) -> Model {
    let name = name.to_owned();
    Model::Mesh(Arc::new(NamedMesh {
        name,
        mesh,
        picture,
    }))
}

/// n × n squares: a mesh as large as one wants.
fn grid(n: u32) -> Mesh {
    let at = |i: u32, j: u32| i * (n + 1) + j;
    let positions =
        (0..=n).flat_map(|i| (0..=n).map(move |j| [i as f32 * 0.1, j as f32 * 0.1, 0.0]));
    let faces = (0..n).flat_map(|i| {
        (0..n).flat_map(move |j| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
    });
    Mesh::new(positions.collect(), Vec::new(), faces.collect()).expect("a grid")
}

#[test]
fn a_mesh_comes_back_however_large_with_its_picture() {
    let mut scene = read(SCENE).expect("in order");
    let painted = include_bytes!("../mesh_file/grey.jpg");
    for (n, picture) in [
        (60, None),
        (60, read_picture(painted)),
        (80, read_picture(painted)),
    ] {
        let model = named("grid", grid(n), picture);
        let object = Object::new(model, [1.0, 2.0, 3.0], [0.0; 3], 0.5);
        scene.set_object(1, object.expect("finite"));
        scene.look_at(Part::Face, 100).expect("it has as many");
        // An OBJ file numbers vertices as faces name them: a mesh that came from one keeps even that.
        let again = read(&written(&scene)).expect("as it was written");
        assert_eq!(read(&written(&again)).as_ref(), Ok(&again));
        let (before, after) = (scene.focused(), again.focused());
        let [n_before, n_after] = [before, after].map(|object| object.model().mesh().faces().len());
        assert_eq!(n_after, n_before);
        assert!((0..(2 * n * n) as usize).all(|i| after.face(i) == before.face(i)));
        let [skin, again] = [before, after].map(|object| object.model().skin([0, 1, 2]));
        assert_eq!(again, skin);
    }
}

#[test]
fn first_scenes_and_names_that_need_quotes_come_back() {
    let first = (LAB.first_scene)();
    let mut scene = first.get::<Scene>().expect("of this lab").clone();
    assert_eq!(read(&written(&scene)).as_ref(), Ok(&scene));
    for name in ["a \"b\" \\ c", "牛", "line\nbreak\t\u{7f}", "x = { }"] {
        let model = named(name, Solid::Tetrahedron.mesh(), None);
        let object = Object::new(model, [0.0; 3], [0.0; 3], 1.0);
        scene.set_object(0, object.expect("finite"));
        assert_eq!(read(&written(&scene)).as_ref(), Ok(&scene));
    }
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -9.0..9.0,
        Just(0.0),
        Just(-0.0),
        Just(1e-7),
        Just(0.1),
        Just(1e15),
        -1e3..1e3
    ]
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(number())
}

fn model() -> impl Strategy<Value = Model> {
    let vertices = prop::collection::vec(prop::array::uniform3(-8f32..8f32), 3..9);
    let meshes =
        (vertices, any::<bool>(), any::<[u8; 6]>()).prop_map(|(positions, has_uvs, picks)| {
            let n = positions.len() as u32;
            let [a, b] = [0, 3].map(|from| [0, 1, 2].map(|i| u32::from(picks[from + i]) % n));
            let uvs = positions.iter().filter(|_| has_uvs);
            let uvs = uvs.map(|&[x, y, _]| [x, y]).collect();
            let mesh = Mesh::new(positions, uvs, vec![a, b]).expect("in order");
            named("m", mesh, None)
        });
    prop_oneof![
        prop::sample::select(Solid::ALL.to_vec()).prop_map(Model::Solid),
        meshes,
    ]
}

fn object() -> impl Strategy<Value = Object> {
    let opacity = prop_oneof![Just(1.0), 0.0..1.0];
    (model(), place(), place(), 0.01..90.0, opacity).prop_map(|(model, at, turn, size, opacity)| {
        let object = Object::new(model, at, turn, size).expect("finite");
        object.with_opacity(opacity).expect("a part of one")
    })
}

prop_compose! {
    fn scenes()(
        methods in any::<[prop::sample::Index; 2]>(),
        places in [place(), place()],
        volume in (any::<bool>(), 0.5..170.0, 0.1..4.0, 0.01..5.0, 0.01..90.0),
        eye in (place(), [-400.0..400.0, -89.0..89.0], 1e-3..1e5, 1.0..120.0),
        objects in prop::collection::vec(object(), 1..6),
        point in place(),
        corners in [place(), place(), place()],
        is_frozen in any::<bool>(),
        picks in any::<[prop::sample::Index; 3]>(),
    ) -> Option<Scene> {
        let known: Vec<Method> = FRUSTUM.all().collect();
        let [method, compare] = methods.map(|index| *index.get(&known));
        let (is_parallel, open, aspect, near, depth) = volume;
        let opening = if is_parallel { Opening::Height(open) } else { Opening::FovY(open) };
        let [position, target] = places;
        let up = [0.1, 1.0, 0.3];
        let camera = TaughtCamera::new([position, target, up], opening, aspect, [near, near + depth]).ok()?;
        let eye = Orbit::new(eye.0, eye.1, eye.2, eye.3);
        let mut scene = Scene::new(method, camera, eye, objects).ok()?;
        scene.beside = [compare].into_iter().filter(|&it| it != method).collect();
        let [a, b, _] = corners;
        scene.set_places(Places { point, segment: [b, a], triangle: corners }).ok()?;
        scene.frozen = if is_frozen { Some(camera.with(|it| it.places = [target, position, up]).ok()?) } else { None };
        scene.look_at(Part::Object, picks[0].index(scene.objects().len())).ok()?;
        let n_faces = scene.focused().model().mesh().faces().len();
        scene.look_at(Part::Face, picks[1].index(n_faces)).ok()?;
        let n_vertices = scene.focused().model().mesh().positions().len();
        scene.look_at(Part::Vertex, picks[2].index(n_vertices)).ok()?;
        Some(scene)
    }
}

proptest! {
    #[test]
    fn what_is_written_is_read_bit_for_bit(scene in scenes()) {
        let Some(scene) = scene else {
            return Ok(());
        };
        let again = read(&written(&scene));
        prop_assert_eq!(again, Ok(scene));
    }
}

/// What is replaced in the lesson, so that it has a mesh.
const WITH_A_MESH: [(&str, &str); 5] = [
    ("\"lines\"", "\"frustum\""),
    ("cohen-sutherland", "sphere-cull"),
    (
        "window = [-1, -1, 1, 1]",
        "camera = { position = [0, 2, 6], target = [0, 1, -2], fov_y_deg = 40, aspect = 1.6, near = 1, far = 12 }",
    ),
    (
        "segments = [[-2, -1, 2, 1.5], [0, 0, 1, 1]]",
        "objects = [{ mesh = \"wedge.obj\", at = [0, 1, 0] }]",
    ),
    ("lock = [\"window\"]\n", ""),
];

const WEDGE: &str = "v 0 0 0\nv 8 0 0\nv 0 4 0\nf 1 2 3\n";

#[test]
fn a_lesson_has_meshes_in_its_folder() {
    let found_in = |file: &str, mesh: &str| {
        let named = [("wedge.obj", file)];
        let mut files = lesson(&[&WITH_A_MESH[..], &named].concat());
        files.insert("01-a/wedge.obj".to_owned(), mesh.into());
        (found(&files), Course::check(&files).course)
    };
    let (problems, course) = found_in("wedge.obj", WEDGE);
    assert!(problems.is_empty(), "{problems:?}");
    let scene = course.lessons[0].steps[0].scene.get::<Scene>();
    let object = scene.expect("of this lab").focused();
    let bounds = object.model().mesh().bounds().expect("it has vertices");
    assert_eq!(bounds.min(), [-1.0, -0.5, 0.0]);
    assert_eq!(bounds.max(), [1.0, 0.5, 0.0]);
    let long_wedge = format!("{WEDGE}f 1 2\n");
    for (file, mesh, expected) in [
        (
            "wedge.obj",
            "v 0 0 0\nf 1 1 2\n",
            "wedge.obj:2:7 no-such-vertex",
        ),
        ("wedge.obj", &long_wedge, "wedge.obj:5:1 face-too-short"),
        ("gone.obj", WEDGE, "lesson.toml:7:21 unreadable"),
        ("../wedge.obj", WEDGE, "lesson.toml:7:21 no-such-mesh"),
        ("wedge.ply", WEDGE, "lesson.toml:7:21 no-such-mesh"),
    ] {
        let (problems, _) = found_in(file, mesh);
        assert!(
            problems.contains(&expected.to_owned()),
            "{file}: {problems:?}"
        );
    }
    let alone = SCENE.replace("solid = \"spot\"", "mesh = \"wedge.obj\"");
    let expected = vec!["a.toml:11:14 no-such-mesh".to_owned()];
    assert_eq!(read(&alone), Err(expected));
}
