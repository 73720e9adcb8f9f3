//! What the names stand for at a step; where one triangle hides another, and by how much.

use glam::DVec3;

use crate::algo::{
    surface::{
        DepthBuffer, DepthBufferInput, DepthSteps, Fragment, Painter, PainterEvent as Event,
        PairTest, faulty::WritesAlways, pixel_story,
    },
    volume::signed_distance,
};

use super::super::{glass::blended, planes::plane_of, prelude::*};

use super::variant::Variant;

pub fn named<L: Variant>(at: &At<'_, Painter<L>>, name: &str) -> Option<Named> {
    let (surfaces, held, event) = (at.step.input, at.step.held, at.step.event());
    let [id, other] = about(event);
    let triangle = |id: u32| triangle(at.scenery, id);
    let place_of = |id: u32| held.placed.iter().position(|&placed| placed == id);
    let known = |id: u32| held.list.iter().find(|(it, _)| it.id == id);
    let depths = |id: u32| known(id).map(|(it, _)| it.depths());
    Some(match (name, event) {
        ("triangle", _) => triangle(id?),
        ("other", _) => triangle(other?),
        ("before", Some(Event::Constraint { before, .. })) => triangle(before),
        ("after", _) => triangle(other?),
        ("before", _) => triangle(*held.cycle.iter().nth_back(1)?),
        ("first", _) => triangle(*held.cycle.first()?),
        ("key", _) => Formula::decimals().num(known(id?)?.1).into(),
        ("z", _) => known(id?)?.1.into(),
        ("nearest", _) => depths(id?)?[0].into(),
        ("farthest", _) => depths(other.or(id)?)?[1].into(),
        ("sign", _) => spaced(sign(depths(id?)?[0], depths(other?)?[1])),
        ("place", Some(Event::Sort { .. })) => held.n_sorted.into(),
        ("place", _) => (place_of(id?)? + 1).into(),
        ("triangles", Some(Event::Paint { .. })) => held.placed.len().into(),
        ("triangles", Some(_)) => held.list.len().into(),
        ("pairs" | "watch-pairs", _) => (held.tally.pairs as usize).into(),
        ("cycle", _) => held.cycle.len().into(),
        ("blend", Some(Event::Paint { id })) => {
            let (_, told) = painted_at(at)?;
            let own = told.iter().find(|fragment| fragment.id == id)?;
            blended(surfaces, own)?.into()
        }
        ("C", _) => {
            let (pixel, _) = painted_at(at)?;
            Formula::decimals()
                .num(held.brightness[held.picture.place(pixel)])
                .into()
        }
        ("behind", _) => distances(surfaces, id?, other?)?.into(),
        ("front", _) => distances(surfaces, other?, id?)?.into(),
        ("hidden", _) => {
            let [far, near] = overlap(surfaces, [other?, id?])?.depths;
            Formula::decimals().num(near).sym(" < ").num(far).into()
        }
        _ => {
            let mut tests = PairTest::ALL.into_iter().zip(held.tally.decided);
            let decided = tests.find(|(test, _)| test_key(*test) == name);
            let counted = decided.map(|(_, n)| (n as usize).into());
            return counted.or_else(|| on_raster::named(surfaces, at.scenery, name));
        }
    })
}

pub fn about(event: Option<Event>) -> [Option<u32>; 2] {
    match event {
        Some(
            Event::Key { id, .. }
            | Event::Sort { id }
            | Event::Place { id }
            | Event::Cycle { id }
            | Event::Paint { id },
        ) => [Some(id), None],
        Some(Event::Pair { id, other, .. }) => [Some(id), Some(other)],
        Some(Event::Constraint { before, after }) => [Some(before), Some(after)],
        Some(Event::Done) | None => [None, None],
    }
}

/// How far the corners of a triangle lie before the plane of another one, on whose near side the eye is.
fn distances(surfaces: &Surfaces, of: u32, plane: u32) -> Option<Formula> {
    let triangle = surfaces.triangles().get(of as usize)?;
    let plane = plane_of(surfaces, plane)?;
    let [x, y, z, w] = surfaces.eye();
    let eye = DVec3::from(plane.normal()).dot(DVec3::new(x, y, z)) + plane.d() * w;
    let sign = if eye < 0.0 { -1.0 } else { 1.0 };
    let distances = triangle.map(|at| sign * signed_distance::<f64>(&plane, at));
    Some(Formula::decimals().sym("d = ").list(&distances))
}

/// The pixel that is looked at, and what is painted there: to paint is to write without asking.
fn painted_at<L: Variant>(at: &At<'_, Painter<L>>) -> Option<([u32; 2], Vec<Fragment>)> {
    let surfaces = at.step.input;
    let pixel = at.scenery?.scene().raster.pixel?;
    let is_there = surfaces.is_tinted() && (0..2).all(|i| pixel[i] < surfaces.size()[i]);
    let input = || DepthBufferInput {
        order: at.step.held.placed.clone(),
        ..DepthBufferInput::new(surfaces.clone())
    };
    is_there.then(|| (pixel, pixel_story::<WritesAlways>(&input(), pixel)))
}

pub const fn test_key(test: PairTest) -> &'static str {
    match test {
        PairTest::DepthExtents => "watch-depth-extents",
        PairTest::ScreenExtents => "watch-screen-extents",
        PairTest::BehindPlane => "watch-behind-plane",
        PairTest::BeforePlane => "watch-before-plane",
        PairTest::Overlap => "watch-overlap",
    }
}

/// Of more triangles the reasons are not looked for: their names only are seen.
const MOST_WITH_REASONS: usize = 26;

pub struct Overlap {
    pub at: [f64; 2],
    /// How far both are there, the farther first.
    pub depths: [f64; 2],
}

/// Of the pixels at which the first is farther than the second, the one in their middle; none where no pixel shows it.
pub fn overlap(surfaces: &Surfaces, ends: [u32; 2]) -> Option<Overlap> {
    let n = surfaces.triangles().len();
    if n > MOST_WITH_REASONS {
        return None;
    }
    let depths = ends.map(|id| {
        let alone = surfaces.part(id as usize..id as usize + 1);
        silent::<DepthBuffer>(&DepthBufferInput {
            steps: DepthSteps::Triangles,
            ..DepthBufferInput::new(alone)
        })
        .depth
    });
    let pixels = depths[0].iter().zip(&depths[1]).enumerate();
    let hidden = pixels.filter(|(_, (far, near))| far.is_finite() && far > near);
    let hidden: Vec<usize> = hidden.map(|(place, _)| place).collect();
    let width = surfaces.size()[0] as usize;
    let place = middle(&hidden, width)?;
    let rays = Rays::of(surfaces);
    Some(Overlap {
        at: middle_at(place, width),
        depths: depths.map(|depths| rays.distance(rays.t_at(depths[place]))),
    })
}
