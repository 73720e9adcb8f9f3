//! The buffer in large pixels: depths, which triangle is seen, or how often each was computed.

use crate::{
    algo::surface::{
        DepthBuffer, DepthBufferEvent as Event, DepthBufferInput, DepthBufferOutput, DepthSteps,
        times_computed,
    },
    labs::space::Tones,
};

use super::super::{
    glass::{bright, unsorted},
    prelude::*,
};

use super::{
    names::{current, fragment_of, of_glass, pixel_of},
    numbers::Shades,
    variant::Variant,
};

const BEFORE_VIEW: &str = "raster-before";
/// What is computed in vain, once and more often.
const VAIN: [f64; 2] = [0.35, 1.0];

/// Where counts are shown and backs are left out, what it would have been with every face comes first.
pub fn rasters<L: Variant>(at: &At<'_, DepthBuffer<L>>, scene: &Scene) -> Vec<View> {
    let own = at.step.input;
    let is_beside = !scene.beside.is_empty();
    let counts = scene.raster.tones == Tones::Counts && scene.beside.len() < 2;
    if !counts {
        return vec![View::new(RASTER_VIEW, Body::Raster(raster(at, scene)))];
    }
    let view = |id, key, input: &DepthBufferInput, so_far: &DepthBufferOutput| {
        let mut raster = counted::<L>(key, input, so_far);
        if at.step.past.is_empty() {
            raster.title = Value::Term("raster-counts-none");
        }
        if let Some(id) = current(at) {
            raster.over = outline(&own.surfaces, id, Role::Accent);
        }
        raster.current = pixel_of(at).map(|pixel| pixel.map(|x| x as usize));
        View::new(id, Body::Raster(raster))
    };
    let whole = whole_picture(at);
    let so_far = whole.as_ref().unwrap_or(&at.step.held.so_far);
    if is_beside || !own.surfaces.culls_backs() {
        return vec![view(RASTER_VIEW, "raster-counts", own, so_far)];
    }
    let every_face = DepthBufferInput {
        surfaces: own.surfaces.with_backs(),
        order: own.order[..n_drawn(at)].to_vec(),
        pixel: None,
        ..own.clone()
    };
    let before = silent::<DepthBuffer<L>>(&every_face);
    vec![
        view(BEFORE_VIEW, "raster-counts-before", &every_face, &before),
        view(RASTER_VIEW, "raster-counts-after", own, so_far),
    ]
}

/// How often each pixel has been computed: once, or once and in vain.
fn counted<L: Variant>(
    key: &'static str,
    input: &DepthBufferInput,
    so_far: &DepthBufferOutput,
) -> Raster {
    let tally = so_far.tally;
    let times = times_computed::<L>(input, tally.fragments);
    let pixel = |(&n, &id): (&u32, &i32)| {
        let n_vain = n.saturating_sub(u32::from(id != Picture::BACKGROUND));
        let role = if n_vain == 0 {
            Role::Accent
        } else {
            Role::Signal
        };
        let shade = VAIN[usize::from(n_vain > 1)];
        let is_any = n > 0;
        Pixel {
            role: is_any.then_some(role),
            shade,
            value: is_any.then_some(Value::Count(n as usize)),
        }
    };
    let pixels = times.iter().zip(so_far.picture.ids()).map(pixel);
    let title = Message::new(key)
        .with("seen", tally.pixels as usize)
        .with("vain", (tally.fragments - tally.pixels) as usize);
    Raster {
        title: Value::Message(title),
        ..raster_so_far(&input.surfaces, pixels.collect(), Vec::new())
    }
}

/// How many triangles have been drawn.
fn n_drawn<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> usize {
    let own = at.step.input;
    let place = |id: u32| own.order.iter().position(|&other| other == id);
    let is_drawn = own.steps == DepthSteps::Triangles || fragment_of(at).is_some();
    match current(at).and_then(place) {
        Some(before) => before + usize::from(is_drawn),
        None if at.step.event() == Some(Event::Done) => own.order.len(),
        None => 0,
    }
}

/// Where one pixel is looked at, all of the picture's pixels, so that it is known where that is.
pub fn whole_picture<L: Variant>(at: &At<'_, DepthBuffer<L>>) -> Option<DepthBufferOutput> {
    let own = at.step.input;
    let whole = own.pixel.map(|_| DepthBufferInput {
        pixel: None,
        order: own.order[..n_drawn(at)].to_vec(),
        ..own.clone()
    });
    whole.map(|whole| silent::<DepthBuffer<L>>(&whole))
}

/// The buffer so far, toned by depth. Beside two others there is no room for depths, and triangles have their names as they have there.
fn raster<L: Variant>(at: &At<'_, DepthBuffer<L>>, scene: &Scene) -> Raster {
    let own = at.step.input;
    let whole = whole_picture(at);
    let so_far = whole.as_ref().unwrap_or(&at.step.held.so_far);
    let current = current(at);
    if scene.raster.tones == Tones::Brightness {
        return in_brightness(at, so_far);
    }
    let names_triangles = scene.beside.len() > 1 || scene.raster.tones == Tones::Triangles;
    let (titles, scale, pixels) = if names_triangles {
        let letters = lettered(&so_far.picture, |id| name_of(at.scenery, id));
        let pixels = pixels(&so_far.picture, current, letters);
        ((Value::Term("raster-so-far"), None), None, pixels)
    } else {
        let shades = Shades::of::<L>(own, &scene.raster);
        let pixels = toned::<L>(so_far, current, &shades);
        // It has not been cleared yet.
        let is_unknown = at.step.past.is_empty();
        let pixels = pixels.filter(|_| !is_unknown).collect();
        (shades.titles::<L>(), shades.scale(), pixels)
    };
    let over = current.map_or_else(Vec::new, |id| outline(&own.surfaces, id, Role::Accent));
    let (title, bare) = titles;
    let raster = Raster {
        title,
        bare,
        scale,
        current: pixel_of(at).map(|pixel| pixel.map(|x| x as usize)),
        ..raster_so_far(&own.surfaces, pixels, over)
    };
    if at.step.event() != Some(Event::Done) {
        return raster;
    }
    let wrong = wrong_pixels(&own.surfaces, &so_far.picture);
    let name = |id| name_of(at.scenery, id);
    let names: Names<'_> = (&so_far.picture, &name);
    with_crosses(raster, names_triangles.then_some(names), &wrong)
}

fn in_brightness<L: Variant>(at: &At<'_, DepthBuffer<L>>, so_far: &DepthBufferOutput) -> Raster {
    let surfaces = &at.step.input.surfaces;
    let over = current(at).map_or_else(Vec::new, |id| outline(surfaces, id, Role::Accent));
    let mut raster = bright(surfaces, &so_far.brightness, over);
    raster.current = pixel_of(at).map(|pixel| pixel.map(|x| x as usize));
    if at.step.event() == Some(Event::Done) {
        raster = with_crosses(raster, None, &unsorted(surfaces, &so_far.brightness));
    }
    raster
}

/// The tone is the depth's, the hue this step's triangle's.
fn toned<'a, L: Variant>(
    so_far: &'a DepthBufferOutput,
    current: Option<u32>,
    shades: &'a Shades<'_>,
) -> impl Iterator<Item = Pixel> + 'a {
    let stored = so_far.picture.ids().iter().zip(&so_far.depth);
    stored.map(move |(&id, &depth)| {
        let is_current = current.is_some_and(|current| u32::try_from(id) == Ok(current));
        let role = if is_current { Role::Accent } else { Role::Soft };
        shades.pixel::<L>(depth, role)
    })
}

/// Pixels around one that might be written, on each side of it.
const AROUND: i64 = 2;
/// Of more triangles the tones of a few pixels would take long.
const MOST_TONED: usize = 1_000;

/// The pixel in hand and those around it, were the fragment written, or were it not. Behind glass neither would say all.
pub fn after<L: Variant>(at: &At<'_, DepthBuffer<L>>, is_written: bool) -> Option<Raster> {
    let (own, fragment) = (at.step.input, fragment_of(at)?);
    let plan = &at.scenery?.scene().raster;
    let is_plain = own.pixel.is_none() && own.surfaces.triangles().len() <= MOST_TONED;
    if !is_plain || of_glass(at).is_some() {
        return None;
    }
    let shades = Shades::of::<L>(own, plan);
    let so_far = &at.step.held.so_far;
    let [width, height] = own.surfaces.size().map(i64::from);
    let [column, row] = fragment.pixel.map(i64::from);
    let stored = |[x, y]: [i64; 2]| {
        if [x, y] == [column, row] {
            let written = (i32::try_from(fragment.id).ok()?, fragment.new);
            let left = (fragment.stored_id, fragment.stored);
            return Some(if is_written { written } else { left });
        }
        let is_there = (0..width).contains(&x) && (0..height).contains(&y);
        let place = is_there.then_some((y * width + x) as usize)?;
        Some((*so_far.picture.ids().get(place)?, *so_far.depth.get(place)?))
    };
    let pixel = |at: [i64; 2]| {
        let (id, depth) = stored(at)?;
        let is_own = u32::try_from(id) == Ok(fragment.id);
        let role = if is_own { Role::Accent } else { Role::Soft };
        Some(shades.pixel::<L>(depth, role))
    };
    let around = || -AROUND..=AROUND;
    let places = around().flat_map(|y| around().map(move |x| [column + x, row + y]));
    let side = (2 * AROUND + 1) as usize;
    Some(Raster {
        title: Value::Term("practice-then"),
        size: [side; 2],
        pixels: places.map(|at| pixel(at).unwrap_or(Pixel::EMPTY)).collect(),
        scale: None,
        under: Vec::new(),
        bare: None,
        current: Some([AROUND as usize; 2]),
        over: Vec::new(),
    })
}
