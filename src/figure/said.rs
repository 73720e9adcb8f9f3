//! What a frame says: every text and every number of its views and of its caption.

use crate::text::{Notation, Said, Value};

use super::{
    frame::{Caption, Frame},
    graph::Graph,
    role::Label,
    small_pictures::{Multiples, Story},
    values::{Bits, Gauges, ListRow, Lists, MatrixProduct, Products, Table},
    view::{Body, ClipperRow, NumberLine, View},
};

/// How the numbers of these frames are written, which stand beside each other, in a run that writes its own so.
pub fn notation<'a>(of_run: Notation, frames: impl IntoIterator<Item = &'a Frame>) -> Notation {
    let frames = frames.into_iter();
    of_run.max(Notation::of(
        frames.flat_map(|frame| said(&frame.views, &frame.caption)),
    ))
}

pub fn said<'a>(views: &'a [View], caption: &'a Caption) -> Vec<Said<'a>> {
    let views = views.iter().flat_map(|view| view.body.said());
    let arithmetic = caption.arithmetic.iter().map(Said::Formula);
    let decision = Said::Message(&caption.decision);
    views.chain([decision]).chain(arithmetic).collect()
}

impl Body {
    pub fn said(&self) -> Vec<Said<'_>> {
        match self {
            Self::Plane(marks) => labels(marks.iter().map(|mark| &mark.label)).collect(),
            Self::Space(space) => {
                let labels = labels(space.marks.iter().map(|mark| &mark.label));
                labels.chain(space.title.iter().map(Said::Value)).collect()
            }
            Self::Raster(raster) => {
                let stored = raster
                    .pixels
                    .iter()
                    .filter_map(|pixel| pixel.value.as_ref());
                stored.chain([&raster.title]).map(Said::Value).collect()
            }
            Self::Bits(bits) => bits.said(),
            Self::Table(table) => table.said(),
            Self::Matrix(product) => in_decimals(product.said()),
            Self::Spaces(row) => {
                let cells = row.cells.iter();
                let cells = cells.flat_map(|cell| [&cell.name].into_iter().chain(&cell.place));
                in_decimals(cells.chain(&row.arrows).map(Said::Value).collect())
            }
            Self::Costs(costs) => costs.names.iter().map(Said::Value).collect(),
            Self::Story(story) => in_decimals(story.said()),
            Self::Graph(graph) => in_decimals(graph.said()),
            Self::Lists(lists) => lists.said(),
            Self::Products(products) => products.said(),
            Self::NumberLine(line) => line.said(),
            Self::Gauges(gauges) => gauges.said(),
            Self::Ribbon(ribbon) => {
                let stages = ribbon.stages.iter();
                let said = stages.flat_map(|stage| [&stage.title, &stage.counts]);
                said.map(Said::Message).collect()
            }
            Self::Multiples(multiples) => multiples.said(),
            Self::Clippers(row) => row.said(),
        }
    }
}

fn in_decimals(mut said: Vec<Said<'_>>) -> Vec<Said<'_>> {
    said.push(Said::Decimals);
    said
}

fn labels<'a>(labels: impl Iterator<Item = &'a Option<Label>>) -> impl Iterator<Item = Said<'a>> {
    labels.flatten().map(|label| Said::Value(&label.text))
}

impl Bits {
    fn said(&self) -> Vec<Said<'_>> {
        let rows = self.rows.iter().chain(&self.result);
        let names = self.columns.iter().chain(rows.map(|row| &row.name));
        let note = self.note.iter().map(Said::Message);
        names.map(Said::Value).chain(note).collect()
    }
}

impl Table {
    fn said(&self) -> Vec<Said<'_>> {
        let header = self.header.iter().map(Said::Formula);
        let values = self.rows.iter().flat_map(|row| {
            let cells = row.cells.iter().filter_map(|cell| cell.value.as_ref());
            std::iter::once(&row.name).chain(cells)
        });
        let notes = self.notes.iter().map(|note| Said::Message(&note.text));
        header.chain(values.map(Said::Value)).chain(notes).collect()
    }
}

impl MatrixProduct {
    fn said(&self) -> Vec<Said<'_>> {
        let names = self.notes.iter().chain(&self.into);
        let names = names.chain([&self.name, &self.from]);
        let sums = self.rows.iter().filter_map(|row| row.sum.as_ref());
        let sums = sums.chain(&self.operator).map(Said::Formula);
        let numbers = self.rows.iter().flat_map(|row| {
            let entries = row.entries.iter().chain(&row.operand);
            entries.chain(&row.result).copied()
        });
        let numbers = numbers.map(Said::Number);
        names.map(Said::Value).chain(sums).chain(numbers).collect()
    }
}

impl Story {
    fn said(&self) -> Vec<Said<'_>> {
        let cards = self.cards.iter();
        let cards = cards.flat_map(|card| [&card.name, &card.new.1, &card.against, &card.word]);
        let around = [&self.title, &self.opening.1, &self.held, &self.down];
        cards.chain(around).map(Said::Value).collect()
    }
}

impl Graph {
    fn said(&self) -> Vec<Said<'_>> {
        let nodes = self.nodes.iter().flat_map(|node| {
            let beside = node.number.iter().chain(&node.note);
            std::iter::once(&node.name).chain(beside)
        });
        let reasons = self.arrows.iter();
        let reasons = reasons.filter_map(|arrow| arrow.reason.as_ref());
        let names = nodes.chain(reasons).chain(&self.ring);
        names.chain([&self.title]).map(Said::Value).collect()
    }
}

impl Lists {
    fn said(&self) -> Vec<Said<'_>> {
        let lists = self.lists.iter().flat_map(|list| {
            let titles = std::iter::once(&list.title).chain(&list.columns);
            titles.chain(list.entries.iter().flat_map(ListRow::said))
        });
        let legend = self.legend.iter().map(|(_, meaning)| meaning);
        lists.chain(legend).map(Said::Value).collect()
    }
}

impl ListRow {
    fn said(&self) -> impl Iterator<Item = &Value> {
        std::iter::once(&self.name).chain(self.details.iter().flatten())
    }
}

impl Products {
    fn said(&self) -> Vec<Said<'_>> {
        let products = self.products.iter().flat_map(|product| {
            [
                Said::Value(&product.onto.name),
                Said::Value(&product.of.name),
                Said::Message(&product.decision),
                Said::Formula(&product.arithmetic),
            ]
        });
        let measured = self.measured.iter().flat_map(|measured| {
            let ends = measured.ends.iter().map(|(name, _)| name);
            let spans = measured.spans.iter().map(|(_, text, _)| text);
            let names = std::iter::once(&measured.zero).chain(ends).chain(spans);
            let title = Said::Message(&measured.title);
            std::iter::once(title).chain(names.map(Said::Value))
        });
        products.chain(measured).collect()
    }
}

impl NumberLine {
    fn said(&self) -> Vec<Said<'_>> {
        let ticks = self.ticks.iter();
        let ticks = ticks.flat_map(|tick| [Said::Value(&tick.name), Said::Formula(&tick.value)]);
        ticks.chain(self.values.iter().map(Said::Formula)).collect()
    }
}

impl Gauges {
    fn said(&self) -> Vec<Said<'_>> {
        let rows = self.rows.iter().flat_map(|row| {
            let verdict = row.verdict.iter().map(Said::Message);
            let value = row.value.into_iter().map(Said::Number);
            std::iter::once(Said::Value(&row.name))
                .chain(value)
                .chain(verdict)
        });
        let sides = self.sides.iter().chain([&self.title]);
        rows.chain(sides.map(Said::Message)).collect()
    }
}

impl Multiples {
    fn said(&self) -> Vec<Said<'_>> {
        let said = self.drawings.iter().flat_map(|drawing| {
            let words = drawing.note.iter().map(|(_, note)| note);
            let words = words.chain([&drawing.title]).map(Said::Value);
            labels(drawing.marks.iter().map(|mark| &mark.label)).chain(words)
        });
        said.collect()
    }
}

impl ClipperRow {
    fn said(&self) -> Vec<Said<'_>> {
        let clippers = self.clippers.iter().map(|clipper| &clipper.name);
        let travellers = self.travellers.iter().map(|traveller| &traveller.name);
        let names = clippers.chain(travellers).chain([&self.output]);
        names.map(Said::Value).collect()
    }
}
