//! What is shown of an option while it is pointed at, and on its card.

use super::{super::*, asked_at, each_colour, is_chip, placed, sides};
use crate::paint::Placed;

/// What is filled over a thirtieth of the window and more, by its colour.
fn large_fills(bench: &mut Bench) -> std::collections::BTreeSet<[u8; 4]> {
    let mut found = std::collections::BTreeSet::new();
    for clipped in &bench.run(Vec::new(), Vec::new()).shapes {
        each_colour(&clipped.shape, &mut |colour, rect| {
            if rect.intersect(clipped.clip_rect).area() > SIZE.x * SIZE.y / 30.0 {
                found.insert(colour.to_array());
            }
        });
    }
    found
}

#[test]
fn an_edge_that_is_pointed_at_tints_what_lies_beyond_it() {
    let mut bench = sides();
    bench.point(pos2(640.0, 3.0));
    bench.frame(0.1, Vec::new());
    let (before, right) = (
        large_fills(&mut bench),
        bench.app.practice.open().expect("it asks").choice.right,
    );
    let chips: Vec<Placed> = placed(&bench).into_iter().filter(is_chip).collect();
    let (mut tints, mut n_drawn) = (Vec::new(), 0);
    for chip in &chips {
        bench.point(chip.rect.center());
        bench.frame(0.1, Vec::new());
        let glimpse = bench.app.practice.glimpse(bench.app.stage.lit).cloned();
        tints.extend(glimpse);
        let now = large_fills(&mut bench);
        n_drawn += usize::from(now.difference(&before).next().is_some());
    }
    assert_eq!(
        tints.len(),
        4,
        "the right one no more than the others: {right}"
    );
    assert!(n_drawn > 1, "it is drawn: {n_drawn}");
    bench.point(pos2(640.0, 3.0));
    bench.frame(0.1, Vec::new());
    bench.frame(0.1, Vec::new());
    assert_eq!(large_fills(&mut bench), before);
}

#[test]
fn how_a_pixel_would_be_is_on_a_card_for_each_answer() {
    use crate::figure::Glimpse;
    let page = Page::Step("34-the-nearer-wins".into(), "nearer".into());
    let mut bench = asked_at(page, Lang::En, SIZE);
    let choice = bench.app.practice.open().expect("it asks").choice.clone();
    let pictures: Vec<_> = choice
        .glimpses
        .iter()
        .filter_map(|it| match it {
            Glimpse::Pixels(raster) => Some(raster.clone()),
            Glimpse::Nothing | Glimpse::Mark(_) => None,
        })
        .collect();
    assert_eq!(pictures.len(), choice.options.len());
    let own = pictures[0].current.expect("a pixel is asked about");
    let place = own[1] * pictures[0].size[0] + own[0];
    for (i, one) in pictures.iter().enumerate() {
        for (other, two) in pictures.iter().enumerate() {
            let is_alike = |at: usize| one.pixels[at] == two.pixels[at];
            assert!((0..one.pixels.len()).all(|at| at == place || is_alike(at)));
            // What is written differs from what is not.
            let is_right = [i, other].map(|it| it == choice.right);
            assert!(
                is_right[0] == is_right[1] || !is_alike(place),
                "{i} {other}"
            );
        }
    }
    bench.frame(0.1, Vec::new());
    let card = |bench: &Bench, nth: usize| {
        let name = format!("{} ", nth + 1);
        let mut names = bench.names.iter().rev();
        let found = names.find(|(own, _)| own.starts_with(&name));
        found.expect("it is listed").1
    };
    let rects: Vec<Rect> = (0..choice.options.len())
        .map(|nth| card(&bench, nth))
        .collect();
    assert!(rects.iter().all(|rect| rect.height() > 100.0), "{rects:?}");
    // A click on the picture answers.
    bench.press_at(rects[choice.right].right_center() - vec2(40.0, 0.0));
    assert!(!bench.app.practice.is_asking());
    assert_eq!(bench.app.practice.told, [1, 1]);
}
