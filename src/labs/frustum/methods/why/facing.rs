//! Why n·e > 0, shown: every face edge-on on one bar, its normal upwards, and the eye above or below it.

use crate::{
    algo::why::{Facing, FacingFact as Fact, FacingInput, Shown, Why},
    figure::Weight,
    labs::{
        frustum::prelude::*,
        why::{Picture, around, fact, mark, segment},
    },
};

use super::super::{
    asked::place,
    back_face::{dot_formula, to_viewer},
};

/// Of a solid with more faces those are laid on the bar that are nearest to edge-on.
const MOST_BESIDE: usize = 11;

impl SpaceTelling for Why<Facing> {
    const SUBJECT: Subject = Subject::Face;
    const TELLS_FACES: bool = true;

    fn input(scene: &Scene) -> FacingInput {
        let object = scene.focused();
        let n_faces = object.model().mesh().faces().len();
        let mut input = FacingInput {
            faces: (0..n_faces).filter_map(|face| object.face(face)).collect(),
            first: scene.face(),
            others: Vec::new(),
            viewer: asked_viewer::<Right>(scene.culler()),
        };
        let mut others: Vec<usize> = (0..n_faces).filter(|&face| face != input.first).collect();
        others.sort_by(|&a, &b| height(&input, a).abs().total_cmp(&height(&input, b).abs()));
        others.truncate(MOST_BESIDE);
        others.sort_unstable();
        input.others = others;
        input
    }
}

fn height(input: &FacingInput, face: usize) -> f64 {
    let (_, dot) = input.measured::<f64>(face);
    dot / input.length(face).max(f64::MIN_POSITIVE)
}

const NAMES: [(&str, Fact); 4] = [
    ("n·e", Fact::Product),
    ("|n|", Fact::Length),
    ("height", Fact::Height),
    ("fronts", Fact::Fronts),
];

impl Telling for Why<Facing> {
    type Scenery = Scenery;

    const ID: &'static str = "why-facing";
    const NAME_KEY: &'static str = "why-facing";
    const SOURCE: &'static str = "Sutherland, Sproull & Schumacker, 1974";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-product", "why-words-product"),
        code_line(0, "why-code-height", "why-words-height"),
        code_line(0, "why-code-bar", "why-words-bar"),
        code_line(0, "why-code-front", "why-words-front"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["n", "e", "n·e", "|n|"]),
        Watched::List("heights"),
    ];
    const OPENING: Row = Row::new(Phase, 0, "why-facing-opening").so(&["n = {n}", "e = {e}"]);

    table! { |event, step|
        product: Shown { fact: Fact::Product, .. } => Row::new(Test, 0, "why-facing-product").so(&["{dot}"]);
        length: Shown { fact: Fact::Length, number } if number > 0.0 =>
            Row::new(Test, 1, "why-facing-length").so(&["|n|{=|n|}"]);
        no_length: Shown { fact: Fact::Length, .. } =>
            Row::new(Reject, 1, "why-facing-no-length").so(&["|n|{=|n|}"]);
        above: Shown { fact: Fact::Height, number } if number > 0.0 =>
            Row::new(Test, 1, "why-facing-above").so(&["~ {n·e / |n|}{=height}", "{angle}° < 90°"]);
        below: Shown { fact: Fact::Height, .. } =>
            Row::new(Test, 1, "why-facing-below").so(&["~ {n·e / |n|}{=height}", "{angle}° ≥ 90°"]);
        other_above: Shown { fact: Fact::Face { .. }, number } if number > 0.0 =>
            Row::new(Test, 2, "why-facing-other-above").so(&["~ {n·e of it / |n| of it}{=number}"]);
        other_below: Shown { fact: Fact::Face { .. }, .. } =>
            Row::new(Test, 2, "why-facing-other-below").so(&["~ {n·e of it / |n| of it}{=number}"]);
        fronts: Shown { fact: Fact::Fronts, .. } => Row::new(Accept, 3, "why-facing-fronts");
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let input = at.step.input;
        let face = match at.step.event().map(|shown| shown.fact) {
            Some(Fact::Face { face }) => face,
            Some(Fact::Product | Fact::Length | Fact::Height | Fact::Fronts) | None => input.first,
        };
        let ([n, e], dot) = input.measured::<f64>(face);
        Some(match name {
            "n" => place(n).into(),
            "e" => place(e).into(),
            "face" => Named::from(Value::Count(face + 1)).linked(face_link(face)),
            "faces" => (input.others.len() + 1).into(),
            "fronts" => Value::Count(fact(&at.step, &NAMES, name)? as usize).into(),
            "dot" => dot_formula(n, e, fact(&at.step, &NAMES, "n·e")?).into(),
            "angle" => Formula::decimals().num(angle(input, face)).into(),
            "n·e of it" => dot.into(),
            "|n| of it" => input.length(face).into(),
            "number" => at.step.event()?.number.into(),
            _ => fact(&at.step, &NAMES, name)?.into(),
        })
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let input = at.step.input;
        let first = (Fact::Height, input.first);
        let others = input.others.iter().map(|&face| (Fact::Face { face }, face));
        let named = |(fact, face): (Fact, usize)| {
            let number = Named::from(Formula::decimals().num(at.step.held.get(fact)?));
            Some(
                number
                    .labelled(Value::Count(face + 1))
                    .linked(face_link(face)),
            )
        };
        [first]
            .into_iter()
            .chain(others)
            .filter_map(named)
            .collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let scene = scenery.scene();
            let look = |object: usize, face: usize| {
                let is_first = object == scene.focus() && face == scene.face();
                if is_first {
                    FaceLook::Own(Role::Signal)
                } else {
                    FaceLook::Whole
                }
            };
            let input = at.step.input;
            let corners = &input.faces[input.first];
            let (_, arrow) = to_viewer(corners[0].into(), input.viewer);
            let outline = Mark3::new(Role::Signal, Shape3::Outline(corners.to_vec()));
            let marks = vec![outline.linked(face_link(input.first)), arrow];
            views.push(scenery.observer_with(|_| Fate::ToCome, look, marks));
        }
        views.push(bar(at));
        views
    }
}

/// Between n and e, in degrees.
fn angle(input: &FacingInput, face: usize) -> f64 {
    let ([n, e], _) = input.measured::<f64>(face);
    DVec3::from(n).angle_between(e.into()).to_degrees()
}

/// Where the eye is over the bar: e, turned about the normal into the picture, to the side that keeps the eyes apart.
fn eye_over(input: &FacingInput, face: usize, nth: usize) -> [f64; 2] {
    let ([_, e], _) = input.measured::<f64>(face);
    let up = height(input, face);
    let aside = (DVec3::from(e).length_squared() - up * up).max(0.0).sqrt();
    [if nth.is_multiple_of(2) { -aside } else { aside }, up]
}

fn bar(at: &At<'_, Why<Facing>>) -> View {
    let input = at.step.input;
    let all = [input.first]
        .into_iter()
        .chain(input.others.iter().copied());
    let eyes: Vec<(usize, [f64; 2])> = all
        .enumerate()
        .map(|(nth, face)| (face, eye_over(input, face, nth)))
        .collect();
    let reach = eyes
        .iter()
        .flat_map(|(_, at)| at.map(f64::abs))
        .fold(1e-9, f64::max);
    let bounds = around(
        eyes.iter()
            .map(|(_, at)| *at)
            .chain([[-reach, 0.0], [reach, 0.5 * reach]]),
    );
    let [[left, _], [right, _]] = bounds;
    let tip = [0.0, 0.3 * reach];
    let half = 0.12 * reach;
    let given = vec![
        mark(Role::Ink, Shape::Wash([[left, 0.0], [right, 0.0]])),
        segment(Role::Soft, [left, 0.0], [right, 0.0]),
        segment(Role::Ink, [-half, 0.0], [half, 0.0]).weighing(Weight::of(6.0)),
        mark(Role::Ink, Shape::Arrow([[0.0, 0.0], tip]))
            .labelled(name("n"))
            .strong(),
    ];
    let mut picture = Picture::new(&at.step, given);
    for (nth, &(face, eye)) in eyes.iter().enumerate() {
        let is_first = nth == 0;
        let (shown, kept) = match (is_first, eye[1] > 0.0) {
            (true, _) => (Fact::Height, Role::Ink),
            (false, true) => (Fact::Face { face }, Role::Accent),
            (false, false) => (Fact::Face { face }, Role::Discarded),
        };
        picture.once(shown, kept, |role, _| {
            let label = Formula::default().sym(format!("{}: ", face + 1));
            let (_, dot) = input.measured::<f64>(face);
            let label = label.num(dot);
            let disc = mark(role, Shape::dot_or_ring(eye[1] > 0.0, eye)).labelled(label);
            let sight = segment(role, [0.0, 0.0], eye);
            let drop = segment(Role::Faint, eye, [eye[0], 0.0]);
            let angle = mark(role, Shape::Angle([[0.0, 0.0], tip, eye]));
            let degrees = Formula::decimals().num(self::angle(input, face)).sym("°");
            let angle = is_first.then(|| angle.labelled(degrees));
            [sight, drop, disc.strong().linked(face_link(face))]
                .into_iter()
                .chain(angle)
        });
    }
    picture.view("why-view-bar", bounds)
}
