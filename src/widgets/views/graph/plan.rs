//! Where the nodes of a graph stand in a room.

use crate::figure::{Graph, GraphNode, NodeStage, Places, Spot, Stands, layers, size_of, spread};

use super::super::prelude::*;

const CHIP: f32 = 23.0;
const PAD: f32 = 8.0;
pub const NAME_PTS: f32 = 12.5;
const TITLE: f32 = 24.0;
const NUMBER: f32 = 14.0;
const MOST_FREE: usize = 12;
/// Their room is no wider than this part of its height: things that are close are seen together.
const WIDEST: f32 = 2.3;
const AROUND: f32 = 9.0;
const APART: f32 = 3.4;
const COLUMN_GAP: f32 = 6.0;
const MOST_COLUMN: f32 = 74.0;
const LAYERS: [f32; 2] = [32.0, 54.0];
/// Below this part of its size text does not shrink: the tree is folded.
const FOLD_BELOW: f32 = 0.85;

pub struct Chip {
    pub place: Rect,
    pub stands: Stands,
}

impl Chip {
    pub fn node<'g>(&self, graph: &'g Graph) -> Option<&'g GraphNode> {
        match self.stands {
            Stands::Node(idx) => graph.nodes.get(idx),
            Stands::Folded(_) => None,
        }
    }

    pub fn words(&self) -> String {
        match self.stands {
            Stands::Node(idx) => idx.to_string(),
            Stands::Folded(count) => format!("+{count}"),
        }
    }
}

pub struct Plan {
    pub chips: Vec<Chip>,
    pub taken: Vec<Rect>,
    /// Lines from a node to what is folded below it, or from that down to a node.
    pub folds: Vec<[Pos2; 2]>,
    pub room: Rect,
    pub n_left_out: usize,
}

impl Plan {
    pub fn new(slate: &Slate<'_>, rect: Rect, graph: &Graph) -> Self {
        let room = rect.with_min_y(rect.top() + slate.pts(TITLE));
        let mut plan = match &graph.places {
            Places::Free(places) => free(slate, room, graph, places),
            Places::Layers(below) => tree(slate, room, graph, below),
        };
        let is_drawn = |chip: &&Chip| {
            let node = chip.node(graph);
            node.is_none_or(|node| node.stage != NodeStage::ToCome)
        };
        let chips = plan.chips.iter().filter(is_drawn);
        plan.taken = chips.map(|chip| chip.place.expand(3.0)).collect();
        plan
    }

    pub fn is_taken(&self, place: Rect) -> bool {
        self.taken.iter().any(|taken| taken.intersects(place))
    }

    pub fn place(&self, node: usize) -> Option<Rect> {
        let mut chips = self.chips.iter();
        let chip = chips.find(|chip| chip.stands == Stands::Node(node))?;
        Some(chip.place)
    }
}

pub fn fitted<'a>(slate: Slate<'a>, graph: &Graph, room: Vec2) -> Slate<'a> {
    let least = FOLD_BELOW * slate.scale;
    slate.shrunk_to(least, room, |slate| match &graph.places {
        Places::Free(_) => {
            let widest = chip_size(slate, graph).x;
            vec2(4.0 * widest, slate.pts(TITLE + 4.0 * CHIP))
        }
        Places::Layers(below) => {
            let spots = layers(below, graph.focus, [usize::MAX; 2]);
            let [n_columns, n_layers] = size_of(&spots);
            let height = slate.pts(TITLE + n_layers * LAYERS[0]);
            vec2(n_columns * column_width(slate, graph), height)
        }
    })
}

fn name_width(slate: &Slate<'_>, node: &GraphNode) -> f32 {
    slate.width(&node.name, Face::Strong, NAME_PTS)
}

fn chip_size(slate: &Slate<'_>, graph: &Graph) -> Vec2 {
    let widths = graph.nodes.iter().map(|node| name_width(slate, node));
    size_for(slate, widths.fold(0.0, f32::max))
}

fn size_for(slate: &Slate<'_>, name: f32) -> Vec2 {
    let height = slate.pts(CHIP);
    vec2((name + 2.0 * slate.pts(PAD)).max(height), height)
}

fn column_width(slate: &Slate<'_>, graph: &Graph) -> f32 {
    chip_size(slate, graph).x + slate.pts(COLUMN_GAP)
}

fn free(slate: &Slate<'_>, room: Rect, graph: &Graph, places: &[[f64; 2]]) -> Plan {
    let half = 0.5 * chip_size(slate, graph);
    let beyond = slate.pts(0.6 * NUMBER);
    let width = room.width().min(WIDEST * room.height());
    let n_fit = width * room.height() / (2.4 * 2.4 * 4.0 * half.x * half.y);
    let shown = graph.near((n_fit as usize).clamp(2, MOST_FREE));
    // Arrows bend outwards, names of cycles and numbers stand beside them.
    let around = slate.pts(AROUND);
    let inner = Rect::from_min_max(
        room.min + half + vec2(around, beyond),
        pos2(room.left() + width, room.bottom()) - half - vec2(beyond, around),
    );
    let [width, height] = [inner.width(), inner.height()].map(|side| f64::from(side.max(1.0)));
    let n = shown.len().max(1) as f64;
    let apart = f64::from(slate.pts(APART * CHIP)).min(0.85 * (width * height / n).sqrt());
    let of_shown = |&idx: &usize| places.get(idx).copied().unwrap_or([0.5; 2]);
    let of_shown: Vec<[f64; 2]> = shown.iter().map(of_shown).collect();
    let places = spread(&of_shown, [width, height], apart);
    let chips = shown.iter().zip(places).map(|(&idx, [x, y])| {
        let size = size_for(slate, name_width(slate, &graph.nodes[idx]));
        let middle = inner.min + vec2(x as f32, y as f32);
        Chip {
            place: Rect::from_center_size(middle, size),
            stands: Stands::Node(idx),
        }
    });
    Plan {
        chips: chips.collect(),
        taken: Vec::new(),
        folds: Vec::new(),
        room,
        n_left_out: graph.nodes.len() - shown.len(),
    }
}

fn tree(slate: &Slate<'_>, room: Rect, graph: &Graph, below: &[[Option<usize>; 2]]) -> Plan {
    let least = column_width(slate, graph);
    let fits = |room: f32, each: f32| (room / each + 0.01) as usize;
    let n_fit = [
        fits(room.width(), least),
        fits(room.height(), slate.pts(LAYERS[0])),
    ];
    let spots = layers(below, graph.focus, n_fit);
    let [n_columns, n_layers] = size_of(&spots);
    let column = (room.width() / n_columns).min(slate.pts(MOST_COLUMN).max(least));
    let [low, high] = LAYERS.map(|height| slate.pts(height));
    let layer = (room.height() / n_layers).clamp(low, high);
    let middle = |column_idx: usize, layer_idx: usize| {
        let x = room.left() + (column_idx as f32 + 0.5) * column;
        pos2(x, room.top() + (layer_idx as f32 + 0.5) * layer)
    };
    let place = |spot: &Spot| {
        let name = match spot.stands {
            Stands::Node(idx) => name_width(slate, &graph.nodes[idx]),
            Stands::Folded(_) => slate.pts(1.5 * NAME_PTS),
        };
        Rect::from_center_size(middle(spot.column, spot.layer), size_for(slate, name))
    };
    let is_node = |stands: Stands| matches!(stands, Stands::Node(_));
    let folds = spots.iter().filter_map(|spot| {
        let above = &spots[spot.above?];
        let is_folded = !is_node(spot.stands) || !is_node(above.stands);
        is_folded.then(|| [place(above).center_bottom(), place(spot).center_top()])
    });
    let chips = spots.iter().map(|spot| Chip {
        place: place(spot),
        stands: spot.stands,
    });
    Plan {
        folds: folds.collect(),
        chips: chips.collect(),
        taken: Vec::new(),
        room,
        n_left_out: 0,
    }
}

pub fn number_size(slate: &Slate<'_>, width: f32) -> Vec2 {
    let height = slate.pts(NUMBER);
    vec2((width + slate.pts(6.0)).max(height), height)
}

/// Where it may be: over a corner of the chip, beside the name; the best first.
pub fn number_places(slate: &Slate<'_>, chip: Rect, width: f32) -> [Rect; 4] {
    let size = number_size(slate, width);
    let off = 0.5 * (chip.size() + size) - vec2(slate.pts(6.0), 0.3 * size.y);
    [[1.0, -1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| {
        let middle = chip.center() + vec2(x * off.x, y * off.y);
        Rect::from_center_size(middle, size)
    })
}

pub fn rim(place: Rect) -> impl Iterator<Item = Pos2> {
    const QUARTERS: usize = 6;
    let radius = 0.5 * place.height();
    let ends = [place.right() - radius, place.left() + radius];
    let turn = std::f32::consts::PI / QUARTERS as f32;
    ends.into_iter().enumerate().flat_map(move |(side, x)| {
        (0..=QUARTERS).map(move |i| {
            let angle = turn * i as f32 + std::f32::consts::PI * side as f32;
            let (sin, cos) = libm::sincosf(angle);
            pos2(x + radius * sin, place.center().y - radius * cos)
        })
    })
}
