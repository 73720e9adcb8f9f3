//! What all methods draw: the picture in large pixels, the ray through one of them in space.

use std::{
    cmp::Ordering,
    collections::{BTreeMap, HashMap},
};

use crate::{
    algo::{
        surface::{Picture, Rays, Surfaces},
        volume::{ClipSpace, ClipVertex, HomogeneousLine, HomogeneousTriangle, LineInput},
    },
    figure::Tick,
    geom::{Camera, pairs_around},
    labs::{
        Document,
        space::{
            prelude::*,
            soup::{place_of, surface_link, surface_name, surfaces_on_raster},
        },
    },
};

/// Greys of neighbouring triangles, a clear step apart.
const TONES: [f64; 4] = [0.4, 1.0, 0.05, 0.7];
const OWN_TONE: f64 = 0.9;

/// What a triangle is called: `A₇`, or its number where there is no scene.
pub fn name_of(scenery: Option<&Scenery>, id: u32) -> Value {
    surface_name(scenery.map(Scenery::scene), id)
}

pub fn triangle(scenery: Option<&Scenery>, id: u32) -> Named {
    Named {
        link: scenery.and_then(|scenery| surface_link(scenery.scene(), id)),
        ..name_of(scenery, id).into()
    }
}

pub fn named(surfaces: &Surfaces, scenery: Option<&Scenery>, name: &str) -> Option<Named> {
    let [columns, rows] = surfaces.size().map(|side| side as usize);
    let n_triangles = surfaces.triangles().len();
    Some(match name {
        "columns" => columns.into(),
        "rows" => rows.into(),
        "pixels" => surfaces.n_pixels().into(),
        "triangles" => n_triangles.into(),
        "all" => scenery
            .map_or(n_triangles, |scenery| scenery.scene().size())
            .into(),
        _ => return None,
    })
}

/// How a run on some triangles begins; of a scene that has more it says so.
pub fn opening(own: &'static Row, surfaces: &Surfaces, scenery: Option<&Scenery>) -> &'static Row {
    const FIRST: Row = Row::new(Tick::Phase, 0, "surfaces-first");
    let n_triangles = surfaces.triangles().len();
    let has_more = scenery.is_some_and(|scenery| scenery.scene().size() > n_triangles);
    if has_more { &FIRST } else { own }
}

/// A name where only text can stand; what has none is said by its number.
pub fn text_of(name: Value, number: usize) -> String {
    if let Value::Name(name) = name {
        name
    } else {
        number.to_string()
    }
}

pub fn sign(one: f64, other: f64) -> &'static str {
    match one.total_cmp(&other) {
        Ordering::Less => "<",
        Ordering::Equal => "=",
        Ordering::Greater => ">",
    }
}

/// How faces look in space where some triangles stand out: the first that is named counts.
pub fn faces<const N: usize>(
    marked: [(Option<u32>, Role); N],
    scene: &Scene,
) -> impl Fn(usize, usize) -> FaceLook {
    let marked = marked.map(|(id, role)| (id.and_then(|id| place_of(scene, id)), role));
    move |object, face| {
        let own = marked
            .iter()
            .find(|(place, _)| *place == Some([object, face]));
        own.map_or(FaceLook::Whole, |&(_, role)| FaceLook::Own(role))
    }
}

/// Beside another method there is no room to name each of more triangles.
const MOST_NAMED: usize = 12;

pub const RASTER_VIEW: &str = "raster";

/// What has room: beside two other methods only space and large pixels, which come first, beside one a third view where it need
/// not name too many triangles; alone, also the picture that the pixels are of, in full size. Without a scene there is none.
pub fn views<M: Telling<Scenery = Scenery>>(
    at: &At<'_, M>,
    shown: impl FnOnce(&Scenery) -> Vec<View>,
) -> Vec<View> {
    let Some(scenery) = at.scenery else {
        return Vec::new();
    };
    let mut views = shown(scenery);
    let n_beside = scenery.scene().beside.len();
    if n_beside == 0 {
        views.push(picture(scenery));
    } else {
        let objects = scenery.scene().objects().iter();
        let n_triangles: usize = objects.map(|o| o.model().mesh().faces().len()).sum();
        let names_all = |view: &View| matches!(view.body, Body::Graph(_) | Body::Table(_));
        let has_room = n_beside == 1 && (n_triangles <= MOST_NAMED || !views.iter().any(names_all));
        views.truncate(if has_room { 3 } else { 2 });
    }
    views
}

/// What the pixels are of, in full size: faces that are left out are not in it.
fn picture(scenery: &Scenery) -> View {
    let scene = scenery.scene();
    let culling = scene.raster.culls_backs.then(|| surfaces_on_raster(scene));
    let objects = scene.objects().iter();
    let firsts = objects.scan(0, |next, object| {
        let first = *next;
        *next += object.model().mesh().faces().len();
        Some(first)
    });
    let firsts: Vec<usize> = firsts.collect();
    let look = |object: usize, face: usize| {
        let is_left_out = |surfaces: &Surfaces| {
            let corners = surfaces.triangles().get(firsts[object] + face);
            corners.is_some_and(|corners| !surfaces.shows(corners))
        };
        if culling.as_ref().is_some_and(is_left_out) {
            FaceLook::Hidden
        } else {
            FaceLook::Whole
        }
    };
    scenery.camera(|_| Fate::ToCome, look, Vec::new())
}

/// Where a triangle has been cut before the run: edges between parts that lie in one plane, of what has few of them.
pub fn seams(scene: &Scene, role: Role) -> Vec<Mark3> {
    const MOST_PARTS: usize = 4;
    const FLAT: f64 = 1.0 - 1e-9;
    let mut marks = Vec::new();
    for object in scene.objects() {
        let mesh = object.model().mesh();
        let edges = mesh.edges().iter().filter(|edge| {
            let normal = |face: u32| glam::DVec3::from(mesh.normal(mesh.faces()[face as usize]));
            let [Some(a), Some(b)] = edge.faces else {
                return false;
            };
            normal(a)
                .normalize_or_zero()
                .dot(normal(b).normalize_or_zero())
                > FLAT
        });
        let points: Vec<[f64; 3]> = object.points().collect();
        let seams = edges
            .filter(|_| mesh.faces().len() <= MOST_PARTS)
            .map(|edge| {
                let ends = edge.ends.map(|i| points[i as usize]);
                Mark3::new(role, Shape3::Segment(ends))
            });
        marks.extend(seams);
    }
    marks
}

pub fn tone(id: u32, own: Option<u32>) -> (Role, f64) {
    if Some(id) == own {
        (Role::Accent, OWN_TONE)
    } else {
        (Role::Soft, TONES[id as usize % TONES.len()])
    }
}

pub fn pixels(
    picture: &Picture,
    own: Option<u32>,
    value: impl Fn(usize) -> Option<Value>,
) -> Vec<Pixel> {
    let pixel = |(place, &id): (usize, &i32)| {
        let Ok(id) = u32::try_from(id) else {
            let value = value(place);
            return Pixel {
                value,
                ..Pixel::EMPTY
            };
        };
        let (role, shade) = tone(id, own);
        Pixel {
            role: Some(role),
            shade,
            value: value(place),
        }
    };
    picture.ids().iter().enumerate().map(pixel).collect()
}

/// Of more triangles the names only cover the picture.
const MOST_LETTERS: usize = 26;

/// Triangles have their names where they are seen, each in the pixel that is nearest to the middle of its pixels.
pub fn lettered(picture: &Picture, name: impl Fn(u32) -> Value) -> impl Fn(usize) -> Option<Value> {
    let width = picture.size()[0] as usize;
    let mut places: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (place, &id) in picture.ids().iter().enumerate() {
        if let Ok(id) = u32::try_from(id) {
            places.entry(id).or_default().push(place);
        }
    }
    let is_few = places.len() <= MOST_LETTERS;
    let named: HashMap<usize, Value> = places
        .into_iter()
        .filter(|_| is_few)
        .filter_map(|(id, places)| Some((middle(&places, width)?, name(id))))
        .collect();
    move |place| named.get(&place).cloned()
}

pub fn middle(places: &[usize], width: usize) -> Option<usize> {
    let at = |place: usize| [place % width, place / width].map(|x| x as f64);
    let n = places.len() as f64;
    let mean = [0, 1].map(|i| places.iter().map(|&place| at(place)[i]).sum::<f64>() / n);
    let distance = |place: usize| {
        let [x, y] = at(place);
        (x - mean[0]).powi(2) + (y - mean[1]).powi(2)
    };
    let nearest = |a: &&usize, b: &&usize| distance(**a).total_cmp(&distance(**b));
    places.iter().min_by(nearest).copied()
}

/// The corners of what is seen of a triangle, over the pixels.
pub fn seen_corners(surfaces: &Surfaces, id: u32) -> Vec<[f64; 2]> {
    let Some(triangle) = surfaces.triangles().get(id as usize) else {
        return Vec::new();
    };
    let clip_from_view = surfaces.volume().clip_from_view();
    let corners = triangle.map(|[x, y, z]| ClipVertex {
        at: clip_from_view.times([x, y, z, 1.0]),
        attributes: [],
    });
    let seen = silent::<HomogeneousTriangle<[f32; 0]>>(&corners);
    let place = |vertex: &ClipVertex<[f32; 0]>| {
        let [x, y, _, w] = vertex.at;
        surfaces.viewport().screen_from_ndc([x / w, y / w])
    };
    seen.vertices().iter().map(place).collect()
}

pub fn middle_of(surfaces: &Surfaces, id: u32) -> Option<[f64; 2]> {
    let corners = seen_corners(surfaces, id);
    let n = corners.len() as f64;
    let mean = |i: usize| corners.iter().map(|at| at[i]).sum::<f64>() / n;
    (n > 0.0).then(|| [mean(0), mean(1)])
}

/// The same; while nothing is painted yet, triangles have their names in the middles of their outlines.
pub fn lettered_or_outlined(
    surfaces: &Surfaces,
    picture: &Picture,
    is_waiting: bool,
    name: impl Fn(u32) -> Value,
) -> impl Fn(usize) -> Option<Value> {
    let is_shown = is_waiting && surfaces.triangles().len() <= MOST_LETTERS;
    let width = surfaces.size()[0] as usize;
    let outlined = surfaces.ids().filter(|_| is_shown).filter_map(|id| {
        let [column, row] = middle_of(surfaces, id)?.map(|x| x.max(0.0) as usize);
        Some((row * width + column.min(width - 1), name(id)))
    });
    let outlined: BTreeMap<usize, Value> = outlined.collect();
    let painted = lettered(picture, name);
    move |place| painted(place).or_else(|| outlined.get(&place).cloned())
}

pub const fn mark(role: Role, shape: RasterShape) -> RasterMark {
    RasterMark { role, shape }
}

/// The middle of a pixel.
pub fn middle_at(place: usize, width: usize) -> [f64; 2] {
    [place % width, place / width].map(|x| x as f64 + 0.5)
}

pub fn outline(surfaces: &Surfaces, id: u32, role: Role) -> Vec<RasterMark> {
    let corners = seen_corners(surfaces, id);
    let line = |ends| mark(role, RasterShape::Line(ends));
    pairs_around(&corners).map(line).collect()
}

/// Of a segment in view space what is seen of it, over the pixels.
pub fn segment(surfaces: &Surfaces, ends: [[f64; 3]; 2], role: Role) -> Option<RasterMark> {
    let clip_from_view = surfaces.volume().clip_from_view();
    let visible = silent::<HomogeneousLine>(&LineInput {
        bounds: ClipSpace,
        ends: ends.map(|[x, y, z]| clip_from_view.times([x, y, z, 1.0])),
    })?;
    let places = visible.map(|[x, y, _, w]| surfaces.viewport().screen_from_ndc([x / w, y / w]));
    Some(mark(role, RasterShape::Line(places)))
}

pub fn spaced(sign: &str) -> Named {
    Value::Name(format!(" {sign} ")).into()
}

pub fn raster_so_far(surfaces: &Surfaces, pixels: Vec<Pixel>, over: Vec<RasterMark>) -> Raster {
    Raster {
        title: Value::Term("raster-so-far"),
        size: surfaces.size().map(|side| side as usize),
        pixels,
        scale: None,
        under: Vec::new(),
        bare: None,
        current: None,
        over,
    }
}

/// A pixel on the near plane, and the line of sight through its middle as far as t.
pub fn sight(surfaces: &Surfaces, camera: &Camera, pixel: [u32; 2], t: f64) -> Vec<Mark3> {
    let rays = Rays::of(surfaces);
    let ray = rays.through(pixel);
    let to = camera.world_from_view(ray.at(t));
    let from = camera.world_from_view(ray.origin);
    vec![
        Mark3::new(
            Role::Signal,
            Shape3::Sheet(on_near(surfaces, camera, pixel).to_vec()),
        ),
        Mark3::new(Role::Signal, Shape3::Segment([from, to])),
    ]
}

fn on_near(surfaces: &Surfaces, camera: &Camera, [column, row]: [u32; 2]) -> [[f64; 3]; 4] {
    let [width, height] = surfaces.size().map(f64::from);
    let [a, b, c, ..] = camera.corners_in_world();
    let corner = |dx: u32, dy: u32| {
        let u = f64::from(column + dx) / width;
        let v = 1.0 - f64::from(row + dy) / height;
        std::array::from_fn(|i| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]))
    };
    [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]
}
