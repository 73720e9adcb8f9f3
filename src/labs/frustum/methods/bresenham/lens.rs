//! 5 × 3 pixels about the one in hand, large: between which two the line runs, and how far it is from their midpoint.
//!
//! ```text
//!   ┌─────┬─────┬─────┬─────┬─────┐
//!   ├──┬──┼─────┼─────┼─────┼─────┤   ┬ a midpoint, │ from it to the line: e / 2a of a pixel
//!   │  │  │  │  │  │  │  ●  │     │   ● the pixel that is taken, × the one that is not
//!   ├─────┼──┴──┼──┴──┼──┼──┼──┬──┤
//!   │     │     │     │  ×  │  │  │
//!   └─────┴─────┴─────┴─────┴─────┘
//! ```

use crate::{algo::pipeline::BresenhamInput, labs::frustum::prelude::*};

use super::picture::{PUT, centre, framed, mark};

/// Behind the pixel in hand, the pixel, and before it; to either side of it.
const ALONG: [i64; 2] = [3, 1];
const ACROSS: i64 = 3;
/// Half of the stroke at a midpoint, in pixels.
const CAP: f64 = 0.12;

pub struct Lens<'a> {
    ends: BresenhamInput,
    put: &'a [[i64; 2]],
    /// e at each of the pixels that are put.
    errors: &'a [i64],
    size: [i64; 2],
    first: [i64; 2],
}

impl<'a> Lens<'a> {
    /// None before anything has been decided, and at the end.
    pub fn new(
        ends: BresenhamInput,
        put: &'a [[i64; 2]],
        errors: &'a [i64],
        screen: [usize; 2],
    ) -> Option<Self> {
        let (&at, before) = (put.last()?, *put.get(put.len().checked_sub(2)?)?);
        let major = ends.major();
        let (mut size, mut first) = ([ACROSS; 2], before.map(|x| x - ACROSS / 2));
        size[major] = ALONG[0] + 1 + ALONG[1];
        first[major] = at[major] - ALONG[usize::from(ends.to()[major] < ends.from()[major])];
        let first = [0, 1].map(|i| first[i].clamp(0, (screen[i] as i64 - size[i]).max(0)));
        let lens = Self {
            ends,
            put,
            errors,
            size,
            first,
        };
        (at != ends.to()).then_some(lens)
    }

    /// Its outline on the whole screen.
    pub fn frame(&self) -> impl Iterator<Item = RasterMark> {
        let to = [0, 1].map(|i| self.first[i] + self.size[i]);
        framed([self.first, to].map(|at| at.map(|x| x as f64)))
    }

    pub fn raster(&self) -> Raster {
        let [columns, rows] = self.size;
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row]));
        let is_put = |at: [i64; 2]| self.put.contains(&self.on_screen(at));
        let pixels = places.clone().map(|at| Pixel {
            role: is_put(at).then_some(Role::Accent),
            shade: PUT,
            value: None,
        });
        let not_taken = self
            .candidates(self.put.len() - 1)
            .into_iter()
            .find(|at| !self.put.contains(at));
        let middles = places
            .filter(|at| Some(self.on_screen(*at)) != not_taken)
            .map(|at| {
                let role = if is_put(at) { Role::Accent } else { Role::Soft };
                mark(role, RasterShape::Dot(centre(at)))
            });
        let mut over: Vec<RasterMark> = middles.collect();
        let line = [self.ends.from(), self.ends.to()].map(|at| self.in_lens(centre(at)));
        over.push(mark(Role::Ink, RasterShape::Line(line)));
        over.extend((1..=self.put.len()).flat_map(|nth| self.decision(nth)));
        over.extend(
            not_taken.map(|at| mark(Role::Signal, RasterShape::Cross(self.in_lens(centre(at))))),
        );
        let at = self.put[self.put.len() - 1];
        let two_a = 2.0 * self.ends.distances()[self.ends.major()] as f64;
        let title = Message::new("raster-lens").with("whole", Formula::decimals().num(two_a));
        Raster {
            title: Value::Message(title),
            size: self.size.map(|n| n as usize),
            pixels: pixels.collect(),
            scale: None,
            under: self.under(),
            bare: None,
            current: Some([0, 1].map(|i| (at[i] - self.first[i]) as usize)),
            over,
        }
    }

    fn on_screen(&self, at: [i64; 2]) -> [i64; 2] {
        [0, 1].map(|i| self.first[i] + at[i])
    }

    fn in_lens(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| at[i] - self.first[i] as f64)
    }

    fn candidates(&self, nth: usize) -> [[i64; 2]; 2] {
        candidates(&self.ends, self.put[nth - 1])
    }

    /// From the midpoint between two candidates to the line, by e; where that is nothing, to both of them.
    fn decision(&self, nth: usize) -> Vec<RasterMark> {
        let (major, candidates) = (self.ends.major(), self.candidates(nth));
        let [straight, aside] = candidates.map(|at| self.in_lens(centre(at)));
        let midpoint = [0, 1].map(|i| straight[i].midpoint(aside[i]));
        let two_a = 2.0 * self.ends.distances()[major] as f64;
        let part = self.errors[nth - 1] as f64 / two_a;
        let on_line = [0, 1].map(|i| midpoint[i] + part * (aside[i] - straight[i]));
        let is_now = nth + 1 == self.put.len();
        let role = if is_now {
            Role::Signal
        } else {
            Role::Discarded
        };
        let tick = [-CAP, CAP].map(|aside| {
            let mut at = midpoint;
            at[major] += aside;
            at
        });
        let tick = mark(role, RasterShape::Line(tick));
        if part != 0.0 {
            return vec![tick, mark(role, RasterShape::Bar([midpoint, on_line]))];
        }
        let halves = [straight, aside].map(|at| mark(role, RasterShape::Line([midpoint, at])));
        [tick].into_iter().chain(halves).collect()
    }

    /// Under each column its e, where columns are what is walked along.
    fn under(&self) -> Vec<Value> {
        let error = |column: i64| {
            let is_there = |nth: &usize| self.candidates(*nth)[0][0] == self.first[0] + column;
            let nth = (1..=self.put.len()).find(is_there);
            nth.map_or(Value::Name(String::new()), |nth| {
                let error = self.errors[nth - 1] as f64;
                Value::Formula(Formula::decimals().sym("e = ").num(error))
            })
        };
        let columns = (0..self.size[0]).filter(|_| self.ends.major() == 0);
        columns.map(error).collect()
    }
}

/// Of which two the pixel after this one is chosen: straight on, and one aside.
pub fn candidates(ends: &BresenhamInput, before: [i64; 2]) -> [[i64; 2]; 2] {
    let (from, to, major) = (ends.from(), ends.to(), ends.major());
    let minor = 1 - major;
    let mut straight = before;
    straight[major] += (to[major] - from[major]).signum();
    let mut aside = straight;
    // Along an axis, too, there is one aside.
    aside[minor] += if to[minor] < from[minor] { -1 } else { 1 };
    [straight, aside]
}
