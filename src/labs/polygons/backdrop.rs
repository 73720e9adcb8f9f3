//! What is on stage whatever the step: the clip region, and the subject polygon as given.

use crate::{
    geom::{Polygon, extent},
    labs::{Backdrop, prelude::*},
};

use super::{GivenSubject, Method, Scene};

impl Backdrop for Scene {
    fn backdrop(&self, column: usize, at_end: bool) -> Vec<Mark> {
        let method = self.on_stage().nth(column).unwrap_or(self.method);
        let clip = region(self, method).map(|clip| vec![outline(&clip)]);
        let clip = clip.map(|clip| Mark::new(Role::Ink, Shape::Area(clip)).linked("window"));
        clip.into_iter()
            .chain(subject(self, method, at_end))
            .collect()
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        let clip = region(self, self.method);
        let rings = self.rings().chain(&clip);
        extent(rings.flat_map(|ring| ring.vertices().iter().copied()))
    }

    fn region(&self) -> Option<[[f64; 2]; 2]> {
        let clip = region(self, self.method)?;
        Some(extent(clip.vertices().iter().copied()))
    }
}

/// What is not covered by the result, or by the list that a method works on, has been cut off.
fn subject(scene: &Scene, method: Method, at_end: bool) -> Vec<Mark> {
    let rings: Vec<_> = scene.rings().map(outline).collect();
    let info = method.info();
    let marks = match (at_end && info.clips, info.given) {
        (true, _) => vec![Mark::new(Role::Discarded, Shape::Area(rings))],
        (false, GivenSubject::Whole) => vec![Mark::new(Role::Soft, Shape::Area(rings))],
        (false, GivenSubject::CutOff) => {
            let outlines = rings.iter().cloned().map(Shape::Outline);
            let outlines = outlines.map(|shape| Mark::new(Role::Discarded, shape));
            let outlines = outlines.collect();
            let fill = Mark::new(Role::Soft, Shape::Fill(rings));
            [vec![fill], outlines].concat()
        }
    };
    marks
        .into_iter()
        .map(|mark| mark.linked("subject"))
        .collect()
}

fn region(scene: &Scene, method: Method) -> Option<Polygon> {
    method.info().clips.then(|| scene.clip_outline())
}

fn outline(polygon: &Polygon) -> Vec<[f64; 2]> {
    polygon.vertices().iter().map(|p| p.to_array()).collect()
}
