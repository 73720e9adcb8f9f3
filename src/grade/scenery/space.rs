//! Cases of space, as an eye sees it that goes round.

use std::sync::Arc;

use glam::DVec3;
use serde_json::Value as Json;

use crate::{
    figure::{Body, Facets, Mark3, Prospect, Role, Seer, Shape3, Space, View},
    geom::{AlignedBox, Orbit, Plane, ViewVolume},
    labs::plane_symbol,
    text::{Formula, Value},
};

use super::{
    super::whole::Whole,
    Scenery,
    plane::{name, role},
    told::{Told, numbers, outline},
};

type At = [f64; 3];

/// Of more planes none is drawn, of more triangles none is named.
const MOST_PLANES: usize = 6;
const MOST_NAMED: usize = 26;
/// Where the search for an eye begins: yaw and pitch, in degrees, distance by the size of what is seen, field of view.
const FROM: [f64; 2] = [30.0, 20.0];
const AWAY: f64 = 3.0;
const FOV_Y_DEG: f64 = 35.0;

pub(super) fn scenery(case: &Json, whole: &Whole) -> Option<Scenery> {
    let mut case = Case::of(case, whole);
    let own = case.own_marks(whole)?;
    let mut marks = std::mem::take(&mut case.marks);
    marks.extend(own);
    let places: Vec<At> = marks.iter().flat_map(|mark| places(&mark.shape)).collect();
    let around = AlignedBox::around(places).ok()?;
    let [min, max] = [around.min(), around.max()].map(DVec3::from);
    let (centre, size) = (0.5 * (min + max), (max - min).length().max(1e-6));
    let sheets = case.planes.iter().take(MOST_PLANES).enumerate();
    let sheets =
        sheets.map(|(i, plane)| sheet(plane, centre, 0.5 * size).labelled(plane_symbol(i)));
    marks.extend(sheets.filter(|_| !case.is_frustum && case.planes.len() <= MOST_PLANES));
    let home = Orbit::new(centre.into(), FROM, AWAY * size, FOV_Y_DEG);
    let space = Space {
        title: None,
        seer: Seer::Eye(home),
        facets: Facets::default(),
        edges: Arc::from([]),
        marks,
    };
    let mut views = vec![View::new("space", Body::Space(space))];
    let mut prospect = Prospect::default();
    prospect.add(&views);
    prospect.eyes(&[&views], 1, None).turn(&mut views);
    Some(Scenery::Views(views))
}

/// What a case gives, drawn, and what of it an answer may be about.
#[derive(Default)]
struct Case {
    marks: Vec<Mark3>,
    planes: Vec<Plane>,
    is_frustum: bool,
    /// The middle of what is asked about.
    anchor: Option<At>,
    /// The first corner of a triangle alone.
    corner: Option<At>,
    /// The middles of objects, or of triangles where there are no objects.
    middles: Vec<At>,
}

impl Case {
    fn of(case: &Json, whole: &Whole) -> Self {
        let mut own = Self::default();
        if let Some(volume) = case.get("frustum").and_then(volume) {
            own.planes = volume.planes().to_vec();
            own.is_frustum = true;
            let corners = volume.corners();
            own.marks.extend(edges(&corners));
        }
        let planes = case.get("planes").and_then(Json::as_array);
        let planes = planes.into_iter().flatten().filter_map(numbers);
        own.planes
            .extend(planes.filter_map(|row| Plane::new(row).ok()));
        own.take_box(case);
        own.take_subject(case);
        if whole.field() == "ndc" {
            own.marks.extend(
                AlignedBox::new([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0])
                    .map(|cube| edges(&cube.corners()))
                    .unwrap_or_default(),
            );
        }
        own
    }

    fn take_box(&mut self, case: &Json) {
        let given = case.get("box").and_then(numbers);
        if let Some(given) = given.and_then(|numbers| AlignedBox::new(numbers).ok()) {
            self.marks.extend(edges(&given.corners()));
            self.anchor = Some(mean(&given.corners()));
        }
        if let Some([x, y, z, r]) = case.get("sphere").and_then(numbers) {
            let centre = [x, y, z];
            self.marks
                .push(Mark3::new(Role::Ink, Shape3::Ball(centre, r)));
            self.anchor = Some(centre);
        }
    }

    fn take_subject(&mut self, case: &Json) {
        if let Some(&[a, b]) = case.get("segment").and_then(outline).as_deref() {
            let line = Mark3::new(Role::Discarded, Shape3::Segment([a, b]));
            let ends = [(a, "P₁"), (b, "P₂")].map(|(end, name)| {
                let ring = Mark3::new(Role::Discarded, Shape3::Ring(end));
                ring.labelled(name.to_owned()).strong()
            });
            self.marks.extend([line].into_iter().chain(ends));
            self.anchor = Some(mean(&[a, b]));
        }
        if let Some(corners) = case.get("triangle").and_then(outline) {
            self.corner = corners.first().copied();
            self.anchor = Some(mean(&corners));
            self.marks
                .push(Mark3::new(Role::Discarded, Shape3::Outline(corners)));
        }
        let all = |name: &str| case.get(name).and_then(Json::as_array);
        let objects: Vec<Vec<Vec<At>>> = match (all("objects"), all("triangles")) {
            (Some(objects), _) => objects.iter().map(outlines).collect(),
            (None, Some(alone)) => alone
                .iter()
                .filter_map(|json| Some(vec![outline(json)?]))
                .collect(),
            (None, None) => Vec::new(),
        };
        let is_named = objects.len() <= MOST_NAMED;
        for (id, triangles) in objects.into_iter().enumerate() {
            let middle = mean(&triangles.concat());
            self.middles.push(middle);
            let outlines = triangles.into_iter().map(Shape3::Outline);
            self.marks
                .extend(outlines.map(|shape| Mark3::new(Role::Ink, shape)));
            let label = Mark3::new(Role::Ink, Shape3::Label(middle)).labelled(Value::Count(id));
            self.marks.extend(is_named.then_some(label));
        }
        // What is said of all of them.
        let all = (!self.middles.is_empty()).then(|| mean(&self.middles));
        self.anchor = self.anchor.or(all);
    }

    /// What is true, and what the program says; none where neither has a place.
    fn own_marks(&self, whole: &Whole) -> Option<Vec<Mark3>> {
        let told = whole
            .each()
            .map(|(json, is_true)| (Told::<3>::of(json), is_true));
        if told.iter().any(|(told, _)| !told.is_empty()) {
            let marks = told
                .iter()
                .flat_map(|(told, is_true)| drawn(told, *is_true));
            return Some(marks.collect());
        }
        let lines = self.lines(whole).map(|lines| {
            let line = |(is_true, ([from, to], word)): (bool, ([At; 2], Value))| {
                let line = Mark3::new(role(is_true), Shape3::Segment([from, to]));
                let line = if is_true { line } else { line.dashed() };
                [line, pointed(to, word, is_true)]
            };
            [true, false]
                .into_iter()
                .zip(lines)
                .flat_map(line)
                .collect()
        });
        lines.or_else(|| self.points(whole))
    }

    /// What is a length or an arrow: from where to where it is true, and from where to where the program says.
    fn lines(&self, whole: &Whole) -> Option<[([At; 2], Value); 2]> {
        let field = whole.field();
        if let "normal" | "to_viewer" = field {
            let from = self.corner?;
            let arrows = whole
                .each()
                .map(|(json, _)| json.get(field).and_then(numbers::<3>));
            let [Some(truth), Some(said)] = arrows else {
                return None;
            };
            let to = |arrow: At| [0, 1, 2].map(|i| from[i] + arrow[i]);
            return Some([truth, said].map(|arrow| ([from, to(arrow)], coordinates(arrow))));
        }
        let plane = match field {
            "distances" => whole.nth(),
            "distance" => whole.truth.get("plane_idx")?.as_u64().map(|i| i as usize),
            _ => None,
        };
        let (unit, from) = (self.planes.get(plane?)?.unit_normal(), self.anchor?);
        let [Some(truth), Some(said)] = whole.parts.each_ref().map(Json::as_f64) else {
            return None;
        };
        let foot = |distance: f64| [0, 1, 2].map(|i| from[i] - distance * unit[i]);
        Some([truth, said].map(|distance| ([from, foot(distance)], number(distance))))
    }

    /// What is a word or a number: at what it is about.
    fn points(&self, whole: &Whole) -> Option<Vec<Mark3>> {
        let point = |is_true: bool| {
            let value = &whole.parts[usize::from(!is_true)];
            let field = whole.field();
            let value_at = || self.middles.get(value.as_u64()? as usize).copied();
            let at = match field {
                "id" | "object_idx" | "order" | "skipped" | "cycle" => value_at(),
                _ if whole.parts[0].is_array() || whole.parts[0].is_object() => None,
                _ => self.anchor,
            };
            let text = value
                .as_str()
                .map_or_else(|| value.to_string(), str::to_owned);
            let value = value.as_f64().filter(|_| value.is_f64()).map(number);
            let name = field.replace('_', " ");
            let word = value.unwrap_or_else(|| Value::Name(format!("{name} {text}")));
            Some(pointed(at?, word, is_true))
        };
        let points: Vec<Mark3> = [true, false].into_iter().filter_map(point).collect();
        (!points.is_empty()).then_some(points)
    }
}

fn volume(json: &Json) -> Option<ViewVolume> {
    let [aspect, near, far] =
        ["aspect", "near", "far"].map(|name| json.get(name).and_then(Json::as_f64));
    let (aspect, near, far) = (aspect?, near?, far?);
    let made = match json.get("height").and_then(Json::as_f64) {
        Some(height) => ViewVolume::parallel(height, aspect, near, far),
        None => ViewVolume::perspective(json.get("fov_y_deg")?.as_f64()?, aspect, near, far),
    };
    made.ok()
}

fn outlines(object: &Json) -> Vec<Vec<At>> {
    object
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(outline)
        .collect()
}

/// Of corners whose numbers differ in one bit.
fn edges(corners: &[At; 8]) -> Vec<Mark3> {
    let ends = (0..8_usize).flat_map(|i| {
        let others = [1, 2, 4].into_iter().filter(move |bit| i & bit == 0);
        others.map(move |bit| [i, i | bit])
    });
    let edge = |[a, b]: [usize; 2]| Shape3::Segment([corners[a], corners[b]]);
    ends.map(|ends| Mark3::new(Role::Ink, edge(ends)).fine())
        .collect()
}

fn mean(places: &[At]) -> At {
    let n = places.len().max(1) as f64;
    [0, 1, 2].map(|i| places.iter().map(|at| at[i]).sum::<f64>() / n)
}

/// A square of a plane, over where things are.
fn sheet(plane: &Plane, centre: DVec3, reach: f64) -> Mark3 {
    let normal = DVec3::from(plane.unit_normal());
    let distance = normal.dot(centre) + plane.d() / plane.length();
    let foot = centre - distance * normal;
    let (a, b) = normal.any_orthonormal_pair();
    let corner = |[u, v]: [f64; 2]| (foot + reach * (u * a + v * b)).into();
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(corner);
    Mark3::new(Role::Soft, Shape3::Sheet(corners.into()))
}

fn coordinates(at: At) -> Value {
    Value::Formula(Formula::default().sym("(").list(&at).sym(")"))
}

fn number(x: f64) -> Value {
    Value::Formula(Formula::decimals().num(x))
}

fn pointed(at: At, word: Value, is_true: bool) -> Mark3 {
    point(at, is_true).labelled(name(word, is_true))
}

fn point(at: At, is_true: bool) -> Mark3 {
    let shape = if is_true {
        Shape3::Ring(at)
    } else {
        Shape3::Cross(at)
    };
    Mark3::new(role(is_true), shape)
}

/// An answer, or an event: its places, and what joins them.
fn drawn(told: &Told<3>, is_true: bool) -> Vec<Mark3> {
    let line = |corners: &Vec<At>| {
        let shape = match corners[..] {
            [a, b] => Shape3::Segment([a, b]),
            _ => Shape3::Outline(corners.clone()),
        };
        let line = Mark3::new(role(is_true), shape);
        if is_true { line } else { line.dashed() }
    };
    let lines = told.outlines.iter().map(line);
    let corners = told.corners().map(|at| point(at, is_true));
    let at = told.at.map(|at| pointed(at, coordinates(at), is_true));
    lines.chain(corners).chain(at).collect()
}

/// Of the shapes that are made here, but for sheets.
fn places(shape: &Shape3) -> Vec<At> {
    match shape {
        Shape3::Outline(corners) => corners.clone(),
        Shape3::Segment(ends) => ends.to_vec(),
        Shape3::Ring(at) | Shape3::Cross(at) | Shape3::Label(at) => vec![*at],
        Shape3::Ball(centre, radius) => [-radius, *radius].map(|r| centre.map(|x| x + r)).to_vec(),
        Shape3::Arrow(_)
        | Shape3::Sheet(_)
        | Shape3::Wash(_)
        | Shape3::RightAngle(_)
        | Shape3::Angle(_)
        | Shape3::Dot(_) => Vec::new(),
    }
}
