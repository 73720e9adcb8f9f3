//! Pictures are the same bytes, whatever was drawn before.
//!
//! `CLIPSCOPE_SAMPLES=/tmp cargo test --test all painting::` also leaves the sample pictures there.

use clipscope::paint::theme::{caption, caption_strong, strong};
use clipscope::paint::{CpuPainter, Headless, Image, Theme, ThemeKind};
use egui::{Align2, Color32, FontId, Panel, RichText, Shape, Stroke, TextStyle, Ui, pos2, vec2};

const CODE: &str = "code₁ ← code(P₁);  code₂ ← code(P₂)\nif code₁ AND code₂ ≠ 0: reject\nP₁ ← segment ∩ edge   t = q/p = (−1 − (−2)) / 4 = 1/4\n⏮ ◀ ⏸ ▶ ⏭  ≤ ≥ ∈ ∪ ⟨x⟩ Δ ∧ ∨ ¬ √ xₖ uₘᵢₙ ½ 裁剪";

/// A bit of everything that the program draws.
fn sample(ui: &mut Ui, theme: &Theme) {
    Panel::left("course").exact_size(260.0).show(ui, |ui| {
        ui.heading("Clipscope");
        ui.label("Both codes have a bit set, yet they share none: neither test decides.");
        ui.label(RichText::new("Cutting with outcodes").text_style(strong()));
        ui.label(
            RichText::new("soft 11 px: Sutherland and Sproull, 1968")
                .small()
                .color(theme.soft),
        );
        ui.label("Español: ¿cómo? ñ á. Português: ação, não.");
        ui.label("中文 裁剪：P₁ 在 left 之外。 x = −1，t ≤ 1/4");
        ui.label(RichText::new("裁剪 Aa 裁剪 semibold").text_style(strong()));
        ui.horizontal(|ui| {
            let _play = ui.button("Play ▶");
            let _step = ui.selectable_label(true, "Lines");
            let _idle = ui.selectable_label(false, "Polygons");
        });
        ui.checkbox(&mut true, "Show the grid");
        ui.add(egui::Slider::new(&mut 0.4, 0.0..=1.0).text("speed"));
        ui.text_edit_singleline(&mut "a text field".to_owned());
        let focused = ui.button("with the focus");
        focused.request_focus();
        ui.separator();
        ui.label(RichText::new(CODE).monospace());
    });
    Panel::bottom("caption").show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.label(
                RichText::new("P₁ is outside left (0001): cut at x = −1.")
                    .text_style(caption_strong()),
            );
            ui.label(
                RichText::new("t = (−1 − (−2)) / (2 − (−2)) = 1/4")
                    .text_style(caption())
                    .color(theme.soft),
            );
        });
    });
    egui::CentralPanel::default()
        .frame(egui::Frame::new().fill(theme.background))
        .show(ui, |ui| stage(ui, theme));
}

fn stage(ui: &mut Ui, theme: &Theme) {
    let painter = ui.painter();
    let rect = ui.max_rect();
    let window = egui::Rect::from_center_size(rect.center(), vec2(224.0, 200.0));
    painter.rect(
        window,
        0.0,
        theme.accent_wash,
        theme.stroke(2.0, theme.ink),
        egui::StrokeKind::Middle,
    );
    for x in [window.left(), window.right()] {
        let line = [pos2(x, rect.top()), pos2(x, rect.bottom())];
        let stroke = Stroke::new(1.0, theme.hairline);
        painter.extend(Shape::dashed_line(&line, stroke, 6.0, 4.0));
    }
    let (p1, p2) = (
        window.left_bottom() + vec2(-80.0, 10.0),
        window.right_top() + vec2(70.0, -40.0),
    );
    painter.line_segment([p1, p2], theme.stroke(2.5, theme.accent));
    painter.circle(
        p1,
        7.0,
        theme.background,
        theme.stroke(2.0, theme.discarded),
    );
    painter.circle_filled(window.center(), 6.0, theme.signal);
    for n in 0..8_u8 {
        let at = window.left_top() + vec2(20.0 * f32::from(n), -30.0);
        painter.circle_filled(at, 1.0 + f32::from(n) * 0.7, theme.accepted);
    }
    let translucent = theme.signal.gamma_multiply(0.3);
    painter.add(Shape::convex_polygon(
        vec![window.center(), window.right_bottom(), p2],
        translucent,
        Stroke::new(1.0, theme.signal),
    ));
    let mono = FontId::monospace(13.0);
    painter.text(
        window.center_top(),
        Align2::CENTER_BOTTOM,
        "1000",
        mono,
        theme.ink,
    );
    let font = TextStyle::Body.resolve(ui.style());
    let galley = painter.layout_no_wrap("turned text".to_owned(), font, theme.ink);
    painter.add(egui::epaint::TextShape::new(p2, galley, Color32::BLACK).with_angle(0.6));
}

fn draw(headless: &mut Headless, pixels_per_point: f32) -> Image {
    let theme = headless.theme();
    headless.draw(vec2(900.0, 520.0), pixels_per_point, |ui| sample(ui, theme))
}

#[test]
fn a_used_table_draws_the_same_as_a_fresh_one() {
    let mut used = Headless::new(ThemeKind::Dark);
    // Fills the glyph atlas in another order, and leaves scrolling and panels behind.
    for i in 0..12_u8 {
        let size = 9.0 + f32::from(i);
        let _image = used.draw(vec2(300.0, 200.0), 1.0 + f32::from(i % 3) * 0.5, |ui| {
            Panel::left("course").exact_size(90.0).show(ui, |ui| {
                egui::ScrollArea::vertical().show(ui, |ui| {
                    ui.label(
                        RichText::new(CODE)
                            .size(size)
                            .family(clipscope::paint::fonts::semibold()),
                    );
                    ui.label(RichText::new(CODE).monospace().size(size + 0.5));
                    ui.scroll_to_cursor(None);
                    ui.ctx().request_repaint();
                });
            });
        });
    }
    for kind in ThemeKind::ALL {
        used.set_theme(kind);
        for pixels_per_point in [1.0, 1.5, 2.0] {
            let mut fresh = Headless::new(kind);
            let expected = draw(&mut fresh, pixels_per_point);
            assert!(
                draw(&mut used, pixels_per_point) == expected,
                "{kind} after others"
            );
            assert!(
                draw(&mut fresh, pixels_per_point) == expected,
                "{kind} again"
            );
            leave_sample(&format!("sample-{kind}-{pixels_per_point}.png"), &expected);
        }
    }
}

/// The painter alone, on given triangles: the same bytes on every machine and in every build.
#[test]
fn given_triangles_give_these_bytes() {
    let mut seed = 1_u32;
    let mut next = |n: u32| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) % n
    };
    let texels = (0..64_u8).map(|i| Color32::from_rgba_premultiplied(i, 2 * i, 3 * i, 3 * i));
    let texture = egui::ColorImage::new([8, 8], texels.collect());
    let id = egui::TextureId::Managed(1);
    let mut delta = egui::TexturesDelta::default();
    let options = egui::TextureOptions::LINEAR_REPEAT;
    delta.push(id, egui::epaint::ImageDelta::full(texture, options));
    let mut painter = CpuPainter::default();
    painter.apply(&mut delta);

    let mut mesh = egui::Mesh::with_texture(id);
    for i in 0..300 {
        let mut at = |n: u32| next(n) as f32 / 16.0;
        let (pos, uv) = (pos2(at(1600), at(1200)), pos2(at(64), at(64)));
        let [r, g, b] = [100, 90, 80].map(|n| next(n) as u8);
        let color = Color32::from_rgba_premultiplied(r, g, b, 100 + next(156) as u8);
        mesh.vertices.push(egui::epaint::Vertex { pos, uv, color });
        mesh.indices.push(i);
    }
    let primitive = egui::ClippedPrimitive {
        clip_rect: egui::Rect::EVERYTHING,
        primitive: egui::epaint::Primitive::Mesh(mesh),
    };
    let image = painter.paint(&[primitive], 1.5, [150, 112], Color32::WHITE);
    // FNV-1a.
    let hash = image
        .rgba
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    assert_eq!(hash, 0x9018_dd26_95e3_ade1, "{hash:#x}");
}

#[test]
fn pictures_are_opaque_and_of_the_size_asked_for() {
    let mut headless = Headless::new(ThemeKind::Light);
    for (size, pixels_per_point, expected) in [
        (vec2(100.0, 50.0), 1.0, [100, 50]),
        (vec2(100.5, 50.0), 1.5, [151, 75]),
        (vec2(0.0, -4.0), 1.0, [1, 1]),
        (vec2(f32::NAN, 10.0), f32::NAN, [1, 1]),
    ] {
        let image = headless.draw(size, pixels_per_point, |ui| {
            ui.label("text");
        });
        assert_eq!(image.size, expected);
        assert_eq!(image.rgba.len(), 4 * expected[0] * expected[1]);
        assert!(image.rgba.as_chunks::<4>().0.iter().all(|p| p[3] == 255));
    }
}

#[test]
fn a_png_holds_the_pixels() {
    let image = draw(&mut Headless::new(ThemeKind::Light), 1.0);
    let bytes = image.to_png();
    assert_eq!(bytes, image.to_png());
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes))
        .read_info()
        .expect("a PNG");
    let mut rgb = vec![0; reader.output_buffer_size().expect("it fits")];
    let info = reader.next_frame(&mut rgb).expect("a picture");
    assert_eq!([info.width as usize, info.height as usize], image.size);
    let expected = image.rgba.as_chunks::<4>().0.iter();
    assert!(
        expected
            .map(|p| [p[0], p[1], p[2]])
            .eq(rgb.as_chunks::<3>().0.iter().copied())
    );
}

fn leave_sample(name: &str, image: &Image) {
    if let Some(folder) = std::env::var_os("CLIPSCOPE_SAMPLES") {
        let path = std::path::Path::new(&folder).join(name);
        std::fs::write(path, image.to_png()).expect("a folder to write to");
    }
}
