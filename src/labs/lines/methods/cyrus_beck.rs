//! Cyrus–Beck, shown.

use crate::{
    algo::{
        line::{CyrusBeckInput, CyrusBeckRow, faulty::NormalsOutside},
        ring::Right,
        segment::{LineClip, LineRules},
    },
    geom::ConvexPolygon,
    labs::{
        crossing_formulas::{dot_product, fixed, oblique, taken},
        segments::{
            LineKeys, LineLook, LineVariant, SeenRow,
            inequalities::{EACH, N_LINES},
        },
        words::{polygon_edge_link, polygon_edge_name},
    },
};

use super::{
    convex_edges::{Shown, edge_in_hand, edge_marks, edge_table, products},
    prelude::*,
    shared::{SegmentInterval, bounded, point},
};

const LINES: [CodeLine; N_LINES] = [
    code_line(0, "code-cb-start", "words-cb-start"),
    code_line(0, "code-cb-each", "words-cb-each"),
    code_line(1, "code-cb-parallel", "words-cb-parallel"),
    code_line(1, "code-cb-enter", "words-cb-enter"),
    code_line(1, "code-cb-leave", "words-cb-leave"),
    code_line(1, "code-cb-empty", "words-cb-empty"),
    code_line(0, "code-cb-accept", "words-cb-accept"),
];

impl<L: LineRules + LineVariant<2, ConvexPolygon>> LineTelling for LineClip<2, ConvexPolygon, L> {
    const TAKES_POLYGON: bool = true;

    fn input(scene: &Scene, segment: Segment) -> CyrusBeckInput {
        CyrusBeckInput {
            clip: scene.clip_polygon(),
            segment,
        }
    }

    fn cuts(event: &Self::Event, _: &Segment) -> Option<(End, f64)> {
        bounded(event)
    }
}

impl LineVariant<2, ConvexPolygon> for Right {
    const ID: &'static str = "cyrus-beck";
    const NAME_KEY: &'static str = "alg-cyrus-beck";
    const CODE: &'static [CodeLine] = &LINES;
}

mistakes! { LineVariant<2, ConvexPolygon>:
    NormalsOutside {
        "faulty-normals", "alg-faulty-normals", "faulty-normals-differs";
        CODE = LINES but EACH: "code-cb-each" "words-faulty-normals";
    }
}

impl LineLook<2> for ConvexPolygon {
    type Scenery = ();

    const SOURCE: &'static str = "Cyrus & Beck, 1978";
    const KEYS: LineKeys = LineKeys {
        opening: "line-opening",
        delta: "lb-delta",
        row: ["cb-edge-entering", "cb-edge-leaving", "cb-edge-parallel"],
        parallel: ["cb-parallel-inside", "cb-parallel-outside"],
        enter: ["cb-enter", "cb-enter-idle"],
        leave: ["cb-leave", "cb-leave-idle"],
        put: "cb-put",
        one_point: ["line-touch", "line-point"],
        reject: "cb-reject",
    };
    const WATCHED: &'static [&'static str] = &["P₁′", "P₂′"];
    const SYMBOLS: [&'static str; 2] = ["t", "t"];
    const HEADER: [&'static str; 2] = ["n·(P₁ − E)", "n·D"];
    const QUOTIENT: [&'static [&'static str]; 2] = [&["−n·(P₁ − E)"], &["n·D"]];
    const SIGN: f64 = -1.0;
    const PARALLEL: &'static str = "n·D = 0,  n·(P₁ − E) = ";
    const ROWS_VIEW: &'static str = "edges";
    const PLANES: &'static str = "table-polygon-edge";
    const NOTES: [&'static str; 2] = ["lb-note-enter", "lb-note-leave"];
    const WATCHES: [bool; 2] = [true, false];

    fn plane(edge_idx: usize, _: Option<&()>) -> Named {
        Named::from(polygon_edge_name(edge_idx)).linked(polygon_edge_link(edge_idx))
    }

    fn numbers(&self, _: &[[f64; 2]; 2], row: &SeenRow<2, Self>) -> [f64; 2] {
        [row.numbers.d1, row.numbers.slope]
    }

    fn row_formulas(&self, ends: &[[f64; 2]; 2], row: &SeenRow<2, Self>) -> Vec<Formula> {
        let CyrusBeckRow {
            normal,
            origin,
            d1,
            d2,
            slope,
        } = row.numbers;
        let along = sym("n·D = n·(P₂ − E) − n·(P₁ − E) = ")
            .num(d2)
            .sym(" − ")
            .operand(d1)
            .equals(slope);
        let distance = dot_product(sym("n·(P₁ − E) = "), normal, point(ends[0]), origin);
        vec![distance.equals(d1), along]
    }

    /// A touched vertex is taken as it is; along an axis one coordinate is computed, else both.
    fn put_formulas(shown: &Shown<'_>, _: End, edge_idx: usize, at: [f64; 2]) -> Vec<Formula> {
        let Some(row) = shown.row_of(edge_idx) else {
            return Vec::new();
        };
        let CyrusBeckRow {
            normal,
            origin,
            d1,
            d2,
            ..
        } = row.numbers;
        let CyrusBeckInput { clip, segment } = shown.input;
        let at = point(at);
        let is_touch = shown.bounds[0] == shown.bounds[1] && clip.vertices().contains(&at);
        match fixed(normal, origin) {
            Some((axis, _)) if is_touch => taken(axis, at),
            Some((axis, c)) => upright(segment, axis, c, at),
            None if is_touch => vec![Formula::default().point(at.to_array())],
            None => vec![oblique("P", [segment.p1, segment.p2], [d1, d2], at)],
        }
    }

    fn border(&self, edge_idx: usize, _: Option<&()>) -> Value {
        polygon_edge_name(edge_idx)
    }

    fn rows(shown: &Shown<'_>) -> Option<Body> {
        Some(match products(shown) {
            Some(products) => Body::Products(products),
            None => Body::Table(edge_table(shown)),
        })
    }

    fn drawing(shown: &Shown<'_>, _: Option<&()>) -> Vec<View> {
        let mut marks = edge_marks(shown);
        let interval = SegmentInterval {
            shown: shown.interval(None),
            crossing_symbol: Self::SYMBOLS[1],
            verdict: shown.verdict,
            goes_on: false,
            vector: edge_in_hand(shown).map(|_| "D"),
        };
        marks.extend(interval.marks(&shown.input.segment));
        vec![View::plane(marks)]
    }
}
