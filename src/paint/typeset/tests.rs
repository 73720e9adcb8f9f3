use egui::{Color32, FontFamily, FontId, epaint::text::PlacedRow, vec2};

use crate::{
    paint::{Headless, ThemeKind, fonts::semibold},
    text::{Catalog, Formula, Lang, Message, Value},
};

use super::*;

const FONT: FontId = FontId::proportional(20.0);
const INK: Color32 = Color32::BLACK;

fn set<T>(mut work: impl FnMut(&Painter) -> T) -> T {
    let mut done = None;
    let mut table = Headless::new(ThemeKind::Light);
    table.draw(vec2(64.0, 64.0), 2.0, |ui| done = Some(work(ui.painter())));
    done.expect("the interface is run")
}

fn line(catalog: &Catalog, formula: &Formula) -> Typeset {
    let span = Span::upright(catalog.formula_pieces(formula), FONT, INK);
    set(|painter| Typeset::line(painter, std::slice::from_ref(&span)))
}

fn text(text: &str, font: &FontId) -> Typeset {
    set(|painter| Typeset::text(painter, text, font.clone(), INK))
}

fn wrapped(spans: &[Span], width: f32) -> Typeset {
    set(|painter| Typeset::wrapped(painter, spans, width))
}

fn lines_of(typeset: &Typeset) -> Vec<String> {
    typeset.galley.rows.iter().map(|row| row.text()).collect()
}

fn ink(row: &PlacedRow) -> (Vec<(char, Rect)>, Vec<Rect>) {
    let mesh = &row.visuals.mesh;
    let boxes = |first: usize| {
        let corners = mesh.vertices[first..first + 4].iter().map(|v| v.pos);
        Rect::from_points(&corners.collect::<Vec<_>>())
    };
    let glyphs = row.glyphs.iter().filter(|it| !it.uv_rect.is_nothing());
    let glyphs = glyphs.map(|glyph| (glyph.chr, boxes(glyph.first_vertex as usize)));
    let bars = (row.visuals.glyph_vertex_range.end..mesh.vertices.len()).step_by(4);
    (glyphs.collect(), bars.map(boxes).collect())
}

#[test]
fn a_quotient_is_centred_on_its_line_and_clear_of_it() {
    let wide = Formula::default().sym("q").over(
        Formula::default().num(-1.0).sym(" − ").operand(-2.0),
        Formula::default().num(4.0),
    );
    for formula in [Formula::default().num(0.375), wide] {
        let typeset = line(Catalog::of(Lang::En), &formula);
        let (glyphs, bars) = ink(&typeset.galley.rows[0]);
        let [bar] = bars[..] else {
            panic!("one line: {bars:?}");
        };
        let stands = |above: bool| {
            let halves = glyphs
                .iter()
                .filter(|(c, at)| *c != '/' && *c != 'q' && (at.bottom() <= bar.top()) == above);
            let union = halves.map(|(_, at)| *at).reduce(Rect::union);
            union.expect("both halves have ink")
        };
        let [num, den] = [stands(true), stands(false)];
        let is_clear = num.bottom() < bar.top() && den.top() > bar.bottom();
        assert!(is_clear, "{num} {bar} {den}");
        for half in [num, den] {
            let off = (half.center().x - bar.center().x).abs();
            assert!(off <= 1.0, "{half} over {bar}");
            assert!(bar.left() < half.left() && half.right() < bar.right());
        }
        assert!(num.top() >= 0.0 && den.bottom() <= typeset.size().y);
    }
}

#[test]
fn a_subscript_is_lowered_and_smaller() {
    let typeset = text("u_nun P₁", &FONT);
    let (glyphs, bars) = ink(&typeset.galley.rows[0]);
    assert_eq!(bars, []);
    let us = glyphs.iter().filter(|(c, _)| *c == 'u');
    let us: Vec<Rect> = us.map(|(_, at)| *at).collect();
    assert!(us[1].bottom() > us[0].bottom() + 2.0, "{us:?}");
    assert!(us[1].height() < 0.8 * us[0].height(), "{us:?}");
    let gap = us[1].left() - us[0].right();
    assert!(gap < 12.0, "nothing where the _ was: {us:?}");
    assert_eq!(typeset.galley.text(), "u_nun P₁", "copied as plain text");
}

#[test]
fn letters_stand_on_one_line_with_and_without_a_quotient() {
    let centre = |typeset: &Typeset| typeset.baseline() - 0.5 * typeset.size().y;
    let plain = text("17", &FONT);
    let stacked = line(Catalog::of(Lang::En), &Formula::default().num(0.375));
    assert!((centre(&plain) - centre(&stacked)).abs() <= 0.5);
    assert!(stacked.size().y < 2.4 * FONT.size, "{:?}", stacked.size());
}

#[test]
fn a_minus_is_as_wide_as_a_plus() {
    for family in [FontFamily::Proportional, semibold(), FontFamily::Monospace] {
        let font = FontId::new(40.0, family);
        let typeset = text("−+-", &font);
        let (glyphs, _) = ink(&typeset.galley.rows[0]);
        let [minus, plus, hyphen] = [0, 1, 2].map(|i| glyphs[i].1.width());
        let is_wide = (minus - plus).abs() <= 1.5 && hyphen < 0.8 * minus;
        assert!(is_wide, "{font:?}");
    }
}

#[test]
fn every_glyph_and_line_is_on_whole_pixels() {
    let formula = Formula::default().sym("u_min = ").num(-0.375);
    let typeset = line(Catalog::of(Lang::En), &formula.sym(" in d_S"));
    let (glyphs, bars) = ink(&typeset.galley.rows[0]);
    let seen = glyphs.iter().filter(|(c, _)| !"_/".contains(*c));
    for at in seen.map(|(_, at)| *at).chain(bars) {
        let in_pixels = at.min * 2.0;
        assert!((in_pixels - in_pixels.round()).length() < 1e-3, "{at}");
    }
}

#[test]
fn no_line_breaks_within_a_coordinate_a_formula_or_a_term() {
    let difference = Formula::default().sym("x = ").num(-1.0).sym(" − ");
    let difference = difference.operand(-2.0).equals(1.0);
    let message = Message::new("access-handle")
        .with("name", Value::Term("object-segment"))
        .with("point", [-1.0, 0.375]);
    let terms = [
        "(−1, 3/8)",
        "(−1; 3/8)",
        "segment",
        "线段",
        "segmento",
        "x = −1 − (−2) = 1",
    ];
    for lang in Lang::ALL {
        let catalog = Catalog::of(lang);
        let mut spans = vec![Span::upright(catalog.message_pieces(&message), FONT, INK); 3];
        let formula = Piece::Kept(catalog.formula_pieces(&difference));
        let pieces = vec![Piece::Text("。".to_owned()), formula];
        spans.push(Span::upright(pieces, FONT, INK));
        let plain = spans.iter().map(|span| Piece::plain(&span.pieces));
        let plain: String = plain.collect();
        let kept = terms.into_iter().filter(|term| plain.contains(term));
        let kept: Vec<&str> = kept.collect();
        assert!(kept.len() >= 3, "{plain}");
        for width in (170..600).step_by(10) {
            let typeset = wrapped(&spans, width as f32);
            assert_eq!(typeset.galley.text(), plain, "nothing is lost");
            let lines = lines_of(&typeset);
            for term in &kept {
                let whole: usize = lines.iter().map(|line| line.matches(term).count()).sum();
                let n = plain.matches(term).count();
                assert_eq!(whole, n, "{lang}, {width}: {term} in {lines:?}");
            }
            let begin_well = lines.iter().all(|line| !line.starts_with('。'));
            assert!(begin_well, "{lines:?}");
            assert!(typeset.size().x <= width as f32 + 12.0, "{lines:?}");
        }
    }
}

#[test]
fn a_formula_too_long_for_any_line_goes_on_before_a_relation_or_a_term() {
    let kept = |formula: Formula| {
        let pieces = Catalog::of(Lang::En).formula_pieces(&formula);
        Span::upright(vec![Piece::Kept(pieces)], FONT, INK)
    };
    let sum = Formula::default().sym("a = 1 + 2 + 3 + 4 = 2 + 3 + 5");
    let products = Formula::default().sym("d = 2 · 3 + 4 · ").operand(-5.0);
    for (span, width, lines) in [
        (
            kept(sum.equals(10.0)),
            190.0,
            vec!["a = 1 + 2 + 3 + 4 ", "= 2 + 3 + 5 = 10"],
        ),
        // No product is torn.
        (
            kept(products.sym(" + 6 · 7").equals(28.0)),
            150.0,
            vec!["d = 2 · 3 ", "+ 4 · (−5) ", "+ 6 · 7 = 28"],
        ),
        (
            Span::text("if n·D > 0: t ← max(t, n·w / n·D)", FONT, INK),
            270.0,
            vec!["if n·D > 0: t ← max(t, ", "n·w / n·D)"],
        ),
    ] {
        assert_eq!(lines_of(&wrapped(&[span], width)), lines);
    }
}

#[test]
fn running_text_has_its_subscripts_lowered_and_is_read_as_it_is_written() {
    let words = "The left row pushes u_min to 1/2.\nThe top row pulls u_max down to 3/7.";
    let small = FontId::monospace(18.0);
    let spans = [
        Span::text(words, FONT, INK),
        Span::text(" 0100", small, INK).slanted(true),
    ];
    let typeset = set(|painter| Typeset::running(painter, &spans, 240.0, 30.0));
    let galley = typeset.galley();
    assert_eq!(galley.text(), format!("{words} 0100"));
    assert!(galley.rows.len() > 2, "it is wrapped");
    // A panel as wide as its text stays as wide.
    assert!(galley.size().x <= 240.0);
    let tops: Vec<f32> = galley.rows.iter().map(|row| row.pos.y).collect();
    let are_apart = tops.windows(2).all(|pair| pair[1] - pair[0] >= 30.0 - 0.1);
    assert!(are_apart, "{tops:?}");
    let ends = lines_of(&typeset);
    let first = ends.iter().position(|row| row.ends_with("1/2."));
    assert!(galley.rows[first.expect("a line ends")].ends_with_newline);
    let row = &galley.rows[0];
    let bottom = |c: char| {
        let (glyphs, _) = ink(row);
        let of = glyphs.into_iter().filter(|(glyph, _)| *glyph == c);
        of.fold(f32::NEG_INFINITY, |low, (_, at)| low.max(at.bottom()))
    };
    let hangs = bottom('m') > bottom('T') + 1.0;
    assert!(hangs, "min hangs below the line: {:?}", row.text());
}
