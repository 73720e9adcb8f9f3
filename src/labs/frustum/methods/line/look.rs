//! What is particular to each kind of bounds: how its planes, its numbers and its crossings are called and written.

use crate::{
    algo::{
        parameter::{End, Ratio},
        volume::{Bounds, LineEvent, LineInput, LineRow, LineState},
    },
    figure::{Link, Table, View},
    labs::{CodeLine, crossing_formulas::Weights, interval::quotient},
    text::{Formula, Message, Value},
};

use super::super::super::{OnSceneInput, Scene, Subject, stage::Scenery};

/// What happens.
pub type Event<P, const N: usize> = LineEvent<P, N>;
/// What a method runs on.
pub type Input<const N: usize, B> = OnSceneInput<LineInput<N, B>>;

/// `(1, 0, 2)`, as many as there are.
pub fn listed<const N: usize>(at: &[f64; N]) -> Formula {
    Formula::default().sym("(").list(at).sym(")")
}

/// `P₁ = (1, 0, 2)`
pub fn end_formula<const N: usize>(symbol: &'static str, at: &[f64; N]) -> Formula {
    let formula = Formula::default().sym(symbol).sym(" = (");
    formula.list(at).sym(")")
}

/// The symbol of an end that has been put in place.
const fn put_symbol(end: End) -> &'static str {
    match end {
        End::P1 => "P₁′",
        End::P2 => "P₂′",
    }
}

/// A plane that can be shown.
pub trait PlaneLook {
    /// Its number among the six of a volume.
    fn idx(self) -> usize;

    /// Its name.
    fn name(self, scenery: Option<&Scenery>) -> Value;

    /// What marks and rows about it have in common.
    fn link(self) -> Link;
}

/// Bounds that can be shown.
pub trait LineLook<const N: usize>: Bounds<N, Plane: PlaneLook> {
    /// What the method is about.
    const SUBJECT: Subject;
    /// Author and year.
    const SOURCE: &'static str;
    /// The parameter along the segment, and where it crosses a plane.
    const SYMBOLS: [&'static str; 2];
    /// Over the two numbers of a row.
    const HEADER: [&'static str; 2];
    /// The quotient of them, as it is written: above, below, each a symbol or one minus another.
    const QUOTIENT: [&'static [&'static str]; 2];
    /// Its sign and that of the denominator, beside q/p.
    const SIGN: f64;
    /// Are the planes the rows of the table, and the interval an axis? Else the points are.
    const SHOWS_PLANES: bool;

    /// Its input, from the scene.
    fn input(scene: &Scene) -> LineInput<N, Self>;

    /// What is asked.
    fn opening(&self) -> Message;

    /// The two numbers of a row under [`LineLook::HEADER`].
    fn numbers(&self, ends: &[[f64; N]; 2], row: &LineRow<Self::Plane>) -> [f64; 2];

    /// What they are, where a symbol says it.
    fn meaning(plane: Self::Plane) -> Option<[String; 2]>;

    /// How the two are worked out.
    fn row_formulas(
        &self,
        ends: &[[f64; N]; 2],
        state: &LineState<Self::Plane, N>,
        row: &LineRow<Self::Plane>,
    ) -> Vec<Formula>;

    /// How an end came to its place on a plane.
    fn put_formulas(
        &self,
        end: End,
        plane: Self::Plane,
        ends: &[[f64; N]; 2],
        at: [f64; N],
    ) -> Vec<Formula> {
        let weights = Weights::across(self.distances(plane, ends));
        vec![weights.mean_of_places(put_symbol(end), ends, at)]
    }

    /// `x = 1`, or the plane's name.
    fn border(&self, scenery: Option<&Scenery>, plane: Self::Plane) -> Value;

    /// What stands beside the drawing in rows, where it is not the planes.
    fn points(_: &ShownLine<'_, N, Self>) -> Option<Table> {
        None
    }

    /// The drawing, and what stands beside it but for the table.
    fn drawing(shown: &ShownLine<'_, N, Self>, scenery: &Scenery) -> Vec<View>;
}

/// A step of a line clipper, whatever its rules.
pub struct ShownLine<'a, const N: usize, B: LineLook<N>> {
    /// What it runs on.
    pub input: &'a LineInput<N, B>,
    /// After the event.
    pub state: &'a LineState<B::Plane, N>,
    /// The plane that the step is about.
    pub in_hand: Option<B::Plane>,
    /// Are the ends divided before they are clipped?
    pub is_divided: bool,
    /// What is left of the parameter.
    pub interval: crate::labs::interval::ShownInterval,
}

/// How a method of certain rules is called.
pub trait Variant<const N: usize, B>: Copy + 'static {
    /// As JSON spells it.
    const ID: &'static str;
    /// Catalogue key of its name.
    const NAME_KEY: &'static str;
    /// Its pseudocode.
    const CODE: &'static [CodeLine];
    /// Of a mistake: what is said at the first step that the right rules do not do.
    const DIFFERS_KEY: Option<&'static str> = None;
}

/// The crossing's parameter as the quotient that it was computed as, by the signs that the method writes.
pub fn ratio<const N: usize, B: LineLook<N>>(row: &LineRow<B::Plane>, r: f64) -> Ratio {
    let zero = 0.0;
    let signed = |x: f64| if B::SIGN < 0.0 { zero - x } else { x };
    quotient(signed(row.q), signed(row.p), r)
}
