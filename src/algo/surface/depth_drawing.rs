//! The loops of the depth buffer: triangle by triangle, row by row, pixel by pixel.

use std::marker::PhantomData;

use serde::Serialize;

use crate::trace::Real;

use super::{
    DepthBufferInput, DepthFormat, Picture, SurfaceRules,
    coverage::{Coverage, Span},
};

/// What comes of one triangle at one pixel.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Fragment {
    /// Of the triangle.
    pub id: u32,
    /// Column and row.
    pub pixel: [u32; 2],
    /// (z/w + 1) / 2
    pub depth: f64,
    /// The same as the buffer stores it.
    pub new: f64,
    /// What stood there; not finite where nothing had been written.
    pub stored: f64,
    /// Whose that was, or [`Picture::BACKGROUND`].
    pub stored_id: i32,
    /// Is it written?
    pub kept: bool,
}

/// How much has been done.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct FragmentTally {
    /// Fragments so far.
    pub fragments: u64,
    /// As many of them as were written.
    pub writes: u64,
    /// Pixels that have been written at all.
    pub pixels: u64,
}

/// Every fragment that reaches a pixel, in order: one run, at this pixel only.
#[must_use]
pub fn pixel_story<L: SurfaceRules>(input: &DepthBufferInput, pixel: [u32; 2]) -> Vec<Fragment> {
    let mut story = Vec::new();
    let input = DepthBufferInput {
        pixel: Some(pixel),
        ..input.clone()
    };
    Drawing::<L>::new(&input).all::<f64>(&mut |told| {
        if let Told::Fragment(fragment) = told {
            story.push(fragment);
        }
    });
    story
}

impl FragmentTally {
    pub(super) fn add(&mut self, fragment: &Fragment) {
        self.fragments += 1;
        if fragment.kept {
            self.writes += 1;
            self.pixels += u64::from(fragment.stored_id == Picture::BACKGROUND);
        }
    }
}

pub(super) fn cleared<L: SurfaceRules>(format: &DepthFormat) -> f64 {
    if L::CLEARS_TO_NEAR {
        format.nearest()
    } else {
        format.nothing()
    }
}

/// What the loops come past.
pub(super) enum Told {
    Triangle { id: u32, drawn: bool },
    Fragment(Fragment),
    SpanDone { row: u32, columns: [u32; 2] },
    TriangleDone,
}

/// The loops, with what they fill.
pub(super) struct Drawing<'a, L> {
    input: &'a DepthBufferInput,
    pub picture: Picture,
    pub depth: Vec<f64>,
    rules: PhantomData<L>,
}

impl<'a, L: SurfaceRules> Drawing<'a, L> {
    pub fn new(input: &'a DepthBufferInput) -> Self {
        Self {
            input,
            picture: Picture::empty(input.surfaces.size()),
            depth: vec![cleared::<L>(&input.format); input.surfaces.n_pixels()],
            rules: PhantomData,
        }
    }

    pub fn all<R: Real>(&mut self, tell: &mut impl FnMut(Told)) {
        for &id in &self.input.order {
            self.triangle::<R>(id, tell);
        }
    }

    /// One of them.
    pub fn triangle<R: Real>(&mut self, id: u32, tell: &mut impl FnMut(Told)) {
        let input = self.input;
        let [_, height] = input.surfaces.size();
        let rows = input.pixel.map_or(0..height, |[_, row]| {
            row.min(height)..row.saturating_add(1).min(height)
        });
        let Some(triangle) = input.surfaces.triangles().get(id as usize) else {
            return;
        };
        let coverage = Coverage::of::<L>(&input.surfaces, triangle);
        let drawn = coverage.is_some();
        tell(Told::Triangle { id, drawn });
        if let Some(coverage) = coverage {
            let viewport = input.surfaces.viewport();
            coverage.for_each_span(viewport, &rows, |span| self.span::<R>(id, span, tell));
        }
        tell(Told::TriangleDone);
    }

    fn span<R: Real>(&mut self, id: u32, span: Span<'_>, tell: &mut impl FnMut(Told)) {
        let [first, end] = span.columns;
        let columns = match self.input.pixel {
            Some([column, _]) => first.max(column)..end.min(column.saturating_add(1)),
            None => first..end,
        };
        for column in columns {
            let fragment = self.fragment::<R>(id, [column, span.row], span.depth::<R>(column));
            tell(Told::Fragment(fragment));
        }
        let (row, columns) = (span.row, span.columns);
        tell(Told::SpanDone { row, columns });
    }

    fn fragment<R: Real>(&mut self, id: u32, pixel: [u32; 2], depth: f64) -> Fragment {
        let format = &self.input.format;
        let (place, new) = (self.picture.place(pixel), format.stored(depth));
        let (stored, stored_id) = (self.depth[place], self.picture.ids()[place]);
        let [front, behind] = if L::TURNS_COMPARISON {
            [stored, new]
        } else {
            [new, stored]
        };
        let kept = !L::COMPARES || format.is_nearer::<R>(front, behind);
        if kept {
            self.depth[place] = new;
            self.picture.put(pixel, id);
        }
        Fragment {
            id,
            pixel,
            depth,
            new,
            stored,
            stored_id,
            kept,
        }
    }
}
