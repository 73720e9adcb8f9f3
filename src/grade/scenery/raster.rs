//! Cases of pixels: what a program paints beside what is true, a cross where it is wrong, a ring where that is right.

use std::collections::HashSet;

use serde_json::Value as Json;

use crate::{
    figure::{Body, Pixel, Raster, RasterMark, RasterShape, Role, View},
    text::{Formula, Message, Value},
};

use super::{super::whole::Whole, Scenery, told::numbers};

type At = [i64; 2];

/// Of more columns or rows those around the first pixel that differs.
const MOST_SIDE: i64 = 32;
/// Tones of neighbours, a clear step apart.
const TONES: [f64; 4] = [0.4, 0.9, 0.1, 0.65];
/// Depths are written in thousandths.
const THOUSANDTHS: f64 = 1e3;

pub(super) fn scenery(case: &Json, output: &Json, whole: &Whole) -> Option<Scenery> {
    if case.get("from").is_some() {
        return line(output, whole);
    }
    let [width, height] = size(case)?;
    let whole_raster = Sheet {
        first: [0, 0],
        size: [width, height],
    };
    if whole.step.is_some() {
        let pixel = |json: &Json| json.get("pixel").and_then(whole_place);
        let [truth, said] = whole.each().map(|(json, _)| pixel(json));
        let sheet = whole_raster.around(truth.or(said)?);
        let marks = [(truth, true), (said, false)].into_iter();
        let marks = marks.filter_map(|(at, is_true)| Some(sheet.mark(at?, is_true)));
        let pixels = |at: At| shown(output, at, width, "ids");
        let title = Value::Term("grade-raster-true");
        let view = sheet.view("true", title, pixels, marks.collect());
        return Some(Scenery::Views(vec![view]));
    }
    let field = whole.field();
    let differ = differing(whole, field, width)?;
    let first = *differ.first()?;
    let sheet = whole_raster.around(first);
    let title = Message::new("grade-raster-said")
        .with("count", differ.len())
        .with(
            "at",
            Formula::default().sym(format!("[{}, {}]", first[0], first[1])),
        );
    let views = [
        ("said", Value::Message(title), &whole.said, false),
        ("true", Value::Term("grade-raster-true"), output, true),
    ];
    let views = views.map(|(id, title, json, is_true)| {
        let inside = differ.iter().filter(|&&at| sheet.has(at));
        let marks = inside.map(|&at| sheet.mark(at, is_true));
        let pixels = |at: At| shown(json, at, width, field);
        sheet.view(id, title, pixels, marks.collect())
    });
    Some(Scenery::Views(views.into()))
}

fn size(case: &Json) -> Option<At> {
    case.get("size").and_then(whole_place)
}

fn whole_place(json: &Json) -> Option<At> {
    numbers::<2>(json).map(|at| at.map(|x| x as i64))
}

/// The pixels whose entries of a list are not the same; none where it is no list of pixels.
fn differing(whole: &Whole, field: &str, width: i64) -> Option<Vec<At>> {
    if !["ids", "depth", "brightness"].contains(&field) {
        return None;
    }
    let list = |json: &Json| json.get(field)?.as_array().cloned();
    let (truth, said) = (list(&whole.truth)?, list(&whole.said).unwrap_or_default());
    // What differs by less than it may does not count: the first that counts is known.
    let first = whole.nth().unwrap_or_default();
    let is_off = |i: &usize| {
        let pair = [truth.get(*i), said.get(*i)].map(|json| json.and_then(Json::as_f64));
        match pair {
            [Some(truth), Some(said)] => (truth - said).abs() > 1e-9 * truth.abs().max(1.0),
            [None, None] => said.get(*i).is_none(),
            [Some(_), None] | [None, Some(_)] => true,
        }
    };
    let places = (first..truth.len()).filter(|i| *i == first || is_off(i));
    Some(
        places
            .map(|i| [i as i64 % width, i as i64 / width])
            .collect(),
    )
}

/// A pixel of a picture: its tone says whose it is, and written in it stands the entry of `field`.
fn shown(picture: &Json, [x, y]: At, width: i64, field: &str) -> Pixel {
    let entry = |field: &str| picture.get(field)?.get((y * width + x) as usize);
    let id = entry("ids").and_then(Json::as_u64);
    let value = match field {
        "ids" => id.map(|id| Value::Count(id as usize)),
        _ => entry(field).and_then(Json::as_f64).map(|part| {
            let thousandths = (part * THOUSANDTHS).round().max(0.0);
            Value::Count(thousandths as usize)
        }),
    };
    Pixel {
        role: id.map(|_| Role::Soft),
        shade: TONES[id.unwrap_or_default() as usize % TONES.len()],
        value,
    }
}

/// A line's pixels: those that are true filled.
fn line(output: &Json, whole: &Whole) -> Option<Scenery> {
    let pixels = |json: &Json| -> Vec<At> {
        let list = json.get("pixels").and_then(Json::as_array);
        list.into_iter().flatten().filter_map(whole_place).collect()
    };
    let truth: HashSet<At> = pixels(output).into_iter().collect();
    let at = |json: &Json| json.get("at").and_then(whole_place);
    let of_step = whole.each().map(|(json, _)| at(json));
    let [missed, wrong]: [Vec<At>; 2] = match (whole.step, of_step) {
        (Some(_), [truth, said]) => [truth, said].map(|at| at.into_iter().collect()),
        (None, _) => {
            let said = pixels(&whole.said);
            let known: HashSet<At> = said.iter().copied().collect();
            let missed = pixels(output).into_iter().filter(|at| !known.contains(at));
            let wrong = said.into_iter().filter(|at| !truth.contains(at));
            [missed.collect(), wrong.collect()]
        }
    };
    let first = *missed.first().or(wrong.first())?;
    let sheet = Sheet::of(&truth.iter().chain(&missed).chain(&wrong))?.around(first);
    let marks = [(missed, true), (wrong, false)].into_iter();
    let marks = marks.flat_map(|(pixels, is_true)| {
        let inside = pixels.into_iter().filter(|&at| sheet.has(at));
        inside.map(move |at| sheet.mark(at, is_true))
    });
    let filled = |at: At| Pixel {
        role: truth.contains(&at).then_some(Role::Accent),
        ..Pixel::EMPTY
    };
    let title = Value::Term("grade-raster-true");
    let view = sheet.view("true", title, filled, marks.collect());
    Some(Scenery::Views(vec![view]))
}

/// The pixels that are drawn.
#[derive(Clone, Copy)]
struct Sheet {
    first: At,
    size: At,
}

impl Sheet {
    /// All of these, and one around.
    fn of<'a>(pixels: &(impl Iterator<Item = &'a At> + Clone)) -> Option<Self> {
        let ends = |axis: usize| {
            let along = pixels.clone().map(move |at| at[axis]);
            Some([along.clone().min()? - 1, along.max()? + 1])
        };
        let [x, y] = [ends(0)?, ends(1)?];
        Some(Self {
            first: [x[0], y[0]],
            size: [x, y].map(|[low, high]| high - low + 1),
        })
    }

    /// As much of it as has room around a pixel.
    fn around(self, pixel: At) -> Self {
        let along = |axis: usize| {
            let [first, size] = [self.first[axis], self.size[axis]];
            let side = size.min(MOST_SIDE);
            let from = (pixel[axis] - side / 2).min(first + size - side).max(first);
            [from, side]
        };
        let [x, y] = [along(0), along(1)];
        Self {
            first: [x[0], y[0]],
            size: [x[1], y[1]],
        }
    }

    fn has(self, at: At) -> bool {
        (0..2).all(|axis| (0..self.size[axis]).contains(&(at[axis] - self.first[axis])))
    }

    fn mark(self, at: At, is_true: bool) -> RasterMark {
        let middle = [0, 1].map(|axis| (at[axis] - self.first[axis]) as f64 + 0.5);
        let shape = if is_true {
            RasterShape::Ring(middle)
        } else {
            RasterShape::Cross(middle)
        };
        let role = super::plane::role(is_true);
        RasterMark { role, shape }
    }

    fn view(
        self,
        id: &'static str,
        title: Value,
        pixel: impl Fn(At) -> Pixel,
        over: Vec<RasterMark>,
    ) -> View {
        let [columns, rows] = self.size;
        let [x, y] = self.first;
        let places =
            (0..rows).flat_map(|row| (0..columns).map(move |column| [x + column, y + row]));
        let raster = Raster {
            title,
            size: self.size.map(|side| side as usize),
            pixels: places.map(pixel).collect(),
            scale: None,
            under: Vec::new(),
            bare: None,
            current: None,
            over,
        };
        View::new(id, Body::Raster(raster))
    }
}
