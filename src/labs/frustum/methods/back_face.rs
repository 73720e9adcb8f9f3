//! Does a face show its front to the camera? Shown.

use crate::{
    algo::cull::{BackFaceEvent as Event, BackFaceOutput, Viewer},
    figure::Tick,
    labs::frustum::prelude::*,
};
use glam::DVec2;

use super::asked::place;

const FACES_VIEW: &str = "faces";
const COLUMNS_VIEW: &str = "columns";
/// Of a solid with more faces only the one in hand is measured beside it.
const MOST_FACES: usize = 24;
/// Under more than so many the determinant's columns would have no room.
const MOST_BESIDE_COLUMNS: usize = 12;

/// The normal as it is drawn, as a part of the longer edge at V₀.
const NORMAL_PART: f64 = 0.75;

impl AnswerAsItIs for BackFaceOutput {}

fn input_of(scene: &Scene, face_idx: usize) -> Option<BackFaceInput> {
    Some(BackFaceInput {
        triangle: scene.focused().face(face_idx)?,
        viewer: asked_viewer::<Right>(scene.culler()),
    })
}

impl SpaceTelling for BackFace {
    const SUBJECT: Subject = Subject::Face;
    const TELLS_FACES: bool = true;

    fn input(scene: &Scene) -> BackFaceInput {
        input_of(scene, scene.face()).expect("the face is one of the object's")
    }
}

/// Which way the face looks; the product before it tells that.
const fn faced(tick: Tick, key: &'static str) -> Row {
    Row::new(tick, 3, key).answers("facing").before_its_phase()
}

impl Telling for BackFace {
    type Scenery = Scenery;

    const ID: &'static str = "back-face";
    const NAME_KEY: &'static str = "alg-back-face";
    const SOURCE: &'static str = "Sutherland, Sproull & Schumacker, 1974";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-face-normal", "words-face-normal"),
        code_line(0, "code-face-viewer", "words-face-viewer"),
        code_line(0, "code-face-product", "words-face-product"),
        code_line(0, "code-face-decide", "words-face-decide"),
    ];

    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "V₀",
        "V₁",
        "V₂",
        "n",
        "e",
        "n·e",
        "det",
        "det_screen",
    ])];
    const OPENING: Row =
        Row::new(Phase, 0, "face-opening").so(&["V₀ = {V₀}", "V₁ = {V₁}", "V₂ = {V₂}"]);

    table! { |event, step|
        normal: Event::Normal { .. } =>
            Row::new(Phase, 0, "face-normal")
                .so(&["V₁ − V₀ = {V₁ − V₀}", "V₂ − V₀ = {V₂ − V₀}", "n = {n}"]);
        to_eye: Event::ToViewer { .. } if matches!(step.input.viewer, Viewer::Eye(_)) =>
            Row::new(Phase, 1, "face-to-eye").so(&["e = {e}"]);
        to_direction: Event::ToViewer { .. } =>
            Row::new(Phase, 1, "face-to-direction").so(&["e = {e}"]);
        products: Event::Products { .. } =>
            Row::new(Test, 2, "face-products").so(&["{dot}", "det = |e, V₁ − V₀, V₂ − V₀|{=det}"]);
        front: Event::Done { front: true } =>
            faced(Accept, "face-front").so(&["n·e{=n·e} > 0"]).keeps("face");
        edge_on: Event::Done { .. } if step.held.dot == 0.0 =>
            faced(Reject, "face-edge-on").so(&["n·e{=n·e}"]).drops("face");
        back: Event::Done { .. } =>
            faced(Reject, "face-back").so(&["n·e{=n·e} < 0"]).drops("face");
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (known, triangle) = (Known::of(at.step.past), at.step.input.triangle);
        let [v0, v1, v2] = triangle.map(place);
        Some(match name {
            "face" => face_name(at),
            "V₀" => v0.into(),
            "V₁" => v1.into(),
            "V₂" => v2.into(),
            "V₁ − V₀" => place(known.edges?[0]).into(),
            "V₂ − V₀" => place(known.edges?[1]).into(),
            "n" => Named::maybe(known.normal.map(place)),
            "e" => Named::maybe(known.to_viewer.map(place)),
            "n·e" => Named::maybe(known.products.map(|[dot, _]| dot)),
            "det" => Named::maybe(known.products.map(|[_, det]| det)),
            "det_screen" => {
                let scenery = at.scenery.filter(|_| known.products.is_some());
                let turn = |scenery: &Scenery| turn_on_screen(scenery.scene().culler(), &triangle);
                Named::maybe(scenery.and_then(turn))
            }
            "dot" => dot_formula(known.normal?, known.to_viewer?, known.products?[0]).into(),
            _ => return None,
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let Some(scenery) = at.scenery else {
            return Vec::new();
        };
        let known = Known::of(at.step.past);
        let scene = scenery.scene();
        let is_kept = |i: usize| i == scene.focus();
        let fate = |i: usize| if is_kept(i) { Fate::Kept } else { Fate::ToCome };
        let answers = answers(scene);
        let role = |object: usize, face: usize| {
            if object != scene.focus() {
                return FaceLook::Whole;
            }
            if face == scene.face() {
                return FaceLook::Own(Role::Signal);
            }
            let is_away = answers.get(face).is_some_and(|answer| !answer.front);
            let pale = is_away.then_some(FaceLook::Own(Role::Discarded));
            pale.unwrap_or(FaceLook::Whole)
        };
        let corners = corner_marks(&at.step.input.triangle);
        let arrows = arrows(at.step.input, at.step.past);
        let gauges = face_gauges(&known, scene, &answers);
        let columns = (gauges.rows.len() <= MOST_BESIDE_COLUMNS).then(|| columns(at, &known));
        let mut views = vec![
            scenery.observer_with(fate, role, [&corners[..], &arrows].concat()),
            scenery.camera(fate, role, corners),
            View::new(FACES_VIEW, Body::Gauges(gauges)),
        ];
        views.extend(columns.map(|columns| View::new(COLUMNS_VIEW, Body::Table(columns))));
        views
    }
}

#[derive(Default)]
struct Known {
    /// From V₀ to V₁ and to V₂.
    edges: Option<[[f64; 3]; 2]>,
    normal: Option<[f64; 3]>,
    to_viewer: Option<[f64; 3]>,
    /// n·e and the determinant.
    products: Option<[f64; 2]>,
}

impl Known {
    fn of(past: &[Event]) -> Self {
        let mut known = Self::default();
        for event in past {
            match *event {
                Event::Normal { edges, normal } => {
                    (known.edges, known.normal) = (Some(edges), Some(normal));
                }
                Event::ToViewer { to_viewer } => known.to_viewer = Some(to_viewer),
                Event::Products { dot, det } => known.products = Some([dot, det]),
                Event::Done { .. } => {}
            }
        }
        known
    }
}

fn face_name(at: &At<'_, BackFace>) -> Named {
    let Some(scenery) = at.scenery else {
        return Value::Count(1).into();
    };
    let scene = scenery.scene();
    let face = scene.face() + 1;
    let mut named = Named::from(face);
    if scene.objects().len() > 1 {
        let of_object = Message::new("face-of-object").with("face", face);
        named = of_object
            .with("object", scene.object_name(scene.focus()))
            .into();
    }
    named.linked(face_link(scene.face()))
}

/// `n·e = (−9)·8 + (−9)·5 + 9·4 = −81`.
pub fn dot_formula(n: [f64; 3], e: [f64; 3], dot: f64) -> Formula {
    sum_of(sym("n·e = "), n.into_iter().zip(e), times).equals(dot)
}

fn answers(scene: &Scene) -> Vec<BackFaceOutput> {
    let faces = 0..scene.focused().model().mesh().faces().len();
    let faces = faces.filter_map(|face_idx| input_of(scene, face_idx));
    faces.map(|input| silent::<BackFace>(&input)).collect()
}

/// (B − A) × (C − A) of the corners on the camera's picture; none where one of them is not before the camera.
fn turn_on_screen(camera: &Camera, triangle: &[[f64; 3]; 3]) -> Option<f64> {
    let clip = triangle.map(|[x, y, z]| camera.clip_from_world().times([x, y, z, 1.0]));
    let is_before = clip.iter().all(|[.., w]| *w > 0.0);
    let [a, b, c] = clip.map(|[x, y, _, w]| DVec2::new(x / w, y / w));
    is_before.then(|| (b - a).perp_dot(c - a))
}

fn corner_marks(triangle: &[[f64; 3]; 3]) -> Vec<Mark3> {
    let names = ["V₀", "V₁", "V₂"];
    let corner = |(symbol, &at): (&'static str, &[f64; 3])| {
        Mark3::new(Role::Signal, Shape3::Ring(at)).labelled(name(symbol))
    };
    let mut marks = vec![Mark3::new(Role::Signal, Shape3::Outline(triangle.to_vec()))];
    marks.extend(names.into_iter().zip(triangle).map(corner));
    marks
}

/// e from a corner, and where it ends: at the eye, or a part along the one direction.
pub fn to_viewer(from: DVec3, viewer: Viewer) -> (DVec3, Mark3) {
    let tip = match viewer {
        Viewer::Eye(eye) => eye.into(),
        Viewer::Direction(view) => from - DVec3::from(view) * 2.0,
    };
    let arrow = Shape3::Arrow([from, tip].map(Into::into));
    (
        tip,
        Mark3::new(Role::Ink, arrow).labelled(name("e")).strong(),
    )
}

/// n and e, from V₀, as they have been computed.
pub fn arrows(input: &BackFaceInput, past: &[Event]) -> Vec<Mark3> {
    let (known, mut marks) = (Known::of(past), Vec::new());
    let [a, b, c] = input.triangle.map(DVec3::from);
    let mut normal_tip = None;
    if let Some(n) = known.normal {
        let size = (b - a).length().max((c - a).length());
        let tip = a + DVec3::from(n).normalize_or_zero() * NORMAL_PART * size;
        let arrow = Shape3::Arrow([a.into(), tip.into()]);
        marks.push(Mark3::new(Role::Signal, arrow).labelled(name("n")).strong());
        normal_tip = Some(tip);
    }
    if known.to_viewer.is_some() {
        let (tip, arrow) = to_viewer(a, input.viewer);
        marks.push(arrow);
        if let Some(normal) = normal_tip {
            let degrees = (normal - a).angle_between(tip - a).to_degrees();
            let angle = Shape3::Angle([a, normal, tip].map(Into::into));
            let angle = Mark3::new(Role::Signal, angle);
            // Its number is the answer.
            let is_told = known.products.is_some();
            marks.push(if is_told {
                angle.labelled(sym(format!("{degrees:.0}°")))
            } else {
                angle
            });
        }
    }
    marks
}

fn columns(at: &At<'_, BackFace>, known: &Known) -> Table {
    // Beside its columns what the determinant comes to: the dot product's number.
    let det = known.products.map(|[_, det]| sym("det").equals(det));
    let symbols = ["e", "V₁ − V₀", "V₂ − V₀"].map(sym);
    let edge = |i: usize| known.edges.map(|edges| edges[i]);
    let columns = [known.to_viewer, edge(0), edge(1)];
    let is_asked = matches!(at.step.event(), Some(Event::Products { .. }));
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
        header: (std::iter::once(det.unwrap_or_else(|| sym("det"))).chain(symbols)).collect(),
        rows: ["x", "y", "z"].into_iter().enumerate().map(row).collect(),
        notes: Vec::new(),
    }
}

/// n·e of all faces, the one in hand once its run has come so far.
fn face_gauges(known: &Known, scene: &Scene, answers: &[BackFaceOutput]) -> Gauges {
    let n_faces = answers.len();
    let all = n_faces <= MOST_FACES;
    let shown = (0..n_faces).filter(|&i| all || i == scene.face());
    let words = ["gauge-culled", "gauge-drawn"];
    let word = |is_front| Message::new(words[usize::from(is_front)]);
    let row = |face_idx: usize| {
        let is_current = face_idx == scene.face();
        let answer = answers.get(face_idx);
        let answer = answer.filter(|_| !is_current || known.products.is_some());
        let role = match answer {
            _ if is_current => Role::Signal,
            Some(BackFaceOutput { front: true, .. }) => Role::Accent,
            Some(_) | None => Role::Discarded,
        };
        Gauge {
            name: Value::Count(face_idx + 1),
            value: answer.map(|answer| answer.dot),
            verdict: answer.map(|answer| word(answer.front)),
            role,
            is_bar: true,
            link: Some(face_link(face_idx)),
        }
    };
    Gauges {
        title: Message::new("gauges-faces").with("faces", n_faces),
        sides: ["gauge-away", "gauge-faces-camera"].map(Message::new),
        band: None,
        rows: shown.map(row).collect(),
    }
}
