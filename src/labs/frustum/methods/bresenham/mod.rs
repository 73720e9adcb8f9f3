//! A line to its pixels, shown: the segment in the view volume, and the screen in large pixels.

mod lens;
mod picture;

use crate::{
    algo::pipeline::{DrawnSegment, LineToPixels, LineToPixelsEvent as Event, LineToPixelsInput},
    labs::frustum::prelude::*,
};

use super::super::screen::screen;

use lens::{Lens, candidates};
use picture::Known;

const RASTER_VIEW: &str = "raster";
const LENS_VIEW: &str = "lens";

/// Rows of large pixels, and so many columns at most.
const ROWS_OF_PIXELS: f64 = 15.0;
const MOST_COLUMNS: f64 = 40.0;

impl Answer for Vec<[i64; 2]> {
    fn told(&self) -> impl Serialize {
        json!({ "pixels": self })
    }
}

impl SpaceTelling for LineToPixels {
    const SUBJECT: Subject = Subject::Segment;

    fn input(scene: &Scene) -> LineToPixelsInput {
        let aspect = scene.camera.aspect();
        let rows = ROWS_OF_PIXELS.min(MOST_COLUMNS / aspect).max(1.0) as u32;
        LineToPixelsInput::Segment(DrawnSegment {
            ends: scene.places().segment,
            camera: *scene.camera.camera(),
            viewport: screen(aspect, rows),
        })
    }
}

const LEFT: &[&str] = &["~ P₁′ = {P₁′}", "~ P₂′ = {P₂′}"];
const DIAGONAL: &[&str] = &["~ e = {e} − 2 · {a} + 2 · {b}{=error}"];
const STRAIGHT: &[&str] = &["~ e = {e} + 2 · {b}{=error}"];

const fn put(line: usize, key: &'static str) -> Row {
    Row::new(Test, line, key).picks("at", "candidates")
}

fn error_before(step: &Step<'_, LineToPixels>) -> Option<i64> {
    Known::of(&step.past[..step.past.len().checked_sub(1)?]).error
}

impl Telling for LineToPixels {
    type Scenery = Scenery;

    const ID: &'static str = "bresenham";
    const NAME_KEY: &'static str = "alg-bresenham";
    const SOURCE: &'static str = "Bresenham, 1965";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-drawn-project", "words-drawn-project"),
        code_line(0, "code-drawn-clip", "words-drawn-clip"),
        code_line(0, "code-drawn-divide", "words-drawn-divide"),
        code_line(0, "code-drawn-begin", "words-drawn-begin"),
        code_line(0, "code-drawn-put", "words-drawn-put"),
        code_line(1, "code-drawn-diagonal", "words-drawn-diagonal"),
        code_line(2, "code-drawn-across", "words-drawn-across"),
        code_line(1, "code-drawn-straight", "words-drawn-straight"),
    ];
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "P₁", "P₂", "P₁′", "P₂′", "S₁", "S₂", "a", "b", "x, y", "error",
    ])];
    const OPENING: Row = Row::new(Phase, 0, "drawn-line-opening").so(&["{from → to}"]);

    table! { |event, step|
        project: Event::Project { clip: [.., w], .. } if w > 0.0 =>
            Row::new(Phase, 0, "drawn-line-project").so(&["~ {end} = {clip}"]);
        project_behind: Event::Project { .. } =>
            Row::new(Phase, 0, "drawn-line-project-behind").so(&["~ {end} = {clip}"]);
        whole: Event::Clip { ends } if Known::of(step.past).projected == ends.map(Some) =>
            Row::new(Cut, 1, "drawn-line-clip-whole").so(LEFT).keeps("segment").answers("clip");
        cut: Event::Clip { .. } =>
            Row::new(Cut, 1, "drawn-line-clip-cut").so(LEFT).cuts("segment").answers("clip");
        reject: Event::Reject =>
            Row::new(Reject, 1, "drawn-line-reject").drops("segment").answers("clip");
        divide: Event::Divide { .. } =>
            Row::new(Phase, 2, "drawn-line-divide").so(&["~ S₁ = {S₁}", "~ S₂ = {S₂}"]);
        round: Event::Round { .. } => Row::new(Phase, 3, "drawn-line-round").so(&["{from → to}"]);
        first: Event::Pixel { .. } if step.held.len() == 1 =>
            Row::new(Test, 4, "drawn-line-first").so(&["~ e = 2b − a = 2 · {b} − {a}{=error}"]);
        tie_diagonal: Event::Pixel { diagonal: true, .. } if error_before(step) == Some(0) =>
            put(6, "drawn-line-tie-diagonal").so(DIAGONAL);
        diagonal: Event::Pixel { diagonal: true, .. } => put(6, "drawn-line-diagonal").so(DIAGONAL);
        tie_straight: Event::Pixel { .. } if error_before(step) == Some(0) =>
            put(7, "drawn-line-tie-straight").so(STRAIGHT);
        straight: Event::Pixel { .. } => put(7, "drawn-line-straight").so(STRAIGHT);
    }

    fn opening(at: &At<'_, Self>) -> &'static Row {
        const SEGMENT: Row = LineToPixels::OPENING.so(&["~ P₁ = {given P₁}", "~ P₂ = {given P₂}"]);
        match at.step.input {
            LineToPixelsInput::Pixels(_) => &Self::OPENING,
            LineToPixelsInput::Segment(_) => &SEGMENT,
        }
    }

    fn named(at: &At<'_, Self>, of: &str) -> Option<Named> {
        let (input, event) = (at.step.input, at.step.event());
        let known = Known::of(at.step.past);
        let given = |i: usize| match input {
            LineToPixelsInput::Pixels(_) => None,
            LineToPixelsInput::Segment(drawn) => Some(list(&drawn.ends[i])),
        };
        let lengths = || {
            let ends = known.ends(input)?;
            let (distances, major) = (ends.distances(), ends.major());
            Some([distances[major], distances[1 - major]].map(|length| length as f64))
        };
        Some(match (of, event) {
            ("P₁", _) => list(&known.projected[0]?),
            ("P₂", _) => list(&known.projected[1]?),
            ("P₁′", _) => list(&known.clipped?[0]),
            ("P₂′", _) => list(&known.clipped?[1]),
            ("S₁", _) => list(&known.screen?[0]),
            ("S₂", _) => list(&known.screen?[1]),
            ("given P₁", _) => given(0)?,
            ("given P₂", _) => given(1)?,
            ("end", Some(Event::Project { end, .. })) => end_name(end).into(),
            ("clip", Some(Event::Project { clip, .. })) => list(&clip),
            ("w", Some(Event::Project { clip, .. })) => clip[3].into(),
            ("segment", _) => Named::from(Value::Term("part-segment")).linked(Link::to("segment")),
            ("from → to", _) => {
                let ends = known.ends(input)?;
                let from = pixel(Formula::decimals(), ends.from()).sym(" → ");
                pixel(from, ends.to()).into()
            }
            ("a", _) => lengths()?[0].into(),
            ("b", _) => lengths()?[1].into(),
            ("x, y", _) => list(&at.step.held.last()?.map(|x| x as f64)),
            ("at", _) => pixel(Formula::decimals(), *at.step.held.last()?).into(),
            ("e", _) => (error_before(&at.step)? as f64).into(),
            ("error", _) => Named::from(known.error? as f64).labelled(name("e")),
            _ => return None,
        })
    }

    /// The two pixels of which the next one was chosen.
    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let ends = Known::of(at.step.past).ends(at.step.input);
        let (Some(ends), [.., before, _]) = (ends, &at.step.held[..]) else {
            return Vec::new();
        };
        candidates(&ends, *before)
            .map(|at| pixel(Formula::decimals(), at).into())
            .to_vec()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let (Some(scenery), LineToPixelsInput::Segment(drawn)) = (at.scenery, at.step.input) else {
            return Vec::new();
        };
        let (known, event) = (Known::of(at.step.past), at.step.event());
        let marks = picture::marks(drawn, &known, event);
        let mut raster = picture::raster(drawn, &known, (at.step.held, event));
        let errors = at.step.past.iter().filter_map(|event| match *event {
            Event::Pixel { error, .. } => Some(error),
            _ => None,
        });
        let errors: Vec<i64> = errors.collect();
        let ends = known.ends(at.step.input);
        let lens = ends.and_then(|ends| Lens::new(ends, at.step.held, &errors, raster.size));
        let lens = lens.map(|lens| {
            raster.over.extend(lens.frame());
            View::new(LENS_VIEW, Body::Raster(lens.raster()))
        });
        let observer = scenery.observer(|_| Fate::ToCome, marks);
        let raster = View::new(RASTER_VIEW, Body::Raster(raster));
        [observer, raster].into_iter().chain(lens).collect()
    }
}

/// `(1.5, 2)`
fn list(numbers: &[f64]) -> Named {
    let formula = Formula::decimals().sym("(").list(numbers).sym(")");
    formula.into()
}

fn pixel(formula: Formula, at: [i64; 2]) -> Formula {
    let formula = formula.sym("[");
    formula.list(&at.map(|x| x as f64)).sym("]")
}
