//! Why an object or a face was kept or culled, in a sentence, and the smallest change that would turn it.

use crate::{
    algo::cull::{FaceTurn, SphereCullInput, face_turn, sphere_verdict, triangle_move},
    figure::Caption,
    labs::{frustum::prelude::*, space::pixel_verdict},
};

use super::part::told_at;

pub fn verdict(scene: &Scene, about: Link, (run, _): AtStep<'_>) -> Option<Verdict> {
    if let Some(pixel) = pixel_verdict(scene, about) {
        return Some(pixel);
    }
    let mut faces = 0..scene.focused().model().mesh().faces().len();
    match faces.find(|&i| about == face_link(i)) {
        Some(face_idx) => face_verdict(scene, face_idx, run),
        None => object_verdict(scene, about, run),
    }
}

fn face_verdict(scene: &Scene, face_idx: usize, run: &dyn Run) -> Option<Verdict> {
    let Some(step) = run.why(face_link(face_idx)) else {
        // No step asks it where its object is culled whole.
        let culled = object_verdict(scene, object_link(scene.focus()), run);
        return culled.filter(|verdict| verdict.step.is_some());
    };
    let turn = if run.event_json(step)["event"] == "triangle" {
        corners_turn(scene, face_idx)
    } else {
        facing_turn(scene, face_idx)
    };
    Some(told_at(step, (scene, run), None, turn))
}

/// How far a face has to be moved until its corners do not all lie beyond one plane; where they do not, the clipper decided.
fn corners_turn(scene: &Scene, face_idx: usize) -> Option<Message> {
    let corners = scene.focused().face(face_idx)?;
    let clip_from_world = scene.culler().clip_from_world();
    let code = |[x, y, z]: [f64; 3]| SideCode::of(clip_from_world.times([x, y, z, 1.0]));
    let [a, b, c] = corners.map(code);
    let Some(side) = a.and(b).and(c).lowest() else {
        return Some(Message::new("verdict-face-cut"));
    };
    let by = triangle_move(&scene.culler().planes_in_world(), &corners, side as usize);
    let message = Message::new(match by {
        Some(_) => "verdict-face-in",
        None => "verdict-face-never",
    });
    let message = message.with("move", by.unwrap_or_default());
    Some(message.with("plane", side_name(side)))
}

/// By how many degrees a face has to be turned until it shows its other side.
fn facing_turn(scene: &Scene, face_idx: usize) -> Option<Message> {
    let turn = face_turn(&BackFaceInput {
        triangle: scene.focused().face(face_idx)?,
        viewer: asked_viewer::<Right>(scene.culler()),
    });
    let Some(FaceTurn { degrees, .. }) = turn else {
        return Some(Message::new("verdict-face-no-normal"));
    };
    let key = if degrees < 0.0 {
        "verdict-face-turn-away"
    } else {
        "verdict-face-turn-to"
    };
    Some(Message::new(key).with("angle", degrees.abs()))
}

fn object_verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
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
        .with("distance", verdict.distance)
        .with("radius", sphere.radius())
        .with("move", verdict.turn.unwrap_or_default().abs());
    Some(Verdict {
        why: Caption::new(message),
        notes: Vec::new(),
        step: run.why(about),
        offer: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labs::{Document, frustum::first_scene, space::Part};

    #[test]
    fn every_object_and_every_face_of_it_is_told_by_the_funnel() {
        let mut scene = first_scene();
        let mut tests = std::collections::HashSet::new();
        // One object goes out of sight, sideways.
        for x in 0..8 {
            let object = scene.objects()[0].moved([0.6 * f64::from(x), 0.9, 0.2]);
            scene.set_object(0, object.expect("finite"));
            for object_idx in 0..scene.objects().len() {
                scene
                    .look_at(Part::Object, object_idx)
                    .expect("one of them");
                tests.extend(told_of_faces(&scene));
            }
        }
        assert!(tests.len() >= 2, "spheres decide, and faces");
    }

    fn told_of_faces(scene: &Scene) -> Vec<String> {
        let runs = scene.record();
        let event = |about| {
            let told = verdict(scene, about, (&*runs[0], 0)).expect("it is told");
            runs[0].event_json(told.step.expect("at a step"))
        };
        assert_eq!(event(object_link(scene.focus()))["event"], "sphere");
        let faces = 0..scene.focused().model().mesh().faces().len();
        let kinds = faces.map(|face_idx| {
            let event = event(face_link(face_idx));
            if event["event"] == "sphere" {
                assert_eq!(event["class"], "outside");
            } else {
                assert_eq!(event["triangle_idx"], face_idx);
            }
            event["event"].to_string()
        });
        kinds.collect()
    }
}
