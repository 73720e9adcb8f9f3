//! A point against the planes of the view volume, shown.

use crate::{
    algo::{
        cull::{PointPlanes, PointPlanesEvent as Event, PointPlanesInput, PointPlanesOutput},
        volume::PlaneSide::{self, Inside, On, Outside},
    },
    geom::planes_from_matrix,
    labs::{frustum::prelude::*, words},
};

use super::asked::{Asked, distance_formula, place, plane_name, says};

const PLANES_VIEW: &str = "planes";

impl AnswerAsItIs for PointPlanesOutput {}

impl SpaceTelling for PointPlanes {
    const SUBJECT: Subject = Subject::Point;

    fn input(scene: &Scene) -> PointPlanesInput {
        PointPlanesInput {
            planes: scene.culler().planes_in_world().to_vec(),
            point: scene.places().point,
        }
    }
}

const P: &[&str] = &["P = {P}"];

impl Telling for PointPlanes {
    type Scenery = Scenery;

    const ID: &'static str = "point-planes";
    const NAME_KEY: &'static str = "alg-point-planes";
    const SOURCE: &'static str = "Sutherland & Hodgman, 1974";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-plane-each", "words-plane-each"),
        code_line(1, "code-point-distance", "words-point-distance"),
        code_line(1, "code-point-outside", "words-point-outside"),
        code_line(0, "code-point-inside", "words-point-inside"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["P", "n", "D"]),
        Watched::ListSeen("distances", PLANES_VIEW),
    ];
    const OPENING: Row = Row::new(Phase, 0, "point-opening").so(P);

    table! { |event, step|
        inside: Event::Plane { side: Inside, .. } =>
            says(Containment::Inside, 1, "point-inside").so(&["{d = n·P + D} > 0"]).answers("side");
        on: Event::Plane { side: On, .. } =>
            says(Containment::Inside, 1, "point-on").so(&["{d = n·P + D}"]).answers("side");
        outside: Event::Plane { side: Outside, .. } =>
            says(Containment::Outside, 2, "point-outside").so(&["{d = n·P + D} < 0"]).answers("side");
        none_out: Event::Done { inside: true } =>
            Row::new(Accept, 3, "point-done-inside").so(P).answers_as("in", "point-answer-inside");
        any_out: Event::Done { inside: false } =>
            Row::new(Reject, 3, "point-done-outside").so(P).answers_as("in", "point-answer-outside");
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (asked, point) = (asked(at), at.step.input.point);
        Some(match name {
            "P" => place(point).into(),
            "d = n·P + D" => {
                let d = at.step.held.distances.last()?;
                distance_formula(["d", "P"], &asked.current?, point, *d).into()
            }
            _ => return asked.named(name),
        })
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        asked(at).listed(list)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let asked = asked(at);
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let mut marks = vec![dot(at)];
            let (camera, distances) = (scenery.scene().culler(), &at.step.held.distances);
            marks.extend(asked.marks(camera, at.step.input.point, distances));
            marks.extend(
                asked
                    .current
                    .and(asked.lit())
                    .and_then(|side| opening(camera, side)),
            );
            views.push(scenery.observer(|_| Fate::ToCome, marks));
            views.push(scenery.camera(|_| Fate::ToCome, |_, _| FaceLook::Whole, vec![dot(at)]));
        }
        let table = plane_table(at, &asked);
        views.push(View::new(PLANES_VIEW, Body::Table(table)));
        views
    }
}

fn asked<'a>(at: &At<'a, PointPlanes>) -> Asked<'a> {
    let planes = &at.step.input.planes;
    let current = match at.step.event() {
        Some(Event::Plane { plane_idx, .. }) => planes.get(plane_idx).copied(),
        Some(Event::Done { .. }) | None => None,
    };
    let says = |&d: &f64| match PlaneSide::of(d) {
        Inside | On => (d.into(), Containment::Inside),
        Outside => (d.into(), Containment::Outside),
    };
    Asked {
        scenery: at.scenery,
        n_planes: planes.len(),
        current,
        answers: at.step.held.distances.iter().map(says).collect(),
        is_done: matches!(at.step.event(), Some(Event::Done { .. })),
        ..Asked::default()
    }
}

fn dot(at: &At<'_, PointPlanes>) -> Mark3 {
    let role = match at.step.event() {
        None | Some(Event::Plane { .. }) => Role::Ink,
        Some(Event::Done { inside: true }) => Role::Accepted,
        Some(Event::Done { inside: false }) => Role::Discarded,
    };
    Mark3::new(role, Shape3::Dot(at.step.input.point)).labelled(words::name("P"))
}

/// How far a plane at a side and the one across from it open, where that is not the same in both directions.
fn opening(camera: &Camera, side: VolumeSide) -> Option<Mark3> {
    let corners = camera.corners_in_world().map(DVec3::from);
    // Those of the far side that differ in one direction.
    let [width, height] = [5, 6].map(|other| corners[4].distance(corners[other]));
    if camera.volume().sight() != Sight::Perspective || side.axis() == 2 || width == height {
        return None;
    }
    let eye = DVec3::from(camera.position());
    let across = [[[4, 6], [5, 7]], [[4, 5], [6, 7]]][side.axis()];
    let ends = across.map(|[a, b]| corners[a].midpoint(corners[b]) - eye);
    let sector = [DVec3::ZERO, ends[0], ends[1]].map(|to| (eye + 0.3 * to).into());
    let degrees = ends[0].angle_between(ends[1]).to_degrees();
    let degrees = Formula::decimals().num(degrees);
    let sector = Mark3::new(Role::Ink, Shape3::Wash(sector.to_vec()));
    Some(sector.labelled(degrees.sym("°")))
}

fn plane_table(at: &At<'_, PointPlanes>, asked: &Asked<'_>) -> Table {
    let symbols = ["n_x", "n_y", "n_z", "D", "d"].map(sym);
    let mut header = vec![Formula::default().term("column-plane")];
    header.extend(symbols);
    let (planes, distances) = (&at.step.input.planes, &at.step.held.distances);
    let cells = |plane_idx: usize, role| {
        let given = planes[plane_idx].to_array();
        let given = given.map(|value| Cell::new(Role::Ink, Some(value)));
        let distance = distances.get(plane_idx);
        let cell = Cell::new(role, distance.copied());
        let cell = if distance.is_some() {
            cell.strong()
        } else {
            cell
        };
        given.into_iter().chain([cell]).collect()
    };
    let in_hand = at.scenery.zip(asked.current_idx());
    let text = in_hand.and_then(|(scenery, plane_idx)| from_matrix(scenery, plane_idx));
    let note = text.map(|text| TableNote {
        text,
        applies: true,
    });
    Table {
        notes: note.into_iter().collect(),
        ..asked.table(header, cells)
    }
}

/// What the rows of the matrix say of the plane at work, and to how many decimals they agree with what the angles give.
fn from_matrix(scenery: &Scenery, plane_idx: usize) -> Option<Message> {
    let camera = scenery.scene().culler();
    let from_matrix = planes_from_matrix(&camera.clip_from_world()).ok()?;
    let apart = from_matrix.iter().zip(scenery.planes()).map(|(a, b)| {
        let both = a.to_array().into_iter().zip(b.to_array());
        let apart = both.map(|(x, y)| (x / a.length() - y).abs());
        apart.fold(0.0, f64::max)
    });
    let apart = apart.fold(f64::EPSILON, f64::max);
    let decimals = (-libm::log10(apart)).floor().max(0.0) as usize;
    let (plane, side) = (&from_matrix[plane_idx], VolumeSide::ALL[plane_idx]);
    let sign = if side.is_high() { '−' } else { '+' };
    let row = ["x", "y", "z"][side.axis()];
    let sum = sym(format!("w {sign} {row} = ("));
    let message = Message::new("plane-from-matrix")
        .with("sum", Value::Formula(sum.list(&plane.to_array()).sym(")")))
        .with("length", plane.length())
        .with("plane", plane_name(Some(scenery), plane_idx));
    Some(message.with("decimals", decimals))
}
