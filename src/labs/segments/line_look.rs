//! What is particular to each kind of bounds: how its planes, its numbers and its crossings are called, written and drawn.

use crate::{
    algo::{
        parameter::{End, Ratio},
        segment::{Bounds, RowNumbers},
    },
    figure::{Body, TableNote, View},
    labs::{Answer, CodeLine, interval::quotient, telling::Named},
    text::{Formula, Value},
};

use super::{LineStep, SeenRow};

/// Catalogue keys of what is said.
#[derive(Debug)]
pub struct LineKeys {
    /// What is asked.
    pub opening: &'static str,
    /// P₂ − P₁ is worked out.
    pub delta: &'static str,
    /// A row: the line comes in, goes out, is parallel.
    pub row: [&'static str; 3],
    /// Parallel and inside, and outside.
    pub parallel: [&'static str; 2],
    /// Coming in raises the lower bound, or does not.
    pub enter: [&'static str; 2],
    /// Going out lowers the upper bound, or does not.
    pub leave: [&'static str; 2],
    /// An end is put in place.
    pub put: &'static str,
    /// The end, where one point is left, and where one was given.
    pub one_point: [&'static str; 2],
    /// The end, where a plane rejects.
    pub reject: &'static str,
}

/// Bounds that can be shown.
pub trait LineLook<const N: usize>: Bounds<N, Output: Answer> {
    /// What is drawn around a run.
    type Scenery: 'static;
    /// Author and year.
    const SOURCE: &'static str;
    /// What is said.
    const KEYS: LineKeys;
    /// The names that the watch table begins with.
    const WATCHED: &'static [&'static str];
    /// The parameter along the segment, and where it crosses a plane.
    const SYMBOLS: [&'static str; 2];
    /// Over the two numbers of a row.
    const HEADER: [&'static str; 2];
    /// The quotient of them, as it is written: above, below, each a symbol or one minus another.
    const QUOTIENT: [&'static [&'static str]; 2];
    /// Its sign and that of the denominator, beside q/p.
    const SIGN: f64;
    /// What stands before the number that decides of a parallel line.
    const PARALLEL: &'static str;
    /// The view of the rows.
    const ROWS_VIEW: &'static str;
    /// Catalogue key: what is over the names of the planes.
    const PLANES: &'static str = "column-plane";
    /// Catalogue keys: how a crossing moves the bounds.
    const NOTES: [&'static str; 2];
    /// Has the watch table a row for each plane from the start, and a word on which way the line goes?
    const WATCHES: [bool; 2];
    /// Are the planes the rows of the table, and the interval an axis? Else the points are.
    const SHOWS_PLANES: bool = true;

    /// A plane's name in a sentence, with its link.
    fn plane(plane: Self::Plane, scenery: Option<&Self::Scenery>) -> Named;

    /// Its name in the table.
    fn plane_in_table(plane: Self::Plane, scenery: Option<&Self::Scenery>) -> Option<Value> {
        Self::plane(plane, scenery).value
    }

    /// The two numbers of a row under [`LineLook::HEADER`].
    fn numbers(&self, ends: &[[f64; N]; 2], row: &SeenRow<N, Self>) -> [f64; 2];

    /// What they are, where a symbol says it.
    fn meaning(plane: Self::Plane) -> Option<[String; 2]>;

    /// How the two are worked out.
    fn row_formulas(&self, ends: &[[f64; N]; 2], row: &SeenRow<N, Self>) -> Vec<Formula>;

    /// How an end came to its place on a plane.
    fn put_formulas(
        shown: &LineStep<'_, N, Self>,
        end: End,
        plane: Self::Plane,
        at: [f64; N],
    ) -> Vec<Formula>;

    /// `x = 1`, or the plane's name.
    fn border(&self, plane: Self::Plane, scenery: Option<&Self::Scenery>) -> Value;

    /// What else stands under the rows.
    fn other_notes(_: &LineStep<'_, N, Self>) -> Vec<TableNote> {
        Vec::new()
    }

    /// What stands over r: how it is worked out, where there is room.
    fn quotient_header() -> Formula {
        Formula::default().sym(Self::SYMBOLS[1])
    }

    /// Does the table begin with the whole interval?
    const STARTS_WHOLE: bool = false;

    /// What stands beside the drawing in rows, where it is not the planes in their order.
    fn rows(_: &LineStep<'_, N, Self>) -> Option<Body> {
        None
    }

    /// The drawing, and what stands beside it but for the table.
    fn drawing(shown: &LineStep<'_, N, Self>, scenery: Option<&Self::Scenery>) -> Vec<View>;
}

/// How a method of certain rules is called.
pub trait LineVariant<const N: usize, B>: Copy + 'static {
    /// As JSON spells it.
    const ID: &'static str;
    /// Catalogue key of its name.
    const NAME_KEY: &'static str;
    /// Its pseudocode: seven lines, of the same sense in all of them.
    const CODE: &'static [CodeLine];
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
}

/// The crossing's parameter as the quotient that it was computed as, by the signs that the method writes.
pub fn ratio<const N: usize, B: LineLook<N>>(row: &SeenRow<N, B>, r: f64) -> Ratio {
    let zero = 0.0;
    let signed = |x: f64| if B::SIGN < 0.0 { zero - x } else { x };
    let [p, q] = row.numbers.p_and_q();
    quotient(signed(q), signed(p), r)
}
