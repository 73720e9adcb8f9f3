//! What the surfaces lab adds to the window: what it costs to find who is in front, as lines over the number of triangles, and
//! how steep they are.

mod surface_costs;

use egui_plot::LineStyle;

use crate::labs::surfaces::{self, SurfaceCounts, fitted_slope};

use super::{prelude::*, space::SpacePanel};

use surface_costs::SurfaceCosts;

pub fn panel() -> SpacePanel<SurfaceCosts> {
    SpacePanel::new(surfaces::LAB, costs_view)
}

fn costs_view(ui: &mut Ui, look: Look<'_>, costs: &mut SurfaceCosts, height: f32) {
    let sweep = &costs.sweep;
    let axes = ["surface-costs-triangles", "surface-costs-counts"];
    let lines = lines(look, sweep);
    power_plot(ui, look, ("surface-costs-lines", axes), height, &lines);
    if costs.is_done() {
        for message in told(sweep) {
            ui.label(RichText::new(look.catalog.message(&message)).text_style(theme::strong()));
        }
    }
}

#[derive(Clone, Copy)]
enum Counted {
    Pairs,
    Questions,
    Fragments,
}

impl Counted {
    const ALL: [Self; 3] = [Self::Pairs, Self::Questions, Self::Fragments];

    /// Over the number of triangles, as far as it is known and is not 0, which has no logarithm.
    fn points(self, sweep: &[SurfaceCounts]) -> Vec<[f64; 2]> {
        let count = |counts: &SurfaceCounts| match self {
            Self::Pairs => counts.pairs,
            Self::Questions => Some(counts.questions),
            Self::Fragments => Some(counts.tally.fragments),
        };
        let point = |counts: &SurfaceCounts| {
            let count = count(counts).filter(|count| *count > 0)?;
            Some([counts.n_triangles as f64, count as f64])
        };
        sweep.iter().filter_map(point).collect()
    }
}

fn lines(look: Look<'_>, sweep: &[SurfaceCounts]) -> Vec<PowerLine> {
    let line = |counted: Counted| {
        let theme = look.theme;
        let (name_key, color, style) = match counted {
            Counted::Pairs => ("alg-painter", theme.soft, LineStyle::dashed_loose()),
            Counted::Questions => ("alg-ray-casting", theme.ink, LineStyle::dotted_dense()),
            Counted::Fragments => ("alg-depth-buffer", theme.accent, LineStyle::Solid),
        };
        PowerLine {
            name_key,
            color,
            style,
            points: counted.points(sweep),
        }
    };
    Counted::ALL.map(line).into()
}

fn told(sweep: &[SurfaceCounts]) -> Vec<Message> {
    let slope = |counted: Counted| {
        let points = counted.points(sweep);
        let [n, count] = *points.last()?;
        let exponent = (100.0 * fitted_slope(&points)?).round() / 100.0;
        let key = match counted {
            Counted::Pairs => "surface-costs-pairs",
            Counted::Questions => "surface-costs-questions",
            Counted::Fragments => "surface-costs-fragments",
        };
        let message = Message::new(key)
            .with("triangles", n as usize)
            .with("count", count as usize);
        Some(message.with("exponent", Value::Number(exponent)))
    };
    let mut told: Vec<Message> = Counted::ALL.into_iter().filter_map(slope).collect();
    let last = sweep.last().filter(|counts| counts.tally.pixels > 0);
    told.extend(last.map(|counts| {
        let tally = counts.tally;
        let overdraw = tally.fragments as f64 / tally.pixels as f64;
        let overdraw = (100.0 * overdraw).round() / 100.0;
        Message::new("surface-costs-overdraw")
            .with("fragments", tally.fragments as usize)
            .with("pixels", tally.pixels as usize)
            .with("overdraw", Value::Number(overdraw))
    }));
    told
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_ends_where_nothing_was_counted() {
        let counts = |n: usize, pairs| SurfaceCounts {
            n_triangles: n,
            pairs,
            questions: 192 * n as u64,
            ..SurfaceCounts::default()
        };
        let sweep = [
            counts(10, Some(90)),
            counts(100, Some(9900)),
            counts(1000, None),
        ];
        assert_eq!(Counted::Pairs.points(&sweep).len(), 2);
        assert_eq!(Counted::Questions.points(&sweep).len(), 3);
        assert!(Counted::Fragments.points(&sweep).is_empty());
        let keys: Vec<&str> = told(&sweep).iter().map(|message| message.key).collect();
        assert_eq!(keys, ["surface-costs-pairs", "surface-costs-questions"]);
    }
}
