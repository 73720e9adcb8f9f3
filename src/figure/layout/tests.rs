//! Nothing overlaps, and what there is no room for is left out.

use super::*;
use crate::figure::Stand;

fn need(id: &'static str, stand: Stand, least: [f32; 2], natural: [f32; 2]) -> Need {
    let id = ViewId(id);
    Need {
        id,
        stand,
        least,
        natural,
        aspect: None,
        whole: [0.0; 2],
        is_equal: false,
        aside: None,
    }
}

fn sheet(size: [f32; 2], em: f32) -> Sheet {
    Sheet {
        area: Slot::new([0.0; 2], size),
        em,
        spacing: &Spacing {
            margin: 48.0,
            gutter: 40.0,
            inset: 0.0,
            titled: 0.0,
            name: 0.0,
            over_caption: 18.0,
            keeps: 0.75,
            is_fixed: false,
            is_tall: false,
        },
        title: 40.0,
        name: 0.0,
        caption: 60.0,
        board: 1.0,
        taken: 0.0,
        cost: 0.0,
    }
}

const WINDOW: &Spacing = &Spacing {
    margin: 0.0,
    gutter: 0.0,
    inset: 24.0,
    titled: 0.0,
    name: 0.0,
    over_caption: 0.0,
    keeps: 0.75,
    is_fixed: true,
    is_tall: false,
};

/// A space seen by an eye, and six rows about it.
fn space_and_table(camera: impl Fn(Need) -> Need) -> Vec<Need> {
    let drawing = |id, aspect| Need {
        aspect: Some(aspect),
        ..need(id, Stand::Drawing, [22.0, 7.5], [30.0, 24.0])
    };
    let table = Need {
        whole: [28.0, 15.5],
        ..need("table", Stand::Beside, [18.5, 11.7], [21.0, 24.2])
    };
    vec![drawing("eye", 0.7), camera(drawing("camera", 1.0)), table]
}

fn side(layout: &Layout, nth: usize, aspect: f32) -> f32 {
    let [width, height] = layout.columns[0].views[nth].1.size();
    width.min(aspect * height) / aspect.sqrt()
}

#[test]
fn more_height_makes_no_drawing_much_smaller_for_its_text() {
    let mut needs = space_and_table(|camera| Need {
        stand: Stand::Inset,
        ..camera
    });
    needs[1].natural = [10.0, 10.0];
    for width in (560..1000).step_by(30) {
        let drawn = |height: usize| {
            let sheet = Sheet {
                spacing: WINDOW,
                ..sheet([width as f32, height as f32], 13.0)
            };
            side(&sheet.lay_out(std::slice::from_ref(&needs)), 0, 0.7)
        };
        for height in (420..760).step_by(20) {
            let [low, high] = [height, height + 20].map(drawn);
            assert!(high > 0.55 * low, "{width}, {height}: {low}, then {high}");
        }
    }
}

#[test]
fn a_strip_stands_in_rows_beside_the_drawing_where_that_makes_it_larger() {
    let drawing = Need {
        aspect: Some(1.5),
        ..need("eye", Stand::Drawing, [22.0, 7.5], [30.0, 24.0])
    };
    let strip = Need {
        aside: Some([[15.0, 9.0], [28.0, 21.0]]),
        ..need("strip", Stand::Across, [30.0, 6.5], [f32::MAX, 10.0])
    };
    let lists = need("lists", Stand::Beside, [12.0, 8.0], [24.0, 12.0]);
    let needs = [vec![drawing, lists, strip]];
    // A page is wide, a window's stage is nearly as high as it is wide.
    for (size, is_beside) in [([960.0, 540.0], true), ([960.0, 860.0], false)] {
        let layout = sheet(size, 12.0).lay_out(&needs);
        let slot = |id: &str| {
            let views = &layout.columns[0].views;
            views
                .iter()
                .find(|(view, _)| view.0 == id)
                .expect("it stands")
                .1
        };
        let [eye, strip] = ["eye", "strip"].map(slot);
        assert_eq!(strip.min[0] > eye.max[0], is_beside, "{size:?} {strip:?}");
    }
}

#[test]
fn pictures_that_are_to_be_equal_have_their_room_before_rows() {
    let needs = space_and_table(|camera| Need {
        is_equal: true,
        ..camera
    });
    let sheet = Sheet {
        spacing: WINDOW,
        title: 0.0,
        ..sheet([768.0, 540.0], 13.0)
    };
    let layout = sheet.lay_out(&[needs]);
    let [eye, camera] = [(0, 0.7), (1, 1.0)].map(|(nth, aspect)| side(&layout, nth, aspect));
    assert_eq!(layout.columns[0].views.len(), 3);
    assert!(eye > 185.0 && camera > 185.0, "{eye} {camera}");
}

fn needs() -> Vec<Need> {
    vec![
        need("plane", Stand::Drawing, [22.0, 8.5], [30.0, 24.0]),
        need("line", Stand::Under, [14.0, 6.0], [60.0, 8.0]),
        need("row", Stand::Across, [43.0, 6.0], [80.0, 6.4]),
        need("table", Stand::Beside, [20.0, 12.0], [30.0, 20.0]),
        need("note", Stand::Beside, [10.0, 4.0], [20.0, 8.0]),
    ]
}

fn is_apart(a: Slot, b: Slot) -> bool {
    (0..2).any(|i| a.max[i] <= b.min[i] || b.max[i] <= a.min[i])
}

/// In windows of many sizes, each 40 points lower for a while.
#[test]
fn what_takes_height_away_for_a_while_moves_little_to_another_side() {
    let mut needs = needs();
    needs[0].aspect = Some(1.3);
    needs.truncate(4);
    needs.remove(2);
    let heights = |width: i32| (420..800).step_by(9).map(move |height| (width, height));
    let [mut n_moved, mut n_anew] = [0; 2];
    for (width, height) in (560..1000).step_by(40).flat_map(heights) {
        let stands = |height: i32, taken: f32| -> Vec<(ViewId, bool)> {
            let whole = sheet([width as f32, height as f32], 13.0);
            let sheet = Sheet {
                spacing: WINDOW,
                taken,
                ..whole
            };
            let views = &sheet.lay_out(std::slice::from_ref(&needs)).columns[0].views;
            let is_beside = |slot: &Slot| slot.min[0] >= views[0].1.max[0];
            let views = views.iter();
            views.map(|(id, slot)| (*id, is_beside(slot))).collect()
        };
        let whole = stands(height, 0.0);
        n_moved += usize::from(stands(height - 40, 40.0) != whole);
        n_anew += usize::from(stands(height - 40, 0.0) != whole);
    }
    // Where there is no room for them otherwise they move.
    assert!(n_anew > 20 && 2 * n_moved < n_anew, "{n_moved} of {n_anew}");
}

#[test]
fn two_drawings_that_are_to_be_equal_are_about_as_large() {
    for width in [500.0, 680.0, 770.0, 1000.0] {
        let drawing = |id, aspect, is_equal| Need {
            aspect: Some(aspect),
            is_equal,
            ..need(id, Stand::Drawing, [10.0, 7.5], [30.0, 24.0])
        };
        let table = need("table", Stand::Beside, [15.0, 8.0], [26.0, 20.0]);
        let needs = vec![
            drawing("eye", 1.2, false),
            drawing("camera", 1.6, true),
            table,
        ];
        let layout = sheet([width, 640.0], 13.0).lay_out(&[needs]);
        let size = |nth: usize, aspect: f32| {
            let [width, height] = layout.columns[0].views[nth].1.size();
            width.min(aspect * height) / aspect.sqrt()
        };
        let [eye, camera] = [size(0, 1.2), size(1, 1.6)];
        assert!(
            (0.7..1.43).contains(&(eye / camera)),
            "{width}: {eye} {camera}"
        );
    }
}

/// Two pictures that the step compares, beside the drawing.
#[test]
fn pictures_over_each_other_are_as_high() {
    let picture = |id| Need {
        aspect: Some(1.3),
        ..need(id, Stand::Drawing, [12.0, 9.0], [48.0, 36.0])
    };
    let needs = vec![picture("eye"), picture("before"), picture("after")];
    let layout = sheet([900.0, 640.0], 13.0).lay_out(&[needs]);
    let height = |nth: usize| layout.columns[0].views[nth].1.size()[1];
    assert!(
        (height(1) - height(2)).abs() <= 1.0,
        "{} {}",
        height(1),
        height(2)
    );
}

#[test]
fn nothing_overlaps_or_leaves_the_sheet_at_any_size() {
    for em in [13.0, 18.2] {
        for width in (100..2000).step_by(90) {
            for height in (80..1200).step_by(70) {
                let size = [width as f32, height as f32];
                let layout = sheet(size, em).lay_out(&[needs(), needs()[..2].to_vec()]);
                for column in &layout.columns {
                    let slots: Vec<Slot> = column.views.iter().map(|(_, slot)| *slot).collect();
                    for (i, &slot) in slots.iter().enumerate() {
                        let others = slots[..i].iter();
                        assert!(others.copied().all(|other| is_apart(slot, other)));
                        assert!(slot.max[1] <= column.caption.min[1], "{size:?} {slot:?}");
                    }
                }
                let [a, b] = [0, 1].map(|i| layout.columns[i].views[0].1.size());
                assert!((a[0] - b[0]).abs() <= 1.0 && a[1] == b[1], "one scale");
            }
        }
    }
}

#[test]
fn a_table_stands_beside_the_drawing_from_its_height_and_an_axis_under_it_at_its_width() {
    let layout = sheet([960.0, 540.0], 13.0).lay_out(&[needs()]);
    let slot = |id| layout.columns[0].slot(ViewId(id)).unwrap();
    let [plane, line, table] = ["plane", "line", "table"].map(slot);
    assert_eq!(table.min[1], plane.min[1]);
    assert!(table.min[0] > plane.max[0]);
    assert_eq!([line.min[0], line.max[0]], [plane.min[0], plane.max[0]]);
    assert!(line.min[1] > plane.max[1]);
    let row = slot("row");
    assert_eq!([row.min[0], row.max[0]], [plane.min[0], table.max[0]]);
    assert!(row.min[1] > line.max[1]);
}

/// Wide over high is a number that the drawing keeps: where height is short the axis goes beside it, where width is short
/// everything goes under it.
#[test]
fn of_all_ways_the_one_with_the_largest_drawing_is_taken() {
    let slots = |aspect: f32| {
        let mut needs = needs();
        needs.truncate(2);
        needs.push(need("table", Stand::Beside, [17.0, 3.0], [24.0, 4.0]));
        (needs[0].aspect, needs[1].natural[0]) = (Some(aspect), f32::MAX);
        let layout = sheet([960.0, 540.0], 13.0).lay_out(&[needs]);
        let slot = |id| layout.columns[0].slot(ViewId(id)).expect("it has room");
        ["plane", "line", "table"].map(slot)
    };
    let [plane, line, table] = slots(1.0);
    assert!(table.min[0] > plane.max[0] && line.min[0] > plane.max[0]);
    assert!(plane.size()[1] > 400.0, "it has all of the height");
    let [plane, line, table] = slots(2.8);
    assert!(table.min[1] >= plane.max[1] && line.min[1] >= plane.max[1]);
    assert!(plane.size()[0] > 850.0, "it has all of the width");
}

#[test]
fn larger_text_makes_no_drawing_smaller() {
    for aspect in [0.6, 1.0, 1.4, 2.0] {
        let mut needs = needs();
        needs[0].aspect = Some(aspect);
        let drawn = |em| {
            let layout = sheet([960.0, 540.0], em).lay_out(&[needs.clone()]);
            let [width, height] = layout.columns[0].views[0].1.size();
            (width - 48.0).min(aspect * (height - 48.0))
        };
        assert!(drawn(18.2) > 0.98 * drawn(13.0), "{aspect}");
    }
}

#[test]
fn what_has_no_room_is_left_out_from_the_last_on() {
    let shown = |size| {
        let layout = sheet(size, 13.0).lay_out(&[needs()]);
        layout.columns[0].views.len()
    };
    assert_eq!(shown([960.0, 540.0]), 5);
    assert_eq!(shown([400.0, 200.0]), 1);
}

#[test]
fn beside_another_method_a_drawing_is_no_strip_for_the_sake_of_text() {
    let plane = Need {
        aspect: Some(1.5),
        ..need("plane", Stand::Drawing, [22.0, 7.5], [30.0, 24.0])
    };
    let axis = need("axis", Stand::Under, [14.0, 4.0], [20.0, 5.0]);
    let table = Need {
        whole: [26.0, 20.0],
        ..need("table", Stand::Beside, [20.0, 9.0], [26.0, 20.0])
    };
    let codes = need("codes", Stand::Beside, [20.0, 9.0], [26.0, 12.0]);
    let sheet = Sheet {
        spacing: WINDOW,
        caption: 0.0,
        title: 0.0,
        ..sheet([768.0, 480.0], 13.0)
    };
    let layout = sheet.lay_out(&[vec![plane, codes], vec![plane, axis, table]]);
    let columns = layout.columns.iter();
    let sides = columns.clone().flat_map(|column| column.views[0].1.size());
    assert!(sides.fold(f32::MAX, f32::min) >= BESIDE);
    let n_views: Vec<usize> = columns.map(|column| column.views.len()).collect();
    assert_eq!(n_views, [2, 3], "nothing goes");
}

#[test]
fn an_inset_stands_on_its_drawing_in_its_own_proportions() {
    let mut needs = needs();
    needs.push(need("inset", Stand::Inset, [9.6, 6.0], [16.0, 10.0]));
    for size in [[1280.0, 720.0], [700.0, 500.0], [420.0, 700.0]] {
        let layout = sheet(size, 13.0).lay_out(&[needs.clone()]);
        let column = &layout.columns[0];
        let [drawing, inset] = ["plane", "inset"].map(|id| column.slot(ViewId(id)).unwrap());
        let over: Vec<Slot> = column.over(ViewId("plane")).collect();
        assert_eq!(over, [inset], "{size:?}");
        for i in 0..2 {
            assert!(drawing.min[i] < inset.min[i] && inset.max[i] < drawing.max[i]);
        }
        let [width, height] = inset.size();
        assert!((width / height - 1.6).abs() < 0.05, "{inset:?}");
        assert!(width <= 0.28 * drawing.size()[0], "{inset:?}");
    }
    // Alone it is the drawing.
    let alone = sheet([800.0, 500.0], 13.0).lay_out(&[vec![needs[5]]]);
    assert!(alone.columns[0].views[0].1.size()[0] > 600.0);
}

#[test]
fn a_moved_boundary_stays_where_everything_has_room_and_overlaps_nothing() {
    for size in [[960.0, 540.0], [420.0, 800.0], [1400.0, 420.0]] {
        let at = |board: f32| {
            let sheet = Sheet {
                board,
                ..sheet(size, 13.0)
            };
            sheet.lay_out(&[needs()])
        };
        let settled = at(1.0);
        let ids = |layout: &Layout| {
            let views = layout.columns[0].views.iter();
            views.map(|(id, _)| *id).collect::<Vec<_>>()
        };
        let extent = |layout: &Layout| layout.columns[0].boundary().expect("two sides").size;
        let mut before = 0.0;
        for tenths in 3..=30_u8 {
            let moved = at(f32::from(tenths) / 10.0);
            assert_eq!(ids(&moved), ids(&settled));
            let slots = moved.columns[0].views.iter().map(|(_, slot)| *slot);
            let slots: Vec<Slot> = slots.collect();
            for (i, &slot) in slots.iter().enumerate() {
                assert!(slots[..i].iter().all(|&other| is_apart(slot, other)));
            }
            assert!(extent(&moved) >= before - 2.0, "{size:?} {tenths}");
            before = extent(&moved);
        }
        let [low, high] = [0.3, 3.0].map(|board| extent(&at(board)));
        assert!(
            low < extent(&settled) && extent(&settled) < high,
            "{size:?}"
        );
    }
}
