//! A bounding box against the planes of the view volume, and what they cannot tell, shown.

use crate::{
    algo::{
        cull::{BoxCull, BoxCullEvent as Event, BoxCullInput, BoxCullOutput},
        volume::{signed_distance, split},
    },
    labs::frustum::prelude::*,
};

use super::asked::{Asked, across, beyond, both, fate_of, place, says, within};

const CORNERS_VIEW: &str = "corners";

impl AnswerAsItIs for BoxCullOutput {}

impl SpaceTelling for BoxCull {
    fn input(scene: &Scene) -> BoxCullInput {
        BoxCullInput {
            planes: scene.culler().planes_in_world().to_vec(),
            bounds: scene.focused().bounds().expect("its vertices are finite"),
        }
    }
}

const RANGE: &[&str] = &["{least} ≤ n·p + D ≤ {most}"];

impl Telling for BoxCull {
    type Scenery = Scenery;

    const ID: &'static str = "box-cull";
    const NAME_KEY: &'static str = "alg-box-cull";
    const SOURCE: &'static str = "Assarsson & Möller, 2000";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-plane-each", "words-plane-each"),
        code_line(1, "code-box-corners", "words-box-corners"),
        code_line(1, "code-box-outside", "words-box-outside"),
        code_line(0, "code-box-meets", "words-box-meets"),
        code_line(0, "code-box-done", "words-box-done"),
    ];
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["min", "max", "watch-class"]),
        Watched::ListSeen("outside", CORNERS_VIEW),
    ];
    const OPENING: Row = Row::new(Phase, 0, "box-opening").so(&["min = {min}", "max = {max}"]);

    table! { |event, step|
        inside: Event::Plane { class: Inside, .. } =>
            says(Inside, 1, "box-inside").so(RANGE).answers_as("class", "option-box-inside");
        straddles: Event::Plane { class: Straddles, .. } =>
            says(Straddles, 1, "box-straddles").so(RANGE).answers_as("class", "option-box-straddles");
        outside: Event::Plane { class: Outside, .. } =>
            says(Outside, 2, "box-outside").so(RANGE).answers_as("class", "option-box-outside");
        meets: Event::Meets { meets: true } => Row::new(Phase, 3, "box-meets").answers("meets");
        in_vain: Event::Meets { meets: false } => Row::new(Phase, 3, "box-in-vain").answers("meets");
        none_out: Event::Done { class: Inside } => within(Row::new(Accept, 4, "box-done-inside"));
        culled: Event::Done { class: Outside } =>
            beyond(Row::new(Reject, 2, "planes-done-outside"));
        drawn_in_vain: Event::Done { class: Straddles } if step.held.false_positive =>
            across(Row::new(Accept, 4, "box-done-in-vain"));
        cut: Event::Done { class: Straddles } => across(Row::new(Accept, 4, "box-done-straddles"));
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let bounds = &at.step.input.bounds;
        let sums = || sums(at).last();
        Some(match name {
            "min" => place(bounds.min()).into(),
            "max" => place(bounds.max()).into(),
            "outside" => asked(at).answers.last()?.0.clone().into(),
            "least" => range(&sums()?)[0].into(),
            "most" => range(&sums()?)[1].into(),
            _ => return asked(at).named(name),
        })
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        asked(at).listed(list)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let asked = asked(at);
        let mut views = Vec::new();
        if let Some(scenery) = at.scenery {
            let mut marks = box_marks(at, &asked);
            marks.extend(cuts(at, &asked, scenery.scene().culler()));
            if let Some(plane_idx) = asked.current_idx() {
                let side = VolumeSide::ALL[plane_idx];
                marks.extend(plane_at_work(scenery.scene().culler(), side));
            }
            let in_vain = at.step.held.false_positive.then_some(Fate::Culled);
            let fate = in_vain.unwrap_or(fate_of(asked.class));
            views.extend(both(scenery, fate, |_| Fate::ToCome, marks));
        }
        let mut table = corner_table(at, &asked);
        table.notes.extend(in_vain_note(at));
        views.push(View::new(CORNERS_VIEW, Body::Table(table)));
        views
    }
}

/// What it comes to that the box is kept although nothing of it is to be seen.
fn in_vain_note(at: &At<'_, BoxCull>) -> Option<TableNote> {
    let (Some(Event::Done { .. }), true) = (at.step.event(), at.step.held.false_positive) else {
        return None;
    };
    let scenery = at.scenery?;
    let n_faces = scenery.scene().focused().model().mesh().faces().len();
    let text = Message::new("box-note-in-vain").with("triangles", n_faces);
    let applies = true;
    Some(TableNote { text, applies })
}

fn asked<'a>(at: &At<'a, BoxCull>) -> Asked<'a> {
    let planes = &at.step.input.planes;
    let (current, class) = match at.step.event() {
        Some(Event::Plane { plane_idx, .. }) => (planes.get(plane_idx).copied(), None),
        Some(Event::Done { class }) => (None, Some(class)),
        Some(Event::Meets { .. }) | None => (None, None),
    };
    let answers = at.step.past.iter().filter_map(|event| match *event {
        Event::Plane {
            n_outside, class, ..
        } => Some((n_outside.into(), class)),
        Event::Meets { .. } | Event::Done { .. } => None,
    });
    Asked {
        scenery: at.scenery,
        n_planes: planes.len(),
        current,
        answers: answers.collect(),
        class,
        is_done: class.is_some(),
        turns_sign: false,
    }
}

fn sums<'a>(at: &At<'a, BoxCull>) -> impl Iterator<Item = [f64; 8]> + use<'a> {
    at.step.past.iter().filter_map(|event| match *event {
        Event::Plane { sums, .. } => Some(sums),
        Event::Meets { .. } | Event::Done { .. } => None,
    })
}

fn range(sums: &[f64; 8]) -> [f64; 2] {
    let least = sums.iter().copied().fold(f64::INFINITY, f64::min);
    let most = sums.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    [least, most]
}

fn box_marks(at: &At<'_, BoxCull>, asked: &Asked<'_>) -> Vec<Mark3> {
    let bounds = &at.step.input.bounds;
    let edge = |ends| Mark3::new(Role::Ink, Shape3::Segment(ends)).fine();
    let mut marks: Vec<Mark3> = bounds.edges().map(edge).collect();
    if let Some(sums) = asked.current.and(sums(at).last()) {
        let corners = bounds.corners().into_iter().zip(sums);
        marks.extend(corners.map(|(corner, sum)| {
            let (role, shape) = if sum < 0.0 {
                (Role::Signal, Shape3::Ring(corner))
            } else {
                (Role::Accent, Shape3::Dot(corner))
            };
            Mark3::new(role, shape)
        }));
    }
    marks
}

/// Once all planes have been asked: where those that keep the box in vain run through it. Upright ones are drawn as far as box and
/// volume reach.
fn cuts(at: &At<'_, BoxCull>, asked: &Asked<'_>, camera: &Camera) -> Vec<Mark3> {
    let bounds = &at.step.input.bounds;
    let corners = camera.corners_in_world().into_iter();
    let around = AlignedBox::around(corners.chain(bounds.corners())).ok();
    if asked.current.is_some() || asked.answers.len() < asked.n_planes {
        return Vec::new();
    }
    let planes = VolumeSide::ALL.into_iter().zip(&at.step.input.planes);
    let answers = asked.answers.iter().map(|(_, class)| *class);
    let straddled = planes.zip(answers).filter(|(_, class)| *class == Straddles);
    let marks = straddled.flat_map(|((side, plane), _)| {
        let cut = section(plane, bounds);
        let upright = around.filter(|_| side.axis() != 1);
        let sheet = upright.map(|around| Shape3::Sheet(section(plane, &around)));
        let sheet = sheet.map(|sheet| Mark3::new(Role::Accent, sheet).fine());
        let wash = Mark3::new(Role::Accent, Shape3::Wash(cut.clone()));
        let outline = Mark3::new(Role::Accent, Shape3::Sheet(cut)).labelled(side_name(side));
        sheet
            .into_iter()
            .chain([wash, outline.linked(side_link(side))])
    });
    marks.collect()
}

/// What a box has of a plane.
fn section(plane: &Plane, bounds: &AlignedBox) -> Vec<[f64; 3]> {
    let ends = [bounds.min(), bounds.max()];
    let [min, max] = ends.map(DVec3::from);
    let unit = DVec3::from(plane.unit_normal());
    let (u, v) = unit.any_orthonormal_pair();
    let foot = min.midpoint(max) - unit * signed_distance::<f64>(plane, min.midpoint(max).into());
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let square = square.map(|[a, b]| (foot + (u * a + v * b) * min.distance(max)).into());
    let sides = (0..6).filter_map(|i| {
        let (axis, sign) = (i % 3, if i < 3 { 1.0 } else { -1.0 });
        let mut side = [0.0, 0.0, 0.0, -sign * ends[i / 3][axis]];
        side[axis] = sign;
        Plane::new(side).ok()
    });
    sides.fold(square.to_vec(), |left, side| {
        let [inside, _] = split(&left, &side);
        inside
    })
}

fn corner_table(at: &At<'_, BoxCull>, asked: &Asked<'_>) -> Table {
    let header = [
        "column-plane",
        "column-outside",
        "column-least",
        "column-most",
    ];
    let header = header.map(|key| Formula::default().term(key)).to_vec();
    let sums: Vec<[f64; 8]> = sums(at).collect();
    asked.table(header, |plane_idx, role| {
        let (sums, answer) = (sums.get(plane_idx), asked.answers.get(plane_idx));
        let n_outside = answer.map(|(n_outside, _)| n_outside);
        let [least, most] = sums.map(range).map_or([None; 2], |range| range.map(Some));
        // Blue is inside.
        let role_of = |d: Option<f64>| {
            let is_outside = d.is_some_and(|d| d < 0.0);
            if is_outside && role == Role::Accent {
                Role::Soft
            } else {
                role
            }
        };
        vec![
            Cell::new(role_of(least), n_outside.cloned()),
            Cell::new(role_of(least), least),
            Cell::new(role_of(most), most),
        ]
    })
}
