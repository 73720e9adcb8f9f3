//! The view volume of a case: `{"fov_y_deg", "aspect", "near", "far"}`, with `"height"` in place of `"fov_y_deg"` where
//! sight lines are parallel.

use crate::{
    geom::{SpaceError, ViewVolume},
    text::{Formula, Value},
};

use super::{Detail, Field, Fields, Given, Node, Path, Refusal};

/// Of a view volume.
pub(super) const VOLUME_FIELDS: [Field; 5] = [
    Field::choice("fov_y_deg"),
    Field::choice("height"),
    Field::required("aspect"),
    Field::required("near"),
    Field::required("far"),
];

/// The volume, and what is told of it.
pub(super) fn read_volume(node: &Node<'_>, detail: Detail) -> Result<(ViewVolume, Given), Refusal> {
    let fields = Fields::of(node, "object-view-volume", &VOLUME_FIELDS, detail)?;
    let (volume, told) = read_volume_of(&fields, &node.path)?;
    Ok((volume, Given::new("object-view-volume", told.into_iter())))
}

/// The same from the fields of an object that has others too.
pub(super) fn read_volume_of(
    fields: &Fields<'_>,
    place: &Path<'_>,
) -> Result<(ViewVolume, Vec<Value>), Refusal> {
    let mut told = Vec::new();
    let mut number = |name| {
        let x = fields.need(name)?.number()?;
        let formula = Formula::default().sym(name).sym(" = ").num(x);
        told.push(Value::Formula(formula));
        Ok(x)
    };
    let is_parallel = fields.get("height").is_some();
    let opening = number(if is_parallel { "height" } else { "fov_y_deg" })?;
    let (aspect, near, far) = (number("aspect")?, number("near")?, number("far")?);
    let make = if is_parallel {
        ViewVolume::parallel
    } else {
        ViewVolume::perspective
    };
    match make(opening, aspect, near, far) {
        Ok(volume) => Ok((volume, told)),
        Err(error) => Err(refused(place, error)),
    }
}

/// At the field of the volume, or of the camera, that is to blame.
pub(super) fn refused(volume: &Path<'_>, error: SpaceError) -> Refusal {
    match error.camera_field() {
        Some(field) => Refusal::space(&Path::Member(volume, field), error),
        None => Refusal::space(volume, error),
    }
}
