//! How much room views want, from their data alone: so that it is settled for a whole run before anything is drawn.

mod tables;

use std::ops::ControlFlow;

use super::{
    frame::{Caption, Shown},
    graph::{Graph, Places, layers, size_of},
    lens::Lens,
    run::Run,
    small_pictures::{Multiples, Raster, Story, Tiles},
    values::{Bits, Costs, Lists, Products},
    view::{Body, View, ViewId},
    watch::{Watch, unseen},
};

use tables::{Letters, TableRoom};

/// Steps of a run that are asked what they show: a view that comes or grows is there at one of them.
const MOST_ASKED: usize = 24;
const MOST_SAID: usize = 200;
/// A run of more steps is asked at its ends alone: its frames are large, and a drag has no time for them.
const LONG: usize = 1024;
/// Entries of a list beyond these are folded wherever it stands.
const MOST_ENTRIES: usize = 16;

/// What is wider, or higher, than so many times its other side has room beside it after all.
const FLATTEST: f64 = 3.0;
const DRAWING: [[f32; 2]; 2] = [[22.0, 7.5], [30.0, 24.0]];

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stand {
    /// On its left: takes whatever the others leave. A second drawing stands beside it.
    Drawing,
    /// A strip under the drawing, at its width: it measures what is drawn above it.
    Under,
    /// The same where the drawing is narrow, too: what is narrow itself.
    Foot,
    Across,
    Over,
    Beside,
    /// A small picture in a corner of the drawing, whose natural width over height it keeps.
    Inset,
}

/// A view's wants: widths and heights, in ems of the text.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Need {
    pub id: ViewId,
    pub stand: Stand,
    /// Less than this is not worth drawing.
    pub least: [f32; 2],
    /// Its size with text of one size; more does it no good.
    pub natural: [f32; 2],
    /// Width over height of what is drawn, which grows with its room: none of what has text alone.
    pub aspect: Option<f32>,
    /// In a window text has a least size: as much of it as has room is read then.
    pub whole: [f32; 2],
    /// Is it to be as large as the drawing that it stands beside?
    pub is_equal: bool,
    /// A strip that may stand beside the drawing, too, where that makes the drawing larger: least and natural size there.
    pub aside: Option<[[f32; 2]; 2]>,
}

impl View {
    pub fn need(&self) -> Need {
        self.need_said(&mut Letters::default())
    }

    fn need_said(&self, letters: &mut Letters) -> Need {
        let mut whole = [0.0; 2];
        let (stand, least, natural) = match &self.body {
            Body::Plane(_) => (Stand::Drawing, DRAWING[0], DRAWING[1]),
            Body::Space(space) => match Lens::from(space.seer).aspect() {
                None => (Stand::Drawing, DRAWING[0], DRAWING[1]),
                Some(aspect) => {
                    let size = [10.0 * aspect as f32, 10.0];
                    (Stand::Inset, size.map(|side| 0.6 * side), size)
                }
            },
            Body::Gauges(gauges) => {
                let height = 2.5 + 1.5 * gauges.rows.len() as f32;
                (Stand::Beside, [13.0, height], [20.0, 1.2 * height])
            }
            Body::Ribbon(_) => (Stand::Across, [25.0, 5.5], [f32::MAX, 7.0]),
            Body::Multiples(multiples) => multiples_need(multiples, letters),
            Body::Spaces(_) => (Stand::Over, [30.0, 7.4], [f32::MAX, 8.0]),
            Body::Matrix(product) => {
                let rows = product.rows.len() as f32;
                let least = [17.0, 4.5 + 1.8 * rows];
                (Stand::Beside, least, [34.0, 6.0 + 3.4 * rows])
            }
            Body::Raster(raster) => raster_need(raster),
            Body::NumberLine(_) => (Stand::Under, [14.0, 6.0], [f32::MAX, 8.0]),
            Body::Clippers(_) => (Stand::Across, [25.5, 5.6], [f32::MAX, 6.8]),
            Body::Bits(bits) => bits_need(bits),
            Body::Table(table) => {
                let room = TableRoom::of(table, letters);
                whole = room.whole;
                (Stand::Beside, room.least, room.natural)
            }
            Body::Costs(costs) => costs_need(costs),
            Body::Graph(graph) => graph_need(graph),
            Body::Story(story) => {
                whole = [0.0, 17.0];
                story_need(story)
            }
            Body::Lists(lists) => lists_need(lists),
            Body::Products(products) => {
                let (room, high) = products_room(products);
                whole = [0.0, high];
                room
            }
        };
        Need {
            id: self.id,
            stand,
            least,
            natural,
            aspect: self.aspect(),
            whole,
            is_equal: false,
            aside: match &self.body {
                Body::Multiples(multiples) => multiples.aside(),
                _ => None,
            },
        }
    }

    fn aspect(&self) -> Option<f32> {
        match &self.body {
            Body::Plane(_) => Some(1.0),
            Body::Space(space) => Some(Lens::from(space.seer).least_aspect() as f32),
            Body::Raster(raster) => {
                let [columns, rows] = raster.size.map(|n| n.max(1) as f32);
                Some(columns / rows)
            }
            Body::Multiples(multiples) if multiples.tiles == Tiles::Large => {
                let (one, n) = (multiples.aspect(), multiples.drawings.len() as f64);
                Some(if one < 1.0 { one * n } else { one / n } as f32)
            }
            _ => None,
        }
    }
}

impl Multiples {
    /// Least and natural size beside a drawing, in ems.
    fn in_rows(&self, rows: f32) -> [[f32; 2]; 2] {
        const WIDE: f32 = 28.0;
        let n = self.drawings.len().max(1) as f32;
        let aspect = self.aspect().clamp(FLATTEST.recip(), FLATTEST) as f32;
        let drawn = WIDE * rows / n;
        let height = rows * (2.8 + drawn / aspect);
        [[15.0, 4.0 + 2.5 * rows], [WIDE, height]]
    }

    fn aside(&self) -> Option<[[f32; 2]; 2]> {
        let is_strip = self.tiles == Tiles::Strip && self.drawings.len() > 1;
        is_strip.then(|| self.in_rows(2.0))
    }
}

fn multiples_need(multiples: &Multiples, letters: &mut Letters) -> (Stand, [f32; 2], [f32; 2]) {
    let n = multiples.drawings.len() as f32;
    match multiples.tiles {
        Tiles::Strip if multiples.drawings.len() == 1 => {
            // Rows of bars. In a narrow place a long title has two lines.
            let rows = (multiples.bounds[1][1] - multiples.bounds[0][1]) as f32;
            let is_long = letters.wraps(0, &multiples.drawings[0].title);
            let [title, row] = if is_long { [4.0, 1.5] } else { [2.6, 1.2] };
            let least = [20.0, title + row * rows];
            (Stand::Beside, least, [29.0, 3.0 + 1.9 * rows])
        }
        Tiles::Strip => (Stand::Across, [5.0 * n, 6.5], [f32::MAX, 10.0]),
        Tiles::Beside => {
            // What is flat stands in two rows.
            let rows = if multiples.aspect() < 2.0 { 1.0 } else { 2.0 };
            let [least, natural] = multiples.in_rows(rows);
            (Stand::Beside, least, natural)
        }
        Tiles::Large => (Stand::Drawing, DRAWING[0], DRAWING[1]),
    }
}

fn raster_need(raster: &Raster) -> (Stand, [f32; 2], [f32; 2]) {
    let [columns, rows] = raster.size.map(|n| n as f32);
    // Where there are more pixels they may be smaller: the picture is seen, if not each number.
    let [least_columns, least_rows] = [columns.clamp(9.0, 21.0), rows.min(16.0)].map(|n| 0.9 * n);
    let around = if raster.scale.is_some() { 4.4 } else { 2.2 };
    let natural = [(3.0 * columns).max(8.0), 3.0 * rows + around];
    let least = [least_columns, least_rows + around];
    (Stand::Drawing, least, natural)
}

fn bits_need(bits: &Bits) -> (Stand, [f32; 2], [f32; 2]) {
    let columns = bits.columns.len() as f32;
    // The result has its room before it is asked for.
    let rows = bits.rows.len() as f32 + 1.0;
    let least = [4.2 + 2.5 * columns, 5.8 + 2.9 * rows];
    let natural = [3.6 + 4.7 * columns, 7.4 + 4.6 * rows];
    (Stand::Beside, least, natural)
}

/// With the height of text of 12 points.
fn products_room(products: &Products) -> ((Stand, [f32; 2], [f32; 2]), f32) {
    let rows = products.products.len() as f32;
    let spans = products.measured.as_ref().map(|it| it.spans.len() as f32);
    let [low, high] = spans.map_or([0.0; 2], |_| [5.6, 11.5]);
    let whole = 5.6 * rows + spans.map_or(0.0, |spans| 7.3 + 1.5 * spans);
    let least = [17.0, 3.7 * rows + low];
    ((Stand::Beside, least, [28.0, 9.5 * rows + high]), whole)
}

fn story_need(story: &Story) -> (Stand, [f32; 2], [f32; 2]) {
    // Two cards, or many folded about one.
    let width = 7.5 * story.cards.len().clamp(1, 2) as f32;
    (Stand::Under, [width + 4.0, 12.0], [f32::MAX, 19.0])
}

fn costs_need(costs: &Costs) -> (Stand, [f32; 2], [f32; 2]) {
    let n = costs.counts.len() as f32;
    // Of two a row has both; of more each has its own.
    let rows = if n > 2.0 { 1.23 * n + 2.1 } else { 4.5 };
    let height = if n > 3.0 {
        2.0 * (1.4 * n + 2.1)
    } else {
        5.0 * rows
    };
    let natural = [27.0, 2.5 + height];
    (Stand::Beside, natural.map(|side| 0.6 * side), natural)
}

fn graph_need(graph: &Graph) -> (Stand, [f32; 2], [f32; 2]) {
    match &graph.places {
        Places::Free(_) => (Stand::Foot, [12.0, 8.5], [f32::MAX, 13.0]),
        Places::Layers(below) => {
            let spots = layers(below, None, [usize::MAX; 2]);
            let [wide, high] = size_of(&spots);
            // What has no room is folded.
            let least = [3.0 * wide.clamp(5.0, 6.0), 2.0 + 3.2 * high.clamp(3.0, 4.0)];
            let natural = [5.7 * wide.clamp(3.0, 8.0), 2.0 + 4.2 * high.clamp(3.0, 8.0)];
            (Stand::Beside, least, natural)
        }
    }
}

fn lists_need(lists: &Lists) -> (Stand, [f32; 2], [f32; 2]) {
    let n = lists.lists.len() as f32;
    let entries = lists.lists.iter().map(|list| list.entries.len());
    let rows = entries.max().unwrap_or(0).min(MOST_ENTRIES) as f32;
    let columns: usize = lists.lists.iter().map(|list| list.columns.len()).sum();
    // Of a long list four entries say little.
    let seen = if rows > 6.0 { 6.0 } else { rows.min(4.0) };
    let legend = if lists.legend.is_empty() { 0.0 } else { 1.0 };
    let least_width = 5.0 * n + 2.5 * (n - 1.0) + 2.0;
    let least = [least_width, 2.9 + 1.65 * seen + 1.4 * legend];
    let width = 6.5 * n + 4.5 * columns as f32 + 4.0 * (n - 1.0);
    let height = 3.5 + 2.3 * rows + 2.0 * legend;
    (Stand::Beside, least, [width, height])
}

/// What the views of a run want, in the order in which a step shows them: enough for every step; `look` sees them, too. A
/// drawing of the plane has the shape of these bounds, its least corner and its largest.
pub fn needs(
    run: &dyn Run,
    [min, max]: [[f64; 2]; 2],
    mut look: impl FnMut(&[View], &Caption),
) -> Vec<Need> {
    let mut needs: Vec<Need> = Vec::new();
    let mut letters: Vec<Letters> = Vec::new();
    ask(run, MOST_ASKED, |shown| {
        let views = shown.views();
        look(&views, &shown.caption());
        letters.resize_with(views.len().max(letters.len()), Letters::default);
        let views = views.iter().zip(&mut letters);
        for (view, letters) in views.filter(|(view, _)| view.id != ViewId::ASKED) {
            let more = view.need_said(letters);
            match needs.iter_mut().find(|need| need.id == more.id) {
                Some(need) => need.widen(&more),
                None => needs.push(more),
            }
        }
    });
    let [width, height] = [0, 1].map(|i| (max[i] - min[i]).max(f64::MIN_POSITIVE));
    let shape = (width / height).clamp(FLATTEST.recip(), FLATTEST) as f32;
    for need in needs.iter_mut().filter(|need| need.id == ViewId::PLANE) {
        need.aspect = Some(shape);
    }
    match_twins(&mut needs);
    needs
}

/// Two pictures with the same pixels are compared: they are to be equally large.
fn match_twins(needs: &mut [Need]) {
    let size = |need: &Need| (need.stand == Stand::Drawing).then_some((need.natural, need.aspect));
    let sizes: Vec<_> = needs.iter().filter_map(size).collect();
    for need in needs {
        let alike = sizes.iter().filter(|other| Some(**other) == size(need));
        need.is_equal = alike.count() > 1;
    }
}

pub fn sentences(run: &dyn Run) -> Vec<Caption> {
    let mut said = Vec::new();
    ask(run, MOST_SAID, |shown| said.push(shown.caption()));
    said
}

pub fn watches(run: &dyn Run) -> Vec<Watch> {
    let mut watched = Vec::new();
    ask(run, MOST_SAID, |shown| watched.push(unseen(&shown.watch())));
    watched
}

fn ask(run: &dyn Run, most: usize, mut look: impl FnMut(&dyn Shown)) {
    let asked = Asked::of(run, most);
    for from_to in asked.stretches() {
        run.visit(from_to, &mut |step, shown| {
            if asked.holds(step) {
                look(shown);
            }
            ControlFlow::Continue(())
        });
    }
}

/// The steps of a run that are asked: some at equal distances, the first at each line of the pseudocode, and the last.
pub(super) struct Asked {
    n_steps: usize,
    stride: usize,
    firsts: Vec<usize>,
}

impl Asked {
    pub(super) fn of(run: &dyn Run, most: usize) -> Self {
        let n_steps = run.n_steps();
        let n_asked = if n_steps > LONG { 1 } else { most };
        let stride = n_steps.div_ceil(n_asked).max(1);
        let mut lines = Vec::new();
        let is_new = |step: &usize| {
            let line = run.code_line(*step);
            let is_new = !lines.contains(&line);
            lines.extend(is_new.then_some(line));
            is_new
        };
        let looked_at = if stride < n_steps { n_steps } else { 0 };
        Self {
            n_steps,
            stride,
            firsts: (0..looked_at).filter(is_new).collect(),
        }
    }

    pub(super) fn holds(&self, step: usize) -> bool {
        step == self.n_steps || step.is_multiple_of(self.stride) || self.firsts.contains(&step)
    }

    pub(super) fn stretches(&self) -> Vec<[usize; 2]> {
        if self.stride < self.n_steps {
            vec![[0, self.n_steps]]
        } else if self.n_steps == 0 {
            vec![[0, 0]]
        } else {
            vec![[0, 0], [self.n_steps, self.n_steps]]
        }
    }
}

impl Need {
    /// The same of a small picture that is a drawing of its own, in place of an inset.
    #[must_use]
    pub fn enlarged(self) -> Self {
        if self.stand != Stand::Inset {
            return self;
        }
        let [least, natural] = DRAWING;
        Self {
            stand: Stand::Drawing,
            least,
            natural,
            ..self
        }
    }

    pub const fn is_drawing(&self) -> bool {
        matches!(self.stand, Stand::Drawing | Stand::Inset)
    }

    pub fn widen(&mut self, more: &Self) {
        let larger = |a: [f32; 2], b: [f32; 2]| [a[0].max(b[0]), a[1].max(b[1])];
        self.least = larger(self.least, more.least);
        self.natural = larger(self.natural, more.natural);
        self.whole = larger(self.whole, more.whole);
        let aside = self.aside.zip(more.aside);
        self.aside = aside.map(|(a, b)| [larger(a[0], b[0]), larger(a[1], b[1])]);
    }
}
