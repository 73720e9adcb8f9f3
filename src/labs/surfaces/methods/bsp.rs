//! A tree of planes, shown: the plane at work in space, the picture so far, the tree growing and then walked.

mod captions;
mod tree;

use serde_json::{Value as Json, json};

use crate::{
    algo::surface::{
        Bsp, BspChoice, BspEvent as Event, BspInput, BspOutput, BspSide, BspState as State,
        Surfaces,
    },
    figure::{
        Body, Caption, Mark3, Raster, Role, Shape3, Tick, View, Watch, WatchRow, WatchSection,
    },
    geom::Camera,
    labs::{
        Answer, CodeLine, Demo, Step, code_line,
        space::{
            OnScene, OnSceneInput, Scene, Subject, demo::SpaceDemo, soup::surfaces_on_raster,
            stage::Fate,
        },
    },
    text::Value,
};

use super::on_raster::{faces, fitting, lettered_or_outlined, name_of, opening, outline, pixels};
use captions::Input;

type Shown = OnScene<Bsp>;

const RASTER_VIEW: &str = "raster";
const TREE_VIEW: &str = "tree";

impl Answer for BspOutput {
    fn json(&self) -> Json {
        json!({ "ids": self.picture, "n_pieces": self.n_pieces })
    }
}

/// The tree of a scene's faces; of the first of them, where that of all would be too large.
fn input_of(surfaces: Surfaces) -> BspInput {
    let mut surfaces = surfaces;
    loop {
        match BspInput::new(surfaces.clone(), BspChoice::First) {
            Ok(input) => return input,
            // Half as many each time: one triangle is never too large.
            Err(_) => surfaces = surfaces.first(surfaces.triangles().len() / 2),
        }
    }
}

impl SpaceDemo for Shown {
    const SUBJECT: Subject = Subject::Surfaces;

    fn input(scene: &Scene) -> Input {
        /// A longer run cannot be followed.
        const MOST_FACES: usize = 300;
        let surfaces = surfaces_on_raster(scene).first(MOST_FACES);
        OnSceneInput::of(scene, input_of(surfaces))
    }
}

impl Demo for Shown {
    const ID: &'static str = "bsp";
    const NAME_KEY: &'static str = "alg-bsp";
    const SOURCE: &'static str = "Fuchs, Kedem & Naylor, 1980";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-bsp-node", "words-bsp-node"),
        code_line(1, "code-bsp-ask", "words-bsp-ask"),
        code_line(1, "code-bsp-cut", "words-bsp-cut"),
        code_line(0, "code-bsp-visit", "words-bsp-visit"),
        code_line(1, "code-bsp-paint", "words-bsp-paint"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Node { .. } | Event::Visit { .. } => Tick::Phase,
            Event::Ask {
                side: BspSide::Cut, ..
            } => Tick::Cut,
            Event::Ask { .. } | Event::Paint { .. } => Tick::Test,
            Event::Built { .. } | Event::Done => Tick::Accept,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Node { .. } => 0,
            Event::Ask {
                side: BspSide::Cut, ..
            } => 2,
            Event::Ask { .. } | Event::Built { .. } => 1,
            Event::Visit { .. } => 3,
            Event::Paint { .. } | Event::Done => 4,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        captions::caption(event, before, input)
    }

    fn opening(input: &Input) -> Caption {
        opening("bsp-opening", input.own.surfaces().triangles().len(), input)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let Some(scenery) = step.input.scenery.as_deref() else {
            return Vec::new();
        };
        let scene = scenery.scene();
        let look = faces([(own(step), Role::Accent)], scene);
        let marks = marks(step, scene.camera.camera());
        let mut views = vec![
            scenery.observer_with(|_| Fate::ToCome, look, marks),
            View::new(RASTER_VIEW, Body::Raster(raster(step))),
        ];
        let tree = tree::tree(step.state, step.event, step.input, scene);
        views.push(View::new(TREE_VIEW, Body::Graph(tree)));
        fitting(scenery, views)
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let n_pieces = state.pieces().count() - state.n_cut();
        let row = |key, n| WatchRow::new(Value::Term(key), Some(Value::Count(n)));
        let rows = vec![
            row("watch-nodes", state.nodes.len()),
            row("watch-pieces", n_pieces),
            row("watch-visited", state.visited.len()),
            row("watch-painted", state.painted.len()),
        ];
        vec![WatchSection::list(rows)]
    }
}

/// The triangle whose plane is at work.
fn own(step: &Step<'_, Shown>) -> Option<u32> {
    let node = step.state.nodes.get(step.state.node? as usize);
    node.map(|node| node.id)
}

/// The plane at work as a wash, and the piece that is asked, or its parts.
fn marks(step: &Step<'_, Shown>, camera: &Camera) -> Vec<Mark3> {
    let world = |corners: &[[f64; 3]]| -> Vec<[f64; 3]> {
        corners
            .iter()
            .map(|&at| camera.world_from_view(at))
            .collect()
    };
    let mut marks = Vec::new();
    let triangles = step.input.own.surfaces().triangles();
    if let Some(triangle) = own(step).and_then(|id| triangles.get(id as usize)) {
        let sheet = world(&in_its_plane(triangle));
        marks.push(Mark3::new(Role::Accent, Shape3::Wash(sheet.clone())));
        marks.push(Mark3::new(Role::Accent, Shape3::Outline(sheet)).fine());
    }
    let state = step.state;
    let asked = state.asked.filter(|_| !state.is_built);
    let painted = state
        .painted
        .last()
        .filter(|_| matches!(step.event, Some(Event::Paint { .. })));
    let shown: Vec<u32> = match (asked, painted) {
        (Some((_, _, Some(parts))), _) => parts.to_vec(),
        (Some((piece, _, None)), _) | (None, Some(&piece)) => vec![piece],
        (None, None) => Vec::new(),
    };
    for piece in shown.into_iter().filter_map(|number| state.piece(number)) {
        let outline = Shape3::Outline(world(&piece.polygon));
        let name = captions::piece_name(step.input, piece);
        marks.push(Mark3::new(Role::Signal, outline).labelled(name));
    }
    marks
}

/// A square in the plane of a triangle, around it.
fn in_its_plane(triangle: &[[f64; 3]; 3]) -> [[f64; 3]; 4] {
    const REACH: f64 = 1.6;
    let [a, b, c] = triangle.map(glam::DVec3::from);
    let middle = (a + b + c) / 3.0;
    let along = (b - a).normalize_or_zero();
    let up = along.cross(c - a).cross(along).normalize_or_zero();
    let reach = [a, b, c]
        .map(|at| at.distance(middle))
        .into_iter()
        .fold(0.0, f64::max);
    let corner = |u: f64, v: f64| (middle + REACH * reach * (u * along + v * up)).into();
    [
        corner(-0.8, -0.8),
        corner(0.8, -0.8),
        corner(0.8, 0.8),
        corner(-0.8, 0.8),
    ]
}

fn raster(step: &Step<'_, Shown>) -> Raster {
    let surfaces = step.input.own.surfaces();
    let [columns, rows] = surfaces.size().map(|side| side as usize);
    let own = own(step);
    let picture = &step.state.so_far.picture;
    let others = surfaces
        .ids()
        .filter(|id| !step.state.is_built && Some(*id) != own);
    let letters = lettered_or_outlined(surfaces, picture, !step.state.is_built, |id| {
        name_of(step.input, id)
    });
    let mut over: Vec<_> = others
        .flat_map(|id| outline(surfaces, id, Role::Soft))
        .collect();
    over.extend(
        own.into_iter()
            .flat_map(|id| outline(surfaces, id, Role::Accent)),
    );
    Raster {
        title: Value::Term("raster-so-far"),
        size: [columns, rows],
        pixels: pixels(picture, own, letters),
        scale: None,
        current: None,
        over,
    }
}
