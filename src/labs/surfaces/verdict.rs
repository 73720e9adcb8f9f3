//! Which pixels a face owns, and an object; why a pixel shows what it shows.

use std::ops::Range;

use crate::{
    algo::surface::{DepthBuffer, DepthBufferInput, Surfaces},
    figure::Caption,
    labs::space::{
        pixel_verdict,
        prelude::*,
        raster_verdict,
        soup::{pixels_covered, surface_name, surfaces_on_raster},
    },
};

/// The verdict on a pixel, of the camera's picture or of the raster; on a face of the object in focus; on an object.
pub fn verdict(scene: &Scene, about: Link, now: AtStep<'_>) -> Option<Verdict> {
    pixel_verdict(scene, about)
        .or_else(|| raster_verdict(scene, about, now))
        .or_else(|| owner_verdict(scene, about))
}

fn owner_verdict(scene: &Scene, about: Link) -> Option<Verdict> {
    let n_faces = |object_idx: usize| scene.objects()[object_idx].model().mesh().faces().len();
    let first = |object_idx: usize| (0..object_idx).map(n_faces).sum::<usize>();
    let focus = scene.focus();
    let mut faces = 0..n_faces(focus);
    let (name, ids) = if let Some(face_idx) = faces.find(|&i| about == face_link(i)) {
        let id = first(focus) + face_idx;
        (surface_name(Some(scene), id as u32), id..id + 1)
    } else {
        let mut objects = 0..scene.objects().len();
        let object_idx = objects.find(|&i| about == object_link(i))?;
        let begin = first(object_idx);
        let name = scene.object_name(object_idx);
        (name, begin..begin + n_faces(object_idx))
    };
    let counts = PixelCounts::of(&surfaces_on_raster(scene), ids);
    Some(Verdict {
        why: Caption::new(counts.told(name)),
        notes: Vec::new(),
        step: None,
        offer: None,
    })
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct PixelCounts {
    /// Those that they would have, were there nothing else.
    covered: usize,
    seen: usize,
}

impl PixelCounts {
    fn of(surfaces: &Surfaces, ids: Range<usize>) -> Self {
        let all = silent::<DepthBuffer>(&DepthBufferInput::new(surfaces.clone()));
        let is_own = |id: &&i32| usize::try_from(**id).is_ok_and(|id| ids.contains(&id));
        Self {
            seen: all.picture.ids().iter().filter(is_own).count(),
            covered: pixels_covered(surfaces, ids),
        }
    }

    fn told(self, name: Value) -> Message {
        let Self { covered, seen } = self;
        let key = match (covered, seen) {
            (0, _) => "owns-nothing",
            (_, 0) => "owns-none",
            _ if seen == covered => "owns-all",
            _ => "owns-some",
        };
        Message::new(key)
            .with("surface", name)
            .with("covered", covered)
            .with("seen", seen)
            .with("hidden", covered - seen)
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::*;
    use crate::{
        algo::surface::{DepthSteps, RayCasting, RayCastingInput},
        figure::{Body, Raster},
        labs::{Answers, space::Tones, surfaces::first_scene},
    };

    #[test]
    fn rays_count_the_same_pixels() {
        let mut scene = first_scene();
        scene.raster = scene.raster.with_rows(48);
        let surfaces = surfaces_on_raster(&scene);
        let seen_by_rays = |surfaces: &Surfaces, id: i32| {
            let surfaces = surfaces.clone();
            let input = RayCastingInput {
                surfaces,
                pixel: None,
            };
            let picture = silent::<RayCasting>(&input).picture;
            picture.ids().iter().filter(|seen| **seen == id).count()
        };
        let mut hidden = 0;
        for id in [0_usize, 1] {
            let counts = PixelCounts::of(&surfaces, id..id + 1);
            assert_eq!(counts.seen, seen_by_rays(&surfaces, id as i32));
            let alone = surfaces.part(id..id + 1);
            assert_eq!(counts.covered, seen_by_rays(&alone, 0));
            hidden += counts.covered - counts.seen;
        }
        assert!(hidden > 20, "one goes through the other: {hidden}");
    }

    #[test]
    fn a_pixel_is_said_to_show_something_where_it_is_drawn_also_in_a_run_of_another_one() {
        let mut scene = first_scene();
        scene.raster.tones = Tones::Triangles;
        let mut n_asked = 0;
        for method in crate::labs::surfaces::SURFACES.all() {
            for pixel in [None, Some([8, 7])] {
                (scene.method, scene.raster.pixel) = (method, pixel);
                let run = (method.info().record)(&scene);
                let n_steps = run.n_steps();
                for step in [n_steps / 3, n_steps / 2, n_steps] {
                    let views = run.frame(step).views;
                    let raster = views.into_iter().find_map(|view| match view.body {
                        Body::Raster(raster) if view.id.0 == "raster" => Some(raster),
                        _ => None,
                    });
                    let pixels = raster.map(|raster| raster.pixels).unwrap_or_default();
                    for (place, drawn) in pixels.iter().enumerate().step_by(7) {
                        let shown = (method.info().shown_at)(&scene, (step, place));
                        let shows = shown.is_some_and(|id| id >= 0);
                        assert_eq!(shows, drawn.role.is_some(), "{method:?} {pixel:?} {step}");
                        n_asked += usize::from(shows);
                    }
                }
            }
        }
        assert!(n_asked > 100, "{n_asked}");
    }

    #[test]
    fn what_is_called_nearer_is_nearer_also_in_a_program_that_is_wrong() {
        let mut scene = first_scene();
        scene.raster = scene.raster.with_rows(12);
        scene.raster.steps = DepthSteps::Fragments;
        let mut said = [0; 3];
        let all = crate::labs::surfaces::SURFACES.all();
        for method in all.filter(|method| method.card().id.contains("depth")) {
            scene.method = method;
            let run = (method.info().record)(&scene);
            run.visit([1, run.n_steps()], &mut |step, shown| {
                let keys = [
                    "depth-fragment-kept",
                    "depth-fragment-lost",
                    "depth-fragment-kept-behind",
                ];
                let key = shown.unnumbered().decision.key;
                if let Some(nth) = keys.iter().position(|known| *known == key) {
                    let event = run.event_json(step);
                    let [new, stored] = ["new", "stored"].map(|name| event[name].as_f64());
                    assert_eq!(new < stored, nth == 0, "{key}: {event}");
                    said[nth] += 1;
                }
                ControlFlow::Continue(())
            });
        }
        assert!(said.iter().all(|count| *count > 2), "{said:?}");
    }

    #[test]
    fn nothing_is_said_to_be_seen_beside_a_pixel_of_a_picture_that_does_not_show_it() {
        let mut scene = first_scene();
        scene.raster = scene.raster.with_rows(12);
        let [columns, rows] = scene.raster.size(scene.camera.aspect());
        let mut n_told = [0; 2];
        let all = crate::labs::surfaces::SURFACES.all();
        for method in all.filter(|method| method.card().id.contains("depth")) {
            scene.method = method;
            let run = (method.info().record)(&scene);
            for at in [0, run.n_steps()] {
                let shows = |place| (method.info().shown_at)(&scene, (at, place));
                let n_shown = (0..(columns * rows) as usize)
                    .filter(|&place| shows(place).is_some_and(|id| id >= 0))
                    .count();
                for place in 0..(columns * rows) as usize {
                    let about = Link::nth(Raster::LINK, place);
                    let Some(verdict) = scene.verdict(about, (&*run, at)) else {
                        continue;
                    };
                    let mut notes = verdict.notes.iter();
                    let says = notes.any(|note| note.key == "pixel-other");
                    assert!(!says || n_shown > 0, "{method:?} {at} {place}");
                    n_told[usize::from(n_shown > 0)] += usize::from(says);
                }
            }
        }
        assert_eq!(n_told[0], 0);
        assert!(n_told[1] > 20, "{n_told:?}");
    }

    #[test]
    fn pixels_faces_and_objects_are_told_of_by_every_method() {
        let mut scene = first_scene();
        let [columns, rows] = scene
            .raster
            .size(scene.camera.aspect())
            .map(|side| side as usize);
        for method in crate::labs::surfaces::SURFACES.all() {
            scene.method = method;
            let run = (method.info().record)(&scene);
            let told = |about| scene.verdict(about, (&*run, run.n_steps()));
            for about in [face_link(0), object_link(1)] {
                let key = told(about).map(|verdict| verdict.why.decision.key);
                assert_eq!(key, Some("owns-some"));
            }
            let pixel = |place| told(Link::nth(Raster::LINK, place));
            let is_told = pixel(columns * rows / 2 + columns / 2).is_some();
            assert_eq!(is_told, !method.card().is_proof, "a proof makes no picture");
            assert!(pixel(columns * rows).is_none(), "there is no such pixel");
            assert!(told(object_link(2)).is_none());
        }
    }
}
