//! Clipping by inequalities, told: against a window, a polygon, a box, planes and in clip space the same steps, said in each
//! one's own words.

use crate::{
    figure::Tick,
    labs::interval::{difference, quotient_formula},
};

use super::{
    ends::{end_named, is_point, left_in, place},
    line_step::{LineLook, LineStep, LineVariant, ratio},
    line_table::{row_values, rows_table},
    prelude::*,
};

const AXIS_VIEW: &str = "axis";

pub const START: usize = 0;
pub const EACH: usize = 1;
pub const PARALLEL: usize = 2;
const ENTER: usize = 3;
const LEAVE: usize = 4;
const EMPTY: usize = 5;
pub const ACCEPT: usize = 6;
pub const N_LINES: usize = ACCEPT + 1;

const fn bound_row(line: usize, key: &'static str, question: &'static str) -> Row {
    let row = Row::new(Cut, line, key).so(&["{r = q/p}", "{u = max(u, r)}"]);
    row.about("plane").answers(question)
}

const fn depths_row(key: &'static str) -> Row {
    Row::new(Test, START, key).so(&["w₁ = {w₁}", "w₂ = {w₂}"])
}

const fn plane_row(key: &'static str) -> Row {
    let row = Row::new(Phase, EACH, key).so(&["{1st}", "{2nd}"]);
    row.about("plane").picks("direction", "directions")
}

/// The last word where something is visible; in clip space also where its ends come to lie on the screen.
const fn accept_row(key: &'static str) -> Row {
    Row::new(Accept, ACCEPT, key).so(&["{P₁′/w}", "{P₂′/w}"])
}

const fn row(tick: Tick, line: usize, key: &'static str) -> Row {
    Row::new(tick, line, key)
}

impl<const N: usize, B, L> Telling for LineClip<N, B, L>
where
    B: LineLook<N>,
    L: LineRules + LineVariant<N, B>,
{
    type Scenery = B::Scenery;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = B::SOURCE;
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[Watched::Names(B::WATCHED)];

    table! { |event, step|
        delta: LineEvent::Delta { .. } => row(Test, START, B::KEYS.delta).so(&["{x}", "{y}", "{z}"]);
        divided: LineEvent::Depths { .. } if L::DIVIDES_FIRST =>
            row(Test, START, "space-line-divided").so(&["P₁ / w₁ = {P₁}", "P₂ / w₂ = {P₂}"]);
        in_front: LineEvent::Depths { behind: [false, false], .. } =>
            depths_row("space-line-before").answers("behind");
        all_behind: LineEvent::Depths { behind: [true, true], .. } =>
            depths_row("space-line-all-behind").answers("behind").drops("segment");
        behind: LineEvent::Depths { .. } =>
            depths_row("space-line-behind").answers_as("behind", "space-line-option-behind");
        comes_in: LineEvent::Row { row, .. } if row.p_and_q()[0] < 0.0 =>
            plane_row(B::KEYS.row[0]);
        goes_out: LineEvent::Row { row, .. } if row.p_and_q()[0] > 0.0 =>
            plane_row(B::KEYS.row[1]);
        goes_along: LineEvent::Row { .. } => plane_row(B::KEYS.row[2]);
        not_asked: LineEvent::Parallel { .. } if L::FORGETS_PARALLEL =>
            row(Phase, PARALLEL, "lb-parallel-forgotten").so(&["{of q}{q}"]);
        inside: LineEvent::Parallel { inside: true, .. } =>
            row(Test, PARALLEL, B::KEYS.parallel[0]).so(&["{of q}{q} ≥ 0"])
                .answers("parallel").keeps("segment");
        outside: LineEvent::Parallel { .. } =>
            row(Test, PARALLEL, B::KEYS.parallel[1]).so(&["{of q}{q} < 0"])
                .answers("parallel").drops("segment");
        raises: LineEvent::Enter { raises: true, .. } =>
            bound_row(ENTER, B::KEYS.enter[0], "raises").cuts("plane");
        enters: LineEvent::Enter { .. } => bound_row(ENTER, B::KEYS.enter[1], "raises");
        lowers: LineEvent::Leave { lowers: true, .. } =>
            bound_row(LEAVE, B::KEYS.leave[0], "lowers").cuts("plane");
        leaves: LineEvent::Leave { .. } => bound_row(LEAVE, B::KEYS.leave[1], "lowers");
        empty: LineEvent::Interval { empty: true, .. } =>
            row(Test, EMPTY, "param-empty").so(&["{min} = {u_min} > {max} = {u_max}"])
                .answers("left").drops("segment");
        one_left: LineEvent::Interval { u_min, u_max, .. } if u_min == u_max =>
            row(Test, EMPTY, "param-touch").so(&["{min} = {u_min} = {max} = {u_max}"])
                .answers("left").keeps("segment");
        left: LineEvent::Interval { .. } =>
            row(Test, EMPTY, "param-left").so(&["{min} = {u_min} < {max} = {u_max}"])
                .answers("left").keeps("segment");
        stays: LineEvent::Put { plane: None, .. } =>
            row(Cut, ACCEPT, "param-put-end").keeps("end");
        put: LineEvent::Put { .. } =>
            row(Cut, ACCEPT, B::KEYS.put).so(&["{1st}", "{2nd}", "{3rd}", "{4th}"]).cuts("end");
        point: LineEvent::Accept { .. } if is_point(step.input.ends()) =>
            accept_row(B::KEYS.one_point[1]);
        touch: LineEvent::Accept { ends } if is_point(ends) => accept_row(B::KEYS.one_point[0]);
        accept: LineEvent::Accept { .. } => accept_row("line-accept");
        reject: LineEvent::Reject { plane: Some(_) } => row(Reject, EMPTY, B::KEYS.reject);
        reject_behind: LineEvent::Reject { plane: None } =>
            row(Reject, START, "space-line-reject-behind");
    }

    const OPENING: Row =
        Row::new(Phase, START, B::KEYS.opening).so(&["P₁ = {given P₁}", "P₂ = {given P₂}"]);

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let shown = LineStep::of(&at.step);
        shown
            .whole(name)
            .or_else(|| shown.of_plane(at.scenery, name))
            .or_else(|| shown.of_interval(at.scenery, name))
            .or_else(|| shown.of_end(at.scenery, name))
    }

    fn listed(_: &At<'_, Self>, _: &str) -> Vec<Named> {
        [-1.0, 1.0, 0.0]
            .map(|p| Value::Term(direction(p)).into())
            .to_vec()
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let shown = LineStep::of(&at.step);
        let [first, second] = B::HEADER;
        let header = vec![first, second, B::SYMBOLS[1]];
        let rows = WatchSection::table(header, row_values(&shown, at.scenery));
        let bounds = WatchSection::list(shown.interval(at.scenery).bound_rows().collect());
        let mut watch: Watch = Self::WATCH.iter().map(|it| at.section(it)).collect();
        watch.extend(if B::SHOWS_PLANES {
            [rows.seen_in(B::ROWS_VIEW), bounds.seen_in(AXIS_VIEW)]
        } else {
            [rows, bounds]
        });
        watch
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let shown = LineStep::of(&at.step);
        let mut views = B::drawing(&shown, at.scenery);
        let rows = || Body::Table(rows_table(&shown, at.scenery));
        let rows = B::rows(&shown).unwrap_or_else(rows);
        views.push(View::new(B::ROWS_VIEW, rows));
        if B::SHOWS_PLANES {
            let interval = shown.interval(at.scenery);
            let axis = Body::NumberLine(interval.number_line(shown.reach()));
            views.push(View::new(AXIS_VIEW, axis));
        }
        views
    }
}

impl<const N: usize, B: LineLook<N>> LineStep<'_, N, B> {
    fn whole(&self, of: &str) -> Option<Named> {
        let end = |end: End, at: &[f64; N]| Named::from(place(at)).linked(end_link(end));
        let delta = |i: usize| Named::maybe(self.delta.map(|delta| delta[i]));
        let given = self.input.ends();
        Some(match of {
            "given P₁" => place(&given[0]).into(),
            "given P₂" => place(&given[1]).into(),
            "P₁" => end(End::P1, &self.ends[0]),
            "P₂" => end(End::P2, &self.ends[1]),
            "P₁′" => end(End::P1, self.put[0].as_ref()?),
            "P₂′" => end(End::P2, self.put[1].as_ref()?),
            "Δ" => place(self.delta.as_ref()?).into(),
            "Δx" => delta(0),
            "Δy" => delta(1),
            "x" | "y" | "z" => {
                let axis = ["x", "y", "z"].iter().position(|it| *it == of)?;
                let Some(LineEvent::Delta { delta }) = self.event else {
                    return None;
                };
                let difference = sym(format!("Δ{of} = ")).num(*given[1].get(axis)?);
                let difference = difference.sym(" − ").operand(*given[0].get(axis)?);
                difference.equals(*delta.get(axis)?).into()
            }
            "w₁" => (*given[0].last()?).into(),
            "w₂" => (*given[1].last()?).into(),
            "planes" => self.input.bounds().planes().count().into(),
            _ => return None,
        })
    }

    fn of_plane(&self, scenery: Option<&B::Scenery>, of: &str) -> Option<Named> {
        let plane = match self.event? {
            LineEvent::Put { plane, .. } => plane?,
            _ => self.in_hand()?,
        };
        let row = self.row_of(plane)?;
        Some(match (of, self.event?) {
            ("edge" | "plane" | "rejects", _) => B::plane(plane, scenery),
            ("k", _) => self.rows.len().into(),
            ("direction", _) => Value::Term(direction(row.p())).into(),
            ("of q", _) => name(B::PARALLEL).into(),
            ("q", LineEvent::Parallel { q, .. }) => q.into(),
            ("1st" | "2nd" | "3rd" | "4th", event) => {
                let nth = ["1st", "2nd", "3rd", "4th"];
                let nth = nth.iter().position(|it| *it == of)?;
                let formulas = match event {
                    LineEvent::Row { .. } => {
                        let bounds = self.input.bounds();
                        bounds.row_formulas(&self.ends, row)
                    }
                    LineEvent::Put { end, at, .. } => B::put_formulas(self, end, plane, at),
                    _ => return None,
                };
                formulas.into_iter().nth(nth)?.into()
            }
            ("bound" | "r = q/p" | "u = max(u, r)", event) => {
                let (side, r, new) = match event {
                    LineEvent::Enter { r, u_min, .. } => (Side::Entering, r, u_min),
                    LineEvent::Leave { r, u_max, .. } => (Side::Leaving, r, u_max),
                    _ => return None,
                };
                let (before, quotient) = (self.before(), ratio(row, r));
                let before = before.interval(scenery);
                match of {
                    "bound" => name(before.bound_symbol(side)).into(),
                    "r = q/p" => {
                        let terms = B::QUOTIENT.map(difference);
                        quotient_formula(B::SYMBOLS[1], terms, quotient).into()
                    }
                    _ => before.bound_formula(side, r, quotient, new).into(),
                }
            }
            _ => return None,
        })
    }

    fn of_interval(&self, scenery: Option<&B::Scenery>, of: &str) -> Option<Named> {
        let interval = self.interval(scenery);
        let crossed = |end: End| {
            let plane = self.set_by[end.idx()].filter(|_| interval.is_crossed_over())?;
            Some(B::plane(plane, scenery))
        };
        Some(match of {
            "min" => name(interval.bound_symbol(Side::Entering)).into(),
            "max" => name(interval.bound_symbol(Side::Leaving)).into(),
            "u_min" => interval.written(self.bounds[0]).into(),
            "u_max" => interval.written(self.bounds[1]).into(),
            "enters" => crossed(End::P1)?,
            "leaves" => crossed(End::P2)?,
            _ => return None,
        })
    }

    fn of_end(&self, scenery: Option<&B::Scenery>, of: &str) -> Option<Named> {
        Some(match (of, self.event?) {
            ("end", LineEvent::Put { end, .. }) => end_named(end),
            (
                "end",
                LineEvent::Depths {
                    behind: [true, _], ..
                },
            ) => end_named(End::P1),
            ("end", LineEvent::Depths { .. }) => end_named(End::P2),
            ("at", LineEvent::Put { at, .. }) => place(&at).into(),
            ("symbol", _) => name(B::SYMBOLS[0]).into(),
            ("u" | "t", LineEvent::Put { u, plane, .. }) => {
                let row = plane.and_then(|plane| self.row_of(plane));
                let row = row.filter(|_| N > 2);
                let written = || self.interval(scenery).written(u);
                let written = row.map_or_else(written, |row| value_of(ratio(row, u)));
                written.into()
            }
            ("border", LineEvent::Put { plane, .. }) => {
                let bounds = self.input.bounds();
                bounds.border(plane?, scenery).into()
            }
            ("P₁′/w" | "P₂′/w", LineEvent::Accept { ends }) if N == 4 => {
                let (w, place) = ends[usize::from(of == "P₂′/w")].split_last()?;
                let image: Vec<f64> = place.iter().map(|x| x / w).collect();
                let symbols = ["P₁′ / w = ", "P₂′ / w = "];
                let formula = sym(symbols[usize::from(of == "P₂′/w")]);
                let formula = formula.sym("(").list(&image).sym(")");
                Some(formula).filter(|_| *w > 0.0)?.into()
            }
            _ => return left_in(self.verdict.flatten(), of),
        })
    }
}
