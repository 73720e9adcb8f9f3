//! Why an object was kept or culled, in a sentence.

use crate::{
    algo::cull::{Containment, SphereCullInput, sphere_verdict},
    figure::{Caption, Link, Moment, Run},
    geom::VolumeSide,
    labs::Verdict,
    text::{Message, Value},
};

use super::{
    Scene,
    stage::{object_link, side_name},
};

/// The verdict on the object that is asked about, by its bounding sphere; and the step of the funnel that says so.
pub fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
    let mut objects = scene.objects().iter().enumerate();
    let (object_idx, object) = objects.find(|(i, _)| about == object_link(*i))?;
    let sphere = object.in_funnel().sphere;
    let planes = scene.culler().planes_in_world().to_vec();
    let verdict = sphere_verdict(&SphereCullInput { planes, sphere })?;
    let side = VolumeSide::ALL[verdict.plane_idx];
    let key = match (verdict.class, verdict.turn) {
        (Containment::Outside, Some(_)) => "verdict-culled",
        (Containment::Outside, None) => "verdict-culled-for-good",
        (Containment::Straddles, _) => "verdict-straddles",
        (Containment::Inside, _) => "verdict-inside",
    };
    let message = Message::new(key)
        .with("object", object_idx + 1)
        .with("plane", side_name(side))
        .with("distance", Value::Number(verdict.distance))
        .with("radius", Value::Number(sphere.radius()))
        .with(
            "move",
            Value::Number(verdict.turn.unwrap_or_default().abs()),
        );
    let moment = format!("sphere #{}", object_idx + 1).parse().ok();
    Some(Verdict {
        why: Caption::new(message),
        notes: Vec::new(),
        step: moment.and_then(|moment: Moment| run.find(&moment)),
    })
}
