//! Why a vertex of the subject is kept or cut away, an intersection lies where it does, a piece is one: the step that decided
//! it, and how far a vertex is from another answer.

use crate::{
    algo::{
        line::{least_move_in, least_move_out},
        polygon::ClipRegion,
    },
    figure::{Caption, Decides},
    geom::{Location, Point, Segment, distance_to_segment, locate},
    labs::{Answers, Click, prelude::*, words::vertex_name},
};

use super::{
    PolygonTelling, Scene,
    handles::corner_link,
    methods::{clip_edge_name, region},
    scene::{Found, VertexFate},
};

/// What becomes of a vertex of the subject that lies there: the last step that keeps or drops it. None where no step does.
pub fn fate<M: PolygonTelling>(scene: &Scene, at: Point) -> Option<VertexFate> {
    let mut fate: Option<VertexFate> = None;
    Recording::<M>::looking(M::input(scene).ok()?, |now| {
        let decides = now.event().and_then(|event| match M::row(now).decides {
            Decides::Keeps if M::asks(&event) == Some(at) => Some(true),
            Decides::Drops if M::asks(&event) == Some(at) => Some(false),
            Decides::Keeps | Decides::Drops | Decides::Cuts | Decides::Nothing => {
                M::tells(&event, at)
            }
        });
        // Where a vertex has been dropped, no later one at its place counts.
        if let Some(is_kept) = decides.filter(|_| fate.is_none_or(|fate| fate.is_kept)) {
            fate = Some(VertexFate {
                step: now.past.len(),
                is_kept,
                border: M::border(now),
            });
        }
    });
    fate
}

pub fn found<M: PolygonTelling>(scene: &Scene) -> Vec<Found> {
    let mut found = Vec::new();
    if let Ok(input) = M::input(scene) {
        Recording::<M>::looking(input, |now| {
            let step = now.past.len();
            let crossing = now.event().and_then(|event| M::crossing(&event));
            found.extend(crossing.map(|at| Found::Crossing { step, at }));
            found.extend(M::piece(now).map(|outline| Found::Piece { step, outline }));
            let step = step - usize::from(crossing.is_some());
            let dropped = M::dropped(now).into_iter();
            found.extend(dropped.map(|part| Found::Dropped { step, part }));
        });
    }
    found
}

impl Answers for Scene {
    fn asked(&self, click: &Click<'_>) -> Option<Link> {
        let [x, y, _] = click.at;
        let at = Point::new(x, y).ok()?;
        let found = (self.method.info().found)(self);
        let nearest = |distance: &dyn Fn(&Found) -> Option<f64>| {
            let near = found.iter().enumerate().filter_map(|(i, found)| {
                let distance = distance(found)?;
                (distance <= click.reach).then_some((distance, i))
            });
            near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
        };
        let crossing = nearest(&|found| match found {
            Found::Crossing { at: there, .. } => Some((there.x() - x).hypot(there.y() - y)),
            Found::Piece { .. } | Found::Dropped { .. } => None,
        });
        let piece = || {
            found.iter().position(|found| match found {
                Found::Crossing { .. } | Found::Dropped { .. } => false,
                Found::Piece { outline, .. } => locate(outline, at) == Location::Inside,
            })
        };
        let dropped = || {
            nearest(&|found| match found {
                Found::Dropped { part, .. } => {
                    let ends = part.map(Point::to_array);
                    Some(distance_to_segment([x, y], ends))
                }
                Found::Crossing { .. } | Found::Piece { .. } => None,
            })
        };
        crossing.or_else(piece).or_else(dropped).map(found_link)
    }

    fn verdict(&self, about: Link, (run, _): AtStep<'_>) -> Option<Verdict> {
        let vertices = self.subject.vertices();
        if let Some(vertex_idx) = (0..vertices.len()).find(|&i| about == corner_link(i)) {
            return vertex_verdict(self, vertex_idx, run);
        }
        let found = (self.method.info().found)(self);
        let idx = (0..found.len()).find(|&i| about == found_link(i))?;
        let (step, note) = match found[idx] {
            Found::Crossing { step, .. } | Found::Piece { step, .. } => (step, None),
            Found::Dropped { step, part } => {
                let [from, to] = part.map(|end| Value::Point(end.to_array()));
                let message = Message::new("verdict-edge-dropped").with("from", from);
                (step, Some(message.with("to", to)))
            }
        };
        Some(Verdict {
            why: run.caption(step),
            notes: note.into_iter().collect(),
            step: Some(step),
            offer: None,
        })
    }
}

fn vertex_verdict(scene: &Scene, vertex_idx: usize, run: &dyn Run) -> Option<Verdict> {
    let info = scene.method.info();
    if !info.clips || run.is_refused() {
        return None;
    }
    let at = scene.subject.vertices()[vertex_idx];
    let Some(fate) = (info.fate)(scene, at) else {
        let message = Message::new("verdict-vertex-passed-by");
        return Some(Verdict {
            why: Caption::new(message.with("vertex", vertex_name(vertex_idx))),
            notes: Vec::new(),
            step: Some(run.n_steps()),
            offer: None,
        });
    };
    let told = Message::new(if fate.is_kept {
        "verdict-vertex-kept"
    } else {
        "verdict-vertex-cut"
    });
    let told = told.with("vertex", vertex_name(vertex_idx));
    let turn = vertex_turn(scene, vertex_idx, fate);
    Some(Verdict {
        why: run.caption(fate.step),
        notes: std::iter::once(told).chain(turn).collect(),
        step: Some(fate.step),
        offer: None,
    })
}

/// How far a vertex has to be moved to be kept, or to be cut away, in a sentence. None of a method that is wrong on purpose.
fn vertex_turn(scene: &Scene, vertex_idx: usize, fate: VertexFate) -> Option<Message> {
    if scene.method.card().is_faulty {
        return None;
    }
    let region = region(scene).ok()?;
    let (border_idx, by) = turn(scene, &region, scene.subject.vertices()[vertex_idx], fate)?;
    let key = match by {
        None => "verdict-vertex-never",
        Some(by) if by > 0.0 => "verdict-vertex-in",
        Some(by) if by < 0.0 => "verdict-vertex-out",
        Some(_) => "verdict-vertex-touch",
    };
    let message = Message::new(key).with("vertex", vertex_name(vertex_idx));
    let message = message.with("move", by.unwrap_or_default().abs());
    Some(message.with("edge", clip_edge_name(&region, border_idx)))
}

/// Along which border's normal a vertex is to be moved, and how far inwards; none where no such move turns its fate. A method
/// that asks no border by name has no answer.
fn turn(
    scene: &Scene,
    region: &ClipRegion,
    at: Point,
    fate: VertexFate,
) -> Option<(usize, Option<f64>)> {
    let border_idx = fate.border?;
    let planes = region.half_planes();
    let corners = scene.convex_clip().ok()?;
    let corners = corners.vertices();
    let point = Segment { p1: at, p2: at };
    Some(if fate.is_kept {
        let turn = least_move_out(&planes, corners, &point)?;
        (turn.border_idx, Some(turn.by))
    } else {
        (
            border_idx,
            least_move_in(&planes, corners, &point, border_idx),
        )
    })
}

const fn found_link(idx: usize) -> Link {
    Link::nth("found", idx)
}

#[cfg(test)]
mod tests {
    use super::{
        super::{Method, random_polygon},
        *,
    };
    use crate::labs::Document;

    fn moved(scene: &Scene, vertex_idx: usize, along: [f64; 2], by: f64) -> Scene {
        let mut scene = scene.clone();
        let [x, y] = scene.subject.vertices()[vertex_idx].to_array();
        let length = along[0].hypot(along[1]);
        let [x, y] = [x + by * along[0] / length, y + by * along[1] / length];
        let to = Point::new(x, y).expect("finite");
        scene.subject.set_vertex(vertex_idx, to);
        scene
    }

    fn is_kept(scene: &Scene, vertex_idx: usize) -> Option<bool> {
        let at = scene.subject.vertices()[vertex_idx];
        let fate = (scene.method.info().fate)(scene, at);
        fate.map(|fate| fate.is_kept)
    }

    #[test]
    fn a_vertex_turns_where_it_is_said() {
        let mut scene = Scene::first();
        let mut n_turned = [0; 2];
        for (id, seed) in [
            ("sutherland-hodgman", 1),
            ("sutherland-hodgman-pipeline", 2),
        ] {
            scene.method = Method::by_id(id).expect("in the registry");
            scene.subject = random_polygon(&scene.clip_window(), 40, seed).expect("a polygon");
            let region = region(&scene).expect("convex");
            let planes = region.half_planes();
            for vertex_idx in 0..40 {
                let at = scene.subject.vertices()[vertex_idx];
                let fate = (scene.method.info().fate)(&scene, at).expect("each is asked");
                let Some((border_idx, by)) = turn(&scene, &region, at, fate) else {
                    continue;
                };
                let Some(by) = by else { continue };
                let normal = planes[border_idx].normal();
                let beyond = moved(&scene, vertex_idx, normal, by + by.signum() * 1e-9);
                let before = moved(&scene, vertex_idx, normal, 0.99 * by);
                let kept = [&beyond, &before].map(|scene| is_kept(scene, vertex_idx));
                let expected = [Some(!fate.is_kept), Some(fate.is_kept)];
                assert_eq!(kept, expected, "{at:?} {by}");
                n_turned[usize::from(fate.is_kept)] += 1;
            }
        }
        assert!(n_turned.iter().all(|&n| n > 5), "{n_turned:?}");
    }

    #[test]
    fn a_click_on_what_is_dropped_asks_about_it() {
        let mut scene = Scene::first();
        for id in ["sutherland-hodgman", "weiler-atherton"] {
            scene.set_method(id);
            let runs = scene.record();
            let found = (scene.method.info().found)(&scene);
            let parts = found.iter().filter_map(|found| match found {
                Found::Dropped { part, .. } => Some(part.map(Point::to_array)),
                Found::Crossing { .. } | Found::Piece { .. } => None,
            });
            for [a, b] in parts {
                let at = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.0];
                let click = Click {
                    at,
                    reach: 1e-9,
                    ..Click::default()
                };
                let told = scene.verdict(scene.asked(&click).expect("it is"), (&*runs[0], 0));
                assert_eq!(told.expect("it is told").notes.len(), 1, "{id}");
            }
        }
    }

    #[test]
    fn every_vertex_intersection_and_piece_of_every_method_is_told() {
        let mut scene = Scene::first();
        let methods = (scene.lab().methods)().into_iter();
        for card in methods.filter(|card| !card.is_proof) {
            scene.set_method(card.id);
            let runs = scene.record();
            let found = (scene.method.info().found)(&scene);
            assert!(!found.is_empty(), "{}", card.id);
            for idx in 0..found.len() {
                let told = scene
                    .verdict(found_link(idx), (&*runs[0], 0))
                    .expect("it is told");
                assert!((1..=runs[0].n_steps()).contains(&told.step.expect("at a step")));
            }
            for vertex_idx in 0..scene.subject.vertices().len() {
                let told = scene.verdict(corner_link(vertex_idx), (&*runs[0], 0));
                assert_eq!(told.is_some(), scene.method.info().clips, "{}", card.id);
            }
        }
    }
}
