//! A third lab, as small as can be and in three dimensions, handed in through the tables alone: it goes through file, run,
//! figure, window and case, and nothing else in the house knows of it.

mod corners;
mod lab;

use egui::{MouseWheelSource, MouseWheelUnit, TouchPhase};

use super::*;
use crate::{
    case::{Detail, Format, Solver, Solvers, Style, trace},
    export,
    figure::{Body, Run, project},
    lesson::{SceneFormat, SceneFormats, Severity},
};

use corners::corner;
use lab::{BoxPanel, BoxScene, CLICKED, FORMAT, LAB, N_RECORDED, SOLVERS};

fn kit() -> Kit {
    static FORMATS: [&SceneFormat; 1] = [&FORMAT];
    Kit {
        panels: vec![Box::new(BoxPanel)],
        formats: SceneFormats(&FORMATS),
    }
}

const TOML: &str = r#"
lab = "boxes"
source = "kept under tests"

[scenes.box]
method = "box-corners"
half = 1.0
c = 0.5

[[step]]
id = "second"
scene = "box"
at = "corner #2"
lock = ["box"]
"#;

const TEXT: &str = "# A box\n\n## second: The second corner\n\nIt is inside.\n";

fn bench() -> Bench {
    let app = App::with_kit(Course::default(), Settings::default(), kit());
    Bench::with(app, SIZE)
}

fn half(bench: &Bench) -> f64 {
    bench.scene::<BoxScene>().half
}

#[test]
fn its_lessons_are_read_and_its_scenes_written() {
    let lesson = [("01-box/lesson.toml", TOML), ("01-box/en.md", TEXT)];
    let files = lesson.map(|(path, text)| (path.to_owned(), text.into()));
    let loaded = Course::check_with(&BTreeMap::from(files), kit().formats);
    let problems = loaded.problems.iter();
    let mut errors = problems.filter(|problem| problem.severity == Severity::Error);
    assert_eq!(errors.next(), None);
    let step = &loaded.course.lessons[0].steps[0];
    assert_eq!(step.moment.to_string(), "corner #2");
    let written = kit().formats.write(&step.scene, &step.moment);
    let again = kit().formats.read("box.toml", written.as_bytes());
    let again = again.expect("as it was written");
    assert_eq!(again.scene, *step.scene);
    assert_eq!(Some(again.position), step.position());
    let broken = kit().formats.read("box.toml", b"half = \"wide\"\nc = 0");
    assert_eq!(broken.expect_err("a word is no number").len(), 1);
}

#[test]
fn its_run_is_stepped() {
    let runs = (LAB.first_scene)().document().record();
    let run: &dyn Run = &*runs[0];
    assert_eq!(run.n_steps(), 9);
    let third: Moment = "corner #3".parse().expect("a moment");
    assert_eq!(run.find(&third), Some(3));
    assert_eq!(run.output_json()["n_inside"], 4);
}

#[test]
fn its_figure_is_a_cube_with_hidden_edges_dashed() {
    let scene = (LAB.first_scene)();
    let frame = scene.document().record()[0].frame(1);
    let Body::Space(space) = &frame.views[0].body else {
        panic!("space first, not {:?}", frame.views[0].id);
    };
    let marks = project(space, &space.seer.into());
    assert_eq!(marks.iter().filter(|mark| mark.is_dashed).count(), 3);
    let picture = |step| export::Picture {
        scene: &scene,
        lesson: None,
        step,
        before: None,
        foot: None,
        options: export::Options {
            lang: Lang::En,
            theme: ThemeKind::Light,
            size_px: [1280, 720],
            steps: export::Steps::Figures,
            asks: false,
        },
        title: None,
    };
    let mut studio = export::Studio::new(ThemeKind::Light);
    let image = studio.draw(&picture(1));
    let before = N_RECORDED.get();
    let steps: Vec<_> = (0..=9).map(|step| studio.draw(&picture(step))).collect();
    assert_eq!(N_RECORDED.get(), before, "the run is there already");
    assert!(steps[1].to_png() == image.to_png() && steps[2].to_png() != image.to_png());
    let png = image.to_png();
    assert!(png.len() > 2_000, "{} bytes: something is drawn", png.len());
    if let Some(folder) = std::env::var_os("CLIPSCOPE_SAMPLES") {
        std::fs::write(std::path::Path::new(&folder).join("third-lab.png"), png).unwrap();
    }
}

#[test]
fn its_window_turns_steps_drags_and_undoes() {
    let mut bench = bench();
    assert_eq!(bench.document().lab(), LAB);
    bench.key(Key::ArrowRight);
    assert_eq!(bench.app.position(), 1);
    let before = bench.on_screen([1.0, 1.0]);
    let empty = bench.on_screen([-1.85, 0.0]);
    bench.drag(empty, empty + vec2(60.0, 0.0));
    let after = bench.on_screen([1.0, 1.0]);
    assert_ne!(after, before, "the eye went round");
    bench.command(Command::FitView);
    assert_eq!(bench.on_screen([1.0, 1.0]), before, "and back");
    let [from, to] = [1.0, 1.5].map(|x| bench.on_screen([x, 0.0]));
    bench.drag(from, to);
    assert!((half(&bench) - 1.5).abs() < 0.1, "{}", half(&bench));
    bench.command(Command::Undo);
    assert_eq!(half(&bench), 1.0);
    assert_eq!(corner(1.0, 7), [1.0; 3]);
}

#[test]
fn its_eye_comes_nearer_goes_sideways_and_knows_what_is_clicked() {
    let mut bench = bench();
    let [middle, side] = [0.0, 1.0].map(|y| bench.on_screen([0.0, y]));
    bench.tap(middle);
    assert_eq!(CLICKED.get(), Some(Link::to("face")));
    let beside = middle + vec2(1.6 * (side.y - middle.y), 0.0);
    bench.tap(beside);
    assert_eq!(CLICKED.get(), None, "nothing is there");
    let wheel = Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        source: MouseWheelSource::Wheel,
        delta: vec2(0.0, 80.0),
        phase: TouchPhase::Move,
        modifiers: Modifiers::NONE,
    };
    bench.frame(0.02, vec![Event::PointerMoved(middle), wheel]);
    bench.settle();
    let nearer = bench.on_screen([0.0, 1.0]);
    assert!(nearer.y < side.y - 1.0, "{nearer:?}, not over {side:?}");
    let before = bench.on_screen([0.0, 0.0]);
    let shift = |pressed| Event::PointerButton {
        pos: beside,
        button: PointerButton::Middle,
        pressed,
        modifiers: Modifiers::NONE,
    };
    bench.frame(0.02, vec![Event::PointerMoved(beside), shift(true)]);
    let to = beside + vec2(40.0, -20.0);
    bench.point(to);
    bench.frame(0.02, vec![shift(false)]);
    let moved = bench.on_screen([0.0, 0.0]) - before;
    assert!((moved - vec2(40.0, -20.0)).length() < 1.0, "{moved:?}");
}

#[test]
fn its_tab_opens_it_and_an_unknown_one_opens_nothing() {
    let mut bench = bench();
    let before: Scene = bench.app.scene().clone();
    bench.command(Command::Lab("lines"));
    assert_eq!(*bench.app.scene(), before);
    bench.command(Command::Lab(LAB.id));
    assert_eq!(*bench.app.scene(), before);
}

#[test]
fn its_cases_are_answered_and_refused() {
    static TABLES: [&[Solver]; 1] = [&SOLVERS];
    let cases = b"{\"algorithm\": \"box-corners\", \"half\": 2, \"c\": -2}\n{\"algorithm\": \"liang-barsky\"}\n";
    let style = Style {
        format: Format::Json,
        detail: Detail::Answers,
        lang: Lang::En,
    };
    let mut answers = Vec::new();
    let solvers = Solvers::new(&TABLES);
    trace(solvers, &cases[..], &mut answers, style, |_| {}).expect("written");
    let answers = String::from_utf8(answers).expect("text");
    let lines: Vec<&str> = answers.lines().collect();
    assert!(lines[0].contains("{\"n_inside\":8}"), "{answers}");
    assert!(lines[1].contains("unknown-algorithm"), "{answers}");
}
