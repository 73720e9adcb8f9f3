//! Does a face show its front to the camera? Shown.

use glam::{DVec2, DVec3};
use serde_json::{Value as Json, json};

use crate::{
    algo::{
        cull::{
            BackFace, BackFaceEvent as Event, BackFaceInput, BackFaceOutput,
            BackFaceState as State, Viewer, asked_viewer,
        },
        ring::Right,
    },
    figure::{
        Body, Caption, Cell, Gauge, Gauges, Mark3, Role, Shape3, Table, TableRow, Tick, View,
        Watch, WatchRow, WatchSection,
    },
    geom::Camera,
    labs::{Answer, CodeLine, Demo, Step, code_line, words::name},
    text::{Formula, Message, Value},
    trace::{Algorithm, silent},
};

use super::{
    super::{
        FaceFate, FaceTest, OnScene, OnSceneInput, Scene, Subject,
        demo::SpaceDemo,
        stage::{FaceLook, Fate, face_link},
    },
    planes::{place, triple},
};

type Input = OnSceneInput<BackFaceInput>;
type Shown = OnScene<BackFace>;

const FACES_VIEW: &str = "faces";
const COLUMNS_VIEW: &str = "columns";
/// Of a solid with more faces only the one in hand is measured beside it.
const MOST_FACES: usize = 24;
/// Under more than so many the determinant's columns would have no room.
const MOST_BESIDE_COLUMNS: usize = 12;

/// The normal as it is drawn, as a part of the longer edge at V₀.
const NORMAL_PART: f64 = 0.75;

impl Answer for BackFaceOutput {
    fn json(&self) -> Json {
        json!(self)
    }
}

fn input_of(scene: &Scene, face_idx: usize) -> Option<BackFaceInput> {
    Some(BackFaceInput {
        triangle: scene.focused().face(face_idx)?,
        viewer: asked_viewer::<Right>(scene.culler()),
    })
}

impl SpaceDemo for Shown {
    const SUBJECT: Subject = Subject::Face;
    const TELLS_FACES: bool = true;

    fn input(scene: &Scene) -> Input {
        let own = input_of(scene, scene.face()).expect("the face is one of the object's");
        OnSceneInput::of(scene, own)
    }

    /// Of the face that is asked, at the last step: nothing before it decides.
    fn face_fate(scene: &Scene, face_idx: usize) -> Option<FaceFate> {
        let step = Self::max_events(&Self::input(scene));
        let test = FaceTest::Facing;
        (face_idx == scene.face()).then_some(FaceFate { step, test })
    }
}

impl Demo for Shown {
    const ID: &'static str = "back-face";
    const NAME_KEY: &'static str = "alg-back-face";
    const SOURCE: &'static str = "Sutherland, Sproull & Schumacker, 1974";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-face-normal", "words-face-normal"),
        code_line(0, "code-face-viewer", "words-face-viewer"),
        code_line(0, "code-face-product", "words-face-product"),
        code_line(0, "code-face-decide", "words-face-decide"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Normal { .. } | Event::ToViewer { .. } => Tick::Phase,
            Event::Products { .. } => Tick::Test,
            Event::Done { front: true } => Tick::Accept,
            Event::Done { front: false } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Normal { .. } => 0,
            Event::ToViewer { .. } => 1,
            Event::Products { .. } => 2,
            Event::Done { .. } => 3,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        let say =
            |key: &'static str| Caption::new(Message::new(key).with("face", face_name(input)));
        match *event {
            Event::Normal { edges, normal } => say("face-normal")
                .so(triple("V₁ − V₀", edges[0]))
                .so(triple("V₂ − V₀", edges[1]))
                .so(triple("n", normal)),
            Event::ToViewer { to_viewer } => {
                let key = match input.own.viewer {
                    Viewer::Eye(_) => "face-to-eye",
                    Viewer::Direction(_) => "face-to-direction",
                };
                say(key).so(triple("e", to_viewer))
            }
            Event::Products { dot, det } => {
                let (_, n) = before.normal.unwrap_or_default();
                let e = before.to_viewer.unwrap_or_default();
                say("face-products")
                    .so(dot_formula(n, e, dot))
                    .so(Formula::default()
                        .sym("det = |e, V₁ − V₀, V₂ − V₀|")
                        .equals(det))
            }
            Event::Done { front } => {
                let [dot, _] = before.products.unwrap_or_default();
                let (key, relation) = if front {
                    ("face-front", " > 0")
                } else if dot == 0.0 {
                    ("face-edge-on", "")
                } else {
                    ("face-back", " < 0")
                };
                say(key).so(Formula::default().sym("n·e").equals(dot).sym(relation))
            }
        }
    }

    fn opening(input: &Input) -> Caption {
        let [v0, v1, v2] = input.own.triangle;
        Caption::new(Message::new("face-opening").with("face", face_name(input)))
            .so(triple("V₀", v0))
            .so(triple("V₁", v1))
            .so(triple("V₂", v2))
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let Some(scenery) = step.input.scenery.as_deref() else {
            return Vec::new();
        };
        let scene = scenery.scene();
        let fate = |i: usize| {
            if i == scene.focus() {
                Fate::Kept
            } else {
                Fate::ToCome
            }
        };
        let fronts = fronts(scene);
        let role = |object: usize, face: usize| {
            if object != scene.focus() {
                return FaceLook::Whole;
            }
            if face == scene.face() {
                return FaceLook::Own(Role::Signal);
            }
            match fronts.get(face) {
                Some(false) => FaceLook::Own(Role::Discarded),
                Some(true) | None => FaceLook::Whole,
            }
        };
        let corners = corner_marks(&step.input.own.triangle);
        let gauges = face_gauges(step, scene);
        let columns = (gauges.rows.len() <= MOST_BESIDE_COLUMNS).then(|| columns(step));
        let mut views = vec![
            scenery.observer_with(fate, role, marks(step)),
            scenery.camera(fate, role, corners),
            View::new(FACES_VIEW, Body::Gauges(gauges)),
        ];
        views.extend(columns.map(|columns| View::new(COLUMNS_VIEW, Body::Table(columns))));
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let corners = ["V₀", "V₁", "V₂"].into_iter().zip(step.input.own.triangle);
        let mut rows: Vec<WatchRow> = corners
            .map(|(symbol, at)| WatchRow::new(name(symbol), Some(place(at))))
            .collect();
        let State {
            normal,
            to_viewer,
            products,
            ..
        } = *step.state;
        rows.push(WatchRow::new(name("n"), normal.map(|(_, n)| place(n))));
        rows.push(WatchRow::new(name("e"), to_viewer.map(place)));
        rows.push(WatchRow::new(
            name("n·e"),
            products.map(|[dot, _]| Value::Number(dot)),
        ));
        rows.push(WatchRow::new(
            name("det"),
            products.map(|[_, det]| Value::Number(det)),
        ));
        let on_screen = step.input.scenery.as_deref().and_then(|scenery| {
            let camera = scenery.scene().culler();
            turn_on_screen(camera, &step.input.own.triangle)
        });
        let shown = on_screen.filter(|_| products.is_some());
        rows.push(WatchRow::new(name("det_screen"), shown.map(Value::Number)));
        vec![WatchSection::list(rows)]
    }
}

/// The face's number, and whose it is where a scene has several objects.
fn face_name(input: &Input) -> Value {
    let Some(scenery) = input.scenery.as_deref() else {
        return Value::Count(1);
    };
    let scene = scenery.scene();
    let face = scene.face() + 1;
    if scene.objects().len() == 1 {
        return Value::Count(face);
    }
    let named = Message::new("face-of-object").with("face", face);
    Value::Message(named.with("object", scene.object_name(scene.focus())))
}

/// `n·e = (−9)·8 + (−9)·5 + 9·4 = −81`.
pub fn dot_formula(n: [f64; 3], e: [f64; 3], dot: f64) -> Formula {
    let mut formula = Formula::default().sym("n·e = ");
    for i in 0..3 {
        formula = if i == 0 {
            formula.num(n[i])
        } else {
            formula.sym(" + ").operand(n[i])
        };
        formula = formula.sym(" · ").operand(e[i]);
    }
    formula.equals(dot)
}

/// Which faces of the object in focus show their front, as the same test says.
fn fronts(scene: &Scene) -> Vec<bool> {
    let n_faces = scene.focused().model().mesh().faces().len();
    let faces = (0..n_faces).filter_map(|face_idx| input_of(scene, face_idx));
    faces
        .map(|input| silent::<BackFace>(&input).front)
        .collect()
}

/// (B − A) × (C − A) of the corners on the camera's picture; none where one of them is not before the camera.
fn turn_on_screen(camera: &Camera, triangle: &[[f64; 3]; 3]) -> Option<f64> {
    let clip = triangle.map(|[x, y, z]| camera.clip_from_world().times([x, y, z, 1.0]));
    let is_before = clip.iter().all(|[.., w]| *w > 0.0);
    let [a, b, c] = clip.map(|[x, y, _, w]| DVec2::new(x / w, y / w));
    is_before.then(|| (b - a).perp_dot(c - a))
}

/// The corners with their names.
fn corner_marks(triangle: &[[f64; 3]; 3]) -> Vec<Mark3> {
    let names = ["V₀", "V₁", "V₂"];
    let corner = |(symbol, &at): (&'static str, &[f64; 3])| {
        Mark3::new(Role::Signal, Shape3::Ring(at)).labelled(name(symbol))
    };
    let mut marks = vec![Mark3::new(Role::Signal, Shape3::Outline(triangle.to_vec()))];
    marks.extend(names.into_iter().zip(triangle).map(corner));
    marks
}

/// Normal and way to the camera, from the middle of the face, and the angle between them.
fn marks(step: &Step<'_, Shown>) -> Vec<Mark3> {
    let triangle = &step.input.own.triangle;
    let mut marks = corner_marks(triangle);
    let [a, b, c] = triangle.map(DVec3::from);
    let middle = (a + b + c) / 3.0;
    let mut normal_tip = None;
    if let Some((_, n)) = step.state.normal {
        let size = (b - a).length().max((c - a).length());
        let tip = middle + DVec3::from(n).normalize_or_zero() * NORMAL_PART * size;
        let arrow = Shape3::Arrow([middle.into(), tip.into()]);
        marks.push(Mark3::new(Role::Signal, arrow).labelled(name("n")).strong());
        normal_tip = Some(tip);
    }
    if step.state.to_viewer.is_some() {
        let tip = match step.input.own.viewer {
            Viewer::Eye(eye) => DVec3::from(eye),
            Viewer::Direction(view) => middle - DVec3::from(view) * 2.0,
        };
        let arrow = Shape3::Arrow([middle.into(), tip.into()]);
        marks.push(Mark3::new(Role::Ink, arrow).labelled(name("e")).strong());
        if let Some(normal) = normal_tip {
            let angle = [middle, normal, tip].map(Into::into);
            marks.push(Mark3::new(Role::Signal, Shape3::Angle(angle)));
        }
    }
    marks
}

/// What the determinant is of: the way to the viewer and the two edges, as columns.
fn columns(step: &Step<'_, Shown>) -> Table {
    let symbols = ["det", "e", "V₁ − V₀", "V₂ − V₀"];
    let State {
        normal, to_viewer, ..
    } = *step.state;
    let edges = normal.map(|(edges, _)| edges);
    let columns = [to_viewer, edges.map(|[p, _]| p), edges.map(|[_, q]| q)];
    let is_asked = matches!(step.event, Some(Event::Products { .. }));
    let role = if is_asked { Role::Signal } else { Role::Ink };
    let row = |(axis, symbol): (usize, &'static str)| TableRow {
        name: name(symbol),
        cells: columns
            .map(|column| Cell::new(role, column.map(|at| at[axis])))
            .into(),
        is_current: false,
        link: None,
    };
    Table {
        header: symbols.map(|name| Formula::default().sym(name)).into(),
        rows: ["x", "y", "z"].into_iter().enumerate().map(row).collect(),
        notes: Vec::new(),
    }
}

/// n·e of all faces, the one in hand once its run has come so far.
fn face_gauges(step: &Step<'_, Shown>, scene: &Scene) -> Gauges {
    let n_faces = scene.focused().model().mesh().faces().len();
    let shown = if n_faces <= MOST_FACES {
        0..n_faces
    } else {
        scene.face()..scene.face() + 1
    };
    let row = |face_idx: usize| {
        let is_current = face_idx == scene.face();
        let answer = input_of(scene, face_idx).map(|input| silent::<BackFace>(&input));
        let answer = answer.filter(|_| !is_current || step.state.products.is_some());
        let role = match answer {
            _ if is_current => Role::Signal,
            Some(BackFaceOutput { front: true, .. }) => Role::Accent,
            Some(_) | None => Role::Discarded,
        };
        Gauge {
            name: Value::Count(face_idx + 1),
            value: answer.map(|answer| answer.dot),
            verdict: answer.map(|answer| {
                Message::new(if answer.front {
                    "gauge-drawn"
                } else {
                    "gauge-culled"
                })
            }),
            role,
            is_bar: true,
            link: Some(face_link(face_idx)),
        }
    };
    Gauges {
        title: Message::new("gauges-faces").with("faces", n_faces),
        sides: [
            Message::new("gauge-away"),
            Message::new("gauge-faces-camera"),
        ],
        band: None,
        rows: shown.map(row).collect(),
    }
}
