//! World planes beside clip space on one triangle: what each finds, and whether both leave the same.

use crate::{figure::ViewId, labs::frustum::prelude::*};

use super::{
    LISTS_VIEW,
    clip_space::{Uv, in_world, triangle},
    marks::vertex_symbol,
    variant::{self, EvenOnScreen, Homogeneous, OnePolygon, Variant},
};

/// Places that lie apart by no more than rounding: coordinates of some tens, matrices of some units.
const SAME: f64 = 1e-6;

/// Is it not beside another method? There is no room for more beside two pictures.
pub fn is_alone(scenery: &Scenery) -> bool {
    scenery.scene().beside.is_empty()
}

/// Do the two methods on stage differ in what they cost or in what the camera sees, and not in their lists?
pub fn is_about_pictures(scenery: Option<&Scenery>) -> bool {
    let Some(scene) = scenery.filter(|it| !is_alone(it)).map(Scenery::scene) else {
        return false;
    };
    let mut on_stage = scene.on_stage().map(|method| method.card().id);
    agrees(scene) || on_stage.any(|id| id == <EvenOnScreen as Variant<OnePolygon>>::ID)
}

/// Rows of the vertices of a list, which stand in its view too where there is one.
pub fn vertex_rows(
    places: impl Iterator<Item = Value>,
    prime: &str,
    scenery: Option<&Scenery>,
) -> WatchSection {
    let row = |(i, place)| {
        let symbol = format!("{}{prime}", vertex_symbol(i));
        WatchRow::new(name(symbol), Some(place))
    };
    let mut rows = WatchSection::list(places.enumerate().map(row).collect());
    if !is_about_pictures(scenery) {
        rows = rows.seen_in(LISTS_VIEW);
    }
    rows
}

fn agrees(scene: &Scene) -> bool {
    let both = [
        <Right as Variant<OnePolygon>>::ID,
        <Right as Variant<Homogeneous>>::ID,
    ];
    let on_stage: Vec<&str> = scene.on_stage().map(|method| method.card().id).collect();
    both.iter().all(|id| on_stage.contains(id))
}

/// Whether world planes and clip space leave the same, where both are on stage.
pub fn agreement_view(scenery: Option<&Scenery>) -> Option<View> {
    let notes = vec![agreement(scenery?.scene())?];
    let (header, rows) = (Vec::new(), Vec::new());
    let table = Table {
        header,
        rows,
        notes,
    };
    Some(View {
        id: ViewId::AGREEMENT,
        body: Body::Table(table),
    })
}

fn agreement(scene: &Scene) -> Option<TableNote> {
    if !agrees(scene) {
        return None;
    }
    let by_planes = silent::<IntersectionPolygon>(&variant::input(scene, false)).triangles;
    let by_planes: Vec<[f64; 3]> = by_planes.iter().flatten().map(|v| v.at).collect();
    let before_divide = silent::<HomogeneousTriangle<Uv>>(&triangle(scene));
    let before_divide = before_divide.vertices().iter();
    let before_divide: Vec<[f64; 3]> = before_divide.map(|v| in_world(v, scene)).collect();
    let apart = apart(&by_planes, &before_divide).max(apart(&before_divide, &by_planes));
    let decimals = (-libm::log10(apart.max(f64::EPSILON))).floor() as usize;
    let text = Message::new("tally-same").with("n", before_divide.len());
    let text = text.with("decimals", decimals);
    let applies = true;
    (apart < SAME).then_some(TableNote { text, applies })
}

/// How far one of these places lies from the nearest of those, at most.
fn apart(these: &[[f64; 3]], those: &[[f64; 3]]) -> f64 {
    let distance = |a: &[f64; 3], b: &[f64; 3]| {
        let square = |i: usize| (a[i] - b[i]) * (a[i] - b[i]);
        (square(0) + square(1) + square(2)).sqrt()
    };
    let nearest = |a| {
        let distances = those.iter().map(|b| distance(a, b));
        distances.fold(f64::INFINITY, f64::min)
    };
    these.iter().map(nearest).fold(0.0, f64::max)
}
