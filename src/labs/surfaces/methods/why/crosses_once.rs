//! Why the far side of a plane hides nothing of the near one, shown: the distance from the plane along two lines of sight.
//!
//! ```text
//!  eye ●╲╲
//!      │  ╲ ╲───● Q        both ends above 0: all between is, too
//!   0 ─┼───╲○──────        to R it is 0 once
//!      │     ╲─● R
//! ```

use crate::{
    algo::{
        volume::signed_distance,
        why::{CrossesOnce, CrossesOnceFact as Fact, CrossesOnceInput, Shown, Why},
    },
    geom::Plane,
    labs::{
        space::{
            prelude::*,
            soup::{surface_name, surfaces_on_raster},
        },
        why::{Picture, fact, mark, segment},
    },
};
use glam::DVec3;

use super::super::planes::{plane_marks, plane_of};

/// How large the drawing is.
const SIZE: [f64; 2] = [1.8, 1.5];

/// The first triangle of the scene and its plane, and one on either side of it, by its middle.
struct Found {
    input: CrossesOnceInput,
    own: Option<u32>,
    other: Option<u32>,
}

fn found(scene: &Scene) -> Found {
    let surfaces = surfaces_on_raster(scene);
    let eye = [0.0; 3];
    let distance = |plane: &Plane, at: [f64; 3]| signed_distance::<f64>(plane, at);
    let plane = plane_of(&surfaces, 0).and_then(|plane| {
        let far = distance(&plane, eye);
        if far == 0.0 {
            None
        } else {
            Some(if far < 0.0 { plane.turned() } else { plane })
        }
    });
    let middle = |id: u32| -> Option<[f64; 3]> {
        let corners = surfaces.triangles().get(id as usize)?;
        Some((corners.map(DVec3::from).iter().sum::<DVec3>() / 3.0).into())
    };
    // Whole on one side: the plane of the first cuts none of them.
    let is_on = |id: u32, sign: f64| {
        let corners = surfaces.triangles().get(id as usize);
        let is_beyond = |plane: &Plane, at: &[f64; 3]| sign * distance(plane, *at) > 0.0;
        corners
            .zip(plane)
            .is_some_and(|(corners, plane)| corners.iter().all(|at| is_beyond(&plane, at)))
    };
    let [own, other] = [1.0, -1.0].map(|sign| surfaces.ids().skip(1).find(|&id| is_on(id, sign)));
    let input = CrossesOnceInput {
        plane,
        eye,
        own: own.and_then(middle),
        other: other.and_then(middle),
    };
    Found { input, own, other }
}

impl SpaceTelling for Why<CrossesOnce> {
    const SUBJECT: Subject = Subject::Surfaces;
    const MOST_FACES: usize = 300;

    fn input(scene: &Scene) -> CrossesOnceInput {
        found(scene).input
    }
}

const NAMES: [(&str, Fact); 5] = [
    ("d(E)", Fact::Eye),
    ("d(Q)", Fact::Own),
    ("least", Fact::Least),
    ("d(R)", Fact::Other),
    ("crossing", Fact::Crossing),
];

impl Telling for Why<CrossesOnce> {
    type Scenery = Scenery;

    const ID: &'static str = "why-crosses-once";
    const NAME_KEY: &'static str = "why-crosses-once";
    const SOURCE: &'static str = "Fuchs, Kedem & Naylor, 1980";
    const IS_PROOF: bool = true;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "why-code-eye", "why-words-eye"),
        code_line(0, "why-code-own", "why-words-own"),
        code_line(0, "why-code-other", "why-words-other"),
        code_line(0, "why-code-order", "why-words-order"),
    ];
    const WATCH: &'static [Watched] = &[Watched::Names(&["d(E)", "d(Q)", "d(R)"])];
    const OPENING: Row = Row::new(Phase, 0, "why-once-opening");

    table! { |event, step|
        no_sides: Shown { fact: Fact::NoSides, .. } => Row::new(Reject, 0, "why-once-no-sides");
        eye: Shown { fact: Fact::Eye, .. } => Row::new(Test, 0, "why-once-eye").so(&["~ d{=d(E)}"]);
        own: Shown { fact: Fact::Own, .. } => Row::new(Test, 1, "why-once-own").so(&["~ d{=d(Q)} > 0"]);
        least: Shown { fact: Fact::Least, .. } =>
            Row::new(Accept, 3, "why-once-least").so(&["~ d ≥ {least} > 0"]);
        other: Shown { fact: Fact::Other, .. } => Row::new(Test, 2, "why-once-other").so(&["~ d{=d(R)} < 0"]);
        crossing: Shown { fact: Fact::Crossing, .. } =>
            Row::new(Accept, 3, "why-once-crossing").so(&["~ {d(E) / to R}{=crossing}"]);
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let number = |name: &str| fact(&at.step, &NAMES, name);
        let triangle = |which: fn(&Found) -> Option<u32>| {
            let scene = at.scenery?.scene();
            Some(surface_name(Some(scene), which(&found(scene))?))
        };
        Some(match name {
            "plane" => surface_name(at.scenery.map(Scenery::scene), 0).into(),
            "own" => triangle(|found| found.own)?.into(),
            "other" => triangle(|found| found.other)?.into(),
            "to R" => {
                let formula = Formula::decimals().num(number("d(E)")?).sym(" − ");
                formula.operand(number("d(R)")?).into()
            }
            _ => number(name)?.into(),
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            views.push(scenery.observer(|_| Fate::ToCome, in_space(at, scenery)));
        }
        views.push(along_sight(at));
        views
    }
}

/// The plane, and the lines of sight that have been looked along.
fn in_space(at: &At<'_, Why<CrossesOnce>>, scenery: &Scenery) -> Vec<Mark3> {
    let (input, camera) = (at.step.input, scenery.scene().camera.camera());
    let surfaces = surfaces_on_raster(scenery.scene());
    let first = surfaces.triangles().first();
    let mut marks: Vec<Mark3> = first
        .into_iter()
        .flat_map(|it| plane_marks(it, camera, Role::Accent))
        .collect();
    let eye = camera.world_from_view(input.eye);
    for (place, fact, symbol) in [(input.own, Fact::Own, "Q"), (input.other, Fact::Other, "R")] {
        let is_now = at.step.event().is_some_and(|shown| shown.fact == fact);
        let role = if is_now { Role::Signal } else { Role::Ink };
        if let Some(place) = place.filter(|_| at.step.held.get(fact).is_some()) {
            let place = camera.world_from_view(place);
            marks.push(Mark3::new(role, Shape3::Segment([eye, place])));
            marks.push(
                Mark3::new(role, Shape3::Dot(place))
                    .labelled(name(symbol))
                    .strong(),
            );
        }
    }
    marks
}

/// The plane at 0, the side above it, and the axis of distances.
fn sides_of_plane([low, high]: [f64; 2], place: impl Fn(f64, f64) -> [f64; 2]) -> Vec<Mark> {
    let corners = [
        place(0.0, 0.0),
        place(1.0, 0.0),
        place(1.0, high),
        place(0.0, high),
    ];
    let label = mark(Role::Accent, Shape::Label(place(0.0, 0.0))).labelled(name("0"));
    vec![
        mark(Role::Ink, Shape::Fill(vec![corners.to_vec()])),
        segment(Role::Soft, place(0.0, low), place(0.0, high)),
        segment(Role::Accent, place(0.0, 0.0), place(1.15, 0.0)),
        label.toward([-1.0, 0.0]),
    ]
}

/// To the right along a line of sight, from the eye to what is looked at; upwards the distance from the plane.
fn along_sight(at: &At<'_, Why<CrossesOnce>>) -> View {
    let input = at.step.input;
    let distance = |place: [f64; 3]| {
        input
            .plane
            .map_or(0.0, |plane| signed_distance(&plane, place))
    };
    let eye = distance(input.eye);
    let [own, other] = [input.own, input.other].map(|it| it.map_or(0.0, distance));
    let (low, high) = (other.min(0.0), eye.max(own).max(f64::MIN_POSITIVE));
    let up = |d: f64| SIZE[1] * (d - low) / (high - low);
    let place = |part: f64, d: f64| [SIZE[0] * part, up(d)];
    let decimal = |symbol: &'static str, d: f64| Formula::decimals().sym(symbol).num(d);
    let mut picture = Picture::new(&at.step, sides_of_plane([low, high], place));
    picture.once(Fact::Eye, Role::Ink, |role, d| {
        let dot = mark(role, Shape::Dot(place(0.0, d))).labelled(Formula::decimals().num(d));
        [dot.strong().toward([-1.0, 0.0])]
    });
    picture.once(Fact::Own, Role::Accent, |role, d| {
        let dot = mark(role, Shape::Dot(place(1.0, d))).labelled(decimal("Q: ", d));
        [
            segment(role, place(0.0, eye), place(1.0, d)),
            dot.strong().toward([1.0, 0.0]),
        ]
    });
    // Two crossings: the line of sight would have to bend.
    picture.once(Fact::Least, Role::Soft, |role, _| {
        let bend = place(0.45, low - 0.15 * (high - low));
        let bent = mark(
            Role::Soft,
            Shape::Path(vec![place(0.0, eye), bend, place(1.0, own)]),
        );
        let cross = mark(role, Shape::Cross(bend)).labelled(Value::Term("why-bend"));
        [bent.dashed(), cross.toward([1.0, -1.0])]
    });
    picture.once(Fact::Other, Role::Ink, |role, d| {
        let dot = mark(role, Shape::Dot(place(1.0, d))).labelled(decimal("R: ", d));
        [
            segment(role, place(0.0, eye), place(1.0, d)),
            dot.strong().toward([1.0, 0.0]),
        ]
    });
    picture.once(Fact::Crossing, Role::Signal, |role, part| {
        let ring = mark(role, Shape::Ring(place(part, 0.0))).labelled(Value::Term("why-once"));
        [ring.strong().toward([1.0, 1.0])]
    });
    let floor = up(low - 0.15 * (high - low)) - 0.25;
    picture.view(
        "why-view-sight",
        [[-0.4, floor], [SIZE[0] + 0.5, SIZE[1] + 0.15]],
    )
}
