//! A tree of planes, shown: the plane at work in space, the picture so far, the tree growing and then walked.

mod above;
mod names;
mod tree;

use crate::{
    algo::surface::{Bsp, BspChoice, BspEvent as Event, BspInput, BspOutput, BspPiece, BspSide},
    figure::Tick,
    geom::Camera,
};

use super::{planes::plane_marks, prelude::*};

const TREE_VIEW: &str = "tree";

pseudocode! {
    NODE: 0, "code-bsp-node", "words-bsp-node";
    ASK: 1, "code-bsp-ask", "words-bsp-ask";
    CUT: 1, "code-bsp-cut", "words-bsp-cut";
    VISIT: 0, "code-bsp-visit", "words-bsp-visit";
    PAINT: 1, "code-bsp-paint", "words-bsp-paint";
}

impl AnswerAsItIs for BspOutput {}

impl SpaceTelling for Bsp {
    const SUBJECT: Subject = Subject::Surfaces;

    fn shown(step: &Step<'_, Self>, place: usize) -> Option<i32> {
        step.held.picture.ids().get(place).copied()
    }

    /// A longer run cannot be followed.
    const MOST_FACES: usize = 300;

    /// The tree of a scene's faces; of the first of them, where that of all would be too large.
    fn input(scene: &Scene) -> BspInput {
        let mut surfaces = surfaces_on_raster(scene);
        loop {
            match BspInput::new(surfaces.clone(), BspChoice::First) {
                Ok(input) => return input,
                // Half as many each time: one triangle is never too large.
                Err(_) => surfaces = surfaces.first(surfaces.triangles().len() / 2),
            }
        }
    }
}

const fn node(key: &'static str) -> Row {
    Row::new(Phase, NODE, key).about("triangle")
}

const fn asked(tick: Tick, line: usize, [key, option]: [&'static str; 2]) -> Row {
    let row = Row::new(tick, line, key).so(&["{distances}"]);
    row.answers_as("side", option).about("piece")
}

const fn visited(key: &'static str) -> Row {
    let row = Row::new(Phase, VISIT, key).so(&["~ d = {eye}"]);
    row.answers("eye").about("triangle")
}

impl Telling for Bsp {
    type Scenery = Scenery;

    const ID: &'static str = "bsp";
    const NAME_KEY: &'static str = "alg-bsp";
    const SOURCE: &'static str = "Fuchs, Kedem & Naylor, 1980";
    const CODE: &'static [CodeLine] = &LINES;
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "watch-nodes",
        "watch-pieces",
        "watch-visited",
        "watch-painted",
    ])];
    const OPENING: Row = Row::new(Phase, NODE, "bsp-opening");

    table! { |event, _step|
        root: Event::Node { parent: None, .. } => node("bsp-node-root");
        back: Event::Node { parent: Some((_, BspSide::Back)), .. } => node("bsp-node-back");
        front: Event::Node { .. } => node("bsp-node-front");
        ask_front: Event::Ask { side: BspSide::Front, .. } => asked(Test, ASK, ["bsp-ask-front", "option-side-front"]);
        ask_back: Event::Ask { side: BspSide::Back, .. } => asked(Test, ASK, ["bsp-ask-back", "option-side-back"]);
        ask_on: Event::Ask { side: BspSide::On, .. } => asked(Test, ASK, ["bsp-ask-on", "option-side-on"]).keeps("piece");
        ask_cut: Event::Ask { side: BspSide::Cut, .. } => asked(Cut, CUT, ["bsp-ask-cut", "option-side-cut"]).cuts("piece");
        built: Event::Built { .. } => Row::new(Accept, ASK, "bsp-built");
        visit_front: Event::Visit { eye: BspSide::Front, .. } => visited("bsp-visit-front");
        visit_back: Event::Visit { eye: BspSide::Back, .. } => visited("bsp-visit-back");
        visit_on: Event::Visit { .. } => visited("bsp-visit-on");
        paint: Event::Paint { .. } => Row::new(Test, PAINT, "bsp-paint").about("piece");
        done: Event::Done => Row::new(Accept, PAINT, "bsp-done");
    }

    fn opening(at: &At<'_, Self>) -> &'static Row {
        on_raster::opening(&Self::OPENING, at.step.input.surfaces(), at.scenery)
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        names::named(at, name)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let mut views = on_raster::views(at, |scenery| {
            let scene = scenery.scene();
            let look = faces([(own(at), Role::Accent)], scene);
            let marks = marks(at, scene.camera.camera());
            // While the tree is built nothing is painted.
            let is_alone = scene.beside.is_empty();
            let picture = if is_alone && !names::is_built(at.step.past) {
                Body::Multiples(above::above(at))
            } else {
                Body::Raster(raster(at))
            };
            vec![
                scenery.observer_with(|_| Fate::ToCome, look, marks),
                View::new(RASTER_VIEW, picture),
                View::new(TREE_VIEW, Body::Graph(tree::tree(at, scene))),
            ]
        });
        let camera = at.scenery.map(|scenery| scenery.scene().camera.camera());
        let mut is_observer = true;
        for view in &mut views {
            if let (Body::Space(space), Some(camera)) = (&mut view.body, camera) {
                let is_named = std::mem::take(&mut is_observer);
                space.marks.extend(cut_pieces(at).map(|piece| {
                    let mark = part(camera, piece);
                    if is_named {
                        mark.labelled(names::piece_name(at.scenery, piece))
                    } else {
                        mark
                    }
                }));
            }
        }
        views
    }
}

/// The parts that planes have cut off before this step, and that are whole since.
fn cut_pieces<'a>(at: &At<'a, Bsp>) -> impl Iterator<Item = &'a BspPiece> {
    let (now, all) = (shown(at), &at.step.held.pieces);
    let is_cut_again = |piece: &BspPiece| {
        let mut others = all.iter().filter(|other| other.id == piece.id);
        others.any(|it| it.cuts.len() > piece.cuts.len() && it.cuts.starts_with(&piece.cuts))
    };
    let pieces = (0..).zip(all).filter(|(_, piece)| !piece.cuts.is_empty());
    let whole = pieces.filter(move |(nth, piece)| !now.contains(nth) && !is_cut_again(piece));
    whole.map(|(_, piece)| piece)
}

fn part(camera: &Camera, piece: &BspPiece) -> Mark3 {
    let corners = piece.polygon.iter().map(|&at| camera.world_from_view(at));
    Mark3::new(Role::Ink, Shape3::Outline(corners.collect())).fine()
}

/// The pieces that the step is about.
fn shown(at: &At<'_, Bsp>) -> Vec<u32> {
    match at.step.event() {
        Some(Event::Ask {
            parts: Some(parts), ..
        }) => parts.to_vec(),
        Some(Event::Ask { piece, .. } | Event::Paint { piece, .. }) => vec![piece],
        Some(Event::Node { .. } | Event::Built { .. } | Event::Visit { .. } | Event::Done)
        | None => Vec::new(),
    }
}

fn own(at: &At<'_, Bsp>) -> Option<u32> {
    let node = names::node_of(at.step.event()?)?;
    Some(at.step.held.nodes[node as usize].id)
}

fn marks(at: &At<'_, Bsp>, camera: &Camera) -> Vec<Mark3> {
    let world = |corners: &[[f64; 3]]| -> Vec<[f64; 3]> {
        corners
            .iter()
            .map(|&at| camera.world_from_view(at))
            .collect()
    };
    let mut marks = Vec::new();
    let triangles = at.step.input.surfaces().triangles();
    if let Some(id) = own(at)
        && let Some(triangle) = triangles.get(id as usize)
    {
        let name = Message::new("bsp-plane").with("triangle", name_of(at.scenery, id));
        let [wash, sheet] = plane_marks(triangle, camera, Role::Accent);
        marks.extend([wash, sheet.labelled(Value::Message(name))]);
    }
    for piece in shown(at) {
        let piece = &at.step.held.pieces[piece as usize];
        let outline = Shape3::Outline(world(&piece.polygon));
        let name = names::piece_name(at.scenery, piece);
        marks.push(Mark3::new(Role::Signal, outline).labelled(name));
    }
    marks
}

fn raster(at: &At<'_, Bsp>) -> Raster {
    let (surfaces, picture) = (at.step.input.surfaces(), &at.step.held.picture);
    let (own, is_built) = (own(at), names::is_built(at.step.past));
    let name = |id| name_of(at.scenery, id);
    let letters = lettered_or_outlined(surfaces, picture, !is_built, name);
    let others = surfaces.ids().filter(|id| !is_built && Some(*id) != own);
    let others = others.map(|id| (id, Role::Soft));
    let over = others.chain(own.map(|id| (id, Role::Accent)));
    let over = over.flat_map(|(id, role)| outline(surfaces, id, role));
    raster_so_far(surfaces, pixels(picture, own, letters), over.collect())
}
